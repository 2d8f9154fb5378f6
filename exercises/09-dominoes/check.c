// check.c - tests of the exercise 09/dominoes.

#include "dominoes.h"
#include "suite.h"

#include <check.h>
#include <string.h>

// Some dozen roundings.
static const real ROUNDING = 1e-12;

static const real g = 9.81;                     // m/s^2
static const real ABOVE = 0.005;                // m
static const vec3 SIDES = { 0.2, 1, 0.5 };      // m
static scene stage;
static particle_system w;

static void set_up(void)
{
    scene_init(&stage);
    w = (particle_system){ .bodies = 0 };
}

static void tear_down(void)
{
    system_free(&w);
    scene_free(&stage);
}

static void make_stage(void)
{
    shape box;
    tear_down();
    set_up();
    ck_assert(shape_box(&box, SIDES, 2).ok);
    ck_assert(scene_add_shape(&stage, &box).ok);
    ck_assert(scene_add_plane(&stage, (vec3){ 0, 1, 0 }, 0).ok);
}

static void begin(real gravity)
{
    system_options o = system_options_mended();
    o.gravity = (vec3){ 0, -gravity, 0 };
    ck_assert(system_init(&w, &stage, o).ok);
}

// A floor, and n dominoes.
static void build(int n, real gap, real spin)
{
    make_stage();
    status r = domino_row(&stage, 0, SIDES, n, ABOVE, gap, spin);
    ck_assert_msg(r.ok, "%s", r.why);
    ck_assert_msg(stage.bodies == n, "the scene has %d bodies, wanted %d",
                  stage.bodies, n);
    begin(g);
}

static void vertices(int b, vec3 *at)
{
    for (int k = 0; k < 8; k++)
        at[k] = w.pool.at[w.body[b].first + k].position;
}

static void run(real seconds)
{
    for (int k = 0; k < seconds / w.options.dt; k++) system_step(&w);
}

static int is_down(int b)
{
    return domino_lean(&w, b) > 0.8;
}

START_TEST(least_spin_lifts_the_centre_over_the_edge)
{
    // 0.6 m by 0.8 m: a diagonal of 1 m, a climb of 0.1 m; I = m / 2.
    // Rejects: the inertia about the middle, or of a solid box; the whole
    // diagonal; half forgotten.
    real got = domino_least_spin(0.6, 0.8, 10), wanted = 2;
    ck_assert_msg(fabs(got - wanted) < ROUNDING, "60 cm by 80 cm, g = 10: got "
                  "%.15g rad/s, wanted %.15g", got, wanted);
    // The same, 5/2 times as large and on the moon: w^2 goes as g / length.
    got = domino_least_spin(1.5, 2, 1.6);
    wanted = sqrt(4 * 0.16 / 2.5);
    ck_assert_msg(fabs(got - wanted) < ROUNDING, "on the moon: got %.15g "
                  "rad/s, wanted %.15g", got, wanted);
}
END_TEST

START_TEST(thin_ones_need_little_and_not_nothing)
{
    // For d << h: climb = d^2 / (4 h), w^2 = g d^2 / h^3.
    // Rejects: a diagonal less a height, in which no digit is left.
    for (real d = 1e-3; d > 1e-13; d /= 10) {
        real got = domino_least_spin(d, 1, 10), wanted = sqrt(10) * d;
        ck_assert_msg(fabs(got / wanted - 1) < d * d + ROUNDING, "%g m thick: "
                      "got %.15g rad/s, wanted %.15g", d, got, wanted);
    }
}
END_TEST

