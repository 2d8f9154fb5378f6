// over.h - two other ways to iterate over sticks.

#ifndef TUMBLE_OVER_H
#define TUMBLE_OVER_H

#include "constraint.h"

// Relaxes n sticks once, in order, each by omega times what it lacks.
void over_iterate(const stick *s, int n, particle *p, real omega);

// Moves all particles by the sum of what n sticks need, each measured
// before any has moved.  move: room for one vector a particle.
void jacobi_iterate(const stick *s, int n, particle *p, int particles,
                  vec3 *move);

// The best omega for a straight chain of n >= 1 equal sticks.
real over_best(int n);

#endif
