// check.c - tests of the exercise 01/rk4.

#include "rk4.h"
#include "expect.h"
#include "suite.h"

#include <check.h>

// A dozen roundings of numbers near 1.
static const real ROUNDING = 1e-14;
// A measured order misses the whole number by the next term of the series.
static const real ORDER_SLACK = 0.05;

static motion along_x(real x, real v)
{
    return (motion){ { x, 0, 0 }, { v, 0, 0 } };
}

static vec3 nothing(motion m, real t, const void *about)
{
    (void)m, (void)t, (void)about;
    return (vec3){ 0, 0, 0 };
}

static vec3 constant(motion m, real t, const void *about)
{
    (void)m, (void)t;
    return *(const vec3 *)about;
}

static vec3 spring(motion m, real t, const void *about)
{
    (void)t, (void)about;
    return vec3_scale(-1, m.position);
}

static vec3 drag(motion m, real t, const void *about)
{
    (void)t, (void)about;
    return vec3_scale(-1, m.velocity);
}

static vec3 cubic(motion m, real t, const void *about)
{
    (void)m, (void)about;
    return (vec3){ t * t * t, 0, 0 };
}

START_TEST(without_a_force_it_goes_straight_on)
{
    // Rejects: a position that does not move with the velocity.
    motion m = { { 1, 2, 3 }, { 4, -5, 6 } };
    m = rk4_step(m, nothing, NULL, 0, 0.5);
    near(vec3_distance(m.position, (vec3){ 3, -0.5, 6 }), 0, ROUNDING, "place");
    near(vec3_distance(m.velocity, (vec3){ 4, -5, 6 }), 0, ROUNDING,
         "velocity");
}
END_TEST

START_TEST(parabola_is_exact)
{
    // Rejects: weights that do not add up to 1, an acceleration left out, a
    // stage that goes on for the wrong time.
    vec3 g = { 0, -9.8125, 2 };
    motion m = { { 1, 2, 3 }, { 4, 5, -6 } };
    for (int k = 0; k < 64; k++)
        m = rk4_step(m, constant, &g, k / 64.0, 1.0 / 64);
    near(m.position.y, 2 + 5 - 9.8125 / 2, 100 * ROUNDING, "y");
    near(m.position.z, 3 - 6 + 1, 100 * ROUNDING, "z");
    near(m.velocity.y, 5 - 9.8125, 100 * ROUNDING, "v");
}
END_TEST

START_TEST(step_of_no_time_changes_nothing)
{
    // Rejects: a division by dt.
    motion m = rk4_step(along_x(1, 2), spring, NULL, 0, 0);
    ck_assert_msg(m.position.x == 1 && m.velocity.x == 2,
                  "got x %g and v %g, wanted 1 and 2", m.position.x,
                  m.velocity.x);
}
END_TEST

START_TEST(force_that_depends_on_time_is_asked_at_the_right_times)
{
    // Simpson's rule integrates t^3 exactly, from any beginning.
    // Rejects: all four at t; three at t + dt / 2; a beginning at 0.
    motion m = rk4_step(along_x(0, 0), cubic, NULL, 1, 0.5);
    near(m.velocity.x, (1.5 * 1.5 * 1.5 * 1.5 - 1) / 4, ROUNDING, "velocity");
}
END_TEST

START_TEST(drag_is_the_exponential_series_up_to_the_fourth_power)
{
    // v' = -v makes v(h) = e^-h; a method of order 4 in four stages gets the
    // series up to h^4 / 24 and not a term more.  Rejects: stages that all see
    // the first velocity.
    real h = 0.5, e = 1 - h + h * h / 2 - h * h * h / 6 + h * h * h * h / 24;
    motion m = rk4_step(along_x(0, 1), drag, NULL, 0, h);
    near(m.velocity.x, e, ROUNDING, "velocity");
    near(m.position.x, 1 - e, ROUNDING, "place");
}
END_TEST

START_TEST(spring_is_the_series_of_the_cosine)
{
    // Rejects: stages that all see the first position, or move it with the
    // first velocity.
    real h = 0.5;
    motion m = rk4_step(along_x(1, 0), spring, NULL, 0, h);
    near(m.position.x, 1 - h * h / 2 + h * h * h * h / 24, ROUNDING, "place");
    near(m.velocity.x, -h + h * h * h / 6, ROUNDING, "velocity");
}
END_TEST

static real error_at_1(int steps)
{
    motion m = along_x(1, 1);
    for (int k = 0; k < steps; k++)
        m = rk4_step(m, spring, NULL, (real)k / steps, 1.0 / steps);
    return fabs(m.position.x - (cos(1.0) + sin(1.0)));
}

START_TEST(it_is_of_order_4)
{
    near(log2(error_at_1(100) / error_at_1(200)), 4, ORDER_SLACK, "order");
}
END_TEST

START_TEST(it_loses_energy_by_its_law)
{
    // One step multiplies a spring's energy by 1 - h^6 / 72 + h^8 / 576:
    // little, but always downwards.  Verlet's swings and comes back.
    real h = 0.5, h2 = h * h, factor = 1 - h2 * h2 * h2 / 72
                                     + h2 * h2 * h2 * h2 / 576;
    motion m = along_x(1, 0);
    for (int k = 0; k < 1000; k++) m = rk4_step(m, spring, NULL, 0, h);
    real energy = vec3_dot(m.position, m.position)
                + vec3_dot(m.velocity, m.velocity);
    near(energy / pow(factor, 1000), 1, 1e-10, "energy");
}
END_TEST

static int asked;

static vec3 counted(motion m, real t, const void *about)
{
    asked++;
    return spring(m, t, about);
}

START_TEST(force_is_asked_four_times)
{
    // Rejects: computing again what is known: the force is what costs.
    asked = 0;
    rk4_step(along_x(1, 0), counted, NULL, 0, 0.1);
    ck_assert_int_eq(asked, 4);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        without_a_force_it_goes_straight_on,
        parabola_is_exact,
        step_of_no_time_changes_nothing,
        force_that_depends_on_time_is_asked_at_the_right_times,
        drag_is_the_exponential_series_up_to_the_fourth_power,
        spring_is_the_series_of_the_cosine,
        it_is_of_order_4,
        it_loses_energy_by_its_law,
        force_is_asked_four_times,
        NULL
    };
    return suite_run((suite){ .name = "rk4", .tests = tests });
}
