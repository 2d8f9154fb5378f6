// check.c - tests of the exercise 00b/spring.

#include "expect.h"
#include "random.h"
#include "spring.h"
#include "suite.h"

#include <check.h>

static const real PI = 3.14159265358979323846;
static const real ROUNDING = 1e-12;
// With 2,000 steps a period the step is too fast by 1 in 24 * (2000 / 2 pi)^2.
static const real PERIOD_SLACK = 1e-6;
static const vec3 NOTHING = { 0, 0, 0 };

START_TEST(stiffness_and_mass_decide)
{
    // Rejects: no root, the mass above the line, half the sum of the inverse masses.
    near(spring_omega(50, 0.5, 0), 5, ROUNDING, "rad/s, of 2 kg on a wall with 50 N/m",
         "omega^2 is the stiffness over the mass.");
    near(spring_omega(200, 0.5, 0), 10, ROUNDING, "rad/s, of 2 kg on a wall with 200 N/m",
         "Four times the stiffness: twice as fast.");
    near(spring_omega(8, 1, 1), 4, ROUNDING, "rad/s, of two times 1 kg with 8 N/m",
         "Both move, so their distance accelerates twice as fast.");
    near(spring_omega(1, 16, 9), 5, ROUNDING, "rad/s, of two different weights",
         "The distance accelerates by the sum of what both do.");
    near(spring_omega(1000, 0, 0), 0, 0, "rad/s, between two walls", "Nothing can move.");
}
END_TEST

// Lets two weights swing along d, with so many steps a period; returns how many
// periods of the formula one period of theirs is.
static real periods(weight a, weight b, real stiffness, vec3 d, int steps)
{
    real omega = sqrt(stiffness * (a.inverse_mass + b.inverse_mass)), rest = 2, before = 0, first = 0;
    b.position = vec3_add_scaled(a.position, rest + 0.1, d);
    for (int k = 1, n = 0; k < 8 * steps; k++) {
        spring_step(&a, &b, stiffness, rest, 2 * PI / omega / steps);
        real now = vec3_distance(a.position, b.position) - rest;
        if (before < 0 && now >= 0) {
            real at = k - now / (now - before);
            if (n++ == 0) first = at;
            if (n == 5) return (at - first) / 4 / steps;
        }
        before = now;
    }
    return 0;
}

START_TEST(step_swings_with_its_period)
{
    // Rejects: a force that pushes where it should pull, along x alone, that grows
    // with the length and not with the stretch, on one weight alone.
    unsigned long long seed = 1;
    for (int k = 0; k < 20; k++) {
        weight a = { random_vec3(&seed, 1), NOTHING, random_between(&seed, 0.1, 2) };
        weight b = { NOTHING, NOTHING, random_between(&seed, 0.1, 2) };
        near(periods(a, b, random_between(&seed, 10, 1000), random_direction(&seed), 2000), 1, PERIOD_SLACK,
             "periods of the formula in a measured one (0: it never came back)",
             "The force is the stiffness times the stretch, along the spring, on both.");
    }
}
END_TEST

START_TEST(first_step_is_the_one_that_is_asked_for)
{
    // 100 N/m, 0.5 m too long, 0.1 s: an impulse of 5 N s.
    // Rejects: positions by the old velocities, twice the impulse.
    weight a = { NOTHING, NOTHING, 1 }, b = { { 1.5, 0, 0 }, { 0, 1, 0 }, 0.5 };
    spring_step(&a, &b, 100, 1, 0.1);
    near_vec3(a.velocity, vec3_make(5, 0, 0), ROUNDING, "velocity of a", "50 N for 0.1 s on 1 kg, towards b.");
    near_vec3(b.velocity, vec3_make(-2.5, 1, 0), ROUNDING, "velocity of b", "The same on 2 kg, towards a.");
    near_vec3(a.position, vec3_make(0.5, 0, 0), ROUNDING, "position of a", "It moves with the new velocity.");
    near_vec3(b.position, vec3_make(1.25, 0.1, 0), ROUNDING, "position of b", "It moves with the new velocity.");
}
END_TEST

