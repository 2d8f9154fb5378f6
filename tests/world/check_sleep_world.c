// check_sleep_world.c - what should sleep in a world does, and nothing else.
// Book: chapter 18.

#include <check.h>
#include <stdlib.h>

#include "convex.h"
#include "expect.h"
#include "probe.h"
#include "random.h"
#include "step.h"
#include "suite.h"

#define EARTH 9.81
#define PI 3.14159265358979

static shape box;
static world w;
static unsigned long long seed;

static void tear_down(void)
{
    world_free(&w);
    shape_free(&box);
}

static void begin(real dt, real mu)
{
    world_options o = world_options_default();
    world_free(&w);
    o.dt = dt;
    o.friction = mu;
    expect_ok(world_init(&w, o));
}

static void make_box(real side)
{
    shape_free(&box);
    expect_ok(shape_box(&box, vec3_make(side, side, side), 1));
}

static int add(placement where)
{
    int number;
    expect_ok(world_add(&w, &box, where, &number));
    return number;
}

static void add_plane(vec3 normal, real offset)
{
    expect_ok(world_add_plane(&w, normal, offset));
}

static void add_floor(void)
{
    add_plane(vec3_make(0, 1, 0), 0);
}

// Turned about z by a (rad).
static placement turned(vec3 at, real a)
{
    placement p = placement_at(at);
    p.x = vec3_make(cos(a), sin(a), 0);
    p.y = vec3_make(-sin(a), cos(a), 0);
    return p;
}

static vec3 center(int b)
{
    return rigid4_frame(w.pool.at + w.body[b].first).center;
}

// Which way axis 1 of body b points.
static vec3 upright(int b)
{
    return vec3_unit(rigid4_frame(w.pool.at + w.body[b].first).axis[1]);
}

// Steps for t seconds, or until so many bodies sleep; returns when that was (s,
// HUGE_VAL: never).
static real run(real t, int sleepers)
{
    int n = (int)(t / w.options.dt + 0.5);
    for (int k = 1; k <= n; k++) {
        world_step(&w);
        if (w.report.asleep >= sleepers) return k * w.options.dt;
    }
    return HUGE_VAL;
}

// --- slopes ------------------------------------------------------------------

// A cube put down on a slope whose tangent is mu + beyond.  It slides
// 1/2 g cos(a) beyond t^2; returns how far it did in t (s) beside that.
static real slide(real mu, real beyond, real side, real dt, real t)
{
    real a = atan(mu + beyond);
    vec3 up = { -sin(a), cos(a), 0 };
    make_box(side);
    begin(dt, mu);
    add_plane(up, 0);
    add(turned(vec3_scale(side / 2, up), a));
    vec3 before = center(0);
    real slept = run(t, 1), far = vec3_distance(before, center(0));
    if (beyond < 0) {
        real most = real_max(0.03, 2 * dt) * real_max(side, 1);
        ck_assert_msg(slept < t && far < most,
                      "mu %g, side %g, dt %g: slid %g m", mu, side, dt, far);
        return 0;
    }
    ck_assert_msg(slept == HUGE_VAL, "mu %g, side %g, dt %g: asleep at %g s",
                  mu, side, dt, slept);
    return far / (EARTH * cos(a) * beyond * t * t / 2);
}

// Some speed is gained before friction is as large as it will be: the more, the
// longer the first frame.
static void expect_slope(real mu, real side, real dt)
{
    real t = 10 * sqrt(real_max(side, 1));
    real far = slide(mu, 0.0005, side, dt, t);
    ck_assert_msg(far > 0.95 && far < 4, "mu %g, side %g, dt %g: %g", mu,
                  side, dt, far);
    slide(mu, -0.0005, side, dt, t);
}

// Rejects: a slope that holds what it cannot (0.9 mm for 0.2 m, and more).
START_TEST(slope_beyond_the_cone_is_slid_down)
{
    expect_slope(0.5, 1, 1.0 / 60);
    expect_slope(0.1, 1, 1.0 / 60);
    expect_slope(0.5, 1, 1.0 / 240);
    expect_slope(0.5, 1, 1.0 / 15);
}
END_TEST

