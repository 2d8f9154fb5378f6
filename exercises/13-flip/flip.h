// flip.h - four particles that spin.
//
// Units: metres, seconds, kilograms, radians.

#ifndef TUMBLE_FLIP_H
#define TUMBLE_FLIP_H

#include "rigid4.h"

// Puts the four particles of a body on their way: its centre at `center`,
// upright as in its plan, with this velocity (m/s) and this spin (rad/s, by the
// right-hand rule), for steps of h (s).  The places of a step ago are those of
// a body that has flown and turned for h, just so: no stick is bent in either.
void flip_start(const rigid4 *f, vec3 center, vec3 velocity, vec3 spin, real h,
                particle *p);

// The spin (rad/s) of four particles, half a step ago: what makes of their
// inertia their angular momentum about their centre.  0 if their inertia has no
// inverse, or a number is lost.
vec3 flip_spin(const particle *p, real h);

#endif
