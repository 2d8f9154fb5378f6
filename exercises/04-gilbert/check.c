// check.c - tests of the exercise 04/gilbert.

#include "gilbert.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>

// Some dozen roundings of numbers up to 10.
static const real ROUNDING = 1e-13;

static void foot(vec3 p, vec3 q, vec3 wanted, const char *what)
{
    vec3 got = segment_nearest(p, q);
    ck_assert_msg(vec3_distance(got, wanted) <= ROUNDING,
                  "%s: got (%g, %g, %g), wanted (%g, %g, %g)", what, got.x,
                  got.y, got.z, wanted.x, wanted.y, wanted.z);
}

static hull set(const vec3 *at, int count)
{
    return (hull){ at, count };
}

static hull box(vec3 at[8], vec3 low, vec3 high)
{
    for (int i = 0; i < 8; i++)
        at[i] = (vec3){ i & 1 ? high.x : low.x, i & 2 ? high.y : low.y,
                        i & 4 ? high.z : low.z };
    return set(at, 8);
}

static unsigned long long seed = 1966;

// A hull of eight random points around a place.
static hull cloud(vec3 at[8], vec3 centre)
{
    for (int i = 0; i < 8; i++) at[i] = vec3_add(centre, random_vec3(&seed, 1));
    return set(at, 8);
}

START_TEST(segment_has_a_foot_or_an_end)
{
    // Rejects: a projection beyond an end, 0 / 0.
    foot((vec3){ -1, 2, 0 }, (vec3){ 3, 2, 0 }, (vec3){ 0, 2, 0 }, "foot");
    foot((vec3){ 1, 2, 0 }, (vec3){ 3, 2, 0 }, (vec3){ 1, 2, 0 }, "end p");
    foot((vec3){ -3, 0, 2 }, (vec3){ -1, 0, 2 }, (vec3){ -1, 0, 2 }, "end q");
    foot((vec3){ -1, -1, 0 }, (vec3){ 3, 3, 0 }, (vec3){ 0, 0, 0 },
         "through the origin");
    foot((vec3){ 1, 2, 3 }, (vec3){ 1, 2, 3 }, (vec3){ 1, 2, 3 },
         "both ends in one point");
}
END_TEST

START_TEST(points_are_apart_by_their_distance)
{
    vec3 p = { 1, 2, 3 }, q[2] = { { 9, 9, 9 }, { 4, 6, 3 } };
    gilbert_result r = gilbert_distance(set(&p, 1), set(q + 1, 1), 1e-12, 10);
    near(r.most, 5, ROUNDING, "one point and one");
    ck_assert_msg(r.asked == 1, "one question shows it, got %d", r.asked);
    r = gilbert_distance(set(&p, 1), set(q, 2), 1e-9, 1000);
    near(r.most, 5, 1e-8, "a point and a segment, whose end is nearer");
}
END_TEST

START_TEST(boxes_are_apart_by_their_gap)
{
    // Rejects: supports on the far side, or on the same side of both.
    vec3 at[8], bt[8];
    hull a = box(at, (vec3){ -1, -2, -3 }, (vec3){ 1, 2, 3 });
    hull b = box(bt, (vec3){ 4, 6, 3 }, (vec3){ 5, 7, 4 });
    near(gilbert_distance(a, b, 1e-9, 100).most, 5, 1e-8, "corner to corner");
    b = box(bt, (vec3){ 3, 0, 0 }, (vec3){ 4, 0.5, 0.5 });
    near(gilbert_distance(a, b, 0.01, 1000).most, 2, 0.021, "face to face");
}
END_TEST

START_TEST(the_distance_lies_between_the_bounds)
{
    // However few questions are asked; and with many the bounds are as near as
    // was asked for.  Rejects: a bound that is not one.
    for (int k = 0; k < 300; k++) {
        vec3 at[8], bt[8];
        hull a = cloud(at, (vec3){ 0, 0, 0 });
        hull b = cloud(bt, random_vec3(&seed, 3));
        real true_one = gjk_distance(a, b, HUGE_VAL, NULL).distance;
        gilbert_result r = gilbert_distance(a, b, 1e-3, 1 + k % 7);
        ck_assert_msg(r.ok && r.least >= 0, "least is %g", r.least);
        ck_assert_msg(r.least <= true_one + ROUNDING
                      && r.most >= true_one - ROUNDING, "after %d questions "
                      "the distance is said to lie between %g and %g; it is "
                      "%g", r.asked, r.least, r.most, true_one);
        near(vec3_length(r.nearest), r.most, ROUNDING, "most, which is |v|");
    }
}
END_TEST

START_TEST(the_lower_bound_never_falls)
{
    for (int k = 0; k < 100; k++) {
        vec3 at[8], bt[8];
        hull a = cloud(at, (vec3){ 0, 0, 0 });
        hull b = cloud(bt, (vec3){ 2, 1, 0.5 });
        real least = 0, most = HUGE_VAL;
        for (int cap = 1; cap < 20; cap++) {
            gilbert_result r = gilbert_distance(a, b, 0, cap);
            ck_assert_msg(r.least >= least, "after %d questions the lower bound"
                          " falls from %g to %g", cap, least, r.least);
            ck_assert_msg(r.most <= most, "after %d questions v grows from %g "
                          "to %g", cap, most, r.most);
            least = r.least;
            most = r.most;
        }
    }
}
END_TEST

START_TEST(bodies_in_each_other_have_no_distance)
{
    // Rejects: a v of length 0 that is asked for its direction.
    vec3 at[8], p = { 1, 1, 1 };
    hull a = box(at, (vec3){ -1, -1, -1 }, (vec3){ 1, 1, 1 });
    gilbert_result r = gilbert_distance(a, a, 1e-3, 50);
    near(r.most, 0, 0, "a box in its own place");
    ck_assert_msg(r.asked == 0, "v is 0 from the first: got %d questions",
                  r.asked);
    r = gilbert_distance(set(&p, 1), a, 1e-3, 50);
    near(r.most, 0, ROUNDING, "a corner on a corner");
    ck_assert_msg(r.least == 0, "least is %g, wanted 0", r.least);
}
END_TEST

