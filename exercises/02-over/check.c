// check.c - tests of the exercise 02/over.

#include "over.h"
#include "expect.h"
#include "suite.h"

#include <check.h>
#include <stdio.h>
#include <string.h>

// Some dozen roundings of numbers near 1.
static const real ROUNDING = 1e-14;
// A stick's answer to small errors bends by about the error itself, 1e-6 here.
static const real BENT = 1e-5;
// A rate taken over two hundred iterations still swings with the phase at its ends.
static const real SWING = 0.01;

static const real PI = 3.14159265358979323846;

enum { MOST = 64 };

static particle at(real x, real y, real z, real inverse_mass)
{
    return (particle){ { x, y, z }, { x, y, z }, inverse_mass };
}

// A straight chain of n sticks of 1 m; stick k is too long by half a sine wave
// over the chain, 1e-6 m at its top: the error that dies out most slowly.
static void chain(int n, stick *s, particle *p)
{
    real x = 0;
    p[0] = at(0, 0, 0, 1);
    for (int k = 0; k < n; k++) {
        x += 1 + 1e-6 * sin(PI * (k + 1) / (n + 1));
        p[k + 1] = at(x, 0, 0, 1);
        s[k] = (stick){ k, k + 1, 1, 1, STICK_EXACT };
    }
}

static real worst(const stick *s, int n, const particle *p)
{
    real most = 0;
    for (int k = 0; k < n; k++) most = fmax(most, stick_strain(s[k], p));
    return most;
}

START_TEST(one_stick_goes_too_far_by_omega)
{
    // 1 m too long, b weighs a third; omega 1.5.  Rejects: omega for the rest
    // length, for one end only; moves that forget the masses.
    particle p[2] = { at(0, 0, 0, 1), at(0, 3, 0, 3) };
    stick s = { 0, 1, 2, 1, STICK_EXACT };
    over_iterate(&s, 1, p, 1.5);
    near(p[0].position.y, 0.375, ROUNDING, "height of a", "1.5 times 1/4 m.");
    near(p[1].position.y, 1.875, ROUNDING, "height of b", "1.5 times 3/4 m.");
}
END_TEST

START_TEST(omega_1_is_the_plain_iteration)
{
    // Rejects: sticks that do not see what the one before has moved, a stick
    // left out, one past the end.
    stick s[20];
    particle p[21], q[21];
    chain(20, s, p);
    for (int i = 0; i < 21; i++) p[i].position.y = 0.25 * (i % 3);
    memcpy(q, p, sizeof p);
    for (int k = 0; k < 3; k++) {
        over_iterate(s, 20, p, 1);
        sticks_iterate(s, 20, q, relax_options_pbd());
    }
    for (int i = 0; i < 21; i++)
        near(vec3_distance(p[i].position, q[i].position), 0, 100 * ROUNDING,
             "metres beside where sticks_iterate puts a particle",
             "One after the other, each from where the last has left it.");
}
END_TEST

START_TEST(jacobi_corrects_one_stick_at_once)
{
    // The room for the moves comes with something in it.  Rejects: moves on
    // top of that; equal moves; moves the wrong way.
    particle p[2] = { at(0, 0, 0, 1), at(0, 3, 0, 3) };
    stick s = { 0, 1, 2, 1, STICK_EXACT };
    vec3 move[2] = { { 9, 9, 9 }, { 9, 9, 9 } };
    jacobi_iterate(&s, 1, p, 2, move);
    near(p[0].position.y, 0.25, ROUNDING, "height of a", "A quarter of 1 m.");
    near(p[1].position.y, 2.25, ROUNDING, "height of b", "Three quarters.");
    near(p[0].position.x, 0, ROUNDING, "x of a",
         "move came with (9, 9, 9) in it.");
}
END_TEST

START_TEST(jacobi_is_the_same_in_any_order)
{
    // Rejects: one stick that sees what another has moved.
    stick s[20], t[20];
    particle p[21], q[21];
    vec3 move[21];
    chain(20, s, p);
    for (int i = 0; i < 21; i++) p[i].position.y = 0.25 * (i % 3);
    memcpy(q, p, sizeof p);
    for (int k = 0; k < 20; k++) t[k] = s[(7 * k) % 20];
    jacobi_iterate(s, 20, p, 21, move);
    jacobi_iterate(t, 20, q, 21, move);
    for (int i = 0; i < 21; i++)
        near(vec3_distance(p[i].position, q[i].position), 0, 100 * ROUNDING,
             "metres between the two orders",
             "Measure all sticks first, and then move.");
}
END_TEST

