// check.c - tests of the exercise 07/cradle.

#include "cradle.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>
#include <string.h>

// Speeds of some m/s: differences of positions of up to 1 m, by a step of
// 1/64 s, after some dozen bounces.
static const real ROUNDING = 1e-12;

static const real dt = 0x1p-6;                  // s
enum { MOST = 12, PLENTY = 10000 };

// A row of touching balls, in memory that ends behind the last.
typedef struct {
    int n;
    particle *p;
} row;

static row row_make(int n, const real *mass, const real *speed)
{
    row r = { n, malloc((size_t)n * sizeof(particle)) };
    ck_assert_ptr_nonnull(r.p);
    for (int i = 0; i < n; i++) {
        real w = mass && !(mass[i] > 0) ? 0 : 1 / (mass ? mass[i] : 1);
        vec3 x = { 0.0625 * i, 0.5, 0 };
        r.p[i] = (particle){ x, { x.x - speed[i] * dt, 0.25, -1 }, w };
    }
    return r;
}

static real speed_of(const row *r, int i)
{
    return (r->p[i].position.x - r->p[i].previous.x) / dt;
}

static void expect(const row *r, const real *wanted, const char *what)
{
    for (int i = 0; i < r->n; i++)
        ck_assert_msg(fabs(speed_of(r, i) - wanted[i]) <= ROUNDING * 10,
                      "%s: ball %d of %d leaves at %.10g m/s, wanted %.10g",
                      what, i, r->n, speed_of(r, i), wanted[i]);
}

// Lets equal balls bounce without loss, and looks at their speeds.
static int play(int n, const real *in, const real *out, const char *what)
{
    row r = row_make(n, NULL, in);
    int bounces = cradle_bounce(r.p, n, 1, PLENTY);
    expect(&r, out, what);
    free(r.p);
    return bounces;
}

static unsigned long long seed = 17;

START_TEST(light_and_heavy_bounce_as_in_the_textbook)
{
    // v1' = (m1 v1 + m2 v2 - m2 e (v1 - v2)) / (m1 + m2), and v2' with the
    // indices exchanged.  1 kg at 4 m/s meets 3 kg at 0, e = 1/2.
    // Rejects: masses ignored or exchanged, e ignored, a sign.
    const real mass[2] = { 1, 3 }, in[2] = { 4, 0 }, out[2] = { -0.5, 1.5 };
    row r = row_make(2, mass, in);
    int bounces = cradle_bounce(r.p, 2, 0.5, PLENTY);
    expect(&r, out, "1 kg at 4 m/s runs into 3 kg");
    ck_assert_int_eq(bounces, 1);
    free(r.p);
}
END_TEST

START_TEST(one_comes_in_and_one_leaves)
{
    // Rejects: pairs one too many or too few; a row that moves on as one.
    const real in[5] = { 1, 0, 0, 0, 0 }, out[5] = { 0, 0, 0, 0, 1 };
    int bounces = play(5, in, out, "one ball in");
    ck_assert_msg(bounces == 4, "one ball in, four to pass it on: got %d "
                  "bounces, wanted 4", bounces);
}
END_TEST

START_TEST(it_works_from_the_right_as_well)
{
    // Now an iteration from left to right moves the blow on by one ball alone.
    const real in[5] = { 0, 0, 0, 0, -1 }, out[5] = { -1, 0, 0, 0, 0 };
    ck_assert_int_eq(play(5, in, out, "one ball in from the right"), 4);
}
END_TEST

START_TEST(two_come_in_and_two_leave)
{
    const real in[5] = { 1, 1, 0, 0, 0 }, out[5] = { 0, 0, 0, 1, 1 };
    play(5, in, out, "two balls in");
    const real in3[5] = { 1, 1, 1, 0, 0 }, out3[5] = { 0, 0, 1, 1, 1 };
    play(5, in3, out3, "three of five in: the middle one goes on");
    const real both[5] = { 2, 0, 0, 0, -1 }, back[5] = { -1, 0, 0, 0, 2 };
    play(5, both, back, "one from each side");
}
END_TEST

START_TEST(balls_that_part_are_left)
{
    // Rejects: a bounce of those that part already.
    const real in[3] = { -1, 0, 2 };
    ck_assert_int_eq(play(3, in, in, "parting already"), 0);
}
END_TEST

START_TEST(pinned_ball_is_a_wall)
{
    const real mass[3] = { 1, 1, 0 }, in[3] = { 2, 0, 0 };
    const real out[3] = { -2, 0, 0 };
    row r = row_make(3, mass, in);
    cradle_bounce(r.p, 3, 1, PLENTY);
    expect(&r, out, "a ball, one at rest, a wall");
    free(r.p);
}
END_TEST

START_TEST(two_walls_do_not_bounce)
{
    // Rejects: 0 / 0; an iteration that finds the same two walls over and over.
    const real mass[3] = { 0, 0, 1 }, in[3] = { 1, 0, 0 };
    row r = row_make(3, mass, in);
    ck_assert_int_eq(cradle_bounce(r.p, 3, 1, PLENTY), 0);
    expect(&r, in, "a wall that is carried against a wall");
    free(r.p);
}
END_TEST

