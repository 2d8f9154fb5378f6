//> verlet-head
// verlet.h - particles, and the step that moves them.
//
// Paper: section 3.1, Eq. 1.  Book: chapter 1.
// Units: metres, seconds, kilograms, newtons.  Frame: the world's.

#pragma once

#include "status.h"
#include "vec3.h"

// A point mass.  It stores no velocity: it remembers where it was.
typedef struct {
    vec3 position;      // m, at time t
    vec3 previous;      // m, at time t - dt
    real inverse_mass;  // 1/kg; 0: pinned, nothing moves it
} particle;

// All particles of a world, in one growing array.
typedef struct {
    particle *at;
    int count, capacity;
} particle_pool;
//<

//> pool-declare
void   pool_init(particle_pool *pool);                 // empty, owns nothing
// Makes room for capacity particles.  Fails, and leaves the pool as it was, if
// they need more than INT_MAX bytes or if memory is refused.
status pool_reserve(particle_pool *pool, int capacity);
// Appends p and returns its index.  Requires: count < capacity.
int    pool_add(particle_pool *pool, particle p);
void   pool_free(particle_pool *pool);
//<

//> verlet-declare
// A particle at x0 (m) that moves with v0 (m/s), ready for its first step of
// dt (s) under the acceleration a0 (m/s^2) at the start.  Its previous position
// is x0 - v0 dt + a0 dt^2 / 2, which makes the motion of order 2; x0 - v0 dt
// alone would make it of order 1 for good.  inverse_mass is in 1/kg; a pinned
// particle (0) gets previous = x0.
particle particle_start(vec3 x0, vec3 v0, vec3 a0, real inverse_mass, real dt);

// One step of dt for n particles: x' = 2 x - x_previous + a dt^2, with a = gravity
// (m/s^2) + inverse_mass * force (N).  force holds n vectors, or is NULL for none.
// Pinned particles stay, with previous = position. Paper: Eq. 1.
void verlet_step(particle *p, int n, vec3 gravity, const vec3 *force, real dt);

// The velocity (m/s) at time t, of order 2.  The mean over the last step,
// (x - x_previous) / dt, is the velocity half a step ago; the acceleration
// (m/s^2) at time t carries it on by dt / 2.  Zero for a pinned particle.
vec3 verlet_velocity(const particle *p, vec3 acceleration, real dt);
//<
