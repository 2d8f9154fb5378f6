// solution.c - long division, and what it leaves.

#include "angle.h"

// What is left of b when a has been taken from it, part by part.  A power of 2
// times a, and the difference of what is nearly equal, are exact.
static vec3 remainder_of(vec3 b, vec3 a)
{
    real square = vec3_dot(a, a), part = 1;
    while (vec3_dot(b, a) > part * square) part *= 2;
    for (real least = 0x1p-60 * part; part > least; part /= 2)
        if (vec3_dot(b, a) > part * square) b = vec3_add_scaled(b, -part, a);
    return b;
}

// With c = |a| |b| cos t and s = |a| |b| sin t the tangent is
// s / (|a| |b| + c), and (|a| |b| - c) / s as well: the one that adds is good.
real half_tangent(vec3 a, vec3 b)
{
    real length_a = vec3_length(a), length_b = vec3_length(b);
    if (!(length_a > 0) || !(length_b > 0)) return 0;
    if (length_a > length_b) return half_tangent(b, a);
    real c = vec3_dot(a, b), both = length_a * length_b;
    vec3 rest = remainder_of(vec3_scale(c < 0 ? -1 : 1, b), a);
    real s = vec3_length(vec3_cross(a, rest));
    if (c >= 0) return s / (both + c);
    return s > 0 ? (both - c) / s : HUGE_VAL;
}
