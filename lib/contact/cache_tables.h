//> cache-head
//>   This is what the cache reads of bodies.
// cache_tables.h - what finding contacts reads of the bodies, and what it keeps.
//
// Paper: section 6.1, where contacts do not outlive a step.  Book: chapter 18.
// Units: metres, kilograms, seconds.  Normals point from B to A.

#pragma once

#include "collide.h"
#include "pairs.h"
#include "placed.h"
#include "solver.h"

// m, the radius of a body; of a thin one at most twice its thickness.
static inline real cache_width(const body *b, real radius)
{
    return b->inner > 0 ? real_min(radius, 4 * b->inner) : radius;
}

// The coordinates of a feature's point in the frame of the four particles.
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
    const rigid_frame *asked;   // [bodies] the frame for queries: where it is now,
                                // turned as in the middle of the frame
    const prediction *ahead;    // [bodies]
    const char *moves;          // [bodies]
    const int *awake;           // [awakes] bodies that move or are new, by number
    int awakes;
    const pair_list *list;
    bool is_new_list;
    const plane *plane;         // the planes that the list names
    real stay;          // radii, see world_options
    bool has_parts;     // there are surfaces: a body may lie on many parts
    bool has_pieces;    // some bodies have several pieces
    tasks run;
} cache_frame;
//<

//> cache-struct
//>   And this is what it keeps of a pair: the last answer, and until when it is
//>   good.
// What is kept of a pair of bodies, or of a body and a plane.  It is small, because it
// is read in every frame; the contact stands elsewhere, if they have one.
typedef struct {
    int  key[2];        // two bodies, or a body and a plane (contact_with_plane)
    int  entry;         // its place in the table of contacts; -1: it has no points
    int  was;           // the place in `was` of what it was before this frame's
                        // query; -1: none
    int  seen[2];       // the number of the placing of each body in the query; -1:
                        // the answer is good for this frame only
    query_cache carried;
    bool is_asked, is_active;   // in this frame
    bool is_merged;     // its points belong to the contact of a neighbouring piece
    bool passes;        // one body flies past the other, or a third holds it before
                        // it gets there, unless it is turned aside
    signed char count;  // points
    real margin;        // m, the query found everything nearer than this
    real near;          // m, the least gap, and how far both bodies had moved by
                        // then: it can close when they have moved so far in all
} cache_pair;

typedef struct {
    int next;           // the next free entry
    contact contact;
} cache_entry;

// What is kept of the pairs of a list.
typedef struct {
    cache_pair *pair;   // [count], as in the list
    int count, capacity;
} cache_list;

typedef struct {
    cache_list pairs;           // of the pairs in the list,
    cache_list still;           // and of pairs that lie still
    cache_entry *entry;
    int entries, entry_capacity, free_entry;
    contact     *was;           // [olds] contacts on floors as they were before this
    int olds, was_capacity;     // frame's queries

    int room;                   // bodies
    rigid_frame *placed;        // [room] the frame in which the vertices of a body
                                // were last placed
    struct placing {
        int  number;    // how often they were placed,
        unsigned since; // and the update of the last time
        int  first;     // the first of them in `vertex`,
        int  vertices;  // and for how many there is room
        unsigned corners;       // the last update in which a contact of fewer
                        // than four points bore something
        real path;      // m, the most that a point of the body has moved in all
        bool in_range;          // hull_in_range of its vertices
    } *placing;         // [room]
    vec3 *vertex;       // m, in the world
    int vertices, vertex_room;

    // Whose contacts are which, see seams.h.
    int *first, *last;          // [room] in met, of what is awake
    int *met;                   // [met_capacity] numbers of pairs
    int met_capacity;

    // The contacts of this frame.
    contact **active;   // [actives]
    cache_pair **of;    // [actives] the pair of each
    real *reach;        // [actives] m, by which its gap may close in this frame
    int actives, active_capacity;
    unsigned updates;
    long queries;       // in this frame
    long found;         // contacts so far
    int  lost;          // contacts that found no memory
    int  fast;          // contacts of bodies that fly, and meet later in the frame
    int  passing;       // pairs that meet only if a body is turned aside
} contact_cache;

// The data of the threads of an update.
typedef struct {
    contact_cache *c;
    const cache_frame *f;
    int first;                  // the pair with which item 0 begins
} cache_work;

// The tables of a cache, with the number of elements that a saved cache keeps, and the
// room of each.
#define CACHE_TABLES(KEPT, ROOM, c)                                           \
    KEPT(entry, (c)->entries, (c)->entry_capacity)                            \
    KEPT(vertex, (c)->vertices, (c)->vertex_room)                             \
    KEPT(placed, (c)->room, (c)->room) KEPT(placing, (c)->room, (c)->room)    \
    ROOM(was, 0, (c)->was_capacity) ROOM(met, 0, (c)->met_capacity)         \
    ROOM(first, 0, (c)->room) ROOM(last, 0, (c)->room)                        \
    ROOM(active, 0, (c)->active_capacity) ROOM(of, 0, (c)->active_capacity)   \
    ROOM(reach, 0, (c)->active_capacity)
//<

//> cache-own
// Body b, for queries, with its vertices where they were last placed.
static inline collider cache_collider(const contact_cache *c,
                                      const cache_frame *f, int b)
{
    const struct placing *p = &c->placing[b];
    return (collider){ f->body[b].shape, c->vertex + p->first, p->in_range };
}

// Where does a pair push, see contact_point?  With a vertex, which keeps its place
// while the face under it slides.  The rounder one of two bodies rolls over a vertex,
// and touches below its own core.
static inline real contact_own(const touch *p, const contact *c)
{
    if (c->round_a != c->round_b) return c->round_a > c->round_b;
    return p->a.count == 1 ? 1 : p->b.count == 1 ? 0 : 0.5;
}

// Makes contact c, whose first piece is a body, of a manifold.  The manifold names
// features of the two shapes; the contact has points of each body, in the coordinates
// of its four particles.
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
            .own = b ? contact_own(&m->point[k], c) : 1 };
}
//<
