// check.c - tests of the exercise 02/bend.

#include "hinge.h"
#include "expect.h"
#include "gains.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <string.h>

// Room for the rounding of some ten operations near 1, each 1.1e-16.
static const real EXACT = 1e-14;
static const real ROUNDING = 1e-12;
static const real not_a_number = (real)NAN;

static particle at(real x, real y, real z, real inverse_mass)
{
    return (particle){ { x, y, z }, { x, y, z }, inverse_mass };
}

static unsigned long long seed = 1;

static void strip(particle *p, real fold)
{
    // The edge along x; the wing tips 2 and 3 each turned up by fold / 2.
    real c = cos(fold / 2), s = sin(fold / 2);
    p[0] = at(0, 0, 0, 1), p[1] = at(2, 0, 0, 0.5);
    p[2] = at(0.5, s, c, 2), p[3] = at(1.5, s, -c, 1);
}

START_TEST(flat_strip_has_no_gap)
{
    particle p[4];
    strip(p, 0);
    bend b;
    int where[4] = { 0, 1, 2, 3 };
    ck_assert(bend_make(&b, where, p, 1).ok);
    real sum = b.weight[0] + b.weight[1] + b.weight[2] + b.weight[3];
    near(sum, 0, EXACT, "sum of weights");
    near(bend_relax(b, p).error, 0, EXACT, "gap");
}
END_TEST

START_TEST(folded_strip_lies_flat_after_one_relaxation)
{
    // The gap is h sin(fold / 2), of first order in the fold; a stick between
    // the tips is short by 1 - cos(fold / 2), of second.  Rejects: shares that
    // forget a weight's square.
    particle p[4], q[4];
    bend b;
    int where[4] = { 0, 1, 2, 3 };
    strip(p, 0);
    ck_assert(bend_make(&b, where, p, 1).ok);
    for (real fold = 0.001; fold < 3; fold *= 2) {
        strip(p, fold);
        memcpy(q, p, sizeof p);
        stick_result r = bend_relax(b, p);
        near(r.error, sin(fold / 2), 4 * EXACT, "gap");
        ck_assert(r.moved);
        gains_nothing(q, p, 4, ROUNDING);
        near(bend_relax(b, p).error, 0, 4 * EXACT, "flat");
    }
    strip(p, 1);
    b.stiffness = 0.25;
    bend_relax(b, p);
    near(bend_relax(b, p).error, 0.75 * sin(0.5), 4 * EXACT, "soft");
}
END_TEST

START_TEST(skewed_strip_too)
{
    // Unequal triangles, lines that cross off the middle.
    for (int i = 0; i < 100; i++) {
        particle p[4] = { at(0, 0, 0, 1), at(1, 0, 0, 2),
                          at(random_real(&seed), 0.5 + 0.4 * random_real(&seed),
                             0, 3),
                          at(random_real(&seed), -1.5 + random_real(&seed) / 3,
                             0, 1) };
        bend b;
        int where[4] = { 0, 1, 2, 3 };
        ck_assert(bend_make(&b, where, p, 1).ok);
        near(bend_relax(b, p).error, 0, 16 * EXACT, "flat");
        p[2].position.z = 0.3;
        particle q[4];
        memcpy(q, p, sizeof p);
        ck_assert(bend_relax(b, p).error > 0);
        gains_nothing(q, p, 4, ROUNDING);
        near(bend_relax(b, p).error, 0, 16 * EXACT, "flat again");
    }
}
END_TEST

START_TEST(rope_bends_at_its_middle)
{
    particle p[3] = { at(0, 0, 0, 1), at(-1, 0, 0, 1), at(2, 0, 0, 1) };
    int where[4] = { 0, 0, 1, 2 };
    bend b;
    ck_assert(bend_make(&b, where, p, 1).ok);
    p[0].position.y = 0.6;
    particle q[3];
    memcpy(q, p, sizeof p);
    near(bend_relax(b, p).error, 0.6, EXACT, "gap");
    gains_nothing(q, p, 3, ROUNDING);
    near(bend_relax(b, p).error, 0, EXACT, "straight");
}
END_TEST

START_TEST(bend_without_a_crossing_is_refused)
{
    particle p[4] = { at(0, 0, 0, 1), at(1, 0, 0, 1),
                      at(0, 1, 0, 1), at(1, 1, 0, 1) };
    int where[4] = { 0, 1, 2, 3 };
    bend b = { { 7, 7, 7, 7 }, { 0, 0, 0, 0 }, 0.5 };
    status s = bend_make(&b, where, p, 1);
    ck_assert(!s.ok && strlen(s.why) > 10 && b.at[0] == 7);
    p[3] = p[2];
    ck_assert(!bend_make(&b, where, p, 1).ok);
    where[1] = 0;
    ck_assert(!bend_make(&b, where, p, 1).ok && b.at[0] == 7);
    // Rejects: a look at one of the four, or none at their differences.
    particle near_by[4] = { at(0, 0, 0, 1), at(2, 0, 0, 1),
                            at(1, -1, 0, 1), at(1, 1, 0, 1) };
    const int whole[4] = { 0, 1, 2, 3 };
    for (int i = 0; i < 4; i++) {
        particle q[4];
        memcpy(q, near_by, sizeof q);
        ck_assert(bend_make(&b, whole, q, 1).ok);
        b.at[0] = 7;
        q[i].position.z = i % 2 ? not_a_number : HUGE_VAL;
        s = bend_make(&b, whole, q, 1);
        ck_assert(!s.ok && strstr(s.why, "finite") && b.at[0] == 7);
    }
    for (int i = 0; i < 4; i++)
        near_by[i].position.z = i < 2 ? 1e308 : -1e308;
    s = bend_make(&b, whole, near_by, 1);
    ck_assert(!s.ok && strstr(s.why, "finite") && b.at[0] == 7);
}
END_TEST

START_TEST(pinned_bend_and_not_a_number_stay)
{
    particle p[4];
    bend b;
    int where[4] = { 0, 1, 2, 3 };
    strip(p, 0);
    ck_assert(bend_make(&b, where, p, 1).ok);
    strip(p, 1);
    for (int i = 0; i < 4; i++) p[i].inverse_mass = 0;
    stick_result r = bend_relax(b, p);
    ck_assert(!r.moved && r.error > 0.4);
    for (int i = 0; i < 4; i++) p[i].inverse_mass = 1;
    p[2].position.x = not_a_number;
    r = bend_relax(b, p);
    ck_assert(!r.moved && r.error == HUGE_VAL);
    ck_assert(vec3_is_finite(p[0].position));
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        flat_strip_has_no_gap,
        folded_strip_lies_flat_after_one_relaxation,
        skewed_strip_too,
        rope_bends_at_its_middle,
        bend_without_a_crossing_is_refused,
        pinned_bend_and_not_a_number_stay,
        NULL
    };
    return suite_run((suite){ .name = "bend", .tests = tests });
}
