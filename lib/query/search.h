//> search-head
// search.h - the distance of chapter 4, sooner; and the shorter question: are
// two bodies apart?
//
// Paper: section 5.1.  Book: chapter 10.
// Units: metres, in the frame of the points (the world's).

#pragma once

#include "climb.h"
//<

//> search-declare
// A body whose mesh is not known.
hull_mesh hull_bare(hull h);

// What gjk_distance answers, by the same last step: a search that does not mind
// rounding finds the simplex, and gjk_distance's proves it.
// Requires: both hulls in range (hull_in_range).
gjk_result search_nearest(const hull_mesh *a, const hull_mesh *b, real margin,
                          simplex *carried);

// What parted two bodies: a direction from B to A (of any length; 0: none), and
// a vertex of A and one of B (-1: none) near those that are nearest along it.
typedef struct {
    vec3 axis;
    int  a, b;
} separating_axis;

// Are a and b further apart than margin (m, >= 0)?  carried: a guess, as a last
// answer gave it.  Receives an axis, if they are apart.
// Requires: both hulls in range (hull_in_range).
bool search_apart(const hull_mesh *a, const hull_mesh *b, real margin,
                  separating_axis *carried);
//<
