// solution.c - as far as the plane between them allows, again and again.

#include "when.h"

#include <stddef.h>

// A where it is at time t, seen from B.
static hull advanced(hull a, vec3 velocity, real t, vec3 *room)
{
    for (int i = 0; i < a.count; i++)
        room[i] = vec3_add_scaled(a.at[i], t, velocity);
    a.at = room;
    return a;
}

when_result when_meet(moving a, moving b, real horizon, real within, int cap,
                      vec3 *room)
{
    vec3 u = vec3_sub(a.velocity, b.velocity);
    when_result r = { .status = WHEN_CAPPED };
    while (r.looks < cap) {
        r.looks++;
        gjk_result g = gjk_distance(advanced(a.shape, u, r.time, room),
                                    b.shape, HUGE_VAL, NULL);
        if (g.status == GJK_NOT_FINITE)
            return (when_result){ .status = WHEN_NOT_FINITE, .looks = r.looks };
        if (g.distance > 0) r.normal = vec3_unit(g.axis);
        if (g.distance <= within) {
            r.status = WHEN_MEET;
            return r;
        }

        // The plane parts them for as long as they do not close along it.
        real closing = -vec3_dot(u, r.normal);
        if (closing > 0) r.time += g.distance / closing;
        if (!(closing > 0) || r.time > horizon)
            return (when_result){ .status = WHEN_NEVER, .looks = r.looks };
    }
    return r;
}
