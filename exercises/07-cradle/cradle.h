// cradle.h - balls in a row that bounce off each other.
//
// Units: metres, kilograms; speeds in metres a step.

#ifndef TUMBLE_CRADLE_H
#define TUMBLE_CRADLE_H

#include "verlet.h"

// Lets n balls in a row along x, each touching the next, bounce until no ball
// runs into its neighbour, or cap bounces are over.  Pairs are asked from left
// to right, again and again.  A pair that approaches at u parts at restitution
// (0 to 1) * u, by masses; at most 1e-12 of the speed that was the fastest at
// first is no approach.  Speeds are moves in the last step.  Moves nothing but
// previous.x.  Returns the number of bounces.
int cradle_bounce(particle *p, int n, real restitution, int cap);

#endif
