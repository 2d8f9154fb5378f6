//> real4-head
// real4.h - four numbers side by side, on which one instruction works at once.
//
// Paper: not asked.  Book: chapter 13.
// The plain form, four numbers and a loop, gives the same bits: it is what a
// compiler without vector types uses, and what the tests compare with.

#pragma once

#include "inline.h"
#include "vec3.h"

#include <stdbool.h>
#include <string.h>

enum { REAL4 = 4 };
//<

//> real4-plain
//>   Four numbers are four registers where a compiler has no vectors, two as a
//>   rule, and one where AVX may be used.
#if !defined(__GNUC__) || defined(TUMBLE_PLAIN_REAL4)
enum { REAL4_REGISTERS = REAL4 };
typedef real real4_part;
typedef bool real4_mask;
#define REAL4_LANE(x, l) (x).of[l]
#define REAL4_OF(a, b, c, d) { { a, b, c, d } }

static inline real4_part real4_select(real4_mask m, real4_part a,
                                      real4_part b)
{
    return m ? a : b;
}
#else
#if defined(__AVX__) || defined(TUMBLE_WIDE_REAL4)
enum { REAL4_REGISTERS = 1 };
#define REAL4_OF(a, b, c, d) { { { a, b, c, d } } }
#else
// As every x86-64 and every 64-bit ARM has them.
enum { REAL4_REGISTERS = 2 };
#define REAL4_OF(a, b, c, d) { { { a, b }, { c, d } } }
#endif
// Wherever it lies, 16 bytes are enough.
enum { REAL4_IN = REAL4 / REAL4_REGISTERS };
enum { REAL4_BYTES = REAL4_IN * sizeof(real) };
typedef real real4_part __attribute__((vector_size(REAL4_BYTES), aligned(16)));
typedef long long real4_mask
    __attribute__((vector_size(REAL4_BYTES), aligned(16)));
#define REAL4_LANE(x, l) (x).of[(l) / REAL4_IN][(l) % REAL4_IN]

static inline real4_part real4_select(real4_mask m, real4_part a,
                                      real4_part b)
{
    return (real4_part)(((real4_mask)a & m) | ((real4_mask)b & ~m));
}
#endif

typedef struct {
    real4_part of[REAL4_REGISTERS];
} real4;
//<

//> real4-operations
//>   Every form has the same operations, with the same bits
//>   (`four_at_once_are_the_bits_of_each_alone_in_every_form`).
#define REAL4_OPERATION(name, expression)                 \
    static inline real4 name(real4 p, real4 q)            \
    {                                                     \
        for (int k = 0; k < REAL4_REGISTERS; k++) {       \
            real4_part a = p.of[k], b = q.of[k];          \
            p.of[k] = (expression);                       \
        }                                                 \
        return p;                                         \
    }

REAL4_OPERATION(real4_add, a + b)
REAL4_OPERATION(real4_sub, a - b)
REAL4_OPERATION(real4_mul, a * b)
REAL4_OPERATION(real4_div, a / b)
REAL4_OPERATION(real4_max, real4_select((real4_mask)(a > b), a, b))
REAL4_OPERATION(real4_min, real4_select((real4_mask)(a < b), a, b))

static inline real4 real4_make(real a, real b, real c, real d)
{
    return (real4)REAL4_OF(a, b, c, d);
}

// Lane by lane: a where s > 0, else b.
static inline real4 real4_if_positive(real4 s, real4 a, real4 b)
{
    const real4_part zero = { 0 };
    for (int k = 0; k < REAL4_REGISTERS; k++)
        a.of[k] = real4_select((real4_mask)(s.of[k] > zero), a.of[k], b.of[k]);
    return a;
}

static inline real4 real4_sqrt(real4 a)
{
    return real4_make(sqrt(REAL4_LANE(a, 0)), sqrt(REAL4_LANE(a, 1)),
                      sqrt(REAL4_LANE(a, 2)), sqrt(REAL4_LANE(a, 3)));
}

// Is any of the four not zero?
static inline bool real4_any(real4 a)
{
    return REAL4_LANE(a, 0) != 0 || REAL4_LANE(a, 1) != 0
        || REAL4_LANE(a, 2) != 0 || REAL4_LANE(a, 3) != 0;
}

// Numbers 2 k and 2 k + 1 of four bodies become two lanes of bodies.
static inline void real4_gather2(const real *const from[REAL4], int k,
                                 real4 *even, real4 *odd)
{
    int i = 2 * k, j = i + 1;
    *even = real4_make(from[0][i], from[1][i], from[2][i], from[3][i]);
    *odd = real4_make(from[0][j], from[1][j], from[2][j], from[3][j]);
}

static inline void real4_scatter2(real *const to[REAL4], int k, real4 even,
                                  real4 odd)
{
    for (int l = 0; l < REAL4; l++) {
        to[l][2 * k] = REAL4_LANE(even, l);
        to[l][2 * k + 1] = REAL4_LANE(odd, l);
    }
}
//<

//> real4-sums
//>   Sums and dot products of them, in every form.
// One of the four.
static inline void real4_set(real4 *a, int l, real value)
{
    memcpy((char *)a + (size_t)l * sizeof value, &value, sizeof value);
}

static inline real real4_get(const real4 *a, int l)
{
    real value;
    memcpy(&value, (const char *)a + (size_t)l * sizeof value, sizeof value);
    return value;
}

static inline real4 real4_all(real s)
{
    return real4_make(s, s, s, s);
}

static inline real4 real4_mad(real4 a, real4 b, real4 c)    // a b + c
{
    return real4_add(real4_mul(a, b), c);
}

static inline real4 real4_dot(const real4 a[3], const real4 b[3])
{
    return real4_mad(a[0], b[0],
                     real4_mad(a[1], b[1], real4_mul(a[2], b[2])));
}

static inline void real4_cross(const real4 a[3], const real4 b[3], real4 c[3])
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        c[i] = real4_sub(real4_mul(a[j], b[k]), real4_mul(a[k], b[j]));
    }
}

// to += a s, for three lanes; and to -= a s.
static inline void real4_add3(real4 to[3], const real4 a[3], real4 s)
{
    for (int i = 0; i < 3; i++) to[i] = real4_mad(a[i], s, to[i]);
}

static inline void real4_sub3(real4 to[3], const real4 a[3], real4 s)
{
    for (int i = 0; i < 3; i++) to[i] = real4_sub(to[i], real4_mul(a[i], s));
}
//<
