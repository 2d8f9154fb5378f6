//> step-head
//>   The function to read is `world_step`, with the two that it calls: `find` is the
//>   first three phases of the picture, `solve_frame` the last two.
// step.h - one frame: integrate, find, separate, relax.
//
// Paper: sections 5 and 6.  Book: chapter 18.

#pragma once

#include "world.h"

// Moves the world on by one frame of options.dt, and says in w->report what it did.  It
// never fails: a body whose numbers are not finite touches nothing, and contacts that
// find no memory are counted in w->report.dropped.
void world_step(world *w);
//<
