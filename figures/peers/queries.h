// queries.h - the parts of the program queries: the same questions about convex
// bodies, to this library and to others, timed in turn.
//
// A library gets a pair before the clock starts, in a layout of its own, and is
// asked by the pair's number.
#ifndef TUMBLE_QUERIES_H
#define TUMBLE_QUERIES_H

enum { QUERY_PAIRS = 250, QUERY_CORNERS = 642 };

#ifdef __cplusplus
extern "C" {
#endif

// Corners of A and of B in the world (m), three numbers each, and a direction
// from A to B to begin with.
typedef struct {
    int corners;
    const double *a, *b;
    double guess[3];
} query_pair;

// openGJK: its distance in doubles, cold.
void   gjk_put(int k, const query_pair *p);
double gjk_ask(int k);

// Jolt: do they overlap, beginning with the guess; how deep?  jolt_learn: what
// it finds now is the guess of the next question about k.
void   jolt_put(int k, const query_pair *p);
void   jolt_learn(int k);
void   jolt_move(int k, const query_pair *p);
int    jolt_overlap(int k);
double jolt_depth(int k);

// Box3D: its distance, from the simplex of the last question about k.
void   box3d_put(int k, const query_pair *p);
void   box3d_learn(int k);
void   box3d_move(int k, const query_pair *p);
double box3d_ask(int k);

#ifdef __cplusplus
}
#endif
#endif
