// check_gjk.c - tests of lib/gjk: distances, bounds, and the hard cases.

#include "oracle.h"

#include <check.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef PAIRS
#define PAIRS "tests/data/pairs.txt"
#endif

// A dozen roundings of coordinates up to 4, 4.4e-16 each at most.
static const real rounding = 5e-15;
// The same where the reference, too, is rounded (long double may be double).
static const real reference = 1e-13;

static gjk_result ask(const body *a, const body *b)
{
    return gjk_distance(body_points(a), body_points(b), gjk_options_default(),
                        NULL);
}

static void near(real got, real wanted, real tolerance)
{
    ck_assert_msg(fabs(got - wanted) <= tolerance, "got %.17g, wanted %.17g",
                  got, wanted);
}

static void same_bits(real got, real wanted)
{
    ck_assert_msg(memcmp(&got, &wanted, sizeof got) == 0, "got %a, wanted %a",
                  got, wanted);
}

// One number that changes if any bit of an answer changes.
static unsigned long long digest(unsigned long long h, gjk_result r)
{
    const real part[] = { r.distance, r.axis.x, r.axis.y, r.axis.z, r.on_a.x,
                          r.on_a.y, r.on_a.z, r.on_b.x, r.on_b.y, r.on_b.z };
    unsigned char bytes[sizeof part];
    memcpy(bytes, part, sizeof part);
    for (size_t i = 0; i < sizeof part; i++)
        h = (h ^ bytes[i]) * 1099511628211ULL;
    return h + (unsigned long long)r.status;
}

// ---- answers that can be had by hand

START_TEST(two_points_are_as_far_as_they_are)
{
    vec3 p = { 1, 2, 3 }, q = { 4, 6, 3 };
    point_set a = { &p, 1, NULL, NULL }, b = { &q, 1, NULL, NULL };
    gjk_result r = gjk_distance(a, b, gjk_options_default(), NULL);
    ck_assert_int_eq(r.status, GJK_APART);
    same_bits(r.distance, 5);
    same_bits(r.axis.x, -3);        // rejects: an axis from A to B
    same_bits(r.on_a.y, 2);
    same_bits(r.on_b.y, 6);
    ck_assert_int_eq(r.last.count, 1);
    same_bits(r.last.weight[0], 1);
}
END_TEST

START_TEST(a_point_on_itself_overlaps)
{
    vec3 p = { 1e7, -3, 0.1 };
    point_set a = { &p, 1, NULL, NULL };
    gjk_result r = gjk_distance(a, a, gjk_options_default(), NULL);
    ck_assert_int_eq(r.status, GJK_OVERLAP);
    same_bits(r.distance, 0);
    ck_assert_int_eq(r.last.count, 1);
}
END_TEST

START_TEST(crossing_segments_are_their_gap_apart)
{
    vec3 s[2] = { { -1, 0, 0 }, { 1, 0, 0 } };
    vec3 t[2] = { { 0.5, -1, 0.25 }, { 0.5, 1, 0.25 } };
    point_set a = { s, 2, NULL, NULL }, b = { t, 2, NULL, NULL };
    gjk_result r = gjk_distance(a, b, gjk_options_default(), NULL);
    same_bits(r.distance, 0.25);
    near(r.on_a.x, 0.5, rounding);
    near(r.on_b.y, 0, rounding);
}
END_TEST

// Two unit cubes, one moved along 1, 2 and 3 axes: face, edge, vertex apart.
START_TEST(boxes_face_edge_and_vertex_apart)
{
    body a = body_cube(0, 0, 0), f = body_cube(2, 0.25, 0.125),
         e = body_cube(2, 2, 0.25);
    body v = body_cube(2, -2, 2);
    same_bits(ask(&a, &f).distance, 1);
    near(ask(&a, &e).distance, sqrt(2.0), rounding);
    near(ask(&a, &v).distance, sqrt(3.0), rounding);
    near(ask(&a, &v).axis.y, 1, rounding);
}
END_TEST

START_TEST(exact_touch_is_overlap)
{
    body a = body_cube(0, 0, 0), f = body_cube(1, 0.25, 0.125),
         e = body_cube(1, 1, 0.25);
    body v = body_cube(-1, 1, 1);
    ck_assert_int_eq(ask(&a, &f).status, GJK_OVERLAP);
    ck_assert_int_eq(ask(&a, &e).status, GJK_OVERLAP);
    ck_assert_int_eq(ask(&a, &v).status, GJK_OVERLAP);
}
END_TEST

