// balls.h - when do two balls touch that fly?
//
// Units: metres; time as a share of the way, 0 to 1.

#ifndef TUMBLE_BALLS_H
#define TUMBLE_BALLS_H

#include "vec3.h"

typedef struct {
    vec3 center;        // m, where it is at time 0
    real radius;        // m, >= 0
    vec3 way;           // m, where it goes until time 1
} flying_ball;

// 1 if they touch within the way, first at *time; *normal is the unit vector
// from B to A then.  Balls that overlap at the start, or touch and come nearer,
// touch at time 0 (normal 0 if their centres are one point).  0, and nothing is
// written, if they do not touch, only part, or if a number is not finite.
int balls_touch(const flying_ball *a, const flying_ball *b, real *time,
                vec3 *normal);

// How many equal substeps (>= 1) a frame needs so that in none of them a body
// goes further than its inner radius (m, > 0), when it goes `way` (m) in the
// frame; at most `most`.  Where that is not enough, or a number is none: most.
int balls_limit(vec3 way, real inner, int most);

#endif
