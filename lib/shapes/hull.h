//> convex-hull-head
// hull.h - a rigid body from points: their convex hull.
//
// Paper: section 4 takes meshes; here also points that nothing joins.
// Book: chapter 10.
// Quickhull (Barber, Dobkin and Huhdanpaa 1996).
// Units: metres, kilograms.

#pragma once

#include "convex.h"

// The solid that n points span, as a rigid shape (see shape_convex) whose
// origin is its centre of mass.  Its vertices are those of the points that
// stand out, in their order; points inside, on a side or on an edge, and
// points said twice, are left out.  Takes a copy of at (m); mass in kg.
// No point lies further outside than 1e-12 of the size, the largest distance
// from the first of them; or 1e-8, and at worst 1e-6, where they lie so nearly
// on faces or edges that triangles would be thinner than shape_convex bears.
// Fails, and leaves *s empty: fewer than 4 points, points in one place, in one
// line or in one plane (or thinner than a millionth of the size), a number out
// of range or not finite, more than 16,384 vertices, no memory.
status shape_hull(shape *s, const vec3 *at, int n, real mass);
//<
