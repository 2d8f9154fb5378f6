//> guard-head
// guard.h - what no frame may do, whatever its contacts were.
//
// Paper: not asked.  Book: chapter 18.

#pragma once

#include "world.h"

// Before the substeps of a frame: how much kinetic energy may the rigid bodies of
// each island have after them?
void guard_begin(world *w, const solver_frame *f);

// After them, when so many have lost their numbers and were stopped: slows those
// of an island, all by the same share, if they have more, and leaves it its
// momentum, unless that alone is more; and puts them back to where the frame
// began, at rest, if it is far more than can be.
void guard_brake(world *w, int lost);

// After the substep of rope and cloth: what has lost its numbers in it stands
// again where the substep began, at rest, and is reported.
void guard_soft(world *w);

// Nothing goes through a body that it touches.
void guard_bodies(world *w);

// No centre of mass goes behind a plane, or further behind than it was; and none
// goes in through a face of what surrounds bodies.
void guard_walls(world *w);
//<