START_TEST(nowhere_to_go_stays)
{
    // Rejects: 0 / 0, for ends in one place and for two pinned ends.
    particle p[3] = { at(1, 0, 0, 0), at(1, 0, 0, 1), at(4, 0, 0, 0) };
    stick s[2] = { { 0, 1, 1, 1, STICK_EXACT }, { 0, 2, 1, 1, STICK_EXACT } };
    vec3 move[3];
    jacobi_iterate(s, 2, p, 3, move);
    over_iterate(s, 2, p, 1.5);
    for (int i = 0; i < 3; i++)
        near(p[i].position.x, i < 2 ? 1 : 4, 0, "x", "Nothing can move.");
}
END_TEST

START_TEST(jacobi_leaves_a_cosine_of_the_slowest_wave)
{
    // Rejects: Gauss-Seidel (the square), sticks that divide what they need.
    for (int n = 1; n <= 50; n += 7) {
        stick s[MOST];
        particle p[MOST];
        vec3 move[MOST];
        chain(n, s, p);
        real before = worst(s, n, p);
        jacobi_iterate(s, n, p, n + 1, move);
        ck_assert_msg(fabs(worst(s, n, p) / before - cos(PI / (n + 1))) <= BENT,
                      "%d sticks: one iteration leaves %g of the error, wanted "
                      "cos(pi / %d) = %g", n, worst(s, n, p) / before, n + 1,
                      cos(PI / (n + 1)));
    }
}
END_TEST

START_TEST(best_omega_is_youngs)
{
    // Rejects: pi / n; the factor of Gauss-Seidel in the place of Jacobi's.
    near(over_best(1), 1, ROUNDING, "one stick",
         "It is corrected at once: mu is 0.");
    near(over_best(2), 4 / (2 + sqrt(3.0)), ROUNDING, "two sticks",
         "mu is cos 60 degrees.");
    near(over_best(5), 4.0 / 3, ROUNDING, "five sticks",
         "mu is cos 30 degrees.");
}
END_TEST

START_TEST(above_the_best_the_rate_is_omega_less_one)
{
    // Then all waves die out alike, by omega - 1 an iteration.  Rejects: omega on
    // one end, half of what goes too far.
    stick s[MOST];
    particle p[MOST];
    chain(20, s, p);
    for (int k = 0; k < 50; k++) over_iterate(s, 20, p, 1.9);
    real before = worst(s, 20, p);
    for (int k = 0; k < 60; k++) over_iterate(s, 20, p, 1.9);
    near(pow(worst(s, 20, p) / before, 1.0 / 60), 0.9, SWING,
         "fraction that an iteration leaves, omega 1.9", "omega - 1, for every wave.");
}
END_TEST

// Iterates until a millionth of the error is left, at most 10,000.
static int iterations_needed(int n, real omega)
{
    stick s[MOST];
    particle p[MOST];
    int iterations = 0;
    chain(n, s, p);
    real before = worst(s, n, p);
    while (iterations < 10000 && worst(s, n, p) > 1e-6 * before) {
        over_iterate(s, n, p, omega);
        iterations++;
    }
    return iterations;
}

START_TEST(fifty_sticks_take_fewer_than_200_iterations)
{
    // Rejects: a best omega that is not; it is sharp.
    int plain = iterations_needed(50, 1), best = iterations_needed(50, over_best(50));
    printf("50 sticks, six digits: %d iterations with omega 1, %d with %g\n",
           plain, best, over_best(50));
    ck_assert_msg(plain > 3500 && plain < 3700,
                  "omega 1: %d iterations for six digits, wanted about 3,640: "
                  "ln(1e-6) / ln(cos^2(pi / 51))", plain);
    ck_assert_msg(best < 200, "omega %g: %d iterations for six digits, wanted "
                  "fewer than 200", over_best(50), best);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        one_stick_goes_too_far_by_omega,
        omega_1_is_the_plain_iteration,
        jacobi_corrects_one_stick_at_once,
        jacobi_is_the_same_in_any_order,
        nowhere_to_go_stays,
        jacobi_leaves_a_cosine_of_the_slowest_wave,
        best_omega_is_youngs,
        above_the_best_the_rate_is_omega_less_one,
        fifty_sticks_take_fewer_than_200_iterations,
        NULL
    };
    return suite_run((suite){ .name = "over", .tests = tests });
}
