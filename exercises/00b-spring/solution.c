// solution.c - two weights on a spring.

#include "spring.h"

#include <assert.h>

static const real PI = 3.14159265358979323846;

// a accelerates by w_a F, b by -w_b F, so their distance by -(w_a + w_b) F.
real spring_omega(real stiffness, real inverse_a, real inverse_b)
{
    return sqrt(stiffness * (inverse_a + inverse_b));
}

void spring_step(weight *a, weight *b, real stiffness, real rest, real dt)
{
    assert(dt > 0);
    vec3 along = vec3_sub(b->position, a->position);
    real length = vec3_length(along);
    if (length > 0) {
        vec3 impulse = vec3_scale(dt * stiffness * (length - rest) / length, along);
        a->velocity = vec3_add_scaled(a->velocity, a->inverse_mass, impulse);
        b->velocity = vec3_add_scaled(b->velocity, -b->inverse_mass, impulse);
    }
    if (a->inverse_mass > 0) a->position = vec3_add_scaled(a->position, dt, a->velocity);
    if (b->inverse_mass > 0) b->position = vec3_add_scaled(b->position, dt, b->velocity);
}

// omega / (2 pi) periods a second; no fraction of a step can be made.
int steps_a_second(real omega, int per_period)
{
    real steps = ceil(per_period * omega / (2 * PI));
    return steps < 1 ? 1 : (int)steps;
}
