//> mesh-head
// mesh.h - which vertex, edge and face touches which: half-edges.
//
// Paper: section 4 (the half-edge structure of Mantyla).  Book: chapter 3.
// A mesh holds no positions: it stays the same while the body moves.

#pragma once

#include "status.h"
#include "vec3.h"

// One of the two directions of an edge.  It runs counter-clockwise around its
// face, seen from outside.
typedef struct {
    int origin;         // the vertex that it leaves
    int next;           // the half-edge after it, around the face or the rim
    int face;           // the face on its left; -1 along a hole or a rim
} half_edge;

// Half-edges 2e and 2e + 1 are the two directions of edge e.
typedef struct mesh {
    int vertices, edges, faces;
    half_edge *half;    // [2 * edges]
    int *vertex_half;   // [vertices] a half-edge that leaves it: the one on
                        // the rim, if there is one; -1 for a lone vertex
    int *face_half;     // [faces] one of its three half-edges
} mesh;
//<

//> mesh-declare-walk
// The other direction of the same edge.
static inline int mesh_twin(int h) { return h ^ 1; }

// The vertex that half-edge h reaches.
int mesh_target(const mesh *m, int h);

// The half-edge after h that leaves the same vertex, clockwise seen from
// outside.  After a whole turn it is back at h.
int mesh_around(const mesh *m, int h);

// The three vertices of face f, counter-clockwise seen from outside.
void mesh_face(const mesh *m, int f, int vertex[3]);

// Vertices - edges + faces: 2 for a sphere, 1 for a disc.
int mesh_euler(const mesh *m);

// m^3, from positions at[vertices] in m.  Positive if the faces of a closed
// mesh look outwards; means nothing for an open one.
real mesh_volume(const mesh *m, const vec3 *at);
//<

//> mesh-declare-build
// Builds the mesh of `faces` triangles over `vertices` vertices.  The vertices
// of a triangle run counter-clockwise seen from outside, and its face begins at
// the first of them. Fails, and leaves *m empty, with a sentence that names the
// triangle or the vertex: an index out of range, a vertex twice in a triangle,
// an edge with three triangles, neighbours that turn opposite ways, a pinched
// vertex, sizes that overflow, no memory.
status mesh_build(mesh *m, int vertices, const int (*triangle)[3], int faces);
void   mesh_free(mesh *m);      // an empty or zeroed mesh is fine
//<
