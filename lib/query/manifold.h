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
    real  round_a, round_b;     // m, how far outside of the points of A and of B
                                // their surfaces are, along the normal
} manifold;
//<

//> manifold-declare
//>   It begins with the answer of a query, and gives back at least that one
//>   touch.
// The touches of rigid bodies a and b where their surfaces are nearly parallel, across
// the normal, and nearer than margin (m).  They are the corners of a polygon: the
// overlap, seen along the normal, of the patch of A (a face, an edge or a vertex that
// faces against the normal) and the patch of B (which faces along it).  A corner is a
// vertex of A over a face of B, a face of A over a vertex of B, or an edge over an
// edge.  Nearly parallel means: leaning by at most 8 degrees plus `turn` (rad, >= 0),
// by which the bodies may turn before they are asked again.  The faces of a patch
// differ from the one that leans least by at most 3 degrees.  Two edges count as
// parallel up to half a degree, and then their points may be off the normal by as much.
// `nearest` is the pair of nearest (or deepest) points that a query found; its normal
// becomes the manifold's.  If fewer than two corners are near, that pair is the only
// touch.  Else point[0] is the deepest corner, and the others are those without which
// the bodies could sink deepest; the pair, which may be any point of two parallel
// faces, is dropped.  Of a patch that bulges, the corners of one face come before those
// of its rim: that face at the nearest vertex which leans least, because the body lies
// on it, or will.  Of two corners at one place one is given.
// Requires nearest->near.  The count is >= 1; if numbers are not finite, the given pair
// may be the only touch.
manifold manifold_find(const collider *a, const collider *b,
                       const query_result *nearest, real margin, real turn);

// The touches of body a and a plane with a unit normal, n . x = offset (m), as on a
// face without a rim.  Each is a vertex of A; point[].b is empty.  count is 0 if they
// are further apart than the margin, or a number is not finite.
manifold manifold_on_plane(const collider *a, vec3 normal, real offset,
                           real margin, real turn);

// Of a rim of many corners four are kept.  Between them a body that turns sinks by at
// most a third of its radius times the angle.  A body that has turned by more than this
// angle is asked again, and one that will turn by more touches where it is nearest.
// (Coins sink twice as deep with twice this angle, and no less with half.)
static const real MANIFOLD_TURN = 0.05;     // tuned, rad

// m^2, the normal of face f of a body with its vertices at `at`: outwards, and as long
// as twice the area.
vec3 face_area(const shape *s, const vec3 *at, int f);

// Is the normal of face f within 8 degrees of the unit vector d (cosine squared 0.98)?
int face_is_along(const shape *s, const vec3 *at, int f, vec3 d);
//<
