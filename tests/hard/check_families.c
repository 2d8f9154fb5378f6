// check_families.c - can the rows of the second list fail, and do they see what
// a program sees?  The short forms of the cheap rows are run.
//
// A row that falls short is a result, which `make hard` holds against the
// committed table.  Here those must hold that hold.

#include "family.h"
#include "suite.h"

#include <check.h>
#include <math.h>
#include <stdlib.h>

static hard_report *new_report(void)
{
    hard_report *r = calloc(1, sizeof *r);
    ck_assert(r != NULL);
    return r;
}

static double error_of(family_worst f)
{
    hard_report *r = new_report();
    family_add(r, &f, "m", "it");
    double error = r->part[0].error;
    ck_assert_int_eq(hard_holds(&r->part[0]), error <= f.target);
    free(r);
    return error;
}

// Rejects: the last trial in the place of the worst.
START_TEST(the_worst_trial_speaks_for_its_row)
{
    family_worst f = { .target = 1 };
    family_trial(&f, 0.5, "first");
    family_trial(&f, 2, "second");
    family_trial(&f, 0.25, "third");
    ck_assert_double_eq(error_of(f), 2);
    ck_assert_str_eq(f.where, "second");
    ck_assert_int_eq(f.trials, 3);
    ck_assert_int_eq(f.beyond, 1);
}
END_TEST

// Rejects: error > target as the sign of failure, and fmax, which let NaN go.
START_TEST(a_trial_of_nan_is_beyond_every_target)
{
    family_worst f = { .target = 1 };
    family_trial(&f, 0.5, "a number");
    family_trial(&f, (double)NAN, "not a number");
    family_trial(&f, 0.75, "a number again");
    ck_assert(error_of(f) > 1e300);
    ck_assert_str_eq(f.where, "not a number");
    ck_assert_int_eq(f.beyond, 1);
}
END_TEST

// Rejects: a range that turned out empty, and held.
START_TEST(a_row_without_a_trial_does_not_hold)
{
    family_worst f = { .target = 1 };
    ck_assert(error_of(f) > 1e300);
}
END_TEST

// Rejects: a failure of tumble.h that a row passes over.
START_TEST(what_is_refused_does_not_hold)
{
    hard_report *r = new_report();
    ck_assert(!family_ok(r, NULL));
    ck_assert(!hard_holds(hard_worst(r)));
    tumble_world *w = tumble_world_make(NULL);
    r->parts = 0;
    ck_assert(family_ok(r, w) && r->parts == 0);
    tumble_shape_box(w, tumble_v(-1, 1, 1), 1);
    ck_assert(!family_ok(r, w));
    tumble_world_free(w);
    free(r);
}
END_TEST

// ---- rows that hold --------------------------------------------------------

static void must_hold(int number)
{
    const hard_case *c = hard_find(number);
    ck_assert_msg(c != NULL, "no row %d", number);
    hard_report *r = new_report();
    c->run(r, 1);
    ck_assert_int_gt(r->parts, 0);
    for (int i = 0; i < r->parts; i++)
        ck_assert_msg(hard_holds(&r->part[i]), "row %d: %s: %g, not %g",
                      number, r->part[i].what, r->part[i].error,
                      r->part[i].target);
    free(r);
}

#define ROW(number, name) START_TEST(name) { must_hold(number); } END_TEST

ROW(116, a_plate_on_a_circle_takes_its_rider_along)
ROW(118, a_body_on_a_belt_slips_as_far_as_friction_says)
ROW(126, elastic_bodies_keep_their_energy_without_gravity)
ROW(128, a_ball_with_spin_strikes_by_coulombs_law)
ROW(136, a_tower_sags_by_its_law)
ROW(146, friction_has_no_direction)
ROW(147, nothing_gains_energy)
ROW(150, what_falls_freely_is_on_its_parabola)
ROW(155, a_ball_bounces_in_a_geometric_series)

// Rejects: two rows of one number, of which only the first is run.
START_TEST(every_number_stands_once)
{
    for (const hard_case *const *l = hard_all.list; *l; l++)
        for (const hard_case *c = *l; c->number > 0; c++) {
            ck_assert_int_le(c->number, HARD_LAST);
            ck_assert_msg(hard_find(c->number) == c, "%d twice", c->number);
        }
}
END_TEST

START_TEST(rotations_follow_each_other)
{
    family_seed s = 1;
    tumble_quat a = family_rotation(&s), b = family_rotation(&s);
    tumble_vec3 x = family_direction(&s);
    tumble_vec3 once = v_turn(q_times(a, b), x);
    tumble_vec3 twice = v_turn(a, v_turn(b, x));
    ck_assert_double_le(v_distance(once, twice), 1e-14);
    ck_assert_double_eq_tol(v_length(once), 1, 1e-14);
}
END_TEST

START_TEST(a_second_has_sixty_steps)
{
    tumble_world *w = tumble_world_make(NULL);
    family_run(w, 1);
    ck_assert_double_eq_tol(tumble_world_time(w), 1, 1e-9);
    tumble_world_free(w);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        the_worst_trial_speaks_for_its_row,
        a_trial_of_nan_is_beyond_every_target,
        a_row_without_a_trial_does_not_hold,
        what_is_refused_does_not_hold,
        a_plate_on_a_circle_takes_its_rider_along,
        a_body_on_a_belt_slips_as_far_as_friction_says,
        elastic_bodies_keep_their_energy_without_gravity,
        a_ball_with_spin_strikes_by_coulombs_law,
        a_tower_sags_by_its_law,
        friction_has_no_direction,
        nothing_gains_energy,
        what_falls_freely_is_on_its_parabola,
        a_ball_bounces_in_a_geometric_series,
        every_number_stands_once,
        rotations_follow_each_other,
        a_second_has_sixty_steps,
        NULL
    };
    return suite_run((suite){ .name = "families", .tests = tests,
                              .seconds = 60 });
}
