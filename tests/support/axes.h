// axes.h - axes of any direction, for bodies that stand askew.

#ifndef TUMBLE_TEST_AXES_H
#define TUMBLE_TEST_AXES_H

#include "random.h"

static unsigned long long seed;

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
    axes f = axes_up(random_vec3(&seed, 1));
    real by = random_real(&seed) * 3, c = cos(by), s = sin(by);
    vec3 x = vec3_add(vec3_scale(c, f.x), vec3_scale(s, f.z));
    return (axes){ x, f.y, vec3_cross(x, f.y) };
}

static inline vec3 turned(axes f, vec3 r)
{
    return vec3_add(vec3_scale(r.x, f.x),
           vec3_add(vec3_scale(r.y, f.y), vec3_scale(r.z, f.z)));
}

#endif
