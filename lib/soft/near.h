//> near-head
// near.h - neighbour lists: particles of ropes and cloths near each other, and near
// rigid bodies.
//
// Paper: section 5.2 asks trees in every step.  Book: chapter 16.
//
// The lists have a margin, and are good until the moves of two things differ by it (the
// neighbour list of Verlet 1967).  Until then a substep only reads them.
// Units: metres, seconds, kilograms, in the world's frame.

#pragma once

#include "aabb_tree.h"
#include "placed.h"
#include "facet.h"
#include "grid.h"
#include "separation.h"
#include "solver.h"
//<

//> near-frame
// Is a rope or cloth deep in something that it was set down in, or that was set down in
// it?  The next substep finds out; then it is watched until a whole frame was good.
typedef enum { SUNK_NOT, SUNK_PERHAPS, SUNK_BEFORE, SUNK } sunk_state;

// The tables of the world that a substep of ropes and cloths reads.  It moves their
// particles, and only pushes rigid bodies.
typedef struct {
    const body *body;           // [bodies]
    const bool *asleep;         // [bodies]
    int  bodies;
    const int *soft;            // [softs] the deformable ones, in their order
    int  softs;
    particle *particle;         // the pool
    const solver_body *now;     // [bodies] rigid ones, as the frame begins,
    line_hold *hold;            // [particles] of the pool
    motion *moved;              // [bodies] how far they have been moved since,
    motion *velocity;           // [bodies] and how fast they are
    const sphere *ball;         // [bodies] around them, as the frame begins
    const prediction *ahead;    // [bodies] how they may move in the frame
    const body_tie *tied;       // [ties] pairs that do not meet
    int  ties;
    const plane *plane;
    int  planes;
    vec3 gravity;               // m/s^2
    const material *material;   // [bodies] what they are made of,
    const material *wall;       // [planes] and these
    const int *owner;           // [particles] of the pool: whose they are
    sunk_state *sunk;           // [bodies] of deformable ones
    vec3 *owed;                 // [bodies] see owe_angular
    int  iterations;            // over strands, at most
    bool certified;             // no cloth crosses cloth, see certificate.h
    relax_options relax;
    int  substeps;              // of a frame: usual for cloth,
    int  stiff_substeps;        // for rope, and cloth with a body on it,
    int  most_substeps;         // and at most
    real frame, whole;          // s; it may be a part of a divided one
    real age;                   // s, a particle was at `previous` so long ago
    real h;                     // s, this substep
} soft_frame;

// For so many substeps, at most, what is clear is trusted to stay so.
enum { TRUST_MOST = 8 };                    // tuned, substeps

// Neither static nor asleep.
static inline bool soft_moves(const soft_frame *f, int b)
{
    return !body_is_fixed(&f->body[b])
        && !f->asleep[body_whole(&f->body[b], b)];
}
static inline bool is_moving_soft(const soft_frame *f, int b)
{
    return body_is_soft(&f->body[b]) && soft_moves(f, b);
}
// Where bodies a and b meet, or a and a plane (b < 0).
static inline material soft_material(const soft_frame *f, int a, int b)
{
    return material_between(f->material, f->wall, a, b);
}
// May anything come of a and b being near each other?
static inline bool soft_meets(const soft_frame *f, int a, int b)
{
    int x = body_whole(&f->body[a], a), y = body_whole(&f->body[b], b);
    for (int k = 0; k < f->ties; k++)
        if ((f->tied[k].soft == x && f->tied[k].rigid == y)
            || (f->tied[k].soft == y && f->tied[k].rigid == x)) return false;
    return body_meets(&f->body[a], &f->body[b]);
}
//<

//> near-struct
//>   The lists hold pairs of particles, particles beside rigid bodies, and
//>   facets.
// A rigid body as particles meet it: where its vertices and planes are.
typedef struct {
    vec3 *corner;       // [corners] of the body that has most
    plane *plane;       // [faces]
    int  corners, faces;
    obstacle hull;      // these, as they stood when it was last looked at,
    rigid_frame frame;  // how the body lay,
    motion moved;       // and how far it had been moved
    int  of;            // that body; -1: none
} rigid_view;

