// axes.h - numbers that look random, and bodies that stand askew: which is here
// and which there does not matter, but it is the same on every machine.

#ifndef TUMBLE_TEST_AXES_H
#define TUMBLE_TEST_AXES_H

#include "vec3.h"

// Numbers in [-1, 1) from a linear congruence; the same on every machine.
static unsigned long long seed;

static inline real any(void)
{
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return (real)(seed >> 11) / 4503599627370496.0 - 1;
}

static inline vec3 any_vec3(real size)
{
    real x = any(), y = any();
    return vec3_scale(size, vec3_make(x, y, any()));
}

typedef struct {
    vec3 x, y, z;
} axes;

static const axes UPRIGHT = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };

// Axes of which y is this direction.
static inline axes axes_up(vec3 y)
{
    axes f = { .y = vec3_unit(y) };
    vec3 other = fabs(f.y.x) < 0.7 ? vec3_make(1, 0, 0) : vec3_make(0, 0, 1);
    f.x = vec3_unit(vec3_cross(other, f.y));
    f.z = vec3_cross(f.x, f.y);
    return f;
}

static inline axes any_axes(void)
{
    axes f = axes_up(any_vec3(1));
    real by = any() * 3, c = cos(by), s = sin(by);
    vec3 x = vec3_add(vec3_scale(c, f.x), vec3_scale(s, f.z));
    return (axes){ x, f.y, vec3_cross(x, f.y) };
}

static inline vec3 turned(axes f, vec3 r)
{
    return vec3_add(vec3_scale(r.x, f.x),
           vec3_add(vec3_scale(r.y, f.y), vec3_scale(r.z, f.z)));
}

#endif
