// check_status.c - does an answer say why not?
//
// Book: chapter 0.

#include <check.h>
#include <string.h>

#include "scarce.h"
#include "status.h"
#include "suite.h"

// Fills the stack that the next call will use, so that what it leaves unwritten
// is not zero by chance.
static size_t dirty_the_stack(void)
{
    volatile char old[4096];
    for (size_t i = 0; i < sizeof old; i++) old[i] = 'x';
    return sizeof old;
}

// Rejects: ok left false; a why that nothing has been written to, and so holds
// whatever lay there before.
START_TEST(ok_has_nothing_to_say)
{
    status s;
    memset(&s, 'x', sizeof s);
    ck_assert_uint_eq(dirty_the_stack(), 4096);
    s = status_ok();
    ck_assert(s.ok);
    ck_assert_str_eq(s.why, "");
}
END_TEST

// Rejects: ok left true; the format kept in the place of what it says.
START_TEST(failure_says_its_sentence)
{
    status s = status_fail("%s:%d: face %d has %.1f corners", "cube.obj", 12, 3, 2.5);
    ck_assert(!s.ok);
    ck_assert_str_eq(s.why, "cube.obj:12: face 3 has 2.5 corners");
}
END_TEST

// Rejects: vsprintf in the place of vsnprintf, also by way of a larger array, one
// byte too many, no closing 0.
START_TEST(long_sentence_is_cut_to_fit)
{
    static char longer[1000000];
    for (size_t length = 199; length < sizeof longer; length = 2 * length + 1) {
        memset(longer, 'x', length);
        longer[length] = 0;
        status s = status_fail("%s", longer);
        ck_assert(!s.ok);
        ck_assert_uint_eq(strlen(s.why), sizeof s.why - 1);
    }
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

// With no memory at all.  Rejects: a refused allocation that passes for success,
// or says nothing; a sentence that is made in memory from malloc.
START_TEST(refused_memory_is_a_failure_with_a_sentence)
{
    mallocs_left = 0;
    status s = status_out_of_memory(), t = status_fail("body %d", 7);
    mallocs_left = INT_MAX;
    ck_assert(!s.ok && !t.ok);
    ck_assert_str_eq(s.why, "out of memory");
    ck_assert_str_eq(t.why, "body 7");
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        ok_has_nothing_to_say,
        failure_says_its_sentence,
        long_sentence_is_cut_to_fit,
        two_failures_keep_their_own_sentences,
        refused_memory_is_a_failure_with_a_sentence,
        NULL
    };
    return suite_run((suite){ .name = "status", .tests = tests });
}
