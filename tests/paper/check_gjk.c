// check_gjk.c - tests of lib/paper/gjk: distances, proofs, and the hard cases.
//
// No test asks for our bits, for our number of iterations or for our choice
// among equal answers: any right GJK passes.

#include "bodies.h"
#include "expect.h"
#include "gjk.h"
#include "known_pairs.h"
#include "oracle.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

// m: some dozens of roundings of coordinates up to 4, 4.4e-16 each at most.
static const real ROUNDING = 2e-14;
// Of the bodies' size: as near to touching as no query has to tell from touch.
static const real NEAR_TOUCH = 1e-11;

static gjk_result ask(const body *a, const body *b)
{
    return gjk_distance(body_hull(a), body_hull(b), HUGE_VAL, NULL);
}

// Bodies that are not hard: a search that leaves them to 106 bits is wrong in its
// own doubles, and slow.
static gjk_result ask_plain(const body *a, const body *b)
{
    gjk_result r = ask(a, b);
    ck_assert_msg(!r.wide, "the search in doubles gave no answer that it can "
                  "prove, of bodies as plain as these: it lost its way");
    return r;
}

// Which corner stands first in a simplex decides the last digits of its normal.
// So a right search may leave one random pair in a thousand to 106 bits, and not
// the one that another right search leaves.
static void check_doubles(int wide, int pairs)
{
    ck_assert_msg(wide <= 1 + pairs / 1000, "of %d plain pairs the search in doubles "
                  "lost its way in %d: its answer could not be proven", pairs,
                  wide);
}

// ---- support and areas

START_TEST(support_is_the_highest_vertex_less_the_lowest)
{
    unsigned long long seed = 1;
    for (int n = 0; n < 500; n++) {
        body a, b;
        body_any(&a, n % 5, &seed);
        body_any(&b, n / 5 % 5, &seed);
        vec3 d = random_vector(&seed, 0.1, 3);
        corner c = hull_support(body_hull(&a), body_hull(&b), d);
        near_vec3(c.at, vec3_sub(a.at[c.a], b.at[c.b]), 0);
        for (int i = 0; i < a.count; i++)
            for (int k = 0; k < b.count; k++)
                ck_assert(vec3_dot(d, vec3_sub(a.at[i], b.at[k]))
                          <= vec3_dot(d, c.at) + ROUNDING);
    }
}
END_TEST

// Rejects: heights over the world's origin, which are all rounding out there.
START_TEST(support_sees_a_nanometre_a_thousand_kilometres_away)
{
    vec3 at[3] = { { 1e6, 0, 7 }, { 1e6, 1e-9, 7 }, { 1e6, -1e-9, 7 } };
    vec3 origin = { 0, 0, 0 };
    hull a = { at, 3 }, b = { &origin, 1 };
    vec3 d = { 0.6, 1e-3, -0.8 }, back = { 0.6, -1e-3, -0.8 };
    ck_assert_int_eq(hull_support(a, b, d).a, 1);
    ck_assert_int_eq(hull_support(a, b, back).a, 2);
    ck_assert_int_eq(hull_support(b, a, d).b, 2);
}
END_TEST

START_TEST(a_normal_is_twice_the_area_long_and_right_handed)
{
    vec3 a = { 1, 1, 5 }, b = { 4, 1, 5 }, c = { 1, 3, 5 };
    near_vec3(triangle_normal(a, b, c), (vec3){ 0, 0, 6 }, ROUNDING);
    near_vec3(triangle_normal(a, c, b), (vec3){ 0, 0, -6 }, ROUNDING);
    near_vec3(triangle_normal(a, b, b), (vec3){ 0, 0, 0 }, 0);
    near_vec3(triangle_normal(a, a, a), (vec3){ 0, 0, 0 }, 0);
}
END_TEST

// Two long edges at an angle of 1e-10, the third edge long or short: the height
// of the triangle is rounding, its length is not.  Rejects: the cross product
// as it comes.
START_TEST(the_normal_of_a_thin_triangle_is_upright_on_it)
{
    unsigned long long seed = 4;
    for (int n = 0; n < 600; n++) {
        vec3 e = random_direction(&seed), side = random_direction(&seed);
        vec3 p[3] = { random_vector(&seed, 0.1, 1) };
        p[1] = vec3_add(p[0], e);
        p[2] = vec3_add_scaled(vec3_add_scaled(p[0], n % 2 ? 1 : 0.7, e),
                               1e-10, side);
        vec3 normal = triangle_normal(p[n % 3], p[(n + 1) % 3], p[(n + 2) % 3]);
        near(vec3_dot(vec3_unit(normal), e), 0, 1e-14);
    }
}
END_TEST

