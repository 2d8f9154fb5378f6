//> query-head
//>   A body is its shape, and where its vertices are. A `touch` is a point of A
//>   and a point of B in terms of the vertices, so that it can ride with them.
// query.h - the nearest points of two rigid bodies, asked again every frame.
//
// Paper: section 5.1.  Book: chapter 10.
// Units: metres, in the frame of the vertices (the world's).

#pragma once

#include "body.h"
#include "hit_face.h"
#include "rim.h"
#include "search.h"

// A convex body for the queries.  Of a round body they use the core: the point nearest
// on the core is nearest on the body, too, and nearer by the radius.
typedef struct {
    const struct shape *shape;  // rigid
    const vec3 *at;             // [shape->particles] its vertices
    bool in_range;              // hull_in_range has returned true for them
} collider;

// A point of A and a point of B across from it, along the normal.  Vertices are
// numbered within each body.
typedef struct {
    feature_point a, b;
    real gap;           // m, (pA - pB) . normal, less the radii of round bodies;
                        // < 0: overlap
} touch;

// What a pair keeps from one query to the next: the corners of GJK's last simplex, as
// vertices of A and of B.  All zeros: nothing yet.
typedef struct {
    unsigned short count, a[4], b[4];
} query_cache;

typedef struct {
    bool  near;         // false: further apart than the margin
    vec3  normal;       // unit, from B to A
    touch at;           // the nearest points; if the bodies overlap, the two points
                        // that the shortest way out joins; on the side of a
                        // cylinder, an end of its axis, as particle 0 or 1.  If
                        // they are not near, at.gap is a lower bound, or 0
} query_result;
//<

//> query-declare
//>   One function asks; its answer says whether the two are near, along which
//>   normal, and where.
// The nearest points of bodies a and b, if they are no further apart than margin (m, >=
// 0; HUGE_VAL: at any distance).  carried: of the same pair in the same order; the
// answer depends on it by rounding only.  Bodies or a margin that are NaN, and bodies
// beyond 1e60 m, are near nothing.
query_result query_nearest(const collider *a, const collider *b, real margin,
                           query_cache *carried);

// The points of A and of B for which a simplex of at most three corners stands.
void query_features(const simplex *s, feature_point *a, feature_point *b);

// The convex hull of a body's vertices.
hull query_hull(const collider *c);

// m, the sum of the radii around the cores of two; 0 unless they are round.
real query_round(const collider *a, const collider *b);

// The rims of two bodies that look along the normal between them.
typedef struct {
    rim_core a, b;
} rim_pair;

void query_move_to_rims(rim_pair *p, const collider *a, const collider *b, vec3 n);

// What is touched of a body: the core of that rim, or the body if none is seen.
collider query_core(const collider *c, const rim_core *r);

// The points of a touch along n go on to the cores of the rims that are seen, where
// they are not there yet; the gap is theirs.
void query_touch_cores(const collider *a, const collider *b, const rim_pair *p,
                       vec3 n, touch *t);
//<
