// check_vec3.c - does lib/base/vec3.h keep the laws of vectors?
//
// Book: chapter 0.  Whole numbers keep most of these tests exact: a sum of
// products of small integers has no rounding, so == is the right question.

#include <check.h>
#include <float.h>

#include "vec3.h"
#include "random.h"
#include "suite.h"

// One rounding of a product or a sum moves a number by at most half of
// DBL_EPSILON of its size.  A product of vectors makes five of them, a length
// or a unit vector a few more: eight halves cover all that stands here.
static const real ROUNDING = 4 * DBL_EPSILON;

static int equal(vec3 a, vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

// Small whole numbers, -9 to 9.
static vec3 whole_vec3(unsigned long long *seed)
{
    int x = random_below(seed, 19), y = random_below(seed, 19);
    return vec3_make(x - 9, y - 9, random_below(seed, 19) - 9);
}

// Rejects: the two exchanged; a NaN that passes where a bound comes second.
START_TEST(larger_and_smaller_hold_the_bound_against_nan)
{
    ck_assert(real_max(1, 2) == 2 && real_max(2, 1) == 2);
    ck_assert(real_min(1, 2) == 1 && real_min(2, 1) == 1);
    ck_assert(real_max(-HUGE_VAL, -1) == -1 && real_min(HUGE_VAL, -1) == -1);
    ck_assert(real_max((real)NAN, 0) == 0 && real_min((real)NAN, 0) == 0);
    ck_assert(int_max(1, 2) == 2 && int_max(2, 1) == 2);
    ck_assert(int_min(1, 2) == 1 && int_min(2, 1) == 1);
}
END_TEST

// Rejects: two components swapped in the maker.
START_TEST(maker_keeps_the_order_of_the_components)
{
    vec3 a = vec3_make(1, 2, 3);
    ck_assert(a.x == 1 && a.y == 2 && a.z == 3);
}
END_TEST

// Rejects: a component left out or added to the wrong one; b - a for a - b.
START_TEST(sums_and_differences_go_component_by_component)
{
    vec3 a = vec3_make(1, 20, 300), b = vec3_make(4, 50, 600);
    ck_assert(equal(vec3_add(a, b), vec3_make(5, 70, 900)));
    ck_assert(equal(vec3_sub(a, b), vec3_make(-3, -30, -300)));
    ck_assert(equal(vec3_sub(vec3_add(a, b), b), a));
}
END_TEST

// Rejects: a + b, a - s b, or s a + b in the place of a + s b.
START_TEST(a_step_along_b_starts_at_a)
{
    vec3 a = vec3_make(1, 2, 3), b = vec3_make(10, 20, 40);
    ck_assert(equal(vec3_scale(-2, a), vec3_make(-2, -4, -6)));
    ck_assert(equal(vec3_add_scaled(a, 3, b), vec3_make(31, 62, 123)));
    ck_assert(equal(vec3_add_scaled(a, 0, b), a));
}
END_TEST

// Rejects: a fused multiply-add, which rounds once where the book's arithmetic
// rounds twice, and so gives other bits.  With e = 2^-30 the square of 1 + e
// is 1 + 2 e + e^2, and e^2 = 2^-60 is lost when it is rounded to a double.
START_TEST(products_are_rounded_before_they_are_added)
{
    volatile real one_and_a_bit = 1 + 0x1p-30;      // unknown to the compiler
    real rounded = 1 + 0x1p-29;
    vec3 a = vec3_make(-rounded, 0, 0), b = vec3_make(one_and_a_bit, 0, 0);
    vec3 sum = vec3_add_scaled(a, one_and_a_bit, b);
    ck_assert_msg(sum.x == 0, "got %a, wanted 0: is -ffp-contract=off missing?", sum.x);
}
END_TEST

// Rejects: a sign lost, a component used twice.
START_TEST(dot_product_weighs_each_axis_alone)
{
    vec3 a = vec3_make(2, 3, 5), b = vec3_make(1, 100, -10000);
    ck_assert(vec3_dot(a, b) == 2 + 300 - 50000);
    ck_assert(vec3_dot(a, b) == vec3_dot(b, a));
}
END_TEST

// Rejects: the left-hand rule.
START_TEST(cross_product_turns_x_to_y_into_z)
{
    vec3 x = vec3_make(1, 0, 0), y = vec3_make(0, 1, 0), z = vec3_make(0, 0, 1);
    ck_assert(equal(vec3_cross(x, y), z));
    ck_assert(equal(vec3_cross(y, z), x));
    ck_assert(equal(vec3_cross(z, x), y));
    ck_assert(equal(vec3_cross(y, x), vec3_make(0, 0, -1)));
}
END_TEST

// Rejects: any one wrong term of the cross product, which the axes may miss.
// Lagrange: |a x b|^2 + (a . b)^2 = |a|^2 |b|^2.
START_TEST(cross_product_is_perpendicular_and_as_long_as_the_area)
{
    unsigned long long seed = 1;
    for (int i = 0; i < 1000; i++) {
        vec3 a = whole_vec3(&seed), b = whole_vec3(&seed);
        vec3 c = vec3_cross(a, b);
        real dot = vec3_dot(a, b);
        ck_assert(vec3_dot(a, c) == 0 && vec3_dot(b, c) == 0);
        ck_assert(vec3_length_squared(c) + dot * dot
                  == vec3_length_squared(a) * vec3_length_squared(b));
        ck_assert(equal(vec3_cross(a, a), vec3_make(0, 0, 0)));
    }
}
END_TEST

// Rejects: the square in the place of the length; a sum in that of a difference.
START_TEST(lengths_and_distances_are_those_of_pythagoras)
{
    vec3 a = vec3_make(2, -3, 6), b = vec3_make(3, -1, 8);
    ck_assert(vec3_length_squared(a) == 49);
    ck_assert(vec3_length(a) == 7);
    ck_assert(vec3_distance(a, b) == 3);
    ck_assert(vec3_distance(b, a) == 3);
    ck_assert(vec3_distance(a, a) == 0);
}
END_TEST

// Rejects: a vector divided by the square of its length.
START_TEST(unit_vector_has_length_one_and_keeps_its_direction)
{
    unsigned long long seed = 2;
    for (int i = 0; i < 1000; i++) {
        vec3 a = whole_vec3(&seed);
        if (vec3_length_squared(a) == 0) continue;
        vec3 u = vec3_unit(a);
        ck_assert_double_eq_tol(vec3_length(u), 1, ROUNDING);
        ck_assert_double_eq_tol(vec3_dot(u, a) / vec3_length(a), 1, ROUNDING);
    }
}
END_TEST

// Rejects: squares kept in float, which give up at 1e-19 and at 1e19.  Ours hold
// until the square leaves the range of a double: 1e-154 to 1e154 metres.
START_TEST(lengths_hold_from_the_smallest_to_the_largest_world)
{
    for (real size = 1e-150; size < 1e151; size *= 1e10) {
        vec3 a = vec3_make(2 * size, -3 * size, 6 * size);
        ck_assert_double_eq_tol(vec3_length(a) / (7 * size), 1, ROUNDING);
        ck_assert_double_eq_tol(vec3_length(vec3_unit(a)), 1, ROUNDING);
    }
}
END_TEST

// Rejects: 0 / 0, the commonest way for NaN to enter a simulation.
START_TEST(zero_vector_has_no_direction_and_stays_zero)
{
    vec3 zero = vec3_make(0, 0, 0);
    ck_assert(equal(vec3_unit(zero), zero));
}
END_TEST

// Rejects: a component that is not looked at; a compiler that was told that
// there is no NaN (-ffinite-math-only) and takes x - x for 0 always.
START_TEST(infinity_and_nan_are_seen_in_every_component)
{
    volatile real big = DBL_MAX;
    real infinite = big * 2, bad[] = { infinite, -infinite, infinite - infinite };
    ck_assert(vec3_is_finite(vec3_make(0, -1, DBL_MAX)));
    for (int i = 0; i < 3; i++) {
        ck_assert(!vec3_is_finite(vec3_make(bad[i], 1, 2)));
        ck_assert(!vec3_is_finite(vec3_make(1, bad[i], 2)));
        ck_assert(!vec3_is_finite(vec3_make(1, 2, bad[i])));
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        larger_and_smaller_hold_the_bound_against_nan,
        maker_keeps_the_order_of_the_components,
        sums_and_differences_go_component_by_component,
        a_step_along_b_starts_at_a,
        products_are_rounded_before_they_are_added,
        dot_product_weighs_each_axis_alone,
        cross_product_turns_x_to_y_into_z,
        cross_product_is_perpendicular_and_as_long_as_the_area,
        lengths_and_distances_are_those_of_pythagoras,
        unit_vector_has_length_one_and_keeps_its_direction,
        lengths_hold_from_the_smallest_to_the_largest_world,
        zero_vector_has_no_direction_and_stays_zero,
        infinity_and_nan_are_seen_in_every_component,
        NULL
    };
    return suite_run((suite){ .name = "vec3", .tests = tests });
}
