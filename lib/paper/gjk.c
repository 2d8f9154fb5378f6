//> gjk-support
// gjk.c - see gjk.h.
#include "gjk.h"
#include "wide.h"
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

// Of the search so far: iterations without gain, and what a shorter v . v cannot
// be less than.
typedef struct { int stalls; real bound; } progress;

// One iteration.  GJK_CAPPED: go on.
static gjk_status step(gjk_result *r, hull a, hull b, real margin, progress *p)
{
    simplex *s = &r->last;
    real vv = vec3_dot(s->v, s->v);
    p->bound = vv;
    if (vv < 1e-120) return GJK_OVERLAP;
    corner w = hull_support(a, b, vec3_scale(-1, s->v));
    p->bound = vec3_dot(s->v, w.at);
    r->distance = p->bound / sqrt(vv);
    if (r->distance > margin) return GJK_BEYOND;
    r->distance = sqrt(vv);
    if (vv - p->bound <= ENOUGH * vv) return GJK_APART;
    bool held = false;
    for (int k = 0; k < s->count; k++)
        held = held || (s->of[k].a == w.a && s->of[k].b == w.b);
    simplex next = *s;
    next.of[next.count++] = w;
    if (!held) nearest(&next);
    // A gain too small to be seen may be on the way to a large one.
    if (!held && (vec3_dot(next.v, next.v) < vv || ++p->stalls < STALLS)) {
        *s = next;
        return GJK_CAPPED;
    }
    // Rounding allows no shorter v.  Only a bound > 0 proves them apart.
    return p->bound > 0 ? GJK_APART : GJK_OVERLAP;
}
//<

//> gjk-certain
static const real SURE = 4e-15;      // of the size: rounding errors

// Is the answer proven?  The weights must give v, and a plane must part the
// bodies by as much as v is long; both but for rounding.
static bool is_certain(const simplex *s, real bound)
{
    vec3 off = vec3_scale(-1, s->v);
    real size = 0, vv = vec3_dot(s->v, s->v), more = vv - bound;
    for (int k = 0; k < s->count; k++) {
        off = vec3_add_scaled(off, s->weight[k], s->of[k].at);
        size = real_max(size, vec3_dot(s->of[k].at, s->of[k].at));
    }
    return vec3_dot(off, off) <= SURE * SURE * size
        && (more <= ENOUGH * vv || more * more <= SURE * SURE * vv * size);
}
//<

//> gjk-wide
// A simplex in numbers of 106 bits.
typedef struct {
    int    count;
    corner of[4];
    wide3  at[4], v;
    wide   weight[4], vv;       // vv: v . v
} wide_simplex;

static wide3 wide_normal(const wide3 *c)
{
    return wide3_cross(wide3_sub(c[1], c[0]), wide3_sub(c[2], c[0]));
}

// The weight of corner k, but for a factor that all of them share.
static wide wide_weight(const wide_simplex *s, int k)
{
    const wide3 *at = s->at;
    if (s->count == 1) return (wide){ 1, 0 };
    wide3 p = at[(k + 1) % s->count], q = at[(k + 2) % s->count];
    if (s->count == 2) return wide3_dot(p, wide3_sub(p, at[k]));
    if (s->count == 3)
        return wide3_dot(wide_normal(at), wide3_cross(p, wide3_sub(q, p)));
    wide3 side[3] = { p, q, at[(k + 3) % 4] };
    wide volume = wide3_dot(p, wide_normal(side));
    return k % 2 ? wide_negative(volume) : volume;
}

// Are all weights positive, and not the rounding errors of a flat simplex?
static bool weigh_wide(wide_simplex *s)
{
    wide sum = { 0, 0 };
    real square = 0;
    bool inside = true;
    for (int k = 0; k < s->count; k++) {
        sum = wide_add(sum, s->weight[k] = wide_weight(s, k));
        vec3 c = wide3_rounded(s->at[k]);
        square = real_max(square, vec3_dot(c, c));
    }
    if (s->count == 4 && !(fabs(sum.high) > 1e-26 * square * sqrt(square)))
        return false;
    for (int k = 0; k < s->count; k++) {
        if (sum.high != 0) s->weight[k] = wide_over(s->weight[k], sum);
        inside = inside && sum.high != 0 && s->weight[k].high > 0;
    }
    return inside;
}

static wide3 wide_point(const wide_simplex *s)
{
    wide3 v = { { 0, 0 }, { 0, 0 }, { 0, 0 } }, n = wide_normal(s->at);
    if (s->count == 4) return v;
    if (s->count == 3)
        return wide3_scale(wide_over(wide3_dot(n, s->at[0]), wide3_dot(n, n)),
                           n);
    for (int k = 0; k < s->count; k++)
        v = wide3_add(v, wide3_scale(s->weight[k], s->at[k]));
    return v;
}

