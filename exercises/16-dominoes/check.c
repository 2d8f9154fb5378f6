// check.c - tests of the exercise 16/dominoes.

#include "dominoes.h"

#include <check.h>
#include <string.h>

// Some dozen roundings.
static const real ROUNDING = 1e-12;

static const real g = 9.81;                     // m/s^2
static const vec3 SIDES = { 0.2, 1, 0.5 };      // m
static shape plan;
static world w;

static void set_up(void)
{
    ck_assert(shape_box(&plan, SIDES, 2).ok);
}

static void tear_down(void)
{
    world_free(&w);
    shape_free(&plan);
}

// A floor, and n dominoes.
static void build(int n, real gap, real spin)
{
    world_options o = world_options_default();
    o.friction = 0.5;
    o.restitution = 0;
    o.gravity = (vec3){ 0, -g, 0 };
    ck_assert(world_init(&w, o).ok);
    ck_assert(world_add_plane(&w, (vec3){ 0, 1, 0 }, 0).ok);
    status r = domino_row(&w, &plan, SIDES, n, gap, spin);
    ck_assert_msg(r.ok, "%s", r.why);
    ck_assert_msg(w.bodies == n, "the world has %d bodies, wanted %d", w.bodies,
                  n);
    ck_assert(world_begin(&w).ok);
}

static void run(real seconds)
{
    for (int k = 0; k < seconds / w.options.dt; k++) world_step(&w);
}

static int is_down(int b)
{
    return domino_lean(&w, b) > 0.8;
}

START_TEST(least_spin_lifts_the_centre_over_the_edge)
{
    // 0.6 m by 0.8 m: a diagonal of 1 m, a climb of 0.1 m; I = m / 3.
    // Rejects: the inertia about the middle; the whole diagonal; half
    // forgotten.
    real got = domino_least_spin(0.6, 0.8, 10), wanted = sqrt(6);
    ck_assert_msg(fabs(got - wanted) < ROUNDING, "60 cm by 80 cm, g = 10: got "
                  "%.15g rad/s, wanted %.15g", got, wanted);
    // The same, 5/2 times as large and on the moon: w^2 goes as g / length.
    got = domino_least_spin(1.5, 2, 1.6);
    wanted = sqrt(6 * 0.16 / 2.5);
    ck_assert_msg(fabs(got - wanted) < ROUNDING, "on the moon: got %.15g "
                  "rad/s, wanted %.15g", got, wanted);
}
END_TEST

START_TEST(thin_ones_need_little_and_not_nothing)
{
    // For d << h: climb = d^2 / (4 h), w^2 = 1.5 g d^2 / h^3.
    // Rejects: a diagonal less a height, in which no digit is left.
    for (real d = 1e-3; d > 1e-13; d /= 10) {
        real got = domino_least_spin(d, 1, 10), wanted = sqrt(15) * d;
        ck_assert_msg(fabs(got / wanted - 1) < d * d + ROUNDING, "%g m thick: "
                      "got %.15g rad/s, wanted %.15g", d, got, wanted);
    }
}
END_TEST

START_TEST(row_stands_where_it_should)
{
    // Rejects: a gap from middle to middle; a floor at half height; no skin.
    build(3, 0.5, 0);
    real above = w.options.skin * plan.radius;
    for (int b = 0; b < 3; b++) {
        vec3 at[8];
        world_vertices(&w, &w.body[b], at);
        for (int k = 0; k < 8; k++) {
            vec3 wanted = { b * 0.7 + (k & 1 ? 0.1 : -0.1),
                            above + (k & 2 ? 1 : 0), k & 4 ? 0.25 : -0.25 };
            ck_assert_msg(vec3_distance(at[k], wanted) < ROUNDING, "domino %d: "
                          "vertex %d is at (%g, %g, %g), wanted (%g, %g, %g)",
                          b, k, at[k].x, at[k].y, at[k].z, wanted.x, wanted.y,
                          wanted.z);
        }
        ck_assert_msg(domino_lean(&w, b) < ROUNDING, "upright, it leans by %g",
                      domino_lean(&w, b));
    }
    run(1);
    for (int b = 0; b < 3; b++)
        ck_assert_msg(domino_lean(&w, b) < 1e-3, "left alone, domino %d leans "
                      "by %g", b, domino_lean(&w, b));
}
END_TEST

