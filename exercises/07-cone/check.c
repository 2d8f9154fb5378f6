// check.c - tests of the exercise 07/cone.

#include "cone.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>

// A dozen roundings of numbers up to 10.
static const real ROUNDING = 1e-14;
// Rounds that every grip here is settled by, and what they leave of it.
enum { ROUNDS = 1000 };
static const real SETTLED = 1e-9;

static const vec3 UP = { 0, 1, 0 };
static const vec3 WEIGHT = { 0, -10, 0 };       // N

static unsigned long long seed = 7;

// What is missing, asked of surfaces in memory that ends behind the last.
static real missing(const vec3 *normal, int n, real mu, vec3 load)
{
    vec3 *of = malloc((size_t)n * sizeof *of), *push = calloc((size_t)n,
                                                               sizeof *push);
    ck_assert(of && push);
    for (int i = 0; i < n; i++) of[i] = normal[i];
    real m = grip(of, n, mu, load, ROUNDS, push);
    free(of);
    free(push);
    return m;
}

START_TEST(wish_in_the_cone_is_granted)
{
    // Inside, on the axis, and on the rim itself.
    near_vec3(cone_nearest((vec3){ 1, 4, -1 }, UP, 0.5),
              (vec3){ 1, 4, -1 }, 10 * ROUNDING, "inside");
    near_vec3(cone_nearest((vec3){ 0, 3, 0 }, UP, 0.5),
              (vec3){ 0, 3, 0 }, 10 * ROUNDING, "straight out");
    near_vec3(cone_nearest((vec3){ 3, 6, 0 }, UP, 0.5),
              (vec3){ 3, 6, 0 }, 10 * ROUNDING, "on the rim");
}
END_TEST

START_TEST(pulling_gets_nothing)
{
    // Rejects: a surface that is made of glue.
    near_vec3(cone_nearest((vec3){ 0, -3, 0 }, UP, 0.5),
              (vec3){ 0, 0, 0 }, 10 * ROUNDING, "straight in");
    near_vec3(cone_nearest((vec3){ 1, -3, 1 }, UP, 0.5),
              (vec3){ 0, 0, 0 }, 10 * ROUNDING, "in, and a little sideways");
}
END_TEST

START_TEST(wish_outside_gets_its_foot_on_the_rim)
{
    // mu = 1/2, so the rim is the line (2, 1) / sqrt(5) in (n, t).  The wish
    // n = 1, t = 3 has its foot at (2, 1): what is missing, (-1, 2), stands at
    // a right angle to it.  Rejects: cutting off what is too much sideways,
    // which gives (1, 1/2).
    near_vec3(cone_nearest((vec3){ 3, 1, 0 }, UP, 0.5),
              (vec3){ 1, 2, 0 }, 10 * ROUNDING, "along x");
    near_vec3(cone_nearest((vec3){ 0, 1, -3 }, UP, 0.5),
              (vec3){ 0, 2, -1 }, 10 * ROUNDING, "against z");
}
END_TEST

START_TEST(much_sideways_leans_on_the_surface)
{
    // It pulls, but so much sideways that the rim is still nearer than the tip.
    // n = -1, t = 7: the foot is at k = (-1 + 3.5) / 1.25 = 2.
    near_vec3(cone_nearest((vec3){ 7, -1, 0 }, UP, 0.5),
              (vec3){ 1, 2, 0 }, 10 * ROUNDING, "(7, -1, 0)");
}
END_TEST

START_TEST(wish_without_length_is_no_nan)
{
    // Rejects: 0 / 0 where there is no sideways part.
    for (int k = 0; k < 3; k++) {
        real mu = k * 0.5;
        near_vec3(cone_nearest((vec3){ 0, 0, 0 }, UP, mu),
                  (vec3){ 0, 0, 0 }, 10 * ROUNDING, "no wish");
        near_vec3(cone_nearest((vec3){ 0, 2, 0 }, UP, mu),
                  (vec3){ 0, 2, 0 }, 10 * ROUNDING, "straight out");
    }
    near_vec3(cone_nearest((vec3){ 3, 1, 0 }, UP, 0), UP, 10 * ROUNDING,
              "without friction");
}
END_TEST