// (0, 0) is 0.5 a + 0.2 b + 0.3 c, seen from 7 m above.
START_TEST(weights_of_a_triangle_are_barycentric)
{
    vec3 a = { -1, -1, 7 }, b = { 4, -0.5, 7 }, c = { -1, 2, 7 };
    vec3 n = triangle_normal(a, b, c);
    real w[3];
    triangle_weigh(n, a, b, c, w);
    real sum = w[0] + w[1] + w[2];
    ck_assert(sum > 0);
    near(w[0] / sum, 0.5, ROUNDING);
    near(w[1] / sum, 0.2, ROUNDING);
    near(w[2] / sum, 0.3, ROUNDING);
    // Turned over, with its own normal: the same.
    triangle_weigh(triangle_normal(a, c, b), a, c, b, w);
    near(w[2] / sum, 0.2, ROUNDING);
    // Beyond an edge one of them is negative.
    vec3 away = { -3, 0, 0 };
    triangle_weigh(n, vec3_sub(a, away), vec3_sub(b, away), vec3_sub(c, away),
                   w);
    ck_assert(w[1] < 0 && w[0] > 0 && w[2] > 0);
}
END_TEST

// ---- answers that can be had by hand

START_TEST(two_points_are_as_far_as_they_are)
{
    vec3 p = { 1, 2, 3 }, q = { 4, 6, 3 };
    hull a = { &p, 1 }, b = { &q, 1 };
    gjk_result r = gjk_distance(a, b, HUGE_VAL, NULL);
    ck_assert_int_eq(r.status, GJK_APART);
    near(r.distance, 5, 0);
    near_vec3(r.axis, (vec3){ -3, -4, 0 }, 0);    // rejects: from A to B
    near_vec3(r.on_a, p, 0);
    near_vec3(r.on_b, q, 0);
    ck_assert_int_eq(r.last.count, 1);
    near(r.last.weight[0], 1, 0);
}
END_TEST

START_TEST(a_point_on_itself_overlaps)
{
    vec3 p = { 1e7, -3, 0.1 };
    hull a = { &p, 1 };
    gjk_result r = gjk_distance(a, a, HUGE_VAL, NULL);
    ck_assert_int_eq(r.status, GJK_OVERLAP);
    near(r.distance, 0, 0);
    near_vec3(r.on_a, p, 0);
}
END_TEST

START_TEST(crossing_segments_are_their_gap_apart)
{
    vec3 s[2] = { { -1, 0, 0 }, { 1, 0, 0 } };
    vec3 t[2] = { { 0.5, -1, 0.25 }, { 0.5, 1, 0.25 } };
    hull a = { s, 2 }, b = { t, 2 };
    gjk_result r = gjk_distance(a, b, HUGE_VAL, NULL);
    near(r.distance, 0.25, ROUNDING);
    near_vec3(r.on_a, (vec3){ 0.5, 0, 0 }, ROUNDING);
    near_vec3(r.on_b, (vec3){ 0.5, 0, 0.25 }, ROUNDING);
}
END_TEST

// Two unit cubes, one moved along 1, 2 and 3 axes: face, edge, vertex apart.
START_TEST(boxes_face_edge_and_vertex_apart)
{
    body a = body_cube(0, 0, 0), f = body_cube(2, 0.25, 0.125);
    body e = body_cube(2, 2, 0.25), v = body_cube(2, -2, 2);
    near(ask_plain(&a, &f).distance, 1, ROUNDING);
    near(ask_plain(&a, &e).distance, sqrt(2.0), ROUNDING);
    near(ask_plain(&a, &v).distance, sqrt(3.0), ROUNDING);
    near_vec3(ask_plain(&a, &v).axis, (vec3){ -1, 1, -1 }, ROUNDING);
}
END_TEST

START_TEST(exact_touch_is_overlap)
{
    body a = body_cube(0, 0, 0), f = body_cube(1, 0.25, 0.125);
    body e = body_cube(1, 1, 0.25), v = body_cube(-1, 1, 1);
    ck_assert_int_eq(ask_plain(&a, &f).status, GJK_OVERLAP);
    ck_assert_int_eq(ask_plain(&a, &e).status, GJK_OVERLAP);
    ck_assert_int_eq(ask_plain(&a, &v).status, GJK_OVERLAP);
}
END_TEST

START_TEST(identical_and_concentric_cubes_overlap)
{
    body a = body_cube(0.1, 0.2, 0.3), c = body_cube(0, 0, 0), small = c;
    body_scale(&small, 1e-4);
    ck_assert_int_eq(ask(&a, &a).status, GJK_OVERLAP);
    ck_assert_int_eq(ask(&c, &small).status, GJK_OVERLAP);
    ck_assert_int_eq(ask(&small, &c).status, GJK_OVERLAP);
    near(ask(&small, &c).distance, 0, 0);
}
END_TEST

