// check_query.c - the nearest points of two rigid bodies, and what a pair keeps
// from one query to the next.  Book: chapter 10.

#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "bodies.h"
#include "expect.h"
#include "oracle.h"
#include "query.h"
#include "random.h"
#include "suite.h"

// Bodies of size 1 near the origin: a few dozen roundings.
#define ROUNDING 1e-13

static unsigned long long seed;

static shape cube, ball;

static void set_up(void)
{
    seed = 5;
    ck_assert(shape_box(&cube, vec3_make(1, 1, 1), 1).ok);
    ck_assert(shape_icosahedron(&ball, 0.5, 1).ok);
}

static void tear_down(void)
{
    shape_free(&cube);
    shape_free(&ball);
}

// A body somewhere, turned at random.
typedef struct {
    const shape *plan;
    body now;
} standing;

static standing stand(const shape *s, vec3 at)
{
    standing x = { .plan = s };
    x.now.count = s->particles;
    memcpy(x.now.at, s->at, (size_t)s->particles * sizeof *s->at);
    body_turn(&x.now, &seed);
    body_move(&x.now, at);
    return x;
}

static collider collider_of(const standing *x)
{
    return (collider){ x->plan, x->now.at, false };
}

static query_result ask(const standing *a, const standing *b, real margin,
                        query_cache *carried)
{
    collider ca = collider_of(a), cb = collider_of(b);
    return query_nearest(&ca, &cb, margin, carried);
}

static query_result ask_cold(const standing *a, const standing *b, real margin)
{
    query_cache fresh = { .count = 0 };
    return ask(a, b, margin, &fresh);
}

// Two bodies whose middles are up to 1.5 m apart.
static void random_pair(int k, standing *a, standing *b)
{
    *a = stand(k % 2 ? &cube : &ball, random_vector(&seed, 0, 1.5));
    *b = stand(k % 3 ? &cube : &ball, vec3_make(0, 0, 0));
}

static void is_point_of(const feature_point *f, const standing *x)
{
    real sum = 0;
    ck_assert(f->count >= 1 && f->count <= 3);
    for (int k = 0; k < f->count; k++) {
        ck_assert(f->vertex[k] >= 0 && f->vertex[k] < x->now.count);
        ck_assert(f->weight[k] >= 0);
        for (int i = 0; i < k; i++)
            ck_assert_int_ne(f->vertex[i], f->vertex[k]);
        sum += f->weight[k];
    }
    ck_assert(fabs(sum - 1) <= ROUNDING);
}

// The slow ways of the oracle know nothing of GJK or of the hit face.
// Rejects: a normal from A to B; a gap that is not the distance, or minus the
// depth; points of the other body; weights of other vertices.
START_TEST(gap_and_points_are_those_of_the_oracle)
{
    int apart = 0, overlapping = 0;
    for (int k = 0; k < 300; k++) {
        standing a, b;
        random_pair(k, &a, &b);
        query_result r = ask_cold(&a, &b, HUGE_VAL);
        ck_assert(r.near);
        is_point_of(&r.at.a, &a);
        is_point_of(&r.at.b, &b);
        ck_assert(fabs(vec3_length(r.normal) - 1) <= ROUNDING);
        vec3 across = vec3_sub(feature_at(&r.at.a, a.now.at),
                               feature_at(&r.at.b, b.now.at));
        near_vec3(across, vec3_scale(r.at.gap, r.normal), ROUNDING);
        hull ha = body_hull(&a.now), hb = body_hull(&b.now);
        real truth = r.at.gap > 0 ? (real)oracle_distance(ha, hb)
                                  : -(real)oracle_depth(ha, hb);
        ck_assert(fabs(r.at.gap - truth) <= ROUNDING);
        apart += r.at.gap > 0;
        overlapping += r.at.gap < 0;
    }
    ck_assert(apart > 50 && overlapping > 50);
}
END_TEST

// Rejects: a margin compared the wrong way round, or not at all; a bound of the
// distance taken for the distance.
START_TEST(margin_decides_to_the_last_digit)
{
    int inside = 0, beyond = 0;
    for (int k = 0; k < 2000; k++) {
        standing a, b;
        random_pair(k, &a, &b);
        real gap = ask_cold(&a, &b, HUGE_VAL).at.gap;
        if (gap <= 0) continue;
        ck_assert(ask_cold(&a, &b, gap * 1.0001).near);
        ck_assert(!ask_cold(&a, &b, gap * 0.9999).near);
        const real margin[] = { nextafter(gap, 0), gap, nextafter(gap, 9) };
        for (int i = 0; i < 3; i++) {
            query_result r = ask_cold(&a, &b, margin[i]);
            if (r.near) ck_assert(r.at.gap <= margin[i]);
            inside += r.near;
        }
        beyond++;
    }
    ck_assert_msg(beyond > 400 && inside > beyond, "%d of %d", inside, beyond);
}
END_TEST

