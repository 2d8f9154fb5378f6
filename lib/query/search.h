//> search-head
// search.h - the distance of chapter 04, faster; and a separating axis, which is enough
// to know that two bodies are apart.
//
// Paper: section 5.1.  Book: chapter 10.
// Units: metres, in the frame of the points (the world's).

#pragma once

#include "climb.h"
//<

//> search-declare
// A hull without a mesh, whose corners are all scanned.
hull_mesh hull_bare(hull h);

// The answer of gjk_distance.  A fast search, which does not care for rounding, finds
// the simplex, and the last step of gjk_distance proves it.
// Requires: both hulls in range (hull_in_range).
gjk_result search_nearest(const hull_mesh *a, const hull_mesh *b, real margin,
                          simplex *carried);

// A separating axis: a direction from B to A (of any length; 0: none), and a vertex of
// A and one of B (-1: none) close to those that are nearest along it.
typedef struct {
    vec3 axis;
    int  a, b;
} separating_axis;

// Are a and b further apart than margin (m, >= 0)?  *carried is a first guess, such as
// the last answer, and receives an axis if they are apart.
// Requires: both hulls in range (hull_in_range).
bool search_apart(const hull_mesh *a, const hull_mesh *b, real margin,
                  separating_axis *carried);
//<