START_TEST(a_point_is_inside_or_outside_a_cube)
{
    body c = body_cube(0, 0, 0);
    vec3 in = { 0.49, -0.3, 0.2 }, out = { 0.3, 0.2, 0.75 };
    hull p = { &in, 1 }, q = { &out, 1 }, cube = body_hull(&c);
    gjk_result r = gjk_distance(p, cube, HUGE_VAL, NULL);
    ck_assert_int_eq(r.status, GJK_OVERLAP);
    near_vec3(r.on_a, in, ROUNDING);
    near_vec3(r.on_b, in, ROUNDING);
    r = gjk_distance(q, cube, HUGE_VAL, NULL);
    near(r.distance, 0.25, ROUNDING);
    near_vec3(r.on_b, (vec3){ 0.3, 0.2, 0.5 }, ROUNDING);
}
END_TEST

// Two balls of points: the gap along the line of two opposite vertices.
START_TEST(balls_of_points_are_apart_by_the_gap)
{
    static body a, b;
    body_icosphere(&a, 2, 0.5);
    b = a;
    vec3 tip = a.at[0];     // the opposite vertex exists: a ball is symmetric
    body_move(&b, vec3_scale(2.5, tip));
    near(ask(&a, &b).distance, 0.25, ROUNDING);
}
END_TEST

// ---- proofs

// All that the header promises of an answer, whatever the bodies.
static void check_answer(const body *a, const body *b, gjk_result r)
{
    vec3 at[2] = { { 0, 0, 0 }, { 0, 0, 0 } };
    real sum = 0;
    ck_assert(r.status == GJK_APART || r.status == GJK_OVERLAP);
    ck_assert(r.last.count >= 1 && r.last.count <= 4);
    for (int c = 0; c < r.last.count; c++) {
        real w = r.last.weight[c];
        at[0] = vec3_add_scaled(at[0], w, a->at[r.last.of[c].a]);
        at[1] = vec3_add_scaled(at[1], w, b->at[r.last.of[c].b]);
        near_vec3(r.last.of[c].at, vec3_sub(a->at[r.last.of[c].a],
                                              b->at[r.last.of[c].b]), 0);
        ck_assert(w > 0);
        sum += w;
    }
    near(sum, 1, ROUNDING);
    near_vec3(r.on_a, at[0], ROUNDING);
    near_vec3(r.on_b, at[1], 100 * ROUNDING);
    near_vec3(vec3_sub(r.on_a, r.on_b), r.axis, ROUNDING);
    near_vec3(r.last.v, r.axis, 0);
    near(r.distance, r.status == GJK_OVERLAP ? 0 : vec3_length(r.axis),
         ROUNDING);
}

// Proof without a reference: v = on_a - on_b is a point of A - B, and no point
// of A - B lies below the plane through it.  Rejects: the wrong side kept.
START_TEST(upper_and_lower_bound_agree)
{
    unsigned long long seed = 7;
    int apart = 0, wide = 0;
    for (int n = 0; n < 4000; n++) {
        body a, b;
        pair_any(&a, &b, n, 5, 0, 2.5, &seed);
        gjk_result r = ask(&a, &b);
        wide += r.wide;
        check_answer(&a, &b, r);
        if (r.status != GJK_APART) continue;
        apart++;
        real lowest = -width_along(&a, &b, r.axis);
        ck_assert(lowest >= r.distance - ROUNDING);
    }
    ck_assert_int_ge(apart, 1500);
    check_doubles(wide, 4000);
}
END_TEST

START_TEST(random_pairs_agree_with_every_pair_of_features)
{
    unsigned long long seed = 2005;
    int apart = 0;
    for (int n = 0; n < 1500; n++) {
        body a, b;
        pair_any(&a, &b, n, 5, 0, 3, &seed);
        if (a.count * b.count > 100) continue;       // the oracle is slow
        gjk_result r = ask(&a, &b);
        if (r.status != GJK_APART) continue;
        apart++;
        near(r.distance, true_distance(&a, &b), 1e-13);
    }
    ck_assert_int_ge(apart, 500);
}
END_TEST

// Overlap must be right, too: moved out by a little more than its depth, a body
// is apart by that little; moved by less, it is not.  Depths are the oracle.s.
START_TEST(overlap_ends_where_the_depth_says)
{
    unsigned long long seed = 8;
    int tried = 0;
    for (int n = 0; n < 300; n++) {
        body a, b;
        body_random(&a, 6, &seed);
        body_random(&b, 5, &seed);
        body_move(&b, random_vector(&seed, 0, 1));
        if (ask(&a, &b).status != GJK_OVERLAP) continue;
        tried++;
        real depth = true_depth(&a, &b);
        vec3 way = random_direction(&seed);
        body_move(&a, vec3_scale(0.99 * depth, way));
        ck_assert_int_eq(ask(&a, &b).status, GJK_OVERLAP);
        real width = width_along(&a, &b, way);
        body_move(&a, vec3_scale(width + 1e-6, way));
        ck_assert_int_eq(ask(&a, &b).status, GJK_APART);
    }
    ck_assert_int_ge(tried, 100);
}
END_TEST

