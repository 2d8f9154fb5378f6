// expect.h - what tests of modules with a status expect.

#ifndef TUMBLE_TESTS_EXPECT_H
#define TUMBLE_TESTS_EXPECT_H

#include "status.h"

#include <check.h>
#include <string.h>

#define COUNT(list) ((int)(sizeof (list) / sizeof (list)[0]))

static inline void expect_why(status s, const char *why)
{
    ck_assert_msg(!s.ok, "accepted, wanted: %s", why);
    ck_assert_msg(strcmp(s.why, why) == 0, "said: %s\nwanted: %s", s.why, why);
}

static inline void expect_ok(status s)
{
    ck_assert_msg(s.ok, "refused: %s", s.why);
}

#endif
