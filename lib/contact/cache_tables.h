//> cache-head
//>   This is what the cache reads of bodies.
// cache_tables.h - what is read of bodies to find contacts, and what is kept.
//
// Paper: section 6.1, where contacts do not outlive a step.  Book: chapter 18.
// Units: metres, kilograms, seconds.  Normals point from B to A.

#pragma once

#include "collide.h"
#include "pairs.h"
#include "placed.h"
#include "solver.h"

// m, its radius; of what is thin, twice as much as it is thick.
static inline real cache_width(const body *b, real radius)
{
    return b->inner > 0 ? real_min(radius, 4 * b->inner) : radius;
}

// Coordinates, in the frame of the four particles, of a point of a feature.
static inline vec3 cache_local(const rigid4 *r, const feature_point *f)
{
    vec3 sum = { 0, 0, 0 };
    for (int k = 0; k < f->count; k++)
        sum = vec3_add_scaled(sum, f->weight[k], r->local[f->vertex[k]]);
    return sum;
}

typedef struct {
    const body *body;           // [bodies]
    const solver_body *now;     // [bodies]
    const rigid_frame *asked;   // [bodies] where it is asked: there, but turned
                                // as it will be in the middle of the time
    const prediction *ahead;    // [bodies]
    const char *moves;          // [bodies]
    const int *awake;           // [awakes] what moves, or has come, by number
    int awakes;
    const pair_list *list;
    bool is_new_list;
    const plane *plane;         // those that the list names
    real stay;          // of a body's radius; see world_options
    bool has_parts;     // of surfaces: a body may lie on very many
    bool has_pieces;    // some bodies ride on others
    tasks run;
} cache_frame;
//<

//> cache-struct
//>   And this is what it keeps of a pair: the last answer, and until when it is
//>   good.
// What is kept of a pair, or of a body and a plane: small, for it is read in
// every frame.
typedef struct {
    int  key[2];        // two bodies, or a body and a plane (contact_with_plane)
    int  entry;         // in the table of contacts; -1: none
    int  seen[2];       // of which placing of each body it was found; -1: it is
                        // good for this frame only
    bool is_asked, is_active;   // in this frame
    bool is_merged;     // a neighbour's contact has its points
    bool passes;        // one flies past the other, or is held by a third before
                        // it comes there, unless it is turned aside
    signed char count;  // points
    real margin;        // m, everything nearer was found
    real near;          // m, its least gap, and how far both bodies had gone by
                        // then: it closes when they have gone so far
} cache_pair;

typedef struct {
    query_cache carried;
    int next;           // the next free entry
    contact contact;
} cache_entry;

// What is kept of the pairs of a list.
typedef struct {
    cache_pair *pair;   // [count], as in the list
    int count, capacity;
    cache_pair *spare;          // [spare_capacity] for the next list
    int spare_capacity;
} cache_list;

typedef struct {
    cache_list pairs;           // of those that are listed,
    cache_list still;           // and of those of which nothing is loose
    cache_entry *entry;
    contact     *was;           // [entries] what those on a floor carried before
                                // they were asked again in this frame
    int entries, entry_capacity, free_entry;

    int room;                   // bodies
    rigid_frame *placed;        // [room] where it was when its vertices were
                                // last placed
    struct placing {
        int  number;    // how often they were placed,
        unsigned since; // at last in this update
        int  first;     // in vertex,
        int  vertices;  // where so many have room
        unsigned corners;       // the update in which a contact of fewer than
                        // four points carried something
        real path;      // m, how far any of its points has gone at most
        bool in_range;          // its vertices, for queries
    } *placing;         // [room]
    vec3 *vertex;       // m
    int vertices, vertex_room;

    // Whose contacts are which, see seams.h.
    int *first, *last;          // [room] in met, of what is awake
    int *met;                   // [met_capacity] numbers of pairs
    int met_capacity;

    // The contacts of this frame, and how near their points may come in it.
    contact **active;   // [actives]
    cache_pair **of;    // [actives] where they are kept
    real *reach;        // [actives] m
    int actives, active_capacity;
    unsigned updates;
    long queries;       // asked in this frame
    long found;         // contacts, ever
    int  lost;          // contacts that found no memory
    int  fast;          // contacts of bodies that meet later in the frame,
    int  passing;       // and pairs that may yet, if they are turned aside
} contact_cache;

// What the threads of an update are given.
typedef struct {
    contact_cache *c;
    const cache_frame *f;
} cache_work;

// All these tables, and for how much there is room: a saved cache keeps what is
// KEPT, so much of it.
#define CACHE_TABLES(KEPT, ROOM, c)                                           \
    KEPT(entry, (c)->entries, (c)->entry_capacity)                            \
    KEPT(vertex, (c)->vertices, (c)->vertex_room)                             \
    KEPT(placed, (c)->room, (c)->room) KEPT(placing, (c)->room, (c)->room)    \
    ROOM(was, 0, (c)->entry_capacity) ROOM(met, 0, (c)->met_capacity)         \
    ROOM(first, 0, (c)->room) ROOM(last, 0, (c)->room)                        \
    ROOM(active, 0, (c)->active_capacity) ROOM(of, 0, (c)->active_capacity)   \
    ROOM(reach, 0, (c)->active_capacity)
//<

//> cache-own
// Body b with its vertices where they were last placed.
static inline collider cache_collider(const contact_cache *c,
                                      const cache_frame *f, int b)
{
    const struct placing *p = &c->placing[b];
    return (collider){ f->body[b].shape, c->vertex + p->first, p->in_range };
}

// Where do both push that touch so?  A vertex takes its place along, while the
// face under it slides: see contact_point.  What is rounder rolls over a vertex,
// and touches below its own core.
static inline real contact_own(const touch *p, const contact *c)
{
    if (c->round_a != c->round_b) return c->round_a > c->round_b;
    return p->a.count == 1 ? 1 : p->b.count == 1 ? 0 : 0.5;
}

// Contact c, of whose pieces the first is a body, is what was found.  An answer
// names features of the two shapes: as a contact they are points of each body, in
// coordinates of its four particles.
static inline void cache_take(contact *c, const manifold *m,
                              const cache_frame *f, bool is_ahead)
{
    const rigid4 *a = f->body[c->piece_a].rigid;
    const rigid4 *b = c->piece_b < 0 ? NULL : f->body[c->piece_b].rigid;
    c->count = m->count;
    c->is_ahead = is_ahead;
    c->is_floor = false;
    c->normal = m->normal;
    c->round_a = m->round_a;
    c->round_b = m->round_b;
    for (int k = 0; k < m->count; k++)
        c->point[k] = (contact_point){
            .local_a = cache_local(a, &m->point[k].a),
            .local_b = b ? cache_local(b, &m->point[k].b) : (vec3){ 0, 0, 0 },
            .offset = c->round_a + c->round_b,
            .own = b ? contact_own(&m->point[k], c) : 1 };
}
//<
