// check_distance.c - tests of lib/query/distance: distances, bounds, and the hard cases.

#include "bodies.h"
#include "gjk.h"
#include "oracle.h"
#include "points.h"

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

static distance_result ask(const body *a, const body *b)
{
    return distance_find(body_points(a), body_points(b), distance_options_default(),
                        NULL);
}

// m, the gap between A and B along the unit vector n, from B to A.
static real gap_along(point_set a, point_set b, vec3 n)
{
    real least = HUGE_VAL, most = -HUGE_VAL;
    for (int i = 0; i < a.count; i++)
        least = fmin(least, vec3_dot(n, vec3_sub(a.at[i], a.at[0])));
    for (int i = 0; i < b.count; i++)
        most = fmax(most, vec3_dot(n, vec3_sub(b.at[i], a.at[0])));
    return least - most;
}

static void near(real got, real wanted, real tolerance)
{
    ck_assert_msg(fabs(got - wanted) <= tolerance, "got %.17g, wanted %.17g",
                  got, wanted);
}

static void same_bits(real got, real wanted)
{
    ck_assert_msg(memcmp(&got, &wanted, sizeof got) == 0,
                  "got %.17g, wanted %.17g", got, wanted);
}

static void same_simplex(const distance_cache *got, const distance_cache *wanted)
{
    ck_assert_int_eq(got->count, wanted->count);
    for (int c = 0; c < 4; c++) {
        ck_assert_int_eq(got->a[c], wanted->a[c]);
        ck_assert_int_eq(got->b[c], wanted->b[c]);
        same_bits(got->weight[c], wanted->weight[c]);
    }
    same_bits(got->axis.x, wanted->axis.x);
}

// One number that changes if any bit of an answer changes.
static unsigned long long digest(unsigned long long h, distance_result r)
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
    distance_result r = distance_find(a, b, distance_options_default(), NULL);
    ck_assert_int_eq(r.status, DISTANCE_APART);
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
    distance_result r = distance_find(a, a, distance_options_default(), NULL);
    ck_assert_int_eq(r.status, DISTANCE_OVERLAP);
    same_bits(r.distance, 0);
    ck_assert_int_eq(r.last.count, 1);
}
END_TEST

START_TEST(crossing_segments_are_their_gap_apart)
{
    vec3 s[2] = { { -1, 0, 0 }, { 1, 0, 0 } };
    vec3 t[2] = { { 0.5, -1, 0.25 }, { 0.5, 1, 0.25 } };
    point_set a = { s, 2, NULL, NULL }, b = { t, 2, NULL, NULL };
    distance_result r = distance_find(a, b, distance_options_default(), NULL);
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
    ck_assert_int_eq(ask(&a, &f).status, DISTANCE_OVERLAP);
    ck_assert_int_eq(ask(&a, &e).status, DISTANCE_OVERLAP);
    ck_assert_int_eq(ask(&a, &v).status, DISTANCE_OVERLAP);
}
END_TEST

START_TEST(identical_and_concentric_cubes_overlap)
{
    body a = body_cube(0.1, 0.2, 0.3), b = a, c = body_cube(0, 0, 0), small = c;
    body_scale(&small, 1e-4);
    ck_assert_int_eq(ask(&a, &b).status, DISTANCE_OVERLAP);
    ck_assert_int_eq(ask(&c, &small).status, DISTANCE_OVERLAP);
    ck_assert_int_eq(ask(&small, &c).status, DISTANCE_OVERLAP);
}
END_TEST

START_TEST(a_point_is_inside_or_outside_a_cube)
{
    body c = body_cube(0, 0, 0);
    vec3 in = { 0.49, -0.3, 0.2 }, out = { 0.3, 0.2, 0.75 };
    point_set p = { &in, 1, NULL, NULL }, q = { &out, 1, NULL, NULL };
    distance_options o = distance_options_default();
    ck_assert_int_eq(distance_find(p, body_points(&c), o, NULL).status,
                     DISTANCE_OVERLAP);
    near(distance_find(q, body_points(&c), o, NULL).distance, 0.25, rounding);
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
    distance_result home = ask(&a, &b);
    vec3 far = { 16777216, -8388608, 16777216 };     // 2^24: moves exactly
    body_move(&a, far);
    body_move(&b, far);
    distance_result away = ask(&a, &b);
    same_bits(away.distance, home.distance);
    same_bits(away.axis.x, home.axis.x);
    same_bits(away.on_a.y - far.y, home.on_a.y);
}
END_TEST

