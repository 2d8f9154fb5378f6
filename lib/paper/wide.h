//> wide-head
// wide.h - numbers of 106 bits, where the 53 of a double are not enough: each is
// the sum of two doubles, of which the second is the first one's rounding error.
//
// Knuth's sum and Dekker's product.  Book: chapter 4.  Only + - * /, so these
// too are the same on every machine.

#pragma once

#include "vec3.h"

typedef struct { real high, low; } wide;        // high is their rounded sum
typedef struct { wide x, y, z; } wide3;
//<

//> wide-numbers
// The exact sum of two doubles.
static inline wide wide_sum(real a, real b)
{
    real s = a + b, t = s - a;
    return (wide){ s, (a - (s - t)) + (b - t) };
}

// The exact product of two doubles, up to 1e290: of halves of 26 bits.
static inline wide wide_product(real a, real b)
{
    real p = a * b, c = 134217729 * a, d = 134217729 * b;   // 2^27 + 1
    real ah = c - (c - a), al = a - ah, bh = d - (d - b), bl = b - bh;
    return (wide){ p, ((ah * bh - p) + ah * bl + al * bh) + al * bl };
}

static inline wide wide_add(wide a, wide b)
{
    wide high = wide_sum(a.high, b.high), low = wide_sum(a.low, b.low);
    high = wide_sum(high.high, high.low + low.high);
    return wide_sum(high.high, high.low + low.low);
}

static inline wide wide_negative(wide a)
{
    return (wide){ -a.high, -a.low };
}

static inline wide wide_times(wide a, wide b)
{
    wide p = wide_product(a.high, b.high);
    return wide_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

// Three digits of a long division, each a double.
static inline wide wide_over(wide a, wide b)
{
    wide sum = { 0, 0 }, left = a;
    for (int k = 0; k < 3; k++) {
        wide digit = { left.high / b.high, 0 };
        sum = wide_add(sum, digit);
        left = wide_add(left, wide_negative(wide_times(digit, b)));
    }
    return sum;
}

static inline bool wide_less(wide a, wide b)
{
    return a.high < b.high || (a.high == b.high && a.low < b.low);
}
//<

//> wide-vectors
// a - b, exactly.
static inline wide3 wide3_between(vec3 a, vec3 b)
{
    return (wide3){ wide_sum(a.x, -b.x), wide_sum(a.y, -b.y),
                    wide_sum(a.z, -b.z) };
}

static inline wide3 wide3_add(wide3 a, wide3 b)
{
    return (wide3){ wide_add(a.x, b.x), wide_add(a.y, b.y),
                    wide_add(a.z, b.z) };
}

static inline wide3 wide3_scale(wide s, wide3 a)
{
    return (wide3){ wide_times(s, a.x), wide_times(s, a.y),
                    wide_times(s, a.z) };
}

static inline wide3 wide3_sub(wide3 a, wide3 b)
{
    return wide3_add(a, (wide3){ wide_negative(b.x), wide_negative(b.y),
                                 wide_negative(b.z) });
}

static inline wide wide3_dot(wide3 a, wide3 b)
{
    return wide_add(wide_times(a.x, b.x),
                    wide_add(wide_times(a.y, b.y), wide_times(a.z, b.z)));
}

// a * d - b * c.
static inline wide wide_minor(wide a, wide b, wide c, wide d)
{
    return wide_add(wide_times(a, d), wide_negative(wide_times(b, c)));
}

static inline wide3 wide3_cross(wide3 a, wide3 b)
{
    return (wide3){ wide_minor(a.y, a.z, b.y, b.z),
                    wide_minor(a.z, a.x, b.z, b.x),
                    wide_minor(a.x, a.y, b.x, b.y) };
}

static inline vec3 wide3_rounded(wide3 a)
{
    return (vec3){ a.x.high, a.y.high, a.z.high };
}
//<
