// judge.h - read before a test program: each of its tests asks the judge first.
//
// Check's own START_TEST and the two ways to add a test (of its versions 0.13 to
// 0.15), with one call more each.  The tests need not know of it.

#ifndef TUMBLE_JUDGE_H
#define TUMBLE_JUDGE_H

#include <check.h>

// Is the test asked for?  ONLY, in the environment, may name a single one, and
// LEAVE those that are not asked for; one that compares bits with ours is asked
// of nobody.
int judge_wants(const char *name);

// Runs the test, unless one before it did not end, and says on stderr when it
// begins and when it has ended.
void judge_trial(const char *name, void (*test)(int), int i);

#undef START_TEST
#define START_TEST(name)                                                     \
static void name##_tested(int);                                              \
static void name##_fn(int _i) { judge_trial(#name, name##_tested, _i); }     \
static const TTest name##_ttest = { #name, name##_fn, __FILE__, __LINE__ };  \
static const TTest *name = &name##_ttest;                                    \
static void name##_tested(int _i CK_ATTRIBUTE_UNUSED)

// Check notes where each ck_assert is that holds, to tell what came before a
// crash; the judge does not ask, and of a hundred thousand notes the reading
// takes longer than the tests.
#define _mark_point(file, line) ((void)0)

#undef tcase_add_loop_test
#define tcase_add_loop_test(tcase, test, from, to)                           \
do {                                                                         \
    if (judge_wants((test)->name))                                           \
        _tcase_add_test((tcase), (test), 0, 0, (from), (to));                \
} while (0)

#undef tcase_add_test
#define tcase_add_test(tcase, test) tcase_add_loop_test(tcase, test, 0, 1)

#endif
