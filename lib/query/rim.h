//> rim-head
//>   A cylinder is a prism for the search, and round for the answer.
// rim.h - the round side of a cylinder, seen from where it is touched.
//
// Paper: no such bodies.  Book: chapter 10.
// Units: metres, in the frame of the vertices (the world's).

#pragma once

#include "feature.h"
#include "body.h"

// A body that leans from its face by less than this still stands on all corners of the
// face; one that leans more stands on an edge, or on its rim.
static const real LEAN_SINE = 0.14142135623730951;     // tuned, 1: 8 degrees

// The point of a cylinder that reaches furthest along a direction d is on one of its
// two rims.  The line along d through that point crosses the axis.  Seen from d, the
// cylinder is a ball around this crossing, and between the crossings of both rims a
// capsule.  The crossings do not move while the body rolls.
typedef struct {
    shape core;         // of the capsule: two particles, an edge, and its radius
    vec3  at[2];        // m, its ends; [0] is that of the rim around particle 0
    real  part[2];      // their places, as fractions from particle 0 to 1
    bool  is_seen;      // a round part faces d; if not, there is no core
    bool  is_flat;      // the side itself faces d, up to 8 degrees
    half_edge half[2];
    int   first[2];
} rim_core;
//<

//> rim-declare
//>   Three functions: what it looks like towards d, which of its ends is nearest, and
//>   what a point of the core is to the body.
// Computes the core of a body with vertices at `at`, towards the unit vector d.  False,
// and not is_seen: it is no cylinder, or an end faces d, up to 8 degrees.  *r must not
// be copied.
bool rim_towards(const shape *s, const vec3 *at, vec3 d, rim_core *r);

// The end that reaches furthest along d.
feature_point rim_furthest(const rim_core *r, vec3 d);

// A point of the core as a point of the body: its particles 0 and 1 with weights, which
// may lie beyond them.  Without a core the point belongs to the body already.
feature_point rim_feature(const rim_core *r, const feature_point *on_core);

// m, how far the prism of its mesh is inside of the cylinder at most; 0 for other
// shapes.
real rim_sag(const shape *s);
//<
