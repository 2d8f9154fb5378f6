// round.h - convex bodies with round edges: balls, capsules, rounded boxes.
//
// Units: metres, in the frame of the points (the world's).

#ifndef TUMBLE_ROUND_H
#define TUMBLE_ROUND_H

#include "gjk.h"

// All that is no further than radius from the hull of the core.  One point: a
// ball.  Two: a capsule.  Eight corners: a box with round edges.
typedef struct {
    hull core;
    real radius;        // m, >= 0
} round_body;

typedef struct {
    gjk_status status;  // what GJK says of the cores
    real gap;           // m, between the surfaces; < 0: they overlap
    vec3 normal;        // unit, from B to A
    vec3 on_a, on_b;    // m, the nearest points of the surfaces
} round_result;

// The point of r furthest along d, whose length does not matter.  d = 0 has no
// direction: then any point of r.
vec3 round_support(round_body r, vec3 d);

// The gap, and where it is: on_a - on_b = gap * normal.  Where the cores
// themselves overlap (status GJK_OVERLAP) there is no telling the way out: gap
// is minus the sum of the radii, which the bodies overlap by at least, normal
// is 0, and on_a and on_b are what GJK gives for the cores.  GJK_NOT_FINITE:
// everything is 0.
round_result round_distance(round_body a, round_body b);

#endif
