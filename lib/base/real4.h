//> real4-head
// real4.h - four numbers side by side, on which one instruction works at once.
//
// Paper: not asked.  Book: chapter 13.
// The plain form, four numbers and a loop, gives the same bits: it is what a
// compiler without vector types uses, and what the tests compare with.

#ifndef TUMBLE_REAL4_H
#define TUMBLE_REAL4_H

#include "inline.h"
#include "vec3.h"

#include <stdbool.h>
#include <string.h>

enum { REAL4 = 4 };
//<

//> real4-plain
//>   Four numbers with an operation for each need, as a loop.
#if !defined(__GNUC__) || defined(TUMBLE_PLAIN_REAL4)
typedef struct {
    real x[REAL4];
} real4;

#define REAL4_OPERATION(name, expression)                      \
    static inline real4 name(real4 a, real4 b)                 \
    {                                                          \
        real4 c;                                               \
        for (int l = 0; l < REAL4; l++) c.x[l] = (expression); \
        return c;                                              \
    }

REAL4_OPERATION(real4_add, a.x[l] + b.x[l])
REAL4_OPERATION(real4_sub, a.x[l] - b.x[l])
REAL4_OPERATION(real4_mul, a.x[l] * b.x[l])
REAL4_OPERATION(real4_div, a.x[l] / b.x[l])
REAL4_OPERATION(real4_max, a.x[l] > b.x[l] ? a.x[l] : b.x[l])
REAL4_OPERATION(real4_min, a.x[l] < b.x[l] ? a.x[l] : b.x[l])

static inline real4 real4_make(real a, real b, real c, real d)
{
    return (real4){ { a, b, c, d } };
}

// Lane by lane: a where s > 0, else b.
static inline real4 real4_if_positive(real4 s, real4 a, real4 b)
{
    real4 c;
    for (int l = 0; l < REAL4; l++) c.x[l] = s.x[l] > 0 ? a.x[l] : b.x[l];
    return c;
}

static inline real4 real4_sqrt(real4 a)
{
    for (int l = 0; l < REAL4; l++) a.x[l] = sqrt(a.x[l]);
    return a;
}

// Is any of the four not zero?
static inline bool real4_any(real4 a)
{
    return a.x[0] != 0 || a.x[1] != 0 || a.x[2] != 0 || a.x[3] != 0;
}

// Numbers 2 k and 2 k + 1 of four bodies become two lanes of bodies.
static inline void real4_gather2(const real *const from[REAL4], int k,
                                 real4 *even, real4 *odd)
{
    for (int l = 0; l < REAL4; l++) {
        even->x[l] = from[l][2 * k];
        odd->x[l] = from[l][2 * k + 1];
    }
}

static inline void real4_scatter2(real *const to[REAL4], int k, real4 even,
                                  real4 odd)
{
    for (int l = 0; l < REAL4; l++) {
        to[l][2 * k] = even.x[l];
        to[l][2 * k + 1] = odd.x[l];
    }
}
//<

//> real4-wide
//>   The same as one register, where AVX may be used.
#elif defined(__AVX__) || defined(TUMBLE_WIDE_REAL4)
// One register of 32 bytes, wherever it lies.
typedef real real2 __attribute__((vector_size(16)));
typedef real real4 __attribute__((vector_size(32), aligned(16)));
typedef long long mask4 __attribute__((vector_size(32), aligned(16)));

static inline real4 real4_add(real4 a, real4 b)
{
    return a + b;
}

static inline real4 real4_sub(real4 a, real4 b)
{
    return a - b;
}

static inline real4 real4_mul(real4 a, real4 b)
{
    return a * b;
}

static inline real4 real4_div(real4 a, real4 b)
{
    return a / b;
}

static inline real4 real4_select(mask4 m, real4 a, real4 b)
{
    return (real4)(((mask4)a & m) | ((mask4)b & ~m));
}

static inline real4 real4_max(real4 a, real4 b)
{
    return real4_select((mask4)(a > b), a, b);
}

static inline real4 real4_min(real4 a, real4 b)
{
    return real4_select((mask4)(a < b), a, b);
}

static inline real4 real4_make(real a, real b, real c, real d)
{
    return (real4){ a, b, c, d };
}

// Lane by lane: a where s > 0, else b.
static inline real4 real4_if_positive(real4 s, real4 a, real4 b)
{
    const real4 zero = { 0, 0, 0, 0 };
    return real4_select((mask4)(s > zero), a, b);
}

static inline real4 real4_sqrt(real4 a)
{
    return (real4){ sqrt(a[0]), sqrt(a[1]), sqrt(a[2]), sqrt(a[3]) };
}

// Is any of the four not zero?
static inline bool real4_any(real4 a)
{
    return a[0] != 0 || a[1] != 0 || a[2] != 0 || a[3] != 0;
}