static int known_apart;

static void judge_distance(const pair_known *p)
{
    gjk_result r = ask(&p->a, &p->b);
    bool is_clear = p->value > NEAR_TOUCH * pair_size(&p->a, &p->b);
    if (p->kind == 'P' && is_clear)
        ck_assert_msg(r.status == GJK_OVERLAP, "%s: apart", p->family);
    if (p->kind != 'S') return;
    known_apart++;
    expect_known(p, r.distance);
    if (is_clear) ck_assert_int_eq(r.status, GJK_APART);
}

START_TEST(stored_pairs_have_their_exact_distance)
{
    each_known_pair(judge_distance);
    ck_assert_int_ge(known_apart, 400);
}
END_TEST

START_TEST(swapped_bodies_give_the_mirror_image)
{
    unsigned long long seed = 31;
    for (int n = 0; n < 500; n++) {
        body a, b;
        pair_any(&a, &b, n, 5, 2.5, 2.5, &seed);
        gjk_result there = ask(&a, &b), back = ask(&b, &a);
        ck_assert_int_eq(there.status, back.status);
        near(there.distance, back.distance, ROUNDING);
        near_vec3(there.axis, vec3_scale(-1, back.axis), 1e-6);
    }
}
END_TEST

// ---- the carried simplex

START_TEST(a_carried_simplex_changes_no_answer)
{
    unsigned long long seed = 12;
    for (int n = 0; n < 300; n++) {
        body a, b;
        simplex carried = { .count = 0 };
        pair_any(&a, &b, n, 5, 0, 2, &seed);
        for (int frame = 0; frame < 8; frame++) {
            gjk_result r = gjk_distance(body_hull(&a), body_hull(&b), HUGE_VAL,
                                        &carried), cold = ask(&a, &b);
            check_answer(&a, &b, r);
            ck_assert_int_eq(r.status, cold.status);
            near(r.distance, cold.distance, ROUNDING);
            ck_assert_int_eq(carried.count, r.last.count);
            body_move(&b, random_vector(&seed, 0, 0.1));
        }
    }
}
END_TEST

// Rejects: corners left where they were, and weights that are never renewed.
START_TEST(a_stale_simplex_does_no_harm)
{
    unsigned long long seed = 13;
    int wide = 0;
    for (int n = 0; n < 300; n++) {
        body a, b;
        simplex carried = { .count = 0 };
        body_random(&a, 8, &seed);
        body_random(&b, 8, &seed);
        body_move(&b, random_vector(&seed, 0, 0.5));
        gjk_distance(body_hull(&a), body_hull(&b), HUGE_VAL, &carried);
        body_turn(&a, &seed);
        body_turn(&b, &seed);
        body_move(&b, random_vector(&seed, 0, 3));
        gjk_result r = gjk_distance(body_hull(&a), body_hull(&b), HUGE_VAL,
                                    &carried);
        wide += r.wide;
        check_answer(&a, &b, r);
        near(r.distance, ask(&a, &b).distance, ROUNDING);
    }
    check_doubles(wide, 300);
}
END_TEST

// All the corners carried may lie within rounding of the origin, and the bodies
// be large.  Rejects: a size of the bodies that only those corners tell, and
// with it, of bodies that all but touch, an axis that does not part them.
START_TEST(carried_corners_at_the_origin_hide_no_size)
{
    unsigned long long seed = 19;
    int apart = 0;
    for (int n = 0; n < 20000; n++) {
        body a = { .count = 3 }, b = { .count = 6 };
        simplex carried = { .count = 4 };
        for (int k = 0; k < 9; k++)
            *(k < 3 ? &a.at[k] : &b.at[k - 3])
                = random_vector(&seed, 0, k > 6 ? 8 : 1e-14);
        for (int c = 0; c < 4; c++)
            carried.of[c] = (corner){ .a = c % 3, .b = (n + c / 2) % 4 };
        gjk_result r = gjk_distance(body_hull(&a), body_hull(&b), HUGE_VAL,
                                    &carried);
        long double parts = -oracle_width(body_hull(&b), body_hull(&a), r.axis);
        ck_assert(r.status == GJK_APART || r.status == GJK_OVERLAP);
        if (r.status == GJK_OVERLAP) continue;
        ck_assert_msg(parts >= -1e-10L, "overlap by %Lg m along it", -parts);
        apart++;
    }
    ck_assert_int_gt(apart, 5);
}
END_TEST