typedef struct {
    int particle;       // of a deformable body, in the pool
    int soft, rigid;    // that body; the rigid one
    int ahead;          // the plane of the rigid one that it was in front of
    int over;           // 1: and over that face, nowhere near its rim
} point_pair;

// A pair of particles that overlapped in this substep.
typedef struct {
    int  pair;          // its number
    real depth;         // m
} pressed_pair;

// A triangle or a link that may meet an edge or a corner.
typedef struct {
    int soft, rigid;    // bodies
    int number;         // of the triangle or the link in its shape
    plane between;      // between it and the body, in the frame of that body
    int until;          // nothing is asked before so many substeps are over
} facet_pair;

typedef struct {
    facet_pair *at;
    int count, next;    // how many; which is looked at
} facet_list;

typedef struct {
    particle_contact *pair;     // of particles
    int  pairs, pair_capacity;
    pressed_pair *pressed;      // [pair_capacity] for a substep
    point_pair *point;          // particles at rigid bodies; those of the same
                                // two bodies stand together
    int  points, point_capacity;
    facet_list facet;           // facets at rigid bodies, in the same order
    facet_list facets_before;   // those of the last lists
    int  facet_capacity;
    int  substeps;      // since the lists were made
    int *ahead;         // [particles] while facets are listed, see near.c
    real margin;        // m, how much further than touching the lists look
    bool is_stale;      // they must be made again, or there are none yet
    vec3 *at;           // [particles] for trees and grid
    vec3 *listed;       // [particles] when the lists were made
    sphere_tree *tree;  // [bodies] of deformable ones
    sphere *ball;       // [bodies] around each, as the frame begins
    real *gap;          // [bodies] how far other deformable ones are kept from
                        // it, as a share of touching; more than 1: it is new
    int  *candidate;    // [candidates] deformable bodies, and rigid ones that
    int  candidates;    // they may meet in this frame, by their numbers
    bool *is_near;      // [bodies] is it a candidate, as this frame begins?
    int  bodies, particles;     // for so many there is room
    struct leaf_pair *leaf;     // [pair_capacity] for a traversal of two trees
    grid grid;          // for the largest deformable body
    int  *soft;         // [softs] the deformable bodies, in their order,
    int  softs;
    int  soft_particles;        // and their particles
    int  made;          // how often, since near_begin
    int  dropped;       // pairs that found no room, since then
} near_lists;
//<

//> near-declare
// Body b of `all` is new; there are so many now, with so many particles in the
// pool.  Nothing needs room before one is deformable.  Fail, adding nothing, for
// want of memory.
status near_add(near_lists *l, const body *all, int b, int bodies,
                int particles);
status rigid_view_add(rigid_view *v, const body *b);
void   near_free(near_lists *l);        // an empty or zeroed one is fine
void   rigid_view_free(rigid_view *v);  // likewise

// What is kept of body b is forgotten: it has been put elsewhere.
void   near_forget(near_lists *l, int b);
// It is taken away, as well.
void   near_remove(near_lists *l, const body *all, int b);

// A frame begins: where is everything, and what may meet?
void near_begin(near_lists *l, const soft_frame *f, const prediction *ahead);

// Brings the lists up to date for a substep.
void near_refresh(near_lists *l, rigid_view *v, const soft_frame *f);

// Where rigid body b stands in the middle of a frame.
rigid_frame soft_rigid_frame(const soft_frame *f, int b);

// Looks where the vertices and planes of rigid body b are now.
void rigid_view_update(rigid_view *v, const soft_frame *f, int b);

// The particles of facet k of b: a link says its last one twice.
static inline void facet_corners(const body *b, int k, int end[FACET])
{
    const shape *s = b->shape;
    bool is_face = s->mesh.faces > 0;
    const int *v = is_face ? &s->face[FACET * k] : NULL;
    end[0] = b->first + (is_face ? v[0] : s->stick[k].a);
    end[1] = b->first + (is_face ? v[1] : s->stick[k].b);
    end[2] = b->first + (is_face ? v[2] : s->stick[k].b);
}

// m, how far particles of `soft` are kept from the surface of `rigid`.
real soft_gap(const body *soft, const body *rigid);

// m, how far triangles and links of `soft` are kept from the edges and corners
// of `rigid`.
real facet_gap(const body *soft, const body *rigid);
//<
