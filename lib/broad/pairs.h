//> pairs-head
// pairs.h - which rigid bodies may meet in this frame?
//
// Paper: section 5.2 tests every pair of spheres.  Book: chapter 16.
//
// Asked once a frame, before anybody moves: so they are looked at as far ahead
// as they may get in it.  Whom they list, narrow.h asks where they touch.

#ifndef TUMBLE_PAIRS_H
#define TUMBLE_PAIRS_H

#include "world.h"
//<

//> pairs-declare
// How body b moves in a frame, as fast as it is now: its way, turn and reach.
void pairs_look_ahead(const world *w, body *b);

// The ball around rigid body b, where it is now.
sphere pairs_ball(const world *w, body *b);

// Looks at every body, says who moves, and lists the pairs of rigid ones that
// may meet in this frame.  Wakes sleepers that something quick comes near.
void pairs_find(world *w);

// Do bodies a and b pass each other, in this share of the frame, by more than
// the smaller inner radius?  Then it must be asked when they first touch, or
// they may be lost to each other.
int pairs_pass_far(const body *a, const body *b, real share);

// Will rigid bodies a and b, which pass each other as far as that in this
// frame, come so near that they may touch?  After pairs_find.
int pairs_fly_into(const world *w, const body *a, const body *b);

// Body a comes near body b: if one of them sleeps and the other did not lie
// still in the last frame, the sleeper wakes, in time to take its part of the
// blow, and all that sleep with it.  1 if so.
int pairs_wake(world *w, int a, int b);
//<

//> pairs-end-of-header
#endif
//<