START_TEST(carried_it_asks_for_fewer_corners)
{
    unsigned long long seed = 14;
    int cold = 0, warm = 0;
    for (int n = 0; n < 200; n++) {
        body a, b;
        simplex carried = { .count = 0 };
        body_icosahedron(&a, 0.5);
        b = a;
        body_turn(&a, &seed);
        body_turn(&b, &seed);
        body_move(&b, random_vector(&seed, 1.1, 1.2));
        cold += gjk_distance(body_hull(&a), body_hull(&b), HUGE_VAL,
                             &carried).iterations;
        body_move(&b, random_vector(&seed, 0, 0.002));
        warm += gjk_distance(body_hull(&a), body_hull(&b), HUGE_VAL,
                             &carried).iterations;
    }
    ck_assert_int_lt(2 * warm, cold);
}
END_TEST

// ---- the margin

START_TEST(beyond_the_margin_there_is_a_true_bound)
{
    unsigned long long seed = 15;
    int beyond = 0;
    for (int n = 0; n < 2000; n++) {
        body a, b;
        pair_any(&a, &b, n, 5, 0, 3, &seed);
        real margin = n % 3 * 0.1, truth = ask(&a, &b).distance;
        gjk_result r = gjk_distance(body_hull(&a), body_hull(&b), margin, NULL);
        if (truth > margin + ROUNDING && n % 3 != 0)
            ck_assert_int_eq(r.status, GJK_BEYOND);
        if (truth <= margin) ck_assert_int_ne(r.status, GJK_BEYOND);
        if (r.status != GJK_BEYOND) {
            near(r.distance, truth, ROUNDING);
            continue;
        }
        beyond++;
        ck_assert(r.distance > margin && r.distance <= truth + ROUNDING);
        real apart = -width_along(&a, &b, r.axis);
        ck_assert(apart >= r.distance - ROUNDING);
    }
    ck_assert_int_ge(beyond, 500);
}
END_TEST

// Rejects: a margin that is looked at only when the search has ended.
START_TEST(beyond_the_margin_the_search_is_shorter)
{
    unsigned long long seed = 16;
    int exact = 0, early = 0;
    for (int n = 0; n < 300; n++) {
        body a = body_cube(0, 0, 0), b = a;
        body_turn(&a, &seed);
        body_turn(&b, &seed);
        body_move(&b, random_vector(&seed, 2, 2.5));
        exact += ask(&a, &b).iterations;
        early += gjk_distance(body_hull(&a), body_hull(&b), 0.05,
                              NULL).iterations;
    }
    ck_assert_int_lt(4 * early, 3 * exact);
}
END_TEST

// ---- where it is hard

// Rejects: anything measured from the world's origin.  2^24 m moves exactly.
START_TEST(far_from_the_origin_nothing_more_is_lost)
{
    body a = body_cube(0, 0, 0), b = body_cube(1.75, 1.5, 1.25);
    gjk_result home = ask(&a, &b);
    pair_move(&a, &b, FAR_AWAY);
    gjk_result away = ask(&a, &b);
    near(away.distance, home.distance, ROUNDING);
    near_vec3(away.axis, home.axis, ROUNDING);
}
END_TEST

// Rejects: every tolerance that is a length.
START_TEST(size_does_not_matter)
{
    const real scale[] = { 1e-50, 1e-12, 1e-6, 1e6, 1e12, 1e50 };
    unsigned long long seed = 11;
    for (int n = 0; n < 300; n++) {
        body a, b;
        body_random(&a, 8, &seed);
        body_random(&b, 6, &seed);
        body_move(&b, random_vector(&seed, 0, 2));
        gjk_result one = ask(&a, &b);
        for (int s = 0; s < 6; s++) {
            body c = a, d = b;
            pair_scale(&c, &d, scale[s]);
            gjk_result r = ask(&c, &d);
            ck_assert_int_eq(r.status, one.status);
            near(r.distance / scale[s], one.distance, ROUNDING);
        }
    }
}
END_TEST

// A millimetre above a plate of a kilometre, and a nanometre above a cube.
START_TEST(small_gaps_between_large_bodies_are_seen)
{
    body plate, block;
    body_box(&plate, (vec3){ -500, -1, -500 }, (vec3){ 500, 0, 500 });
    body_box(&block, (vec3){ 3, 1e-3, 4 }, (vec3){ 3.5, 0.5, 4.5 });
    near(ask(&block, &plate).distance, 1e-3, 1e-15);
    body_box(&plate, (vec3){ -1, -1, -1 }, (vec3){ 1, 0, 1 });
    body_box(&block, (vec3){ 0.2, 1e-9, 0.1 }, (vec3){ 0.5, 0.5, 0.4 });
    near(ask(&block, &plate).distance, 1e-9, 1e-22);
    ck_assert_int_eq(ask(&block, &plate).status, GJK_APART);
    near(ask(&block, &plate).axis.y, 1e-9, 1e-22);
}
END_TEST

