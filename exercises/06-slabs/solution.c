// solution.c - seven intervals.

#include "slabs.h"

// The length of SLAB[k].
static real slab_length(int k)
{
    return vec3_length(SLAB[k]);
}

// The smaller, or larger, of the two; a NaN in either wins.
static real lower(real a, real b)
{
    return a < b || a != a ? a : b;
}

static real higher(real a, real b)
{
    return a > b || a != a ? a : b;
}

slabs slabs_of_points(const vec3 *at, int n)
{
    slabs s;
    for (int k = 0; k < SLABS; k++) {
        s.low[k] = (real)INFINITY;
        s.high[k] = -(real)INFINITY;
        for (int i = 0; i < n; i++) {
            real along = vec3_dot(SLAB[k], at[i]);
            s.low[k] = lower(s.low[k], along);
            s.high[k] = higher(s.high[k], along);
        }
    }
    return s;
}

slabs slabs_of_ball(vec3 center, real radius)
{
    slabs s;
    for (int k = 0; k < SLABS; k++) {
        real along = vec3_dot(SLAB[k], center);
        s.low[k] = along - radius * slab_length(k);
        s.high[k] = along + radius * slab_length(k);
    }
    return s;
}

slabs slabs_join(const slabs *a, const slabs *b)
{
    slabs s;
    for (int k = 0; k < SLABS; k++) {
        s.low[k] = lower(a->low[k], b->low[k]);
        s.high[k] = higher(a->high[k], b->high[k]);
    }
    return s;
}

// Apart along one of them is apart.
int slabs_meet(const slabs *a, const slabs *b, real margin)
{
    for (int k = 0; k < SLABS; k++) {
        real room = margin * slab_length(k);
        if (a->low[k] >= b->high[k] + room) return 0;
        if (b->low[k] >= a->high[k] + room) return 0;
    }
    return 1;
}
