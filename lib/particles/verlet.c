//> verlet-pool
// verlet.c - particles, and the step that moves them.
//
// Paper: section 3.1, Eq. 1.  Book: chapter 1.

#include "verlet.h"

#include <assert.h>
#include <limits.h>
#include <stdlib.h>

// The largest pool whose bytes an int can count.
enum { MOST_PARTICLES = INT_MAX / (int)sizeof(particle) };

void pool_init(particle_pool *pool)
{
    *pool = (particle_pool){ .at = NULL, .count = 0, .capacity = 0 };
}

status pool_reserve(particle_pool *pool, int capacity)
{
    if (capacity <= pool->capacity) return status_ok();
    if (capacity > MOST_PARTICLES)
        return status_fail("a pool of %d particles is too large: the most are "
                           "%d", capacity, MOST_PARTICLES);

    particle *at = realloc(pool->at, (size_t)capacity * sizeof *at);
    if (!at) return status_out_of_memory();
    pool->at = at;
    pool->capacity = capacity;
    return status_ok();
}

int pool_add(particle_pool *pool, particle p)
{
    assert(pool->count < pool->capacity);
    pool->at[pool->count] = p;
    return pool->count++;
}

void pool_free(particle_pool *pool)
{
    free(pool->at);
    pool_init(pool);
}
//<

//> verlet-start
// Taylor's theorem, one step back from the start:
//     x(-dt) = x0 - v0 dt + a0 dt^2 / 2 - ...
// The first step then gives 2 x0 - x(-dt) + a0 dt^2 = x0 + v0 dt + a0 dt^2 / 2,
// which is Taylor's theorem, one step forward.
particle particle_start(vec3 x0, vec3 v0, vec3 a0, real inverse_mass, real dt)
{
    assert(dt > 0 && inverse_mass >= 0);
    assert(vec3_is_finite(x0) && vec3_is_finite(v0) && vec3_is_finite(a0));

    particle p = { x0, x0, inverse_mass };
    if (inverse_mass == 0) return p;

    vec3 last_move = vec3_add_scaled(vec3_scale(dt, v0), -dt * dt / 2, a0);
    p.previous = vec3_sub(x0, last_move);
    return p;
}
//<

//> verlet-step
// Gravity accelerates all particles alike, a force the light ones more.
static vec3 acceleration_of(vec3 gravity, real inverse_mass,
                            const vec3 *force, int i)
{
    if (!force) return gravity;
    assert(vec3_is_finite(force[i]));
    return vec3_add_scaled(gravity, inverse_mass, force[i]);
}

// A pinned particle does not move.  Its previous position becomes its position,
// so that it starts from rest if it is freed.
void verlet_step(particle *p, int n, vec3 gravity, const vec3 *force, real dt)
{
    assert(n >= 0 && dt > 0 && vec3_is_finite(gravity));
    for (int i = 0; i < n; i++) {
        vec3 here = p[i].position;
        if (p[i].inverse_mass > 0) {
            vec3 a = acceleration_of(gravity, p[i].inverse_mass, force, i);
            vec3 last_move = vec3_sub(here, p[i].previous);
            vec3 move = vec3_add_scaled(last_move, dt * dt, a);
            p[i].position = vec3_add(here, move);
        }
        p[i].previous = here;
    }
}
//<

//> verlet-velocity
vec3 verlet_velocity(const particle *p, vec3 acceleration, real dt)
{
    assert(dt > 0);
    if (p->inverse_mass == 0) return (vec3){ 0, 0, 0 };

    vec3 last_move = vec3_sub(p->position, p->previous);
    return vec3_add_scaled(vec3_scale(1 / dt, last_move), dt / 2,
                           acceleration);
}
//<
