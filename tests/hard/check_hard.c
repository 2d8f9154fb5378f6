// check_hard.c - the hard cases in their short forms, one test each.
//
// What they measure and how well is printed by `make hard`; here they must
// hold.

#include "hard.h"
#include "suite.h"

#include <check.h>
#include <math.h>
#include <stdlib.h>

static void must_hold(int number)
{
    const hard_case *c = hard_find(number);
    hard_report *r = calloc(1, sizeof *r);
    ck_assert_msg(c && r, "no case %d", number);
    c->run(r, 1);
    for (int i = 0; i < r->parts; i++)
        ck_assert_msg(hard_holds(&r->part[i]), "case %d: %s: %g, not %g",
                      number, r->part[i].what, r->part[i].error,
                      r->part[i].target);
    free(r);
}

#define CASE(number, name) \
    START_TEST(name) { must_hold(number); } END_TEST

CASE(1, free_flight_is_a_parabola)
CASE(2, an_oscillator_keeps_the_discrete_period)
CASE(3, a_spinning_stick_keeps_its_speed)
CASE(4, a_pendulum_is_of_second_order)
CASE(5, a_pendulum_keeps_its_energy_for_a_minute)
CASE(6, a_double_pendulum_is_of_second_order)
CASE(7, a_whipping_chain_keeps_its_length_and_energy)
CASE(8, a_loaded_rope_does_not_stretch)
CASE(9, a_hanging_chain_finds_its_rest)
CASE(10, a_free_body_keeps_both_momenta)
CASE(11, a_box_flips_about_its_middle_axis_on_time)
CASE(12, a_symmetric_top_precesses_at_its_rate)
CASE(22, random_pairs_are_answered_as_can_be_proven)
CASE(23, sphere_trees_hold_a_strained_body)
CASE(24, a_cloth_that_falls_or_folds_never_crosses_itself)
CASE(25, a_flat_cloth_lies_still)
CASE(26, a_full_room_stays_whole)
CASE(27, a_cloth_on_the_cube_crosses_nothing)
CASE(32, a_cloth_that_lands_flat_is_not_torn)
CASE(36, silk_denim_and_card_stay_on_a_small_cube)

// ---- the frame -------------------------------------------------------------

START_TEST(the_worst_part_speaks_for_its_case)
{
    hard_report *r = calloc(1, sizeof *r);
    ck_assert(r != NULL);
    hard_add(r, 0, 0, "", "nothing of nothing");
    hard_add(r, 3, 10, "m", "a third");
    ck_assert(hard_holds(hard_worst(r)));
    ck_assert_int_eq(hard_worst(r) - r->part, 1);
    hard_add(r, 1e-9, 0, "", "a little of nothing");
    ck_assert(!hard_holds(hard_worst(r)));
    free(r);
}
END_TEST

// Rejects: error > target as the sign of failure, which NaN is not.
START_TEST(a_nan_falls_short)
{
    hard_report *r = calloc(1, sizeof *r);
    ck_assert(r != NULL);
    hard_add(r, 0.5, 1, "", "good");
    hard_add(r, (double)NAN, 1, "", "not a number");
    ck_assert_int_eq(hard_worst(r) - r->part, 1);
    ck_assert(!hard_holds(hard_worst(r)));
    free(r);
}
END_TEST

START_TEST(an_order_is_a_slope)
{
    const double step[3] = { 0.1, 0.05, 0.025 };
    const double error[3] = { 3e-3, 7.5e-4, 1.875e-4 };
    ck_assert_double_eq_tol(hard_order(step, error, 3), 2, 1e-12);
}
END_TEST

// Rejects: fmax, which prefers any number to a NaN.
START_TEST(a_nan_is_the_worst_for_good)
{
    ck_assert_double_eq(hard_worse(1, 2), 2);
    ck_assert_double_eq(hard_worse(2, 1), 2);
    double worst = hard_worse(1, (double)NAN);
    ck_assert(hard_worse(worst, 2) > 1e300);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        free_flight_is_a_parabola,
        an_oscillator_keeps_the_discrete_period,
        a_spinning_stick_keeps_its_speed,
        a_pendulum_is_of_second_order,
        a_pendulum_keeps_its_energy_for_a_minute,
        a_double_pendulum_is_of_second_order,
        a_whipping_chain_keeps_its_length_and_energy,
        a_loaded_rope_does_not_stretch,
        a_hanging_chain_finds_its_rest,
        a_free_body_keeps_both_momenta,
        a_box_flips_about_its_middle_axis_on_time,
        a_symmetric_top_precesses_at_its_rate,
        random_pairs_are_answered_as_can_be_proven,
        sphere_trees_hold_a_strained_body,
        a_cloth_that_falls_or_folds_never_crosses_itself,
        a_flat_cloth_lies_still,
        a_full_room_stays_whole,
        a_cloth_on_the_cube_crosses_nothing,
        a_cloth_that_lands_flat_is_not_torn,
        silk_denim_and_card_stay_on_a_small_cube,
        the_worst_part_speaks_for_its_case,
        a_nan_falls_short,
        a_nan_is_the_worst_for_good,
        an_order_is_a_slope,
        NULL
    };
    // The short forms take a second together; without optimisation, under
    // valgrind or the sanitizers, much more.
    return suite_run((suite){ .name = "hard", .tests = tests, .seconds = 60 });
}
