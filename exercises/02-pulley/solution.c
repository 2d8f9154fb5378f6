// solution.c - a condition on the sum of two distances.

#include "pulley.h"

#include <assert.h>
#include <math.h>

// Moving a by -k w_a n_a and b by -k w_b ratio n_b, n the unit vectors away
// from the wheels, takes k (w_a + ratio^2 w_b) from C.  An end at its wheel has
// n = 0, and no part in it.
static int pull_both(particle *a, particle *b, real C, vec3 grad_a, vec3 grad_b)
{
    real bottom = a->inverse_mass * vec3_length_squared(grad_a)
                + b->inverse_mass * vec3_length_squared(grad_b);
    if (!(bottom > 0)) return 0;

    real k = C / bottom;
    a->position = vec3_add_scaled(a->position, -k * a->inverse_mass, grad_a);
    b->position = vec3_add_scaled(b->position, -k * b->inverse_mass, grad_b);
    return 1;
}

stick_result pulley_relax(pulley r, particle *p)
{
    assert(r.a != r.b && r.ratio > 0);
    particle *a = &p[r.a], *b = &p[r.b];
    vec3 along_a = vec3_sub(a->position, r.wheel_a);
    vec3 along_b = vec3_sub(b->position, r.wheel_b);
    real C = vec3_length(along_a) + r.ratio * vec3_length(along_b) - r.length;
    if (C <= 0) return (stick_result){ 0, 0 };
    if (!(C < HUGE_VAL)) return (stick_result){ HUGE_VAL, 0 };

    vec3 grad_a = vec3_unit(along_a);
    vec3 grad_b = vec3_scale(r.ratio, vec3_unit(along_b));
    return (stick_result){ C, pull_both(a, b, C, grad_a, grad_b) };
}
