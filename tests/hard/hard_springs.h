// hard_springs.h - a sheet of springs and the cubes that fall on it, in tiny
// explicit steps: by how much must the sheet be stretched?
//
// This shares nothing with the solvers of the library: every link is a spring,
// what touches is pushed off by a spring, and forces are added up.  So it shows
// what belongs to the cloth, and what the solvers add.
// Units: metres, seconds, kilograms, newtons.  Frame: y points up.

#ifndef TUMBLE_HARD_SPRINGS_H
#define TUMBLE_HARD_SPRINGS_H

#include "world.h"

// The largest strain of a link at the end of any frame of the first `seconds`.
// Body 0 of the world, which begins at rest, is a cloth whose links give; the
// others are free cubes.  A diagonal has the stiffness `shear` (N/m).  HUGE_VAL
// if memory is refused.
real springs_strain(const world *w, real shear, real seconds);

#endif