START_TEST(identical_and_concentric_cubes_overlap)
{
    body a = body_cube(0.1, 0.2, 0.3), b = a, c = body_cube(0, 0, 0), small = c;
    body_scale(&small, 1e-4);
    ck_assert_int_eq(ask(&a, &b).status, GJK_OVERLAP);
    ck_assert_int_eq(ask(&c, &small).status, GJK_OVERLAP);
    ck_assert_int_eq(ask(&small, &c).status, GJK_OVERLAP);
}
END_TEST

START_TEST(a_point_is_inside_or_outside_a_cube)
{
    body c = body_cube(0, 0, 0);
    vec3 in = { 0.49, -0.3, 0.2 }, out = { 0.3, 0.2, 0.75 };
    point_set p = { &in, 1, NULL, NULL }, q = { &out, 1, NULL, NULL };
    gjk_options o = gjk_options_default();
    ck_assert_int_eq(gjk_distance(p, body_points(&c), o, NULL).status,
                     GJK_OVERLAP);
    near(gjk_distance(q, body_points(&c), o, NULL).distance, 0.25, rounding);
}
END_TEST

// Two balls of points: the gap along the line of two opposite vertices.
START_TEST(balls_of_points_are_apart_by_the_gap)
{
    body a, b;
    body_icosphere(&a, 2, 0.5);
    b = a;
    vec3 tip = a.at[0];     // opposite vertices exist: the ball is symmetric
    body_move(&b, vec3_scale(2.5, tip));
    near(ask(&a, &b).distance, 0.25, rounding);
}
END_TEST

// ---- where it is hard

// Rejects: supports and witnesses measured from the world's origin.
START_TEST(far_from_the_origin_nothing_more_is_lost)
{
    body a = body_cube(0, 0, 0), b = body_cube(1.75, 1.5, 1.25);
    gjk_result home = ask(&a, &b);
    vec3 far = { 16777216, -8388608, 16777216 };     // 2^24: moves exactly
    body_move(&a, far);
    body_move(&b, far);
    gjk_result away = ask(&a, &b);
    same_bits(away.distance, home.distance);
    same_bits(away.axis.x, home.axis.x);
    same_bits(away.on_a.y - far.y, home.on_a.y);
}
END_TEST

// Rejects: every absolute tolerance.  A power of two scales without rounding,
// so the answer must scale bit by bit; 2^-400 m needs the second attempt.
START_TEST(size_does_not_matter)
{
    const real scale[] = { 0x1p-20, 0x1p20, 0x1p-100, 0x1p100, 0x1p-400,
                           0x1p500 };
    unsigned long long seed = 11;
    for (int n = 0; n < 200; n++) {
        body a, b;
        body_random(&a, 8, &seed);
        body_random(&b, 6, &seed);
        body_move(&b, random_vector(&seed, 0, 2));
        gjk_result one = ask(&a, &b);
        for (int s = 0; s < 6; s++) {
            body c = a, d = b;
            body_scale(&c, scale[s]);
            body_scale(&d, scale[s]);
            gjk_result r = ask(&c, &d);
            ck_assert_int_eq(r.status, one.status);
            same_bits(r.distance, one.distance * scale[s]);
            same_bits(r.on_b.z, one.on_b.z * scale[s]);
        }
    }
}
END_TEST

// Every stored pair: distance to 1e-6, or to 1e-14 of the size near touch
// (the criterion of the set that they come from).
START_TEST(stored_pairs_have_their_exact_distance)
{
    FILE *file = fopen(PAIRS, "r");
    ck_assert_msg(file != NULL, "cannot open %s", PAIRS);
    static pair_known p;
    int read, apart = 0;
    while ((read = pair_read(file, &p)) == 1) {
        real size = 0;
        for (int i = 0; i < p.a.count; i++)
            size = fmax(size, vec3_distance(p.a.at[0], p.a.at[i]));
        for (int i = 0; i < p.b.count; i++)
            size = fmax(size, vec3_distance(p.b.at[0], p.b.at[i]));
        gjk_result r = ask(&p.a, &p.b);
        if (p.kind == 'P' && p.value > 1e-12 * size)
            ck_assert_int_eq(r.status, GJK_OVERLAP);
        if (p.kind != 'S') continue;
        apart++;
        real error = fabs(r.distance - p.value);
        ck_assert_msg(error <= 1e-6 * p.value || error <= 1e-14 * size,
                      "%s: got %.17g, wanted %.17g", p.family, r.distance,
                      p.value);
        if (p.value > 1e-12 * size) ck_assert_int_eq(r.status, GJK_APART);
    }
    fclose(file);
    ck_assert_int_eq(read, 0);
    ck_assert_int_ge(apart, 30);
}
END_TEST