// A pair tumbles by in small moves, apart, near and overlapping; the cache goes
// with it.
// Rejects: a carried simplex that is not brought to where its corners are now;
// one that is kept when GJK has gone on from it; vertices of A and B exchanged.
START_TEST(carried_or_cold_the_answer_is_the_same)
{
    for (int k = 0; k < 60; k++) {
        standing a, b;
        query_cache carried = { .count = 0 };
        random_pair(k, &a, &b);
        body_move(&a.now, vec3_make(1.5, 0, 0));
        for (int frame = 0; frame < 60; frame++) {
            body_move(&a.now, vec3_make(-0.04, 0.002, 0.001));
            query_result r = ask(&a, &b, HUGE_VAL, &carried);
            query_result cold = ask_cold(&a, &b, HUGE_VAL);
            ck_assert(r.near && cold.near);
            ck_assert(fabs(r.at.gap - cold.at.gap) <= ROUNDING);
            if (r.at.gap > 1e-3) near_vec3(r.normal, cold.normal, 1e-9);
            ck_assert_int_ge(carried.count, 1);
        }
    }
}
END_TEST

// What gjk_distance needs from a cold start, and what from the cache.
static int iterations(const standing *a, const standing *b,
                      const query_cache *carried)
{
    simplex s = { .count = carried->count };
    for (int i = 0; i < s.count; i++)
        s.of[i].a = carried->a[i], s.of[i].b = carried->b[i];
    return gjk_distance(body_hull(&a->now), body_hull(&b->now), HUGE_VAL,
                        &s).iterations;
}

// Rejects: a cache that is not written, or written with other vertices: the
// answer would be right, and no sooner.
START_TEST(carried_query_asks_for_one_support_where_little_has_moved)
{
    const query_cache nothing = { .count = 0 };
    long cold = 0, carried = 0, pairs = 0;
    for (int k = 0; k < 1000; k++) {
        standing a, b;
        query_cache last = { .count = 0 };
        random_pair(k, &a, &b);
        if (ask(&a, &b, HUGE_VAL, &last).at.gap < 0.01) continue;
        body_move(&a.now, random_vector(&seed, 0, 0.002));
        cold += iterations(&a, &b, &nothing);
        carried += iterations(&a, &b, &last);
        pairs++;
    }
    ck_assert_msg(10 * carried < 12 * pairs && cold > 3 * pairs,
                  "%ld pairs: %ld cold, %ld carried", pairs, cold, carried);
}
END_TEST

// Rejects: a cache that a failed query has spoilt.
START_TEST(what_is_not_finite_is_near_nothing_and_leaves_the_cache)
{
    const real bad[] = { (real)NAN, HUGE_VAL, -HUGE_VAL };
    for (int k = 0; k < 3; k++) {
        standing a = stand(&cube, vec3_make(0, 0.9, 0));
        standing b = stand(&ball, vec3_make(0, 0, 0)), broken = a;
        query_cache last = { .count = 0 };
        ck_assert(ask(&a, &b, 9, &last).near);
        query_cache before = last;
        broken.now.at[3].y = bad[k];
        ck_assert(!ask(&broken, &b, 9, &last).near);
        ck_assert(!ask(&b, &broken, 9, &before).near);
        ck_assert(!ask(&a, &b, (real)NAN, &last).near);
        ck_assert_int_ge(last.count, 1);
        ck_assert(ask(&a, &b, 9, &last).near);
    }
}
END_TEST

// What is left of two cubes that were pressed flat into one plane overlaps, and
// has no way out.  Rejects: a contact along no normal.
START_TEST(bodies_pressed_flat_into_one_plane_are_near_nothing)
{
    standing a = stand(&cube, vec3_make(0.2, 0, 0.1));
    standing b = stand(&cube, vec3_make(0, 0, 0));
    for (int i = 0; i < 8; i++) a.now.at[i].y = b.now.at[i].y = 0;
    ck_assert(!ask_cold(&a, &b, 1).near);
}
END_TEST

// There is one cache for each listed pair.  Rejects: one of 200 bytes.
START_TEST(a_cache_is_small)
{
    ck_assert_uint_le(sizeof(query_cache), 32);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        gap_and_points_are_those_of_the_oracle,
        margin_decides_to_the_last_digit,
        carried_or_cold_the_answer_is_the_same,
        carried_query_asks_for_one_support_where_little_has_moved,
        what_is_not_finite_is_near_nothing_and_leaves_the_cache,
        bodies_pressed_flat_into_one_plane_are_near_nothing,
        a_cache_is_small,
        NULL
    };
    return suite_run((suite){
        .name = "query", .tests = tests, .set_up = set_up,
        .tear_down = tear_down
    });
}
