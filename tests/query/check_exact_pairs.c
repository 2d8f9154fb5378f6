// check_exact_pairs.c - a few pairs of each hard family, held against exact
// truth.  `make queries-exact` asks about many more.

#include "exact_judge.h"
#include "expect.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>

enum { EACH = 60 };

static void expect_right(const made *a, const made *b, int family, int pair)
{
    truth t = truth_find((hull){ a->at, a->count }, (hull){ b->at, b->count });
    ck_assert_msg(t.doubt <= 4e-15L * t.size + 1e-7L * fabsl(t.value),
                  "%s, pair %d: the truth is not proven", MADE_NAME[family],
                  pair);
    for (int ask = 0; ask < ASKS; ask++) {
        verdict v = exact_judge(a, b, &t, ask, 7);
        ck_assert_msg(!v.bad && !v.sign && !v.witness && !v.normal,
                      "%s, pair %d, %s: %.17g for %.17g; of the size: wrong by "
                      "%.1e, points by %.1e, normal by %.1e", MADE_NAME[family],
                      pair, ASK_NAME[ask], v.value, (real)t.value, v.error,
                      v.points, v.along);
    }
}

static void expect_family(int family, int pairs)
{
    for (int n = 0; n < pairs; n++) {
        unsigned long long seed = 2718 + (unsigned)n * 7919ULL;
        made a, b;
        made_pair(&a, &b, family, &seed);
        expect_right(&a, &b, family, n);
    }
}

// Rejects: the weights of the last simplex as points, whatever they give; a gap
// below 2e-12 of the size taken for 0.
START_TEST(edges_along_one_line_get_their_points)
{
    expect_family(12, 4 * EACH);
    expect_family(13, 4 * EACH);
}
END_TEST

// Rejects: a normal that is the difference of two points almost in one place.
START_TEST(boxes_at_rest_get_the_normal_of_their_faces)
{
    expect_family(14, 4 * EACH);
}
END_TEST

// Of 1,500,000 such pairs 46 end with weights that give v, while no plane parts the
// bodies by as much; here are eight.  Rejects: a proof by the weights alone, which
// takes boxes 7e-10 m apart for boxes that touch.
START_TEST(weights_alone_prove_nothing)
{
    static const struct { int family; unsigned long long seed; } ends[] = {
        { 14, 3640762583433459602ULL }, { 14, 14504744027947939217ULL },
        { 14, 6125342048739557377ULL }, { 13, 16792875304091868404ULL },
        { 13, 14617275901776130731ULL }, { 13, 11311692251506540513ULL },
        { 12, 5799411731086672201ULL }, { 12, 8438181983331837916ULL }
    };
    for (int k = 0; k < 8; k++) {
        unsigned long long seed = ends[k].seed;
        made a, b;
        made_pair(&a, &b, ends[k].family, &seed);
        expect_right(&a, &b, ends[k].family, k);
    }
}
END_TEST

START_TEST(all_families_are_answered_exactly)
{
    for (int f = 0; f < MADE_FAMILIES; f++) expect_family(f, EACH);
}
END_TEST

// ---- the judge itself

// Two boxes whose distance or depth is plain.
static truth of_boxes(vec3 apart)
{
    vec3 a[8], b[8];
    for (int i = 0; i < 8; i++) {
        a[i] = (vec3){ i & 1, i >> 1 & 1, i >> 2 & 1 };
        b[i] = vec3_add(a[i], apart);
    }
    return truth_find((hull){ a, 8 }, (hull){ b, 8 });
}

START_TEST(the_truth_of_boxes_is_what_anyone_can_see)
{
    static const struct { vec3 apart; long double value; } known[] = {
        { { 3, 0.5, 0 }, 2 }, { { 4, 5, 0 }, 5 }, { { 0.25, 0, 0.5 }, -0.5L },
        { { 1, 0.5, 0.5 }, 0 }, { { 1 + 0x1p-52, 0, 0 }, 0x1p-52L },
        { { 1 - 0x1p-40, 0, 0 }, -0x1p-40L }
    };
    for (int k = 0; k < 6; k++)
        ck_assert(fabsl(of_boxes(known[k].apart).value - known[k].value)
                  <= 2e-17L);
}
END_TEST

// Rejects: a judge that believes what it is told.
START_TEST(the_judge_sees_a_wrong_truth)
{
    unsigned long long seed = 3;
    made a, b;
    made_pair(&a, &b, 0, &seed);
    truth t = truth_find((hull){ a.at, a.count }, (hull){ b.at, b.count });
    ck_assert(!exact_judge(&a, &b, &t, ASK_PAPER, 1).bad);
    t.value *= 1 + 2e-6L;
    ck_assert(exact_judge(&a, &b, &t, ASK_PAPER, 1).bad);
    ck_assert(exact_judge(&a, &b, &t, ASK_ENGINE, 1).normal);
    t.value = -t.value;
    ck_assert(exact_judge(&a, &b, &t, ASK_ENGINE_CARRIED, 1).sign);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        the_truth_of_boxes_is_what_anyone_can_see,
        the_judge_sees_a_wrong_truth,
        edges_along_one_line_get_their_points,
        boxes_at_rest_get_the_normal_of_their_faces,
        weights_alone_prove_nothing,
        all_families_are_answered_exactly,
        NULL
    };
    return suite_run((suite){ .name = "exact_pairs", .tests = tests,
                              .seconds = 60 });
}
