// bodies.h - the bodies that the tests of queries ask about: made here
// or read, with their exact answers, from tests/data/pairs.txt.

#ifndef TUMBLE_BODIES_H
#define TUMBLE_BODIES_H

#include "gjk.h"
#include "mesh.h"

enum { BODY_POINTS = 642, BODY_RING = 6 * BODY_POINTS };

// A convex body with room for the largest icosphere.
typedef struct {
    int  count;
    vec3 at[BODY_POINTS];
    int  has_ring;
    int  ring_start[BODY_POINTS + 1], ring[BODY_RING];
} body;

// A pair with its exact answer, as stored in tests/data/pairs.txt.
typedef struct {
    char   family[40];
    char   kind;            // S apart, T touching, P overlapping
    double value;           // m, distance or depth
    char   feature[4];      // of A, then of B; -- if hard to tell
    int    unique;          // one facet of A - B alone attains the depth
    double gap;             // relative lead of that facet over the next
    body   a, b;
} pair_known;

hull body_hull(const body *b);
void body_box(body *b, vec3 low, vec3 high);
body body_cube(real x, real y, real z);     // of side 1, its middle there
void body_icosahedron(body *b, real radius);
// 42, 162 or 642 points (level 1, 2, 3) on a sphere, with their ring.
void body_icosphere(body *b, int level, real radius);
void body_random(body *b, int count, unsigned long long *state);
// A square of side 1 in the plane z = 0.
void body_square(body *b);
// A table, 7 m wide, of 64 vertices on one below, which is vertex `foot`: its top
// is uneven by `rough` (m; a mesh may be by 1e-9 of its size), or < 0: a dome.  And
// the mesh of all.
enum { TABLE_FOOT = 64 };
void body_table(body *b, int foot, real rough, unsigned long long *state);
status table_mesh(struct mesh *m, int foot);
void body_turn(body *b, unsigned long long *state);     // any rotation
// Turned anyhow, kind 0: a cube; 1: an icosahedron; 2: a few points; 3: a
// square; 4: at most three points.
void body_any(body *b, int kind, unsigned long long *state);
void body_move(body *b, vec3 by);
void body_scale(body *b, real by);

// Pair n of a family: two bodies of the first `kinds` kinds, all in their turn;
// B is moved by `least` to `most` in any direction.
void pair_any(body *a, body *b, int n, int kinds, real least, real most,
              unsigned long long *state);
void pair_move(body *a, body *b, vec3 by);
void pair_scale(body *a, body *b, real by);
void pair_turn(body *a, body *b, unsigned long long *state); // both alike
real pair_size(const body *a, const body *b);   // of the larger, from vertex 0

// 0 while a module of the reader's own is judged (YOURS is set): it may be right
// to the last tolerance, and have other bits.
int bits_are_ours(void);

// Reads the next pair of an open file.  1: read; 0: at the end; -1: damaged.
int pair_read(void *file, pair_known *p);

#endif
