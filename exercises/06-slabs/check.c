// check.c - tests of the exercise 06/slabs.

#include "slabs.h"
#include "gjk.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdio.h>

// Some dozen roundings of numbers up to 10.
static const real ROUNDING = 1e-14;

static const real ROOT_3 = 1.7320508075688772;

static unsigned long long seed = 14;

static void expect(const char *what, const slabs *s, int k, real low,
                   real high)
{
    ck_assert_msg(fabs(s->low[k] - low) <= ROUNDING
                  && fabs(s->high[k] - high) <= ROUNDING,
                  "%s, along (%g, %g, %g): got a slab from %.15g to %.15g, "
                  "wanted %.15g to %.15g", what, SLAB[k].x, SLAB[k].y, SLAB[k].z, s->low[k],
                  s->high[k], low, high);
}

static void expect_meet(const char *what, const slabs *a, const slabs *b,
                        real margin, int meet)
{
    int ab = slabs_meet(a, b, margin), ba = slabs_meet(b, a, margin);
    ck_assert_msg(ab == meet, "%s, margin %g m: they %s, and should%s.  One "
                  "direction that parts them is enough, and along a diagonal a "
                  "metre counts sqrt(3) times", what, margin,
                  ab ? "meet" : "do not meet", meet ? "" : " not");
    ck_assert_msg(ba == meet, "%s, exchanged, margin %g m: they %s, and "
                  "should%s: which is the first must not matter", what, margin,
                  ba ? "meet" : "do not meet", meet ? "" : " not");
}

START_TEST(points_lie_between_their_slabs)
{
    // Rejects: a first point that is a low but no high; three directions for
    // seven; the last point left out.
    vec3 at[3] = { { 5, 1, 1 }, { 2, 3, -4 }, { 1, 7, 2 } };
    slabs s = slabs_of_points(at, 3), one = slabs_of_points(at, 1);
    expect("three points", &s, 0, 1, 5);
    expect("three points", &s, 1, 1, 7);
    expect("three points", &s, 2, -4, 2);
    expect("three points", &s, 3, 1, 10);
    expect("three points", &s, 4, 5, 9);
    expect("three points", &s, 5, -5, 5);
    expect("three points", &s, 6, -8, 3);
    expect("one point", &one, 0, 5, 5);
    expect("one point", &one, 3, 7, 7);
}
END_TEST

START_TEST(ball_is_wider_along_a_longer_direction)
{
    // Rejects: the radius alone along (1, 1, 1), which cuts into the ball.
    slabs s = slabs_of_ball((vec3){ 1, 2, 3 }, 2);
    expect("a ball", &s, 0, -1, 3);
    expect("a ball", &s, 2, 1, 5);
    expect("a ball", &s, 3, 6 - 2 * ROOT_3, 6 + 2 * ROOT_3);
    expect("a ball", &s, 6, -4 - 2 * ROOT_3, -4 + 2 * ROOT_3);
}
END_TEST

START_TEST(join_holds_both)
{
    // Rejects: the piece that both share; an empty one that adds the origin.
    vec3 p = { 1, 0, 0 }, q = { -2, 3, 0 };
    slabs a = slabs_of_points(&p, 1), b = slabs_of_points(&q, 1);
    slabs none = slabs_of_points(&p, 0), s = slabs_join(&a, &b);
    expect("two points", &s, 0, -2, 1);
    expect("two points", &s, 1, 0, 3);
    expect("two points", &s, 5, -5, 1);
    s = slabs_join(&none, &b);
    expect("nothing and a point", &s, 0, -2, -2);
    s = slabs_join(&b, &none);
    expect("a point and nothing", &s, 0, -2, -2);
}
END_TEST

START_TEST(margin_is_in_metres)
{
    // Two corners across (1, 1, 1), sqrt(3) m apart; and two along x, 1 m.
    // Rejects: a margin that is not scaled; touching that counts.
    vec3 p = { 0, 0, 0 }, q = { 1, 1, 1 }, r = { 1, 0, 0 };
    slabs a = slabs_of_points(&p, 1), b = slabs_of_points(&q, 1);
    slabs c = slabs_of_points(&r, 1);
    expect_meet("along (1, 1, 1)", &a, &b, 1.6, 0);
    expect_meet("along (1, 1, 1)", &a, &b, 1.8, 1);
    expect_meet("along x", &a, &c, 0.9, 0);
    expect_meet("along x", &a, &c, 1, 0);
    expect_meet("along x", &a, &c, 1.1, 1);
}
END_TEST

START_TEST(one_direction_is_enough)
{
    // Two sticks side by side, askew: their boxes overlap, and so do all other
    // slabs but one.  Rejects: apart only if all seven say so; a direction that
    // is not asked; a look from one side only.
    for (int k = 3; k < SLABS; k++) {
        vec3 d = SLAB[k], side = vec3_scale(0.2, d);
        // Across d, whose entries are 1 and -1: 2 - 1 - 1 = 0.
        vec3 across = { 2 * d.x, -d.y, -d.z };
        vec3 a[2] = { vec3_scale(-3, across), vec3_scale(3, across) };
        vec3 b[2] = { vec3_add(a[0], side), vec3_add(a[1], side) };
        slabs s = slabs_of_points(a, 2), t = slabs_of_points(b, 2);
        expect_meet("two sticks side by side", &s, &t, 0, 0);
    }
}
END_TEST