// ---- against every feature pair

static const int pairs_tried = 1500;

START_TEST(random_pairs_agree_with_every_feature_pair)
{
    unsigned long long seed = 2005;
    int apart = 0;
    for (int n = 0; n < pairs_tried; n++) {
        body a, b;
        body_any(&a, n % 5, &seed);
        body_any(&b, n / 5 % 5, &seed);
        if (a.count * b.count > 100) continue;       // the oracle is slow
        body_move(&b, random_vector(&seed, 0, 3));
        gjk_result r = ask(&a, &b);
        if (r.status != GJK_APART) continue;
        apart++;
        real truth = (real)oracle_distance(body_points(&a), body_points(&b));
        near(r.distance, truth, reference);
        near(vec3_distance(r.on_a, r.on_b), truth, reference);
    }
    ck_assert_int_ge(apart, 500);
}
END_TEST

// Proof without a reference: v = on_a - on_b is a point of A - B, and no point
// of A - B lies below the plane through it.  Rejects: a wrong region.
START_TEST(the_gap_is_a_certificate)
{
    unsigned long long seed = 7;
    int apart = 0;
    for (int n = 0; n < 4000; n++) {
        body a, b;
        body_any(&a, n % 5, &seed);
        body_any(&b, n / 5 % 5, &seed);
        body_move(&b, random_vector(&seed, 0, 2.5));
        gjk_result r = ask(&a, &b);
        ck_assert(r.status == GJK_APART || r.status == GJK_OVERLAP);
        vec3 v = r.axis, w = vec3_sub(r.on_a, r.on_b);
        real sum = 0;
        for (int c = 0; c < r.last.count; c++) {
            ck_assert(r.last.weight[c] >= 0);
            sum += r.last.weight[c];
        }
        near(sum, 1, rounding);
        // A flat tetrahedron around the origin has rough weights.
        near(vec3_distance(v, w), 0,
             r.status == GJK_APART ? rounding : 100 * rounding);
        if (r.status != GJK_APART) continue;
        apart++;
        vec3 back = vec3_scale(-1, v);
        real lowest = -(real)oracle_width(body_points(&a), body_points(&b),
                                          back);
        ck_assert(lowest >= r.distance - rounding);
    }
    ck_assert_int_ge(apart, 1500);
}
END_TEST

START_TEST(swapped_bodies_give_the_mirror_image)
{
    unsigned long long seed = 31;
    for (int n = 0; n < 500; n++) {
        body a, b;
        body_any(&a, n % 5, &seed);
        body_any(&b, n / 5 % 5, &seed);
        body_move(&b, vec3_scale(2.5, random_direction(&seed)));
        gjk_result r = ask(&a, &b), s = ask(&b, &a);
        near(r.distance, s.distance, rounding);
        near(vec3_length(vec3_add(r.axis, s.axis)), 0, 10 * rounding);
    }
}
END_TEST

// ---- the simplex that is carried on

START_TEST(carried_equals_cold)
{
    unsigned long long seed = 3;
    long cold_asked = 0, carried_asked = 0;
    for (int n = 0; n < 500; n++) {
        body a, b;
        body_any(&a, n % 3, &seed);
        body_any(&b, n / 3 % 3, &seed);
        body_move(&b, random_vector(&seed, 0.5, 2));
        simplex carried = { .count = 0 };
        vec3 drift = vec3_scale(0.0025, random_direction(&seed));
        for (int frame = 0; frame < 12; frame++) {
            gjk_result cold = ask(&a, &b);
            gjk_result warm = gjk_distance(body_points(&a), body_points(&b),
                                           gjk_options_default(), &carried);
            ck_assert_int_eq(warm.status, cold.status);
            near(warm.distance, cold.distance, rounding);
            ck_assert_mem_eq(&carried, &warm.last, sizeof carried);
            cold_asked += cold.iterations;
            if (frame > 0) carried_asked += warm.iterations;
            body_move(&b, drift);
        }
    }
    ck_assert(3 * carried_asked < cold_asked);
}
END_TEST

