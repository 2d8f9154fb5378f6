//> ahead-head
//>   How far a body gets in a frame, and which pairs are asked again within it.
// ahead.h - what bodies are asked for: where they will be, and until when that
// holds.
//
// Paper: bodies move, then overlaps are looked for.  Book: chapter 18.
// Units: metres, seconds, radians.

#pragma once

#include "world.h"

// How far body b may get in so many seconds, in rigid.ahead, and as what it is
// asked until then, in rigid.asked.  It has a frame, a basis and a velocity.
void ahead_predict(world *w, int b, real seconds);

// What the cache is told, and asked for.
cache_frame ahead_frame(const world *w);

// Between two substeps, with `left` (s) to go: asks again for contacts of the
// rung that goes, of bodies that have turned so far that other points of theirs
// may touch by now.  Each at most once a substep.
void ahead_again(world *w, const solver_frame *f, real left);
//<
