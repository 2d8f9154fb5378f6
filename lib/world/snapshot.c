//> snapshot-shape
//>   A shape is its points, its faces and its sticks.
#include "snapshot.h"
#include "weight.h"

#include <stdlib.h>

void shape_store(shape *x, store *s)
{
#define WHOLE(table, count) STORE_TABLE(s, x->table, count, count);
    SHAPE_TABLES(WHOLE, x)
#undef WHOLE
}
//<

//> snapshot-pairs
//>   The list of pairs is found again for the same balls. It is sorted, so it is
//>   the same list: the order of impulses follows from it.
// Of a list of tables of x: one that is saved, and one that is only room.
#define SAVED(table, kept, room) STORE_TABLE(s, x->table, kept, room);
#define ROOM(table, kept, room) STORE_ROOM(s, x->table, room);

// The tree is planted again.
static void broad_store(broad *x, store *s)
{
    BROAD_TABLES(ROOM, x, x->room)
    STORE_FORGET(s, x->tree.things);
    STORE_FORGET(s, x->tree.leaves);
}

static void pair_list_store(pair_list *x, store *s)
{
    PAIR_TABLES(SAVED, ROOM, x)
    STORE_FORGET(s, x->looses);
    STORE_FORGET(s, x->is_due);
    x->is_due |= s->is_reading;
    broad_store(&x->broad, s);
}
//<

//> snapshot-contacts
//>   The cache keeps its contacts with their impulses, and the solver its
//>   blocks.
static void cache_store(contact_cache *x, store *s)
{
    STORE_TABLE(s, x->pairs.pair, x->pairs.count, x->pairs.capacity);
    STORE_TABLE(s, x->still.pair, x->still.count, x->still.capacity);
    CACHE_TABLES(SAVED, ROOM, x)
    STORE_FORGET(s, x->actives);
}

// Blocks outlive a frame if its contacts do.
static void solver_blocks_store(contact_solver *s, store *to)
{
    int starts = s->blocks > 0 ? s->blocks + 1 : 0;
    STORE_TABLE(to, s->start, starts, s->start_capacity);
    if (!to->done.ok) return;
    STORE_TABLE(to, s->point, starts > 0 ? s->start[s->blocks] : 0,
                s->point_capacity);
    STORE_TABLE(to, s->place, starts > 0 ? s->start[s->blocks] : 0,
                s->place_capacity);
    STORE_TABLE(to, s->block, s->blocks, s->block_capacity);
    for (int k = 0; k < s->blocks && to->done.ok; k++) {
        STORE_FORGET(to, s->block[k].point);
        STORE_FORGET(to, s->block[k].place);
        if (!to->is_reading) continue;
        s->block[k].point = s->point + s->start[k];
        s->block[k].place = s->place + s->start[k];
    }
}

static void contact_solver_store(contact_solver *s, store *to)
{
    STORE_TABLE(to, s->active, s->contacts, s->capacity);
    STORE_ROOM(to, s->order, s->capacity);
    STORE_ROOM(to, s->taken, s->room);
    STORE_ROOM(to, s->first_of, s->room);
    STORE_ROOM(to, s->next_of, s->side_capacity);
    solver_blocks_store(s, to);
}
//<

//> snapshot-joints
//>   Joints keep the impulses of the last substep, for the warm start, and the
//>   number of the last frame in which their bodies were joined.
static void linkage_store(linkage *l, store *s)
{
    STORE_TABLE(s, l->joint, l->count, l->capacity);
    STORE_TABLE(s, l->rows, l->count, l->capacity);
    STORE_ROOM(s, l->role, l->capacity);
    STORE_ROOM(s, l->step, l->capacity);
    STORE_ROOM(s, l->group, l->capacity);
    STORE_ROOM(s, l->reach, l->reach_room);
    STORE_ROOM(s, l->block, l->block_room);
    STORE_ROOM(s, l->order, l->bodies);
    STORE_ROOM(s, l->apart, l->capacity);
    STORE_TABLE(s, l->tied, l->ties, l->tie_room);
    STORE_TABLE(s, l->body, l->bodies, l->bodies);
    for (int b = 0; b < l->bodies && s->done.ok; b++)
        STORE_FORGET(s, l->body[b].end);
}
//<

