//> substeps-head
// substeps.h - how many substeps does a frame need?
//
// Book: chapter 18.

#ifndef TUMBLE_SUBSTEPS_H
#define TUMBLE_SUBSTEPS_H

#include "world.h"

// In how many parts is this frame to be solved?  Its moments of inertia are those
// of its beginning, in each part; what is joined must not turn too far with them.
int parts_for_turns(const world *w);

// For the frame, or the part of it, whose contacts the solver has looked at:
// the usual number, fewer where all is calm, more under heavy loads, for small
// things, and for cloth.  At most options.most_substeps in a frame, and never
// more than ALL_SUBSTEPS: what has fewer for that is counted in report.cut.
int substeps_choose(world *w);

// With how many substeps that frame, or part, which had so many, must be solved
// again, because its joints swung faster than those could follow; 0, if it need
// not.  Not where there is cloth or rope, which has moved.  These, too, are at most
// options.most_substeps in a frame; those of the first time are on top.
int substeps_again(const world *w, int had);

#endif
//<
