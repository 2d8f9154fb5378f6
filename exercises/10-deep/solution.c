// solution.c - GJK outside, the hit face inside, and a radius around both.

#include "deep.h"

#include <stddef.h>

// Where the cores are apart GJK says how far; where they are not the hit face
// says how deep, which is a distance below zero.  A radius adds to every height
// of A - B, so both are taken off.
deep_contact deep_contact_find(round_body a, round_body b,
                               penetration_scratch *scratch)
{
    distance_result g = distance_find(a.core, b.core, distance_options_default(), NULL);
    if (g.status == DISTANCE_NOT_FINITE) return (deep_contact){ .ok = 0 };

    deep_contact c = { 1, g.distance, vec3_unit(g.axis), g.on_a, g.on_b };
    if (g.status == DISTANCE_OVERLAP) {
        penetration_result h = penetration_find(a.core, b.core, &g.last, scratch);
        if (h.status == PENETRATION_NOT_FINITE) return (deep_contact){ .ok = 0 };
        c = (deep_contact){ 1, -h.depth, h.normal, h.on_a, h.on_b };
    }
    c.gap -= a.radius + b.radius;
    c.on_a = vec3_add_scaled(c.on_a, -a.radius, c.normal);
    c.on_b = vec3_add_scaled(c.on_b, b.radius, c.normal);
    return c;
}