// As nearest; but all sides are tried.
static void nearest_wide(wide_simplex *s)
{
    if (weigh_wide(s)) {
        s->v = wide_point(s), s->vv = wide3_dot(s->v, s->v);
        return;
    }
    wide_simplex best = { .count = 0 };
    for (int k = 0; k < s->count && s->count > 1; k++) {
        wide_simplex side = *s;
        side.count--;
        side.of[k] = side.of[side.count], side.at[k] = side.at[side.count];
        nearest_wide(&side);
        if (!best.count || wide_less(side.vv, best.vv)) best = side;
    }
    *s = best;
}

static void join_wide(wide_simplex *s, hull a, hull b, int i, int j)
{
    s->of[s->count] = (corner){ i, j, vec3_sub(a.at[i], b.at[j]) };
    s->at[s->count++] = wide3_between(a.at[i], b.at[j]);
}

vec3 triangle_nearest_wide(simplex *s, hull a, hull b)
{
    wide_simplex w = { .count = 0 };
    for (int k = 0; k < 3; k++) join_wide(&w, a, b, s->of[k].a, s->of[k].b);
    vec3 normal = wide3_rounded(wide_normal(w.at));
    nearest_wide(&w);
    s->v = wide3_rounded(w.v);
    for (int k = 0; k < 3; k++) {
        s->weight[k] = 0;
        for (int i = 0; i < w.count; i++)
            if (w.of[i].a == s->of[k].a && w.of[i].b == s->of[k].b)
                s->weight[k] = w.weight[i].high;
    }
    return normal;
}

static int furthest_wide(hull h, wide3 d)
{
    int best = 0;
    wide most = { 0, 0 };
    for (int k = 1; k < h.count; k++) {
        wide height = wide3_dot(d, wide3_between(h.at[k], h.at[0]));
        if (wide_less(most, height)) most = height, best = k;
    }
    return best;
}

// One iteration.  GJK_CAPPED: go on.
static gjk_status step_wide(wide_simplex *s, hull a, hull b)
{
    if (s->count == 4 || !(s->vv.high > 0)) return GJK_OVERLAP;
    wide3 none = { { 0, 0 }, { 0, 0 }, { 0, 0 } }, back = wide3_sub(none, s->v);
    wide_simplex next = *s;
    join_wide(&next, a, b, furthest_wide(a, back), furthest_wide(b, s->v));
    wide bound = wide3_dot(s->v, next.at[s->count]);
    wide more = wide_add(s->vv, wide_negative(bound));
    gjk_status last = bound.high > 0 ? GJK_APART : GJK_OVERLAP;
    if (more.high <= 1e-20 * s->vv.high) return last;
    nearest_wide(&next);
    if (!wide_less(next.vv, s->vv)) return last;
    *s = next;
    return GJK_CAPPED;
}

// Goes on in 106 bits from where rounding ended the search.
static gjk_status search_wide(gjk_result *r, hull a, hull b)
{
    wide_simplex s = { .count = 0 };
    gjk_status status = GJK_CAPPED;
    for (int k = 0; k < r->last.count; k++)
        join_wide(&s, a, b, r->last.of[k].a, r->last.of[k].b);
    nearest_wide(&s);
    for (int k = 0; k < CAP && status == GJK_CAPPED; k++)
        status = step_wide(&s, a, b);
    r->last = (simplex){ .count = s.count, .v = wide3_rounded(s.v) };
    for (int k = 0; k < s.count; k++)
        r->last.of[k] = s.of[k], r->last.weight[k] = s.weight[k].high;
    r->distance = vec3_length(r->last.v), r->wide = true;
    return status;
}
//<

//> gjk-distance
gjk_result gjk_search(hull a, hull b, real margin, simplex *carried)
{
    assert(a.count >= 1 && b.count >= 1 && margin >= 0);
    gjk_result r = { .status = GJK_CAPPED };
    if (carried) r.last = *carried;
    begin(&r.last, a, b);
    progress p = { 0, 0 };
    for (; r.status == GJK_CAPPED && r.iterations < CAP; r.iterations++)
        r.status = step(&r, a, b, margin, &p);
    if (r.status != GJK_BEYOND && !is_certain(&r.last, p.bound))
        r.status = search_wide(&r, a, b);
    if (r.status == GJK_OVERLAP) r.distance = 0;
    for (int k = 0; k < r.last.count; k++)
        r.on_a = vec3_add_scaled(r.on_a, r.last.weight[k],
                                 a.at[r.last.of[k].a]);
    r.axis = r.last.v;
    r.on_b = vec3_sub(r.on_a, r.axis);
    if (carried) *carried = r.last;
    return r;
}

gjk_result gjk_distance(hull a, hull b, real margin, simplex *carried)
{
    if (!hull_in_range(a) || !hull_in_range(b))
        return (gjk_result){ .status = GJK_NOT_FINITE };
    return gjk_search(a, b, margin, carried);
}
//<
