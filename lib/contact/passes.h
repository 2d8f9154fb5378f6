//> passes-head
//>   A **block** holds four contacts that share no body: otherwise two lanes
//>   would read the same velocity, and the second would overwrite what the
//>   first has written.
// passes.h - blocks of four contacts side by side, and what goes over them.
//
// Paper: section 6.1 parts one pair after the other, once a step.  Here:
// projected Gauss-Seidel with soft contacts (Catto 2011, 2024), four contacts
// side by side.  Book: chapter 13.
// Units: metres, kilograms, seconds.  Normals point from B to A.

#pragma once

#include "contact.h"
#include "material.h"
#include "real4.h"
#include "scene.h"
#include "task.h"

#include <stddef.h>

// How an overlap is pushed out: as a spring and a damper would, so strongly
// that the substep can follow.
typedef struct {
    real rate;          // 1/s, at which an overlap goes
    real mass;          // share of the effective mass that answers
    real impulse;       // share of the old impulse that is given up
} softness;

// A rigid body as the solver reads it.
typedef struct {
    motion_basis basis; // zero: immovable
    rigid_frame frame;  // where it stood when its basis was made: it has been
                        // moved since then, see solver_push
    real radius;        // m, around its centre
    bool is_driven;     // its velocity is set, whatever pushes it: its basis is
                        // that of a body so heavy that no push shows
    bool is_joined;     // joints have rows of it in this basis
    bool is_struck;     // an impact has put it elsewhere in this substep
} solver_body;

// Where are the rows of a body made?  Where it stands when a substep ends;
// halfway, if it touches a driven body that turns; or, if it lies, where its
// contacts were found.
enum { GOES_EXACTLY, GOES_BY_HALVES, LIES };

// What the solver is told about a frame.
typedef struct {
    const solver_body *body;    // [bodies]
    int  bodies;
    const char *fresh;          // [bodies] has it a new frame and basis since
                                // rows were made?  NULL: all have
    bool is_put_back;           // by an impact, to where it has not been
    const rigid_frame *rows_at; // [bodies] where rows are made, if not where
    const char *is_elsewhere;   // [bodies] it stands; NULL: none is elsewhere;
                                // or GOES_EXACTLY, ...
    const motion_basis *lying;  // [bodies] the basis there, of those that lie;
                                // NULL: of none.  While they lie, both stay
    const plane *plane;         // those that contacts with planes name
    real h;                     // s, a substep
    int  substeps;              // of this frame, or part of it
    real warm;                  // times the impulses that contacts bring along;
                                // 0: none
    const real *age;            // [bodies] s, the substep that they are of;
                                // NULL: one of h
    real friction;              // Coulomb's coefficient, and
    real restitution;           // of impacts, 0 to 1; 0: there are none; of
                                // all bodies, or
    const material *material;   // [bodies] each has its own; NULL: these;
    const material *wall;       // and so has each plane
    real hertz;                 // 1/s, of the contacts' springs, at most
    real damping;               // ratio, of their dampers
    real max_rate;              // 1/s, times the smaller radius: the speed at
                                // which overlaps are pushed out, at most
    real joint_rate;            // 1/s, likewise: that at which joints come together
    vec3 gravity;               // m/s^2, for impacts
    // Is told of each impact, and its impulse (N s); NULL: none is.
    void (*hear)(void *listener, const contact *c, real impulse);
    void *listener;
    tasks run;
} solver_frame;
//<

//> passes-material
// Where bodies a and b meet, or a and a plane (b < 0).
static inline material solver_material(const solver_frame *f, int a, int b)
{
    if (!f->material) return (material){ f->friction, f->restitution };
    return material_between(f->material, f->wall, a, b);
}
//<

//> passes-strikes
// Is contact c one of impacts in time: do its bodies bounce, or meet later in the
// frame than where they are now?
static inline bool solver_strikes(const solver_frame *f, const contact *c)
{
    return (c->b >= 0 && c->is_ahead)
        || solver_material(f, c->a, c->b).restitution > 0;
}
//<

