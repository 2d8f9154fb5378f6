//> face-save
//>   Save and load: the world and the ids that a program holds.
#include "inside.h"
#include "snapshot.h"

#include <stdlib.h>

// The things that a saved world points to are its shapes.
static const void *shape_at(const void *owner, int number)
{
    const tumble_world *w = owner;
    const shape_place *x = slots_at(&w->shapes, number);
    return x ? x->shape : NULL;
}

// If there is no memory for them, there are none.
static void slots_store(slots *x, store *s)
{
    store_table(s, &x->slot, x->count, x->capacity, sizeof *x->slot);
    store_table(s, &x->thing, x->count, x->capacity, x->size);
    if (!s->done.ok) slots_free(x);
}

// Places that are free have an address of something that is gone.
static void shapes_store(tumble_world *w, store *s)
{
    slots_store(&w->shapes, s);
    store_enter(s);
    for (int k = 0; k < w->shapes.count; k++) {
        shape_place *x = (shape_place *)(void *)w->shapes.thing + k;
        if (!slots_is_taken(&w->shapes, k)) {
            STORE_FORGET(s, x->shape);
            continue;
        }
        STORE_TABLE(s, x->shape, 1, 1);
        store_enter(s);
        if (x->shape) shape_store(x->shape, s);
        store_leave(s);
    }
    store_leave(s);
}

static void mesh_store(body_place *x, store *s)
{
    STORE_TABLE(s, x->mesh, 1, 1);
    body_mesh *m = x->mesh;
    if (!m) return;
    store_enter(s);
    STORE_TABLE(s, m->surface.point, m->surface.points, m->surface.points);
    STORE_TABLE(s, m->surface.triangle, m->surface.triangles,
                m->surface.triangles);
    STORE_TABLE(s, m->surface.deep, m->surface.triangles,
                m->surface.triangles);
    STORE_TABLE(s, m->surface.order, m->surface.prisms, m->surface.prisms);
    STORE_TABLE(s, m->surface.box, 2 * m->surface.leaves,
                2 * m->surface.leaves);
    STORE_TABLE(s, m->piece, m->surface.triangles, m->surface.triangles);
    STORE_TABLE(s, m->of, x->pieces, m->room);
    STORE_TABLE(s, m->seen, m->seens, m->seen_room);
    store_leave(s);
}

static void bodies_store(tumble_world *w, store *s)
{
    slots_store(&w->bodies, s);
    store_enter(s);
    for (int k = 0; k < w->bodies.count; k++) {
        body_place *x = (body_place *)(void *)w->bodies.thing + k;
        if (slots_is_taken(&w->bodies, k)) {
            mesh_store(x, s);
            STORE_TABLE(s, x->piece, x->pieces,
                        x->mesh ? x->mesh->room : x->pieces);
        } else {
            STORE_FORGET(s, x->piece);
            STORE_FORGET(s, x->mesh);
        }
    }
    store_leave(s);
}

// Both ways.
static void all_store(tumble_world *w, store *s)
{
    store_memory(s, w, sizeof *w);
    store_enter(s);
    shapes_store(w, s);
    bodies_store(w, s);
    slots_store(&w->joints, s);
    slots_store(&w->planes, s);
    STORE_TABLE(s, w->owner, w->world.bodies, w->owners);
    STORE_ROOM(s, w->scratch, 4 * w->most_vertices);
    STORE_TABLE(s, w->touching, w->touchings, w->touchings);
    STORE_FORGET(s, w->meets);
    STORE_FORGET(s, w->meets_context);
    STORE_TABLE(s, w->sensed, w->senses, w->senses);
    s->owner = w;
    s->thing = shape_at;
    s->things = w->shapes.count;
    world_store(&w->world, s);
    store_leave(s);
}

size_t tumble_world_save(const tumble_world *w, void *into, size_t room)
{
    if (!w) return 0;
    tumble_world all = *w;
    store s = store_to(into, room, TUMBLE_VERSION);
    all_store(&all, &s);
    return store_end(&s);
}

static tumble_world *read_world(const void *from, size_t size, status *done)
{
    store s = store_from(from, size, TUMBLE_VERSION);
    tumble_world *w = s.done.ok ? calloc(1, sizeof *w) : NULL;
    if (!w) store_fail(&s, status_out_of_memory());
    if (w) all_store(w, &s);
    *done = s.done;
    if (s.done.ok && w->first_mesh > 0) inside_watch_meshes(w);
    if (s.done.ok) return w;
    tumble_world_free(w);
    return NULL;
}

tumble_world *tumble_world_load(const void *from, size_t size)
{
    status done;
    tumble_world *w = read_world(from, size, &done);
    tumble_world_forget_failure(NULL);
    inside_not_made(done);
    return w;
}
//<

//> face-restore
//>   To take a move back, or to begin an episode again, a program wants the saved state
//>   where its world is. The two change places, and the old one goes.
bool tumble_world_restore(tumble_world *w, const void *from, size_t size)
{
    status done;
    if (!inside_is_world(w)) return false;
    tumble_world *saved = read_world(from, size, &done);
    if (!inside_is_ok(w, done)) return false;
    tumble_world old = *w;
    world_host *host = &saved->world.options.host;
    host->run = old.world.options.host.run;
    host->meets = old.world.options.host.meets;
    host->chooser = w;
    saved->meets = old.meets;
    saved->meets_context = old.meets_context;
    *w = *saved;
    *saved = old;
    tumble_world_free(saved);
    if (w->first_mesh > 0) inside_watch_meshes(w);
    return true;
}
//<
