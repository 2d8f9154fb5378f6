// check.c - tests of the exercise 15/balls.

#include "balls.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>

static const real ROUNDING = 1e-13;

static const vec3 STILL = { 0, 0, 0 };

static unsigned long long seed = 14;

static flying_ball make(real x, real y, real radius, vec3 way)
{
    return (flying_ball){ { x, y, 0 }, radius, way };
}

static void touch(flying_ball a, flying_ball b, real time, vec3 normal,
                  const char *what)
{
    real t = -7;
    vec3 n = { -7, -7, -7 };
    ck_assert_msg(balls_touch(&a, &b, &t, &n), "%s: they do not touch", what);
    near(t, time, ROUNDING, what);
    ck_assert_msg(vec3_distance(n, normal) < 1e-9, "%s: the normal is (%g, %g, "
                  "%g), wanted (%g, %g, %g)", what, n.x, n.y, n.z, normal.x,
                  normal.y, normal.z);
}

static void miss(flying_ball a, flying_ball b, const char *what)
{
    real t = -7;
    vec3 n = { -7, -7, -7 };
    ck_assert_msg(!balls_touch(&a, &b, &t, &n), "%s: they touch at %g", what,
                  t);
    ck_assert_msg(t == -7 && n.x == -7, "%s: something is written", what);
}

START_TEST(two_balls_meet_head_on)
{
    // 10 m between the centres, radii 1 and 2: 7 m to go.
    const vec3 left = { -1, 0, 0 }, right = { 1, 0, 0 };
    flying_ball b = make(0, 0, 2, STILL);
    touch(make(10, 0, 1, vec3_make(-14, 0, 0)), b, 0.5, right, "14 m to go");
    touch(make(-10, 0, 1, vec3_make(7, 0, 0)), b, 1, left, "7 m to go");
    b.way = vec3_make(7, 0, 0);
    touch(make(10, 0, 1, vec3_make(-7, 0, 0)), b, 0.5, right,
          "they come from both sides");
    touch(make(10, 0, 1, vec3_make(0, 0, 0)), b, 1, right, "B comes alone");
    b.way = vec3_make(17, 4, 0);
    touch(make(10, 0, 1, vec3_make(3, 4, 0)), b, 0.5, right,
          "one overtakes the other");
}
END_TEST

START_TEST(slant_ball_meets_at_its_side)
{
    // 3 m aside, and 5 m is the sum of the radii: they touch when 4 m are left.
    touch(make(-10, 3, 2, vec3_make(20, 0, 0)), make(0, 0, 3, STILL), 0.3,
          vec3_make(-0.8, 0.6, 0), "3 m aside");
}
END_TEST

START_TEST(who_passes_by_a_hair_does_not_touch)
{
    // Rejects: a root of less than nothing.
    flying_ball b = make(0, 0, 1, STILL);
    vec3 way = { 20, 0, 0 };
    miss(make(-10, 1.5 + 1e-9, 0.5, way), b, "a nanometre beside");
    miss(make(-10, 9, 0.5, way), b, "far beside");
    real t = 0;
    vec3 n = STILL;
    flying_ball a = make(-10, 1.5 - 1e-9, 0.5, way);
    ck_assert_msg(balls_touch(&a, &b, &t, &n), "a nanometre inside");
    near(t, 0.5, 1e-5, "a nanometre inside");
}
END_TEST

START_TEST(who_parts_does_not_touch)
{
    flying_ball b = make(0, 0, 1, STILL);
    miss(make(3, 0, 1, vec3_make(5, 0, 0)), b, "it flies away");
    miss(make(3, 0, 1, STILL), b, "nobody moves");
    miss(make(3, 0, 1, vec3_make(0, 5, 0)), b, "square to it");
    miss(make(2, 0, 1, vec3_make(5, 0, 0)), b, "it touches, and parts");
    miss(make(2, 0, 1, vec3_make(0, 1, 0)), b, "it touches, and slides by");
}
END_TEST

START_TEST(who_comes_too_late_does_not_touch)
{
    flying_ball b = make(0, 0, 2, STILL);
    miss(make(10, 0, 1, vec3_make(-6.999, 0, 0)), b, "1 mm is left");
}
END_TEST

START_TEST(overlap_is_now)
{
    const vec3 right = { 1, 0, 0 };
    flying_ball b = make(0, 0, 2, STILL);
    touch(make(2.5, 0, 1, vec3_make(-1, 0, 0)), b, 0, right, "they overlap");
    touch(make(2.5, 0, 1, vec3_make(9, 0, 0)), b, 0, right,
          "they overlap, and part");
    touch(make(3, 0, 1, vec3_make(-1, 0, 0)), b, 0, right,
          "they touch, and come nearer");
    touch(make(0, 0, 1, STILL), b, 0, STILL, "one centre");
}
END_TEST

