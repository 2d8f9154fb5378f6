// fuzz_hit_face.c - hit_face_find on two bodies made from bytes.  See fuzz.h.

#include "hit_face.h"
#include "sets.h"

typedef long double wide;

// Of the reach of A - B: what a depth may be off.
static const wide rounding = 1e-12L;

static void check_feature(const body *b, const feature_point *f)
{
    real sum = 0;
    MUST(f->count >= 1 && f->count <= 3, "%d vertices", f->count);
    for (int k = 0; k < f->count; k++) {
        MUST(f->vertex[k] >= 0 && f->vertex[k] < b->count, "vertex %d",
             f->vertex[k]);
        MUST(f->weight[k] >= 0, "weight %g", f->weight[k]);
        sum += f->weight[k];
    }
    MUST(fabs(sum - 1) <= 1e-14, "weights add up to %.17g", sum);
}

// All that an answer says of itself, whatever the bodies.
static void check_form(const sets *s, const hit_result *r)
{
    MUST(r->status >= HIT_FOUND && r->status <= HIT_NOT_FINITE, "%d",
         r->status);
    MUST(r->kind >= TOUCH_VERTEX_FACE && r->kind <= TOUCH_EDGE_EDGE, "%d",
         r->kind);
    MUST(r->iterations >= 0 && r->iterations <= 512, "%d", r->iterations);
    MUST(is_number(r->depth) && r->depth >= 0, "depth %g", r->depth);
    MUST(vec3_is_finite(r->normal), "normal");
    MUST(vec3_is_finite(r->on_a) && vec3_is_finite(r->on_b), "points");
    if (r->status == HIT_NOT_FINITE) return;
    real length = vec3_length(r->normal);
    MUST(!s->fair || fabs(length - 1) <= 1e-14, "normal of length %.17g",
         length);
    check_feature(&s->a, &r->a);
    check_feature(&s->b, &r->b);
    for (int i = 0; i < 3; i++) {
        MUST(r->hit[i].a >= 0 && r->hit[i].a < s->a.count, "a %d",
             r->hit[i].a);
        MUST(r->hit[i].b >= 0 && r->hit[i].b < s->b.count, "b %d",
             r->hit[i].b);
    }
}

// How far A reaches over B against n: the move along n that parts them.
static wide width(const sets *s, vec3 n)
{
    return oracle_width(body_hull(&s->a), body_hull(&s->b),
                        vec3_scale(-1, n));
}

// Of the reach, what the points may be off, which in a wedge of a thin A - B
// are not as sure as the depth.
static const wide roughly = 1e-6L;

// The points are depth apart along the normal.
static void check_points(const sets *s, const hit_result *r)
{
    wide off = 16 * (roughly * s->reach + 1e-15L * s->place);
    wide d = (wide)r->depth;
    MUST(fabsl((wide)r->on_b.x - (wide)r->on_a.x - d * (wide)r->normal.x) <= off
         && fabsl((wide)r->on_b.y - (wide)r->on_a.y
                  - d * (wide)r->normal.y) <= off
         && fabsl((wide)r->on_b.z - (wide)r->on_a.z
                  - d * (wide)r->normal.z) <= off,
         "the points are not the depth %g apart along the normal", r->depth);
}

static void check_answer(const sets *s, const hit_result *r, vec3 other)
{
    check_form(s, r);
    if (!s->fair) return;
    wide off = rounding * s->reach, along = width(s, r->normal);
    MUST(r->status != HIT_NOT_FINITE, "every coordinate is finite");

    // The move parts them, and no other is shorter.
    wide depth = (wide)r->depth;
    if (r->status == HIT_FOUND) {
        MUST(along <= depth + off, "depth %Lg, width %Lg", depth, along);
        check_points(s, r);
    }
    if (r->status == HIT_CAPPED)
        MUST(depth <= along + off, "depth %Lg, width %Lg", depth, along);
    if (r->status == HIT_FOUND) {
        for (int k = 0; k < 6; k++) {
            wide way = k % 2 ? 1 : -1;
            vec3 axis = { k / 2 == 0, k / 2 == 1, k / 2 == 2 };
            wide across = width(s, vec3_scale((real)way, axis));
            MUST(across >= depth - off,
                 "depth %Lg is more than along axis %d", depth, k);
        }
        if (vec3_is_finite(other) && vec3_length_squared(other) > 0)
            MUST(width(s, other) >= depth - off,
                 "depth %Lg is not the least, %Lg", depth, width(s, other));
    }
    if (r->status == HIT_FLAT)
        MUST(fabsl(along) <= off, "flat, but %Lg thick", along);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static sets s;
    bytes in = { .at = data, .left = size };
    sets_take(&s, &in);
    vec3 other = take_vec3(&in);
    hull a = body_hull(&s.a), b = body_hull(&s.b);
    gjk_result g = gjk_distance(a, b, 0, NULL);
    if (g.status != GJK_OVERLAP && g.status != GJK_NOT_FINITE) return 0;
    hit_result r = hit_face_find(a, b, &g.last);
    check_answer(&s, &r, other);
    return 0;
}