START_TEST(no_push_of_the_cone_is_nearer)
{
    // What is missing looks away from every push of the cone: if not, a step
    // towards that push would come nearer.
    for (int k = 0; k < 1000; k++) {
        vec3 normal = vec3_unit(random_vec3(&seed, 1)),
             wish = random_vec3(&seed, 1);
        real mu = 1 + random_real(&seed);
        vec3 got = cone_nearest(wish, normal, mu);
        real out = vec3_dot(got, normal);
        vec3 across = vec3_add_scaled(got, -out, normal);
        ck_assert_msg(vec3_length(across) <= mu * out + ROUNDING,
                      "got a push with %g across and %g along the normal, and "
                      "mu is only %g", vec3_length(across), out, mu);
        vec3 side = vec3_cross(normal, random_vec3(&seed, 1));
        vec3 other = vec3_add_scaled(normal, mu / vec3_length(side), side);
        vec3 left = vec3_sub(wish, got);
        ck_assert_msg(vec3_dot(left, vec3_sub(other, got)) <= 10 * ROUNDING,
                      "another push of the cone is nearer to the wish");
    }
}
END_TEST

START_TEST(block_holds_up_to_the_angle_of_friction)
{
    // On a slope of 3 in 4: held if mu >= 3/4.  Else the weight sticks out of
    // the cone by 10 N times the sine of (slope angle - friction angle), and
    // with mu = 1/2 that is (0.6 - 0.8 mu) / sqrt(1 + mu^2).
    vec3 slope = { -0.6, 0.8, 0 };
    near(missing(&slope, 1, 0.76, WEIGHT), 0, ROUNDING * 10,
         "missing at mu = 0.76, N");
    near(missing(&slope, 1, 0.5, WEIGHT), 2 / sqrt(1.25), ROUNDING * 10,
         "missing at mu = 0.5, N");
}
END_TEST

START_TEST(climber_holds_by_pressing_harder)
{
    // Between two upright walls, any friction will do: the less there is, the
    // harder the climber presses.  Without friction all of the weight is
    // missing.  Rejects: walls that are asked once; walls that do not hear each
    // other.
    const vec3 wall[2] = { { 1, 0, 0 }, { -1, 0, 0 } };
    near(missing(wall, 2, 0.5, WEIGHT), 0, SETTLED, "missing at mu = 0.5, N");
    near(missing(wall, 2, 0.2, WEIGHT), 0, SETTLED, "missing at mu = 0.2, N");
    near(missing(wall, 2, 0, WEIGHT), 10, SETTLED, "missing at mu = 0, N");
    near(missing(wall, 1, 0.5, WEIGHT), 10 / sqrt(1.25), SETTLED,
         "missing with one wall alone, N");
}
END_TEST

START_TEST(log_lies_in_its_groove)
{
    // Two planks at 45 degrees, no friction: each must give 10 / sqrt(2) N.
    const vec3 plank[2] = { { sqrt(0.5), sqrt(0.5), 0 },
                            { -sqrt(0.5), sqrt(0.5), 0 } };
    vec3 push[2];
    real m = grip(plank, 2, 0, WEIGHT, ROUNDS, push);
    near(m, 0, SETTLED, "missing, N");
    near(vec3_length(push[0]), 10 * sqrt(0.5), SETTLED, "left plank, N");
    near(vec3_length(push[1]), 10 * sqrt(0.5), SETTLED, "right plank, N");
}
END_TEST

START_TEST(what_cannot_be_held_is_missing)
{
    // A balloon on the floor, and a weight on nothing.
    near(missing(&UP, 1, 0.5, (vec3){ 0, 3, 0 }), 3, ROUNDING, "balloon, N");
    near(missing(NULL, 0, 0.5, WEIGHT), 10, ROUNDING, "on nothing, N");
}
END_TEST

START_TEST(old_pushes_are_forgotten)
{
    vec3 push = { 4, 5, 6 };
    real m = grip(&UP, 1, 0.5, WEIGHT, 0, &push);
    near(m, 10, ROUNDING, "missing before the first round, N");
    near_vec3(push, (vec3){ 0, 0, 0 }, 10 * ROUNDING,
              "the push before the first round");
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        // Cone.
        wish_in_the_cone_is_granted,
        pulling_gets_nothing,
        wish_outside_gets_its_foot_on_the_rim,
        much_sideways_leans_on_the_surface,
        wish_without_length_is_no_nan,
        no_push_of_the_cone_is_nearer,
        // Grip.
        block_holds_up_to_the_angle_of_friction,
        climber_holds_by_pressing_harder,
        log_lies_in_its_groove,
        what_cannot_be_held_is_missing,
        old_pushes_are_forgotten,
        NULL
    };
    return suite_run((suite){ .name = "cone", .tests = tests });
}
