// deep.h - convex bodies with round edges, however deep they are in each other.
//
// Units: metres, in the frame of the points (the world's).

#ifndef TUMBLE_DEEP_H
#define TUMBLE_DEEP_H

#include "hit_face.h"

// All that is no further than radius from the hull of the core.  One point: a
// ball.  Two: a capsule.  Eight corners: a box with round edges.
typedef struct {
    hull core;
    real radius;        // m, >= 0
} round_body;

typedef struct {
    int  ok;            // 0: a coordinate is not finite, and all numbers are 0
    real gap;           // m, between the surfaces; < 0: A must move by -gap
    vec3 normal;        // unit, from B to A
    vec3 on_a, on_b;    // m, on the surfaces: on_a - on_b = gap * normal
} deep_contact;

deep_contact deep_contact_find(round_body a, round_body b);

#endif
