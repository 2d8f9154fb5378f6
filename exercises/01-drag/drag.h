// drag.h - Verlet's step in air.

#ifndef TUMBLE_DRAG_H
#define TUMBLE_DRAG_H

#include "verlet.h"

// One step of dt (s) for n particles under gravity (m/s^2) and the force
// -drag (v - wind): drag in kg/s, >= 0, wind in m/s, v = (x' - x_previous) /
// (2 dt), which makes it a method of order 2.  Pinned particles stay
// (previous = position).
void drag_step(particle *p, int n, vec3 gravity, real drag, vec3 wind, real dt);

#endif