// A carried simplex may be anything: what was near once, all four corners, even
// after the bodies have changed places.
START_TEST(a_stale_simplex_does_no_harm)
{
    unsigned long long seed = 5;
    for (int n = 0; n < 1000; n++) {
        body a, b;
        body_any(&a, n % 3, &seed);
        body_any(&b, n / 3 % 3, &seed);
        body_move(&b, random_vector(&seed, 0, 2));
        simplex stale = { .count = 1 + n % 4 };
        for (int c = 0; c < stale.count; c++) {
            stale.a[c] = (int)(a.count * random_unit(&seed));
            stale.b[c] = (int)(b.count * random_unit(&seed));
            stale.weight[c] = 1;
        }
        gjk_result cold = ask(&a, &b);
        gjk_result warm = gjk_distance(body_points(&a), body_points(&b),
                                       gjk_options_default(), &stale);
        ck_assert_int_eq(warm.status, cold.status);
        near(warm.distance, cold.distance, rounding);
    }
}
END_TEST

// ---- margin, bound, cap

START_TEST(beyond_the_margin_it_stops_early_with_a_true_bound)
{
    unsigned long long seed = 13;
    int beyond = 0;
    gjk_options o = gjk_options_default();
    o.margin = 0.1;
    for (int n = 0; n < 1000; n++) {
        body a, b;
        body_any(&a, n % 3, &seed);
        body_any(&b, n / 3 % 3, &seed);
        body_move(&b, random_vector(&seed, 0, 2.5));
        gjk_result full = ask(&a, &b);
        gjk_result r = gjk_distance(body_points(&a), body_points(&b), o, NULL);
        if (full.distance < 0.1) {
            ck_assert_int_eq(r.status, full.status);
            near(r.distance, full.distance, rounding);
            continue;
        }
        beyond++;
        ck_assert_int_eq(r.status, GJK_BEYOND);
        ck_assert(r.distance > 0.1 && r.distance <= full.distance + rounding);
        ck_assert_int_le(r.iterations, full.iterations);
        // The axis parts them by at least that much.
        real parted = -(real)oracle_width(body_points(&a), body_points(&b),
                                          vec3_scale(-1, r.axis));
        near(parted, r.distance, rounding);
    }
    ck_assert_int_ge(beyond, 300);
}
END_TEST

START_TEST(the_relative_error_is_kept)
{
    const real bound[] = { 0.5, 0.1, 0.01, 1e-4 };
    unsigned long long seed = 17;
    for (int n = 0; n < 800; n++) {
        body a, b;
        body_any(&a, n % 3, &seed);
        body_any(&b, n / 3 % 3, &seed);
        body_move(&b, vec3_scale(2.5, random_direction(&seed)));
        gjk_options o = gjk_options_default();
        o.relative_error = bound[n % 4];
        gjk_result exact = ask(&a, &b);
        gjk_result r = gjk_distance(body_points(&a), body_points(&b), o, NULL);
        if (exact.status != GJK_APART) continue;
        ck_assert(r.distance >= exact.distance - rounding);
        ck_assert(r.distance - exact.distance
                  <= bound[n % 4] * r.distance + rounding);
        ck_assert_int_le(r.iterations, exact.iterations);
    }
}
END_TEST

START_TEST(the_cap_is_honoured)
{
    body a, b;
    body_icosphere(&a, 2, 0.5);
    b = a;
    body_move(&b, (vec3){ 0.8, 0.7, 0.6 });
    gjk_result full = ask(&a, &b);
    ck_assert_int_gt(full.iterations, 3);
    real before = HUGE_VAL;
    for (int cap = 1; cap <= full.iterations; cap++) {
        gjk_options o = gjk_options_default();
        o.cap = cap;
        gjk_result r = gjk_distance(body_points(&a), body_points(&b), o, NULL);
        ck_assert_int_le(r.iterations, cap);
        // What is so far: never worse with more, and a point of A - B.
        ck_assert(r.distance <= before && r.distance >= full.distance);
        near(vec3_distance(r.on_a, r.on_b), r.distance, rounding);
        ck_assert(r.status == GJK_CAPPED || cap == full.iterations);
        before = r.distance;
    }
}
END_TEST