//> passes-place
// Where a point of each of four contacts rides on its bodies.  Rows are made of
// it, and no pass reads it.
typedef struct {
    real4 local_a[3], local_b[3];   // coordinates in the frames of the bodies
    real4 own;          // 1: they push where A's point is; 0: where B's is
    real4 has;          // 1: there is such a point; 0: not
    real4 began;        // N s, its impulse before this substep
    real4 blow;         // N s, what of it was given at once, see blow.h
} block_place;
//<

//> passes-block
// Four contacts side by side: each number of each kind stands in a lane of its
// own.  The contacts of a block share no body.
typedef struct {
    real4 turn_a[TURNS], turn_b[TURNS]; // kg^(-1/2), Jacobian row of the turns
    real4 gap, now;     // m, when the row was made; when last relaxed
    real4 mass;         // kg, effective, along the normal
    real4 impulse;      // N s
    real4 lever;        // m, from the point where friction acts
} block_point;

// Friction acts along two directions across the normal, and as a twist about it.
enum { TWIST = 2, RUBS };

typedef struct {
    real4 normal[3];
    real4 across[2][3];                 // two unit vectors across it
    real4 inverse_a, inverse_b;         // 1/kg
    real4 rub_a[RUBS][TURNS], rub_b[RUBS][TURNS];   // rows of friction
    real4 across_mass[3];               // kg: inverse of the 2 x 2 matrix K
    real4 twist_mass;                   // kg m^2
    real4 rub[RUBS];                    // N s, N m s, its impulses
    real4 friction;
    real4 strikes;                      // 0: not; 1: see solver_strikes; 2: and
                                        // it bounces
    real4 uneven;                       // root of the ratio of the masses, or 0
    real4 closing;                      // m/s, below 0: they strike, see blow.h
    int   a[REAL4], b[REAL4];           // bodies; lanes left over: the spare
    int   contact[REAL4];               // -1: left over
    int   points;                       // of the contact that has most
    bool  two;                          // both sides move,
    bool  is_driven;                    // but B is driven
    bool  is_uneven;                    // a heavy body meets a light one
    bool  has_blow;                     // impulses hold one, see blow_forget
    real4 struck;                       // > 0: what closed fast was stopped
    int   in_blow;                      // a bit a lane, while it is found
    bool  rubs;                         // friction's impulses may not be 0
    bool  is_stale;                     // rows are those of an older substep
    bool  lies;                         // all that it has lies, with its gaps
                                        // closed: rows stay good
    bool  is_round;                     // some are
    real4 round_a, round_b;             // m, see contact
    real4 height;                       // m, of the plane; of bodies, 0
    real4 per_near;                     // 1/m, of a gap that is all but closed
    real4 radius;                       // m, the smaller one
    real4 began[RUBS];                  // rub before this substep
    block_point *point;                 // [points] of the solver's
    block_place *place;                 // [points]
} block;
//<

//> passes-struct
//>   So the contacts are *coloured*. Each takes the lowest colour that neither
//>   of its bodies has yet, and any four of one colour make a block. What does
//>   not move cannot be overwritten, nor what is driven, which no push moves;
//>   contacts with these have colours of their own, and come last.
// Blocks of one colour share no body that pushes move, so that they may be solved
// in any order, or at once.  Contacts with what is driven, or does not move, have
// colours of their own, and come last: what is immovable has the last word.
enum { COLORS = 64 };
enum { TWO_SIDED, DRIVEN_SIDED, ONE_SIDED, SIDES };

typedef struct {
    long found;         // the contact's
    int  a, b;          // bodies, or b < 0: a plane; ONE_SIDED: only a moves;
                        // DRIVEN_SIDED: b is driven
    int  color;
    signed char count;  // points that may touch in this frame
    signed char sides;
    bool is_swapped;    // A yields to no push: the block's A is the contact's B
    bool is_new;        // it, or one of its points, was not in the last frame
    bool is_deep;       // overlaps by more than a tenth of the smaller radius
    bool carries;       // these bring an impulse along
    signed char point[CONTACT_POINTS];  // which of the contact's
    real least;                         // m, of all points
    real load;          // N s, along the normal, when last solved
    int  above;         // the body that lies on the other, if they may touch,
                        // and it is not driven; or -1
    real lift;          // N m/s, the load along gravity, times gravity
    real weight;        // m/s^2, the weight of that body, over effective mass,
                        // as if nothing else bore it;
    real borne;         // m/s^2, the force that was borne, over the same
} active_contact;

