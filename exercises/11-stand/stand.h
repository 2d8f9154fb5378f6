// stand.h - does a body stand on its contacts?
//
// Units: metres.

#ifndef TUMBLE_STAND_H
#define TUMBLE_STAND_H

#include "vec3.h"

typedef struct {
    real margin;    // m, across `down`: how far the foot of the weight lies
                    // inside the polygon of the contacts (> 0: it stands), or
                    // (< 0) how far outside; -HUGE_VAL: no contact, no `down`,
                    // or numbers that are not finite
    int  a, b;      // the contacts between which it would tip, or tips: a < b.
                    // Alone, it turns about a = b.  -1: none
} stand;

// Does a body with its weight at `center` stand on the n points `at`?  The
// weight pulls along `down`, which need not be a unit vector.  The points may
// come in any order, one may be there twice or stand between others, and they
// need not lie in a plane: all is seen along `down`.  Only what stands counts:
// on a single point or a line nothing does, and margin <= 0.
stand stand_find(const vec3 *at, int n, vec3 center, vec3 down);

#endif
