// thomas.h - three diagonals, and a rope that is solved with them.
//
// Units: metres, inverse masses in 1/kg.

#ifndef TUMBLE_THOMAS_H
#define TUMBLE_THOMAS_H

#include "verlet.h"

// Solves, for k = 0 .. n - 1 and n >= 0,
//     lower[k] x[k - 1] + diagonal[k] x[k] + upper[k] x[k + 1] = right[k].
// lower[0] and upper[n - 1] are not looked at.  x may be `right` itself.  share
// is room for n numbers.  Returns 1; or 0 if a pivot is no more than 1e-12 of
// its diagonal, or no number: then x holds nothing of use.
int thomas_solve(int n, const real *lower, const real *diagonal,
                 const real *upper, const real *right, real *x, real *share);

// One step of Newton for all links of a rope: link k joins p[k] and p[k + 1],
// and ought to be `rest` (m) long.  room is for 5 numbers a link.  Returns 1; or
// 0 if the links have no answer: then nothing has moved.
int rope_step(particle *p, int links, real rest, real *room);

#endif
