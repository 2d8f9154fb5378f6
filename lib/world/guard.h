//> guard-head
// guard.h - bounds that hold in every frame, whatever its contacts were.
//
// Paper: not asked.  Book: chapter 18.

#pragma once

#include "world.h"

// Before the substeps of a frame: computes how much kinetic energy the rigid bodies of
// each island may have after them.
void guard_begin(world *w, const solver_frame *f);

// After the substeps, in which `lost` bodies were stopped because their numbers were
// not finite: slows all bodies of an island that has more energy than that by the same
// factor, and keeps the momentum of the island unless that alone is too much.  If the
// energy is far more than can be, the bodies are put back to where the frame began, at
// rest.
void guard_brake(world *w, int lost);

// After a substep of rope and cloth: particles whose numbers are not finite are put
// back to where the substep began, at rest, and reported.
void guard_soft(world *w);

// Stops bodies that would go through a body that they touch.
void guard_bodies(world *w);

// Stops centres of mass that would go behind a plane, or further behind it than they
// were, and those that would go in through a face of a surface.
void guard_walls(world *w);
//<
