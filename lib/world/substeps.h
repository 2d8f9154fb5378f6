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

// After a substep of h (s), with `left` to go, itself included: into how many must that
// time be divided instead, because joints swung faster than it could follow?  0: it was
// good, or there is rope or cloth, which has moved already.  At most
// options.most_substeps in a frame, beside those that are done again.
int substeps_again(const world *w, real h, int left);
//<