// Rejects: limits that are good for a metre only.
START_TEST(slopes_are_the_same_for_a_pebble_and_a_mountain)
{
    expect_slope(0.5, 0.01, 1.0 / 60);
    expect_slope(0.5, 1000, 1.0 / 15);
}
END_TEST

// --- edges and rolls ---------------------------------------------------------

// A cube on its edge, off balance by so much (rad); t s.
static void expect_fall(real off, real side, real dt, real t)
{
    make_box(side);
    begin(dt, 0.5);
    add_floor();
    add(turned(vec3_make(0, side * sqrt(0.5) * cos(off), 0), PI / 4 + off));
    vec3 before = upright(0);
    real slept = run(t, 1);
    ck_assert_msg(slept < t, "side %g, dt %g: awake", side, dt);
    ck_assert_msg(vec3_distance(before, upright(0)) > 0.7,
                  "side %g, dt %g: asleep on its edge", side, dt);
}

// Rejects: a cube that sleeps on its edge.
START_TEST(cube_on_its_edge_falls)
{
    expect_fall(0.0003, 1, 1.0 / 60, 10);
    expect_fall(-0.0003, 1, 1.0 / 60, 10);
    expect_fall(0.0003, 1, 1.0 / 240, 10);
    expect_fall(0.0003, 1, 1.0 / 15, 10);
    expect_fall(0.0003, 0.01, 1.0 / 60, 10);
    expect_fall(0.0003, 1000, 1.0 / 15, 300);
}
END_TEST

// A prism with 16 sides, along z.
static void make_roll(real r)
{
    enum { SIDES_OF_ROLL = 16 };
    vec3 at[2 * SIDES_OF_ROLL];
    int face[4 * SIDES_OF_ROLL][3], n = 0;
    for (int k = 0; k < SIDES_OF_ROLL; k++) {
        real a = 2 * PI * k / SIDES_OF_ROLL;
        int a0 = 2 * k, b0 = 2 * ((k + 1) % SIDES_OF_ROLL);
        const int side[2][3] = { { a0, b0, b0 + 1 }, { a0, b0 + 1, a0 + 1 } };
        for (int end = 0; end < 2; end++) {
            at[a0 + end] = vec3_make(r * sin(a), -r * cos(a), r * (end - 0.5));
            for (int i = 0; i < 3; i++) face[n][i] = side[end][i];
            n++;
        }
        if (k == 0 || k == SIDES_OF_ROLL - 1) continue;
        const int cap[2][3] = { { 0, b0, a0 }, { 1, a0 + 1, b0 + 1 } };
        for (int end = 0; end < 2; end++, n++)
            for (int i = 0; i < 3; i++) face[n][i] = cap[end][i];
    }
    shape_free(&box);
    expect_ok(shape_convex(&box, 2 * SIDES_OF_ROLL, at, n,
                           (const int (*)[3])face, 1));
}

// On a slope that is `beyond` steeper than its sides let it stand on.
static real roll(real beyond)
{
    real a = PI / 16 + beyond, high = 0.5 * cos(PI / 16);
    vec3 up = { -sin(a), cos(a), 0 };
    make_roll(0.5);
    begin(1.0 / 60, 0.5);
    add_plane(up, 0);
    add(turned(vec3_scale(high, up), a + PI / 16));
    vec3 before = center(0);
    real slept = run(10, 1);
    ck_assert_msg((slept < 10) == (beyond < 0), "%g: asleep at %g s", beyond,
                  slept);
    return vec3_distance(before, center(0));
}

// Rejects: a roll that sleeps on the edge between two of its sides.
START_TEST(roll_goes_on_where_the_slope_lets_it)
{
    ck_assert(roll(0.0005) > 3);
    ck_assert(roll(0.01) > 3);
    ck_assert(roll(-0.001) < 0.01);
}
END_TEST

// --- without gravity, without friction ---------------------------------------