START_TEST(cap_is_kept)
{
    vec3 at[8], bt[8];
    hull a = box(at, (vec3){ -1, -1, -1 }, (vec3){ 1, 1, 1 });
    hull b = box(bt, (vec3){ 0.1, -0.3, 0.2 }, (vec3){ 3, 3, 3.3 });
    gilbert_result r = gilbert_distance(a, b, 1e-6, 25);
    ck_assert_msg(r.asked <= 25, "cap 25, got %d questions", r.asked);
    ck_assert_msg(r.least == 0, "they overlap, and least is %g", r.least);
    gilbert_answer yes = gilbert_beyond(a, b, 0, 25);
    ck_assert_msg(yes.answer != 1 && yes.asked <= 25, "they overlap: got the "
                  "answer %d after %d questions", yes.answer, yes.asked);
}
END_TEST

START_TEST(most_pairs_are_answered_by_one_question)
{
    // Rejects: measuring first.  Is the gap more than 1 m?  It is 8 m at least.
    for (int k = 0; k < 50; k++) {
        vec3 at[8], bt[8];
        hull a = cloud(at, (vec3){ 0, 0, 0 });
        hull b = cloud(bt, (vec3){ 10, 10, k % 7 });
        gilbert_answer r = gilbert_beyond(a, b, 1, 100);
        ck_assert_msg(r.answer == 1, "more than 1 m apart? got %d", r.answer);
        ck_assert_msg(r.asked == 1, "one question is enough, got %d", r.asked);
    }
    vec3 at[8];
    hull a = cloud(at, (vec3){ 0, 0, 0 });
    gilbert_answer r = gilbert_beyond(a, a, 0.5, 100);
    ck_assert_msg(r.answer == 0 && r.asked == 0, "two points are near enough "
                  "from the first: got %d after %d questions", r.answer,
                  r.asked);
}
END_TEST

START_TEST(yes_or_no_agrees_with_gjk)
{
    int said[2] = { 0, 0 };
    for (int k = 0; k < 500; k++) {
        vec3 at[8], bt[8];
        hull a = cloud(at, (vec3){ 0, 0, 0 });
        hull b = cloud(bt, random_vec3(&seed, 4));
        real true_one = gjk_distance(a, b, HUGE_VAL, NULL).distance;
        real margin = k % 2 ? 0.5 : 2;
        int wanted = true_one > margin;
        gilbert_answer r = gilbert_beyond(a, b, margin, 100000);
        ck_assert_msg(r.answer == wanted, "distance %g, margin %g: got %d, "
                      "wanted %d", true_one, margin, r.answer, wanted);
        said[wanted]++;
    }
    ck_assert_int_gt(said[0], 50);
    ck_assert_int_gt(said[1], 50);
}
END_TEST

START_TEST(what_is_not_finite_is_said)
{
    vec3 p = { 1, (real)NAN, 0 }, q[2] = { { 4, 6, 3 }, { 5, 5, -HUGE_VAL } };
    gilbert_result r = gilbert_distance(set(&p, 1), set(q, 1), 1e-3, 10);
    ck_assert_msg(!r.ok && r.most == 0 && r.least == 0, "NaN: ok is %d, most "
                  "%g", r.ok, r.most);
    r = gilbert_distance(set(q, 2), set(q, 1), 1e-3, 10);
    gilbert_answer yes = gilbert_beyond(set(&p, 1), set(q, 1), 1, 10);
    ck_assert_msg(yes.answer == -1, "NaN: the answer is %d, wanted -1",
                  yes.answer);
    p.y = 2;
    r = gilbert_distance(set(&p, 1), set(q, 2), 1e-3, 10);
    ck_assert_msg(!r.ok, "a point at infinity, and ok is 1");
}
END_TEST

START_TEST(it_gets_there_in_a_zigzag)
{
    // Two boxes face to face.  GJK asks a few times and has it exactly; ours
    // asks 67 times for 10 %, 821 times for 1 %.
    vec3 at[8], bt[8];
    hull a = box(at, (vec3){ -1, -2, -3 }, (vec3){ 1, 2, 3 });
    hull b = box(bt, (vec3){ 3, -1, -2 }, (vec3){ 4, 1, 2 });
    gjk_result g = gjk_distance(a, b, HUGE_VAL, NULL);
    gilbert_result r = gilbert_distance(a, b, 0.1, 100);
    near(r.most, 2, 0.21, "distance to 10 %");
    near(r.least, 2, 0.21, "lower bound to 10 %");
    r = gilbert_distance(a, b, 0.01, 1000);
    near(r.most, 2, 0.021, "distance to 1 %");
    near(r.least, 2, 0.021, "lower bound to 1 %");
    near(g.distance, 2, ROUNDING, "GJK");
    ck_assert_msg(g.iterations <= 10, "GJK has asked %d questions",
                  g.iterations);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        segment_has_a_foot_or_an_end,
        points_are_apart_by_their_distance,
        boxes_are_apart_by_their_gap,
        the_distance_lies_between_the_bounds,
        the_lower_bound_never_falls,
        bodies_in_each_other_have_no_distance,
        cap_is_kept,
        most_pairs_are_answered_by_one_question,
        yes_or_no_agrees_with_gjk,
        what_is_not_finite_is_said,
        it_gets_there_in_a_zigzag,
        NULL
    };
    return suite_run((suite){ .name = "gilbert", .tests = tests });
}
