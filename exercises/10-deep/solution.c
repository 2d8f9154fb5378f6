// solution.c - GJK outside, the hit face inside, and a radius around both.

#include "deep.h"

#include <stddef.h>

// Where the cores are apart GJK says how far; where they are not the hit face
// says how deep, which is a distance below zero.  A radius adds to every height
// of A - B, so both are taken off.
deep_contact deep_contact_find(round_body a, round_body b)
{
    gjk_result g = gjk_distance(a.core, b.core, HUGE_VAL, NULL);
    if (g.status == GJK_NOT_FINITE) return (deep_contact){ .ok = 0 };

    deep_contact c = { 1, g.distance, vec3_unit(g.axis), g.on_a, g.on_b };
    if (g.status == GJK_OVERLAP) {
        hit_result h = hit_face_find(a.core, b.core, &g.last);
        if (h.status == HIT_NOT_FINITE) return (deep_contact){ .ok = 0 };
        c = (deep_contact){ 1, -h.depth, h.normal, h.on_a, h.on_b };
    }
    c.gap -= a.radius + b.radius;
    c.on_a = vec3_add_scaled(c.on_a, -a.radius, c.normal);
    c.on_b = vec3_add_scaled(c.on_b, b.radius, c.normal);
    return c;
}