START_TEST(digits_are_kept)
{
    // Gaps of a micrometre and much less, before a slanting way of a kilometre;
    // then balls that come from a thousand kilometres.
    for (int power = 20; power <= 40; power += 5) {
        real gap = ldexp(1, -power), t = 0;
        vec3 n = STILL, way = { 700, 300, 100 };
        flying_ball a = make(-2 - gap, 0, 1, way), b = make(0, 0, 1, STILL);
        long double g = (long double)gap, w2 = (long double)vec3_dot(way, way);
        long double c = (4 + g) * g, q = 700 * (2 + g);
        long double wanted = c / (q + sqrtl(q * q - w2 * c));
        ck_assert(balls_touch(&a, &b, &t, &n));
        near(t / (real)wanted, 1, 1e-12, "time of a little gap, as a share");
    }
    real t = 0;
    vec3 n = STILL;
    flying_ball a = make(-1e6, 0, 1, vec3_make(2e6, 0, 0));
    flying_ball b = make(0, 0, 1, STILL);
    ck_assert(balls_touch(&a, &b, &t, &n));
    near(t, (1e6 - 2) / 2e6, 1e-12, "from a thousand kilometres");
}
END_TEST

START_TEST(nobody_was_nearer_before)
{
    int met = 0;
    for (int round = 0; round < 20000; round++) {
        flying_ball a = { random_vec3(&seed, 5), 1 + random_real(&seed),
                          random_vec3(&seed, 6) };
        flying_ball b = { random_vec3(&seed, 5), 1 + random_real(&seed),
                          random_vec3(&seed, 6) };
        real t = 1, r = a.radius + b.radius;
        vec3 n = STILL;
        int is_met = balls_touch(&a, &b, &t, &n);
        vec3 d = vec3_sub(a.center, b.center), w = vec3_sub(a.way, b.way);
        if (is_met && t > 0) {
            near(vec3_length(vec3_add_scaled(d, t, w)), r, 1e-9,
                 "distance at the touch");
            met++;
        }
        for (int k = 0; k < 20 && (!is_met || t > 0); k++) {
            real before = t * k / 20;
            ck_assert_msg(vec3_length(vec3_add_scaled(d, before, w))
                          > r * (1 - 1e-9), "they overlap at %g, and are said "
                          "to touch at %g", before, t);
        }
    }
    ck_assert_msg(met > 500, "%d met: both kinds are to be tried", met);
}
END_TEST

START_TEST(what_is_not_finite_touches_nobody)
{
    const real bad[2] = { (real)NAN, HUGE_VAL };
    for (int k = 0; k < 8; k++) {
        flying_ball a = make(10, 0, 1, vec3_make(-14, 0, 0));
        flying_ball b = make(0, 0, 2, STILL);
        if (k / 2 == 0) a.center.y = bad[k % 2];
        if (k / 2 == 1) a.way.y = bad[k % 2];
        if (k / 2 == 2) b.center.z = bad[k % 2];
        if (k / 2 == 3) b.radius = (real)NAN;
        miss(a, b, "something is no number");
    }
}
END_TEST

START_TEST(limit_is_the_inner_radius)
{
    ck_assert_int_eq(balls_limit(STILL, 0.05, 100), 1);
    ck_assert_int_eq(balls_limit(vec3_make(0.03, 0.04, 0), 0.05, 100), 1);
    ck_assert_int_eq(balls_limit(vec3_make(0, 0, 0.0501), 0.05, 100), 2);
    ck_assert_int_eq(balls_limit(vec3_make(0, -1, 0), 0.25, 100), 4);
    ck_assert_int_eq(balls_limit(vec3_make(0, -1, 0), 0.25, 3), 3);
    ck_assert_int_eq(balls_limit(vec3_make(1e300, 0, 0), 1e-3, 420), 420);
    ck_assert_int_eq(balls_limit(vec3_make((real)NAN, 0, 0), 0.05, 7), 7);
    // 1000 m/s, 5 cm, 60 frames a second: the chapter's 420, whose inner
    // radius is a little less than 5 cm.
    ck_assert_int_eq(balls_limit(vec3_make(1000 / 60.0, 0, 0), 0.05, 999), 334);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        two_balls_meet_head_on,
        slant_ball_meets_at_its_side,
        who_passes_by_a_hair_does_not_touch,
        who_parts_does_not_touch,
        who_comes_too_late_does_not_touch,
        overlap_is_now,
        digits_are_kept,
        nobody_was_nearer_before,
        what_is_not_finite_touches_nobody,
        limit_is_the_inner_radius,
        NULL
    };
    return suite_run((suite){ .name = "balls", .tests = tests });
}
