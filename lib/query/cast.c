//> cast
//>   The only thing that `swept` does not say is where the surface is. The
//>   nearest point of B lies on its hull, and the surface lies further out
//>   along the normal, by B's radius.
#include "cast.h"
#include "hit_face.h"

#include <math.h>
#include <stddef.h>

static vec3 unit(vec3 v)
{
    real length = vec3_length(v);
    return length > 0 ? vec3_scale(1 / length, v) : (vec3){ 0, 0, 0 };
}

// The largest distance (m) of a point of it from its first one.
static real rounded_size(rounded r)
{
    real most = 0;
    for (int k = 1; k < r.core.count; k++) {
        vec3 d = vec3_sub(r.core.at[k], r.core.at[0]);
        most = real_max(most, vec3_length(d));
    }
    return most + r.round;
}

sphere rounded_ball(rounded r)
{
    sphere s = { { 0, 0, 0 }, 0 };
    real most = 0;
    for (int k = 0; k < r.core.count; k++)
        s.center = vec3_add_scaled(s.center, 1.0 / r.core.count, r.core.at[k]);
    for (int k = 0; k < r.core.count; k++)
        most = real_max(vec3_length_squared(vec3_sub(r.core.at[k], s.center)), most);
    s.radius = sqrt(most) + r.round;
    return s;
}

static cast_result met(const swept_result *s, rounded a, vec3 delta, rounded b)
{
    if (s->status == SWEPT_OVERLAP)
        return (cast_result){ true, 0, a.core.at[0],
                              unit(vec3_scale(-1, delta)) };
    if (s->status == SWEPT_PASSES || s->status == SWEPT_NOT_FINITE)
        return (cast_result){ .hits = false };
    vec3 surface = vec3_add_scaled(s->on_b, b.round, s->normal);
    return (cast_result){ true, s->time, surface, s->normal };
}

//<

//> cast-cylinder
//>   A point meets a cylinder where it is inside of all that bounds it: the planes of
//>   its two ends, and the round side.
typedef struct {
    vec3 axis;          // unit
    real length;        // m
    real up;            // m, of a point along it, from the lower end
    vec3 off;           // m, of it across the axis
} axial;

static axial axial_of(rounded c, vec3 x)
{
    vec3 delta = vec3_sub(c.core.at[1], c.core.at[0]);
    real length = vec3_length(delta);
    vec3 axis = vec3_scale(1 / length, delta), d = vec3_sub(x, c.core.at[0]);
    real up = vec3_dot(d, axis);
    return (axial){ axis, length, up, vec3_add_scaled(d, -up, axis) };
}

// The part of the way inside, 0 to 1 of all of it, and where it comes in.
typedef struct {
    real from, to;
    vec3 normal;
} passage;

static void clip_entry(passage *p, real from, real to, vec3 normal)
{
    if (from > p->from) p->from = from, p->normal = normal;
    p->to = real_min(p->to, to);
}

static void pass_ends(passage *p, const axial *at, real speed)
{
    vec3 down = vec3_scale(-1, at->axis);
    real low = -at->up / speed, high = (at->length - at->up) / speed;
    if (speed > 0)      clip_entry(p, low, high, down);
    else if (speed < 0) clip_entry(p, high, low, at->axis);
    else if (!(at->up >= 0 && at->up <= at->length)) p->to = -1;
}

// |off + t v| = r, of which the two solutions have the product c / a.
static void pass_side(passage *p, const axial *at, vec3 v, real radius)
{
    real a = vec3_length_squared(v), b = vec3_dot(at->off, v);
    real c = vec3_length_squared(at->off) - radius * radius;
    real left = b * b - a * c;
    if (!(a > 0)) {
        if (c > 0) p->to = -1;
        return;
    }
    if (!(left >= 0)) {
        p->to = -1;
        return;
    }
    real root = b > 0 ? -b - sqrt(left) : -b + sqrt(left);
    real one = root / a, other = root != 0 ? c / root : 0;
    real from = real_min(one, other), to = real_max(one, other);
    clip_entry(p, from, to, unit(vec3_add_scaled(at->off, from, v)));
}

static cast_result ray_cylinder(vec3 from, vec3 delta, rounded c)
{
    axial at = axial_of(c, from);
    real speed = vec3_dot(delta, at.axis);
    passage p = { -HUGE_VAL, HUGE_VAL, { 0, 0, 0 } };
    pass_ends(&p, &at, speed);
    pass_side(&p, &at, vec3_add_scaled(delta, -speed, at.axis), c.rim);
    if (!(p.from <= p.to && p.to >= 0 && p.from <= 1))
        return (cast_result){ .hits = false };
    if (p.from <= 0)
        return (cast_result){ true, 0, from, unit(vec3_scale(-1, delta)) };
    return (cast_result){ true, p.from, vec3_add_scaled(from, p.from, delta),
                          p.normal };
}

static cast_result nearest_cylinder(vec3 x, rounded c, real most)
{
    axial at = axial_of(c, x);
    real out = vec3_length(at.off);
    real up = real_max(0, real_min(at.up, at.length));
    vec3 near = vec3_add_scaled(c.core.at[0], up, at.axis);
    real in = out > c.rim ? c.rim / out : 1;
    near = vec3_add_scaled(near, in, at.off);
    vec3 d = vec3_sub(x, near);
    real away = in == 1 && up == at.up ? 0 : vec3_length(d);
    if (!(away <= most)) return (cast_result){ .hits = false };
    if (away == 0) return (cast_result){ true, 0, x, { 0, 0, 0 } };
    return (cast_result){ true, away, near, vec3_scale(1 / away, d) };
}
//<

