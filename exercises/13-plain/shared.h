// shared.h - bodies, and the points where they touch.
//
// Units: metres, kilograms, seconds.

#ifndef TUMBLE_SHARED_H
#define TUMBLE_SHARED_H

#include "vec3.h"

// A rigid body.  What never moves has the inverse mass 0 and an inverse inertia
// of zeros.
typedef struct {
    vec3 velocity, spin;        // m/s, rad/s
    real inverse_mass;          // 1/kg
    vec3 inverse[3];            // 1/(kg m^2), of the inverse inertia, columns
} solid;

// A point where two bodies touch, or will soon.
typedef struct {
    int  a, b;                  // indices of the two bodies
    vec3 ra, rb;                // m, from their centres to the point
    vec3 normal;                // unit, from b to a
    real gap;                   // m, along the normal; < 0: they overlap
    real friction;              // Coulomb's coefficient
    real push;                  // kg m/s, the impulse along the normal, in sum
    vec3 rub;                   // kg m/s, the impulse across it, in sum
} touch;

// kg: what the two bodies seem to weigh for an impulse along the unit vector d
// at the point.  At least one of them can move.
real touch_mass(const solid *body, const touch *t, vec3 d);

// The start of a step: every point gives the impulses again that it gave in the
// step before, which are in push and rub.
void touches_warm(solid *body, const touch *t, int count);

// So many iterations over all points, in their order.  Each first looks along
// the normal: an open gap may close within the step of h seconds but no
// further, an overlap is to open by a fifth of itself, and no point ever
// pulls.  Then friction stops what slides, by at most `friction` times the
// push.  push and rub are the sums of all that the point has given, those of
// touches_warm among them.
void touches_solve(solid *body, touch *t, int count, real h, int iterations);

#endif
