// check.c - tests of the exercise 11/stand.

#include "stand.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>
#include <string.h>

// Some dozen roundings of numbers up to 10.
static const real ROUNDING = 1e-14;

static const vec3 DOWN = { 0, -9.81, 0 };

// Asks with memory that ends behind the last contact.
static stand ask(const vec3 *at, int n, vec3 center, vec3 down)
{
    vec3 *own = malloc((size_t)(n > 0 ? n : 1) * sizeof *own);
    ck_assert_ptr_nonnull(own);
    if (n > 0) memcpy(own, at, (size_t)n * sizeof *own);
    stand s = stand_find(n > 0 ? own : NULL, n, center, down);
    free(own);
    return s;
}

static void expect(const char *what, stand s, real margin, int a, int b)
{
    real off = s.margin == margin ? 0 : fabs(s.margin - margin);
    ck_assert_msg(off <= ROUNDING * 10, "%s: got a margin of %.15g m, wanted "
                  "%.15g m", what, s.margin, margin);
    ck_assert_msg(s.a == a && s.b == b, "%s: got the contacts %d and %d, "
                  "wanted %d and %d", what, s.a, s.b, a, b);
}

// A table of 2 m by 1 m, its legs anyhow.
static const vec3 LEG[4] = { { 1, 0, 0.5 }, { -1, 0, -0.5 }, { 1, 0, -0.5 },
                             { -1, 0, 0.5 } };

START_TEST(table_stands_on_its_four_legs)
{
    // Rejects: legs that are taken in the order in which they come; the mean
    // of the legs for a polygon; the sign.
    expect("weight in the middle, a hand to the right",
           ask(LEG, 4, (vec3){ 0.75, 0.8, 0 }, DOWN), 0.25, 0, 2);
    expect("weight near the front", ask(LEG, 4, (vec3){ 0, 0.8, 0.375 }, DOWN),
           0.125, 0, 3);
    expect("weight over the right rim",
           ask(LEG, 4, (vec3){ 1.5, 0.8, 0.25 }, DOWN), -0.5, 0, 2);
}
END_TEST

START_TEST(over_a_corner_it_is_the_corner_that_is_near)
{
    // 0.3 and 0.4 beyond: 0.5.
    // Rejects: sides that go on for ever.
    expect("weight beyond a corner", ask(LEG, 4, (vec3){ 1.3, 0.8, 0.9 }, DOWN),
           -0.5, 0, 0);
    expect("beyond the opposite one",
           ask(LEG, 4, (vec3){ -1.3, 0.8, -0.9 }, DOWN), -0.5, 1, 1);
}
END_TEST

START_TEST(three_legs_are_a_triangle)
{
    // Rejects: a box around the legs.
    const vec3 three[3] = { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 0, 3 } };
    expect("inside", ask(three, 3, (vec3){ 1.5, 5, 0.75 }, DOWN), 0.75, 0, 1);
    // The line 3 x + 4 z = 12: (3 . 2 + 4 . 3 - 12) / 5.
    expect("beyond the long side", ask(three, 3, (vec3){ 2, 5, 3 }, DOWN),
           -1.2, 1, 2);
    expect("inside, by the long side",
           ask(three, 3, (vec3){ 2, 5, 1.25 }, DOWN), 0.2, 1, 2);
}
END_TEST

START_TEST(contacts_in_between_change_nothing)
{
    const vec3 many[8] = { { 0, 0, 0 }, { 1, 0, 0.5 }, { -1, 0, -0.5 },
                           { 0.2, 0, 0.3 }, { 1, 0, -0.5 }, { 1, 0, 0.25 },
                           { -1, 0, 0.5 }, { 1, 0, 0.5 } };
    stand s = ask(many, 8, (vec3){ 0.75, 0.8, 0 }, DOWN);
    ck_assert_msg(fabs(s.margin - 0.25) < ROUNDING, "got %.15g, wanted 0.25",
                  s.margin);
    s = ask(many, 8, (vec3){ -1.5, 0.8, 0 }, DOWN);
    expect("over the left rim", s, -0.5, 2, 6);
}
END_TEST

START_TEST(slope_moves_the_foot)
{
    // A box of 2 m by 2 m, its centre 1.5 m over a slope of 3:4 (sin 0.6):
    // along the slope the foot is 1.5 . 0.75 m downhill, 0.125 m beyond the
    // rim, and seen along the weight all that is cos = 0.8 of it.
    // Rejects: what is seen from above the floor; `down` not made a unit.
    const vec3 foot[4] = { { 1, 0, 1 }, { 1, 0, -1 }, { -1, 0, 1 },
                           { -1, 0, -1 } };
    expect("a high box", ask(foot, 4, (vec3){ 0, 1.5, 0 },
                             (vec3){ 6, -8, 0 }), -0.1, 0, 1);
    expect("a low box", ask(foot, 4, (vec3){ 0, 1, 0 },
                            (vec3){ 6, -8, 0 }), 0.2, 0, 1);
    expect("uphill to the right", ask(foot, 4, (vec3){ 0, 1, 0 },
                                      (vec3){ -0.06, -0.08, 0 }), 0.2, 2, 3);
}
END_TEST

