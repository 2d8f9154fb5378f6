// check_impact.c - do rows that are stopped together end as rows that are stopped
// one after the other, until nothing changes?  Book: chapter 15.

#include <check.h>
#include <string.h>

#include "expect.h"
#include "impact.h"
#include "random.h"
#include "suite.h"

// The last body is driven: nothing pushes it.
enum { EACH = 5, DRIVEN = EACH - 1, MOST = 10 };

static unsigned long long seed;
static impact_set set;
static impact_row row[IMPACT_ROWS];
static motion velocity[EACH];
static int rows;

static impact_row any_row(const real inverse[EACH], bool is_pulled)
{
    impact_row r = { .along = random_direction(&seed) };
    r.body[A] = random_below(&seed, DRIVEN);
    r.body[B] = random_below(&seed, EACH);
    if (r.body[B] == r.body[A]) r.body[B] = DRIVEN;
    for (int side = A; side < BODIES; side++) {
        r.inverse[side] = inverse[r.body[side]];
        for (int t = 0; t < TURNS && r.body[side] != DRIVEN; t++)
            r.turn[side][t] = sqrt(r.inverse[side]) * random_real(&seed);
    }
    if (r.body[B] == DRIVEN && !is_pulled) r.body[B] = -1;
    return r;
}

// Some bodies, and rows between them; some rows are there twice.  In half of the
// scenes the immovable side is the ground, in the others a driven body.
static void any_rows(int n)
{
    bool is_pulled = random_below(&seed, 2);
    real inverse[EACH] = { 0 };
    for (int b = 0; b < EACH; b++) {
        velocity[b] = (motion){ { 0 } };
        if (b < DRIVEN) inverse[b] = exp(random_real(&seed));
        for (int i = 0; i < (b < DRIVEN ? MOTIONS : MOTION_TURN); i++)
            velocity[b].of[i] = random_real(&seed);
    }
    rows = n;
    for (int i = 0; i < n; i++)
        row[i] = i > 0 && random_below(&seed, 5) == 0
            ? row[random_below(&seed, i)] : any_row(inverse, is_pulled);
}

static void add_rows(int first, int end)
{
    for (int i = first; i < end; i++)
        impact_add(&set, &row[i], impact_parting(&row[i], velocity));
    impact_stop(&set);
    impact_apply(&set, velocity);
}

// The oracle: projected Gauss-Seidel, until nothing changes.
static bool sweep_rows(motion u[EACH])
{
    real impulse[IMPACT_ROWS] = { 0 };
    for (long n = 0; n < 1000000; n++) {
        real most = 0;
        for (int i = 0; i < rows; i++) {
            real mass = 1 / impact_product(&row[i], &row[i]);
            real next = impulse[i] - mass * impact_parting(&row[i], u);
            next = real_max(next, 0);
            impact_push(&row[i], next - impulse[i], u);
            most = real_max(most, fabs(next - impulse[i]));
            impulse[i] = next;
        }
        if (most < 1e-12) return true;
    }
    return false;
}

static void expect_velocities(const motion wanted[EACH], int round)
{
    for (int b = 0; b < EACH; b++)
        for (int i = 0; i < MOTIONS; i++)
            ck_assert_msg(fabs(velocity[b].of[i] - wanted[b].of[i]) < 1e-6,
                          "round %d, %d rows, body %d: %g, swept %g", round, rows,
                          b, velocity[b].of[i], wanted[b].of[i]);
}

// Impulses may share a load in many ways, but the velocities after are those of
// least energy: one answer.  Rejects: a row left closing; one that pulls, or pushes
// what parts; a set that keeps what it should have dropped.
START_TEST(what_is_stopped_at_once_is_what_sweeps_end_with)
{
    int swept = 0, pushed = 0;
    seed = 21;
    for (int round = 0; round < 3000; round++) {
        motion wanted[EACH];
        any_rows(1 + random_below(&seed, MOST));
        memcpy(wanted, velocity, sizeof wanted);
        impact_begin(&set);
        add_rows(0, rows);
        for (int i = 0; i < rows; i++) {
            ck_assert(set.impulse[i] >= 0);
            pushed += set.impulse[i] > 0;
        }
        if (!sweep_rows(wanted)) continue;
        swept++;
        expect_velocities(wanted, round);
    }
    ck_assert_int_ge(swept, 2900);
    ck_assert_int_ge(pushed, 3000);
}
END_TEST

// Rejects: rows that come later and forget what was given; impulses given twice.
START_TEST(rows_that_come_later_end_as_if_all_had_come_at_once)
{
    seed = 22;
    for (int round = 0; round < 3000; round++) {
        motion began[EACH], wanted[EACH];
        any_rows(2 + random_below(&seed, MOST));
        memcpy(began, velocity, sizeof began);
        impact_begin(&set);
        add_rows(0, rows);
        memcpy(wanted, velocity, sizeof wanted);
        memcpy(velocity, began, sizeof began);
        impact_begin(&set);
        add_rows(0, rows / 2);
        add_rows(rows / 2, rows);
        expect_velocities(wanted, round);
    }
}
END_TEST

// Rejects: a loop without an end, or one that ends too soon, where many more rows
// push than there are ways to move.
START_TEST(as_many_rows_as_there_are_leave_none_closing)
{
    seed = 23;
    for (int round = 0; round < 300; round++) {
        any_rows(IMPACT_ROWS);
        impact_begin(&set);
        add_rows(0, rows);
        for (int i = 0; i < rows; i++)
            ck_assert(impact_parting(&row[i], velocity) > -1e-8);
    }
}
END_TEST

// What closes beyond its gap: here with gaps that are all others, so that no sum of
// impulses meets all of more rows than there are ways to move.  Rejects: a row left
// closing because others stand for it; one that pushes and parts.
START_TEST(rows_with_gaps_stop_or_do_not_push)
{
    seed = 24;
    int pushed = 0;
    for (int round = 0; round < 3000; round++) {
        real gap[IMPACT_ROWS];    // m/s: over the substep
        any_rows(2 + random_below(&seed, IMPACT_ROWS - 1));
        impact_begin(&set);
        for (int i = 0; i < rows; i++) {
            gap[i] = 0.01 * random_fraction(&seed);
            impact_add(&set, &row[i], impact_parting(&row[i], velocity) + gap[i]);
        }
        impact_stop(&set);
        impact_apply(&set, velocity);
        for (int i = 0; i < rows; i++) {
            real parts = impact_parting(&row[i], velocity) + gap[i];
            ck_assert(parts > -1e-8);
            ck_assert(set.impulse[i] == 0
                      || (set.impulse[i] > 0 && parts < 1e-8));
            pushed += set.impulse[i] > 0;
        }
    }
    ck_assert_int_ge(pushed, 3000);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        what_is_stopped_at_once_is_what_sweeps_end_with,
        rows_that_come_later_end_as_if_all_had_come_at_once,
        as_many_rows_as_there_are_leave_none_closing,
        rows_with_gaps_stop_or_do_not_push, NULL
    };
    return suite_run((suite){ .name = "impact", .tests = tests });
}
