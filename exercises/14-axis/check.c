// check.c - tests of the exercise 14/axis.

#include "axis.h"
#include "expect.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>

static const real ROUNDING = 1e-13;

// Both, in memory that ends behind the last point.
static void spreads(const vec3 *at, int n, real spread[3])
{
    vec3 *mine = malloc((size_t)(n > 0 ? n : 1) * sizeof *mine);
    ck_assert_ptr_nonnull(mine);
    for (int i = 0; i < n; i++) mine[i] = at[i];
    axis_spreads(mine, n, spread);
    free(mine);
}

static const vec3 FIVE[5] = { { 1, 0, 2 }, { 2, 0, 2 }, { 3, 1, 2 },
                              { 4, 0, 2 }, { 5, -1, 2 } };

START_TEST(spread_is_the_mean_square_from_the_mean)
{
    // x: mean 3, squares 4 1 0 1 4, mean 2.  y: mean 0, 2/5.  z: nothing.
    real spread[3] = { -1, -1, -1 };
    spreads(FIVE, 5, spread);
    near(spread[0], 2, ROUNDING, "spread along x");
    near(spread[1], 0.4, ROUNDING, "spread along y");
    near(spread[2], 0, ROUNDING, "spread along z");
}
END_TEST

START_TEST(nobody_is_spread_by_nothing)
{
    // Rejects: 0 / 0.
    real spread[3] = { -1, -1, -1 };
    spreads(FIVE, 0, spread);
    near(spread[0] + spread[1] + spread[2], 0, 0, "spreads of nobody");
    spreads(FIVE, 1, spread);
    near(spread[0] + spread[1] + spread[2], 0, 0, "spreads of one");
    ck_assert_int_eq(axis_widest(NULL, 0, -1), 0);
    ck_assert_int_eq(axis_widest(NULL, 0, 2), 2);
}
END_TEST

START_TEST(widest_axis_is_taken)
{
    vec3 at[6] = { { 0, 0, 0 } };
    for (int axis = 0; axis < 3; axis++) {
        for (int i = 0; i < 6; i++)
            at[i] = vec3_make(axis == 0 ? i : 0.1 * i, axis == 1 ? i : 0.2 * i,
                              axis == 2 ? i : 0.3 * i);
        ck_assert_int_eq(axis_widest(at, 6, -1), axis);
        for (int before = 0; before < 3; before++)
            ck_assert_int_eq(axis_widest(at, 6, before), axis);
    }
    // All alike.
    for (int i = 0; i < 6; i++) at[i] = vec3_make(i, i, i);
    ck_assert_msg(axis_widest(at, 6, -1) == 0, "of equals the first: got %d",
                  axis_widest(at, 6, -1));
    ck_assert_int_eq(axis_widest(at, 6, 2), 2);
}
END_TEST

START_TEST(far_from_the_origin_nothing_is_lost)
{
    // Ten thousand bodies of a metre's spread at (1, -2, 3) 10^7 m, all on a
    // grid that doubles have there.
    enum { N = 10000 };
    vec3 *at = malloc(N * sizeof *at);
    ck_assert_ptr_nonnull(at);
    real home[3], away[3];
    for (int i = 0; i < N; i++)
        at[i] = vec3_make((i * 37 % 256) / 64.0, (i * 101 % 512) / 64.0,
                          (i * 53 % 128) / 64.0);
    spreads(at, N, home);
    for (int i = 0; i < N; i++)
        at[i] = vec3_add(at[i], vec3_make(1e7, -2e7, 3e7));
    spreads(at, N, away);
    for (int k = 0; k < 3; k++) near(away[k] / home[k], 1, 1e-12, "spread");
    free(at);
}
END_TEST

START_TEST(lost_bodies_are_left_out)
{
    vec3 at[8];
    real spread[3], all[3];
    for (int where = 0; where < 6; where++) {
        for (int i = 0; i < 6; i++) at[i] = FIVE[i > where ? i - 1 : i % 5];
        at[where] = vec3_make(where % 2 ? (real)NAN : 1,
                              where % 2 ? 1 : HUGE_VAL, 0);
        spreads(at, 6, spread);
        spreads(FIVE, 5, all);
        for (int k = 0; k < 3; k++)
            near(spread[k], all[k], ROUNDING, "spread of the others");
    }
    at[0] = at[1] = vec3_make(0, 0, (real)NAN);
    spreads(at, 2, spread);
    near(spread[0] + spread[1] + spread[2], 0, 0, "spread of lost ones");
}
END_TEST

START_TEST(row_that_turns_changes_its_axis_once)
{
    // From x to y, in steps of a degree: tan t > 1.25 from 52 degrees on.
    vec3 at[20];
    int axis = 0, changed = -1, changes = 0;
    for (int degree = 0; degree <= 90; degree++) {
        real t = degree * 3.14159265358979324 / 180;
        for (int i = 0; i < 20; i++)
            at[i] = vec3_make(i * cos(t), i * sin(t), 0);
        int now = axis_widest(at, 20, axis);
        if (now != axis) changed = degree;
        changes += now != axis;
        axis = now;
    }
    ck_assert_msg(changes == 1 && changed == 52, "%d changes, the last at %d "
                  "degrees; wanted one, at 52", changes, changed);
    for (int degree = 90; degree >= 39; degree--) {
        real t = degree * 3.14159265358979324 / 180;
        for (int i = 0; i < 20; i++)
            at[i] = vec3_make(i * cos(t), i * sin(t), 0);
        axis = axis_widest(at, 20, axis);
    }
    ck_assert_msg(axis == 1, "back at 39 degrees it should still be y");
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        spread_is_the_mean_square_from_the_mean,
        nobody_is_spread_by_nothing,
        widest_axis_is_taken,
        far_from_the_origin_nothing_is_lost,
        lost_bodies_are_left_out,
        row_that_turns_changes_its_axis_once,
        NULL
    };
    return suite_run((suite){ .name = "axis", .tests = tests });
}
