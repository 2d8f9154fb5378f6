// check.c - tests of the exercise 02/spring.

#include "spring.h"
#include "expect.h"
#include "suite.h"

#include <check.h>

// Some dozen roundings of numbers near 1.
static const real ROUNDING = 1e-13;
// A thousand steps of a weight at rest, each rounding its place.
static const real REST_SLACK = 1e-9;
// Two springs relaxed in turn, 100 times, come that near to both being satisfied.
static const real SWEEP_SLACK = 1e-6;

static const vec3 DOWN = { 0, -9.8125, 0 };

static particle at(real x, real y, real z, real inverse_mass)
{
    return (particle){ { x, y, z }, { x, y, z }, inverse_mass };
}

START_TEST(without_compliance_it_is_a_stick)
{
    // Rejects: a division by the compliance, half the error.
    particle p[2] = { at(0, 0, 0, 1), at(1, 2, 2, 3) }, q[2] = { p[0], p[1] };
    real lambda = 0;
    spring_relax((spring){ 0, 1, 1, 0 }, p, 0.5, &lambda);
    stick_relax((stick){ 0, 1, 1, 1, STICK_EXACT }, q, relax_options_pbd());
    for (int i = 0; i < 2; i++)
        near(vec3_distance(p[i].position, q[i].position), 0, ROUNDING,
             "metres beside where a stick would put it",
             "With compliance 0 all of the error is corrected, by inverse mass.");
    near(lambda, 0.5, ROUNDING, "lambda",
         "2 m too long, divided by inverse masses of 4 / kg.");
}
END_TEST

START_TEST(spring_gives_as_much_as_it_pulls)
{
    // 1 m too long, w 1 and 3, soft = 1 / 0.5^2 = 4: lambda is 1 / 8, and
    // half a metre is left: 4 / 8.  Rejects: a move the wrong way, compliance
    // by dt or not by dt^2 at all, masses ignored, no unit vector.
    particle p[2] = { at(0, 0, 0, 1), at(3, 0, 0, 3) };
    real lambda = 0;
    spring_relax((spring){ 0, 1, 2, 1 }, p, 0.5, &lambda);
    near(lambda, 0.125, ROUNDING, "lambda",
         "1 m / (w_a + w_b + compliance / dt^2), 1 + 3 + 4.");
    near(p[0].position.x, 0.125, ROUNDING, "x of a", "lambda times w_a.");
    near(p[1].position.x, 2.625, ROUNDING, "x of b", "lambda times w_b back.");
}
END_TEST

START_TEST(second_relaxation_finds_nothing_to_do)
{
    // Rejects: what has been given already is forgotten, or begins at 0 again:
    // the more iterations, the harder the spring.
    particle p[2] = { at(0, 0, 0, 1), at(3, 0, 0, 3) };
    spring s = { 0, 1, 2, 1 };
    real lambda = 0;
    for (int k = 0; k < 10; k++) spring_relax(s, p, 0.5, &lambda);
    near(p[1].position.x - p[0].position.x, 2.5, ROUNDING,
         "length after ten relaxations",
         "The first satisfied it: d - rest = compliance lambda / dt^2.");
    near(lambda, 0.125, ROUNDING, "lambda after ten relaxations",
         "It is the sum of ten, of which nine are 0.");
}
END_TEST

START_TEST(spring_too_short_pushes)
{
    // Rejects: a rope.
    particle p[2] = { at(0, 0, 0, 1), at(1, 0, 0, 3) };
    real lambda = 0;
    spring_relax((spring){ 0, 1, 2, 1 }, p, 0.5, &lambda);
    near(p[1].position.x - p[0].position.x, 1.5, ROUNDING, "length", "");
    near(lambda, -0.125, ROUNDING, "lambda", "Below 0: the ends are pushed.");
}
END_TEST

START_TEST(nowhere_to_go_changes_nothing)
{
    // Rejects: 0 / 0, for ends in one place and for two pinned ends; a lambda that
    // counts a move that was not made.
    particle p[2] = { at(1, 2, 3, 1), at(1, 2, 3, 1) };
    real lambda = 0.25;
    spring_relax((spring){ 0, 1, 2, 0 }, p, 0.5, &lambda);
    ck_assert_msg(vec3_is_finite(p[0].position), "ends in one place: nan");
    near(lambda, 0.25, 0, "lambda of ends in one place", "No move, no change.");
    p[0] = at(0, 0, 0, 0), p[1] = at(3, 0, 0, 0);
    spring_relax((spring){ 0, 1, 2, 1 }, p, 0.5, &lambda);
    near(p[1].position.x, 3, 0, "x of a pinned end", "");
    near(lambda, 0.25, 0, "lambda between two pinned ends",
         "No move, no change.");
}
END_TEST

