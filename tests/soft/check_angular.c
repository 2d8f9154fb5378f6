// check_angular.c - tests of lib/soft/angular.c, what links within a body must not
// change.  Each names the mistake that it rejects.

#include "angular.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <math.h>

enum { MOST = 30 };

static unsigned long long seed = 1;
static particle p[MOST];

// About the origin, as Verlet's step keeps it.
static vec3 angular_about_origin(int n)
{
    vec3 sum = { 0, 0, 0 };
    for (int i = 0; i < n; i++)
        sum = vec3_add_scaled(sum, 1 / p[i].inverse_mass,
                              vec3_cross(p[i].previous, p[i].position));
    return sum;
}

static vec3 momentum(int n)
{
    vec3 sum = { 0, 0, 0 };
    for (int i = 0; i < n; i++)
        sum = vec3_add_scaled(sum, 1 / p[i].inverse_mass,
                              vec3_sub(p[i].position, p[i].previous));
    return sum;
}

// Of the size `size` (m), at `at`; flat, or in one line, by its dimensions.
static void scatter(int n, int dimensions, real size, vec3 at)
{
    vec3 axis[3];
    for (int k = 0; k < 3; k++) axis[k] = random_vec3(&seed, size);
    for (int i = 0; i < n; i++) {
        p[i] = (particle){ .inverse_mass = random_between(&seed, 0.5, 20),
                           .previous = at };
        for (int k = 0; k < dimensions; k++)
            p[i].previous = vec3_add_scaled(p[i].previous, random_real(&seed),
                                            axis[k]);
        p[i].position = vec3_add(p[i].previous, random_vec3(&seed, 0.01 * size));
    }
}

// Pulls that cancel each other, and that have other arms than a step ago.
static void pull_pairs(int n, real size)
{
    for (int i = 0; i + 1 < n; i++) {
        vec3 pull = random_vec3(&seed, 1e-4 * size);
        p[i].position = vec3_add_scaled(p[i].position, p[i].inverse_mass, pull);
        p[i + 1].position = vec3_add_scaled(p[i + 1].position,
                                            -p[i + 1].inverse_mass, pull);
    }
}

// Rejects: a matrix with the arms of now in the place of those of a step ago; a turn
// about another point than the centre of mass.
START_TEST(what_pulls_have_taken_is_given_back)
{
    for (int round = 0; round < 300; round++) {
        int n = 3 + round % (MOST - 3), dimensions = 2 + round % 2;
        real size = pow(10, random_between(&seed, -3, 3));
        scatter(n, dimensions, size, random_vec3(&seed, 3 * size));
        vec3 before = angular_about_origin(n);
        angular was = angular_measure(p, n);
        pull_pairs(n, size);
        vec3 moving = momentum(n), taken = angular_about_origin(n);
        angular_restore(was, p, n);
        vec3 now = angular_about_origin(n);
        real lost = vec3_distance(before, taken);
        ck_assert(lost > 0);
        near(vec3_distance(before, now) / lost, 0, 1e-6, "share that is lost");
        near(vec3_distance(moving, momentum(n)) / vec3_length(moving), 0, 1e-9,
             "momentum");
    }
}
END_TEST

// Rejects: a turn that stretches.  What is turned by an angle a keeps its lengths but
// for half of its square.
START_TEST(lengths_stay)
{
    for (int round = 0; round < 100; round++) {
        int n = 10;
        scatter(n, 3, 1, vec3_make(0, 0, 0));
        vec3 at[MOST];
        angular was = angular_measure(p, n);
        pull_pairs(n, 1);
        for (int i = 0; i < n; i++) at[i] = p[i].position;
        angular_restore(was, p, n);
        for (int i = 1; i < n; i++) {
            real then = vec3_distance(at[0], at[i]);
            near(vec3_distance(p[0].position, p[i].position), then, 1e-3 * then,
                 "length");
        }
    }
}
END_TEST

// Rejects: a quotient of nothing.  A straight rope has no inertia about itself.
START_TEST(what_lies_in_one_line_is_turned_across_it)
{
    scatter(12, 1, 1, vec3_make(5, 0, 0));
    vec3 line = vec3_unit(vec3_sub(p[1].previous, p[0].previous));
    for (int i = 0; i < 12; i++) p[i].position = p[i].previous;
    angular was = angular_measure(p, 12);
    vec3 across = vec3_unit(vec3_cross(line, vec3_make(0.3, 1, 0.2)));
    was.sum = vec3_scale(1e-3, across);
    angular_restore(was, p, 12);
    angular now = angular_measure(p, 12);
    near(vec3_distance(now.sum, was.sum), 0, 1e-9, "angular momentum, kg m^2");
}
END_TEST

// Rejects: places that are lost with the sums.
START_TEST(what_has_no_number_or_is_too_much_is_left)
{
    scatter(12, 3, 1, vec3_make(0, 0, 0));
    const vec3 bad[] = { { NAN, 0, 0 }, { HUGE_VAL, 0, 0 }, { 1e6, 0, 0 } };
    for (int k = 0; k < 3; k++) {
        angular was = angular_measure(p, 12);
        was.sum = bad[k];
        vec3 at = p[3].position;
        angular_restore(was, p, 12);
        ck_assert(vec3_distance(at, p[3].position) == 0);
    }
    for (int i = 0; i < 12; i++) p[i].position = p[i].previous = p[0].previous;
    vec3 at = p[3].position;
    angular_restore(angular_measure(p, 12), p, 12);
    ck_assert(vec3_distance(at, p[3].position) == 0);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        what_pulls_have_taken_is_given_back,
        lengths_stay,
        what_lies_in_one_line_is_turned_across_it,
        what_has_no_number_or_is_too_much_is_left,
        NULL
    };
    return suite_run((suite){ .name = "angular", .tests = tests });
}
