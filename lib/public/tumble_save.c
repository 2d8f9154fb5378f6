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
    if (s->is_reading && !s->done.ok) slots_free(x);
}

// Places that are free have an address of something that is gone.
static void shape_places_store(tumble_world *w, store *s)
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
#define WHOLE(table, n) STORE_TABLE(s, m->surface.table, n, n);
    SURFACE_TABLES(WHOLE, &m->surface)
#undef WHOLE
    STORE_TABLE(s, m->piece, m->surface.triangles, m->surface.triangles);
    STORE_TABLE(s, m->of, x->pieces, m->room);
    STORE_TABLE(s, m->seen, m->seens, m->seen_room);
    store_leave(s);
}

static void body_places_store(tumble_world *w, store *s)
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
    shape_places_store(w, s);
    body_places_store(w, s);
    slots_store(&w->joints, s);
    slots_store(&w->planes, s);
    STORE_TABLE(s, w->owner, w->world.bodies, w->owners);
    STORE_ROOM(s, w->scratch, 4 * w->most_vertices);
    STORE_TABLE(s, w->touching, w->touchings, w->touchings);
    STORE_FORGET(s, w->meets);
    STORE_FORGET(s, w->meets_context);
    STORE_TABLE(s, w->sensed, w->senses, w->senses);
    STORE_FORGET(s, w->spare);
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

// Into a world that owns nothing, in memory of the list; NULL: in memory of its own.
static status read_world(tumble_world *w, const void *from, size_t size,
                         store_spare *spare)
{
    store s = store_from(from, size, TUMBLE_VERSION);
    *w = (tumble_world){ .first_mesh = 0 };
    s.spare = spare;
    if (!s.done.ok) return s.done;
    all_store(w, &s);
    if (!s.done.ok) inside_free(w);
    return s.done;
}

tumble_world *tumble_world_load(const void *from, size_t size)
{
    tumble_world *w = malloc(sizeof *w);
    status done = w ? read_world(w, from, size, NULL) : status_out_of_memory();
    tumble_world_forget_failure(NULL);
    inside_not_made(done);
    if (!done.ok) {
        free(w);
        return NULL;
    }
    if (w->first_mesh > 0) inside_watch_meshes(w);
    return w;
}
//<

//> face-restore
//>   To take a move back, or to begin an episode again, a program wants the saved state
//>   where its world is. It is read beside the world, and takes its place if all of it
//>   could be read. What the world was in is kept for the next time: so from the second
//>   time on no memory is asked for.
static void take_host(tumble_world *w, const tumble_world *old)
{
    world_host *host = &w->world.options.host;
    host->run = old->world.options.host.run;
    host->meets = old->world.options.host.meets;
    w->meets = old->meets;
    w->meets_context = old->meets_context;
}

// Its tables, for the next one; or, if there is no memory for the list, none.
static void keep_tables(tumble_world *old, store_spare *spare)
{
    store s = store_list(spare);
    all_store(old, &s);
    if (!s.done.ok) inside_free(old);
}

bool tumble_world_restore(tumble_world *w, const void *from, size_t size)
{
    tumble_world saved, old;
    if (!inside_is_world(w)) return false;
    status done = read_world(&saved, from, size, &w->spare);
    if (!done.ok) store_clear(&w->spare);
    if (!inside_is_ok(w, done)) return false;
    old = *w;
    *w = saved;
    take_host(w, &old);
    w->world.options.host.chooser = w;
    w->spare = old.spare;
    old.spare = (store_spare){ .count = 0 };
    store_clear(&w->spare);
    keep_tables(&old, &w->spare);
    if (w->first_mesh > 0) inside_watch_meshes(w);
    return true;
}
//<
