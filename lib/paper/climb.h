//> climb-head
// climb.h - which vertex of a convex body lies furthest along a direction, where
// there are many: uphill along the edges of its mesh.
//
// Book: chapter 5.  Units: metres, in the frame of the points.

#ifndef TUMBLE_CLIMB_H
#define TUMBLE_CLIMB_H

#include "gjk.h"
#include "mesh.h"

// A convex body: its vertices, and the mesh that they are the vertices of.
// NULL: none is known.
typedef struct {
    hull hull;
    const struct mesh *mesh;
    real size;          // m, > 0: no two vertices are further apart
} hull_mesh;
//<

//> climb-declare
// A body without a mesh, measured.
hull_mesh hull_bare(hull h);

// The vertex furthest along d, of any length: of equals, the first.
int hull_scan(hull h, vec3 d);

// Has a body a mesh, and so many vertices that it is worth to climb?
bool hull_climbs(const hull_mesh *b);

// As hull_scan; but of a body that climbs, the end of a climb from a vertex.  A
// mesh is convex to 1e-9 of its size, and a climb may end in front of a dent
// (mesh_check_convex), or on a plain below.
int hull_climb(const hull_mesh *b, vec3 d, int from);

#endif
//<
