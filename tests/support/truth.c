// truth.c - see truth.h.

#include "truth.h"

#include <float.h>

#define wide long double
#define WIDE_NAME long
#define WIDE_EPS LDBL_EPSILON
#include "truth_wide.h"
#undef wide
#undef WIDE_NAME
#undef WIDE_EPS

__extension__ typedef __float128 quad;
#define wide quad
#define WIDE_NAME quad
#define WIDE_EPS ((quad)0x1p-112)
#include "truth_wide.h"
#undef wide
#undef WIDE_NAME
#undef WIDE_EPS

static const long double NEAR = 1e-16L;     // of the size: as good as equal
static const long double ALIKE = 1e-10L;    // of the value: the same

static long double side(hull h)
{
    long double most = 0;
    for (int i = 0; i < h.count; i++)
        for (int j = 0; j < i; j++) {
            most = fmaxl(most, fabsl((long double)h.at[i].x - h.at[j].x));
            most = fmaxl(most, fabsl((long double)h.at[i].y - h.at[j].y));
            most = fmaxl(most, fabsl((long double)h.at[i].z - h.at[j].z));
        }
    return most;
}

long double truth_width(hull a, hull b, vec3 n)
{
    static pair_quad p;
    widen_quad(&p, a, b);
    vec_quad q = widened_quad(n);
    return (long double)(width_quad(&p, q) / root_quad(dot_quad(q, q)));
}

// --- depth -------------------------------------------------------------------

// One direction in which a facet of A - B may look: across two edges.
typedef struct { int of[4]; long double width, error; } way;
enum { WAYS = 2 * 560 + 120 * 120 };
typedef struct { way at[WAYS]; int count; } ways;

// The edges of a way: both of A, both of B, or one of each.
static void edges(const pair_long *p, const int of[4], vec_long *e, vec_long *f)
{
    const vec_long *one = of[0] < 0 ? p->b : p->a;
    if (of[3] >= 0) {
        *e = minus_long(p->a[of[1]], p->a[of[0]]);
        *f = minus_long(p->b[of[3]], p->b[of[2]]);
        return;
    }
    int first = of[0] < 0 ? -1 - of[0] : of[0];
    *e = minus_long(one[of[1]], one[first]);
    *f = minus_long(one[of[2]], one[first]);
}

static void edges_wider(const pair_quad *p, const int of[4], vec_quad *e,
                        vec_quad *f)
{
    const vec_quad *one = of[0] < 0 ? p->b : p->a;
    if (of[3] >= 0) {
        *e = minus_quad(p->a[of[1]], p->a[of[0]]);
        *f = minus_quad(p->b[of[3]], p->b[of[2]]);
        return;
    }
    int first = of[0] < 0 ? -1 - of[0] : of[0];
    *e = minus_quad(one[of[1]], one[first]);
    *f = minus_quad(one[of[2]], one[first]);
}

static void add_way(ways *w, const pair_long *p, long double size, int i, int j,
                    int k, int l)
{
    way *t = &w->at[w->count];
    *t = (way){ .of = { i, j, k, l } };
    vec_long e, f;
    edges(p, t->of, &e, &f);
    t->width = width_across_long(p, e, f, size, &t->error);
    if (dot_long(e, e) > 0 && dot_long(f, f) > 0) w->count++;
}

static void all_ways(ways *w, const pair_long *p, long double size)
{
    w->count = 0;
    for (int i = 0; i < p->na; i++)
        for (int j = i + 1; j < p->na; j++) {
            for (int k = j + 1; k < p->na; k++)
                add_way(w, p, size, i, j, k, -1);
            for (int k = 0; k < p->nb; k++)
                for (int l = k + 1; l < p->nb; l++)
                    add_way(w, p, size, i, j, k, l);
        }
    for (int i = 0; i < p->nb; i++)
        for (int j = i + 1; j < p->nb; j++)
            for (int k = j + 1; k < p->nb; k++)
                add_way(w, p, size, -1 - i, j, k, -1);
}

