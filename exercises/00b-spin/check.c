// check.c - tests of the exercise 00b/spin.

#include "expect.h"
#include "random.h"
#include "spin.h"
#include "suite.h"

#include <check.h>

// Some roundings of numbers below 100.
static const real ROUNDING = 1e-11;
static const vec3 UP = { 0, 0, 1 };
enum { POINTS = 6 };

START_TEST(dumbbell_has_two_weights)
{
    // Rejects: the distance for its square, half of it, the weights' mean.
    point p[2] = { { 3, { -2, 0, 0 }, { 0, 0, 0 } }, { 3, { 2, 0, 0 }, { 0, 0, 0 } } };
    near(inertia(p, 2, UP), 24, ROUNDING, "kg m^2, of two times 3 kg at 2 m", "Each has its mass times the distance squared.");
    near(inertia(p, 2, vec3_make(1, 0, 0)), 0, ROUNDING, "kg m^2, about the bar itself", "Both lie on that axis.");
}
END_TEST

START_TEST(distance_is_from_the_axis)
{
    // Rejects: the distance from the origin.
    point p = { 2, { 3, 4, 12 }, { 0, 0, 0 } };
    near(inertia(&p, 1, UP), 50, ROUNDING, "kg m^2, of 2 kg, 5 m from the axis and 12 m up",
         "How far it lies along the axis does not count.");
    near(inertia(&p, 1, vec3_make(0, 0.6, 0.8)), 2 * (169 - 12.0 * 12), ROUNDING, "kg m^2, about a slanting axis",
         "Take the part across the axis: a cross product has its length.");
}
END_TEST

START_TEST(box_is_the_limit_of_its_points)
{
    // 40 x 40 points in a plate of 2 m by 1 m: too small by one in 40^2.
    // Rejects: a 3 or a 6 below the line, the product of the sides.
    enum { N = 40 };
    static point p[N * N];
    for (int i = 0; i < N * N; i++)
        p[i] = (point){ 6.0 / (N * N), { 2 * ((i % N + 0.5) / N - 0.5), (i / N + 0.5) / N - 0.5, 0 }, { 0, 0, 0 } };
    real sum = inertia(p, N * N, UP);
    near(sum, 2.5 * (1 - 1.0 / (N * N)), ROUNDING, "kg m^2, of a box in 1,600 points", "This is your inertia().");
    near(box_inertia(6, 2, 1), 2.5, ROUNDING, "kg m^2, of a box of 6 kg, 2 m by 1 m",
         "The mean of x^2 over a side of length a is a^2 / 12.");
}
END_TEST

START_TEST(flying_straight_on_keeps_angular_momentum)
{
    // Rejects: v x x, masses left out, the length of v for its part across.
    point p = { 2, { -10, 3, 0 }, { 4, 0, 0 } };
    for (int k = 0; k < 6; k++) {
        near_vec3(angular_momentum(&p, 1), vec3_make(0, 0, -24), ROUNDING, "kg m^2/s, of 2 kg that fly past at 3 m",
                  "Distance 3 m, 8 kg m/s, and clockwise as seen from above.");
        p.position = vec3_add(p.position, p.velocity);
    }
}
END_TEST

// Any points that turn about the axis as one.
static void turn(unsigned long long *seed, point *p, vec3 axis, real omega)
{
    for (int i = 0; i < POINTS; i++) {
        p[i] = (point){ random_between(seed, 0.1, 3), random_vec3(seed, 1), { 0, 0, 0 } };
        p[i].velocity = vec3_scale(omega, vec3_cross(axis, p[i].position));
    }
}

START_TEST(half_the_distance_is_four_times_as_fast)
{
    // Rejects: twice as fast, the same speed, work of the wrong sign.
    point p[2] = { { 2, { -1, 0, 0 }, { 0, -3, 0 } }, { 2, { 1, 0, 0 }, { 0, 3, 0 } } };
    real work = pull_in(p, 2, UP, 0.5);
    near_vec3(p[1].position, vec3_make(0.5, 0, 0), ROUNDING, "place of the second weight", "Half of its distance.");
    near_vec3(p[1].velocity, vec3_make(0, 6, 0), ROUNDING, "velocity of the second weight",
              "12 rad/s at 0.5 m: the moment is a quarter, so omega is four times what it was.");
    near(work, 54, ROUNDING, "J of work", "18 J before, 72 J after.");
}
END_TEST

START_TEST(angular_momentum_is_kept_about_any_axis)
{
    // Rejects: distances from the origin, an axis that is always z.
    unsigned long long seed = 1;
    for (int k = 0; k < 200; k++) {
        point p[POINTS], was[POINTS];
        vec3 axis = random_direction(&seed);
        turn(&seed, p, axis, random_between(&seed, -5, 5));
        for (int i = 0; i < POINTS; i++) was[i] = p[i];
        real before = vec3_dot(axis, angular_momentum(p, POINTS)), factor = random_between(&seed, 0.3, 2);
        pull_in(p, POINTS, axis, factor);
        near(vec3_dot(axis, angular_momentum(p, POINTS)), before, ROUNDING, "kg m^2/s along the axis",
             "A pull towards the axis has no torque about it.");
        for (int i = 0; i < POINTS; i++) {
            near(vec3_dot(axis, p[i].position), vec3_dot(axis, was[i].position), ROUNDING, "m along the axis",
                 "Only the part across the axis shrinks.");
            near(vec3_length(vec3_cross(axis, p[i].position)), factor * vec3_length(vec3_cross(axis, was[i].position)),
                 ROUNDING, "m from the axis", "It is factor times what it was.");
        }
    }
}
END_TEST

START_TEST(letting_out_gives_the_work_back)
{
    // Rejects: work that is never negative.
    unsigned long long seed = 2;
    point p[POINTS];
    turn(&seed, p, UP, 4);
    real in = pull_in(p, POINTS, UP, 0.5), out = pull_in(p, POINTS, UP, 2);
    ck_assert_msg(in > 0, "pulling in took %g J of work; it speeds the body up, so it must cost something", in);
    near(out, -in, ROUNDING, "J, to let the arms out again", "The body is as it was, so all of the work comes back.");
}
END_TEST

START_TEST(needle_on_its_axis_stays)
{
    // Rejects: 0 / 0.
    point p[2] = { { 1, { 0, 0, -1 }, { 0, 0, 0 } }, { 1, { 0, 0, 1 }, { 0, 0, 0 } } };
    near(pull_in(p, 2, UP, 0.5), 0, 0, "J of work on points that lie on the axis", "There is nothing to pull in.");
    near_vec3(p[1].velocity, vec3_make(0, 0, 0), 0, "velocity of a point on the axis", "0 / 0 is NaN.");
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        dumbbell_has_two_weights,
        distance_is_from_the_axis,
        box_is_the_limit_of_its_points,
        flying_straight_on_keeps_angular_momentum,
        half_the_distance_is_four_times_as_fast,
        angular_momentum_is_kept_about_any_axis,
        letting_out_gives_the_work_back,
        needle_on_its_axis_stays,
        NULL
    };
    return suite_run((suite){ .name = "spin", .tests = tests });
}