// The smaller radius of the bodies of x; of the one that yields, if it is alone.
static inline real active_radius(const active_contact *x,
                                 const solver_frame *f)
{
    real radius = f->body[x->a].radius;
    return x->sides == TWO_SIDED ? real_min(radius, f->body[x->b].radius)
                                 : radius;
}

// s: the substep that its impulses are of.  (Its A yields.)
static inline real active_age(const active_contact *x, const solver_frame *f)
{
    return f->age ? f->age[x->a] : f->h;
}

// Is it that of the frame before, with the same points and impulses?
static inline bool solver_is_kept(const active_contact *x,
                                  const solver_frame *f)
{
    return !x->is_new && active_age(x, f) == f->h;
}

typedef struct {
    int  first, count;  // blocks
    int  begin, contacts;       // in the solver's order
    int  sides;
    bool is_crowded;    // more contacts met in one body than there are colours:
                        // these share bodies, one in a block
    bool carries;       // they bring impulses along; if not, they have yet to
                        // find them
} block_color;

typedef struct {
    active_contact *active;             // [capacity] of every contact
    int  *order;                        // [capacity] by colour and points
    int  contacts, capacity;
    int  known;                         // contacts of the frame before
    int  first, end;                    // blocks are of active[first] to before
                                        // active[end]
    block *block;
    int  blocks, block_capacity;
    block_point *point;                 // of block after block
    block_place *place;
    int  point_capacity, place_capacity;
    int  *start;                        // [blocks + 1] where they begin
    int  start_capacity;
    block_color color[2 * SIDES * COLORS];
    int  colors;
    unsigned long long (*taken)[SIDES]; // [bodies] colours of each
    int  *first_of;                     // [bodies] the first side of a block's
                                        // contact that is of each, and
    int  *next_of;                      // after each side the next: see blow.c
    int  side_capacity;
    int  room;                          // for so many there is room
    bool strikes;                       // some of these strike
    real h;                             // s, the substeps that blocks are for
} contact_solver;

// The first contact in s->order of block `number`, and how many it has.
static inline int solver_lanes(const contact_solver *s, int number, int *first)
{
    const block_color *c = s->color;
    while (number >= c->first + c->count) c++;
    int each = c->is_crowded ? 1 : REAL4, before = each * (number - c->first);
    *first = c->begin + before;
    return int_min(each, c->contacts - before);
}
//<

//> passes-declare
// An item has as many contacts in its blocks as others have things.
enum { FEW_BLOCKS = TASK_CHUNK / REAL4 };

// What the making of blocks is given.
typedef struct {
    contact_solver *s;
    const solver_frame *f;
    const contact *const *table;
    const real *reach;
    int known;          // so many blocks are those of the frame before,
    bool is_same;       // and all their contacts are
} preparation;

// What a pass over the blocks is given.
typedef struct {
    contact_solver *s;
    motion *velocity;
    const motion *moved;
    real per_h;             // 1/s
    real max_rate;
    real slowest;           // m/s, what closes more slowly does not strike
    softness soft[SIDES];
    int first, count, sides;    // the blocks of a colour,
    bool carries;               // and whether they bring impulses along
    const solver_frame *f;
} solver_pass;

// Each does item `item` of its work: FEW_BLOCKS blocks.
// `push` and `relax` of contacts that have no impacts; and that may have some.
typedef void solver_work(void *data, int item);
typedef struct {
    solver_work *fill, *renew;                      // data: a preparation
    solver_work *refill;                            // item: one block
    solver_work *see, *strike, *warm, *push[2], *relax[2];   // data: a solver_pass
} solver_passes;

extern const solver_passes passes_narrow, passes_wide;

// Those that this processor is quickest with.  All give the same bits.
static inline const solver_passes *passes_best(void)
{
#if defined(__x86_64__) && defined(__GNUC__)
    if (__builtin_cpu_supports("avx")) return &passes_wide;
#endif
    return &passes_narrow;
}
//<
