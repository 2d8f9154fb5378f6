//> substeps-head
// substeps.h - how many substeps does a frame need?
//
// Book: chapter 18.

#pragma once

#include "world.h"

// Of island i, for the frame or the part of it whose contacts the solver has
// looked at: the usual number, or more where contacts bear much beside their
// masses, where joints swing fast, and for cloth.  *c is what it has taken so
// far, and becomes what it asks for.  At most options.most_substeps in a frame.
int substeps_choose(world *w, const island *i, substep_choice *c);

// And never more than this: what has fewer for that is counted in report.cut.
int substeps_all(const world *w);

// After a substep of h (s), when `left` of them were to go, it among them: into
// how many must that time be divided instead, because its joints swung faster
// than it could follow?  0: it is good.  Not where there is cloth or rope, which
// has moved.  At most options.most_substeps in a frame; those that are done
// again are on top.
int substeps_again(const world *w, real h, int left);
//<
