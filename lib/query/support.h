//> support-head
// support.h - which point of a convex body is furthest along a direction?
//
// Paper: section 5.1, Eqs 5 and 6.  Book: chapter 10.
// Units: metres, in the frame of the points (the world's).

#ifndef TUMBLE_SUPPORT_H
#define TUMBLE_SUPPORT_H

#include "vec3.h"

// The convex hull of points.  ring_start and ring list the mesh neighbours of
// each point (see shape); NULL: unknown, and support scans.
typedef struct {
    const vec3 *at;
    int count;                  // >= 1
    const int *ring_start, *ring;
} point_set;

// A vertex of A and one of B: their difference is a corner of A - B.
typedef struct {
    int a, b;
} vertex_pair;
//<

//> support-declare
// The vertex of p furthest along d; of equals the lowest index (scan), or the
// one where climbing from vertex `from` ends.  Climbing needs p.ring.  A scan
// that meets a coordinate that is not finite answers -1.
int support_scan(point_set p, vec3 d);
int support_climb(point_set p, vec3 d, int from);

// Climbs if p has a ring and so many points that it pays; scans otherwise.
int support_point(point_set p, vec3 d, int from);

// The vertex of A furthest along d, and that of B furthest against it; -1 where
// a coordinate is not finite.  One climbs on both, and one scans both, with
// heights measured from the world's origin.
vertex_pair support_climb_both(const point_set *a, const point_set *b, vec3 d,
                               vertex_pair from);
vertex_pair support_scan_both(const point_set *a, const point_set *b, vec3 d);
//<

//> support-climbs
// Support looks at every point of a set up to this size, and climbs from
// neighbour to neighbour in a larger one.  (Measured: see chapter 4.)
enum { SCAN_AT_MOST = 48 };

// 1 if support climbs on p.
static inline int support_climbs(point_set p)
{
    return p.ring && p.count > SCAN_AT_MOST;
}
//<

//> support-both
// The same two vertices, as it is best.  near_home: nobody climbs, and both are
// near the world's origin, so they are scanned from there.
static inline vertex_pair support_both(const point_set *a, const point_set *b,
                                       vec3 d, vertex_pair from, int near_home)
{
    if (near_home) return support_scan_both(a, b, d);
    if (support_climbs(*a) && support_climbs(*b))
        return support_climb_both(a, b, d, from);
    return (vertex_pair){ support_point(*a, d, from.a),
                          support_point(*b, vec3_scale(-1, d), from.b) };
}

#endif
//<