// Two edges cross at an angle of 1e-3 to 1e-10, one over the middle of the
// other: their triangle in A - B is as thin.  Rejects: the nearest point by a
// normal that rounding has tilted; there the gap was wrong by up to a third.
START_TEST(nearly_parallel_edges_keep_their_gap)
{
    unsigned long long seed = 17;
    for (int n = 0; n < 2000; n++) {
        real angle = pow(10, -3 - 7 * random_fraction(&seed));
        real gap = pow(10, -7 + 6 * random_fraction(&seed));
        real end = random_fraction(&seed);
        body a = { .count = 2 }, b = a;
        a.at[0] = (vec3){ -1, 0, 0 };
        a.at[1] = (vec3){ 1, 0, 0 };
        b.at[0] = (vec3){ -1 + end, -angle, 0 };
        b.at[1] = (vec3){ 1 + end, angle, 0 };
        for (int i = 0; i < 2; i++) b.at[i].z = gap;
        pair_turn(&a, &b, &seed);
        near(ask(&a, &b).distance, gap, 1e-6 * gap);
    }
}
END_TEST

// A plate ten micrometres over another, one edge higher by up to a micrometre,
// and the lower edge is sought from a diagonal.  Rejects: a search that ends
// when rounding hides that v has become shorter.
START_TEST(a_tilted_plate_is_found_by_its_lower_edge)
{
    unsigned long long seed = 22;
    for (int n = 0; n < 300; n++) {
        real gap = 1e-5, tilt = 1e-6 * random_fraction(&seed);
        body a = { .count = 4 }, b = a;
        for (int i = 0; i < 4; i++) {
            real x = i % 2 ? 1 : -1, y = i / 2 ? 1 : -1;
            a.at[i] = (vec3){ x, y, 0 };
            b.at[i] = (vec3){ x / 2, y / 4, gap + tilt * (1 + x) };
        }
        pair_turn(&a, &b, &seed);
        near(ask_plain(&a, &b).distance, gap, 1e-14);
    }
}
END_TEST

// A body and itself, turned and moved by next to nothing: A - B is full of
// corners that cancel, and v is short at the first look.  Rejects: apart, only
// because rounding lets v shrink no further.
START_TEST(a_body_overlaps_its_near_copy)
{
    unsigned long long seed = 18;
    for (int n = 0; n < 20000; n++) {
        body a, b;
        body_random(&a, 4 + n % 3, &seed);
        b = a;
        body_move(&b, random_vector(&seed, 0, n % 2 ? 1e-14 : 1e-16));
        ck_assert_int_eq(ask(&a, &b).status, GJK_OVERLAP);
    }
}
END_TEST

// The corners of a nearly flat curve lie 0.1 mm apart, their distances differ
// by 1e-8 m.  Rejects: a search that stops at a millionth.
START_TEST(a_flat_curve_is_followed_to_its_nearest_corner)
{
    body a = { .count = 41 };
    for (int i = 0; i < 41; i++) {
        real t = (i - 20) * 1e-4;
        a.at[i] = (vec3){ t, -t * t, 0 };
    }
    for (int i = 1; i < 40; i++) {
        real t = (i - 20) * 1e-4;
        body b = { .count = 1 };
        b.at[0] = vec3_add(a.at[i], (vec3){ 2 * t, 1, 0 });
        near(ask_plain(&b, &a).distance, sqrt(1 + 4 * t * t), 1e-12);
    }
}
END_TEST

// Points again, points between others, and bodies that are a point, a segment
// or a triangle: the hull is what counts.
START_TEST(points_that_say_nothing_new_change_nothing)
{
    unsigned long long seed = 19;
    for (int n = 0; n < 500; n++) {
        body a, b;
        pair_any(&a, &b, n, 5, 0, 3, &seed);
        gjk_result plain = ask(&a, &b);
        for (int k = 0; k < 4; k++) {
            vec3 twice = a.at[k % a.count], other = a.at[(k + 1) % a.count];
            a.at[a.count++] = twice;
            a.at[a.count++] = vec3_scale(0.5, vec3_add(twice, other));
            b.at[b.count] = b.at[b.count - 1];
            b.count++;
        }
        gjk_result r = ask(&a, &b);
        ck_assert_int_eq(r.status, plain.status);
        near(r.distance, plain.distance, ROUNDING);
    }
}
END_TEST

START_TEST(many_points_on_a_line_are_a_segment)
{
    body a = { .count = 9 }, b = { .count = 9 };
    for (int i = 0; i < 9; i++) {
        a.at[i] = (vec3){ i - 4.0, 0, 0 };
        b.at[i] = (vec3){ 20 - i, 3, 0 };
    }
    near(ask(&a, &b).distance, sqrt(64 + 9), 1e-13);
    for (int i = 0; i < 9; i++) b.at[i].x -= 14;
    near(ask(&a, &b).distance, 3, ROUNDING);
    for (int i = 0; i < 9; i++) b.at[i].y = 0;
    ck_assert_int_eq(ask(&a, &b).status, GJK_OVERLAP);
}
END_TEST

