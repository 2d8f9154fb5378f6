//> climb-head
// climb.h - the vertex of a convex body that lies furthest along a direction:
// where there are many, uphill along the edges of its mesh.
//
// Book: chapter 5.  Units: metres, in the frame of the points.
#pragma once
#include "gjk.h"
#include "mesh.h"

// A convex body: its vertices, and the mesh whose vertices they are; NULL if
// no mesh is known.
typedef struct {
    hull hull;
    const struct mesh *mesh;
    real size;          // m, no two vertices are further apart
} hull_mesh;

// With fewer vertices it is quicker to look at all of them than to climb.
enum { HULL_CLIMBS = 48 };

static inline bool hull_climbs(const hull_mesh *b)
{
    return b->hull.count >= HULL_CLIMBS && b->mesh
        && b->mesh->vertices == b->hull.count;
}

// The vertex furthest along d, which may have any length; of equals, the first.
int hull_scan(hull h, vec3 d);

// The same by a climb from the vertex `from`, if b climbs.  A mesh is convex to
// 1e-9 of its size (mesh_check_convex), and flat in places: a climb may end in
// front of a dent, or on a plain far below the top.
int hull_climb(const hull_mesh *b, vec3 d, int from);
//<
