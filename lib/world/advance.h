//> advance-head
// advance.h - in every substep everything is where it is.
//
// Paper: not asked.  Book: chapter 18.
// The frame and basis of a body follow it through the substeps, and the rows of its
// contacts are made from them.  A body that lies among others hardly moves: its
// displacement is only summed up (rigid.moved) until it is too large for its rows.
// Units: metres, seconds, radians.

#pragma once

#include "world.h"
//<

//> advance-declare
// Before the substeps, when the contacts of the frame are found.
void advance_begin(world *w);

// After impacts, which displace bodies: bodies that move freely get a new frame, and
// rigid.fresh says which.
void advance_struck(world *w);

// Moves all bodies on with their velocities for a substep of h (s).  rigid.fresh says
// which of them have a new frame and basis, and rigid.middle where they were halfway.
void advance_bodies(world *w, real h);

// How far body b has turned since it had this frame: twice the sine of half the angle,
// which is how far a vertex moves for each metre of its radius.
real advance_turned(const world *w, int b, const rigid_frame *was);

// The same without the turn that moves no point of a round body: 0 for a ball, and for
// a capsule or a cylinder how far its axis has turned.
real advance_leaned(const world *w, int b, const rigid_frame *was);

// Remembers the state before a substep that may have to be done again; and restores it.
void advance_mark(world *w);
void advance_back(world *w);

// Puts body b back to where the substeps began, at rest.
void advance_stop(world *w, int b);

// After the substeps: every displacement becomes part of a frame.  A body whose numbers
// are not finite is put back as advance_stop does.  Returns how many there were.
int advance_end(world *w);

// Writes the bodies to their particles.
void advance_write(world *w);
//<