START_TEST(short_spring_pushes)
{
    // Rejects: a rope, which only pulls.
    weight a = { NOTHING, NOTHING, 1 }, b = { { 0, 0.5, 0 }, NOTHING, 1 };
    spring_step(&a, &b, 10, 1, 0.1);
    near_vec3(a.velocity, vec3_make(0, -0.5, 0), ROUNDING, "velocity of a", "A spring that is too short pushes.");
}
END_TEST

START_TEST(momentum_is_kept_by_any_step)
{
    // Rejects: the second weight seeing the first where it is already new.
    unsigned long long seed = 2;
    for (int k = 0; k < 100; k++) {
        weight a = { random_vec3(&seed, 1), random_vec3(&seed, 1), 1 }, b = { random_vec3(&seed, 1), random_vec3(&seed, 1), 0.25 };
        vec3 before = vec3_add_scaled(a.velocity, 4, b.velocity);
        real dt = random_between(&seed, 0.01, 1);
        vec3 middle = vec3_add_scaled(a.position, 4, b.position);
        spring_step(&a, &b, 30, 1, dt);
        near_vec3(vec3_add_scaled(a.velocity, 4, b.velocity), before, 100 * ROUNDING, "kg m/s after the step",
                  "Both impulses must be equal and opposite.");
        near_vec3(vec3_add_scaled(a.position, 4, b.position), vec3_add_scaled(middle, dt, before), 100 * ROUNDING,
                  "mass times position after the step", "The centre of mass flies straight on.");
    }
}
END_TEST

START_TEST(wall_stays)
{
    // Rejects: a wall that is pushed.
    weight wall = { NOTHING, NOTHING, 0 }, b = { { 3, 0, 0 }, NOTHING, 1 };
    for (int k = 0; k < 10; k++) spring_step(&b, &wall, 5, 1, 0.1);
    near_vec3(wall.position, NOTHING, 0, "place of the wall", "An inverse mass of 0 cannot be moved.");
    ck_assert_msg(b.position.x < 3, "the weight is still at %g m: nothing pulled it", b.position.x);
}
END_TEST

START_TEST(weights_in_one_place_feel_nothing)
{
    // Rejects: 0 / 0.
    weight a = { NOTHING, { 1, 0, 0 }, 1 }, b = { NOTHING, { 1, 0, 0 }, 1 };
    spring_step(&a, &b, 5, 1, 0.5);
    near_vec3(a.position, vec3_make(0.5, 0, 0), ROUNDING, "place of a", "No length, no direction: it flies straight on.");
}
END_TEST

START_TEST(steps_are_enough_and_one_less_is_not)
{
    // Rejects: omega for periods a second, rounding down, rounding to the nearest.
    unsigned long long seed = 3;
    for (int k = 0; k < 1000; k++) {
        real omega = random_between(&seed, 1, 3000);
        int each = 4 + random_below(&seed, 40), n = steps_a_second(omega, each);
        ck_assert_msg(n * 2 * PI / omega >= each * (1 - ROUNDING), "%d steps a second are %g a period of omega %g, and not %d",
                      n, n * 2 * PI / omega, omega, each);
        ck_assert_msg((n - 1) * 2 * PI / omega < each, "%d steps a second are more than it takes: %d are enough for omega %g",
                      n, n - 1, omega);
    }
    near(steps_a_second(0, 20), 1, 0, "steps a second for what does not swing", "At least 1, says the header.");
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        stiffness_and_mass_decide,
        first_step_is_the_one_that_is_asked_for,
        short_spring_pushes,
        step_swings_with_its_period,
        momentum_is_kept_by_any_step,
        wall_stays,
        weights_in_one_place_feel_nothing,
        steps_are_enough_and_one_less_is_not,
        NULL
    };
    return suite_run((suite){ .name = "spring", .tests = tests });
}
