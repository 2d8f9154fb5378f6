//> penetration-head
// penetration.h - two bodies overlap: which way out, and who touched whom?
//
// Paper: section 5.1, the hit face: the face of A - B nearest the origin,
// found by van den Bergen's expanding polytope.  Book: chapter 10.

#ifndef TUMBLE_PENETRATION_H
#define TUMBLE_PENETRATION_H

#include "distance.h"
#include "feature.h"

typedef enum {
    PENETRATION_FOUND,
    PENETRATION_APART,          // the origin is outside A - B
    PENETRATION_NOT_FINITE,     // a coordinate is NaN, infinite or beyond 2^1020 m; the
                        // numbers are all 0
    PENETRATION_CAPPED,         // polytope full: depth is an upper bound, still usable
    PENETRATION_FLAT            // A - B has no volume (two flat sets in one plane):
                        // depth 0 along its normal
} penetration_status;

typedef struct {
    penetration_status status;
    touch_kind kind;
    real depth;         // m, >= 0: the least move that parts them
    vec3 normal;        // unit, from B to A: A moves out along it by depth
    vec3 on_a, on_b;    // m, the points that the move brings together:
                        // on_b - on_a = depth * normal
    feature_point a, b; // on_a and on_b in terms of vertices; equal vertices
                        // merged
    int  corner_a[3], corner_b[3]; // the corners of the hit face: pairs (a, b)
    int  iterations;
} penetration_result;

// Memory for the polytope: one for each thread that asks.
typedef struct penetration_scratch penetration_scratch;
//<

//> penetration-declare
penetration_scratch *penetration_scratch_new(void);     // NULL if memory is refused
void         penetration_scratch_free(penetration_scratch *scratch);

// The hit face of hulls a and b; PENETRATION_APART if they do not overlap.  start is
// the final simplex of distance_find for the pair; or empty (count 0), which for
// small bodies costs less than to ask gjk before.
penetration_result penetration_find(point_set a, point_set b, const distance_cache *start,
                         penetration_scratch *scratch);

#endif
//<
