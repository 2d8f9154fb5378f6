// heirs.h - what the points of a contact remember of the step before.
//
// Units: metres, kilograms, seconds.

#ifndef TUMBLE_HEIRS_H
#define TUMBLE_HEIRS_H

#include "vec3.h"

enum { HEIRS = 4 };             // a contact has no more points

typedef struct {
    vec3 at;                    // m, in the axes of the first body
    real push;                  // kg m/s, the impulse along the normal
    vec3 rub;                   // kg m/s, that of friction
} heir;

// Gives push and rub of the old points to new ones, each to one at most: the
// nearest pair first, and no pair that is `near` (m) or more apart.  New points
// that inherit nothing get 0.  Returns how many inherited.  Both counts are 0 to
// HEIRS.
int points_inherit(heir *now, int count, const heir *old, int olds, real near);

// The part of rub that is across the unit normal, and no longer than `most`.
vec3 rub_carried(vec3 rub, vec3 normal, real most);

#endif