// Rejects: every absolute tolerance.  A power of two scales without rounding,
// so the answer must scale bit by bit; 2^-400 m needs the second attempt, and
// the last two have directions whose products with the vertices overflow.
START_TEST(size_does_not_matter)
{
    const real scale[] = { 0x1p-20, 0x1p20, 0x1p-100, 0x1p100, 0x1p-400,
                           0x1p500, 0x1p-900, 0x1p990 };
    unsigned long long seed = 11;
    for (int n = 0; n < 200; n++) {
        body a, b;
        body_random(&a, 8, &seed);
        body_random(&b, 6, &seed);
        body_move(&b, random_vector(&seed, 0, 2));
        distance_result one = ask(&a, &b);
        for (int s = 0; s < 8; s++) {
            body c = a, d = b;
            body_scale(&c, scale[s]);
            body_scale(&d, scale[s]);
            distance_result r = ask(&c, &d);
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
        distance_result r = ask(&p.a, &p.b);
        if (p.kind == 'P' && p.value > 1e-12 * size)
            ck_assert_int_eq(r.status, DISTANCE_OVERLAP);
        if (p.kind != 'S') continue;
        apart++;
        real error = fabs(r.distance - p.value);
        ck_assert_msg(error <= 1e-6 * p.value || error <= 1e-14 * size,
                      "%s: got %.17g, wanted %.17g", p.family, r.distance,
                      p.value);
        if (p.value > 1e-12 * size) ck_assert_int_eq(r.status, DISTANCE_APART);
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
        distance_result r = ask(&a, &b);
        if (r.status != DISTANCE_APART) continue;
        apart++;
        real truth = (real)oracle_distance(body_hull(&a), body_hull(&b));
        near(r.distance, truth, reference);
        near(vec3_distance(r.on_a, r.on_b), truth, reference);
    }
    ck_assert_int_ge(apart, 500);
}
END_TEST

// Chapter 04's GJK, which shares no line with this one.  Rejects: a distance, an
// axis or witness points that only the fast way believes in.
START_TEST(the_fast_distance_is_the_plain_one)
{
    unsigned long long seed = 404;
    int apart = 0;
    for (int n = 0; n < 20000; n++) {
        static body a, b;
        body_any(&a, n % 5, &seed);
        body_any(&b, n / 5 % 5, &seed);
        body_move(&b, random_vector(&seed, 0, 3));
        distance_result fast = ask(&a, &b);
        gjk_result plain = gjk_distance((hull){ a.at, a.count },
                                        (hull){ b.at, b.count }, HUGE_VAL,
                                        NULL);
        near(fast.distance, plain.distance, reference);
        if (fast.status != DISTANCE_APART) continue;
        apart++;
        near(vec3_distance(fast.axis, plain.axis), 0, 1e-6 * plain.distance
             + reference);
        near(vec3_distance(fast.on_a, fast.on_b), plain.distance, reference);
    }
    ck_assert_int_ge(apart, 10000);
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
        distance_result r = ask(&a, &b);
        ck_assert(r.status == DISTANCE_APART || r.status == DISTANCE_OVERLAP);
        vec3 v = r.axis, w = vec3_sub(r.on_a, r.on_b);
        real sum = 0;
        for (int c = 0; c < r.last.count; c++) {
            ck_assert(r.last.weight[c] >= 0);
            sum += r.last.weight[c];
        }
        near(sum, 1, rounding);
        // A flat tetrahedron around the origin has rough weights.
        near(vec3_distance(v, w), 0,
             r.status == DISTANCE_APART ? rounding : 100 * rounding);
        if (r.status != DISTANCE_APART) continue;
        apart++;
        vec3 back = vec3_scale(-1, v);
        real lowest = -(real)oracle_width(body_hull(&a), body_hull(&b),
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
        distance_result r = ask(&a, &b), s = ask(&b, &a);
        near(r.distance, s.distance, rounding);
        near(vec3_length(vec3_add(r.axis, s.axis)), 0, 10 * rounding);
    }
}
END_TEST

// ---- the simplex that is carried on

// The oracle of the short way is the search.  Rejects: corners that are believed
// to be nearest without a look at the others; the weights of other corners.
START_TEST(carried_equals_cold)
{
    unsigned long long seed = 3;
    long cold_asked = 0, carried_asked = 0;
    for (int n = 0; n < 500; n++) {
        body a, b;
        body_any(&a, n % 3, &seed);
        body_any(&b, n / 3 % 3, &seed);
        body_move(&b, random_vector(&seed, 0.5, 2));
        distance_cache carried = { .count = 0 };
        vec3 drift = vec3_scale(0.0025, random_direction(&seed));
        for (int frame = 0; frame < 12; frame++) {
            distance_result cold = ask(&a, &b);
            distance_result warm = distance_find(body_points(&a), body_points(&b),
                                           distance_options_default(), &carried);
            ck_assert_int_eq(warm.status, cold.status);
            near(warm.distance, cold.distance, rounding);
            vec3 between = vec3_sub(warm.on_a, warm.on_b);
            near(vec3_distance(between, warm.axis), 0, rounding);
            same_simplex(&carried, &warm.last);
            cold_asked += cold.iterations;
            if (frame > 0) carried_asked += warm.iterations;
            body_move(&b, drift);
        }
    }
    ck_assert(3 * carried_asked < cold_asked);
}
END_TEST

// Rejects: a short way that is taken where squares of squares leave the range.
START_TEST(a_carried_simplex_serves_bodies_of_any_size)
{
    const real scale[] = { 0x1p-20, 0x1p20, 0x1p-100, 0x1p100, 0x1p-265,
                           0x1p-400, 0x1p500 };
    unsigned long long seed = 29;
    for (int n = 0; n < 200; n++) {
        body a, b;
        body_random(&a, 8, &seed);
        body_random(&b, 6, &seed);
        body_move(&b, random_vector(&seed, 0, 2));
        distance_cache last = ask(&a, &b).last;
        body_move(&b, vec3_scale(0.0025, random_direction(&seed)));
        distance_result one = ask(&a, &b);
        for (int s = 0; s < 7; s++) {
            body c = a, d = b;
            body_scale(&c, scale[s]);
            body_scale(&d, scale[s]);
            distance_cache carried = last;
            distance_result r = distance_find(body_points(&c), body_points(&d),
                                        distance_options_default(), &carried);
            ck_assert_int_eq(r.status, one.status);
            near(r.distance / scale[s], one.distance, rounding);
        }
    }
}
END_TEST

// The second vertex is nearer than the carried one by 2^-28 m, which heights
// from the world's origin cannot tell: they are sums of some 2^25.6 m.
// Rejects: a short way that measures so wherever the bodies are.
START_TEST(far_out_a_carried_corner_is_not_believed)
{
    const real f = 0x1p24, step = 0x1p-28;
    vec3 away[] = { { f + 1, f + 1, f + 1 }, { f + 1, f + 1, f + 1 - step },
                    { f + 2, f + 2, f + 2 }, { f + 2, f + 3, f + 2 } };
    vec3 origin = { f, f, f }, home[4], none = { 0, 0, 0 };
    for (int i = 0; i < 4; i++) home[i] = vec3_sub(away[i], origin);
    point_set a = { away, 4, NULL, NULL }, b = { &origin, 1, NULL, NULL };
    point_set c = { home, 4, NULL, NULL }, d = { &none, 1, NULL, NULL };
    distance_cache carried = { .count = 1 };
    distance_result r = distance_find(a, b, distance_options_default(), &carried);
    distance_result wanted = distance_find(c, d, distance_options_default(), NULL);
    same_bits(r.distance, wanted.distance);
}
END_TEST

// Rejects: an axis believed without a look at where the bodies are now; one that
// is not unit; one that hides what is not a number.
START_TEST(an_axis_that_parted_answers_first)
{
    unsigned long long seed = 47;
    distance_options o = distance_options_default();
    o.margin = 0.02;
    for (int n = 0; n < 500; n++) {
        body a, b;
        body_any(&a, n % 5, &seed);
        body_any(&b, n / 5 % 5, &seed);
        vec3 way = random_direction(&seed);
        body_move(&b, vec3_scale(3, way));
        distance_cache carried = { .count = 0 };
        distance_result r = distance_find(body_points(&a), body_points(&b), o,
                                    &carried);
        ck_assert_int_eq(r.status, DISTANCE_BEYOND);
        near(vec3_length(carried.axis), 1, rounding);
        // Further and further in: until the axis no longer parts them.
        for (int step = 0; step < 12; step++) {
            body_move(&b, vec3_scale(-0.25, way));
            real truth = ask(&a, &b).distance;
            distance_cache was = carried;
            r = distance_find(body_points(&a), body_points(&b), o, &carried);
            if (r.status != DISTANCE_BEYOND) {
                near(r.distance, truth, 4 * rounding);
                ck_assert(truth <= o.margin);
                same_bits(carried.axis.z, 0);   // nothing parted them
                continue;
            }
            ck_assert(r.distance > o.margin && r.distance <= truth + rounding);
            real gap = gap_along(body_points(&a), body_points(&b), was.axis);
            if (vec3_length(was.axis) > 0 && gap > 1.001 * o.margin) {
                near(r.distance, gap, 4 * rounding);
                ck_assert_int_eq(r.iterations, 1);
            }
        }
        body_move(&b, vec3_scale(3, way));
        distance_find(body_points(&a), body_points(&b), o, &carried);
        a.at[a.count - 1].y = (real)NAN;
        r = distance_find(body_points(&a), body_points(&b), o, &carried);
        ck_assert_int_eq(r.status, DISTANCE_NOT_FINITE);
    }
}
END_TEST

// Far out, heights along the axis are rough.  Rejects: a bound that does not
// take that off, and so promises a micrometre too much.
START_TEST(an_axis_promises_too_little_rather_than_too_much)
{
    unsigned long long seed = 59;
    distance_options o = distance_options_default();
    o.margin = 0.02;
    for (int n = 0; n < 2000; n++) {
        body a, b;
        body_any(&a, n % 3, &seed);
        body_any(&b, n / 3 % 3, &seed);
        vec3 way = random_direction(&seed);
        vec3 far = vec3_scale(ldexp(1, n % 40), random_direction(&seed));
        body_move(&b, vec3_scale(2.5, way));
        body_move(&a, far);
        body_move(&b, far);
        distance_cache carried = { .count = 0 };
        distance_find(body_points(&a), body_points(&b), o, &carried);
        distance_result r = distance_find(body_points(&a), body_points(&b), o,
                                    &carried);
        real gap = gap_along(body_points(&a), body_points(&b), carried.axis);
        ck_assert(r.status != DISTANCE_BEYOND || r.distance <= gap + rounding);
        if (n % 40 < 10) ck_assert_int_eq(r.status, DISTANCE_BEYOND);
    }
}
END_TEST

// Rejects: a start that is no better than any corner (which takes 5).
START_TEST(three_first_corners_are_mostly_near)
{
    unsigned long long seed = 61;
    int asked = 0, pairs = 2000;
    for (int n = 0; n < pairs; n++) {
        body a, b;
        body_icosahedron(&a, 0.5);
        b = a;
        body_turn(&a, &seed);
        body_turn(&b, &seed);
        body_move(&b, random_vector(&seed, 1.02, 1.5));
        asked += ask(&a, &b).iterations;
    }
    ck_assert_int_lt(asked, 3 * pairs);
}
END_TEST

// Rejects: a sketch that is taken for the body; a start from one that leaves
// half of the way to the climbs (which took 7.5).
START_TEST(large_bodies_are_sketched_first)
{
    unsigned long long seed = 53;
    int asked = 0, pairs = 200;
    for (int n = 0; n < pairs; n++) {
        static body a, b;
        body_icosphere(&a, 2 + n % 2, 0.5);
        body_icosphere(&b, 2 + n / 2 % 2, 0.5);
        body_turn(&a, &seed);
        body_turn(&b, &seed);
        body_move(&b, random_vector(&seed, 0.9, 1.4));
        point_set pa = body_points(&a), pb = body_points(&b);
        distance_result climbed = distance_find(pa, pb, distance_options_default(), NULL);
        pa.ring = pb.ring = NULL;
        distance_result scanned = distance_find(pa, pb, distance_options_default(), NULL);
        ck_assert_int_eq(climbed.status, scanned.status);
        near(climbed.distance, scanned.distance, rounding);
        asked += climbed.iterations;
    }
    ck_assert_int_lt(asked, 6 * pairs);
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
        distance_cache stale = { .count = 1 + n % 4 };
        for (int c = 0; c < stale.count; c++) {
            stale.a[c] = (int)(a.count * random_unit(&seed));
            stale.b[c] = (int)(b.count * random_unit(&seed));
            stale.weight[c] = 1;
        }
        distance_result cold = ask(&a, &b);
        distance_result warm = distance_find(body_points(&a), body_points(&b),
                                       distance_options_default(), &stale);
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
    distance_options o = distance_options_default();
    o.margin = 0.1;
    for (int n = 0; n < 1000; n++) {
        body a, b;
        body_any(&a, n % 3, &seed);
        body_any(&b, n / 3 % 3, &seed);
        body_move(&b, random_vector(&seed, 0, 2.5));
        distance_result full = ask(&a, &b);
        distance_result r = distance_find(body_points(&a), body_points(&b), o, NULL);
        if (full.distance < 0.1) {
            ck_assert_int_eq(r.status, full.status);
            near(r.distance, full.distance, rounding);
            continue;
        }
        beyond++;
        ck_assert_int_eq(r.status, DISTANCE_BEYOND);
        ck_assert(r.distance > 0.1 && r.distance <= full.distance + rounding);
        ck_assert_int_le(r.iterations, full.iterations);
        // The axis parts them by at least that much.
        real parted = -(real)oracle_width(body_hull(&a), body_hull(&b),
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
        distance_options o = distance_options_default();
        o.relative_error = bound[n % 4];
        distance_result exact = ask(&a, &b);
        distance_result r = distance_find(body_points(&a), body_points(&b), o, NULL);
        if (exact.status != DISTANCE_APART) continue;
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
    distance_result full = ask(&a, &b);
    ck_assert_int_gt(full.iterations, 2);
    real before = HUGE_VAL;
    for (int cap = 1; cap <= full.iterations; cap++) {
        distance_options o = distance_options_default();
        o.cap = cap;
        distance_result r = distance_find(body_points(&a), body_points(&b), o, NULL);
        ck_assert_int_le(r.iterations, cap);
        // What is so far: never worse with more, and a point of A - B.
        ck_assert(r.distance <= before && r.distance >= full.distance);
        near(vec3_distance(r.on_a, r.on_b), r.distance, rounding);
        ck_assert(r.status == DISTANCE_CAPPED || cap == full.iterations);
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
        distance_result r = ask(&a, &b);
        ck_assert(r.status == DISTANCE_APART || r.status == DISTANCE_OVERLAP);
        ck_assert_int_le(r.iterations, 20);
        ck_assert(r.distance < 1e-14);
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
        distance_result climbed = ask(&a, &b);
        a.has_ring = b.has_ring = 0;
        distance_result scanned = ask(&a, &b);
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
                    distance_result r = ask(&a, &b), s = ask(&b, &a);
                    ck_assert_int_eq(r.status, DISTANCE_NOT_FINITE);
                    ck_assert_int_eq(s.status, DISTANCE_NOT_FINITE);
                    same_bits(r.distance, 0);
                    ck_assert_int_eq(r.last.count, 0);
                }
}
END_TEST

// ---- what the fuzzer found

// Rejects: directions whose products with the vertices overflow or vanish.
START_TEST(the_ends_of_the_range_of_numbers_are_served)
{
    // Steps of the smallest double: cubes of 16 steps, 3 apart.
    body a = body_cube(0, 0, 0), b = body_cube(1.1875, 0, 0);
    body_scale(&a, 0x1p-1070);
    body_scale(&b, 0x1p-1070);
    distance_result r = ask(&a, &b);
    ck_assert_int_eq(r.status, DISTANCE_APART);
    same_bits(r.distance, 0x1p-1070 * 0.1875);

    a = body_cube(0, 0, 0), b = body_cube(1.25, 0, 0);
    body_scale(&a, 0x1p1015);
    body_scale(&b, 0x1p1015);
    same_bits(ask(&a, &b).distance, 0x1p1013);
    body_scale(&b, 64);     // beyond 2^1020: the distance may be no number
    r = ask(&a, &b);
    ck_assert_int_eq(r.status, DISTANCE_NOT_FINITE);
    same_bits(r.distance, 0);
}
END_TEST

// Rejects: the bound of the step before, given out with the status.
START_TEST(what_is_met_late_leaves_no_number)
{
    const real end = 0x1.fffffffffffffp1023;
    vec3 at[3] = { { 1, 0, 0 }, { 0.5, 1, 0 }, { 1, -end, 0 } };
    vec3 o = { 0, 0, 0 };
    point_set a = { at, 3, NULL, NULL }, b = { &o, 1, NULL, NULL };
    distance_cache carried = { .count = 1, .weight = { 1 } };
    distance_result r = distance_find(a, b, distance_options_default(), &carried);
    ck_assert_int_eq(r.status, DISTANCE_NOT_FINITE);
    ck_assert_int_gt(r.iterations, 1);
    same_bits(r.distance, 0);
    same_bits(r.axis.x, 0);
    ck_assert_int_eq(r.last.count, 0);
}
END_TEST

// Rejects: "the largest so far", which forgets a NaN: then no weight need be
// positive, and the simplex has no corner.
START_TEST(a_bad_corner_among_carried_ones_is_not_forgotten)
{
    const real poison[3] = { (real)NAN, HUGE_VAL, -HUGE_VAL };
    for (int n = 0; n < 4 * 4 * 27; n++) {
        vec3 at[4] = { { 1, 0, 0 }, { 1, 1, 0 }, { 2, 0, 1 }, { 1, 2, 2 } };
        vec3 o = { 0, 0, 0 };
        int bad = n % 4, first = n / 4 % 4;
        at[bad] = (vec3){ 0, 0, poison[n / 16 % 3] };
        at[(bad + 1) % 4] = (vec3){ poison[n / 48 % 3], poison[n / 144 % 3],
                                    1 };
        point_set a = { at, 4, NULL, NULL }, b = { &o, 1, NULL, NULL };
        for (int count = 1; count <= 4; count++) {
            distance_cache carried = { .count = count };
            for (int c = 0; c < count; c++) carried.a[c] = (first + c) % 4;
            distance_result r = distance_find(a, b, distance_options_default(), &carried);
            ck_assert_int_eq(r.status, DISTANCE_NOT_FINITE);
            ck_assert_int_eq(r.last.count, 0);
        }
    }
}
END_TEST

// From a corner of usual size the next is one whose square is no number.
START_TEST(a_far_corner_may_come_second)
{
    vec3 at[2] = { { 1, 0, 0 }, { -0x1p600, 0x1p600, 0 } }, o = { 0, 0, 0 };
    point_set a = { at, 2, NULL, NULL }, b = { &o, 1, NULL, NULL };
    distance_cache carried = { .count = 1 };
    distance_result r = distance_find(a, b, distance_options_default(), &carried);
    ck_assert(r.status == DISTANCE_APART || r.status == DISTANCE_OVERLAP);
    ck_assert(r.distance <= 1);
}
END_TEST

// Three corners in line but for rounding have no plane.  Rejects: a foot on it,
// 25 m from all of them, and so a distance of 2e-13 m.
START_TEST(a_triangle_without_a_plane_has_no_foot)
{
    vec3 p[2] = { { 4.9999999999994689, 4.999999999999428, 4.9999999999993872 },
                  { 4.9999999999995914, 4.9999999999995506,
                    4.9999999999995097 } };
    vec3 q[2] = { { -32, -32, -32 },
                  { -9.25, -9.2499999999999236, -9.2499999999998472 } };
    point_set a = { p, 2, NULL, NULL }, b = { q, 2, NULL, NULL };
    distance_cache carried = { .count = 3, .a = { 0, 1, 0 }, .b = { 0, 1, 1 } };
    distance_result r = distance_find(a, b, distance_options_default(), &carried);
    ck_assert_int_eq(r.status, DISTANCE_APART);
    near(r.distance, vec3_distance(p[0], q[1]), 1e-11);
    near(vec3_distance(r.on_a, r.on_b), r.distance, 1e-11);
}
END_TEST

// A square of 7e-9 m over one of 28 m.  Rejects: an end as soon as a step gains
// nothing, with a sixth of the distance to go.
START_TEST(a_step_that_gains_nothing_may_be_on_the_way)
{
    vec3 large[4] = {
        { -19.161808558681052, -13.456259470345898, -31.06182769103108 },
        { -47.801560216008681, -22.335465632163135, -25.298710272142699 },
        { -16.198439769908259, -41.664534353753808, -38.701289713774244 },
        { -44.838191427235891, -50.543740515571045, -32.93817229488586 } };
    vec3 small[4];
    for (int i = 0; i < 4; i++)
        small[i] = (vec3){ i & 1 ? -31.999999989437708 : -31.999999996479236,
                           i & 2 ? -31.999999989437708 : -31.999999996479236,
                           -32 };
    point_set a = { large, 4, NULL, NULL }, b = { small, 4, NULL, NULL };
    distance_result r = distance_find(a, b, distance_options_default(), NULL);
    ck_assert_int_eq(r.status, DISTANCE_APART);
    near(r.distance, (real)oracle_distance(hull_of(a), hull_of(b)), 1e-14 * 28);
    ck_assert_int_le(r.iterations, 20);
}
END_TEST

// Two thin bodies as near as rounding can tell.  Rejects: steps that gain and
// lose by turns, until the cap.
START_TEST(steps_that_gain_nothing_are_counted)
{
    vec3 p[2] = { { -32, -32.000000000000902, -32.000000000000639 },
                  { -32.000000000000774, -32.000000000001116,
                    -32.000000000000838 } };
    vec3 q[4] = {
        { -44.370739812370473, -20.597419159857139, -16.869040126990139 },
        { -18.71552942578051, -13.895287853877079, -34.782488035676685 },
        { -45.284470574220769, -50.10471214612447, -29.217511964324334 },
        { -19.629260187630809, -43.40258084014441, -47.13095987301088 } };
    point_set a = { p, 2, NULL, NULL }, b = { q, 4, NULL, NULL };
    distance_result r = distance_find(a, b, distance_options_default(), NULL);
    ck_assert(r.status == DISTANCE_APART || r.status == DISTANCE_OVERLAP);
    ck_assert_int_le(r.iterations, 20);
    ck_assert(r.distance < 1e-14 * 32);
}
END_TEST

// Bodies that are apart by a few roundings, and v has no direction to speak of.
// Rejects: v for the axis all the same, which put two fifths of B before A.
START_TEST(the_axis_parts_what_is_apart)
{
    vec3 p = { 0x1.66p+5, 0x1.6600000000036p+5, 0x1.6600000000041p+5 };
    vec3 q[5] = {
        { 0x1.6600000000077p+5, 0x1.66000000000adp+5, 0x1.66000000000e3p+5 },
        { 48, 48, 48 }, { 48, 0x1.66p+5, 0x1.6600000000036p+5 },
        { 0x1.660000000006cp+5, 0x1.6600000000019p+5, -8 }, { -8, -8, -8 } };
    point_set a = { &p, 1, NULL, NULL }, b = { q, 5, NULL, NULL };
    distance_result r = distance_find(a, b, distance_options_default(), NULL);
    ck_assert_int_eq(r.status, DISTANCE_APART);
    ck_assert(r.distance > 0 && r.distance < 1e-14 * 52.75);
    near(vec3_length(r.axis), r.distance, 1e-27);
    // How far B reaches over A along the axis.
    ck_assert((real)oracle_width(hull_of(b), hull_of(a), r.axis) < 1e-14 * 52.75);
}
END_TEST

// 1e33 m off, where a body reaches to 1e209 m: touching, for any purpose.
// Rejects: a direction scaled until nothing is left of it.
START_TEST(what_vanishes_beside_the_body_touches)
{
    vec3 p = { -31.5, -31.5, -37.25 };
    vec3 q[3] = { { -37.25, -9.25e32, -9.25e32 },
                  { -9.25e32, -9.25e32, 2.75e209 }, { -64, -64, -64 } };
    point_set a = { &p, 1, NULL, NULL }, b = { q, 3, NULL, NULL };
    distance_result r = distance_find(a, b, distance_options_default(), NULL);
    ck_assert_int_eq(r.status, DISTANCE_OVERLAP);
    same_bits(r.distance, 0);
}
END_TEST

// A vertex at the end of all numbers.  Rejects: its height over a plane, no
// number, taken for no vertex: -1.
START_TEST(a_height_that_is_no_number_shows_nothing)
{
    const real end = 0x1.fffffffffffffp1023;
    vec3 p[3] = { { -9.5, -9.5, -9.5 }, { -9.5, end, -9.5 },
                  { -9.5, 30.25, -26.5 } };
    vec3 q[6] = { { -26.5, -9.5, -9.5 }, { -9.5, -9.5, -9.4999999999999183 },
                  { -9.25, -9.2499999999999236, -9.2499999999998472 },
                  { -9.2499999999995843, -32, -32 }, { -32, -32, -32 },
                  { -32, -31.999999999999737, -31.999999999999474 } };
    point_set a = { p, 3, NULL, NULL }, b = { q, 6, NULL, NULL };
    distance_cache carried = { .count = 1, .b = { 1 } };
    distance_result r = distance_find(a, b, distance_options_default(), &carried);
    ck_assert(r.distance <= 1e-13);
    carried = (distance_cache){ .count = 1, .a = { 1 } };
    r = distance_find(b, a, distance_options_default(), &carried);
    ck_assert(r.distance <= 1e-13);
}
END_TEST

// Rejects: parts of a segment, rounded by its distance, taken for weights.
START_TEST(weights_add_up_however_far_a_short_segment_is)
{
    vec3 p[2] = { { -31.999999992958472, -32.000001168489177,
                    -32.000001895007117 },
                  { -32.000001895007117, -31.999999992958472,
                    -32.000001168489177 } };
    vec3 q = { -64, -64, -64 };
    point_set a = { p, 2, NULL, NULL }, b = { &q, 1, NULL, NULL };
    distance_result r = distance_find(a, b, distance_options_default(), NULL);
    ck_assert_int_eq(r.last.count, 2);
    near(r.last.weight[0] + r.last.weight[1], 1, 1e-15);
}
END_TEST

// ---- the same bits

// The number was printed by this test itself; gcc and clang agree on it at -O0,
// -O2 and -O3.  A change of it is a change of answers.
static const unsigned long long known_digest = 0x2f0ca092068b6ed1ULL;

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
    tcase_add_test(t, the_fast_distance_is_the_plain_one);
    tcase_add_test(t, the_gap_is_a_certificate);
    tcase_add_test(t, swapped_bodies_give_the_mirror_image);
    tcase_add_test(t, carried_equals_cold);
    tcase_add_test(t, a_carried_simplex_serves_bodies_of_any_size);
    tcase_add_test(t, far_out_a_carried_corner_is_not_believed);
    tcase_add_test(t, an_axis_that_parted_answers_first);
    tcase_add_test(t, an_axis_promises_too_little_rather_than_too_much);
    tcase_add_test(t, three_first_corners_are_mostly_near);
    tcase_add_test(t, large_bodies_are_sketched_first);
    tcase_add_test(t, a_stale_simplex_does_no_harm);
    tcase_add_test(t, beyond_the_margin_it_stops_early_with_a_true_bound);
    tcase_add_test(t, the_relative_error_is_kept);
    tcase_add_test(t, the_cap_is_honoured);
    tcase_add_test(t, sixty_four_is_never_reached);
    tcase_add_test(t, a_ring_changes_nothing_but_the_time);
    tcase_add_test(t, what_is_not_finite_gets_a_status);
    tcase_add_test(t, the_ends_of_the_range_of_numbers_are_served);
    tcase_add_test(t, what_is_met_late_leaves_no_number);
    tcase_add_test(t, a_bad_corner_among_carried_ones_is_not_forgotten);
    tcase_add_test(t, a_far_corner_may_come_second);
    tcase_add_test(t, a_triangle_without_a_plane_has_no_foot);
    tcase_add_test(t, a_step_that_gains_nothing_may_be_on_the_way);
    tcase_add_test(t, steps_that_gain_nothing_are_counted);
    tcase_add_test(t, the_axis_parts_what_is_apart);
    tcase_add_test(t, what_vanishes_beside_the_body_touches);
    tcase_add_test(t, a_height_that_is_no_number_shows_nothing);
    tcase_add_test(t, weights_add_up_however_far_a_short_segment_is);
    if (bits_are_ours()) tcase_add_test(t, the_same_bits_everywhere);
    suite_add_tcase(suite, t);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