//> snapshot-sleep
//>   Sleep keeps its windows, or a pile would start its count again.
static void sleep_store(sleep_state *x, store *s)
{
#define KEPT(table) STORE_TABLE(s, x->table, x->bodies, x->room);
#define ANEW(table) STORE_ZEROS(s, x->table, x->room);
    SLEEP_TABLES(KEPT, ANEW)
#undef KEPT
#undef ANEW
    STORE_FORGET(s, x->members);
    for (int k = 0; k < WINDOWS; k++)
        STORE_TABLE(s, x->start[k], x->particles, x->particle_room);
    for (int b = 0; b < x->room && s->is_reading && s->done.ok; b++) {
        x->parent[b] = b;
        if (b >= x->bodies) x->next[b] = b;
    }
}
//<

//> snapshot-soft
//>   Cloth has most tables, and most of them are only room.
static void trees_store(near_lists *l, store *s)
{
    STORE_TABLE(s, l->tree, l->bodies, l->bodies);
    if (!l->tree) l->bodies = 0;        // there are none to be freed
    store_enter(s);
    for (int b = 0; b < l->bodies; b++) {
        sphere_tree *t = &l->tree[b];
        STORE_TABLE(s, t->node, t->nodes, t->nodes);
        STORE_TABLE(s, t->leaf, t->leaves, t->leaves);
        STORE_TABLE(s, t->rest, t->leaves, t->leaves);
    }
    store_leave(s);
}

static void grid_store(grid *g, store *s)
{
    int points = g->points;
    STORE_ROOM(s, g->start, g->cells + 2);
    STORE_ROOM(s, g->cell, points + 1);
    STORE_ROOM(s, g->sorted, points + 1);
    STORE_ROOM(s, g->near, points + 1);
}

static void near_store(near_lists *l, store *s)
{
    STORE_TABLE(s, l->pair, l->pairs, l->pair_capacity);
    STORE_TABLE(s, l->point, l->points, l->point_capacity);
    STORE_TABLE(s, l->facet.at, l->facet.count, l->facet_capacity);
    STORE_ROOM(s, l->facets_before.at, l->facet_capacity);
    STORE_ROOM(s, l->ahead, l->particles);
    STORE_ROOM(s, l->at, l->particles);
    STORE_TABLE(s, l->listed, l->particles, l->particles);
    STORE_ROOM(s, l->ball, l->bodies);
    STORE_TABLE(s, l->gap, l->bodies, l->bodies);
    STORE_TABLE(s, l->candidate, l->candidates, l->bodies);
    STORE_TABLE(s, l->soft, l->softs, l->bodies);
    STORE_ROOM(s, l->is_near, l->bodies);
    STORE_ROOM(s, l->leaf, l->pair_capacity);
    STORE_ROOM(s, l->pressed, l->pair_capacity);
    grid_store(&l->grid, s);
    trees_store(l, s);
}

// A view is looked at again.
static void rigid_view_store(rigid_view *v, store *s)
{
    STORE_ROOM(s, v->corner, v->corners);
    STORE_ROOM(s, v->plane, v->faces);
    STORE_FORGET(s, v->hull);
    STORE_FORGET(s, v->frame);
    STORE_FORGET(s, v->moved);
    STORE_FORGET(s, v->of);
    if (s->is_reading) v->of = -1;
}

// What a certificate has proved is asked again in the next frame.
static void certificate_store(certificate *c, store *s)
{
    bool is_proved = c->keeps > 0 && c->keeps <= c->room;
    int n = is_proved ? c->particles : 0;
    STORE_TABLE(s, c->at[0], n, c->particles);
    STORE_ROOM(s, c->at[1], c->particles);
    STORE_TABLE(s, c->of, n, c->particles);
    STORE_TABLE(s, c->kept, is_proved ? c->keeps : 0, c->room);
    STORE_ROOM(s, c->seen, c->particles);
    STORE_ROOM(s, c->box, 2 * c->particles);
    STORE_ROOM(s, c->clash, c->particles);
    STORE_ROOM(s, c->cut, c->particles);
    STORE_ROOM(s, c->beside, c->particles);
}

static void soft_store(soft_solver *x, store *s)
{
    certificate_store(&x->proof, s);
    near_store(&x->near, s);
    rigid_view_store(&x->view, s);
    STORE_ROOM(s, x->ahead, x->bodies);
    STORE_ROOM(s, x->held, x->bodies);
    STORE_TABLE(s, x->sweeps, x->bodies, x->bodies);
    STORE_TABLE(s, x->sunk, x->bodies, x->bodies);
    STORE_ROOM(s, x->fallen, x->bodies);
    STORE_ROOM(s, x->owed, x->bodies);
    STORE_TABLE(s, x->hold, x->particles, x->particles);
    STORE_ROOM(s, x->bends, x->rows);
}
//<

