//> guard-head
// guard.h - what no frame may do, whatever its contacts were.
//
// Paper: not asked.  Book: chapter 18.

#ifndef TUMBLE_GUARD_H
#define TUMBLE_GUARD_H

#include "world.h"

// J, before the substeps of a frame: how much kinetic energy rigid bodies may
// have after them.  0 where none moves by itself.
real guard_most(const world *w, const solver_frame *f);

// After them, when so many have lost their numbers and were stopped: slows rigid
// bodies, all by the same share, if they have more.
void guard_brake(world *w, real most, int lost);

// After the substep of rope and cloth: what has lost its numbers in it stands
// again where the substep began, at rest, and is reported.
void guard_soft(world *w);

// Nothing goes through a body that it touches.
void guard_bodies(world *w);

// No centre of mass goes behind a plane, or further behind than it was.
void guard_planes(world *w);

#endif
//<
