//> world-head
// world.h - the system: bodies in one pool of particles, and the step.
//
// Paper: sections 5 to 7.  Book: chapter 9.
// Units: metres, seconds, kilograms, joules.  Frame: y points up.

#ifndef TUMBLE_WORLD_H
#define TUMBLE_WORLD_H

#include "collide.h"
#include "ordering.h"
#include "rest.h"
#include "sphere_tree.h"

// What the leaves of a deformable body's tree enclose.
typedef enum {
    LEAVES_VERTEX,      // its particles, as balls of 0.55 of the spacing
    LEAVES_FACE         // its triangles or links (the paper)
} leaves_kind;

// Every difference between the paper's way and ours is one of these.  dt and
// substeps stay as they are once a body is in: where a particle was is where it
// was dt / substeps ago.
typedef struct {
    real dt;            // s, a frame: one call of world_step; to 1
    int  substeps;      // a frame is this many integrations (paper: 1); 1 to
                        // 10000
    int  sweeps;        // over a body's sticks in a substep, at most; 1 to
                        // 10000
    vec3 gravity;       // m/s^2
    relax_options    relax;
    order_kind       order;     // of sticks, in rigid bodies that collided
    response_options response;
    leaves_kind      leaves;
    int  look_ahead;    // 1: contacts are found before they are needed, and
                        // kept for a frame; 0: only overlaps are contacts
    real skin;          // of a rigid body's radius: its contacts keep that far
                        // off, so that bodies at rest do not overlap
    int  manifold;      // 1: several contacts a pair of rigid bodies
    int  blows;         // 1: after a blow bodies part at restitution times the
                        // speed at which they met; 0: at what the pushes gave
    int  resting;       // 1: bodies that lie still fall asleep
    real (*clock)(void);// s; times the stages; NULL: nothing is timed
} world_options;
//<

//> body-struct
// A body: a range of the pool, built to a plan that it may share.
typedef struct {
    const shape *plan;
    int  first;         // its particles: first .. first + plan->particles - 1
    real mass;          // kg; HUGE_VAL: nailed as a whole
    real thickness;     // m, its contacts keep that far off: the radius of the
                        // particles of a deformable body, a rigid one's skin
    sphere_tree tree;
    real reach;         // m, how far it may move in the rest of this frame
} body;

// How a body enters the world: the axes of its own frame, position of its
// centre of mass, velocity and spin about it.
typedef struct {
    vec3 position;      // m
    vec3 x, y, z;       // unit, perpendicular to each other, right-handed
    vec3 velocity;      // m/s
    vec3 spin;          // rad/s
    int  nailed;        // 1: it never moves
} placement;
//<

//> report-struct
enum { STAGE_INTEGRATE, STAGE_PAIRS, STAGE_QUERY, STAGE_SEPARATE, STAGE_RELAX,
       STAGE_REST, STAGES };

// What the last step did.
typedef struct {
    real time[STAGES];  // s
    int  pairs;         // of rigid bodies whose spheres met
    int  contacts;      // of rigid bodies and planes, at the end of the frame
    int  near;          // pairs of particles, and of particle and body, watched
    int  touching;      // of those, how many were pushed in the last substep
    int  rebuilt;       // how often that list was made
    long tested;        // sticks looked at
    long relaxed;       // sticks moved
    int  fell_back;     // solves that GRADIENT_OLD lost and GRADIENT_NEW won
    int  asleep;        // bodies
    int  dropped;       // contacts or pairs that found no room: should be 0
} step_report;
//<

//> world-struct
typedef struct {
    int a, b;           // rigid bodies, a < b
    int quick;          // they pass each other too quickly for contacts to last
    simplex carried;
} body_pair;

typedef struct {
    int particle;       // of a deformable body, in the pool
    int soft, rigid;    // that body; the rigid one
    int ahead;          // the plane of the rigid one that it was in front of
} point_pair;

typedef struct {
    const shape *shape;
    stick_lists lists;  // empty unless the order needs them
} plan_order;

// The particles' places that a frame remembers beside the pool.
typedef struct {
    vec3 *at;           // where they are, for the queries
    vec3 *start;        // at the start of the frame
    vec3 *before;       // before separation; scratch of the solver
    vec3 *listed;       // when the near lists were made
    real *inverse_mass; // 1/kg, when awake
} particle_tables;

typedef struct {
    world_options options;
    particle_pool pool;
    int  bodies, planes, plans, softs;  // softs: deformable bodies
    body *body;
    plane plane[6];
    plan_order *plan;   // [plans] one for each shape in use
    real time;          // s
    int  ready;         // world_begin has sized everything below

    particle_tables of; // [particles]
    hit_scratch   *hit;
    order_scratch *orders;

    body_pair *pair, *old_pair;         // sorted; this frame's, the last one's
    int  pairs, old_pairs, pair_capacity;
    contact *contact;                   // of rigid bodies and planes
    int  (*between)[2];                 // their bodies; -1: a plane
    int  contacts, contact_capacity;
    int  lasting;       // the first of them are good for the whole frame, the
                        // others, of quick pairs, for two substeps

    sphere_contact *near;               // pairs of deformable particles
    int  nears, near_capacity;
    point_pair *point;                  // deformable particles at rigid bodies
    int  points, point_capacity;
    leaf_pair *leaf_pair;               // room for a traversal
    int  leaf_capacity;
    int *leaf_met;      // [leaves of the largest tree] where in leaf_pair a
                        // leaf of the first tree was last met
    int  trusted;       // the near lists are good for as many substeps more;
                        // -1: there are none yet
    real list_margin;   // m, how much further than touching they look

    plane *hull;        // the planes of body hull_of
    int  *hull_face, hulls, hull_of;

    char *slow;         // [bodies] slow enough to rest, in this frame
    char *collided;     // [bodies] rigid ones that were pushed in this substep,
                        // by each other or by planes
    sphere *ball;       // [bodies] around each rigid body, this frame
    real *spread;       // [bodies] m, their reach before it was spread
    rest_state  rest;
    step_report report;
} world;
//<

//> world-declare
// Our best: substeps, contacts before sticks, looking ahead, manifolds, rest.
world_options world_options_default(void);

// The paper's way: one step, one separation, Eq. 10 as printed, whole leaves
// apart by Eq. 11, ordered lists, 1 %.  (PUSH_PRINTED is left to be chosen.)
world_options world_options_paper(void);

// Upright, at rest, free.
placement placement_at(vec3 position);

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

// Nails particle i of body b where it is.  Before world_begin.
void   world_nail(world *w, int b, int i);

// Sizes everything that a step needs.  Once, after all is in.  Fails only for
// want of memory: then world_free is all that may follow.
status world_begin(world *w);

// Body b as the queries see it: its places as of the last world_look.
collider world_collider(const world *w, const body *b);

// Copies where the particles of body b are for the queries.
void   world_look(world *w, const body *b);

// The same, and brings the body's tree up to date.
void   world_look_again(world *w, body *b);

static inline int body_is_nailed(const body *b)
{
    return !(b->mass < HUGE_VAL);
}
static inline int body_is_soft(const body *b)
{
    return b->plan->kind != SHAPE_RIGID;
}

//<

//> world-end-of-header
#endif
//<
