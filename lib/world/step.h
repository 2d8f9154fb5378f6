//> step-head
//>   The function to read is `world_step`, with the two that it calls: `find` is the
//>   first three phases of the picture, `solve_frame` the last two.
// step.h - one frame: integrate, find, separate, relax.
//
// Paper: sections 5 and 6.  Book: chapter 18.

#pragma once

#include "world.h"

// One frame of options.dt: every body moves, and is parted from what it met;
// threads keep their lengths.  What it did is in w->report.  Allocates nothing
// and never fails: a body whose numbers are lost touches nothing, and
// w->report.dropped counts what found no room.
void world_step(world *w);
//<
