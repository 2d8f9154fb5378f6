// hostile.h - numbers of every size that a double can hold, zero among them, and
// vectors of them: nothing that is not finite may come of these.

#ifndef TUMBLE_TESTS_HOSTILE_H
#define TUMBLE_TESTS_HOSTILE_H

#include "random.h"

#include <float.h>

static inline real hostile(unsigned long long *state)
{
    const real size[] = { 0, DBL_TRUE_MIN, DBL_MIN, 1e-200, 1e-20, 1, 1e20,
                          1e150 };
    return size[(int)(random_fraction(state) * 8)];
}

static inline vec3 hostile_vec3(unsigned long long *state)
{
    real sign = random_fraction(state) < 0.5 ? -1 : 1;
    real x = sign * hostile(state), y = -sign * hostile(state);
    return vec3_make(x, y, hostile(state));
}

// Any direction; one in ten has no length.
static inline vec3 hostile_normal(unsigned long long *state)
{
    real size = random_fraction(state) < 0.1 ? 0 : 1;
    return vec3_unit(random_vec3(state, size));
}

#endif
