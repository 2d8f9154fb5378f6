// euler.h - Euler's two methods, for figures that compare them with Verlet's.

#ifndef TUMBLE_EULER_H
#define TUMBLE_EULER_H

#include "vec3.h"

typedef struct {
    vec3 position;      // m
    vec3 velocity;      // m/s
} euler_particle;

// One step of dt (s) under the acceleration a (m/s^2) at the position now.
// Explicit: moves with the velocity before the kick (the paper's "Euler").
static inline void euler_step_explicit(euler_particle *p, vec3 a, real dt)
{
    p->position = vec3_add_scaled(p->position, dt, p->velocity);
    p->velocity = vec3_add_scaled(p->velocity, dt, a);
}

// Symplectic: moves with the velocity after it.
static inline void euler_step_symplectic(euler_particle *p, vec3 a, real dt)
{
    p->velocity = vec3_add_scaled(p->velocity, dt, a);
    p->position = vec3_add_scaled(p->position, dt, p->velocity);
}

#endif
