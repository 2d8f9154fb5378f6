// piles_tumble.c - the piles in this library.

#include "piles.h"
#include "step.h"

#include <stdlib.h>

typedef struct {
    world world;
    shape cube;
} room;

static placement placement_of(const start *s)
{
    return (placement){ .position = s->at.middle, .x = s->at.x, .y = s->at.y,
                        .z = s->at.z, .velocity = s->velocity,
                        .spin = s->spin };
}

static void *begin(const pile *p, int substeps, bool may_sleep)
{
    room *r = calloc(1, sizeof *r);
    world_options o = world_options_default();
    vec3 sides = { 2 * p->half, 2 * p->half, 2 * p->half };
    if (!r) give_up("there is no memory for a world");
    o.dt = p->dt;
    o.friction = p->friction;
    o.substeps = substeps;
    if (!may_sleep) o.sleep_speed = 0;
    status done = shape_box(&r->cube, sides, 1);
    if (done.ok) done = world_init(&r->world, o);
    for (int k = 0; k < p->walls && done.ok; k++)
        done = world_add_plane(&r->world, p->normal[k], p->offset[k]);
    for (int k = 0; k < p->boxes && done.ok; k++)
        done = world_add(&r->world, &r->cube, placement_of(&p->box[k]), NULL);
    if (!done.ok) give_up(done.why);
    return r;
}

static void step(void *self)
{
    world_step(&((room *)self)->world);
}

// From the corners: corner k stands at +x if bit 0 of k is set, and so on.
static pose look(const void *self, int box)
{
    const world *w = &((const room *)self)->world;
    vec3 at[8], middle = { 0, 0, 0 };
    world_vertices(w, &w->body[box], at);
    for (int k = 0; k < 8; k++) middle = vec3_add_scaled(middle, 0.125, at[k]);
    return (pose){ middle, vec3_unit(vec3_sub(at[1], at[0])),
                   vec3_unit(vec3_sub(at[2], at[0])),
                   vec3_unit(vec3_sub(at[4], at[0])) };
}

static int asleep(const void *self)
{
    return ((const room *)self)->world.report.asleep;
}

static void end(void *self)
{
    room *r = self;
    world_free(&r->world);
    shape_free(&r->cube);
    free(r);
}

const mover mover_tumble = { "tumble", begin, step, look, asleep, end };
