//> mesh-check-head
// mesh_check.h - is a mesh sound, and is it a convex body?
//
// Book: chapter 3.  Chapters 4 and 5 believe what these two have checked.

#ifndef TUMBLE_MESH_CHECK_H
#define TUMBLE_MESH_CHECK_H

#include "mesh.h"

// Is every link of the mesh what the half-edge rules say?  If not, the sentence
// names the element and the rule that it breaks.  Any contents of the arrays
// are safe to ask about, as long as they are as long as the counts say.
status mesh_validate(const mesh *m);

// Closed, of sphere type, no flat triangle, no vertex outside the plane of any
// face: a convex body whose faces look outwards.  If not, the sentence names
// the face and the vertex.  at[vertices] in m.  Every tolerance is 1e-9 of the
// size, the largest distance from vertex 0.
status mesh_check_convex(const mesh *m, const vec3 *at);

#endif
//<
