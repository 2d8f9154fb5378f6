//> convex-head
// convex.h - a rigid body from any convex triangle mesh.
//
// Paper: section 4, last paragraph.  Book: chapter 3.
// Units: metres, kilograms.

#pragma once

#include "body.h"

// Closed, of sphere type, no flat triangle, no vertex outside the plane of any
// face: a convex body whose faces look outwards.  If not, the sentence names
// the face and the vertex.  at[vertices] in m.  Every tolerance is 1e-9 of the
// size, the largest distance from vertex 0.
status mesh_check_convex(const struct mesh *m, const vec3 *at);

// A rigid shape from a closed, convex mesh: a stick along every edge of
// tetrahedra that fill it without a new particle (all have vertex 0 as their
// apex), and moved so that the mean of its vertices is the origin.  A vertex
// whose tetrahedra are all flat gets one stick more, to the vertex farthest
// below its plane.  Takes copies of at (m) and triangle.  mass in kg.
// Fails, and leaves *s empty, with the sentences of mesh_build and
// mesh_check_convex; and if there are fewer than 4 or more than 16,384
// vertices, a number is out of range, or memory is refused.
status shape_convex(shape *s, int vertices, const vec3 *at,
                    int faces, const int (*triangle)[3], real mass);
//<
