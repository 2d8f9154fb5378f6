//> advance-head
// advance.h - in every substep everything is where it is.
//
// Paper: not asked.  Book: chapter 18.
// A body's frame and basis follow it through the substeps, and the rows of its
// contacts with them.  One that lies among others hardly moves: it is only
// displaced (rigid.moved) until that is too much for its rows.
// Units: metres, seconds, radians.

#ifndef TUMBLE_ADVANCE_H
#define TUMBLE_ADVANCE_H

#include "world.h"
//<

//> advance-declare
// The substeps begin: the bodies stand as they were looked at, and the solver
// has its contacts.
void advance_begin(world *w);

// After impacts, which displace bodies: those that go freely have a frame for it,
// and rigid.fresh says which.
void advance_struck(world *w);

// A substep of h (s): all bodies go on as fast as they are.  rigid.fresh says
// which have a new frame and basis, and rigid.middle where all were halfway.
void advance_bodies(world *w, real h);

// How far body b has turned since it stood so: twice the sine of half the angle.
// (Three unit axes that turn by an angle go by sqrt(8) times that sine together,
// a vertex by twice its radius times the sine.)
real advance_turned(const world *w, int b, const rigid_frame *was);

// The same, but of what is round only what gets it elsewhere: of a ball nothing, of
// a capsule or a cylinder how far its axis has turned.
real advance_leaned(const world *w, int b, const rigid_frame *was);

// Body b stands again where the substeps began, at rest.
void advance_stop(world *w, int b);

// The substeps have ended: no body is displaced any more.  One whose numbers are
// lost stands where it did when they began, at rest; returns how many.
int advance_end(world *w);

// The particles follow.
void advance_write(world *w);

#endif
//<
