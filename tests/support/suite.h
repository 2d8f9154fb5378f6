// suite.h - runs the tests of one program, each in a process of its own, and
// says which of them failed.

#ifndef TUMBLE_TESTS_SUITE_H
#define TUMBLE_TESTS_SUITE_H

#include <check.h>

typedef struct {
    const char *name;
    const TTest *const *tests;  // the last is NULL
    void (*set_up)(void);       // before each test; may be NULL
    void (*tear_down)(void);    // after each test; may be NULL
    int seconds;                // that a test may take; 0: as long as Check gives
    // Tests that run once for each number _i: from, from + 1, ... to - 1.
    struct {
        const TTest *test;
        int from, to;
    } repeated[3];
} suite;

static inline TCase *suite_case(const suite *s)
{
    TCase *t = tcase_create(s->name);
    tcase_add_checked_fixture(t, s->set_up, s->tear_down);
    if (s->seconds) tcase_set_timeout(t, s->seconds);
    for (int k = 0; s->tests[k]; k++) tcase_add_test(t, s->tests[k]);
    for (int k = 0; k < 3 && s->repeated[k].test; k++)
        tcase_add_loop_test(t, s->repeated[k].test, s->repeated[k].from,
                            s->repeated[k].to);
    return t;
}

// Returns what main returns: 0 if every test passed.
static inline int suite_run(suite s)
{
    Suite *all = suite_create(s.name);
    suite_add_tcase(all, suite_case(&s));
    SRunner *runner = srunner_create(all);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}

#endif
