// solution.c - four looks ahead, and their mean.

#include "rk4.h"

// m, had it gone on for dt as `rate` says: rate.position is a velocity (m/s),
// and rate.velocity an acceleration (m/s^2).
static motion go_on(motion m, motion rate, real dt)
{
    m.position = vec3_add_scaled(m.position, dt, rate.position);
    m.velocity = vec3_add_scaled(m.velocity, dt, rate.velocity);
    return m;
}

// How fast a motion changes: its position by its velocity, its velocity by a.
static motion rate_of(motion m, acceleration *a, const void *about, real t)
{
    return (motion){ m.velocity, a(m, t, about) };
}

// The rate at the beginning; twice in the middle, each time as far as the rate
// before leads; at the end.  Their mean, with the weights 1, 2, 2, 1, is
// Simpson's rule where the rate depends on time alone.
motion rk4_step(motion m, acceleration *a, const void *about, real t, real dt)
{
    motion k1 = rate_of(m, a, about, t);
    motion k2 = rate_of(go_on(m, k1, dt / 2), a, about, t + dt / 2);
    motion k3 = rate_of(go_on(m, k2, dt / 2), a, about, t + dt / 2);
    motion k4 = rate_of(go_on(m, k3, dt), a, about, t + dt);
    m = go_on(m, k1, dt / 6);
    m = go_on(m, k2, dt / 3);
    m = go_on(m, k3, dt / 3);
    return go_on(m, k4, dt / 6);
}
