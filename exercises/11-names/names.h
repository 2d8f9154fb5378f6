// names.h - touches that are known again in the next frame.

#ifndef TUMBLE_NAMES_H
#define TUMBLE_NAMES_H

#include "manifold.h"

// Are s and t, of the same two bodies, the same touch, a frame apart?  They are
// if a vertex of A touches in both, and it is the same one; or a vertex of B,
// likewise; or if no vertex touches in either, and the vertices of A's feature
// are the same, in any order, and those of B's.  Weights and gaps may differ.
int touch_same(const touch *s, const touch *t);

// Hands what the old touches pushed (kg m) to those that are the same now:
// begin[i] of now[i] is pushed[k] of the first old[k] that is the same and has
// not been handed on; 0 if there is none.  What none takes is lost.
void names_carry(const touch *old, const real *pushed, int olds,
                 const touch *now, real *begin, int n);

#endif
