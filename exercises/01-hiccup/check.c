// check.c - tests of the exercise 01/hiccup.

#include "hiccup.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>

// Room for the rounding of some hundred sums near 10.
static const real ROUNDING = 1e-11;
// A measured order may miss the whole number by the next term of the series.
static const real ORDER_SLACK = 0.1;

static const vec3 GRAVITY = { 0, -9.8125, 0 };
static const vec3 NO_GRAVITY = { 0, 0, 0 };

START_TEST(parabola_is_exact_when_the_step_changes)
{
    // Rejects: the plain step; a ratio that is upside down; a dt^2 or a
    // dt_before^2 for gravity.
    vec3 speed = { 3, 4, 0 };
    real dt = 0.01, t = 0;
    particle p = particle_start(NO_GRAVITY, speed, GRAVITY, 1, dt);
    unsigned long long seed = 1;
    for (int k = 0; k < 200; k++) {
        real next = random_between(&seed, 0.004, 0.014);
        step_changed(&p, 1, GRAVITY, NULL, dt, next);
        dt = next;
        t += dt;
        near(p.position.x, 3 * t, ROUNDING, "x");
        near(p.position.y, 4 * t - 9.8125 * t * t / 2, ROUNDING, "y");
    }
}
END_TEST

START_TEST(unchanged_step_is_the_plain_step)
{
    // Rejects: a formula that is another one where nothing changes.
    particle p = particle_start((vec3){ 1, 1, 1 }, (vec3){ 1, 2, 3 }, GRAVITY,
                                1, 0.01), q = p;
    verlet_step(&p, 1, GRAVITY, NULL, 0.01);
    step_changed(&q, 1, GRAVITY, NULL, 0.01, 0.01);
    near(vec3_distance(p.position, q.position), 0, ROUNDING, "off Verlet's");
    near(vec3_distance(p.previous, q.previous), 0, ROUNDING, "previous, off");
}
END_TEST

START_TEST(pinned_particle_stays)
{
    // Rejects: gravity on a pinned particle; a previous that stays behind.
    particle p = { { 1, 0, 0 }, { 0, 0, 0 }, 0 };
    step_changed(&p, 1, GRAVITY, NULL, 0.01, 0.02);
    ck_assert(p.position.x == 1 && p.position.y == 0);
    ck_assert_msg(p.previous.x == 1, "previous is still at x = %g",
                  p.previous.x);
}
END_TEST

START_TEST(each_particle_has_its_own_force)
{
    // Rejects: force[0] for all; a mass that is forgotten; gravity left out.
    particle p[3];
    vec3 force[3] = { { 1, 0, 0 }, { 0, 2, 0 }, { 0, 0, 3 } };
    for (int i = 0; i < 3; i++)
        p[i] = (particle){ NO_GRAVITY, NO_GRAVITY, 0.5 };
    step_changed(p, 3, (vec3){ 0, 0, 4 }, force, 1, 3);
    near(p[0].position.x, 3, ROUNDING, "x of particle 0");  // 6 . 0.5 . 1
    near(p[1].position.y, 6, ROUNDING, "y of particle 1");
    near(p[2].position.z, 33, ROUNDING, "z of particle 2");
    near(p[0].position.z, 24, ROUNDING, "z of particle 0");
}
END_TEST

// How far a spring is off after a second, in steps that are long and short in
// turn, three to one.
static real spring_error(int pairs)
{
    real unit = 1.0 / (4 * pairs), before = unit;
    particle p = particle_start((vec3){ 1, 0, 0 }, NO_GRAVITY,
                                (vec3){ -4, 0, 0 }, 1, before);
    for (int k = 0; k < 2 * pairs; k++) {
        real dt = k % 2 ? unit : 3 * unit;
        vec3 force = vec3_scale(-4, p.position);
        step_changed(&p, 1, NO_GRAVITY, &force, before, dt);
        before = dt;
    }
    return fabs(p.position.x - cos(2.0));
}

START_TEST(spring_is_followed_through_long_and_short_steps)
{
    // Half the steps, a quarter of the error: order 2, as with a fixed step.
    // Rejects: the plain step, which does not come nearer however short its
    // steps are.
    near(log2(spring_error(200) / spring_error(400)), 2, ORDER_SLACK, "order");
    near(spring_error(400), 0, 1e-5, "off by, in m,");
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        parabola_is_exact_when_the_step_changes,
        unchanged_step_is_the_plain_step,
        pinned_particle_stays,
        each_particle_has_its_own_force,
        spring_is_followed_through_long_and_short_steps,
        NULL
    };
    return suite_run((suite){ .name = "hiccup", .tests = tests });
}
