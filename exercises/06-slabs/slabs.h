// slabs.h - bodies between seven pairs of planes (a k-DOP, k = 14).

#ifndef TUMBLE_SLABS_H
#define TUMBLE_SLABS_H

#include "vec3.h"

enum { SLABS = 7 };

static const vec3 SLAB[SLABS] = {
    { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 1, 1 }, { 1, 1, -1 }, { 1, -1, 1 }, { 1, -1, -1 }
};

// low[k] <= SLAB[k] . x <= high[k]: metres for the first three, sqrt(3) times
// metres for the others.  low > high: empty.
typedef struct {
    real low[SLABS], high[SLABS];
} slabs;

// Around n points; n = 0: empty (low is infinity, high is -infinity).  A point
// with a NaN makes NaN of what it takes part in.
slabs slabs_of_points(const vec3 *at, int n);

// Around a ball of this radius (m), >= 0.
slabs slabs_of_ball(vec3 center, real radius);

// Around both.  NaN in one of them stays.
slabs slabs_join(const slabs *a, const slabs *b);

// 1 unless some direction shows that they are apart by margin (m), >= 0, or
// more.  Empty slabs meet nothing; NaN shows nothing.
int slabs_meet(const slabs *a, const slabs *b, real margin);

#endif
