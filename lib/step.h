//> step-head
// step.h - one frame: integrate, find, separate, relax.
//
// Paper: sections 5 and 6.  Book: chapter 9.

#ifndef TUMBLE_STEP_H
#define TUMBLE_STEP_H

#include "world.h"

// One frame of options.dt.  Requires world_begin.  Allocates nothing.
void world_step(world *w);

#endif
//<
