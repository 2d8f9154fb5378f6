// solution.c - moment of inertia, angular momentum, and who pays for a faster turn.

#include "spin.h"

#include <assert.h>

// |axis x position| is the distance from the axis.
real inertia(const point *p, int n, vec3 axis)
{
    real sum = 0;
    for (int i = 0; i < n; i++)
        sum += p[i].mass * vec3_length_squared(vec3_cross(axis, p[i].position));
    return sum;
}

vec3 angular_momentum(const point *p, int n)
{
    vec3 sum = { 0, 0, 0 };
    for (int i = 0; i < n; i++)
        sum = vec3_add_scaled(sum, p[i].mass, vec3_cross(p[i].position, p[i].velocity));
    return sum;
}

// The mean of x^2 between -a/2 and a/2 is a^2 / 12, that of y^2 is b^2 / 12.
real box_inertia(real mass, real a, real b)
{
    return mass * (a * a + b * b) / 12;
}

static real energy(const point *p, int n)
{
    real sum = 0;
    for (int i = 0; i < n; i++) sum += p[i].mass * vec3_length_squared(p[i].velocity) / 2;
    return sum;
}

real pull_in(point *p, int n, vec3 axis, real factor)
{
    assert(n >= 0 && factor > 0);
    real before = energy(p, n), kept = vec3_dot(axis, angular_momentum(p, n));
    if (inertia(p, n, axis) == 0) return 0;
    for (int i = 0; i < n; i++) {
        vec3 along = vec3_scale(vec3_dot(axis, p[i].position), axis);
        vec3 across = vec3_sub(p[i].position, along);
        p[i].position = vec3_add_scaled(along, factor, across);
    }
    real omega = kept / inertia(p, n, axis);
    for (int i = 0; i < n; i++)
        p[i].velocity = vec3_scale(omega, vec3_cross(axis, p[i].position));
    return energy(p, n) - before;
}
