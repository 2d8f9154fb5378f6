// exact_judge.c - see exact_judge.h.

#include "exact_judge.h"
#include "query.h"

#include <string.h>

const char *const ASK_NAME[ASKS] = {
    "paper", "paper, carried", "paper, again",
    "engine", "engine, carried", "engine, again"
};

// What a query says, whichever it is.
typedef struct {
    int  known;             // 0: nothing, 1: all, 2: no way out is told
    real value;             // m, < 0: overlap
    vec3 normal;
    feature_point a, b;     // by vertices
    vec3 on_a, on_b;
    int  has_points;
} answer;

static hull of(const made *m) { return (hull){ m->at, m->count }; }

static answer paper(const made *a, const made *b, simplex *carried)
{
    answer r = { .known = 1 };
    gjk_result g = gjk_distance(of(a), of(b), HUGE_VAL, carried);
    if (g.status == GJK_APART) {
        r.value = g.distance, r.normal = vec3_unit(g.axis);
        for (int k = 0; k < g.last.count; k++) {
            feature_add(&r.a, g.last.of[k].a, g.last.weight[k]);
            feature_add(&r.b, g.last.of[k].b, g.last.weight[k]);
        }
        r.on_a = g.on_a, r.on_b = g.on_b, r.has_points = 1;
        return r;
    }
    if (g.status != GJK_OVERLAP) return (answer){ .known = 0 };
    hit_result h = hit_face_find(of(a), of(b), &g.last);
    if (h.status != HIT_FOUND && h.status != HIT_FLAT)
        return (answer){ .known = 0 };
    return (answer){ h.status == HIT_FLAT ? 2 : 1, -h.depth, h.normal, h.a, h.b,
                     h.on_a, h.on_b, 1 };
}

static answer engine(const made *a, const made *b, query_cache *carried)
{
    struct shape sa = { .particles = a->count, .round = a->round };
    struct shape sb = { .particles = b->count, .round = b->round };
    collider ca = { &sa, a->at, false }, cb = { &sb, b->at, false };
    query_result q = query_nearest(&ca, &cb, HUGE_VAL, carried);
    // Flat bodies in one plane have no way out: near nothing.
    if (!q.near) return (answer){ .known = 2 };
    return (answer){ 1, q.at.gap, q.normal, q.at.a, q.at.b, { 0, 0, 0 },
                     { 0, 0, 0 }, 0 };
}

static answer asked(const made *a, const made *b, int ask,
                    unsigned long long seed)
{
    made a0, b0;
    made_before(&a0, a, &seed);
    made_before(&b0, b, &seed);
    simplex s = { .count = 0 };
    query_cache c = { .count = 0 };
    int warm = ask % 3;
    if (ask < ASK_ENGINE) {
        if (warm) paper(warm == 1 ? &a0 : a, warm == 1 ? &b0 : b, &s);
        return paper(a, b, &s);
    }
    if (warm) engine(warm == 1 ? &a0 : a, warm == 1 ? &b0 : b, &c);
    return engine(a, b, &c);
}

typedef long double wide;

// How far pA - pB is from gap * normal; the points by their weights.
static wide mismatch(const answer *r, const made *a, const made *b, wide gap)
{
    wide d[3] = { 0, 0, 0 }, sum = 0, worst = 0;
    const double *o = &a->at[0].x;
    for (int k = 0; k < r->a.count; k++) {
        const double *p = &a->at[r->a.vertex[k]].x;
        for (int i = 0; i < 3; i++)
            d[i] += (wide)r->a.weight[k] * ((wide)p[i] - o[i]);
        sum += r->a.weight[k];
        if (!(r->a.weight[k] >= 0)) return 1e30L;
    }
    if (!(fabsl(sum - 1) < 1e-12L)) return 1e30L;
    sum = 0;
    for (int k = 0; k < r->b.count; k++) {
        const double *p = &b->at[r->b.vertex[k]].x;
        for (int i = 0; i < 3; i++)
            d[i] -= (wide)r->b.weight[k] * ((wide)p[i] - o[i]);
        sum += r->b.weight[k];
        if (!(r->b.weight[k] >= 0)) return 1e30L;
    }
    if (!(fabsl(sum - 1) < 1e-12L)) return 1e30L;
    const double *n = &r->normal.x;
    for (int i = 0; i < 3; i++) worst = fmaxl(worst, fabsl(d[i] - gap * n[i]));
    return worst;
}

// The same of points that are given, less what their own rounding may do.
static wide mismatch_given(const answer *r, const made *a, wide gap)
{
    wide worst = 0, size = 0;
    const double *n = &r->normal.x, *p = &r->on_a.x, *q = &r->on_b.x;
    for (int i = 0; i < 3; i++) {
        size = fmaxl(size, fabsl((wide)(&a->at[0].x)[i]));
        worst = fmaxl(worst, fabsl((wide)p[i] - q[i] - gap * n[i]));
    }
    return fmaxl(worst - 1e-15L * size, 0);
}

verdict exact_judge(const made *a, const made *b, const truth *t, int ask,
                    unsigned long long seed)
{
    static const wide SAME = 1e-6L, NOISE = 1e-14L, POINT = 1e-9L;
    verdict v = { .bad = 0 };
    answer r = asked(a, b, ask, seed);
    wide round = ask < ASK_ENGINE ? 0 : (wide)a->round + b->round;
    wide size = t->size + round, value = t->value - round;
    wide got = r.known == 2 && ask >= ASK_ENGINE ? 0 : (wide)r.value;
    wide error = fabsl(got - value);
    v.value = r.value, v.error = (real)(error / size);
    v.bad = !r.known || !(error <= SAME * fabsl(value) || error <= NOISE * size);
    v.sign = !r.known || (fabsl(value) > 1e-12L * size && got * value <= 0);
    if (r.known != 1) return v;
    wide core = (wide)r.value + round;
    wide points = mismatch(&r, a, b, core);
    if (r.has_points) points = fmaxl(points, mismatch_given(&r, a, core));
    v.points = (real)(points / size);
    v.witness = !(points <= POINT * size);
    vec3 back = vec3_scale(-1, r.normal);
    wide along = -truth_width(of(a), of(b), back);
    v.along = (real)(fabsl(along - t->value) / size);
    v.normal = !(fabsl(along - t->value) <= POINT * size);
    return v;
}
