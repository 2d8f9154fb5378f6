// known_pairs.h - what the tests of GJK and of the hit face share: pairs whose
// distance or depth is known exactly, and what the slow oracle says of others.

#ifndef TUMBLE_TESTS_KNOWN_PAIRS_H
#define TUMBLE_TESTS_KNOWN_PAIRS_H

#include "bodies.h"
#include "expect.h"
#include "oracle.h"

#ifndef PAIRS
#define PAIRS "tests/data/pairs-all.txt"
#endif

// 2^24 m and half of it: to move there and back loses nothing.
static const vec3 FAR_AWAY = { 16777216, -8388608, 16777216 };

static inline real true_distance(const body *a, const body *b)
{
    return (real)oracle_distance(body_hull(a), body_hull(b));
}

static inline real true_depth(const body *a, const body *b)
{
    return (real)oracle_depth(body_hull(a), body_hull(b));
}

// How far A goes along the normal until the bodies only touch; below 0: how far
// they are apart along it.
static inline real width_along(const body *a, const body *b, vec3 normal)
{
    return (real)oracle_width(body_hull(a), body_hull(b),
                              vec3_scale(-1, normal));
}

// Every stored pair, one after another.
static inline void each_known_pair(void (*judge)(const pair_known *p))
{
    FILE *file = fopen(PAIRS, "r");
    ck_assert_msg(file != NULL, "cannot open %s", PAIRS);
    static pair_known p;
    int read;
    while ((read = pair_read(file, &p)) == 1) judge(&p);
    fclose(file);
    ck_assert_int_eq(read, 0);
}

// To 1e-6, or to 1e-14 of the size near touch: the criterion of the set that
// they come from.
static inline void expect_known(const pair_known *p, real got)
{
    real error = fabs(got - p->value), size = pair_size(&p->a, &p->b);
    ck_assert_msg(error <= 1e-6 * p->value || error <= 1e-14 * size,
                  "%s: got %.17g, wanted %.17g", p->family, got, p->value);
}

#endif