// Rejects: a slow drift, or a slow spin, that ends.
START_TEST(what_drifts_in_space_goes_on)
{
    const real speed[] = { 0.015, 1e-4 };
    for (int k = 0; k < 2; k++) {
        make_box(1);
        begin(1.0 / 60, 0.5);
        w.options.gravity = vec3_make(0, 0, 0);
        placement p = placement_at(vec3_make(0, 0, 0));
        p.velocity = vec3_make(speed[k], 0, 0);
        add(p);
        p.position.y = 5;
        p.velocity.x = 0;
        p.spin = vec3_make(0, 0, speed[k]);
        add(p);
        p.position.y = 10;
        p.spin.z = 0;
        add(p);
        ck_assert(run(20, 2) == HUGE_VAL);
        ck_assert(probe_sleeps(&w, 2));
        ck_assert(fabs(center(0).x - 20 * speed[k]) < 1e-9);
        ck_assert(fabs(upright(1).x + sin(20 * speed[k])) < 1e-6);
    }
}
END_TEST

// Rejects: ice on which what glides at 1.5 cm/s falls asleep.
START_TEST(what_glides_without_friction_goes_on)
{
    make_box(1);
    begin(1.0 / 60, 0);
    add_floor();
    placement p = placement_at(vec3_make(0, 0.5, 0));
    p.velocity = vec3_make(0.015, 0, 0);
    add(p);
    ck_assert(run(20, 1) == HUGE_VAL);
    ck_assert(fabs(center(0).x - 0.3) < 1e-3);
}
END_TEST

// Rejects: a body that hangs in the air, at the top of its flight.
START_TEST(what_is_thrown_up_comes_down)
{
    const real g[] = { EARTH, 0.01, 1e-5 };
    for (int k = 0; k < 3; k++) {
        make_box(1);
        begin(1.0 / 60, 0.5);
        w.options.gravity = vec3_make(0, -g[k], 0);
        placement p = placement_at(vec3_make(0, 0, 0));
        p.velocity = vec3_make(0, 2 * g[k], 0);
        add(p);
        ck_assert_msg(run(4, 1) == HUGE_VAL, "g %g", g[k]);
        ck_assert(fabs(center(0).y) < 0.02 * g[k]);
    }
}
END_TEST

// --- piles -------------------------------------------------------------------

static void add_pyramid(int rows, vec3 at)
{
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < rows - i; j++) {
            vec3 beside = { j + 0.5 * i - 0.5 * rows, i + 0.5, 0 };
            add(placement_at(vec3_add(at, beside)));
        }
}

// Rejects: a pile whose clocks wait for each other; a creeping that keeps all
// awake.
START_TEST(pyramid_is_asleep_within_a_second)
{
    make_box(1);
    begin(1.0 / 60, 0.5);
    add_floor();
    add_pyramid(20, vec3_make(0, 0, 0));
    vec3 placed = center(209);
    ck_assert(run(1, 210) <= 1);
    vec3 top = center(209);
    ck_assert(vec3_distance(placed, top) < 0.02);
    ck_assert(run(5, 211) == HUGE_VAL && w.report.asleep == 210);
    ck_assert(vec3_distance(top, center(209)) == 0);
}
END_TEST

// 100 cubes, let go in a room: asleep within 15 s, and then nothing moves.
static void drop(real restitution)
{
    seed = 3;
    make_box(0.5);
    begin(1.0 / 60, 0.5);
    w.options.restitution = restitution;
    add_floor();
    for (int k = 0; k < 4; k++) {
        real s = k % 2 ? 1 : -1;
        add_plane(k < 2 ? vec3_make(s, 0, 0) : vec3_make(0, 0, s), -2);
    }
    for (int k = 0; k < 100; k++) {
        real x = k % 4 - 1.5, z = k / 4 % 4 - 1.5;
        add(turned(vec3_make(x, 0.5 + k / 16, z), PI * random_real(&seed)));
    }
    real t = run(15, 100);
    ck_assert_msg(t < 15, "restitution %g: %d asleep", restitution,
                  w.report.asleep);
    ck_assert(run(1, 101) == HUGE_VAL && w.report.asleep == 100);
}

// Rejects: neighbours that wake each other for ever; impacts that go on.
START_TEST(cubes_in_a_room_fall_asleep)
{
    drop(0);
    drop(0.6);
}
END_TEST

