// eight.h - bodies that attract each other.

#ifndef TUMBLE_EIGHT_H
#define TUMBLE_EIGHT_H

#include "verlet.h"

// The force (N) on each of n bodies: towards every other, G m m' / d^2, where G
// (N m^2 / kg^2) is the strength of gravity and d (m) their distance.  mass in
// kg, also of pinned bodies.  Bodies in the same place do not attract each
// other.
void attract(const particle *p, const real *mass, int n, real G, vec3 *force);

// The area (m^2) of the triangle between sun, previous and position, along its
// normal: to the side from which the body is seen to go round counter-clockwise.
vec3 area_swept(const particle *p, vec3 sun);

#endif
