//> world-head
// world.h - the system: bodies in one pool of particles, and the step.
//
// Paper: sections 5 to 7.  Book: chapter 16.
// Units: metres, seconds, kilograms, joules.  Frame: y points up.

#ifndef TUMBLE_WORLD_H
#define TUMBLE_WORLD_H

#include "broad.h"
#include "obstacle.h"
#include "grid.h"
#include "line.h"
#include "push.h"
#include "rest.h"

typedef struct {
    real dt;            // s, a frame: one call of world_step; to 1
    int  substeps;      // a frame is this many integrations, or
    int  least_substeps;// fewer, down to this, while no rigid body goes further
                        // than a sixth of its inner radius, or
    int  most_substeps; // more, up to this, if it takes more for what is about
                        // to touch something to go no further than its own
                        // radius in one; all 1 to 10000
    int  sweeps;        // over a body's sticks, or a cloth's columns and rows,
                        // in a substep, at most; 1 to 10000
    vec3 gravity;       // m/s^2
    relax_options    relax;
    real friction;      // Coulomb's coefficient, >= 0
    real restitution;   // of rigid bodies, 0 to 1: the speed after an impact /
                        // the speed before
    int  passes;        // over all contacts of rigid bodies in a substep, at
                        // most, in pairs, forward and backward; 1 to 1000
    real content;       // of the smallest rigid body's radius: a pass that
                        // changes no gap by more is the last
    int  memory;        // 1: a contact begins with what it pushed in the last
                        // frame (warm starting); 0: with nothing
    real mend;          // share of an old overlap that a substep pushes out;
                        // 0 to 1
    real mend_speed;    // m/s, the most at which it does
    real skin;          // of a rigid body's radius: its contacts keep that far
                        // off, so that bodies at rest do not overlap
    real stay;          // of a rigid body's radius: one that lies no further
                        // from where its contacts were found keeps them; 0:
                        // they are found in every frame
    int  resting;       // 1: bodies that lie still fall asleep
    int  ledger;        // 1: who gave and took energy is booked
    real (*clock)(void);// s; times the stages; NULL: nothing is timed
    // Does work(data, 0) and work(data, 1), in any order or at once, and
    // returns when both are done; NULL: one after the other.  The bits do not
    // depend on it.
    void (*both)(void *context, void (*work)(void *data, int half),
                 void *data);
    void *both_context;
} world_options;
//<

//> body-struct
// A body: a range of the pool, built to a plan that it may share.
typedef struct body {
    const shape *plan;
    const struct rigid4  *four; // a rigid body's four particles; NULL: it is
                        // deformable, with a particle at every vertex
    int  first;         // its particles: first .. first + body_particles - 1
    int  corner;        // its vertices in the table `of.at`; = first where they
                        // are the particles
    real mass;          // kg; HUGE_VAL: nailed as a whole
    real thickness;     // m, its contacts keep that far off: the radius of the
                        // particles of a deformable body, a rigid one's skin
    sphere_tree tree;
    real inner;         // m, its plan's inner radius
    vec3 way;           // m, its centre's in a frame, as fast as it is now
    real turn;          // m, what its vertices may go beside that
    real reach;         // m, how far it may move in a frame; or what hits it
} body;
//<

//> report-struct
enum { STAGE_INTEGRATE, STAGE_PAIRS, STAGE_QUERY, STAGE_SEPARATE, STAGE_RELAX,
       STAGE_REST, STAGES };

// What the last step did.
typedef struct {
    real time[STAGES];  // s
    int  substeps;
    int  pairs;         // of rigid bodies whose spheres met
    int  contacts;      // of rigid bodies, at the end of the frame
    int  pushing;       // of those, how many pushed in the end
    int  near;          // pairs of particles, and of particle and body, watched
    int  touching;      // of those, and of particles and planes, how many were
                        // pushed in the last substep
    int  rebuilt;       // how often that list was made
    long tested;        // sticks looked at
    long relaxed;       // sticks moved
    int  fell_back;     // solves that GRADIENT_OLD lost and GRADIENT_NEW won
    int  asleep;        // bodies
    int  dropped;       // contacts or pairs that found no room: should be 0
} step_report;
//<

//> ledger-struct
// Whom energy and momentum may come from, and go to.  Friction of deformable
// bodies is booked under contacts.
enum { LEDGER_INTEGRATE, LEDGER_CONTACTS, LEDGER_FRICTION, LEDGER_STICKS,
       LEDGER_REST, LEDGERS };

typedef struct {
    real energy;        // J
    vec3 momentum;      // kg m/s
    vec3 angular;       // kg m^2/s, about the origin
} ledger_entry;
//<