START_TEST(empty_meets_nothing)
{
    vec3 p = { 0, 0, 0 };
    slabs none = slabs_of_points(&p, 0), ball = slabs_of_ball(p, 1e9);
    expect_meet("nothing and a large ball", &none, &ball, 1, 0);
    expect_meet("nothing and nothing", &none, &none, 1, 0);
}
END_TEST

START_TEST(what_is_no_number_meets_everything)
{
    // Rejects: a comparison that loses it, in either place.
    vec3 bad[3] = { { 0, 0, 0 }, { (real)NAN, 0, 0 }, { 1, 0, 0 } };
    vec3 far = { 100, 100, 100 };
    slabs a = slabs_of_points(bad, 3), b = slabs_of_points(&far, 1);
    // Along y and z it need not show.
    for (int k = 0; k < SLABS; k++)
        if (k != 1 && k != 2)
            ck_assert_msg(a.low[k] != a.low[k] && a.high[k] != a.high[k],
                          "three points, the second no number: direction %d "
                          "has %g to %g, wanted nan to nan", k, a.low[k],
                          a.high[k]);
    slabs left = slabs_join(&a, &b), right = slabs_join(&b, &a);
    ck_assert_msg(left.low[0] != left.low[0] && right.low[0] != right.low[0],
                  "joined, it is forgotten");
    vec3 all = { (real)NAN, (real)NAN, (real)NAN };
    slabs c = slabs_of_points(&all, 1);
    expect_meet("no number and a point", &c, &b, 0, 1);
}
END_TEST

// A long thin body around the middle: four corners.
static void long_stick(vec3 *at, vec3 middle)
{
    vec3 along = vec3_scale(4, vec3_unit(random_vec3(&seed, 1)));
    for (int i = 0; i < 4; i++)
        at[i] = vec3_add(vec3_add_scaled(middle, i % 2 ? 1 : -1, along),
                         random_vec3(&seed, 0.1));
}

static real gap(const vec3 *a, const vec3 *b)
{
    return gjk_distance((hull){ a, 4 }, (hull){ b, 4 }, HUGE_VAL,
                        NULL).distance;
}

START_TEST(nothing_near_is_lost)
{
    // Rejects: every cut that is too deep.
    for (int i = 0; i < 2000; i++) {
        vec3 a[4], b[4];
        long_stick(a, (vec3){ 0, 0, 0 });
        long_stick(b, random_vec3(&seed, 4));
        slabs s = slabs_of_points(a, 4), t = slabs_of_points(b, 4);
        real d = gap(a, b);
        ck_assert_msg(d >= 0.5 || slabs_meet(&s, &t, 0.5), "pose %d: GJK finds "
                      "a gap of %g m, the margin is 0.5 m, and the slabs say "
                      "that they are further apart", i, d);
    }
}
END_TEST

static int balls_meet(const vec3 *a, const vec3 *b)
{
    vec3 p = vec3_scale(0.5, vec3_add(a[0], a[1]));
    vec3 q = vec3_scale(0.5, vec3_add(b[0], b[1]));
    return vec3_distance(p, q) < 8;
}

static int boxes_meet(const slabs *a, const slabs *b)
{
    for (int k = 0; k < 3; k++)
        if (a->low[k] >= b->high[k] || b->low[k] >= a->high[k]) return 0;
    return 1;
}

START_TEST(slabs_raise_fewer_false_alarms)
{
    // Rejects: nothing wrong, but slabs that are not worth their seven.
    int apart = 0, balls = 0, boxes = 0, fourteen = 0;
    for (int i = 0; i < 2000; i++) {
        vec3 a[4], b[4];
        long_stick(a, (vec3){ 0, 0, 0 });
        long_stick(b, random_vec3(&seed, 4));
        slabs s = slabs_of_points(a, 4), t = slabs_of_points(b, 4);
        if (!(gap(a, b) > 0)) continue;
        apart++;
        balls += balls_meet(a, b);
        boxes += boxes_meet(&s, &t);
        fourteen += slabs_meet(&s, &t, 0);
    }
    printf("of %d pairs of sticks apart, %d balls meet, %d boxes, %d slabs\n",
           apart, balls, boxes, fourteen);
    ck_assert_msg(4 * fourteen < 3 * boxes, "of %d pairs that are apart, the "
                  "boxes of %d meet and the slabs of %d: wanted fewer than "
                  "three quarters", apart, boxes, fourteen);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        points_lie_between_their_slabs,
        ball_is_wider_along_a_longer_direction,
        join_holds_both,
        margin_is_in_metres,
        one_direction_is_enough,
        empty_meets_nothing,
        what_is_no_number_meets_everything,
        nothing_near_is_lost,
        slabs_raise_fewer_false_alarms,
        NULL
    };
    return suite_run((suite){ .name = "slabs", .tests = tests });
}
