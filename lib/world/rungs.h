//> rungs-head
//>   Between the look at the contacts and the substeps stands one function.
// rungs.h - islands take the substeps that they need, and no other does.
//
// Paper: not asked.  Book: chapter 18.
// Bodies that push each other, or are joined, are an island, and what is in two
// islands does not meet in this frame.  So each may have substeps of its own.
// Those that take about as many go together, on one rung.  Models of stars have
// such block time steps (Aarseth 1963, McMillan 1986).

#pragma once

#include "world.h"

// Sorts what is awake into rungs, and the contacts of the frame with it: the
// solver has looked at them, and no one holds their numbers.  Returns how many
// rungs there are, at least one; they stand in rigid.rungs, w->rigid.by_rung.
int rungs_find(world *w);

// Does one of a and b, which is driven, turn past the other within a frame?  (b < 0:
// a plane, which nothing passes.)
bool rungs_sweeps(const world *w, int a, int b);

// The island of the one of a and b that moves; NULL: neither does.
island *rungs_island(const world *w, int a, int b);
//<