START_TEST(row_stands_where_it_should)
{
    // Rejects: a gap from middle to middle; a floor at half height.
    build(3, 0.5, 0);
    for (int b = 0; b < 3; b++) {
        vec3 at[8];
        vertices(b, at);
        for (int k = 0; k < 8; k++) {
            vec3 wanted = { b * 0.7 + (k & 1 ? 0.1 : -0.1),
                            ABOVE + (k & 2 ? 1 : 0), k & 4 ? 0.25 : -0.25 };
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
        ck_assert_msg(domino_lean(&w, b) < 1e-2, "left alone, domino %d leans "
                      "by %g", b, domino_lean(&w, b));
}
END_TEST

START_TEST(first_turns_about_its_edge)
{
    // Rejects: a turn about the middle; one backwards; about the other edge;
    // a row that is pushed as a whole.
    build(2, 0.5, 3);
    for (int k = 0; k < 8; k++) {
        vec3 v = scene_velocity(&stage, 0, k);
        // About (0.1, 0): a point at (x, y) from it moves with 3 (y, -x).
        vec3 wanted = { k & 2 ? 3 : 0, k & 1 ? 0 : 0.6, 0 };
        ck_assert_msg(vec3_distance(v, wanted) < ROUNDING, "vertex %d begins "
                      "with (%g, %g, %g) m/s, wanted (%g, %g, %g)", k, v.x, v.y,
                      v.z, wanted.x, wanted.y, wanted.z);
        ck_assert_msg(vec3_length(scene_velocity(&stage, 1, k)) == 0, "the "
                      "second domino moves, too");
    }
}
END_TEST

START_TEST(lean_is_an_angle)
{
    // Rejects: the sine, which comes back from 90 degrees; degrees.
    const real turn[5] = { 1e-9, 0.5, acos(0.0), 2, acos(-1.0) };
    for (int k = 0; k < 5; k++) {
        make_stage();
        placement p = placement_at((vec3){ 3, 5, 2 });
        real c = cos(turn[k]), s = sin(turn[k]);
        p.y = (vec3){ 0.6 * s, c, 0.8 * s };
        p.x = (vec3){ 0.8, 0, -0.6 };
        p.z = vec3_cross(p.x, p.y);
        ck_assert(scene_add(&stage, 0, p).ok);
        begin(g);
        real got = domino_lean(&w, 0);
        ck_assert_msg(fabs(got - turn[k]) < ROUNDING, "leans by %.12g, got "
                      "%.12g", turn[k], got);
    }
}
END_TEST

START_TEST(less_comes_back_and_more_falls)
{
    real least = domino_least_spin(SIDES.x, SIDES.y, g);
    build(1, 0, 0.9 * least);
    run(2.5);
    ck_assert_msg(!is_down(0), "with 10 %% less than the least push it fell: it "
                  "leans by %g", domino_lean(&w, 0));
    build(1, 0, 1.1 * least);
    run(2.5);
    ck_assert_msg(is_down(0), "with 10 %% more than the least push it did not "
                  "fall: it leans by %g", domino_lean(&w, 0));
}
END_TEST

START_TEST(row_falls_one_after_the_other)
{
    enum { N = 5 };
    build(N, 0.3, 1.5 * domino_least_spin(SIDES.x, SIDES.y, g));
    int fallen_at[N] = { 0 };
    for (int k = 1; k < 180; k++) {
        system_step(&w);
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
    // Rejects: a status that is not passed on.
    make_stage();
    status r = domino_row(&stage, 0, SIDES, 3, ABOVE, (real)NAN, 0);
    ck_assert_msg(!r.ok && *r.why, "a gap that is no number: ok");
    ck_assert_msg(stage.bodies <= 1, "and %d bodies", stage.bodies);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        least_spin_lifts_the_centre_over_the_edge,
        thin_ones_need_little_and_not_nothing,
        row_stands_where_it_should,
        first_turns_about_its_edge,
        lean_is_an_angle,
        less_comes_back_and_more_falls,
        row_falls_one_after_the_other,
        gap_that_is_too_wide_ends_it,
        what_is_no_place_is_refused,
        NULL
    };
    return suite_run((suite){
        .name = "dominoes", .tests = tests, .set_up = set_up,
        .tear_down = tear_down
    });
}
