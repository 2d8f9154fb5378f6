//> body-head
// body.h - shapes: particles, the sticks that hold them and the mesh they span.
//
// Paper: section 4.  Book: chapter 3.
// A shape is the plan of a body, in its own frame: origin at the centre of
// mass.  Many bodies may be built to one plan.  Units: metres, kilograms.

#ifndef TUMBLE_BODY_H
#define TUMBLE_BODY_H

#include "constraint.h"
#include "mesh.h"

typedef enum {
    SHAPE_RIGID,        // convex, closed mesh, sticks make it rigid
    SHAPE_CLOTH,        // mesh with a rim
    SHAPE_ROPE          // no mesh, a line of particles
} shape_kind;

// Lines side by side: particle k of line l is number l * across + k * along.
// All their links are equally long.
typedef struct {
    int  lines, particles;      // how many; in each
    int  across, along;
    real rest_length;           // m
} strands;

// The particles of a shape are the vertices of its mesh.
typedef struct shape {
    shape_kind kind;
    int    particles;
    vec3  *at;          // [particles] m, at rest
    real  *mass;        // [particles] kg
    int    sticks;
    struct stick *stick; // [sticks]
    strands strand[2];  // a rope: itself; a cloth: its columns, its rows
    int    directions;  // of them, 0 to 2
    int    on_strands;  // the first of the sticks are the strands' links
    struct mesh mesh;   // no vertex, edge or face for a rope
    int   *face;        // [mesh.faces * 3] vertices of each face, for loops
    int   *ring_start;  // [particles + 1] the mesh neighbours of vertex v are
    int   *ring;        //   ring[ring_start[v]] .. ring[ring_start[v + 1] - 1]
    real   radius;      // m, largest distance of a particle from the origin
    real   inner;       // m, a ball of it about the origin lies inside;
                        // 0: there is no inside
    real   spacing;     // m, shortest stick: the grain of the shape
} shape;
//<

//> body-declare-solids
// Each builder fails, and leaves *s empty, if a number is not finite, not
// positive or too large, or memory is refused.  Every particle of a shape has
// the same mass.  Sticks next to each other in the list share no particle where
// that can be had, so stick k is not, in general, the k-th edge.

// A box with these full sides: 8 particles, 12 triangles, 18 edges and the 4
// main diagonals as sticks.  (Particle k stands at +x if bit 0 of k is set, at
// +y for bit 1, +z for bit 2.)
status shape_box(shape *s, vec3 sides, real mass);

// A regular icosahedron: 12 particles, 20 triangles, 30 edges and 6 diagonals.
// (Particle k ^ 3 stands opposite to particle k.)
status shape_icosahedron(shape *s, real radius, real mass);

// Any convex, closed triangle mesh: a stick along every edge of a
// tetrahedralisation of it that adds no particle (every tetrahedron has vertex
// 0 as its apex), the shape moved so that its centre of mass is the origin.
// A vertex whose tetrahedra are all flat gets one stick more, to the vertex
// farthest below its plane.  Fails with the sentences of mesh_build and
// mesh_check_convex.  Takes copies of at and triangle.
status shape_convex(shape *s, int vertices, const vec3 *at,
                    int faces, const int (*triangle)[3], real mass);
//<

//> body-declare-thin
// n links of equal length along x, 1 to 1,000,000: n + 1 particles, n sticks.
// (Link k joins particles k and k + 1; the even links come first in the list.)
status shape_rope(shape *s, int n, real length, real mass);

// columns x rows particles (2 to 2048 each) in the plane y = 0, width along x,
// depth along z; faces look up (+y).  Sticks along columns and rows first, then
// one diagonal a cell, alternating.  The diagonals have stiffness diagonal, in
// (0, 1].
// (Particle (i, j) is number j * columns + i, at x = i, z = j.)
status shape_cloth(shape *s, int columns, int rows, real width, real depth,
                   real mass, real diagonal);

void shape_free(shape *s);      // an empty or zeroed shape is fine

// Rank of the rigidity matrix of the sticks at the rest positions: 3 n - 6 if
// and only if no infinitesimal motion but those of a rigid body is left.
// -1 if memory is refused.
int shape_rank(const shape *s);

#endif
//<
