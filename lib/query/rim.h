//> rim-head
//>   A cylinder is a prism for the search, and round for the answer.
// rim.h - the round side of a cylinder, seen from where it is touched.
//
// Paper: no such bodies.  Book: chapter 10.
// Units: metres, in the frame of the vertices (the world's).

#pragma once

#include "feature.h"
#include "body.h"

// A body that rests on its face, strained or rocking a little, still stands on
// all of its corners; one that leans more stands on an edge, or on its rim.
static const real LEAN_SINE = 0.14142135623730951;     // tuned, 1: 8 degrees

// Towards a direction d, no point of a cylinder reaches further than one of its two
// rims.  The line along d through that point crosses the axis: around the crossing,
// the cylinder is a ball as seen from d, and along both crossings a capsule, of which
// those are the ends.  They stay where they are while the body rolls.
typedef struct {
    shape core;         // of the capsule: two particles, an edge, and its radius
    vec3  at[2];        // m, its ends; [0] is of the rim around particle 0
    real  part[2];      // where they are: of the way from particle 0 to 1
    bool  is_seen;      // what faces d is round: else there is no core
    bool  is_flat;      // the side itself faces d, up to 8 degrees
    half_edge half[2];
    int   first[2];
} rim_core;
//<

//> rim-declare
//>   Three functions: what it looks like towards d, which of its ends is nearest, and
//>   what a point of the core is to the body.
// That of a body whose vertices are at `at`, towards the unit vector d.  False, and
// not seen: it has none, or one of its ends faces d, up to 8 degrees.  *r must stay
// where it is.
bool rim_towards(const shape *s, const vec3 *at, vec3 d, rim_core *r);

// The end that reaches furthest along d.
feature_point rim_furthest(const rim_core *r, vec3 d);

// A point of the core as one of the body: its particles 0 and 1, weighted, perhaps
// beyond them.  Where no core is seen it is one of the body already.
feature_point rim_feature(const rim_core *r, const feature_point *on_core);

// m, by how much the prism of its mesh may be short of the cylinder; 0 of others.
real rim_sag(const shape *s);
//<
