// plane.c - see plane.h.

#include "plane.h"

vec3 plane_turned(vec3 d, real t)
{
    real c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
    return vec3_make(c * d.x - s * d.y, s * d.x + c * d.y, 0);
}

// Lambert's fraction: tan x = x / (1 - xx / (3 - xx / (5 - ...))).
real plane_tangent(real degrees)
{
    real x = degrees * 3.14159265358979 / 360, below = 15;
    for (int k = 13; k > 0; k -= 2) below = k - x * x / below;
    return x / below;
}

vec3 plane_middle(const vec3 *at, int n)
{
    vec3 sum = { 0, 0, 0 };
    for (int i = 0; i < n; i++) sum = vec3_add_scaled(sum, 1.0 / n, at[i]);
    return sum;
}

void plane_place(const vec3 *rest, int n, vec3 to, real t, vec3 *at)
{
    vec3 middle = plane_middle(rest, n);
    for (int i = 0; i < n; i++)
        at[i] = vec3_add(vec3_add(middle, to), plane_turned(vec3_sub(rest[i], middle), t));
}

hull plane_prism(const vec3 *flat, int n, vec3 *at)
{
    const real half = 20;
    for (int i = 0; i < 2 * n; i++)
        at[i] = vec3_make(flat[i % n].x, flat[i % n].y, i < n ? half : -half);
    return (hull){ at, 2 * n };
}

// Asks for the support all the way round: half by half, by tangents.
int plane_difference(hull a, hull b, vec3 *at, int most)
{
    enum { HALF_ROUND = 1800 };
    int n = 0;
    for (int k = 0; k < 2 * HALF_ROUND && n < most; k++) {
        real t = 2.0 * (k % HALF_ROUND) / HALF_ROUND - 1;
        vec3 c = hull_support(a, b, plane_turned(vec3_make(k < HALF_ROUND ? 1 : -1, 0, 0), t)).at;
        if (n == 0 || vec3_distance(c, at[n - 1]) > 0) at[n++] = c;
    }
    // The round ends with the corner that it began with.
    return n > 1 && !(vec3_distance(at[0], at[n - 1]) > 0) ? n - 1 : n;
}