//> world-entries
// Some contacts of a frame, one after the other, in `pushes`.
typedef struct {
    int  first, count;
    real margin;        // m, all that are nearer are there; 0: none are, or
                        // they are good for a substep only
} contact_run;

// Whom does it touch?  What is asked, and what is found.
enum { ASK_NOTHING,     // it is too far away
       ASK_STAYS,       // the contacts of the last frame go on
       ASK_NEAREST,     // who is nearest?
       ASK_SWEPT };     // when do they first touch?

typedef struct {
    int  ask;
    int  found;         // contacts
    int  guard;         // 1: and one beside them, contacts_have_guard
    real margin;        // m, all that are nearer are found
    contact_run run, was;   // this frame's contacts; the last one's, in
                            // pushes.old
} inquiry;

typedef struct {
    int a, b;           // rigid bodies, a < b
    int quick;          // they pass each other too quickly for contacts to last
    int place;          // of its contacts among those that were found
    inquiry is;
} body_pair;

enum { PLANES = 6 };

typedef struct {
    inquiry is;
    int at[PLANES];     // how many were found at each
} body_wall;

typedef struct {
    int particle;       // of a deformable body, in the pool
    int soft, rigid;    // that body; the rigid one
    int ahead;          // the plane of the rigid one that it was in front of
} point_pair;

typedef struct {
    const struct shape *shape;
    struct rigid4 *four;  // NULL unless rigid
    real inner;         // m, see shape_inner
    line_scratch *line; // NULL unless deformable
} plan_entry;
//<

//> world-tables
// The places that a frame remembers beside the pool, each table [particles].
// Written by whoever looks at a body (`at`, world_look), and by those named.
typedef struct {
    vec3 *at;           // of particles, then of the vertices that ride on four
                        // of them, for the queries
    int  corners;       // how many places those are in all
    vec3 *seen;         // when their body's contacts were found (pairs.c)
    vec3 *lain;         // when their body was last seen to move (step.c)
    vec3 *listed;       // when the near lists were made (soft.c)
    real *inverse_mass; // 1/kg, when awake
} particle_tables;

// What is true of a body, 0 or 1.  Written by pairs.c, at the start of a frame;
// and by those named.
typedef struct {
    char *moves;        // [bodies] neither nailed nor asleep, at the start of
                        // the frame
    char *fresh;        // [bodies] its contacts are found anew in this frame
    char *looked;       // [bodies] its vertices are where it is now (narrow.c)
    char *still;        // [bodies] did not move, in this frame (step.c)
} body_flags;
//<

//> world-tables-rigid
// The broad phase, pairs of rigid bodies.  Written by pairs.c, once a frame.
typedef struct {
    sphere *ball;       // [bodies] around each rigid body, this frame
    real *spread;       // [bodies] m, their reach before it was spread
    real *listed;       // [bodies] m, their reach when pairs were listed
    struct broad broad;
    int  (*met)[2];     // pairs whose balls meet
    body_pair *at, *old;                // sorted; this frame's, the last one's
    query_cache *carried, *old_carried; // what the last query of each left:
                                        // beside the pairs, for these are gone
                                        // through again and again
    int  count, old_count, capacity;
} pair_tables;

// The world in two halves.  Written by halves.c, when pairs have been listed.
typedef struct {
    char *side;         // [bodies] of the cut: 0, 1
    int  *sided, lefts; // [bodies] those on side 0, so many; then the others
} world_cut;

// The narrow phase.  Written by narrow.c, once a frame; for quick pairs again.
typedef struct {
    body_wall *wall;    // [bodies] what is asked and found at the planes
    contact_point *found;   // as they are found: every rigid body has room for
                        // its own with the planes; then those of each half's
                        // pairs, one after the other
    vec3 *swept[2];     // room for the vertices of two bodies, one for each
                        // half of the work
    char *needed[2];    // [bodies] must be looked at
} narrow_tables;

// Contacts of rigid bodies with each other and with planes.  Written by
// contacts.c after the narrow phase; solver.c pushes them in every substep.
typedef struct {
    struct push *at, *old;              // this frame's, the last one's
    int  (*between)[2], (*old_between)[2];  // their bodies; bodies + k: plane k
    int  count, capacity;
    int  lasting;       // the first of them are good for the whole frame, the
                        // others, of quick pairs, for a substep
    int  *in_parts, end[PILE_PARTS];    // their numbers in three parts: see
                                        // push_pile (halves.c)
    rigid4_ways  *ways;   // [bodies] when this frame's contacts were found
                        // (pairs.c)
    push_drift *drift;  // [bodies + PILE_PARTS] how far they are pushed in a
                        // substep (solver.c)
    push_near  *near;   // those that may touch, in a substep (solver.c)
} push_tables;
//<

