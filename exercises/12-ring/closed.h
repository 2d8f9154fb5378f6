// closed.h - three diagonals and two corners: a rope whose ends are joined.
//
// Units: metres, inverse masses in 1/kg.

#ifndef TUMBLE_CLOSED_H
#define TUMBLE_CLOSED_H

#include "verlet.h"

// Solves, for k = 0 .. n - 1 and n >= 3, with the indices counted round,
//     lower[k] x[k - 1] + diagonal[k] x[k] + upper[k] x[k + 1] = right[k]:
// before row 0 comes row n - 1, after row n - 1 comes row 0.  Where right goes
// in, x comes out.  room is for 3 n numbers.  Returns 1; or 0 if there is no
// answer, or no single one, as far as 1e-12 can tell.
int ring_solve(int n, const real *lower, const real *diagonal,
               const real *upper, real *x, real *room);

// One step of Newton for a ring of n >= 3 particles: link k joins p[k] and the
// next one, the last link p[n - 1] and p[0]; each ought to be `rest` (m) long.
// room is for 7 n numbers.  Returns 1; or 0 if the links have no answer: then
// nothing has moved.
int ring_step(particle *p, int n, real rest, real *room);

#endif
