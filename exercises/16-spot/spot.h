// spot.h - a place on a piece of cloth, and how two of them part.
//
// Units: metres, inverse masses in 1/kg.

#ifndef TUMBLE_SPOT_H
#define TUMBLE_SPOT_H

#include "verlet.h"

// A mean of one to three particles: a corner, a point of an edge, of a triangle.
typedef struct {
    int  count, at[3];
    real weight[3];         // 0 to 1, their sum is 1
} spot;

vec3 spot_position(const particle *p, const spot *s);

// 1/kg: how far the spot goes for an impulse (kg m) of 1 that its particles
// share by their weights.
real spot_answer(const particle *p, const spot *s);

// Parts a and b, which share no particle: afterwards a is `apart` (m) from b
// along the unit normal, which points from b to a.  If it is as far already,
// nothing moves.  What the two have slid past each other since `previous` is
// taken back, by at most friction times the push.
void spots_part(particle *p, const spot *a, const spot *b, vec3 normal,
                real apart, real friction);

#endif
