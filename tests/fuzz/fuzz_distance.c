// fuzz_distance.c - distance_find on two bodies made from bytes.  See fuzz.h.

#include "points.h"
#include "sets.h"

typedef long double wide;

// Of the reach of A - B: what a distance may be off.
static const wide rounding = 1e-12L;

static wide length(wide x, wide y, wide z)
{
    return sqrtl(x * x + y * y + z * z);
}

static void check_simplex(const sets *s, const distance_cache *last)
{
    real sum = 0;
    MUST(last->count >= 1 && last->count <= 4, "%d corners", last->count);
    for (int c = 0; c < last->count; c++) {
        MUST(last->a[c] >= 0 && last->a[c] < s->a.count, "a %d", last->a[c]);
        MUST(last->b[c] >= 0 && last->b[c] < s->b.count, "b %d", last->b[c]);
        MUST(last->weight[c] >= 0, "weight %g", last->weight[c]);
        sum += last->weight[c];
    }
    MUST(fabs(sum - 1) <= 1e-14, "weights add up to %.17g", sum);
}

// All that an answer says of itself, whatever the bodies.
static void check_form(const sets *s, distance_result r, int cap)
{
    MUST(r.status >= DISTANCE_APART && r.status <= DISTANCE_CAPPED, "%d", r.status);
    MUST(r.iterations >= 0 && r.iterations <= cap, "%d", r.iterations);
    MUST(is_number(r.distance) && r.distance >= 0, "%g", r.distance);
    MUST(vec3_is_finite(r.axis), "axis");
    MUST(vec3_is_finite(r.on_a) && vec3_is_finite(r.on_b), "witness points");
    if (r.status != DISTANCE_NOT_FINITE) check_simplex(s, &r.last);
    else MUST(r.last.count == 0, "%d corners of nothing", r.last.count);
}

// A search ends when rounding leaves nothing to gain in |v|^2: a v turned by t
// is only t^2 / 2 too long, so that t may be the root of what rounding is.
static const wide turned = 1e-7L;

// No point of A - B is nearer than the plane that the axis stands on.
static void check_bound(const sets *s, distance_result r, real error)
{
    wide least = (wide)r.distance * (1 - (wide)error) - turned * s->reach;
    wide d = -oracle_width(body_hull(&s->b), body_hull(&s->a), r.axis);
    MUST(d >= least, "a point at %.20Lg is nearer than %.20g", d, r.distance);
}

// The witness points are of the bodies and, unless these overlap, as far apart
// as the distance says.
static void check_witness(const sets *s, distance_result r)
{
    wide off = rounding * s->reach + 1e-15L * s->place;
    wide gap = length((wide)r.on_a.x - (wide)r.on_b.x,
                      (wide)r.on_a.y - (wide)r.on_b.y,
                      (wide)r.on_a.z - (wide)r.on_b.z);
    MUST(r.status == DISTANCE_OVERLAP || fabsl(gap - (wide)r.distance) <= 4 * off,
         "gap %Lg, distance %g", gap, r.distance);
    MUST(set_may_hold(&s->a, r.on_a, off), "on_a is not on A");
    MUST(set_may_hold(&s->b, r.on_b, off), "on_b is not on B");
}

// In a triangle that is all but a line the oracle's plane is rounding.
static int has_thin(const body *b)
{
    for (int i = 0; i < b->count; i++)
        for (int j = i + 1; j < b->count; j++)
            for (int k = j + 1; k < b->count; k++) {
                vec3 e = vec3_unit(vec3_sub(b->at[j], b->at[i]));
                vec3 f = vec3_unit(vec3_sub(b->at[k], b->at[i]));
                real sine = vec3_length(vec3_cross(e, f));
                if (!(sine > 1e-4) && sine > 0) return 1;
            }
    return 0;
}

// Of few points, the slow answer is quick to have.
static void check_oracle(const sets *s, distance_result r, real error)
{
    if (s->a.count > 5 || s->b.count > 5) return;
    if (has_thin(&s->a) || has_thin(&s->b)) return;
    wide exact = oracle_distance(body_hull(&s->a), body_hull(&s->b));
    MUST((wide)r.distance * (1 - (wide)error) <= exact + rounding * s->reach,
         "distance %.17g, exactly %.20Lg", r.distance, exact);
}

static void check_answer(const sets *s, distance_result r, distance_options o)
{
    check_form(s, r, o.cap);
    if (!s->finite) return;
    if (!s->fair) return;
    MUST(r.status != DISTANCE_NOT_FINITE, "every coordinate is finite");
    MUST(r.status != DISTANCE_CAPPED || (r.iterations == o.cap && o.cap < 64),
         "64 is said to be never reached");
    if (r.status == DISTANCE_OVERLAP) MUST(r.distance <= 0, "%g", r.distance);
    if (r.status != DISTANCE_BEYOND) check_witness(s, r);
    if (r.status == DISTANCE_APART) check_bound(s, r, o.relative_error);
    if (r.status == DISTANCE_APART) check_oracle(s, r, o.relative_error);
    if (r.status == DISTANCE_BEYOND) {
        check_bound(s, r, 0);
        MUST((wide)r.distance
             >= (wide)o.margin * (1 - rounding) - rounding * s->reach,
             "%g is within %g", r.distance, o.margin);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static sets s;
    bytes in = { .at = data, .left = size };
    int how = take_byte(&in);
    distance_options o = distance_options_default();
    if (how & 1) o.relative_error = take_count(&in, 0, 99) / 100.0;
    if (how & 2) o.margin = fabs(take_real(&in));
    if (how & 4) o.cap = take_count(&in, 1, 64);
    if (!(o.margin >= 0)) o.margin = 0;
    sets_take(&s, &in);

    distance_cache carried = { .count = take_count(&in, 0, 4) };
    for (int c = 0; c < carried.count; c++) {
        carried.a[c] = take_byte(&in) % s.a.count;
        carried.b[c] = take_byte(&in) % s.b.count;
    }
    point_set a = body_points(&s.a), b = body_points(&s.b);
    distance_result cold = distance_find(a, b, o, NULL);
    check_answer(&s, cold, o);
    check_answer(&s, distance_find(a, b, o, &carried), o);
    return 0;
}
