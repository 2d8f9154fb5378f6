//> solver-head
// solver.h - parts rigid bodies from what they touch.
//
// Paper: section 6.1.  Book: chapters 16 and 13.

#ifndef TUMBLE_SOLVER_H
#define TUMBLE_SOLVER_H

#include "world.h"
//<

//> solver-declare
// Once a substep of h (s): contacts that forget, one after the other; then
// those that remember, blows first, until none wants more or passes run out.
void solver_separate(world *w, real h);

// After relaxing: bodies that met in a blow part at restitution times the speed
// at which they met (BODY_VERTICES; of those of four solver_separate takes
// care).
void solver_bounce(world *w, real h);

// The end of a frame: who pushed each other is one island, and all is counted.
void solver_end(world *w);

#endif
//<
