//> rigidity-head
// rigidity.h - how many degrees of freedom do the sticks of a shape take away?
//
// Book: chapter 3.

#pragma once

#include "body.h"

// The rank of the rigidity matrix of the sticks at the rest positions: 3 n - 6
// if and only if the n particles have no infinitesimal motion left but those of
// a rigid body.  -1 if memory is refused.
int shape_rank(const shape *s);
//<
