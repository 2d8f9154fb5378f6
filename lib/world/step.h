//> step-head
// step.h - one frame: integrate, find, separate, relax.
//
// Paper: sections 5 and 6.  Book: chapter 16.

#ifndef TUMBLE_STEP_H
#define TUMBLE_STEP_H

#include "world.h"

// One frame of options.dt: every body moves, is parted from what it met, and is
// relaxed; what it did is in w->report.  Requires world_begin.  Allocates
// nothing and never fails: a body whose numbers are lost touches nothing, and
// w->report.dropped counts what found no room.
void world_step(world *w);

// Verlet's step for n particles under the acceleration a (m/s^2), if the last
// step took dt_before (s) and this one takes dt:
// x' = x + (x - x_previous) dt / dt_before + a dt (dt_before + dt) / 2.
// Pinned particles stay, with previous = position.
void verlet_step_changed(particle *p, int n, vec3 a, real dt_before, real dt);

#endif
//<
