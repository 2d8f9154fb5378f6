// check_clock.c - does the harness of chapter 21 time what it says?
//
// No time is tested here, only which runs are counted, and what is made of
// their times.
// Book: chapter 21.

#include <check.h>
#include <math.h>

#include "ball.h"
#include "clock.h"
#include "suite.h"

// Powers of ten, taken to pieces by logarithms and put together again.
static const real ROUNDING = 1e-12;

// Rejects: a median of numbers that have not been sorted; the upper of the
// two in the middle; a read before the first of none.
START_TEST(median_is_in_the_middle)
{
    real odd[] = { 5, 1, 100 }, even[] = { 4, 1, 100, 2 };
    ck_assert_double_eq(clock_median(odd, 3), 5);
    ck_assert_double_eq(clock_median(even, 4), 3);
    ck_assert_double_eq(clock_median(odd, 0), 0);
}
END_TEST

// Rejects: straight lines on linear scales, which give 0.091.
START_TEST(curve_is_met_on_a_straight_line_of_logarithms)
{
    const real seconds[] = { 1, 10, 100 }, error[] = { 1, 1e-2, 1e-4 };
    ck_assert_double_eq_tol(clock_at_error(seconds, error, 3, 0.1), sqrt(10),
                            10 * ROUNDING);
    ck_assert_double_eq_tol(clock_at_error(seconds, error, 3, 1e-3),
                            10 * sqrt(10), 100 * ROUNDING);
}
END_TEST

// Rejects: a curve that is continued beyond its ends.
START_TEST(curve_is_not_continued)
{
    const real seconds[] = { 1, 10 }, error[] = { 1e-1, 1e-2 };
    ck_assert_double_eq(clock_at_error(seconds, error, 2, 0.5), 1);
    ck_assert(isinf(clock_at_error(seconds, error, 2, 1e-3)));
    ck_assert(isinf(clock_at_error(seconds, error, 0, 1)));
}
END_TEST

// Rejects: the first point that is good enough, where a later one took less; an
// error of 0 whose logarithm is taken.
START_TEST(quickest_of_all_points_counts)
{
    const real seconds[] = { 8, 4, 2 }, error[] = { 0, 0, 1e-3 };
    ck_assert_double_eq(clock_at_error(seconds, error, 3, 1e-2), 2);
    const real to_none[] = { 1, 0 };
    ck_assert_double_eq(clock_at_error(seconds, to_none, 2, 1e-2), 4);
}
END_TEST

// Rejects: a run that exploded and passes for one without error.
START_TEST(what_exploded_does_not_count)
{
    const real seconds[] = { 1, 2, 4 }, error[] = { (real)NAN, 1, 1e-2 };
    ck_assert_double_eq(clock_at_error(seconds, error, 3, 1e-2), 4);
    const real lost[] = { 1, (real)NAN, (real)NAN };
    ck_assert(isinf(clock_at_error(seconds, lost, 3, 1e-2)));
}
END_TEST

enum { WAYS = 5, ROUNDS = 7 };
static int calls[WAYS], order[WAYS * (ROUNDS + 1)], all;

static void note(int way, void *with)
{
    ck_assert_ptr_eq(with, calls);
    calls[way]++;
    order[all++] = way;
}

// Rejects: a way that is left out of a round, or timed while still cold; a
// round that always goes the same way.
START_TEST(every_way_runs_once_in_every_round)
{
    lap l[WAYS];
    int same = 1;
    clock_race((race){ WAYS, ROUNDS, 0, note, calls }, l);
    for (int way = 0; way < WAYS; way++)
        ck_assert_int_eq(calls[way], ROUNDS + 1);
    for (int round = 0; round <= ROUNDS; round++) {
        int seen = 0;
        for (int k = 0; k < WAYS; k++) seen |= 1 << order[round * WAYS + k];
        ck_assert_int_eq(seen, (1 << WAYS) - 1);
        for (int k = 0; k < WAYS && round > 1; k++)
            same &= order[round * WAYS + k] == order[WAYS + k];
    }
    ck_assert(!same);
}
END_TEST

static long runs;

static void count(int way, void *with)
{
    (void)way;
    (void)with;
    runs++;
}

// Rejects: a time of one call that is that of a slice; a ratio the wrong way
// round.  (A call takes nanoseconds, so a millisecond holds thousands.)
START_TEST(short_work_is_repeated)
{
    lap l[2];
    clock_race((race){ 2, 3, 1e-3, count, NULL }, l);
    ck_assert_int_gt(runs, 1000);
    ck_assert_double_eq(l[0].ratio, 1);
    ck_assert(l[0].seconds > 0 && l[0].seconds < 1e-4);
}
END_TEST

static void work_long(int way, void *with)
{
    volatile int *k = with;
    for (*k = 0; *k < (way ? 40000 : 1000); ++*k) { }
}

// Rejects: a ratio the wrong way round.  (Forty times the work: were it four
// on a bad day, it is still the slower one.)
START_TEST(ratio_is_to_the_first_way)
{
    lap l[2];
    int k;
    clock_race((race){ 2, 5, 1e-3, work_long, &k }, l);
    ck_assert(l[1].ratio > 4 && l[1].seconds > 4 * l[0].seconds);
}
END_TEST

// Rejects: faces that look inwards or overlap (shape_convex refuses them), a
// corner that stands twice, one that is off the sphere.
START_TEST(ball_has_its_corners_on_the_sphere)
{
    const int corners[BALL_LEVELS] = { 12, 42, 162, 642 };
    for (int level = 0; level < BALL_LEVELS; level++) {
        shape s;
        ck_assert(ball_shape(&s, level, 0.5, 1).ok);
        ck_assert_int_eq(s.particles, corners[level]);
        ck_assert_int_eq(s.mesh.faces, 2 * corners[level] - 4);
        for (int i = 0; i < s.particles; i++)
            ck_assert_double_eq_tol(vec3_length(s.at[i]), 0.5, ROUNDING);
        shape_free(&s);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        // Times.
        median_is_in_the_middle,
        curve_is_met_on_a_straight_line_of_logarithms,
        curve_is_not_continued,
        quickest_of_all_points_counts,
        what_exploded_does_not_count,
        // Races.
        every_way_runs_once_in_every_round,
        short_work_is_repeated,
        ratio_is_to_the_first_way,
        // Balls.
        ball_has_its_corners_on_the_sphere,
        NULL
    };
    return suite_run((suite){ .name = "clock", .tests = tests });
}