START_TEST(sixty_four_is_never_reached)
{
    unsigned long long seed = 19;
    for (int n = 0; n < 4000; n++) {
        body a, b;
        body_any(&a, n % 5, &seed);
        body_any(&b, n / 5 % 5, &seed);
        // Within a few rounding errors of touching, on either side.
        body_move(&b, vec3_scale(2.5, random_direction(&seed)));
        for (int k = 0; k < 4; k++)
            body_move(&b, ask(&a, &b).axis);
        gjk_result r = ask(&a, &b);
        ck_assert(r.status == GJK_APART || r.status == GJK_OVERLAP);
        ck_assert_int_le(r.iterations, 20);
        ck_assert(r.distance < 1e-14);
    }
}
END_TEST

// ---- support

START_TEST(support_is_the_furthest_and_the_lowest_of_equals)
{
    body c = body_cube(0, 0, 0);
    point_set p = body_points(&c);
    ck_assert_int_eq(support_scan(p, (vec3){ 1, 1, 1 }), 7);
    ck_assert_int_eq(support_scan(p, (vec3){ -1, -1, -1 }), 0);
    ck_assert_int_eq(support_scan(p, (vec3){ 0, 0, 1 }), 4);
    ck_assert_int_eq(support_scan(p, (vec3){ 0, 0, 0 }), 0);
}
END_TEST

static real height(const body *b, int i, vec3 d)
{
    return vec3_dot(d, vec3_sub(b->at[i], b->at[0]));
}

START_TEST(climbing_finds_what_scanning_finds)
{
    unsigned long long seed = 23;
    for (int level = 1; level <= 3; level++) {
        static body b;
        body_icosphere(&b, level, 0.5);
        body_turn(&b, &seed);
        body_move(&b, (vec3){ 100, -200, 300 });
        point_set p = body_points(&b);
        for (int n = 0; n < 3000; n++) {
            vec3 d = random_direction(&seed);
            int from = (int)(b.count * random_unit(&seed));
            int scanned = support_scan(p, d);
            int climbed = support_climb(p, d, from);
            same_bits(height(&b, climbed, d), height(&b, scanned, d));
        }
    }
}
END_TEST

// A grid on each face of a cube: plateaus of level neighbours everywhere.
// Rejects: a climb that takes the middle of the lowest side for the top.
START_TEST(climbing_crosses_plateaus)
{
    enum { SIDE = 5, COUNT = SIDE * SIDE * SIDE };
    vec3 at[COUNT];
    int start[COUNT + 1], ring[COUNT * 26], count = 0, used = 0;
    for (int i = 0; i < COUNT; i++) {
        int x = i % SIDE, y = i / SIDE % SIDE, z = i / SIDE / SIDE;
        int rim = x % (SIDE-1) == 0 || y % (SIDE-1) == 0 || z % (SIDE-1) == 0;
        if (rim) at[count++] = (vec3){ x, y, z };
    }
    for (int i = 0; i < count; i++) {
        start[i] = used;
        for (int j = 0; j < count; j++) {
            vec3 d = vec3_sub(at[i], at[j]);
            if (i != j && fabs(d.x) <= 1 && fabs(d.y) <= 1 && fabs(d.z) <= 1)
                ring[used++] = j;
        }
    }
    start[count] = used;
    point_set p = { at, count, start, ring };
    unsigned long long seed = 29;
    for (int n = 0; n < 3000; n++) {
        vec3 d = random_direction(&seed);
        if (n % 3 == 1) d.x = 0;
        if (n % 3 == 2) d.x = d.z = 0;
        int climbed = support_climb(p, d, (int)(count * random_unit(&seed)));
        near(vec3_dot(d, at[climbed]), vec3_dot(d, at[support_scan(p, d)]),
             rounding);
    }
}
END_TEST

