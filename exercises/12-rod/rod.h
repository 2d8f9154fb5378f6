// rod.h - a rope that does not like to be bent.
//
// Units: metres, seconds, kilograms, newtons.

#ifndef TUMBLE_ROD_H
#define TUMBLE_ROD_H

#include "verlet.h"

// A symmetric matrix of five diagonals: row k has diagonal[k] in column k,
// next[k] in columns k + 1 and (row k + 1) k, far[k] in columns k + 2 and
// (row k + 2) k.  What would stand outside is 0, and is not looked at.
typedef struct {
    int n;
    real *diagonal, *next, *far;        // [n] each
} band;

// Fills in what a rod of n particles adds to the system of rod_step:
//     M + h^2 B,  M = diagonal of masses,
// where B belongs to the bending energy
//     stiffness / 2 sum_k |x_(k-1) - 2 x_k + x_(k+1)|^2,  0 < k < n - 1,
// with stiffness in N/m.  A nailed particle (inverse mass 0) does not move: its
// row and column are those of the unit matrix.
void rod_band(band *m, const particle *p, real stiffness, real h);

// Solves m x = right for three right sides at once, one for each coordinate;
// where right goes in, x comes out.  m is lost.  Returns 1; or 0 if a pivot is
// not greater than 0: then x holds nothing of use.
int band_solve(band *m, vec3 *x);

// Bends n particles back, for a substep of h (s), after they have moved: moves
// the positions by what the force of bending does that they have at the END of
// it.  Masses are 1 / inverse_mass.  All three arrays of m are for n numbers,
// move is for n vectors.  Returns 0, and moves nobody, if it cannot be solved.
int rod_step(particle *p, int n, real stiffness, real h, band *m, vec3 *move);

#endif
