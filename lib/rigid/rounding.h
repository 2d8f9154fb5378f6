//> rounding-head
//>   A hull with a radius is a round body whose core has faces.
// rounding.h - rigid shapes with round edges: all that is near a hull.
//
// Paper: no such bodies.  Book: chapter 13.
// Units: metres, kilograms.

#pragma once

#include "weight.h"

// All that is no further from `of` than radius, evenly filled, with the mass of
// `of`; moved so that its centre of mass is the origin.  The vertices and faces
// are those of `of`, which is the core.  Fails, and leaves *s empty: a shape
// without faces, or not rigid; a radius out of range; more than 16,384 points
// to draw; no memory.
status shape_round(shape *s, const shape *of, real radius);
//<
