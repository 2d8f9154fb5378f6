// solution.c - no faster than way and spin together can bring it along n.

#include "turn.h"

#include <stddef.h>

// Rodrigues: what lies along the axis stays, what lies across turns.
//     r' = r cos + (axis x r) sin + axis (axis . r) (1 - cos)
void turning_at(const turning *b, real t, vec3 *at)
{
    real c = cos(t * b->angle), s = sin(t * b->angle);
    vec3 center = vec3_add_scaled(b->center, t, b->way);
    for (int i = 0; i < b->shape.count; i++) {
        vec3 r = vec3_sub(b->shape.at[i], b->center);
        real along = vec3_dot(b->axis, r) * (1 - c);
        vec3 turned = vec3_add_scaled(vec3_scale(c, r), s,
                                      vec3_cross(b->axis, r));
        at[i] = vec3_add(center, vec3_add_scaled(turned, along, b->axis));
    }
}

static real furthest(const turning *b)
{
    real most = 0;
    for (int i = 0; i < b->shape.count; i++)
        most = fmax(most, vec3_distance(b->shape.at[i], b->center));
    return most;
}

// m a frame, at most, at which a point of b goes along n, center apart: it goes
// at angle axis x r, and n . (axis x r) = r . (n x axis) <= |r| |n x axis|.
static real fastest_end(const turning *b, vec3 n, real reach)
{
    return fabs(b->angle) * reach * vec3_length(vec3_cross(n, b->axis));
}

// The plane between them has the distance d, and n stays.  Until time has gone
// on by d / closing nobody of A can have come through to B, wherever he turns.
turn_result turn_first_touch(const turning *a, const turning *b, real within,
                             int cap, vec3 *room)
{
    turn_result r = { .status = TURN_CAPPED };
    hull pa = a->shape, pb = b->shape;
    real reach_a = furthest(a), reach_b = furthest(b);
    vec3 way = vec3_sub(a->way, b->way);
    pa.at = room;
    pb.at = room + pa.count;
    while (r.looks < cap) {
        r.looks++;
        turning_at(a, r.time, room);
        turning_at(b, r.time, room + pa.count);
        gjk_result g = gjk_distance(pa, pb, HUGE_VAL, NULL);
        if (g.status == GJK_NOT_FINITE)
            return (turn_result){ .status = TURN_NOT_FINITE, .looks = r.looks };
        if (g.distance > 0) r.normal = vec3_unit(g.axis);
        if (g.distance <= within) {
            r.status = TURN_TOUCH;
            return r;
        }
        real closing = fastest_end(a, r.normal, reach_a)
                     + fastest_end(b, r.normal, reach_b)
                     - vec3_dot(way, r.normal);
        if (closing > 0) r.time += g.distance / closing;
        if (!(closing > 0) || r.time > 1)
            return (turn_result){ .status = TURN_NEVER, .looks = r.looks };
    }
    return r;
}