//> cast-straight
//>   All else is asked of hulls and their radii.
static bool is_point(rounded a)
{
    return a.core.count == 1 && a.round == 0;
}

cast_result cast_first(rounded a, vec3 delta, rounded b, vec3 *scratch)
{
    if (b.rim > 0 && is_point(a)) return ray_cylinder(a.core.at[0], delta, b);
    real apart = a.round + b.round;
    real fine = 1e-12 * (vec3_length(delta) + rounded_size(a) + rounded_size(b));
    swept_result s = { .status = SWEPT_NOT_FINITE };
    if (fine > 0)
        s = swept_first_touch(a.core, delta, b.core, apart, fine, scratch);
    return met(&s, a, delta, b);
}

cast_result cast_turning(rounded a, const swept_motion *m, rounded b,
                         vec3 *scratch)
{
    const swept_motion stays = { .out = 0 };
    real fine = 1e-6 * (vec3_length(m->delta) + m->out + a.round);
    swept_result s = swept_turning(a.core, m, b.core, &stays,
                                   a.round + b.round, fine, scratch);
    return met(&s, a, m->delta, b);
}
//<

//> cast-plane
//>   A plane needs no search: the lowest point of the body meets it first.
cast_result cast_first_plane(rounded a, vec3 delta, plane p)
{
    real lowest = HUGE_VAL, down = -vec3_dot(delta, p.normal);
    vec3 at = a.core.at[0];
    for (int k = 0; k < a.core.count; k++) {
        real height = vec3_dot(a.core.at[k], p.normal) - p.offset - a.round;
        if (!(height < lowest)) continue;
        lowest = height;
        at = a.core.at[k];
    }
    if (lowest <= 0)
        return (cast_result){ true, 0, at, unit(vec3_scale(-1, delta)) };
    if (!(lowest <= down)) return (cast_result){ .hits = false };
    real time = lowest / down;
    vec3 there = vec3_add_scaled(at, time, delta);
    return (cast_result){ true, time,
                          vec3_add_scaled(there, -a.round, p.normal),
                          p.normal };
}
//<

//> cast-near
//>   What is near a point, and what overlaps a shape.
cast_result cast_nearest(vec3 x, rounded b, real most)
{
    if (b.rim > 0) return nearest_cylinder(x, b, most);
    gjk_result g = gjk_distance((hull){ &x, 1 }, b.core, HUGE_VAL, NULL);
    real away = g.distance - b.round;
    bool is_apart = g.status == GJK_APART || g.status == GJK_CAPPED;
    if (g.status == GJK_OVERLAP || (is_apart && away <= 0))
        return (cast_result){ true, 0, x, { 0, 0, 0 } };
    if (!is_apart || !(away <= most)) return (cast_result){ .hits = false };
    vec3 out = unit(g.axis);
    return (cast_result){ true, away, vec3_add_scaled(g.on_b, b.round, out),
                          out };
}

cast_result cast_nearest_plane(vec3 x, plane p, real most)
{
    real away = vec3_dot(x, p.normal) - p.offset;
    if (!(away <= most)) return (cast_result){ .hits = false };
    if (away <= 0) return (cast_result){ true, 0, x, { 0, 0, 0 } };
    return (cast_result){ true, away, vec3_add_scaled(x, -away, p.normal),
                          p.normal };
}

bool cast_overlaps(rounded a, rounded b)
{
    real apart = a.round + b.round;
    separating_axis none = { .a = -1 };
    if (!(apart >= 0) || !hull_in_range(a.core) || !hull_in_range(b.core))
        return false;
    hull_mesh in_a = hull_bare(a.core), in_b = hull_bare(b.core);
    return !search_apart(&in_a, &in_b, apart, &none);
}
//<

//> cast-gap
//>   And how far two are apart, or how deep one is in the other.
static cast_result gap_of_hulls(rounded a, rounded b)
{
    gjk_result g = gjk_distance(a.core, b.core, HUGE_VAL, NULL);
    if (g.status == GJK_NOT_FINITE) return (cast_result){ .hits = false };
    if (g.status != GJK_OVERLAP)
        return (cast_result){ true, g.distance, g.on_b, unit(g.axis) };
    hit_result h = hit_face_find(a.core, b.core, &g.last);
    if (h.status == HIT_NOT_FINITE) return (cast_result){ .hits = false };
    return (cast_result){ true, -h.depth, h.on_b, h.normal };
}

cast_result cast_gap(rounded a, rounded b)
{
    cast_result r = gap_of_hulls(a, b);
    r.fraction -= a.round + b.round;
    r.point = vec3_add_scaled(r.point, b.round, r.normal);
    return r;
}

cast_result cast_gap_plane(rounded a, plane p)
{
    real lowest = HUGE_VAL;
    vec3 at = a.core.at[0];
    for (int k = 0; k < a.core.count; k++) {
        real height = vec3_dot(a.core.at[k], p.normal) - p.offset;
        if (height < lowest) at = a.core.at[k];
        lowest = real_min(lowest, height);
    }
    return (cast_result){ lowest < HUGE_VAL, lowest - a.round,
                          vec3_add_scaled(at, -lowest, p.normal), p.normal };
}
//<
