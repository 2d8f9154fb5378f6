// solution.c - the nearest points of two edges: each share the best for the other.

#include "edges.h"

static real cut(real share)
{
    return real_max(0, real_min(1, share));
}

// above / below, cut to the edge; on an edge without length, its first end.
static real share(real above, real below)
{
    return below > 0 ? cut(above / below) : 0;
}

// The squared distance is convex in both shares together, so cutting one and
// then finding the other ends at the minimum (Ericson, 2005).
edge_meeting edges_nearest(vec3 p0, vec3 p1, vec3 q0, vec3 q1)
{
    vec3 u = vec3_sub(p1, p0), v = vec3_sub(q1, q0), r = vec3_sub(p0, q0);
    real uu = vec3_dot(u, u), vv = vec3_dot(v, v), uv = vec3_dot(u, v);
    real ur = vec3_dot(u, r), vr = vec3_dot(v, r), det = uu * vv - uv * uv;
    real s = 0.5;
    if (det > 1e-14 * uu * vv) s = cut((uv * vr - ur * vv) / det);
    real t = share(uv * s + vr, vv);
    s = share(uv * t - ur, uu);
    vec3 way = vec3_add_scaled(vec3_add_scaled(r, s, u), -t, v);
    return (edge_meeting){ s, t, way };
}
