// solution.c - the least of fifteen overlaps.

#include "fifteen.h"

// m, from its middle, along a unit vector.
static real reach(const box *x, vec3 n)
{
    return x->half.x * fabs(vec3_dot(n, x->axis[0]))
         + x->half.y * fabs(vec3_dot(n, x->axis[1]))
         + x->half.z * fabs(vec3_dot(n, x->axis[2]));
}

// Three faces of A, three of B, nine crossings of an edge with an edge.  Of
// parallel edges: the zero vector, no direction.
static vec3 direction_of(const box *a, const box *b, int k)
{
    if (k < 3) return a->axis[k];
    if (k < 6) return b->axis[k - 3];
    return vec3_unit(vec3_cross(a->axis[(k - 6) / 3], b->axis[(k - 6) % 3]));
}

fifteen_result boxes_depth(const box *a, const box *b)
{
    vec3 between = vec3_sub(a->centre, b->centre);
    fifteen_result r = { HUGE_VAL, { 0, 0, 0 }, -1 };
    for (int k = 0; k < 15; k++) {
        vec3 n = direction_of(a, b, k);
        if (!(vec3_length_squared(n) > 0)) continue;
        real along = vec3_dot(n, between);
        real overlap = reach(a, n) + reach(b, n) - fabs(along);
        if (!(overlap < r.depth)) continue;
        r.depth = overlap;
        r.normal = along >= 0 ? n : vec3_scale(-1, n);
        r.direction = k;
    }
    return r;
}