// Numbers 2 k and 2 k + 1 of four bodies become two lanes of bodies.  What they
// come from is aligned to 16 bytes.
static inline void real4_gather2(const real *const from[REAL4], int k,
                                 real4 *even, real4 *odd)
{
    real2 a = ((const real2 *)from[0])[k], b = ((const real2 *)from[1])[k];
    real2 c = ((const real2 *)from[2])[k], d = ((const real2 *)from[3])[k];
    *even = (real4){ a[0], b[0], c[0], d[0] };
    *odd = (real4){ a[1], b[1], c[1], d[1] };
}

static inline void real4_scatter2(real *const to[REAL4], int k, real4 even,
                                  real4 odd)
{
    for (int l = 0; l < REAL4; l++)
        ((real2 *)to[l])[k] = (real2){ even[l], odd[l] };
}
//<

//> real4-vectors
//>   The same as two registers, with the same bits
//>   (`four_at_once_are_the_bits_of_each_alone_in_every_form`).
#else
// Two registers of 16 bytes, which every x86-64 and every 64-bit ARM has.
typedef real real2 __attribute__((vector_size(16)));
typedef long long mask2 __attribute__((vector_size(16)));

typedef struct {
    real2 lo, hi;
} real4;

static inline real4 real4_add(real4 a, real4 b)
{
    return (real4){ a.lo + b.lo, a.hi + b.hi };
}

static inline real4 real4_sub(real4 a, real4 b)
{
    return (real4){ a.lo - b.lo, a.hi - b.hi };
}

static inline real4 real4_mul(real4 a, real4 b)
{
    return (real4){ a.lo * b.lo, a.hi * b.hi };
}

static inline real4 real4_div(real4 a, real4 b)
{
    return (real4){ a.lo / b.lo, a.hi / b.hi };
}

static inline real2 real2_select(mask2 m, real2 a, real2 b)
{
    return (real2)(((mask2)a & m) | ((mask2)b & ~m));
}

static inline real4 real4_max(real4 a, real4 b)
{
    return (real4){ real2_select((mask2)(a.lo > b.lo), a.lo, b.lo),
                    real2_select((mask2)(a.hi > b.hi), a.hi, b.hi) };
}

static inline real4 real4_min(real4 a, real4 b)
{
    return (real4){ real2_select((mask2)(a.lo < b.lo), a.lo, b.lo),
                    real2_select((mask2)(a.hi < b.hi), a.hi, b.hi) };
}

static inline real4 real4_make(real a, real b, real c, real d)
{
    return (real4){ { a, b }, { c, d } };
}

// Lane by lane: a where s > 0, else b.
static inline real4 real4_if_positive(real4 s, real4 a, real4 b)
{
    const real2 zero = { 0, 0 };
    return (real4){ real2_select((mask2)(s.lo > zero), a.lo, b.lo),
                    real2_select((mask2)(s.hi > zero), a.hi, b.hi) };
}

static inline real4 real4_sqrt(real4 a)
{
    return (real4){ { sqrt(a.lo[0]), sqrt(a.lo[1]) },
                    { sqrt(a.hi[0]), sqrt(a.hi[1]) } };
}

// Is any of the four not zero?
static inline bool real4_any(real4 a)
{
    const real2 zero = { 0, 0 };
    mask2 m = (mask2)(a.lo != zero) | (mask2)(a.hi != zero);
    return (m[0] | m[1]) != 0;
}

// Numbers 2 k and 2 k + 1 of four bodies become two lanes of bodies.  What they
// come from is aligned to 16 bytes.
static inline void real4_gather2(const real *const from[REAL4], int k,
                                 real4 *even, real4 *odd)
{
    real2 a = ((const real2 *)from[0])[k], b = ((const real2 *)from[1])[k];
    real2 c = ((const real2 *)from[2])[k], d = ((const real2 *)from[3])[k];
    *even = (real4){ { a[0], b[0] }, { c[0], d[0] } };
    *odd = (real4){ { a[1], b[1] }, { c[1], d[1] } };
}

static inline void real4_scatter2(real *const to[REAL4], int k, real4 even,
                                  real4 odd)
{
    ((real2 *)to[0])[k] = (real2){ even.lo[0], odd.lo[0] };
    ((real2 *)to[1])[k] = (real2){ even.lo[1], odd.lo[1] };
    ((real2 *)to[2])[k] = (real2){ even.hi[0], odd.hi[0] };
    ((real2 *)to[3])[k] = (real2){ even.hi[1], odd.hi[1] };
}
#endif
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

static inline void real4_set3(real4 to[3], int l, vec3 a)
{
    real4_set(&to[0], l, a.x);
    real4_set(&to[1], l, a.y);
    real4_set(&to[2], l, a.z);
}
//<

//> real4-end
//>   The header ends.
#endif
//<