START_TEST(a_ring_changes_nothing_but_the_time)
{
    unsigned long long seed = 37;
    for (int n = 0; n < 60; n++) {
        static body a, b;
        body_icosphere(&a, 2 + n % 2, 0.5);
        b = a;
        body_turn(&a, &seed);
        body_turn(&b, &seed);
        body_move(&b, random_vector(&seed, 0.9, 1.2));
        gjk_result climbed = ask(&a, &b);
        a.has_ring = b.has_ring = 0;
        gjk_result scanned = ask(&a, &b);
        ck_assert_int_eq(climbed.status, scanned.status);
        near(climbed.distance, scanned.distance, rounding);
    }
}
END_TEST

// ---- bad input

START_TEST(what_is_not_finite_gets_a_status)
{
    const real poison[3] = { (real)NAN, HUGE_VAL, -HUGE_VAL };
    for (int apart = 0; apart < 2; apart++)
        for (int kind = 0; kind < 3; kind++)
            for (int i = 0; i < 8; i++)
                for (int axis = 0; axis < 3; axis++) {
                    body a = body_cube(0, 0, 0);
                    body b = body_cube(0.2 + 2 * apart, 0.1, 0.3);
                    real *x = axis == 0 ? &b.at[i].x
                            : axis == 1 ? &b.at[i].y : &b.at[i].z;
                    *x = poison[kind];
                    gjk_result r = ask(&a, &b), s = ask(&b, &a);
                    ck_assert_int_eq(r.status, GJK_NOT_FINITE);
                    ck_assert_int_eq(s.status, GJK_NOT_FINITE);
                    same_bits(r.distance, 0);
                    ck_assert_int_eq(r.last.count, 0);
                }
}
END_TEST

// ---- the same bits

// The number was printed by this test itself; gcc and clang agree on it at -O0,
// -O2 and -O3.  A change of it is a change of answers.
static const unsigned long long known_digest = 0x3c7016d941c5a216ULL;

START_TEST(the_same_bits_everywhere)
{
    unsigned long long seed = 41, h = 0;
    for (int n = 0; n < 3000; n++) {
        body a, b;
        body_any(&a, n % 5, &seed);
        body_any(&b, n / 5 % 5, &seed);
        body_move(&b, random_vector(&seed, 0, 2));
        h = digest(h, ask(&a, &b));
    }
    ck_assert_msg(h == known_digest, "the digest is 0x%llxULL", h);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("gjk");
    TCase *t = tcase_create("gjk");
    tcase_set_timeout(t, 60);
    tcase_add_test(t, two_points_are_as_far_as_they_are);
    tcase_add_test(t, a_point_on_itself_overlaps);
    tcase_add_test(t, crossing_segments_are_their_gap_apart);
    tcase_add_test(t, boxes_face_edge_and_vertex_apart);
    tcase_add_test(t, exact_touch_is_overlap);
    tcase_add_test(t, identical_and_concentric_cubes_overlap);
    tcase_add_test(t, a_point_is_inside_or_outside_a_cube);
    tcase_add_test(t, balls_of_points_are_apart_by_the_gap);
    tcase_add_test(t, far_from_the_origin_nothing_more_is_lost);
    tcase_add_test(t, size_does_not_matter);
    tcase_add_test(t, stored_pairs_have_their_exact_distance);
    tcase_add_test(t, random_pairs_agree_with_every_feature_pair);
    tcase_add_test(t, the_gap_is_a_certificate);
    tcase_add_test(t, swapped_bodies_give_the_mirror_image);
    tcase_add_test(t, carried_equals_cold);
    tcase_add_test(t, a_stale_simplex_does_no_harm);
    tcase_add_test(t, beyond_the_margin_it_stops_early_with_a_true_bound);
    tcase_add_test(t, the_relative_error_is_kept);
    tcase_add_test(t, the_cap_is_honoured);
    tcase_add_test(t, sixty_four_is_never_reached);
    tcase_add_test(t, support_is_the_furthest_and_the_lowest_of_equals);
    tcase_add_test(t, climbing_finds_what_scanning_finds);
    tcase_add_test(t, climbing_crosses_plateaus);
    tcase_add_test(t, a_ring_changes_nothing_but_the_time);
    tcase_add_test(t, what_is_not_finite_gets_a_status);
    tcase_add_test(t, the_same_bits_everywhere);
    suite_add_tcase(suite, t);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