// Pairs within a few roundings of touching, on either side.
START_TEST(the_cap_is_never_reached)
{
    unsigned long long seed = 20;
    for (int n = 0; n < 4000; n++) {
        body a, b;
        pair_any(&a, &b, n, 5, 1, 3, &seed);
        for (int k = 0; k < 3; k++) {
            gjk_result r = ask(&a, &b);
            ck_assert(r.status == GJK_APART || r.status == GJK_OVERLAP);
            ck_assert_int_le(r.iterations, 100);
            real more = 1 + (real)(n % 7 - 3) * 1e-15;
            body_move(&b, vec3_scale(more, r.axis));
        }
    }
}
END_TEST

// ---- bad input

START_TEST(what_is_not_finite_gets_a_status)
{
    const real poison[4] = { (real)NAN, HUGE_VAL, -HUGE_VAL, 1e300 };
    for (int kind = 0; kind < 4; kind++)
        for (int n = 0; n < 8 * 3 * 2; n++) {
            body a = body_cube(0, 0, 0);
            body b = body_cube(n % 2 ? 2.2 : 0.2, 0.1, 0.3);
            vec3 *at = &b.at[n / 2 % 8];
            *(n / 16 == 0 ? &at->x : n / 16 == 1 ? &at->y : &at->z) =
                poison[kind];
            gjk_result r = ask(&a, &b), s = ask(&b, &a);
            ck_assert_int_eq(r.status, GJK_NOT_FINITE);
            ck_assert_int_eq(s.status, GJK_NOT_FINITE);
            near(r.distance, 0, 0);
            near_vec3(r.axis, (vec3){ 0, 0, 0 }, 0);
            near_vec3(r.on_a, (vec3){ 0, 0, 0 }, 0);
            ck_assert_int_eq(r.last.count, 0);
        }
}
END_TEST

// Rejects: a look at what is finite in the first frame only.
START_TEST(a_carried_simplex_does_not_hide_a_nan)
{
    body a = body_cube(0, 0, 0), b = body_cube(2, 0.1, 0.3);
    simplex carried = { .count = 0 };
    gjk_distance(body_hull(&a), body_hull(&b), HUGE_VAL, &carried);
    for (int i = 0; i < 8; i++) {
        body bad = b;
        simplex copy = carried;
        bad.at[i].y = (real)NAN;
        ck_assert_int_eq(gjk_distance(body_hull(&a), body_hull(&bad), HUGE_VAL,
                                      &copy).status, GJK_NOT_FINITE);
    }
}
END_TEST

// Points at random among the worst: 0, 1, tiny, huge, twice the same.
START_TEST(no_number_that_leaves_is_nan)
{
    const real odd[] = { 0, 0, 1, 1, -1, 0.5, 1e-9, -1e-9, 1e-30, 1e-70, 1e-170,
                         1e-300, 1e9, 1e30, 1e-16 };
    unsigned long long seed = 21;
    for (int n = 0; n < 40000; n++) {
        body a = { .count = 1 + n % 6 }, b = { .count = 1 + n / 6 % 6 };
        for (int i = 0; i < a.count + b.count; i++) {
            real x[3];
            for (int k = 0; k < 3; k++)
                x[k] = odd[(int)(15 * random_fraction(&seed))];
            *(i < a.count ? &a.at[i] : &b.at[i - a.count]) =
                (vec3){ x[0], x[1], x[2] };
        }
        gjk_result r = ask(&a, &b);
        ck_assert(r.status == GJK_APART || r.status == GJK_OVERLAP);
        ck_assert(r.distance >= 0 && r.distance < HUGE_VAL);
        ck_assert(vec3_is_finite(r.axis) && vec3_is_finite(r.on_a));
        ck_assert(vec3_is_finite(r.on_b));
        for (int k = 0; k < r.last.count; k++)
            ck_assert(r.last.weight[k] >= 0 && r.last.weight[k] <= 1 + 1e-14);
    }
}
END_TEST

