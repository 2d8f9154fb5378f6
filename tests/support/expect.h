// expect.h - what tests expect: numbers that are near enough, and a status.

#ifndef TUMBLE_TESTS_EXPECT_H
#define TUMBLE_TESTS_EXPECT_H

#include "status.h"
#include "vec3.h"

#include <check.h>
#include <stdio.h>
#include <string.h>

#define COUNT(list) ((int)(sizeof (list) / sizeof (list)[0]))

// ---- Is a number near enough?

// near(got, wanted, tolerance), near(got, wanted, tolerance, what) and
// near(got, wanted, tolerance, what, reason): the test fails, in this line,
// unless got is within the tolerance of wanted.  A NaN is near nothing.
#define near(...) \
    near_or_fail((near_reals){ .file = __FILE__, .line = __LINE__, __VA_ARGS__ })
// The same for vectors: their distance counts.
#define near_vec3(...) \
    near_vec3_or_fail((near_vec3s){ .file = __FILE__, .line = __LINE__, \
                                    __VA_ARGS__ })
// The same, with a tolerance that is a part of what is wanted.
#define near_relative(...) \
    near_part_or_fail((near_reals){ .file = __FILE__, .line = __LINE__, \
                                    __VA_ARGS__ })

typedef struct {
    const char *file;
    int line;
    real got, wanted, tolerance;
    const char *what, *reason;      // NULL: it goes without saying
} near_reals;

typedef struct {
    const char *file;
    int line;
    vec3 got, wanted;
    real tolerance;
    const char *what, *reason;
} near_vec3s;

// Ends the test with "what: got ..., wanted ....  reason".
static inline void near_fail(const char *file, int line, const char *what,
                             const char *said, const char *reason)
{
    _ck_assert_failed(file, line, "near", "%s%s%s%s%s", what ? what : "",
                      what ? ": " : "", said, reason ? ".  " : "",
                      reason ? reason : "");
}

static inline void near_or_fail(near_reals n)
{
    char said[200];
    _mark_point(n.file, n.line);
    if (fabs(n.got - n.wanted) <= n.tolerance) return;
    snprintf(said, sizeof said, "got %.15g, wanted %.15g (off by %.2g)", n.got,
             n.wanted, n.got - n.wanted);
    near_fail(n.file, n.line, n.what, said, n.reason);
}

static inline void near_part_or_fail(near_reals n)
{
    n.tolerance *= fabs(n.wanted);
    near_or_fail(n);
}

static inline void near_vec3_or_fail(near_vec3s n)
{
    char said[300];
    real off = vec3_distance(n.got, n.wanted);
    _mark_point(n.file, n.line);
    if (off <= n.tolerance) return;
    snprintf(said, sizeof said, "got (%.9g, %.9g, %.9g), wanted (%.9g, %.9g,"
             " %.9g) (off by %.2g)", n.got.x, n.got.y, n.got.z, n.wanted.x,
             n.wanted.y, n.wanted.z, off);
    near_fail(n.file, n.line, n.what, said, n.reason);
}

// ---- A status

// expect_why(status, why): the test fails, in this line, unless the status is a
// refusal in these words.
#define expect_why(...) why_or_fail(__FILE__, __LINE__, __VA_ARGS__)
#define expect_ok(...)  ok_or_fail(__FILE__, __LINE__, __VA_ARGS__)

static inline void why_or_fail(const char *file, int line, status s,
                               const char *why)
{
    _mark_point(file, line);
    if (s.ok) _ck_assert_failed(file, line, "refused", "accepted, wanted: %s",
                                why);
    if (strcmp(s.why, why) == 0) return;
    _ck_assert_failed(file, line, "why", "said: %s\nwanted: %s", s.why, why);
}

static inline void ok_or_fail(const char *file, int line, status s)
{
    _mark_point(file, line);
    if (!s.ok) _ck_assert_failed(file, line, "ok", "refused: %s", s.why);
}

#endif
