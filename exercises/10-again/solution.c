// solution.c - one look along the old axis, and only then GJK.

#include "again.h"

// The corner of A - B that reaches furthest against n is nearest to the origin
// along n.
real gap_along(hull a, hull b, vec3 n)
{
    corner w = hull_support(a, b, vec3_scale(-1, n));
    return vec3_dot(n, w.at) / vec3_length(n);
}

gjk_result ask_again(hull a, hull b, real margin, memory *m)
{
    const vec3 none = { 0, 0, 0 };
    // A point that is not a number is never the furthest: look for it.
    if (vec3_length(m->axis) > 0 && hull_in_range(a) && hull_in_range(b)) {
        real gap = gap_along(a, b, m->axis);
        if (gap > margin)
            return (gjk_result){ .status = GJK_BEYOND, .distance = gap,
                                 .axis = m->axis, .last = m->last };
    }
    gjk_result g = gjk_distance(a, b, margin, &m->last);
    m->axis = g.status == GJK_BEYOND ? g.axis : none;
    return g;
}
