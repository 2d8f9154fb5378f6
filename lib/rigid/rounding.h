//> rounding-head
//>   A hull with a radius is a round body whose core has faces.
// rounding.h - rigid shapes with round edges.
//
// Paper: no such bodies.  Book: chapter 13.
// Units: metres, kilograms.

#pragma once

#include "weight.h"

// Makes a shape of all points no further from `of` than radius, evenly filled, with the
// mass of `of` and its centre of mass at the origin.  Its vertices and faces are those
// of `of`, which is the core.  Fails, leaving *s empty, if `of` has no faces or is not
// rigid, the radius is out of range, there are more than 16,384 points to draw, or
// memory is refused.
status shape_round(shape *s, const shape *of, real radius);
//<
