//> drive-head
// drive.h - kinematic bodies in a step: only the program moves them.
//
// Paper: not asked.  Book: chapter 18.
// A kinematic body that moves is called driven here.  Contacts read its motion, and
// never change it.  For joints it is a body of HEAVIER times its mass, so they need no
// case of their own.
// Units: metres, seconds.

#pragma once

#include "world.h"
//<

//> drive-declare
// Makes the driven body b heavy, once it has its basis, and gives it the velocity that
// the program chose.
void drive_begin(world *w, int b);

// Gives all driven bodies that velocity again, after joints have changed it.
void drive_hold(world *w);

// Puts the driven body b to where it is so long (s) after the substeps began.
void drive_advance(world *w, int b, real seconds);

// Puts it back to where it was when they began.
void drive_back(world *w, int b);

// m/s: no point of a driven body is faster.
real drive_fastest(const world *w);
//<