START_TEST(weight_hangs_by_its_weight_times_compliance)
{
    // 2 kg on 0.01 m/N: 0.19625 m, whatever the step, however many iterations.
    // Rejects: a stiffness that depends on either, which is what `stiffness` of
    // a stick does; the mass ignored.
    real sag = 2 * 9.8125 * 0.01;
    for (int steps = 16; steps <= 1024; steps *= 8)
        for (int iterations = 1; iterations <= 9; iterations += 4) {
            particle p[2] = { at(0, 0, 0, 0), at(0, -1 - sag, 0, 0.5) };
            for (int k = 0; k < 1000; k++) {
                real lambda = 0, dt = 1.0 / steps;
                verlet_step(p, 2, DOWN, NULL, dt);
                for (int i = 0; i < iterations; i++)
                    spring_relax((spring){ 0, 1, 1, 0.01 }, p, dt, &lambda);
            }
            ck_assert_msg(fabs(p[1].position.y + 1 + sag) <= REST_SLACK,
                          "%d steps a second, %d iterations: the weight hangs %g m "
                          "below the spring's end, wanted m g compliance = %g",
                          steps, iterations, -1 - p[1].position.y, sag);
        }
}
END_TEST

START_TEST(two_springs_in_a_row_give_twice_as_much)
{
    // A light ring between them.  Rejects: one lambda for all springs is the
    // caller's mistake; a move that does not go by inverse mass is yours.
    spring s[2] = { { 0, 1, 1, 0.01 }, { 1, 2, 1, 0.01 } };
    real sag = 9.8125 * 0.01, ring = 0.25 * 9.8125 * 0.01;
    particle p[3] = { at(0, 0, 0, 0), at(0, -1 - sag - ring, 0, 4),
                      at(0, -2 - 2 * sag - ring, 0, 1) };
    for (int k = 0; k < 200; k++) {
        real lambda[2] = { 0, 0 };
        verlet_step(p, 3, DOWN, NULL, 1.0 / 64);
        for (int i = 0; i < 100; i++)
            for (int j = 0; j < 2; j++)
                spring_relax(s[j], p, 1.0 / 64, &lambda[j]);
    }
    near(p[2].position.y, -2 - 2 * sag - ring, SWEEP_SLACK, "height of 1 kg",
         "Each spring carries it, and each gives.");
}
END_TEST

// The places x of 1 kg on a spring of stiffness k (N/m), without gravity.
static void swing(real k, real dt, int n, real *x)
{
    particle p[2] = { at(0, 0, 0, 0), at(11, 0, 0, 1) };
    for (int i = 0; i < n; i++) {
        real lambda = 0;
        x[i] = p[1].position.x - 10;
        verlet_step(p, 2, (vec3){ 0, 0, 0 }, NULL, dt);
        spring_relax((spring){ 0, 1, 10, 1 / k }, p, dt, &lambda);
    }
}

START_TEST(each_step_takes_its_part_of_the_swing)
{
    // x'' = -k x' of the *new* place: Euler's implicit step.  It multiplies
    // x^2 - x_before x_after by 1 / (1 + k dt^2).  Rejects: an explicit spring,
    // damping of any other size.
    real x[40], k = 16, dt = 0.125, keeps = 1 / (1 + k * dt * dt);
    swing(k, dt, 40, x);
    for (int i = 2; i < 39; i++) {
        real before = x[i - 1] * x[i - 1] - x[i - 2] * x[i];
        real after = x[i] * x[i] - x[i - 1] * x[i + 1];
        near(after / before, keeps, 1e-9, "fraction of the swing that is kept",
             "1 / (1 + stiffness dt^2 / mass): the price of never exploding.");
    }
}
END_TEST

START_TEST(no_spring_is_too_stiff)
{
    // omega dt from 1 to 10^6; Verlet's limit is 2.  Rejects: lambda from the
    // length before the move.
    for (real stiff = 1; stiff <= 1e12; stiff *= 100) {
        real x[100];
        swing(stiff, 1, 100, x);
        for (int i = 0; i < 100; i++)
            ck_assert_msg(fabs(x[i]) <= 1 + ROUNDING, "omega dt = %g: after %d "
                          "steps the swing is %g m, it began with 1",
                          sqrt(stiff), i, x[i]);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        without_compliance_it_is_a_stick,
        spring_gives_as_much_as_it_pulls,
        second_relaxation_finds_nothing_to_do,
        spring_too_short_pushes,
        nowhere_to_go_changes_nothing,
        weight_hangs_by_its_weight_times_compliance,
        two_springs_in_a_row_give_twice_as_much,
        each_step_takes_its_part_of_the_swing,
        no_spring_is_too_stiff,
        NULL
    };
    return suite_run((suite){ .name = "spring", .tests = tests });
}
