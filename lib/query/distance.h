//> distance-head
// distance.h - how far apart are two convex bodies?
//
// Paper: section 5.1, Eqs 2 to 7; the variant of van den Bergen (1999) with the
// signed volumes of Montanari et al. (2017).  Book: chapter 10.
// Units: metres, in the frame of the points (the world's).

#ifndef TUMBLE_DISTANCE_H
#define TUMBLE_DISTANCE_H

#include "support.h"

// Up to four points of A - B, each the difference of a vertex of A and one of
// B, and the weights (>= 0, sum 1) that make the point nearest the origin.
typedef struct {
    int  count;                 // 0: none yet
    int  a[4], b[4];            // vertices of A and of B
    real weight[4];
    vec3 axis;                  // unit, from B to A: parted them beyond the
                                // margin; 0: did not
} distance_cache;

typedef enum {
    DISTANCE_APART,          // distance and witness points are exact to the bound
    DISTANCE_BEYOND,         // further apart than the margin; distance is a lower
                        // bound, axis separates, no witness points
    DISTANCE_OVERLAP,        // the simplex holds the origin, or the origin lies so
                        // near it that rounding cannot tell: ask hit_face
    DISTANCE_NOT_FINITE,     // a coordinate is NaN, infinite or beyond 2^1020 m; the
                        // numbers are all 0
    DISTANCE_CAPPED          // ran into the iteration cap: the best so far
} distance_status;

typedef struct {
    real relative_error; // of the distance, >= 0 and < 1; 0 asks for all that
                         // rounding gives
    real margin;         // m, >= 0: stop once the distance surely exceeds it
    int  cap;            // iterations, >= 1
} distance_options;

typedef struct {
    distance_status status;
    real    distance;   // m, 0 when they overlap
    vec3    axis;       // m, from B to A: on_a - on_b, the point of A - B
                        // nearest the origin; a separating axis when apart
    vec3    on_a, on_b; // m, witness points; a point of each when they overlap
    distance_cache last;       // the final simplex
    int     iterations; // support points asked for
} distance_result;
//<

//> distance-declare
// Exact to rounding, no margin (infinite), cap 64.
distance_options distance_options_default(void);

// Distance of the hulls of a and b.  carried holds the final simplex of an
// earlier call for the same pair (count = 0: none) and receives this one's:
// while the bodies move little, the search starts where it ended.  NULL: none.
distance_result distance_find(point_set a, point_set b, distance_options options,
                        distance_cache *carried);

#endif
//<
