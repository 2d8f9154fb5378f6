// check.c - tests of the exercise 10/deep.

#include "deep.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdio.h>

// A dozen roundings of numbers up to 10.
static const real ROUNDING = 1e-13;

static round_body around(const vec3 *at, int count, real radius)
{
    return (round_body){ { at, count }, radius };
}

// What must hold of every answer.
static deep_contact ask(round_body a, round_body b)
{
    deep_contact c = deep_contact_find(a, b);
    ck_assert_msg(c.ok, "there is an answer, and ok is 0");
    near(vec3_length(c.normal), 1, ROUNDING, "length of the normal");
    near_vec3(vec3_sub(c.on_a, c.on_b), vec3_scale(c.gap, c.normal), ROUNDING,
              "on A - on B, which is to be gap times normal");
    return c;
}

static unsigned long long seed = 55;

static void cube_make(vec3 at[8])
{
    for (int i = 0; i < 8; i++)
        at[i] = (vec3){ i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1 };
}

START_TEST(balls_side_by_side)
{
    vec3 p = { 0, 0, 0 }, q = { 3, 4, 0 };
    deep_contact c = ask(around(&p, 1, 1), around(&q, 1, 2));
    near(c.gap, 2, ROUNDING, "gap of balls that are apart");
    near_vec3(c.normal, (vec3){ -0.6, -0.8, 0 }, ROUNDING,
              "normal, from B to A");
    c = ask(around(&p, 1, 4), around(&q, 1, 2));
    near(c.gap, -1, ROUNDING, "gap of balls that overlap");
    near_vec3(c.on_a, (vec3){ 2.4, 3.2, 0 }, ROUNDING, "on A");
    near_vec3(c.on_b, (vec3){ 1.8, 2.4, 0 }, ROUNDING, "on B");
}
END_TEST

START_TEST(ball_with_its_centre_in_a_cube)
{
    // 0.25 m below the upper face, with a radius of 0.5 m.  Rejects: a normal
    // of length 0, one that leads in, a gap above 0.
    vec3 at[8], p = { 0.25, 0.75, -0.5 };
    cube_make(at);
    deep_contact c = ask(around(&p, 1, 0.5), around(at, 8, 0));
    near(c.gap, -0.75, ROUNDING, "gap");
    near_vec3(c.normal, (vec3){ 0, 1, 0 }, ROUNDING, "normal");
    near_vec3(c.on_a, (vec3){ 0.25, 0.25, -0.5 }, ROUNDING,
              "lowest point of the ball");
    near_vec3(c.on_b, (vec3){ 0.25, 1, -0.5 }, ROUNDING, "point of the face");
}
END_TEST

START_TEST(crossing_capsules_know_the_way)
{
    // The segments meet: their difference is flat, and the way out leads out of
    // its plane, along z.  Rejects: HIT_FLAT taken for a failure.
    vec3 s[2] = { { -1, 0, 0 }, { 1, 0, 0 } };
    vec3 t[2] = { { 0, -1, 0 }, { 0, 1, 0 } };
    deep_contact c = ask(around(s, 2, 0.25), around(t, 2, 0.5));
    near(c.gap, -0.75, ROUNDING, "gap");
    near(fabs(c.normal.z), 1, ROUNDING, "normal along z");
}
END_TEST

START_TEST(capsules_in_one_line_and_balls_in_one_place)
{
    // The difference is a segment, or a point.  Any normal across will do.
    vec3 s[2] = { { -1, 0, 0 }, { 1, 0, 0 } };
    vec3 t[2] = { { 0.5, 0, 0 }, { 2.5, 0, 0 } }, p = { 1, 2, 3 };
    deep_contact c = ask(around(s, 2, 0.25), around(t, 2, 0.5));
    near(c.gap, -0.75, ROUNDING, "gap of capsules in one line");
    near(c.normal.x, 0, ROUNDING, "normal, along the line");
    c = ask(around(&p, 1, 0.25), around(&p, 1, 0.5));
    near(c.gap, -0.75, ROUNDING, "gap of balls with one centre");
}
END_TEST

START_TEST(capsule_falls_through_a_capsule)
{
    // From 1 m above the other to the height of its middle, a centimetre at a
    // time.  Rejects: a jump where the cores meet.
    vec3 t[2] = { { 0, -1, 0 }, { 0, 1, 0 } };
    for (int k = 0; k <= 100; k++) {
        real z = 1 - 0.01 * k;
        vec3 s[2] = { { -1, 0, z }, { 1, 0, z } };
        deep_contact c = ask(around(s, 2, 0.25), around(t, 2, 0.5));
        char what[60];
        snprintf(what, sizeof what, "capsule at z = %g, gap", z);
        near(c.gap, z - 0.75, ROUNDING, what);
    }
}
END_TEST

START_TEST(capsule_falls_through_a_box)
{
    // Upright, its lower end ahead, down to the middle of the box.
    // Rejects: radii that are forgotten where the cores overlap.
    vec3 at[8];
    cube_make(at);
    for (int k = 0; k <= 95; k++) {
        real y = 1.5 - 0.01 * k;
        vec3 s[2] = { { 0.1, y, 0 }, { 0.1, y + 5, 0 } };
        deep_contact c = ask(around(s, 2, 0.25), around(at, 8, 0.125));
        char what[60];
        snprintf(what, sizeof what, "lower end at y = %g, gap", y);
        real up = y - 1 - 0.375, aside = -0.9 - 0.375;
        near(c.gap, up > aside ? up : aside, ROUNDING, what);
    }
}
END_TEST

START_TEST(random_bodies_touch_once_they_have_moved)
{
    // Out along the normal by the gap, or in: then the gap is 0.
    // Rejects: points left on the cores, or on the far side.
    int deep = 0;
    for (int k = 0; k < 100; k++) {
        vec3 s[6], t[6];
        for (int i = 0; i < 6; i++) {
            s[i] = random_vec3(&seed, 1);
            t[i] = vec3_add_scaled(random_vec3(&seed, 1), (real)(k % 5) / 2,
                                   (vec3){ 1, 0, 0 });
        }
        round_body a = around(s, 6, 0.1), b = around(t, 6, 0.3);
        deep_contact c = ask(a, b);
        deep += c.gap < -0.4;
        for (int i = 0; i < 6; i++)
            s[i] = vec3_add_scaled(s[i], -c.gap, c.normal);
        near(ask(a, b).gap, 0, ROUNDING, "gap after moving by it");
    }
    ck_assert_msg(deep > 20 && deep < 80, "%d of 100 have overlapping cores: "
                  "both kinds are to be tried", deep);
}
END_TEST

START_TEST(what_is_not_finite_gives_zeros)
{
    vec3 p = { 0, (real)NAN, 0 }, q = { 2, 0, 0 };
    deep_contact c = deep_contact_find(around(&p, 1, 1), around(&q, 1, 1));
    ck_assert_msg(!c.ok, "a coordinate is no number, and ok is 1");
    ck_assert_msg(c.gap == 0 && vec3_length(c.normal) == 0, "gap is %g", c.gap);
    ck_assert(vec3_length(c.on_a) == 0 && vec3_length(c.on_b) == 0);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        balls_side_by_side,
        ball_with_its_centre_in_a_cube,
        crossing_capsules_know_the_way,
        capsules_in_one_line_and_balls_in_one_place,
        capsule_falls_through_a_capsule,
        capsule_falls_through_a_box,
        random_bodies_touch_once_they_have_moved,
        what_is_not_finite_gives_zeros,
        NULL
    };
    return suite_run((suite){ .name = "deep", .tests = tests });
}