START_TEST(first_turns_about_its_edge)
{
    // In a moment of 1/960 s without gravity's help.
    // Rejects: a turn about the middle; one backwards; about the other edge;
    // a row that is pushed as a whole.
    build(2, 0.5, 3);
    vec3 before[8], after[8], other[8];
    world_vertices(&w, &w.body[0], before);
    world_free(&w);
    build(2, 0.5, 3);
    w.options.dt = 1.0 / 960;
    w.options.substeps = w.options.most_substeps = 1;
    world_vertices(&w, &w.body[1], other);
    world_step(&w);
    world_vertices(&w, &w.body[0], after);
    for (int k = 0; k < 8; k++) {
        vec3 v = vec3_scale(960, vec3_sub(after[k], before[k]));
        // About (0.1, 0): a point at (x, y) from it moves with 3 (y, -x).
        vec3 wanted = { k & 2 ? 3 : 0, k & 1 ? 0 : 0.6, 0 };
        ck_assert_msg(vec3_distance(v, wanted) < 0.05, "vertex %d begins with "
                      "(%g, %g, %g) m/s, wanted (%g, %g, %g)", k, v.x, v.y, v.z,
                      wanted.x, wanted.y, wanted.z);
    }
    world_vertices(&w, &w.body[1], after);
    for (int k = 0; k < 8; k++)
        ck_assert_msg(vec3_distance(after[k], other[k]) < 1e-4, "the second "
                      "domino moves, too");
}
END_TEST

START_TEST(lean_is_an_angle)
{
    // Rejects: the sine, which comes back from 90 degrees; degrees.
    build(1, 0, 0);
    const real turn[5] = { 1e-9, 0.5, acos(0.0), 2, acos(-1.0) };
    for (int k = 0; k < 5; k++) {
        world_free(&w);
        ck_assert(world_init(&w, world_options_default()).ok);
        placement p = placement_at((vec3){ 3, 5, 2 });
        real c = cos(turn[k]), s = sin(turn[k]);
        p.y = (vec3){ 0.6 * s, c, 0.8 * s };
        p.x = (vec3){ 0.8, 0, -0.6 };
        p.z = vec3_cross(p.x, p.y);
        ck_assert(world_add(&w, &plan, p, NULL).ok);
        ck_assert(world_begin(&w).ok);
        real got = domino_lean(&w, 0);
        ck_assert_msg(fabs(got - turn[k]) < ROUNDING, "leans by %.12g, got "
                      "%.12g", turn[k], got);
    }
}
END_TEST

START_TEST(less_comes_back_and_more_falls)
{
    real least = domino_least_spin(SIDES.x, SIDES.y, g);
    build(1, 0, 0.96 * least);
    run(2.5);
    ck_assert_msg(!is_down(0), "with 4 %% less than the least push it fell: it "
                  "leans by %g", domino_lean(&w, 0));
    world_free(&w);
    build(1, 0, 1.04 * least);
    run(2.5);
    ck_assert_msg(is_down(0), "with 4 %% more than the least push it did not "
                  "fall: it leans by %g", domino_lean(&w, 0));
}
END_TEST

START_TEST(row_falls_one_after_the_other)
{
    enum { N = 5 };
    build(N, 0.3, 1.5 * domino_least_spin(SIDES.x, SIDES.y, g));
    int fallen_at[N] = { 0 };
    for (int k = 1; k < 180; k++) {
        world_step(&w);
        for (int b = 0; b < N; b++)
            if (!fallen_at[b] && domino_lean(&w, b) > 0.3) fallen_at[b] = k;
    }
    for (int b = 0; b < N; b++) {
        ck_assert_msg(fallen_at[b] > 0, "domino %d stands", b);
        ck_assert_msg(b == 0 || fallen_at[b] > fallen_at[b - 1], "domino %d "
                      "fell in frame %d, and the one before it in frame %d", b,
                      fallen_at[b], b ? fallen_at[b - 1] : 0);
    }
}
END_TEST

START_TEST(gap_that_is_too_wide_ends_it)
{
    build(3, 1.1, 1.5 * domino_least_spin(SIDES.x, SIDES.y, g));
    run(3);
    ck_assert_msg(is_down(0), "the first one stands");
    ck_assert_msg(!is_down(1) && !is_down(2), "1.1 m further on another fell, "
                  "though dominoes are 1 m high");
}
END_TEST

START_TEST(what_is_no_place_is_refused)
{
    // Rejects: a status that nobody passes on.
    ck_assert(world_init(&w, world_options_default()).ok);
    status r = domino_row(&w, &plan, SIDES, 3, (real)NAN, 0);
    ck_assert_msg(!r.ok && *r.why, "a gap that is no number: ok");
    ck_assert_msg(w.bodies <= 1, "and %d bodies", w.bodies);
}
END_TEST

int main(void)
{
    Suite *s = suite_create("dominoes");
    TCase *t = tcase_create("dominoes");
    tcase_add_checked_fixture(t, set_up, tear_down);
    tcase_add_test(t, least_spin_lifts_the_centre_over_the_edge);
    tcase_add_test(t, thin_ones_need_little_and_not_nothing);
    tcase_add_test(t, row_stands_where_it_should);
    tcase_add_test(t, first_turns_about_its_edge);
    tcase_add_test(t, lean_is_an_angle);
    tcase_add_test(t, less_comes_back_and_more_falls);
    tcase_add_test(t, row_falls_one_after_the_other);
    tcase_add_test(t, gap_that_is_too_wide_ends_it);
    tcase_add_test(t, what_is_no_place_is_refused);
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed != 0;
}
