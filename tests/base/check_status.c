// check_status.c - does an answer say why not?
//
// Book: chapter 0.

#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "status.h"

// Rejects: ok left at 0; an old sentence left standing in a good answer.
START_TEST(ok_has_nothing_to_say)
{
    status s = status_ok();
    ck_assert_int_eq(s.ok, 1);
    ck_assert_str_eq(s.why, "");
}
END_TEST

// Rejects: ok left at 1; the format kept in the place of what it says.
START_TEST(failure_says_its_sentence)
{
    status s = status_fail("%s:%d: face %d has %.1f corners", "cube.obj", 12, 3, 2.5);
    ck_assert_int_eq(s.ok, 0);
    ck_assert_str_eq(s.why, "cube.obj:12: face 3 has 2.5 corners");
}
END_TEST

// Rejects: sprintf in the place of vsnprintf, one byte too many, no closing 0.
START_TEST(long_sentence_is_cut_to_fit)
{
    char longer[1000];
    memset(longer, 'x', sizeof longer - 1);
    longer[sizeof longer - 1] = 0;
    status s = status_fail("%s", longer);
    ck_assert_int_eq(s.ok, 0);
    ck_assert_uint_eq(strlen(s.why), sizeof s.why - 1);
}
END_TEST

// Rejects: a why that points at one buffer shared by all answers.
START_TEST(two_failures_keep_their_own_sentences)
{
    status first = status_fail("the first"), second = status_fail("the second");
    ck_assert_str_eq(first.why, "the first");
    ck_assert_str_eq(second.why, "the second");
}
END_TEST

// Rejects: a refused allocation that passes for success, or says nothing.
START_TEST(refused_memory_is_a_failure_with_a_sentence)
{
    status s = status_out_of_memory();
    ck_assert_int_eq(s.ok, 0);
    ck_assert_str_eq(s.why, "out of memory");
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("status");
    TCase *answers = tcase_create("answers");
    tcase_add_test(answers, ok_has_nothing_to_say);
    tcase_add_test(answers, failure_says_its_sentence);
    tcase_add_test(answers, long_sentence_is_cut_to_fit);
    tcase_add_test(answers, two_failures_keep_their_own_sentences);
    tcase_add_test(answers, refused_memory_is_a_failure_with_a_sentence);
    suite_add_tcase(suite, answers);

    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0 ? EXIT_FAILURE : EXIT_SUCCESS;
}
