//> substeps-head
// substeps.h - how many substeps does a frame need?
//
// Book: chapter 18.

#ifndef TUMBLE_SUBSTEPS_H
#define TUMBLE_SUBSTEPS_H

#include "world.h"

// For the frame, or the part of it, whose contacts the solver has looked at:
// the usual number, fewer where all is calm, more under heavy loads, for small
// things, and for cloth.  At most options.most_substeps in a frame.
int substeps_choose(world *w);

#endif
//<