START_TEST(legs_need_not_be_equally_long)
{
    // A chair with its hind legs on a step.
    const vec3 foot[4] = { { 1, 0, 1 }, { 1, 5, -1 }, { -1, 0, 1 },
                           { -1, 5, -1 } };
    expect("a step", ask(foot, 4, (vec3){ 0, 9, -0.75 }, DOWN), 0.25, 1, 3);
}
END_TEST

START_TEST(knife_and_needle_hold_nothing)
{
    // Rejects: a line with an inside; 0 / 0.
    const vec3 line[4] = { { 0, 0, 0 }, { 3, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 } };
    stand s = ask(line, 4, (vec3){ 2, 1, 0 }, DOWN);
    ck_assert_msg(fabs(s.margin) < ROUNDING, "exactly over a line: got %g",
                  s.margin);
    expect("beside a line", ask(line, 4, (vec3){ 2, 1, -0.5 }, DOWN), -0.5,
           0, 1);
    expect("beyond its end", ask(line, 4, (vec3){ 6, 1, 4 }, DOWN), -5, 1, 1);
    s = ask(line, 1, (vec3){ 0, 1, 0 }, DOWN);
    ck_assert_msg(fabs(s.margin) < ROUNDING, "exactly over a point: got %g",
                  s.margin);
    expect("beside a point", ask(line, 1, (vec3){ 3, 1, 4 }, DOWN), -5, 0, 0);
    s = ask(line + 2, 2, (vec3){ 1, 1, 2 }, DOWN);
    ck_assert_msg(fabs(s.margin + 2) < ROUNDING, "beside a point that is there "
                  "twice: got %g, wanted -2", s.margin);
}
END_TEST

START_TEST(many_contacts_are_nearly_a_circle)
{
    // A regular polygon of 40 corners, the radius of its inner circle 1.
    enum { N = 40 };
    vec3 at[N];
    real by = 2 * acos(-1.0) / N, radius = 1 / cos(by / 2);
    for (int k = 0; k < N; k++) {
        int place = 7 * k % N;
        at[k] = (vec3){ radius * cos(by * place), 0, radius * sin(by * place) };
    }
    stand s = ask(at, N, (vec3){ 0, 3, 0 }, DOWN);
    ck_assert_msg(fabs(s.margin - 1) < ROUNDING * 10, "got %.15g, wanted 1",
                  s.margin);
}
END_TEST

START_TEST(nothing_is_lost_far_away)
{
    // Rejects: places that are measured from the world's origin.
    vec3 far = { 0x1.5p33, 0x1.9p32, -0x1.3p33 }, at[4];
    for (int k = 0; k < 4; k++) at[k] = vec3_add(far, LEG[k]);
    vec3 weight = vec3_add(far, (vec3){ 0.75, 0.75, 0 });
    stand s = ask(at, 4, weight, (vec3){ 0.0625, -1, 0.03125 });
    // As near the origin.
    stand near = ask(LEG, 4, (vec3){ 0.75, 0.75, 0 },
                     (vec3){ 0.0625, -1, 0.03125 });
    ck_assert_msg(fabs(s.margin - near.margin) < ROUNDING, "far away the "
                  "margin is %.15g, near the origin %.15g", s.margin,
                  near.margin);
}
END_TEST

START_TEST(what_is_no_answer_says_so)
{
    // Rejects: NaN that leaves; a contact that is not there.
    const vec3 up = { 0, 1, 0 }, zero = { 0, 0, 0 };
    const vec3 bad[3] = { { 0, 0, 0 }, { (real)NAN, 0, 0 }, { 0, 0, 1 } };
    expect("no contact", ask(NULL, 0, up, DOWN), -HUGE_VAL, -1, -1);
    expect("no weight", ask(LEG, 4, up, zero), -HUGE_VAL, -1, -1);
    stand s = ask(LEG, 4, (vec3){ (real)NAN, 0, 0 }, DOWN);
    ck_assert_msg(s.margin == -HUGE_VAL, "a centre that is no number: got %g",
                  s.margin);
    s = ask(bad, 3, up, DOWN);
    ck_assert_msg(s.margin <= 0, "a contact that is no number: got %g",
                  s.margin);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        table_stands_on_its_four_legs,
        over_a_corner_it_is_the_corner_that_is_near,
        three_legs_are_a_triangle,
        contacts_in_between_change_nothing,
        slope_moves_the_foot,
        legs_need_not_be_equally_long,
        knife_and_needle_hold_nothing,
        many_contacts_are_nearly_a_circle,
        nothing_is_lost_far_away,
        what_is_no_answer_says_so,
        NULL
    };
    return suite_run((suite){ .name = "stand", .tests = tests });
}
