// solution.c - a radius around what GJK can do already.

#include "round.h"

#include <stddef.h>

// The core's furthest vertex, and from there the radius on.
vec3 round_support(round_body r, vec3 d)
{
    vec3 origin = { 0, 0, 0 };
    corner c = hull_support(r.core, (hull){ &origin, 1 }, d);
    return vec3_add_scaled(c.at, r.radius, vec3_unit(d));
}

// Two surfaces are nearer than their cores by both radii, along the same line.
round_result round_distance(round_body a, round_body b)
{
    gjk_result core = gjk_distance(a.core, b.core, HUGE_VAL, NULL);
    round_result r = { .status = core.status };
    if (core.status == GJK_NOT_FINITE) return r;

    r.gap = core.distance - (a.radius + b.radius);
    // Zero where the cores overlap: GJK's axis is zero there.
    r.normal = vec3_unit(core.axis);
    r.on_a = vec3_add_scaled(core.on_a, -a.radius, r.normal);
    r.on_b = vec3_add_scaled(core.on_b, b.radius, r.normal);
    return r;
}
