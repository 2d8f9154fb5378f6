//> substeps-head
// substeps.h - how many substeps does a frame need?
//
// Book: chapter 18.

#ifndef TUMBLE_SUBSTEPS_H
#define TUMBLE_SUBSTEPS_H

#include "world.h"

// Of island i, for the frame or the part of it whose contacts the solver has
// looked at: the usual number, or more where contacts bear much beside their
// masses, where joints swing fast, and for cloth.  *c is what it has taken so
// far, and becomes what it asks for.  At most options.most_substeps in a frame.
int substeps_choose(world *w, const island *i, substep_choice *c);

// And never more than this: what has fewer for that is counted in report.cut.
int substeps_all(const world *w);

// When `left` substeps of h (s) are to go: into how many must that time be divided for
// what joints have felt in the last?  (Where there is cloth or rope, into as many.)
int substeps_left(const world *w, real h, int left);

#endif
//<
