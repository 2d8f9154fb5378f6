//> rim-towards
//>   With the axis a and the part u of d across it, d = c u + s a. The point of the rim
//>   around the end e is p = e + r u, and p - (r / c) d = e - r (s / c) a lies on the
//>   axis: a ball of r / c around it touches the rim at p, and nothing of the cylinder
//>   is beyond.
#include "rim.h"
#include "capsule.h"
#include "cylinder.h"

#include <math.h>

static void make_core(const shape *s, real round, rim_core *r)
{
    r->core = (shape){ .kind = SHAPE_RIGID, .particles = 2,
                       .round = round, .radius = s->radius };
    r->core.mesh.half = r->half;
    r->core.mesh.vertex_half = r->first;
    capsule_join_core(&r->core.mesh);
}

bool rim_towards(const shape *s, const vec3 *at, vec3 d, rim_core *r)
{
    r->is_seen = r->is_flat = false;
    if (!(s->rim > 0)) return false;
    vec3 delta = vec3_sub(at[1], at[0]);
    real length = vec3_length(delta), along = vec3_dot(d, delta) / length;
    vec3 across = vec3_add_scaled(d, -along / length, delta);
    real c = vec3_length(across);
    if (!(c > LEAN_SINE)) return false;
    make_core(s, s->rim / c, r);
    for (int k = 0; k < 2; k++) {
        r->part[k] = k - s->rim * along / (c * length);
        r->at[k] = vec3_add_scaled(at[0], r->part[k], delta);
    }
    r->is_flat = fabs(along) <= LEAN_SINE;
    return r->is_seen = true;
}
//<

//> rim-furthest
//>   Of the core the furthest point towards d is one of its two ends. On the body it
//>   is a point of the axis.
feature_point rim_furthest(const rim_core *r, vec3 d)
{
    int end = vec3_dot(vec3_sub(r->at[1], r->at[0]), d) > 0;
    return (feature_point){ 1, { end }, { 1 } };
}

feature_point rim_feature(const rim_core *r, const feature_point *on_core)
{
    real part = 0;
    if (!r->is_seen) return *on_core;
    for (int k = 0; k < on_core->count; k++)
        part += on_core->weight[k] * r->part[on_core->vertex[k]];
    return (feature_point){ 2, { 0, 1 }, { 1 - part, part } };
}

// Halfway between two corners of the rim: 1 - cos x is at most x^2 / 2.
real rim_sag(const shape *s)
{
    const real x = 3.141592653589793 / CYLINDER_SIDES;
    return x * x / 2 * s->rim;
}
//<
