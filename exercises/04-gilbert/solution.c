// solution.c - from point to point along segments.

#include "gilbert.h"

// The point of A - B furthest against v.  0 if it is not finite.
static int difference(hull a, hull b, vec3 v, vec3 *w)
{
    *w = hull_support(a, b, vec3_scale(-1, v)).at;
    return vec3_is_finite(*w);
}

vec3 segment_nearest(vec3 p, vec3 q)
{
    vec3 e = vec3_sub(q, p);
    real ahead = -vec3_dot(p, e), ee = vec3_length_squared(e);
    if (!(ahead > 0)) return p;
    return ahead >= ee ? q : vec3_add_scaled(p, ahead / ee, e);
}

gilbert_result gilbert_distance(hull a, hull b, real relative_error,
                                int cap)
{
    vec3 v = vec3_sub(a.at[0], b.at[0]), w;
    gilbert_result r = { .ok = 1, .most = vec3_length(v), .nearest = v };
    while (r.most > 0 && r.asked < cap) {
        r.asked++;
        if (!difference(a, b, r.nearest, &w))
            return (gilbert_result){ .ok = 0 };
        // The plane through w has all of A - B beyond it.
        real along = vec3_dot(r.nearest, w) / r.most;
        if (along > r.least) r.least = along;
        if (r.most - r.least <= relative_error * r.most) break;
        v = segment_nearest(r.nearest, w);
        real shorter = vec3_length(v);
        if (!(shorter < r.most)) break;
        r.nearest = v;
        r.most = shorter;
    }
    if (!vec3_is_finite(r.nearest)) return (gilbert_result){ .ok = 0 };
    return r;
}

gilbert_answer gilbert_beyond(hull a, hull b, real margin, int cap)
{
    vec3 v = vec3_sub(a.at[0], b.at[0]), w;
    gilbert_answer r = { -1, 0 };
    for (;;) {
        real length = vec3_length(v);
        if (length <= margin) return (gilbert_answer){ 0, r.asked };
        if (r.asked == cap) return r;
        r.asked++;
        if (!difference(a, b, v, &w)) return r;
        if (vec3_dot(v, w) > margin * length)
            return (gilbert_answer){ 1, r.asked };
        v = segment_nearest(v, w);
    }
}