// The least width over all directions, those in doubt measured again.
static long double least_width(ways *w, const pair_long *p, const pair_quad *q,
                               long double size, long double *doubt, int *wider)
{
    all_ways(w, p, size);
    long double best = HUGE_VALL, open = HUGE_VALL;
    for (int k = 0; k < w->count; k++)
        if (w->at[k].error >= 0 && w->at[k].width + w->at[k].error < best)
            best = w->at[k].width + w->at[k].error;
    for (int k = 0; k < w->count; k++) {
        way *t = &w->at[k];
        if (t->error >= 0 && t->width - t->error > best) continue;
        if (t->error < 0 || t->error > NEAR * size + ALIKE * fabsl(t->width)) {
            quad error;
            vec_quad e, f;
            edges_wider(q, t->of, &e, &f);
            t->width = (long double)width_across_quad(q, e, f, (quad)size,
                                                      &error);
            t->error = (long double)error;
            *wider = 1;
            if (t->error < 0) continue;     // parallel, to 113 bits
        }
        best = fminl(best, t->width + t->error);
        open = fminl(open, t->width - t->error);
    }
    *doubt = best - open;
    return best;
}

// --- distance ----------------------------------------------------------------

// Only vertices near the planes that part the bodies most.
static void choose(pair_quad *q, const pair_long *p, vec_long n,
                   long double thick)
{
    long double most = -HUGE_VALL, least = HUGE_VALL;
    for (int i = 0; i < p->nb; i++) most = fmaxl(most, dot_long(n, p->b[i]));
    for (int i = 0; i < p->na; i++) least = fminl(least, dot_long(n, p->a[i]));
    for (int i = 0; i < p->nb; i++)
        q->use_b[i] = dot_long(n, p->b[i]) >= most - thick;
    for (int i = 0; i < p->na; i++)
        q->use_a[i] = dot_long(n, p->a[i]) <= least + thick;
}

static int proven(truth *t, long double distance, long double bound)
{
    t->value = distance, t->doubt = distance - bound;
    return t->doubt <= NEAR * t->size + ALIKE * distance;
}

static int proven_wider(truth *t, const pair_quad *q)
{
    best_quad r = apart_quad(q);
    t->wider = 1;
    return proven(t, (long double)root_quad(r.square), (long double)r.proven);
}

static int find_apart(truth *t, const pair_long *p, pair_quad *q)
{
    best_long r = apart_long(p);
    if (proven(t, sqrtl(r.square), r.proven)) return 1;
    long double length = sqrtl(dot_long(r.axis, r.axis));
    if (!(length > 0)) return proven_wider(t, q);
    vec_long n = times_long(1 / length, r.axis);
    if (dot_long(n, r.v) < 0) n = times_long(-1, n);
    choose(q, p, n, 1e-4L * t->size);
    return proven_wider(t, q)
        || (choose(q, p, n, HUGE_VALL), proven_wider(t, q));
}

truth truth_find(hull a, hull b)
{
    static ways w;
    static pair_long p;
    static pair_quad q;
    truth t = { .size = fmaxl(side(a), side(b)) };
    widen_long(&p, a, b);
    widen_quad(&q, a, b);
    if (!(t.size > 0))              // two points: their distance
        t.size = sqrtl(dot_long(p.b[0], p.b[0])) + (long double)DBL_MIN;
    long double doubt = 0;
    int wider = 0;
    long double reach = 2 * t.size + fabsl(p.b[0].x) + fabsl(p.b[0].y)
                      + fabsl(p.b[0].z);
    long double depth = least_width(&w, &p, &q, 2 * reach, &doubt, &wider);
    if (depth < HUGE_VALL && depth > 1e-12L * t.size) {   // they overlap, surely
        t.value = -depth, t.doubt = doubt, t.wider = wider;
        return t;
    }
    if (find_apart(&t, &p, &q)) return t;
    t.value = depth < HUGE_VALL ? -fmaxl(depth, 0) : 0;
    t.doubt = depth < HUGE_VALL ? doubt : 0, t.wider = 1;
    return t;
}
