//> mesh-head
// mesh.h - which vertex, edge and face touches which: half-edges.
//
// Paper: section 4 (the half-edge structure of Mantyla).  Book: chapter 3.
// A mesh knows no positions: it is the same while the body moves.
//
// Half-edges 2e and 2e + 1 are the two directions of edge e, so the twin of h
// is h ^ 1.  A half-edge with face = -1 runs along a hole or the rim.

#ifndef TUMBLE_MESH_H
#define TUMBLE_MESH_H

#include "status.h"
#include "vec3.h"

typedef struct {
    int origin;         // the vertex it leaves
    int next;           // the next half-edge around the same face or rim
    int face;           // the face on its left; -1: none
} half_edge;

typedef struct mesh {
    int vertices, edges, faces;  // 2 * edges half-edges
    half_edge *half;             // [2 * edges]
    int *vertex_half;            // [vertices] one that leaves it, on the rim if
                                 // the vertex is on a rim; -1: isolated
    int *face_half;              // [faces] one of its three
} mesh;
//<

//> mesh-declare-build
// Builds the mesh of `faces` triangles over `vertices` vertices; a triangle's
// vertices run counter-clockwise seen from outside.  Edges are numbered in the
// order in which the triangles first name them.
// Fails, and leaves *m empty, with a sentence that names the triangle or edge:
// an index out of range, a triangle with a vertex twice, an edge with three
// triangles, neighbours that turn opposite ways, two fans that meet in one
// vertex only, sizes that overflow, no memory.
// (A sentence always says `triangle 7` and `vertex 12`, counting from 0, so
// that a reader of files can put its own line numbers there.)
status mesh_build(mesh *m, int vertices, const int (*triangle)[3], int faces);
void   mesh_free(mesh *m);      // an empty or zeroed mesh is fine

// Is every link of the structure what the half-edge rules say?  Names the bad
// element and the rule that it breaks.
status mesh_validate(const mesh *m);
//<

//> mesh-declare-walk
// Every edge has two faces: no rim.
int mesh_is_closed(const mesh *m);

// Vertices - edges + faces: 2 for a sphere, 1 for a disc.
int mesh_euler(const mesh *m);

static inline int mesh_twin(int h) { return h ^ 1; }
int mesh_target(const mesh *m, int h);              // the vertex it reaches

// The three vertices of face f, counter-clockwise seen from outside.
void mesh_face(const mesh *m, int f, int vertex[3]);

// Circulates: the half-edge that leaves the same vertex after h, turning
// clockwise seen from outside.  Back at the start when the turn is complete.
int mesh_around(const mesh *m, int h);
//<

//> mesh-declare-measure
// m^3, signed: positive if the faces of a closed mesh look outwards.
real mesh_volume(const mesh *m, const vec3 *at);

// Closed, of sphere type, no flat or inverted face, no vertex outside the plane
// of any face by more than 1e-9 of the size: a convex body that looks outwards.
// The size is the diagonal of the box around the vertices.
// The sentence names the face and the vertex that break the rule.
status mesh_check_convex(const mesh *m, const vec3 *at);

#endif
//<
