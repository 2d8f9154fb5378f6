//> facet-head
// facet.h - triangles of a cloth and links of a rope, beside a convex body.
//
// Paper: section 5.2 makes spheres of them.  Here: a triangle is a convex body
// with three corners, so the query of two bodies finds where it is nearest.
// Book: chapter 16.
// Units: metres, in the world's frame.

#pragma once

#include "obstacle.h"

enum { FACET = 3 };

// Where a facet and a body are nearest.
typedef struct {
    real weight[FACET]; // of its corners: >= 0, sum 1
    surface_point at;   // of the body, out of it towards the facet
    real gap;           // m; < 0: overlap
} facet_touch;

// m, how far a facet is in front of the plane with its nearest corner.  (A link
// says its last corner twice.)
static inline real facet_height(const vec3 end[FACET], plane p)
{
    real least = plane_height(p, end[0]);
    for (int k = 1; k < FACET; k++) {
        real up = plane_height(p, end[k]);
        if (up < least || up != up) least = up;
    }
    return least;
}
//<

//> facet-declare
//>   One function answers, with the nearest points and the weights of the
//>   corners.
// Is the facet with these corners nearer than reach (m, > 0) to the body, or in
// it?  *out says where the two are nearest; if not, only its gap is right, or a
// bound.
// `between` is the plane that touched the body, and had the facet in front of
// it, when that was last known (a normal of 0: never); it receives the new one.
// A facet has no inside: if it cuts the body, this plane tells by which side it
// is to leave.  Corners that are not finite are near nothing.
bool facet_nearest(const obstacle *b, const vec3 end[FACET], plane *between,
                   real reach, facet_touch *out);
//<