// Two towers; a cube flies into the first.  Rejects: a tower that sleeps on as
// it is hit; one that wakes because another does.
START_TEST(what_is_hit_wakes_and_its_island_with_it)
{
    make_box(1);
    begin(1.0 / 60, 0.5);
    add_floor();
    for (int k = 0; k < 10; k++)
        add(placement_at(vec3_make(k < 5 ? 0 : 20, k % 5 + 0.5, 0)));
    placement p = placement_at(vec3_make(-26, 20, 0));
    p.velocity = vec3_make(14, 0, 0);
    add(p);
    ck_assert(run(1.2, 10) < 1.2);
    vec3 top = center(4), other = center(9);
    // It comes down to 3 m as it arrives.
    run(2.2 - w.time, 11);
    ck_assert(vec3_distance(top, center(4)) > 0.1);
    ck_assert_int_eq(w.report.asleep, 5);
    ck_assert(vec3_distance(other, center(9)) == 0);
}
END_TEST

// On ice, a cube slides by a sleeper at 4 m/s: their balls meet, and they do not.
// How far the sleeper has gone then.
static real pass_by(real beside)
{
    make_box(1);
    begin(1.0 / 60, 0);
    add_floor();
    add(placement_at(vec3_make(0, 0.5, 0)));
    ck_assert(run(2, 1) < 2);
    placement p = placement_at(vec3_make(beside, 0.5, -4));
    p.velocity = vec3_make(0, 0, 4);
    add(p);
    for (int k = 0; k < 120; k++) {
        world_step(&w);
        ck_assert(beside < 1 || w.report.asleep == 1);
    }
    ck_assert(center(1).z > 2 || beside < 1);
    return vec3_length(vec3_sub(center(0), vec3_make(0, 0.5, 0)));
}

// Rejects: a sleeper that wakes because a ball around it is touched; one that
// sleeps on as it is hit.
START_TEST(what_passes_by_wakes_nothing_and_what_hits_does)
{
    ck_assert(pass_by(1.3) < 0.01);
    ck_assert(pass_by(1.5) < 0.01);
    ck_assert(pass_by(0.9) > 1);
}
END_TEST

enum { ROW = 4 };

// Cubes in a row, `gap` (m) apart, without gravity, and after a second one more,
// `from` (m) before them, at 2 m/s.  Writes how fast each goes at last (m/s).
static void hit_row(bool sleeps, real gap, real from, real speed[ROW + 1])
{
    make_box(1);
    begin(1.0 / 60, 0.5);
    w.options.gravity = (vec3){ 0, 0, 0 };
    if (!sleeps) w.options.sleep_speed = 0;
    for (int k = 0; k < ROW; k++)
        add(placement_at(vec3_make((1 + gap) * k, 0, 0)));
    run(1, ROW + 1);
    ck_assert_int_eq(w.report.asleep, sleeps ? ROW : 0);
    placement p = placement_at(vec3_make(-1 - from, 0, 0));
    p.velocity = vec3_make(2, 0, 0);
    add(p);
    run(2, ROW + 1);
    for (int k = 0; k <= ROW; k++) speed[k] = probe_velocity(&w, k)->of[0];
}

// What stands side by side and presses nothing is asleep one by one.
// Rejects: a sleeper that is a rock in the frame in which its neighbour is hit, or
// beside which something has just come that flies.
START_TEST(row_that_sleeps_is_hit_as_one_that_is_awake)
{
    static const real gap[] = { 0, 1e-3, 1e-2 }, from[] = { 0.01, 1 };
    for (int k = 0; k < 6; k++) {
        real asleep[ROW + 1], awake[ROW + 1];
        hit_row(true, gap[k % 3], from[k / 3], asleep);
        hit_row(false, gap[k % 3], from[k / 3], awake);
        for (int b = 0; b <= ROW; b++)
            ck_assert_msg(fabs(asleep[b] - awake[b]) < 1e-9,
                          "gap %g m, from %g m, cube %d: %g m/s, not %g",
                          gap[k % 3], from[k / 3], b, asleep[b], awake[b]);
    }
}
END_TEST

