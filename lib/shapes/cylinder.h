//> cylinder-head
// cylinder.h - a rigid body with two flat ends and a round side.
//
// Paper: no such bodies.  Book: chapter 10.
// Units: metres, kilograms.

#pragma once

#include "capsule.h"
#include "convex.h"

// Of that length and radius, evenly filled.  Its axis lies along y, with its middle
// in the origin.  Particles 0 and 1 are the middles of the lower and the upper end;
// its mesh is the prism that CYLINDER_SIDES corners of each rim span, and the shape
// is round beyond it, up to its rim (see rim.h).  Fails, and leaves *s empty, if a
// number is not from 1e-30 to 1e30, the radius is not from 1e-4 to 1e4 lengths, or
// memory is refused.
enum { CYLINDER_SIDES = 32 };
status shape_cylinder(shape *s, real length, real radius, real mass);
//<