START_TEST(tower_of_balls_throws_the_last)
{
    // 1 kg, 1 g and a milligram fall onto a wall at 1 m/s, the heavy one ahead.
    // It turns back first; the next meets it at 2 m/s, and leaves at 3; the
    // last at 7.  Were the ratios of masses infinite: these lose 0.02.
    const real mass[4] = { 0, 1, 1e-3, 1e-6 }, in[4] = { 0, -1, -1, -1 };
    row r = row_make(4, mass, in);
    cradle_bounce(r.p, 4, 1, PLENTY);
    real top = speed_of(&r, 3);
    ck_assert_msg(fabs(top - 7) < 0.03, "the topmost ball leaves at %g m/s, "
                  "wanted nearly 7", top);
    free(r.p);
}
END_TEST

START_TEST(without_restitution_they_leave_as_one)
{
    // Rejects: a loop that waits for the last rounding to be gone.
    const real in[5] = { 5, 0, 0, 0, 0 };
    row r = row_make(5, NULL, in);
    int bounces = cradle_bounce(r.p, 5, 0, PLENTY);
    ck_assert_msg(bounces < PLENTY, "after %d bounces there is still no end: "
                  "what is below 1e-12 of the fastest is no approach", bounces);
    for (int i = 0; i < 5; i++)
        ck_assert_msg(fabs(speed_of(&r, i) - 1) < 1e-9,
                      "ball %d leaves at %.12g m/s, wanted 1", i,
                      speed_of(&r, i));
    free(r.p);
}
END_TEST

START_TEST(cap_is_kept)
{
    const real in[5] = { 1, 0, 0, 0, 0 }, out[5] = { 0, 0, 0, 1, 0 };
    row r = row_make(5, NULL, in);
    int bounces = cradle_bounce(r.p, 5, 1, 3);
    ck_assert_msg(bounces == 3, "cap 3: got %d bounces", bounces);
    expect(&r, out, "three bounces and no more");
    free(r.p);
}
END_TEST

START_TEST(only_previous_moves)
{
    // And that along x alone.
    const real in[3] = { 1, 0, 0 };
    row r = row_make(3, NULL, in);
    particle old[3];
    memcpy(old, r.p, sizeof old);
    cradle_bounce(r.p, 3, 1, PLENTY);
    for (int i = 0; i < 3; i++) {
        ck_assert_msg(vec3_distance(r.p[i].position, old[i].position) == 0,
                      "ball %d: its position has moved", i);
        ck_assert_msg(r.p[i].previous.y == 0.25 && r.p[i].previous.z == -1,
                      "ball %d: previous has moved along y or z", i);
    }
    free(r.p);
}
END_TEST

START_TEST(momentum_stays_and_energy_does_not_grow)
{
    // Random rows; without loss the energy stays, too, and in the end no ball
    // runs into another.
    for (int k = 0; k < 200; k++) {
        int n = 2 + k % (MOST - 1);
        real mass[MOST], speed[MOST], e = k % 2 ? 1 : random_fraction(&seed);
        real momentum = 0, energy = 0;
        for (int i = 0; i < n; i++) {
            mass[i] = 0.25 + 4 * random_fraction(&seed);
            speed[i] = 2 * random_fraction(&seed) - 1;
        }
        row r = row_make(n, mass, speed);
        for (int i = 0; i < n; i++) {
            momentum -= mass[i] * speed_of(&r, i);
            energy -= mass[i] * speed_of(&r, i) * speed_of(&r, i);
        }
        cradle_bounce(r.p, n, e, PLENTY);
        for (int i = 0; i < n; i++) {
            real v = speed_of(&r, i);
            momentum += mass[i] * v;
            energy += mass[i] * v * v;
            ck_assert_msg(i == 0 || speed_of(&r, i - 1) <= v + ROUNDING * 10,
                          "ball %d still runs into ball %d", i - 1, i);
        }
        ck_assert_msg(fabs(momentum) < 100 * ROUNDING,
                      "momentum has changed by %g kg m/s", momentum);
        ck_assert_msg(energy < 100 * ROUNDING, "energy has grown by %g J",
                      energy / 2);
        ck_assert_msg(e < 1 || energy > -100 * ROUNDING,
                      "without loss, energy has shrunk by %g J", -energy / 2);
        free(r.p);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        light_and_heavy_bounce_as_in_the_textbook,
        one_comes_in_and_one_leaves,
        it_works_from_the_right_as_well,
        two_come_in_and_two_leave,
        balls_that_part_are_left,
        pinned_ball_is_a_wall,
        two_walls_do_not_bounce,
        tower_of_balls_throws_the_last,
        without_restitution_they_leave_as_one,
        cap_is_kept,
        only_previous_moves,
        momentum_stays_and_energy_does_not_grow,
        NULL
    };
    return suite_run((suite){ .name = "cradle", .tests = tests });
}