// A tower of ten, each cube a millimetre off, sways for two seconds, and cannot
// fall.  Leaning at 1 cm/s does not keep it awake; a cube that tips over is, with
// the same speed, and so is one that slides.
// Rejects: a sway that is taken for a fall.
START_TEST(tower_that_sways_sleeps)
{
    for (int throw = 1; throw < 5; throw++) {
        seed = (unsigned long long)throw;
        make_box(1);
        begin(1.0 / 60, 0.5);
        add_floor();
        for (int k = 0; k < 10; k++) {
            vec3 off = random_vec3(&seed, 0.001);
            add(placement_at(vec3_make(off.x, k + 0.5, off.z)));
        }
        real t = run(3, 10);
        ck_assert_msg(t < 0.8, "throw %d: %g s", throw, t);
    }
}
END_TEST

// Rejects: an option that nothing reads.
START_TEST(without_sleep_speed_no_body_sleeps)
{
    make_box(1);
    begin(1.0 / 60, 0.5);
    w.options.sleep_speed = 0;
    add_floor();
    add(placement_at(vec3_make(0, 0.5, 0)));
    ck_assert(run(5, 1) == HUGE_VAL);
}
END_TEST

// Rejects: another.
START_TEST(time_to_sleep_is_the_time_to_sleep)
{
    for (real t = 0.125; t < 5; t *= 2) {
        make_box(1);
        begin(1.0 / 64, 0.5);
        w.options.time_to_sleep = t;
        add_floor();
        add(placement_at(vec3_make(0, 0.5, 0)));
        real slept = run(10, 1);
        ck_assert_msg(slept >= t && slept <= 1.5 * t + 0.3, "%g: %g s", t,
                      slept);
    }
}
END_TEST

// --- what sleeps costs nothing -----------------------------------------------

// A stack of four sleeps while a cube slides by, far away, for two seconds, and
// its pairs are in no list.  It wakes with what it knew.
// Rejects: contacts that are asked for again, or that have lost their impulses:
// the stack would sink; a stack that is no more one island; steps that go over
// what sleeps.
START_TEST(what_wakes_has_the_contacts_with_which_it_fell_asleep)
{
    make_box(1);
    begin(1.0 / 60, 0);
    add_floor();
    for (int k = 0; k < 4; k++) add(placement_at(vec3_make(0, k + 0.5, 0)));
    ck_assert(run(5, 4) < 5);
    int contacts = w.report.contacts;
    placement far = placement_at(vec3_make(30, 0.5, 0));
    far.velocity = vec3_make(4, 0, 0);
    int slider = add(far);
    run(2, 5);
    ck_assert_int_eq(w.report.asleep, 4);
    ck_assert_int_eq(w.report.contacts, 1);
    ck_assert_int_eq(w.report.pairs, 3);
    ck_assert_int_eq(probe_awake(&w), 1);
    world_remove(&w, slider);
    real high = center(3).y;
    world_wake(&w, 0);
    world_step(&w);
    ck_assert_int_eq(w.report.asleep, 0);
    ck_assert_int_eq(w.report.queries, 0);
    ck_assert_int_eq(w.report.contacts, contacts);
    run(0.2, 4);
    real sunk = high - center(3).y;
    ck_assert_msg(fabs(sunk) < 1e-3, "sunk by %g m", sunk);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        what_wakes_has_the_contacts_with_which_it_fell_asleep,
        slope_beyond_the_cone_is_slid_down,
        slopes_are_the_same_for_a_pebble_and_a_mountain,
        cube_on_its_edge_falls,
        roll_goes_on_where_the_slope_lets_it,
        what_drifts_in_space_goes_on,
        what_glides_without_friction_goes_on,
        what_is_thrown_up_comes_down,
        pyramid_is_asleep_within_a_second,
        cubes_in_a_room_fall_asleep,
        what_is_hit_wakes_and_its_island_with_it,
        what_passes_by_wakes_nothing_and_what_hits_does,
        row_that_sleeps_is_hit_as_one_that_is_awake,
        tower_that_sways_sleeps,
        without_sleep_speed_no_body_sleeps,
        time_to_sleep_is_the_time_to_sleep,
        NULL
    };
    return suite_run((suite){
        .name = "sleep in a world", .tests = tests, .tear_down = tear_down,
        .seconds = 60
    });
}
