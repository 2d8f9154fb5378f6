//> manifold-head
//>   A manifold is a normal that all touches share, and up to four touches.
// manifold.h - where two bodies touch, when they touch in more than one point.
//
// Paper: section 5.1 treats one pair of features; two faces touch in a polygon.
// Book: chapter 11.
// Units: metres, in the world's frame.  The normal points from B to A.

#pragma once

#include "query.h"

enum { MANIFOLD_POINTS = 4 };

// The touches of two bodies, which share a normal.
typedef struct {
    int   count;        // 0 to MANIFOLD_POINTS; 0: they do not touch
    vec3  normal;       // unit, from B to A
    touch point[MANIFOLD_POINTS];
    real  round_a, round_b;     // m, so far from the points of A and of B, along
                                // the normal, are their surfaces
} manifold;
//<

//> manifold-declare
//>   It begins with the answer of a query, and gives back at least that one
//>   touch.
// The touches of rigid bodies a and b where their surfaces run alike across the
// normal, as far as they are nearer than margin (m): the corners of the polygon
// in which the patch of A (a face, an edge or a vertex that looks against the
// normal) and that of B (which looks along it) overlap, seen along the normal.
// Each is a vertex of A over a face of B, a face of A over a vertex of B, or an
// edge over an edge.  To run alike is to lean by no more than 8 degrees and turn
// (rad, >= 0): so far the bodies may turn against each other before they are asked
// again.  The faces of a patch are off the one that leans least by no more than 3.
// nearest is the pair of nearest (or deepest) points that a query found, and
// its normal the manifold's.  The pair is the only touch where fewer than two
// corners are near.  Else point[0] is the deepest corner, and the others those
// without which the bodies could sink deepest; the pair, which may be any point
// of two faces that are parallel, is dropped.  Of a patch that bulges, the corners
// of one face come before those of its rim: of the faces at the nearest vertex the
// one that leans least, for on that the body lies, or will.  Of two corners at one
// place one is given.  Two edges count as side by side up to half a degree; their
// points may then be off the normal by as much.
// Requires nearest->near.  The count is >= 1; where numbers are not finite, the
// pair as it was given may be all.
manifold manifold_find(const collider *a, const collider *b,
                       const query_result *nearest, real margin, real turn);

// The touches of body a and a plane with that unit normal, n . x = offset (m):
// as on a face without a rim.  Each is a vertex of A; point[].b is empty.  count
// 0: further apart than the margin, or a number is not finite.
manifold manifold_on_plane(const collider *a, vec3 normal, real offset,
                           real margin, real turn);

// A rim of many corners holds four of them: between those a body that turns sinks by
// a third of its radius times how far it turned, at most.  One that turns by more
// than this is asked again; and where it is to turn by more, it will touch where it
// is nearest.  (Coins sink twice as deep with twice as much, and no less with half.)
static const real MANIFOLD_TURN = 0.05;     // tuned, rad

// m^2, the normal of face f of a body with vertices at `at`, outwards and twice
// as long as the face is large.
vec3 face_area(const shape *s, const vec3 *at, int f);

// Does it look along the unit vector d, to within 8 degrees (cosine squared
// 0.98)?
int face_is_along(const shape *s, const vec3 *at, int f, vec3 d);
//<
