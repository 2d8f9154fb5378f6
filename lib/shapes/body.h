//> body-head
//>   A **shape** describes a body at rest: its particles, their masses, the
//>   sticks and the mesh. Many bodies can share one shape.
// body.h - shapes: particles, the sticks between them and the mesh around them.
//
// Paper: section 4.  Book: chapter 3.
// A shape describes a body at rest, in a frame of its own whose origin is the
// centre of mass.  Many bodies can share one shape.  Units: metres, kilograms.

#pragma once

#include "constraint.h"
#include "mesh.h"

typedef enum {
    SHAPE_RIGID,        // closed mesh; the sticks make it rigid
    SHAPE_CLOTH,        // mesh with a rim
    SHAPE_ROPE          // no mesh: a line of particles
} shape_kind;

// Triangles that are drawn, and nothing else.
struct skin {
    int points, faces;
    vec3 *at;           // [points] m, at rest
    int  *face;         // [faces * 3] counter-clockwise seen from outside
};

// What a shape weighs that is not evenly filled: see weight.h.
struct weight {
    real mass;          // kg; 0: it has none of its own
    vec3 center;        // m, of mass, in the frame of the shape
    real spread[3][3];  // m^2, the mean of x x^T about it
    real reach;         // m, from it, of a body of which this is a piece; or 0
};

// The particles of a shape are the vertices of its mesh.
typedef struct shape {
    shape_kind kind;
    int    particles;
    vec3  *at;          // [particles] m, at rest
    real  *mass;        // [particles] kg
    int    sticks;
    struct stick *stick; // [sticks]
    int    angles;      // angular constraints; no shape of this file has one
    struct angle *angle; // [angles]
    int    columns, rows; // of a cloth; a rope is one row; rigid: 0
    struct mesh mesh;   // no vertex, edge or face for a rope
    int   *face;        // [mesh.faces * 3] vertices of each face, for loops
    real   round, rim;  // m, rigid: what is no further from the particles' hull, or
                        // from a cylinder's axis, is of the body, too; else 0
    struct skin skin;   // of one that is round; else empty
    real   radius;      // m, largest distance of the body from the origin
    real   spacing;     // m, the shortest stick
    struct weight own;
    vec3   middle;      // m, in its frame, of the ball inside it; of most: 0
} shape;
//<

//> body-declare-solids
//>   Two solids come ready-made.
// Every particle of a shape has the same mass.  A function that makes a shape
// fails, and leaves *s empty, if a number is not finite, not positive or out of
// range, or memory is refused.

// A box with these full sides (m) and mass (kg): 8 particles, 12 triangles, 18
// edges and the 4 main diagonals as sticks.  Particle k stands at +x if bit 0
// of k is set, at +y for bit 1, at +z for bit 2.
status shape_box(shape *s, vec3 sides, real mass);

// A regular icosahedron: 12 particles, 20 triangles, 30 edges and 6 diagonals.
// Particle k ^ 3 stands opposite to particle k.
status shape_icosahedron(shape *s, real radius, real mass);
//<

//> body-declare-thin
//>   And two thin things, a rope and a cloth.
// A rope of n links of equal length along x, 1 to 1,000,000: n + 1 particles,
// n sticks.  Link k joins particles k and k + 1.
status shape_rope(shape *s, int n, real length, real mass);

// A cloth of columns x rows particles (2 to 2048 each) in the plane y = 0, its
// width along x, its depth along z; faces look up (+y).  Particle (i, j) is
// number j * columns + i.  Sticks: the links along z, the links along x, and
// one diagonal a cell, alternating, of stiffness `diagonal`, in (0, 1].
status shape_cloth(shape *s, int columns, int rows, real width, real depth,
                   real mass, real diagonal);
//<

//> body-declare-make
//>   Other modules make shapes of their own, from these parts.
// Fails unless the value is a number from 1e-30 to 1e30; name and unit are for the
// sentence.
status size_check(const char *name, real value, const char *unit);

// To make a shape of one's own: begin, fill s->at, span a mesh (or none), add
// sticks, finish.  shape_begin gives all particles the same mass, and
// room for most_sticks.  Requires: particles >= 1, most_sticks >= 0.
status shape_begin(shape *s, shape_kind kind, int particles, int most_sticks,
                   real mass);

// Spans triangles over the particles.  Fails as mesh_build.
status shape_span(shape *s, const int (*triangle)[3], int faces);

// Two triangles [2 (columns - 1) (rows - 1)] a cell of a cloth or a terrain, cut as
// the cloth's diagonal does, turned so that they look up.
void shape_cut_cells(int (*triangle)[3], int columns, int rows);

// Adds a stick of the length that its ends are apart; one along every edge.
void shape_add_stick(shape *s, int a, int b);
void shape_add_edges(shape *s);

// Measures radius and spacing.  If something failed before, frees *s and
// returns that failure; it fails itself if a stick has no length.
status shape_finish(shape *s, status so_far);

// Adds an angular constraint to a finished shape.  Fails, and leaves *s as it
// was, if memory is refused.
status shape_add_angle(shape *s, struct angle c);

void shape_free(shape *s);      // an empty or zeroed shape is fine

// What is drawn of it: its skin, or its particles and their mesh.
struct skin shape_skin(const shape *s);
//<
