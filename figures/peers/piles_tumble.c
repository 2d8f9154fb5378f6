// piles_tumble.c - the piles in this library.

#include "piles.h"
#include "step.h"

#include <stdlib.h>

typedef struct {
    world world;
    shape shape;
} room;

static placement placement_of(const start *s)
{
    return (placement){ .position = s->at.middle, .x = s->at.x, .y = s->at.y,
                        .z = s->at.z, .velocity = s->velocity,
                        .spin = s->spin };
}

static status make_shape(shape *s, const pile *p)
{
    real side = 2 * p->half;
    return shape_box(s, vec3_make(side, side, side), 1);
}

static void *begin(const pile *p, int substeps, bool may_sleep)
{
    room *r = calloc(1, sizeof *r);
    world_options o = world_options_default();
    if (!r) give_up("there is no memory for a world");
    o.dt = p->dt;
    o.friction = p->friction;
    o.substeps = o.most_substeps = substeps;
    if (!may_sleep) o.sleep_speed = 0;
    status done = make_shape(&r->shape, p);
    if (done.ok) done = world_init(&r->world, o);
    for (int k = 0; k < p->walls && done.ok; k++)
        done = world_add_plane(&r->world, p->normal[k], p->offset[k]);
    for (int k = 0; k < p->boxes && done.ok; k++)
        done = world_add(&r->world, &r->shape, placement_of(&p->box[k]), NULL);
    if (!done.ok) give_up(done.why);
    return r;
}

static void step(void *self)
{
    world_step(&((room *)self)->world);
}

// From the corners.  At rest they stand evenly around the middle: the sum of
// c c^T is a multiple of 1, so that of c_x c' points along the axis x has now.
static pose look(const void *self, int box)
{
    const room *r = self;
    int n = r->shape.particles;
    vec3 at[PILE_CORNERS], middle = { 0, 0, 0 }, zero = { 0, 0, 0 };
    pose p = { zero, zero, zero, zero };
    world_vertices(&r->world, &r->world.body[box], at);
    for (int k = 0; k < n; k++) middle = vec3_add_scaled(middle, 1.0 / n, at[k]);
    for (int k = 0; k < n; k++) {
        vec3 arm = vec3_sub(at[k], middle), own = r->shape.at[k];
        p.x = vec3_add_scaled(p.x, own.x, arm);
        p.y = vec3_add_scaled(p.y, own.y, arm);
        p.z = vec3_add_scaled(p.z, own.z, arm);
    }
    return (pose){ middle, vec3_unit(p.x), vec3_unit(p.y), vec3_unit(p.z) };
}

static int asleep(const void *self)
{
    return ((const room *)self)->world.report.asleep;
}

static void end(void *self)
{
    room *r = self;
    world_free(&r->world);
    shape_free(&r->shape);
    free(r);
}

const mover mover_tumble = { "tumble", begin, step, look, asleep, end };
