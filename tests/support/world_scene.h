// world_scene.h - the engine's world from a scene of chapter 09, and the
// paper's experiments, for figures and tests.
//
// Paper: section 7, Figure 8.  Book: chapter 18.

#ifndef TUMBLE_WORLD_SCENE_H
#define TUMBLE_WORLD_SCENE_H

#include "experiments.h"
#include "measure.h"

#include <assert.h>
#include <stddef.h>

// Body k stands where the scene's own list of positions says, at rest.
static inline void move_to_start(world *w, int k, const vec3 *start)
{
    const body *b = &w->body[k];
    for (int i = 0; i < b->shape->particles; i++) {
        particle *p = &w->pool.at[b->first + i];
        p->position = p->previous = start[i];
    }
}

// Fills a new world with what the scene describes, ready to step.  Body k of
// the world is body k of the scene, whose shapes must outlive the world.
// Fails with a sentence (an option out of range, more planes than there is room
// for, memory), leaving *w empty.
static inline status world_of_scene(world *w, const scene *s, world_options how)
{
    status done = world_init(w, how);
    for (int k = 0; k < s->planes && done.ok; k++)
        done = world_add_plane(w, s->plane[k].normal, s->plane[k].offset);
    for (int k = 0; k < s->bodies && done.ok; k++) {
        done = world_add(w, scene_shape(s, k), s->body[k].where, NULL);
        if (done.ok && s->body[k].start) move_to_start(w, k, s->body[k].start);
    }
    for (int k = 0; k < s->pins && done.ok; k++) {
        int b = s->pin[k].body;
        if (w->body[b].rigid)
            done = status_fail("body %d is rigid, and cannot be pinned", b);
        else
            world_pin(w, b, s->pin[k].particle);
    }
    if (!done.ok) world_free(w);
    return done;
}

// One of the paper's experiments, and a world that runs it.
typedef struct {
    scene_kind kind;
    scene scene;
    struct world world;
    real size;          // m, the scene's
    real body_radius;   // m, of a thrown body; what penetration is measured by
} world_scene;

// world_options_default, with the substeps that this scene needs; a cloth of so
// many particles along a side.
static inline world_options world_scene_options(scene_kind kind, int cloth)
{
    world_options o = world_options_default();
    if (kind == SCENE_ROOM) return o;
    // The finer a cloth is, the more of its spacings does it go in a substep;
    // and columns and rows, solved in turn, need more rounds.  In small steps
    // the lines may be solved along the links as they lie, and the diagonals
    // do with the cheaper root.
    // Layers that lie on each other take some more.
    // No scene has a cloth of more than 512 a side.
    o.substeps = 2 + int_min(int_max(cloth, 0), 512) / 100;
    o.iterations = 12;
    o.relax.gradient = GRADIENT_NEW;
    o.relax.root = ROOT_APPROXIMATE;
    return o;
}

static inline void world_scene_free(world_scene *s)
{
    world_free(&s->world);
    scene_free(&s->scene);
    *s = (world_scene){ .size = 0 };
}

// Builds the scene, ready to step.  Fails as scene_build and world_of_scene do,
// leaving *s empty.
static inline status world_scene_build(world_scene *s, scene_kind kind,
                                       scene_options what,
                                       world_options how)
{
    assert(kind >= 0 && kind < SCENES);
    *s = (world_scene){ .kind = kind };
    status done = scene_build(&s->scene, kind, what);
    if (done.ok) done = world_of_scene(&s->world, &s->scene, how);
    s->size = s->scene.size;
    if (kind == SCENE_ROOM) s->body_radius = SCENE_BODY_RADIUS;
    if (!done.ok) world_scene_free(s);
    return done;
}

#endif
