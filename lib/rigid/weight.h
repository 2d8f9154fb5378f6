//> weight-head
//>   A drum with a stone in it is no evenly filled drum.
// weight.h - rigid shapes that are not evenly filled.
//
// Paper: not asked; a body there weighs what its particles weigh.  Book:
// chapter 13.
// Units: metres, kilograms.  Frame: the shape's.

#ifndef TUMBLE_WEIGHT_H
#define TUMBLE_WEIGHT_H

#include "rigid4.h"

// A shape with copies of all that `of` has.  Fails, and leaves *s empty, if
// memory is refused.
status weight_copy(shape *s, const shape *of);

// The same for a rigid one, with this mass (kg), this centre of mass (m) and
// these moments of inertia about it (kg m^2): xx, yy, zz, xy, xz, yz of the
// tensor.  Fails, and leaves *s empty: a shape that is not rigid, a number out
// of range, a centre that is not inside, moments that no solid has (each
// principal one is less than the sum of the two others), no memory.
status weight_give(shape *s, const shape *of, real mass, vec3 center,
                   const real inertia[6]);

#endif
//<
