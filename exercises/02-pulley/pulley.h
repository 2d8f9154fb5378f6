// pulley.h - a rope from a over two wheels to b.

#ifndef TUMBLE_PULLEY_H
#define TUMBLE_PULLEY_H

#include "constraint.h"

// |x_a - wheel_a| + ratio |x_b - wheel_b| <= length.
typedef struct {
    int  a, b;              // particles, not the same
    vec3 wheel_a, wheel_b;  // m, fixed
    real ratio;             // parts of the rope that lead to b; > 0
    real length;            // m, without what lies between the wheels
} pulley;

// Moves both ends until the rope is no longer too long, to first order, as
// little as can be, weighed by mass.  error: m, by how much it was too long; 0
// if it was slack, HUGE_VAL for NaN.  An end at its wheel stays.  If there is
// nothing to do or nothing to move, moved is false.
stick_result pulley_relax(pulley r, particle *p);

#endif