//> world-tables-soft
// Particles of deformable bodies near each other, and near rigid bodies.
// Written by soft.c when the last lists are no longer good; it goes down these
// in every substep.
typedef struct {
    particle_contact *pair;             // of particles
    int  pairs, pair_capacity;
    point_pair *point;                  // particles at rigid bodies
    int  points, point_capacity;
    real margin;        // m, how much further than touching they look
    int  trusted;       // they are good for as many substeps more; -1: there
                        // are none yet
    struct grid grid;   // for the largest deformable body
} near_lists;

// Room for a traversal of two trees; scratch of soft.c.
typedef struct {
    struct leaf_pair *pair;
    int  capacity;
} leaf_tables;

// The planes of the rigid body that is asked about.  Written by soft.c, body
// after body, in every substep.
typedef struct {
    struct plane *plane;
    int  *face;         // the first of its plan in each plane
    int  planes;
    int  of;            // that body; -1: none
} hull_tables;
//<

//> world-struct
typedef struct world {
    world_options options;
    particle_pool pool;
    int  bodies, planes, plans, softs;  // softs: deformable bodies
    struct body *body;
    struct plane plane[PLANES];
    plan_entry *plan;   // [plans] one for each shape in use
    real time;          // s
    real age;           // s, a particle was at `previous` so long ago
    int  ready;         // world_begin has sized everything below
    real least_radius;  // m, of the rigid bodies; HUGE_VAL: none

    particle_tables of;
    body_flags      flags;

    // Rigid bodies, in the order of the stages.
    pair_tables     pairs;
    world_cut       cut;
    narrow_tables   narrow;
    push_tables     pushes;

    // Deformable bodies.
    near_lists      near;
    leaf_tables     leaves;
    hull_tables     hull;

    rest_state     rest;
    step_report    report;
    ledger_entry   ledger[LEDGERS];     // since the start, or ledger_clear
    ledger_entry   ledger_now;          // what there is, as of the last entry
} world;
//<

//> world-declare
// 4 substeps of 1/240 s, friction 0.5, restitution 0.
world_options world_options_default(void);

// An empty world.  Fails, with the option's name, if one is out of range: *w is
// empty then, too, and owns nothing.
status world_init(world *w, world_options options);
void   world_free(world *w);    // at any time after world_init, or zeroed

// Adds a body to plan s, which must outlive the world and stay where it is; its
// number in *number (which may be NULL).  Before world_begin.  Fails, adding
// nothing: a placement that is not finite, or whose axes are not perpendicular
// units; no memory.
status world_add(world *w, const shape *s, placement where, int *number);

// Adds a half-space that bodies stay out of, x . normal < offset; at most 6.
// The normal points to the free side; it need not be a unit vector (offset is
// in m times its length).  Before world_begin.  Fails, adding nothing: a
// seventh plane, a normal without direction, numbers that are not finite.
status world_add_plane(world *w, vec3 normal, real offset);

// Nails particle i of the deformable body b where it is.  Before world_begin.
void   world_nail(world *w, int b, int i);

// Sizes everything that a step needs.  Once, after all is in.  Fails only for
// want of memory: then world_free is all that may follow.
status world_begin(world *w);

// Body b as the queries see it: its places as of the last world_look.
pooled world_collider(const world *w, const body *b);

// Tells the queries where the vertices of body b are now.
void   world_look(world *w, const body *b);

// The same, and brings the body's tree up to date.
void   world_look_again(world *w, body *b);

// Finds how body b can move as it lies now, in w->pushes.ways; nothing, unless
// it is rigid.
void   world_find_ways(world *w, const body *b);

// Neither nailed nor asleep.
static inline int body_moves(const world *w, int b)
{
    return w->body[b].mass < HUGE_VAL && !w->rest.asleep[b];
}

// Writes to at where the vertices of body b are now: plan->particles of them.
void   world_vertices(const world *w, const body *b, vec3 *at);

static inline int body_is_soft(const body *b)
{
    return !b->four;
}
// How many particles body b has in the pool: four, or one at every vertex.
static inline int body_particles(const body *b)
{
    return body_is_soft(b) ? b->plan->particles : FOUR;
}
static inline int body_is_nailed(const body *b)
{
    return !(b->mass < HUGE_VAL);
}
//<

//> world-end-of-header
#endif
//<
