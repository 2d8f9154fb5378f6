// stage.h - a world, to be filled and looked at, for the tests that need one.
//
// Needs check.h before it.  A test's own bodies and frames are its own.

#ifndef TUMBLE_STAGE_H
#define TUMBLE_STAGE_H

#include "random.h"
#include "expect.h"
#include "probe.h"
#include "world.h"

static const vec3 ZERO = { 0, 0, 0 }, UP = { 0, 1, 0 };

static world w;

static inline void begin(world_options o)
{
    world_free(&w);
    status done = world_init(&w, o);
    ck_assert_msg(done.ok, "%s", done.why);
}

static unsigned long long seed = 3;

static inline int add(const shape *s, placement where)
{
    int number;
    status done = world_add(&w, s, where, &number);
    ck_assert_msg(done.ok, "%s", done.why);
    return number;
}

static inline int add_at(const shape *s, real x, real y, real z)
{
    return add(s, placement_at(vec3_make(x, y, z)));
}

static inline int add_nailed(const shape *s, real x, real y, real z)
{
    placement p = placement_at(vec3_make(x, y, z));
    p.is_static = 1;
    return add(s, p);
}

static inline int add_thrown(const shape *s, vec3 at, vec3 velocity, vec3 spin)
{
    placement p = placement_at(at);
    p.velocity = velocity;
    p.spin = spin;
    return add(s, p);
}

static inline placement anywhere(real far, real fast, real quick)
{
    placement p = placement_at(random_vec3(&seed, far));
    p.x = random_direction(&seed);
    p.y = vec3_unit(vec3_cross(p.x, random_direction(&seed)));
    p.z = vec3_cross(p.x, p.y);
    p.velocity = random_vec3(&seed, fast);
    p.spin = random_vec3(&seed, quick);
    return p;
}

static inline void add_floor(void)
{
    ck_assert(world_add_plane(&w, UP, 0).ok);
}

static inline particle *particle_of(int b, int i)
{
    return &w.pool.at[w.body[b].first + i];
}

// As the step begins a frame.
static inline void begin_frame(void)
{
    w.report = (step_report){ .substeps = w.options.substeps };
    probe_begin_sleep(&w);
}

enum { MOST_VERTICES = 100 };

// Where vertex i of body b is.
static inline vec3 vertex_of(int b, int i)
{
    static vec3 at[MOST_VERTICES];
    ck_assert_int_le(w.body[b].shape->particles, MOST_VERTICES);
    world_vertices(&w, &w.body[b], at);
    return at[i];
}

#endif
