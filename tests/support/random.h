// random.h - pseudo-random numbers for tests, exercises and figures: a linear
// congruential generator, the same on every machine.
//
// The caller holds the state, whose first value is the seed.  Ranges hold their
// lower end and not their upper one.

#ifndef TUMBLE_TESTS_RANDOM_H
#define TUMBLE_TESTS_RANDOM_H

#include "vec3.h"

// 64 bits, of which the higher ones are better: the lowest has the period 2.
static inline unsigned long long random_bits(unsigned long long *state)
{
    return *state = *state * 6364136223846793005ULL + 1442695040888963407ULL;
}

// Uniform in [0, 1).
static inline real random_fraction(unsigned long long *state)
{
    return (real)(random_bits(state) >> 11) * 0x1p-53;
}

// Uniform in [-1, 1).
static inline real random_real(unsigned long long *state)
{
    return 2 * random_fraction(state) - 1;
}

static inline real random_between(unsigned long long *state, real low,
                                  real high)
{
    return low + (high - low) * random_fraction(state);
}

// A whole number from 0 to n - 1.
static inline int random_below(unsigned long long *state, int n)
{
    return (int)((random_bits(state) >> 33) % (unsigned long long)n);
}

// Each component in [-size, size).  One after the other: C leaves the order of
// calls within an expression open.
static inline vec3 random_vec3(unsigned long long *state, real size)
{
    real x = random_real(state), y = random_real(state);
    return vec3_scale(size, vec3_make(x, y, random_real(state)));
}

// A unit vector, all directions alike.
static inline vec3 random_direction(unsigned long long *state)
{
    for (;;) {
        vec3 v = random_vec3(state, 1);
        real length = vec3_length(v);
        if (length > 0.1 && length < 1) return vec3_scale(1 / length, v);
    }
}

// A vector in any direction, its length between two numbers.
static inline vec3 random_vector(unsigned long long *state, real least,
                                 real most)
{
    real length = random_between(state, least, most);
    return vec3_scale(length, random_direction(state));
}

#endif
