//> search-head
// search.h - the distance of chapter 4, sooner; and the shorter question: are
// two bodies apart?
//
// Paper: section 5.1.  Book: chapter 10.
// Units: metres, in the frame of the points (the world's).

#ifndef TUMBLE_SEARCH_H
#define TUMBLE_SEARCH_H

#include "gjk.h"
#include "mesh.h"

// A convex body: its vertices, and the mesh that they are the vertices of.
// NULL: none is known.  Where there are many, the search climbs along it.
typedef struct {
    hull hull;
    const struct mesh *mesh;
} hull_mesh;
//<

//> search-declare
// What gjk_distance answers, by the same last step: a search that does not mind
// rounding finds the simplex, and gjk_distance's proves it.
// Requires: both hulls in range (hull_in_range).
gjk_result search_nearest(const hull_mesh *a, const hull_mesh *b, real margin,
                          simplex *carried);

// Are a and b further apart than margin (m, >= 0)?  axis (m, from B to A, of any
// length): a guess of a direction that separates them, as a last answer gave
// it; 0: none.  Receives one, if they are apart.
// Requires: both hulls in range (hull_in_range).
bool search_apart(const hull_mesh *a, const hull_mesh *b, real margin,
                  vec3 *axis);

#endif
//<
