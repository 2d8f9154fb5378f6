// check.c - tests of the exercise 04/round.

#include "round.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>

// Some dozen roundings of numbers up to 10, 1e-15 each.
static const real ROUNDING = 1e-13;

static round_body around(const vec3 *at, int count, real radius)
{
    return (round_body){ { at, count }, radius };
}

static unsigned long long seed = 4;

START_TEST(support_of_a_ball_lies_on_the_ball)
{
    // Rejects: a direction that is not normalised, the far side.
    vec3 c = { 1, 2, 3 };
    round_body ball = around(&c, 1, 0.5);
    near_vec3(round_support(ball, (vec3){ 0, 8, 0 }),
               (vec3){ 1, 2.5, 3 }, ROUNDING, "up");
    near_vec3(round_support(ball, (vec3){ -0.25, 0, 0 }),
               (vec3){ 0.5, 2, 3 }, ROUNDING, "left");
}
END_TEST

START_TEST(support_is_further_than_the_core_by_the_radius)
{
    // Rejects: the wrong end of a capsule, a radius left out.
    vec3 at[2] = { { -1, 0, 0 }, { 1, 0.5, 0 } };
    round_body capsule = around(at, 2, 0.25);
    for (int k = 0; k < 1000; k++) {
        vec3 d = random_vec3(&seed, 5);
        real core = fmax(vec3_dot(d, at[0]), vec3_dot(d, at[1]));
        near(vec3_dot(d, round_support(capsule, d)),
             core + 0.25 * vec3_length(d), ROUNDING, "height along d");
    }
}
END_TEST

START_TEST(support_of_no_direction_is_a_point_of_the_body)
{
    // Rejects: 0 / 0.
    vec3 c = { 1, 2, 3 };
    vec3 s = round_support(around(&c, 1, 0.5), (vec3){ 0, 0, 0 });
    ck_assert_msg(vec3_distance(s, c) <= 0.5 + ROUNDING, "got (%g, %g, %g)",
                  s.x, s.y, s.z);
}
END_TEST

START_TEST(balls_are_apart_by_their_centres_less_their_radii)
{
    // Rejects: one radius alone, a normal from A to B, points on the far sides.
    vec3 p = { 0, 0, 0 }, q = { 3, 4, 0 };
    round_result r = round_distance(around(&p, 1, 1), around(&q, 1, 2));
    near(r.gap, 2, ROUNDING, "gap");
    near_vec3(r.normal, (vec3){ -0.6, -0.8, 0 }, ROUNDING, "normal");
    near_vec3(r.on_a, (vec3){ 0.6, 0.8, 0 }, ROUNDING, "on A");
    near_vec3(r.on_b, (vec3){ 1.8, 2.4, 0 }, ROUNDING, "on B");
}
END_TEST

START_TEST(ball_meets_the_side_and_the_end_of_a_capsule)
{
    // Rejects: a capsule that ends flat.
    vec3 at[2] = { { 0, 0, 0 }, { 2, 0, 0 } };
    vec3 side = { 1.5, 3, 0 }, end = { 5, 4, 0 };
    round_body capsule = around(at, 2, 0.5);
    near(round_distance(capsule, around(&side, 1, 0.25)).gap, 2.25, ROUNDING,
         "side");
    near(round_distance(capsule, around(&end, 1, 0.25)).gap, 4.25, ROUNDING,
         "end");
}
END_TEST

START_TEST(crossing_capsules_are_apart_at_their_middles)
{
    vec3 s[2] = { { -1, 0, 0 }, { 1, 0, 0 } };
    vec3 t[2] = { { 0.25, -1, 1 }, { 0.25, 1, 1 } };
    round_result r = round_distance(around(s, 2, 0.25), around(t, 2, 0.5));
    near(r.gap, 0.25, ROUNDING, "gap");
    near_vec3(r.on_a, (vec3){ 0.25, 0, 0.25 }, ROUNDING, "on A");
    near_vec3(r.on_b, (vec3){ 0.25, 0, 0.5 }, ROUNDING, "on B");
}
END_TEST

