//> gjk-support
// gjk.c - see gjk.h.
#include "gjk.h"
#include <assert.h>

// Number of the vertex furthest along d.  Heights are measured from the first
// vertex: far from the world's origin they would otherwise be all rounding.
static int furthest(hull h, vec3 d)
{
    int best = 0;
    real most = 0;
    for (int k = 1; k < h.count; k++) {
        real height = vec3_dot(d, vec3_sub(h.at[k], h.at[0]));
        if (height > most) most = height, best = k;
    }
    return best;
}

corner hull_support(hull a, hull b, vec3 d)
{
    int i = furthest(a, d), j = furthest(b, vec3_scale(-1, d));
    return (corner){ i, j, vec3_sub(a.at[i], b.at[j]) };
}
//<

//> gjk-normal
// The part of v along e.
static vec3 along(vec3 v, vec3 e)
{
    real ee = vec3_dot(e, e);
    return vec3_scale(ee > 0 ? vec3_dot(e, v) / ee : 0, e);
}

// Rounding tilts the cross product of nearly parallel edges.  Once it is again
// perpendicular to one of them, it is tilted only across, where all is thin.
vec3 triangle_normal(vec3 a, vec3 b, vec3 c)
{
    vec3 ab = vec3_sub(b, a), n = vec3_cross(ab, vec3_sub(c, a));
    return vec3_sub(n, along(n, ab));
}
//<

//> gjk-weigh
void triangle_weigh(vec3 n, vec3 a, vec3 b, vec3 c, real w[3])
{
    w[0] = vec3_dot(n, vec3_cross(b, vec3_sub(c, b)));
    w[1] = vec3_dot(n, vec3_cross(c, vec3_sub(a, c)));
    w[2] = vec3_dot(n, vec3_cross(a, vec3_sub(b, a)));
}

// Six times the volume between the origin and a triangle.
static real volume(vec3 a, vec3 b, vec3 c)
{
    return vec3_dot(a, triangle_normal(a, b, c));
}

// Fills in the barycentric coordinates of the origin's projection.  True if all
// are positive: it lies inside.  A flat simplex, where they cancel, gets zeros.
static bool weigh(simplex *s)
{
    vec3 a = s->of[0].at, b = s->of[1].at, c = s->of[2].at, d = s->of[3].at;
    real w[4] = { 1, 0, 0, 0 };
    if (s->count == 2)
        w[0] = vec3_dot(b, vec3_sub(b, a)), w[1] = vec3_dot(a, vec3_sub(a, b));
    if (s->count == 3) triangle_weigh(triangle_normal(a, b, c), a, b, c, w);
    if (s->count == 4)
        w[0] = volume(b, c, d), w[1] = volume(a, d, c),
        w[2] = volume(a, b, d), w[3] = volume(a, c, b);
    real sum = w[0] + w[1] + w[2] + w[3];
    bool inside = true;
    for (int k = 0; k < s->count; k++) {
        s->weight[k] = sum != 0 ? w[k] / sum : 0;
        inside = inside && s->weight[k] > 0;
    }
    return inside;
}
//<

//> gjk-point
// The point of these weights.  A short one is a small difference of long ones,
// tilted by rounding: so it is made perpendicular to the edge or the triangle.
static vec3 weighted_point(const simplex *s)
{
    const corner *c = s->of;
    vec3 v = { 0, 0, 0 };
    for (int k = 0; k < s->count && s->count < 4; k++)
        v = vec3_add_scaled(v, s->weight[k], c[k].at);
    if (s->count == 2)
        v = vec3_sub(v, along(v, vec3_sub(c[1].at, c[0].at)));
    if (s->count < 3) return v;
    return along(v, triangle_normal(c[0].at, c[1].at, c[2].at));
}
//<

