//> ahead-head
//>   How far a body gets in a frame, and which pairs are asked again within it.
// ahead.h - predictions: how far bodies move in a frame, and which contacts are found
// again within it.
//
// Paper: bodies move, then overlaps are looked for.  Book: chapter 18.
// Units: metres, seconds, radians.

#pragma once

#include "world.h"

// Predicts how far body b may move in so many seconds (rigid.ahead), and the frame in
// which its contacts are found until then (rigid.asked), from its frame, basis and
// velocity.
void ahead_predict(world *w, int b, real seconds);

// The tables of the world that the contact cache reads.
cache_frame ahead_frame(const world *w);

// Between two substeps of a rung, with `left` (s) to go: finds contacts again of bodies
// that have turned so far that other points of them may touch by now.  Each contact is
// found at most once a substep.
void ahead_again(world *w, const solver_frame *f, real left);
//<
