//> substeps-head
// substeps.h - the number of substeps of a frame.
//
// Book: chapter 18.

#pragma once

#include "world.h"

// The substeps of island i, for this frame or part of a frame, after solver_activate:
// the usual number, or more if contacts bear much for their masses, if joints swing
// fast, and for cloth.  *c is what the island took before, and becomes what it takes
// now.  At most options.most_substeps in a frame.
int substeps_choose(world *w, const island *i, substep_choice *c);

// The most of all.  A part of a frame that gets fewer for that is counted in
// report.cut.
int substeps_all(const world *w);

// With `left` substeps of h (s) to go: into how many must that time be divided, for the
// pulls that joints have felt in the last one?  Where there is rope or cloth: `left`.
int substeps_left(const world *w, real h, int left);
//<