//> gjk-nearest
// Keeps the part of s nearest the origin: all of s, if the origin projects
// inside; else part of a side, one opposite to a corner of weight <= 0.
static void nearest(simplex *s)
{
    if (weigh(s)) { s->v = weighted_point(s); return; }
    simplex best = { .count = 0 };
    for (int k = 0; k < s->count; k++) {
        if (s->weight[k] > 0) continue;
        simplex side = *s;
        side.of[k] = side.of[--side.count];
        nearest(&side);
        if (!best.count || vec3_dot(side.v, side.v) < vec3_dot(best.v, best.v))
            best = side;
    }
    *s = best;
}
//<

//> gjk-begin
// A NaN is not <= anything, either.
bool hull_in_range(hull h)
{
    real sum = 0;
    for (int k = 0; k < h.count; k++)
        sum += fabs(h.at[k].x) + fabs(h.at[k].y) + fabs(h.at[k].z);
    return sum <= 1e60;
}

static vec3 middle(hull h)
{
    vec3 sum = { 0, 0, 0 };
    for (int k = 0; k < h.count; k++) sum = vec3_add(sum, h.at[k]);
    return vec3_scale(1 / (real)h.count, sum);
}

// The carried simplex where it is now, or the corner between the two middles.
static void begin(simplex *s, hull a, hull b)
{
    for (int k = 0; k < s->count; k++)
        s->of[k].at = vec3_sub(a.at[s->of[k].a], b.at[s->of[k].b]);
    if (s->count == 0)
        s->of[s->count++] = hull_support(a, b, vec3_sub(middle(b), middle(a)));
    nearest(s);
}
//<

//> gjk-step
enum { CAP = 100, STALLS = 5 };      // iterations; those without a shorter v
static const real ENOUGH = 1e-13;    // relative error of the squared distance
static const real TOUCHING = 4e-24;  // of the squared size: too near to tell

// One iteration.  GJK_CAPPED: go on.
static gjk_status step(gjk_result *r, hull a, hull b, real margin, int *stalls)
{
    simplex *s = &r->last;
    real vv = vec3_dot(s->v, s->v);
    if (vv < 1e-120) return GJK_OVERLAP;
    corner w = hull_support(a, b, vec3_scale(-1, s->v));
    real bound = vec3_dot(s->v, w.at), size = vec3_dot(w.at, w.at);
    r->distance = bound / sqrt(vv);
    if (r->distance > margin) return GJK_BEYOND;
    r->distance = sqrt(vv);
    if (vv - bound <= ENOUGH * vv) return GJK_APART;
    bool held = false;
    for (int k = 0; k < s->count; k++) {
        held = held || (s->of[k].a == w.a && s->of[k].b == w.b);
        size = real_max(size, vec3_dot(s->of[k].at, s->of[k].at));
    }
    simplex next = *s;
    next.of[next.count++] = w;
    if (!held) nearest(&next);
    // A gain too small to be seen may be on the way to a large one.
    if (!held && (vec3_dot(next.v, next.v) < vv || ++*stalls < STALLS)) {
        *s = next;
        return GJK_CAPPED;
    }
    // Rounding allows no shorter v.  Only a bound > 0 proves them apart.
    return bound > 0 || vv > TOUCHING * size ? GJK_APART : GJK_OVERLAP;
}
//<

//> gjk-distance
gjk_result gjk_distance(hull a, hull b, real margin, simplex *carried)
{
    assert(a.count >= 1 && b.count >= 1 && margin >= 0);
    gjk_result r = { .status = GJK_CAPPED };
    if (!hull_in_range(a) || !hull_in_range(b))
        return (gjk_result){ .status = GJK_NOT_FINITE };
    if (carried) r.last = *carried;
    begin(&r.last, a, b);
    for (int stalls = 0; r.status == GJK_CAPPED && r.iterations < CAP;
         r.iterations++) r.status = step(&r, a, b, margin, &stalls);
    if (r.status == GJK_OVERLAP) r.distance = 0;
    for (int k = 0; k < r.last.count; k++)
        r.on_a = vec3_add_scaled(r.on_a, r.last.weight[k],
                                 a.at[r.last.of[k].a]);
    r.axis = r.last.v;
    r.on_b = vec3_sub(r.on_a, r.axis);
    if (carried) *carried = r.last;
    return r;
}
//<