//> snapshot-bodies
//>   A body points to its shape, which may be shared, so shapes are stored
//>   first and bodies name them by number.
// What is found for a shape, and memory to work on it.
static void shape_entry_store(shape_entry *e, store *s)
{
    store_pointer(s, &e->shape);
    bool is_rigid = e->shape && e->shape->kind == SHAPE_RIGID;
    if (!e->shape || is_rigid) STORE_FORGET(s, e->line);
    STORE_TABLE(s, e->rigid, 1, 1);
    if (is_rigid && e->rigid) {
        store_enter(s);
        STORE_TABLE(s, e->rigid->local, e->shape->particles,
                    e->shape->particles);
        store_leave(s);
    }
    if (!e->shape || is_rigid) return;
    store_room(s, &e->line, 1, line_scratch_size(e->shape));
    if (s->is_reading && e->line) line_scratch_init(e->line, e->shape);
}

static void shapes_store(world *w, store *s)
{
    STORE_TABLE(s, w->shape, w->shapes, w->shape_room);
    if (!w->shape) w->shapes = 0;       // there are none to be freed
    store_enter(s);
    for (int k = 0; k < w->shapes; k++) shape_entry_store(&w->shape[k], s);
    store_leave(s);
}

// A body of no shape is a place that is free.
static void find_body_shape(const world *w, body *x)
{
    if (!x->shape) x->shape = &WORLD_NOTHING;
    for (int k = 0; k < w->shapes; k++) {
        const shape_entry *e = &w->shape[k];
        if (e->bodies == 0 || e->shape != x->shape) continue;
        x->rigid = e->rigid;
        x->line = e->line;
    }
}

static void bodies_store(world *w, store *s)
{
    STORE_TABLE(s, w->body, w->bodies, w->room);
    for (int b = 0; b < w->bodies && s->done.ok; b++) {
        body *x = &w->body[b];
        store_pointer(s, &x->shape);
        STORE_FORGET(s, x->rigid);
        STORE_FORGET(s, x->line);
        if (s->is_reading) find_body_shape(w, x);
    }
    STORE_FORGET(s, w->rigid.body);
    if (s->is_reading) w->rigid.body = w->body;
}
//<

//> snapshot-world
//>   At last the world, which goes whole and then names its tables in the order
//>   of its parts.
static void rigid_store(rigid_tables *t, int bodies, int room, store *s)
{
#define KEPT(table) STORE_TABLE(s, t->table, bodies, room);
#define ZEROS(table) STORE_ZEROS(s, t->table, room);
#define FILLED(table) STORE_ROOM(s, t->table, room);
    RIGID_TABLES(KEPT, ZEROS, FILLED)
#undef KEPT
#undef ZEROS
#undef FILLED
    for (int b = 0; b < bodies && s->done.ok; b++)
        STORE_FORGET(s, t->now[b].basis.of);
    STORE_ZEROS(s, t->velocity, t->motions);
    STORE_ZEROS(s, t->moved, t->motions);
    STORE_FORGET(s, t->awakes);
    STORE_FORGET(s, t->has_noticed);
    pair_list_store(&t->pairs, s);
    cache_store(&t->cache, s);
    contact_solver_store(&t->solver, s);
}

// As if it had moved: the next frame looks where it is.
static void notice_all(world *w)
{
    for (int b = 0; b < w->bodies; b++) {
        w->rigid.moves[b] = !body_is_soft(&w->body[b]);
        world_notice(w, b);
    }
}

void world_store(world *w, store *s)
{
    int particles = w->pool.count, room = w->pool.capacity;
    STORE_FORGET(s, w->options.host);
    STORE_TABLE(s, w->pool.at, particles, room);
    STORE_TABLE(s, w->inverse_mass, particles, room);
    STORE_TABLE(s, w->owner, particles, room);
    STORE_TABLE(s, w->plane, w->planes, w->plane_room);
    STORE_TABLE(s, w->wall, w->planes, w->wall_room);
    shapes_store(w, s);
    bodies_store(w, s);
    rigid_store(&w->rigid, w->bodies, w->room, s);
    STORE_TABLE(s, w->rigid.heard, w->rigid.hears, w->rigid.heard_room);
    linkage_store(&w->joints, s);
    soft_store(&w->soft, s);
    sleep_store(&w->sleep, s);
    if (s->is_reading && s->done.ok) notice_all(w);
}
//<