START_TEST(overlap_is_a_negative_gap_with_the_same_normal)
{
    // Rejects: a gap that stops at 0, a normal that turns round.
    vec3 p = { 0, 0, 0 }, q = { 2, 0, 0 };
    round_result r = round_distance(around(&p, 1, 1.5), around(&q, 1, 1));
    near(r.gap, -0.5, ROUNDING, "gap");
    near_vec3(r.normal, (vec3){ -1, 0, 0 }, ROUNDING, "normal");
    near_vec3(r.on_a, (vec3){ 1.5, 0, 0 }, ROUNDING, "on A");
    near_vec3(r.on_b, (vec3){ 1, 0, 0 }, ROUNDING, "on B");
}
END_TEST

START_TEST(overlapping_cores_have_no_normal_and_no_nan)
{
    // Rejects: 0 / 0 as a normal.
    vec3 s[2] = { { -1, 0, 0 }, { 1, 0, 0 } };
    vec3 t[2] = { { 0, -1, 0 }, { 0, 1, 0 } };
    round_result r = round_distance(around(s, 2, 0.25), around(t, 2, 0.5));
    ck_assert_int_eq(r.status, GJK_OVERLAP);
    near(r.gap, -0.75, ROUNDING, "gap");
    near_vec3(r.normal, (vec3){ 0, 0, 0 }, ROUNDING, "normal");
    near_vec3(r.on_a, (vec3){ 0, 0, 0 }, ROUNDING, "on A");
    near_vec3(r.on_b, (vec3){ 0, 0, 0 }, ROUNDING, "on B");
}
END_TEST

START_TEST(radius_zero_is_gjk_itself)
{
    vec3 a[4] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    vec3 b[3] = { { 2, 2, 2 }, { 3, 1, 2 }, { 1, 3, 4 } };
    round_result r = round_distance(around(a, 4, 0), around(b, 3, 0));
    gjk_result g = gjk_distance((hull){ a, 4 }, (hull){ b, 3 }, HUGE_VAL,
                                NULL);
    ck_assert(r.gap == g.distance && r.status == g.status);
    near_vec3(r.on_a, g.on_a, ROUNDING, "on A");
    near_vec3(r.on_b, g.on_b, ROUNDING, "on B");
}
END_TEST

START_TEST(points_lie_on_the_surfaces_and_the_gap_between_them)
{
    // Rejects: radii exchanged; a sign that only shows when nothing is 0.
    for (int k = 0; k < 500; k++) {
        vec3 s[2] = { random_vec3(&seed, 1), random_vec3(&seed, 1) };
        vec3 t[2] = { random_vec3(&seed, 1), random_vec3(&seed, 1) };
        round_body a = around(s, 2, 0.1), b = around(t, 2, 0.3);
        round_result r = round_distance(a, b), q = round_distance(b, a);
        near_vec3(vec3_sub(r.on_a, r.on_b), vec3_scale(r.gap, r.normal),
                  ROUNDING,
                   "on A - on B");
        near_vec3(r.on_a, q.on_b, ROUNDING,
                  "on A, and on B with the bodies exchanged");
        round_body foot = around(&r.on_a, 1, 0);
        near(round_distance(foot, around(s, 2, 0)).gap, 0.1, ROUNDING,
             "from A's core");
    }
}
END_TEST

START_TEST(what_is_not_finite_leaves_nothing)
{
    vec3 p = { 0, (real)NAN, 0 }, q = { 2, 0, 0 };
    round_result r = round_distance(around(&p, 1, 1), around(&q, 1, 1));
    ck_assert_int_eq(r.status, GJK_NOT_FINITE);
    ck_assert(r.gap == 0 && vec3_length(r.normal) == 0);
    ck_assert(vec3_length(r.on_a) == 0 && vec3_length(r.on_b) == 0);
    ck_assert(round_support(around(&q, 1, 1), (vec3){ 1, 0, 0 }).x == 3);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        // Support.
        support_of_a_ball_lies_on_the_ball,
        support_is_further_than_the_core_by_the_radius,
        support_of_no_direction_is_a_point_of_the_body,
        // Distance.
        balls_are_apart_by_their_centres_less_their_radii,
        ball_meets_the_side_and_the_end_of_a_capsule,
        crossing_capsules_are_apart_at_their_middles,
        overlap_is_a_negative_gap_with_the_same_normal,
        overlapping_cores_have_no_normal_and_no_nan,
        radius_zero_is_gjk_itself,
        points_lie_on_the_surfaces_and_the_gap_between_them,
        what_is_not_finite_leaves_nothing,
        NULL
    };
    return suite_run((suite){ .name = "round", .tests = tests });
}
