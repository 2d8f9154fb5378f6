//> convex-head
// convex.h - a rigid body from any convex triangle mesh.
//
// Paper: section 4, last paragraph.  Book: chapter 3.
// Units: metres, kilograms.

#ifndef TUMBLE_CONVEX_H
#define TUMBLE_CONVEX_H

#include "body.h"

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

#endif
//<
