// fuzz_gjk.c - gjk_distance on two bodies made from bytes.  See fuzz.h.

#include "sets.h"

typedef long double wide;

// Of the reach of A - B: what a distance may be off.
static const wide rounding = 1e-12L;

static wide length(wide x, wide y, wide z)
{
    return sqrtl(x * x + y * y + z * z);
}

static void check_simplex(const sets *s, const simplex *last)
{
    real sum = 0;
    MUST(last->count >= 1 && last->count <= 4, "%d corners", last->count);
    for (int c = 0; c < last->count; c++) {
        int a = last->of[c].a, b = last->of[c].b;
        MUST(a >= 0 && a < s->a.count, "a %d", a);
        MUST(b >= 0 && b < s->b.count, "b %d", b);
        MUST(last->weight[c] >= 0, "weight %g", last->weight[c]);
        sum += last->weight[c];
    }
    MUST(fabs(sum - 1) <= 1e-14, "weights add up to %.17g", sum);
}

// All that an answer says of itself, whatever the bodies.
static void check_form(const sets *s, gjk_result r)
{
    MUST(r.status >= GJK_APART && r.status <= GJK_CAPPED, "%d", r.status);
    MUST(r.iterations >= 0 && r.iterations <= 100, "%d", r.iterations);
    MUST(is_number(r.distance) && r.distance >= 0, "%g", r.distance);
    MUST(vec3_is_finite(r.axis), "axis");
    MUST(vec3_is_finite(r.on_a) && vec3_is_finite(r.on_b), "witness points");
    if (r.status != GJK_NOT_FINITE) check_simplex(s, &r.last);
    else MUST(r.last.count == 0, "%d corners of nothing", r.last.count);
}

// A search ends when rounding leaves nothing to gain in |v|^2: a v turned by t
// is only t^2 / 2 too long, so that t may be the root of what rounding is.
static const wide turned = 1e-7L;

// No point of A - B is nearer than the plane that the axis stands on.
static void check_bound(const sets *s, gjk_result r)
{
    wide least = (wide)r.distance - turned * s->reach;
    wide d = -oracle_width(body_hull(&s->b), body_hull(&s->a), r.axis);
    MUST(d >= least, "a point at %.20Lg is nearer than %.20g", d, r.distance);
}

// The witness points are of the bodies, and as far apart as the distance says.
static void check_witness(const sets *s, gjk_result r)
{
    wide off = rounding * s->reach + 1e-15L * s->place;
    wide gap = length((wide)r.on_a.x - (wide)r.on_b.x,
                      (wide)r.on_a.y - (wide)r.on_b.y,
                      (wide)r.on_a.z - (wide)r.on_b.z);
    MUST(fabsl(gap - (wide)r.distance) <= 4 * off,
         "gap %Lg, distance %g", gap, r.distance);
    MUST(set_may_hold(&s->a, r.on_a, off), "on_a is not on A");
    MUST(set_may_hold(&s->b, r.on_b, off), "on_b is not on B");
}

// All but a line: its least height is next to nothing beside its longest side.
// (A real line is none: its points tell GJK nothing that is wrong.)
static int is_thin(vec3 a, vec3 b, vec3 c)
{
    vec3 e = vec3_sub(b, a), f = vec3_sub(c, a);
    real side = fmax(vec3_distance(b, c),
                     fmax(vec3_length(e), vec3_length(f)));
    vec3 n = vec3_cross(vec3_scale(1 / side, e), vec3_scale(1 / side, f));
    real height = vec3_length(n);
    return height > 0 && height <= 1e-4;
}

// Has the body such a triangle, or two points that only rounding tells apart?
// Then so has A - B.  (A ball, which the bytes may flatten, has too many to be
// asked.)
static int has_thin(const sets *s, const body *b)
{
    if (b->count > 12) return 1;
    for (int i = 0; i < b->count; i++)
        for (int j = i + 1; j < b->count; j++) {
            wide apart = (wide)vec3_distance(b->at[i], b->at[j]);
            if (apart > 0 && apart <= rounding * s->reach) return 1;
            for (int k = j + 1; k < b->count; k++)
                if (is_thin(b->at[i], b->at[j], b->at[k])) return 1;
        }
    return 0;
}

// Of few points, the slow answer is quick to have.
static void check_oracle(const sets *s, gjk_result r)
{
    if (s->a.count > 5 || s->b.count > 5) return;
    wide exact = oracle_distance(body_hull(&s->a), body_hull(&s->b));
    MUST((wide)r.distance <= exact + rounding * s->reach,
         "distance %.17g, exactly %.20Lg", r.distance, exact);
}

static void check_answer(const sets *s, gjk_result r, real margin)
{
    check_form(s, r);
    if (!s->fair) return;
    MUST(r.status != GJK_NOT_FINITE, "every coordinate is finite");
    MUST(r.status != GJK_CAPPED, "%d iterations", r.iterations);
    if (r.status == GJK_OVERLAP) MUST(r.distance <= 0, "%g", r.distance);
    if (r.status == GJK_APART || r.status == GJK_BEYOND) check_bound(s, r);
    // In a sliver neither the weights nor the oracle's plane is sure.
    if (r.status == GJK_APART && !has_thin(s, &s->a) && !has_thin(s, &s->b)) {
        check_witness(s, r);
        check_oracle(s, r);
    }
    if (r.status == GJK_BEYOND)
        MUST((wide)r.distance
             >= (wide)margin * (1 - rounding) - rounding * s->reach,
             "%g is within %g", r.distance, margin);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static sets s;
    bytes in = { .at = data, .left = size };
    real margin = take_byte(&in) & 1 ? fabs(take_real(&in)) : HUGE_VAL;
    if (!(margin >= 0)) margin = 0;
    sets_take(&s, &in);

    // From nothing, and from any corners.
    simplex carried = { .count = take_count(&in, 0, 4) };
    for (int c = 0; c < carried.count; c++) {
        carried.of[c].a = take_byte(&in) % s.a.count;
        carried.of[c].b = take_byte(&in) % s.b.count;
    }
    hull a = body_hull(&s.a), b = body_hull(&s.b);
    check_answer(&s, gjk_distance(a, b, margin, NULL), margin);
    check_answer(&s, gjk_distance(a, b, margin, &carried), margin);
    return 0;
}
