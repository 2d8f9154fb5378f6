//> manifold-head
// manifold.h - where two bodies touch, when they touch in more than one point.
//
// Paper: section 5.1 treats one pair of features; two faces touch in a polygon.
// Book: chapter 11.
// Units: metres, in the world's frame.  The normal points from B to A.

#ifndef TUMBLE_MANIFOLD_H
#define TUMBLE_MANIFOLD_H

#include "body.h"
#include "feature.h"

enum { MANIFOLD_TOUCHES = 4 };

// A point of A and the point of B across from it, along the normal, in terms of
// the vertices of each (numbered within the body).
typedef struct {
    feature_point a, b;
    real gap;           // m, (pA - pB) . normal; < 0: overlap
} touch;
//<

//> manifold-declare
// The touches of rigid bodies a and b, whose vertices stand at at_a and at_b,
// where their surfaces run alike across the unit vector normal, as far as they
// are nearer than margin (m): the corners of the polygon in which the patch of
// A (a face, an edge or a vertex that looks against the normal) and that of B
// (which looks along it) overlap, seen along the normal.  Each is a vertex of A
// over a face of B, a face of A over a vertex of B, or an edge over an edge.
// nearest is the pair of nearest (or deepest) points that a query found, its
// gap along normal.  It is the only answer where fewer than two corners are
// near.  Else out[0] is the deepest corner, and the others (at most
// MANIFOLD_TOUCHES in all) span the most; nearest, which may be any point of
// two faces that are parallel, is dropped.  Only if the patches bulge, so that
// nearest is deeper than every corner by more than a hundredth of their reach,
// it is out[0].  Of two corners at one place one is given.  Two edges count as
// side by side up to half a degree; their points may then be off the normal by
// as much.  Returns the number of touches, >= 1.
// Numbers that are not finite: nearest, as it was given, may be all.
int manifold_find(const shape *a, const vec3 *at_a,
                  const shape *b, const vec3 *at_b, vec3 normal,
                  touch nearest, real margin, touch out[MANIFOLD_TOUCHES]);

// m, where the point that f stands for is, in a body with vertices at `at`.
vec3 feature_place(const feature_point *f, const vec3 *at);

// Does face f of a body with vertices at `at` look along the unit vector d, to
// within 8 degrees (cosine squared 0.98)?
int face_looks(const shape *s, const vec3 *at, int f, vec3 d);

#endif
//<
