//> rungs-head
//>   Between the look at the contacts and the substeps stands one function.
// rungs.h - each island takes as many substeps as it needs.
//
// Paper: not asked.  Book: chapter 18.
// Bodies that push each other, or are joined, form an island, and bodies of two islands
// do not meet in this frame.  So each island may have its own number of substeps.
// Islands with about the same number are solved together, as one rung.  Simulations of
// stars have such block time steps (Aarseth 1963, McMillan 1986).

#pragma once

#include "world.h"

// Sorts the bodies that are awake, and the contacts of the frame, into rungs
// (rigid.rungs, rigid.by_rung), after solver_activate; numbers of contacts change.
// Returns how many rungs there are, at least one.
int rungs_find(world *w);

// Does the driven one of a and b turn past the other within a frame?  False for a
// plane, b < 0.
bool rungs_sweeps(const world *w, int a, int b);

// The island of a, or of b if a does not move; NULL if neither moves.
island *rungs_island(const world *w, int a, int b);
//<
