//> solver-head
// solver.h - parts rigid bodies from what they touch.
//
// Paper: section 6.1.  Book: chapter 16.

#ifndef TUMBLE_SOLVER_H
#define TUMBLE_SOLVER_H

#include "world.h"
//<

//> solver-declare
// Once a substep of h (s): blows first, then all contacts, until none wants
// more or passes run out.
void solver_separate(world *w, real h);

// The end of a frame: who pushed each other is one island, and all is counted.
void solver_end(world *w);

#endif
//<
