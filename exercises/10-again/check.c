// check.c - tests of the exercise 10/again.

#include "again.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdbool.h>

// A dozen roundings of numbers up to 10.
static const real ROUNDING = 1e-13;

enum { POINTS = 8, PAIRS = 1000, FRAMES = 20 };

static unsigned long long seed = 10;

// Two bodies that drift: eight random points of a box of 2 m each.
typedef struct {
    vec3   a[POINTS], b[POINTS], way;
    memory known;
} pair;

static pair drifting(vec3 apart, real speed)
{
    pair p = { .way = random_vec3(&seed, speed) };
    for (int i = 0; i < POINTS; i++) {
        p.a[i] = vec3_add(apart, random_vec3(&seed, 1));
        p.b[i] = random_vec3(&seed, 1);
    }
    return p;
}

static hull hull_a(const pair *p) { return (hull){ p->a, POINTS }; }
static hull hull_b(const pair *p) { return (hull){ p->b, POINTS }; }

static void move_on(pair *p)
{
    for (int i = 0; i < POINTS; i++) p->a[i] = vec3_add(p->a[i], p->way);
}

START_TEST(gap_of_boxes_along_any_direction)
{
    // Cubes of 2 m, their middles 5 m apart along x.
    vec3 at[8], bt[8];
    for (int i = 0; i < 8; i++) {
        at[i] = vec3_make(i & 1 ? 6 : 4, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
        bt[i] = vec3_make(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    }
    hull a = { at, 8 }, b = { bt, 8 };
    near(gap_along(a, b, vec3_make(1, 0, 0)), 3, ROUNDING, "along x");
    near(gap_along(a, b, vec3_make(7, 0, 0)), 3, ROUNDING,
         "along x, n of length 7");
    near(gap_along(a, b, vec3_make(0.6, 0.8, 0)), 0.2, ROUNDING,
         "along 0.6, 0.8, 0");
    near(gap_along(a, b, vec3_make(0, 2, 0)), -2, ROUNDING, "along y");
    near(gap_along(a, b, vec3_make(-1, 0, 0)), -7, ROUNDING, "against x");
}
END_TEST

// Is r what GJK says?  A bound may be less than the distance.
static void compare(const pair *p, gjk_result r, real margin)
{
    gjk_result g = gjk_distance(hull_a(p), hull_b(p), HUGE_VAL, NULL);
    bool beyond = r.status == GJK_BEYOND;
    ck_assert_msg(beyond == (g.distance > margin), "they are %g m apart, the "
                  "margin is %g m, and the status %d", g.distance, margin,
                  (int)r.status);
    if (beyond) {
        ck_assert(r.distance > margin && r.distance <= g.distance + ROUNDING);
        ck_assert_msg(gap_along(hull_a(p), hull_b(p), r.axis)
                      >= r.distance - ROUNDING, "the axis does not part them");
    } else {
        near(r.distance, g.distance, ROUNDING, "distance");
        ck_assert_int_eq(r.status == GJK_OVERLAP, g.status == GJK_OVERLAP);
    }
}

// Rejects: an old axis that is believed without a look.
START_TEST(every_answer_is_that_of_gjk)
{
    for (int k = 0; k < PAIRS; k++) {
        pair p = drifting(random_vec3(&seed, 4), 0.3);
        for (int f = 0; f < FRAMES; f++, move_on(&p))
            compare(&p, ask_again(hull_a(&p), hull_b(&p), 0.1, &p.known), 0.1);
    }
}
END_TEST

// Bodies that come straight at each other, a centimetre a frame.
START_TEST(apart_by_less_than_the_margin_is_not_beyond)
{
    for (int k = 0; k < 20; k++) {
        pair p = drifting(vec3_make(3.2, 0, 0), 0);
        p.way = vec3_make(-0.01, 0, 0);
        for (int f = 0; f < 250; f++, move_on(&p))
            compare(&p, ask_again(hull_a(&p), hull_b(&p), 0.5, &p.known), 0.5);
    }
}
END_TEST

START_TEST(what_stays_far_is_not_asked_of_gjk)
{
    int asked = 0;
    for (int k = 0; k < PAIRS; k++) {
        pair p = drifting(vec3_make(6, 0, 0), 0.02);
        for (int f = 0; f < FRAMES; f++, move_on(&p))
            asked += ask_again(hull_a(&p), hull_b(&p), 0.1,
                               &p.known).iterations > 0;
    }
    ck_assert_msg(asked <= 1.2 * PAIRS, "GJK was asked %d times about %d pairs "
                  "in %d frames", asked, (int)PAIRS, (int)FRAMES);
}
END_TEST

START_TEST(what_stays_near_is_asked_for_one_support)
{
    long supports = 0, queries = 0;
    for (int k = 0; k < PAIRS; k++) {
        pair p = drifting(vec3_make(2.2, 0, 0), 0.001);
        for (int f = 0; f < FRAMES; f++, move_on(&p)) {
            gjk_result r = ask_again(hull_a(&p), hull_b(&p), 9, &p.known);
            if (f == 0 || r.status != GJK_APART) continue;
            supports += r.iterations;
            queries++;
        }
    }
    ck_assert_msg(supports <= 1.2 * (double)queries && queries > 5000,
                  "%ld support points in %ld queries", supports, queries);
}
END_TEST

START_TEST(what_is_not_finite_is_seen)
{
    for (int k = 0; k < POINTS; k++) {
        pair p = drifting(vec3_make(6, 0, 0), 0);
        ck_assert_int_eq(ask_again(hull_a(&p), hull_b(&p), 0.1,
                                   &p.known).status, GJK_BEYOND);
        p.a[k].y = (real)NAN;
        ck_assert_int_eq(ask_again(hull_a(&p), hull_b(&p), 0.1,
                                   &p.known).status, GJK_NOT_FINITE);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        gap_of_boxes_along_any_direction,
        every_answer_is_that_of_gjk,
        apart_by_less_than_the_margin_is_not_beyond,
        what_stays_far_is_not_asked_of_gjk,
        what_stays_near_is_asked_for_one_support,
        what_is_not_finite_is_seen,
        NULL
    };
    return suite_run((suite){ .name = "again", .tests = tests });
}
