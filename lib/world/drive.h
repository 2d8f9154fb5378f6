//> drive-head
// drive.h - kinematic bodies in a step: a program moves them, and nothing else.
//
// Paper: not asked.  Book: chapter 18.
// One that moves is called driven here.  Contacts read how it moves, and write nothing
// to it.  To joints it is a body of HEAVIER times its mass, so they need not know.
// Units: metres, seconds.

#pragma once

#include "world.h"
//<

//> drive-declare
// Body b, which is driven, has its basis: it becomes heavy, and has the velocity
// that the program gave it.
void drive_begin(world *w, int b);

// All that are driven have that velocity still: what joints did is taken back.
void drive_hold(world *w);

// Body b, which is driven, stands where it does so long (s) after the substeps
// began.
void drive_advance(world *w, int b, real seconds);

// It stands where it did when they began.
void drive_back(world *w, int b);

// m/s, of any point of a driven body, at most.
real drive_fastest(const world *w);
//<
