//> obj-head
//>   `tumble --mesh` throws a body of your own, from an OBJ file.
// obj.h - a convex body from a Wavefront OBJ file.
//
// Book: chapter 10.  Of the format: lines `v x y z` and `f i j k ...` (also
// i/t/n; negative indices count back; polygons are cut into fans), in any
// order.  A backslash at the end of a line joins it to the next.  All other
// lines are ignored.

#pragma once

#include "body.h"

// Reads the triangle mesh in the file `path` as a rigid, convex body of that
// mass (kg), its centre of mass at the origin, scaled so that the largest
// distance of a vertex from it is radius (m). Vertices that no face uses are
// dropped.  A mesh whose faces all look inwards is turned round.  Numbers have
// a decimal point, whatever the locale. Fails, and leaves *s empty, with one
// sentence that names the file, the line where there is one, what is wrong and
// why: cannot open, not a number, index out of range, no face, open,
// non-manifold, flat, not convex, more than 4096 vertices, more than 16 MB.
status obj_read(const char *path, real radius, real mass, shape *s);
//<