// Two edges cross at an angle of 1e-9 rad and less, some 1e-13 of their length
// above each other: the height is the distance.  Rejects: a touch that is taken
// for granted below 2e-12 of the size; the search in doubles alone, whose points
// are somewhere along the edges.
START_TEST(edges_along_one_line_have_their_distance_and_points)
{
    unsigned long long seed = 31;
    for (int n = 0; n < 2000; n++) {
        real lean = 1e-9 * random_fraction(&seed) + 1e-13, gap = 0x1p-43;
        vec3 at[2] = { { -1, 0, 0 }, { 1, 0, 0 } };
        vec3 across[2] = { { -0.5, -lean, gap }, { 0.75, lean, gap } };
        gjk_result r = gjk_distance((hull){ at, 2 }, (hull){ across, 2 },
                                    HUGE_VAL, NULL);
        ck_assert_int_eq(r.status, GJK_APART);
        near(r.distance, gap, 1e-9 * gap);
        near_vec3(r.axis, (vec3){ 0, 0, -gap }, 1e-9 * gap);
        near(r.on_a.x, 0.125, 1e-12);
        vec3 joined = { 0, 0, 0 };
        for (int k = 0; k < r.last.count; k++)
            joined = vec3_add_scaled(joined, r.last.weight[k], r.last.of[k].at);
        near_vec3(joined, r.axis, 1e-15);
    }
}
END_TEST

// The lower face of a box that rests 1e-11 above a floor, turned anyhow: nearest
// are a corner and a face, whose normal does not depend on the gap.  Rejects: the
// difference of two points as a normal.
START_TEST(a_normal_is_the_face_s_however_near_it_is)
{
    unsigned long long seed = 32;
    for (int n = 0; n < 500; n++) {
        body a, b;
        real gap = n % 2 ? 1e-11 : 1e-9;
        body_box(&a, (vec3){ -2, -2, -1 }, (vec3){ 2, 2, 0 });
        body_box(&b, (vec3){ -0.5, -0.4, gap }, (vec3){ 0.5, 0.3, 1 });
        pair_turn(&a, &b, &seed);
        gjk_result r = ask(&a, &b);
        ck_assert_int_eq(r.status, GJK_APART);
        real lowest = -width_along(&a, &b, r.axis);
        near(lowest, r.distance, 1e-15 * 4);
    }
}
END_TEST

// Rejects: a proof that is never met, and one that is never asked for.
START_TEST(doubles_are_enough_unless_bodies_are_hard)
{
    unsigned long long seed = 33;
    int wide = 0;
    for (int n = 0; n < 5000; n++) {
        body a, b;
        pair_any(&a, &b, n, 5, 0, 2.5, &seed);
        wide += ask(&a, &b).wide;
    }
    check_doubles(wide, 5000);
    wide = 0;
    for (int n = 0; n < 100; n++) {
        body a = { .count = 2, .at = { { -1, 0, 0 }, { 1, 0, 0 } } };
        body b = { .count = 2, .at = { { -1, -1e-14, 1e-13 },
                                       { 0.7, 1e-14, 1e-13 } } };
        pair_turn(&a, &b, &seed);
        wide += ask(&a, &b).wide;
    }
    ck_assert(wide > 50 || !bits_are_ours());
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        support_is_the_highest_vertex_less_the_lowest,
        support_sees_a_nanometre_a_thousand_kilometres_away,
        a_normal_is_twice_the_area_long_and_right_handed,
        the_normal_of_a_thin_triangle_is_upright_on_it,
        weights_of_a_triangle_are_barycentric,
        two_points_are_as_far_as_they_are,
        a_point_on_itself_overlaps,
        crossing_segments_are_their_gap_apart,
        boxes_face_edge_and_vertex_apart,
        exact_touch_is_overlap,
        identical_and_concentric_cubes_overlap,
        a_point_is_inside_or_outside_a_cube,
        balls_of_points_are_apart_by_the_gap,
        upper_and_lower_bound_agree,
        random_pairs_agree_with_every_pair_of_features,
        overlap_ends_where_the_depth_says,
        stored_pairs_have_their_exact_distance,
        swapped_bodies_give_the_mirror_image,
        a_carried_simplex_changes_no_answer,
        a_stale_simplex_does_no_harm,
        carried_corners_at_the_origin_hide_no_size,
        carried_it_asks_for_fewer_corners,
        beyond_the_margin_there_is_a_true_bound,
        beyond_the_margin_the_search_is_shorter,
        far_from_the_origin_nothing_more_is_lost,
        size_does_not_matter,
        small_gaps_between_large_bodies_are_seen,
        nearly_parallel_edges_keep_their_gap,
        a_tilted_plate_is_found_by_its_lower_edge,
        a_body_overlaps_its_near_copy,
        a_flat_curve_is_followed_to_its_nearest_corner,
        points_that_say_nothing_new_change_nothing,
        many_points_on_a_line_are_a_segment,
        the_cap_is_never_reached,
        what_is_not_finite_gets_a_status,
        a_carried_simplex_does_not_hide_a_nan,
        no_number_that_leaves_is_nan,
        edges_along_one_line_have_their_distance_and_points,
        a_normal_is_the_face_s_however_near_it_is,
        doubles_are_enough_unless_bodies_are_hard,
        NULL
    };
    return suite_run((suite){ .name = "gjk", .tests = tests });
}
