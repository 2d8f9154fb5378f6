//> gjk-head
// gjk.h - how far apart are two convex bodies?  (Gilbert, Johnson, Keerthi.)
// Paper: section 5.1, Eqs 2 to 7.  Book: chapter 4.
// Units: metres, in the frame of the points (the world's).
#pragma once
#include "vec3.h"
#include <stdbool.h>

// The convex hull of count >= 1 points, which it does not own.
typedef struct { const vec3 *at; int count; } hull;

// A corner of the Minkowski difference A - B: vertex a of A less vertex b of B.
typedef struct { int a, b; vec3 at; } corner;

typedef struct {
    int    count;       // 0: none yet;  4: a tetrahedron that holds the origin
    corner of[4];
    real   weight[4];   // barycentric coordinates of v: > 0, sum 1
    vec3   v;           // the point of the simplex nearest the origin
} simplex;

typedef enum {
    GJK_APART,          // distance, axis and nearest points hold
    GJK_BEYOND,         // further apart than the margin: distance is a bound,
                        // axis separates, the points are not nearest
    GJK_OVERLAP,        // they meet; or nearly, to rounding or to 1e-60 m
    GJK_NOT_FINITE,     // a coordinate is NaN or beyond 1e60 m: all is 0
    GJK_CAPPED          // out of iterations: the best so far
} gjk_status;

typedef struct {
    gjk_status status;
    real    distance;   // m, 0 when they overlap
    vec3    axis;       // m, from B to A: on_a - on_b, a separating axis
    vec3    on_a, on_b; // m, the nearest (witness) points, of bodies apart
    simplex last;       // the final simplex, from which hit_face goes on
    int     iterations;
    bool    wide;       // rounding hid the answer: 106 bits found it
} gjk_result;
//<

//> gjk-declare
// Normal of a triangle by the right-hand rule; its length is twice the area.
vec3 triangle_normal(vec3 a, vec3 b, vec3 c);

// Where the origin projects to on a triangle with the normal n: its barycentric
// coordinates times a number > 0 (m^4); all 0 if the triangle has no area.
void triangle_weigh(vec3 n, vec3 a, vec3 b, vec3 c, real w[3]);

// The corner of A - B that lies furthest along d, a vector of any length.
corner hull_support(hull a, hull b, vec3 d);

// The same of a triangle of corners of A - B, in 106 bits: where it is nearest to
// the origin.  s has three corners; fills in v and the weights (>= 0), and returns
// the normal.
vec3 triangle_nearest_wide(simplex *s, hull a, hull b);

// Do products of four coordinates not overflow?  They do from 1e60 m on.
bool hull_in_range(hull h);

// The distance of two convex bodies, to rounding.  Stops with GJK_BEYOND once
// it is surely more than margin (m, >= 0; HUGE_VAL: never).  carried (or NULL):
// the last simplex of the pair, for a warm start; receives the new one.
gjk_result gjk_distance(hull a, hull b, real margin, simplex *carried);

// The same of hulls that are known to be in range.
gjk_result gjk_search(hull a, hull b, real margin, simplex *carried);
//<
