//> world-head
//>   What can be chosen is an option; most scenes set none. Turn `dt` down for
//>   bodies that are small and fast for the screen's rate, and `substeps` up for
//>   finer cloth, swings and tops. Turn `most_substeps` down where no frame may
//>   take fifty times the usual four, and up for a bullet and a cloth. A lower
//>   `hertz` gives soft landings, with more overlap. `stay` at 0 shows what the
//>   cache does; it costs a factor. `sleep_speed` at 0 lets nothing sleep; turn it
//>   up for scenes that must be quiet soon. More `iterations` are for cloth that
//>   must not stretch. The `ledger` is for a scene that you do not believe, and
//>   changes no bit.
// world.h - the system: bodies in one pool of particles, and the step.
//
// Paper: sections 5 to 7.  Book: chapter 18.
// Units: metres, seconds, kilograms, joules.  Frame: y points up.

#ifndef TUMBLE_WORLD_H
#define TUMBLE_WORLD_H

#include "cache.h"
#include "linkage.h"
#include "sleep.h"
#include "soft.h"

// What the program around a world lends it.
typedef struct {
    real (*clock)(void);    // s; times the phases; NULL: nothing is timed
    tasks run;              // threads; see task.h
    // Called in each part of a frame, when `ahead` says how far bodies get in it:
    // adds parts and removes parts (world_add_part), and says whether it added
    // some.  NULL: there is nothing of which parts come and go.
    bool (*surround)(void *surroundings);
    // Called after that part, by several threads at once: does the way of the
    // centre of body b go in through one of their faces?  The first such face goes
    // to *side.
    bool (*enters)(void *surroundings, int b, vec3 from, vec3 to, plane *side);
    void *surroundings;
    // Shall the bodies of this contact push each other in this part of a frame?
    // NULL: all do.
    bool (*meets)(void *chooser, const contact *c);
    void *chooser;
} world_host;

// In all parts of a frame together.
enum { ALL_SUBSTEPS = 10000 };

typedef struct {
    real dt;            // s, a frame: one call of world_step; to 1
    int  substeps;      // of a frame, at least, 1 to ALL_SUBSTEPS; 0: as
                        // world_substeps says, when the world is made
    int  most_substeps; // a frame takes more, up to this, for a cloth that
                        // something fast comes near, and for what bears much
                        // beside its mass; no more in its four parts
                        // together, if something is fast
    vec3 gravity;       // m/s^2
    real friction;      // Coulomb's coefficient, >= 0
    real restitution;   // of rigid bodies, and of cloth and rope at what does
                        // not move, 0 to 1: the speed after an impact / the
                        // speed before
    real hertz;         // 1/s, of a contact's spring, at most; a substep bears
                        // an eighth of its own rate.  The lower, the softer do
                        // bodies settle, and the more do they overlap
    real stay;          // of a rigid body's radius: one that has gone no
                        // further since its contacts were found keeps them; 0:
                        // they are found in every frame
    bool warm_start;    // contacts begin with the impulses of the last frame
    real sleep_speed;   // m/s, of a body half a metre in radius under 9.81
                        // m/s^2, see sleep.h: slower ones fall asleep; 0: none
    real time_to_sleep; // s, so long all of an island must have been slow
    bool certified;     // cloth never crosses cloth, see certificate.h
    int  iterations;    // over a cloth's columns and rows in a substep, at
                        // most; 1 to 10000
    relax_options relax;    // of a cloth's links
    bool ledger;        // what gives and takes energy is booked
    world_host host;
} world_options;
//<

//> report-struct
//>   A step reports what it did.
enum { PHASE_PAIRS, PHASE_CONTACTS, PHASE_PREPARE, PHASE_SOLVE, PHASE_SOFT,
       PHASE_MOVE, PHASE_SLEEP, PHASES };

// What the last step did.
typedef struct {
    real time[PHASES];  // s
    int  substeps;      // of the island that took most; 0: all sleep, and
                        // nothing was done
    int  pairs;         // of rigid bodies that may meet
    int  queries;       // of them and of planes, asked where they touch
    int  contacts;      // of rigid bodies: pairs, and bodies and planes
    int  pushing;       // of those, how many pushed in the end
    int  near;          // pairs of particles, and of particle and body, watched
    int  touching;      // of those, and of particles and planes, how many were
                        // pushed in the last substep
    int  rebuilt;       // how often that list was made
    long tested;        // sticks looked at
    long relaxed;       // sticks moved
    int  fell_back;     // strands that turned too far in a substep
    int  asleep;        // bodies
    int  unconverged;   // contacts that overlap by more than a tenth of the
                        // smaller body's radius, joints apart by a hundredth
                        // of it or of a radian, and ropes and cloths with a
                        // link that is off by a hundredth
    int  lost;          // bodies that had no numbers after the substeps of a
                        // part of the frame, and were stopped: should be 0
    int  cut;           // parts of the frame that had fewer substeps than
                        // options ask for, for ALL_SUBSTEPS are all: should be 0
    int  prevented;     // pairs of facets of cloth that were kept from crossing,
    int  crossed;       // and that cross, as they did when the frame began
    int  dropped;       // contacts or pairs that found no room: should be 0
    int  broken;        // joints that had to bear more than their strength
    real parted;        // m, the most by which the points of a joint are apart
} step_report;
//<

//> ledger-struct
//>   Each phase books the energy and momentum that it gave.
// What energy and momentum may come from, and go to: gravity and motion,
// contacts with their friction, sticks, falling asleep.
enum { LEDGER_INTEGRATE, LEDGER_CONTACTS, LEDGER_STICKS, LEDGER_SLEEP,
       LEDGERS };

typedef struct {
    real energy;        // J
    vec3 momentum;      // kg m/s
    vec3 angular;       // kg m^2/s, about the origin
} ledger_entry;
//<

//> world-tables
// A shape in use, and what is found once for all bodies built to it.
typedef struct {
    const struct shape *shape;
    int  bodies;        // built to it; 0: the entry is free
    rigid4 *rigid;      // NULL unless rigid
    real inner;         // m, see shape_inner
    line_scratch *line; // NULL unless deformable
} shape_entry;

// What pushes a body all through the next frame, from outside.
typedef struct {
    vec3 force, torque; // N, N m
} body_load;

// What a contact gave at once, or in a frame, where it first did.
typedef struct {
    int  a, b;          // as a contact has them
    vec3 point, normal;
    real impulse;       // N s
} heard_impulse;

// How a kinematic body moves.
typedef struct {
    vec3 velocity, spin;        // m/s, rad/s
} body_drive;

// How many substeps an island takes.
typedef struct {
    int now;            // a frame
    int frames;         // for which fewer would have done
} substep_choice;

// What pushes or is joined to another, and what asks it for substeps.  An island
// is named by one of its bodies.  A driven body is in none: nothing goes on through
// it, from one island to the next.
typedef struct {
    int  parent;        // union-find: a body of the same island
    int  ground;        // the driven body that it touches; -1: none
    bool rests;         // it touches something at rest, or is joined to it
    real lift;          // N m/s, of all contacts that bear this one body
    real pulls;         // N, how hard gravity and forces pull, summed over bodies
    vec3 carried;       // N, what planes, static and driven bodies push it with
    real weight;        // 1/s^2, the largest of its contacts beside the smaller
    real squares;       // width; the sum of the squares of what they bear,
    int  bears;         // which are so many
    real low, high;     // m, along gravity, how far its bodies reach,
    real inner, width;  // m, the sums of their inner radii and cache_width,
    real largest;       // m, the largest radius of its bodies,
    int  bodies;        // of which there are so many
    real pace;          // rad/s, of the fastest swing about its joints
    real lasts;         // s, in which a spring would bring it home at its speed
    bool rubs;          // a contact of it presses
    bool is_held;       // joints hold it to what no pull moves
    bool hangs;         // it has joints, or is soft:
    bool is_soft;       // it has ropes or cloths
    bool is_calm;       // none of it flies
    bool is_fast;       // some of it goes by its inner radius in a frame
    real turn;          // rad, in the frame, of what turns furthest
    int  substeps;
    real energy, mass;  // J, kg, of what touches something
    vec3 momentum;      // kg m/s, likewise
    real loads;         // J, that forces from outside would give, and the sum of
    real drives;        // the roots (J^(1/2)) of what motors and springs would
    real most;          // J, that it may have when the frame ends, see guard.h
    bool is_lost;       // it has other numbers than it should, or none
} island;

// Islands that take about as many substeps go together: by_rung[first] to before
// by_rung[end], and their contacts likewise.
typedef struct {
    int substeps;
    int first, end, first_contact, end_contact;
    bool is_soft;       // all ropes and cloths are here: they have one time
    bool hangs;         // there are joints
} rung;

// Each has a quarter more substeps than the one below.
enum { RUNGS = 16 };    // tuned, rungs

// Rigid bodies in a frame, each phase with its own table: where they are ->
// which may meet -> where they touch -> what impulses part them -> how far they
// move.  In `now` and its neighbours a deformable body is immovable, and has a
// ball of negative radius.
typedef struct {
    const struct body *body;    // [bodies] the world's
    char        *dynamic;   // [bodies] rigid, and not static
    char        *moves;     // [bodies] and neither asleep nor kinematic and
                            // at rest
    solver_body *now;       // [bodies] where it stands
    sphere      *ball;      // [bodies]
    prediction  *ahead;     // [bodies]
    real        *reach;     // [bodies] of ahead
    real        *age;       // [bodies] s, see body_age
    real        *halfway;   // [bodies] s, see ledger_halfway
    motion_basis *lying;    // [bodies] see solver_frame
    rigid_frame *asked;     // [bodies] see cache_frame
    rigid_frame *middle;    // [bodies] where its rows are made, see advance.c
    real        *turned;    // [bodies] m, see ahead.c
    rigid_frame *began;     // [bodies] when they began
    int         *awake;     // [awakes] all that every step goes over, by number:
    int          awakes;    // what moves, and what may since it was looked at
    char        *is_awake;  // [bodies]
    bool         has_noticed;           // some are not in the list yet
    motion      *velocity;  // [motions], see solver.h
    motion      *moved;     // [motions] since it got its frame and basis
    char        *fresh;     // [bodies] it got them in the last substep
    char        *going;     // [bodies] see advance.c
    char        *touches;   // [bodies] it moves, and has contacts or joints
    real elapsed;            // s, since the substeps began
    int          motions;
    char        *held;      // [bodies] by contacts or joints, in the last substep
    body_load   *load;      // [bodies]
    bool is_loaded;         // some are not 0
    material    *material;  // [bodies] deformable ones, too
    body_drive  *drive;     // [bodies]
    substep_choice *choice; // [bodies] of the island that it was in last
    island      *island;    // [bodies]
    char        *rung;      // [bodies]
    int         *by_rung;   // [awakes] what is awake, one rung after the other,
    int          drivens;   // and before these what is driven
    rung         rungs[RUNGS];
    char         on_rung;   // the one that goes now
    pair_list      pairs;
    bool           is_new_list;         // of pairs
    contact_cache  cache;
    contact_solver solver;
    bool         listens;   // what contacts give is written down:
    heard_impulse *heard;   // [hears] in the last frame
    int          hears, heard_room;
    int          heard_from;            // where contacts of this rung begin in
                                        // it; < 0: they have no lines yet
} rigid_tables;

// All that have a place for each body: what a saved world keeps of them, what must
// be zeros where a frame begins, and what a step fills before it reads it.
#define RIGID_TABLES(KEPT, ZEROS, FILLED)                                     \
    KEPT(dynamic) KEPT(ball) KEPT(age) KEPT(choice) KEPT(held) KEPT(load)     \
    KEPT(material) KEPT(drive)                                                \
    ZEROS(ahead) ZEROS(reach) ZEROS(halfway) ZEROS(rung) ZEROS(is_awake)      \
    FILLED(moves) FILLED(island) FILLED(by_rung) FILLED(asked) FILLED(middle) \
    FILLED(turned) FILLED(lying) FILLED(began) FILLED(awake) FILLED(fresh)    \
    FILLED(going) FILLED(touches) KEPT(now)
//<

//> world-struct
//>   The world owns all tables, and lends them as `const` to the phases that
//>   only read them.
typedef struct world {
    world_options options;
    particle_pool pool;
    real *inverse_mass;     // [particles] 1/kg, when awake
    int  bodies;            // places of bodies,
    int  gone;              // and how many of them are free
    int  room;              // for so many there are tables
    int  free_place, free_entry;    // no place of a body before that one is free,
                            // and none of a shape
    int  planes, shapes, softs;     // places of planes; softs: deformable bodies
    int  plane_room, wall_room, shape_room;     // for so many there are tables
    struct body *body;
    struct plane *plane;
    material *wall;         // [planes] what each is made of
    int *owner;             // [particles] of the pool: whose they are
    bool is_damped;         // some rigid bodies are
    shape_entry *shape;     // [shapes]
    real time;              // s
    real age;               // s, a particle of a rope or cloth, and of what
                            // has come, was at `previous` so long ago
    real frame;             // s, or the part of it that is computed
    bool is_still;          // all slept when the last step ended, and nothing
                            // has been done to the world since then
    int  dynamic_bodies;    // neither static nor kinematic
    int  kinematic_bodies;
    bool has_pieces;        // some bodies have had several
    real most_gravity;      // 1, the largest share of the world's gravity that
                            // acts on a body
    bool has_substeps;      // options said how many
    rigid_tables rigid;
    linkage      joints;
    soft_solver  soft;
    sleep_state  sleep;
    step_report  report;
    ledger_entry ledger[LEDGERS];   // since the start
    ledger_entry ledger_now;        // what there is, as of the last entry
} world;
//<

//> world-declare
//>   A program makes a world, adds bodies, and steps. The rest is for the
//>   modules of the step.
// Steps of 1/60 s, friction 0.5, restitution 0.
world_options world_options_default(void);

// The substeps of a frame in which nothing asks for more: options.substeps, or
// else four, or so many that none is longer than 1/240 s.
int world_substeps(const world_options *o);

// The same in this frame, of what is stiff or of anything else.  Where options
// did not say, it is at least eight for what is stiff: rope, for the errors of a
// swing go as h^2, and cloth that hangs by pins or bears a body; and in each part
// of a divided frame.
int world_usual(const world *w, bool is_stiff);

// An empty world.  Fails, with the option's name, if one is out of range: *w is
// empty then, too, and owns nothing.
status world_init(world *w, world_options options);
void   world_free(world *w);    // at any time after world_init, or zeroed

// Adds a body to shape s, which must stay where it is while the body is there;
// its number in *number (which may be NULL).  At any time between two steps.
// Fails, adding nothing, if placement_check does, or for want of memory.
status world_add(world *w, const shape *s, placement where, int *number);

// Takes body b away.  What lay on it, or slept with it, wakes.  Its number goes
// to a body that is added later; until then it is that of a static body without
// particles (body_is_gone).
void   world_remove(world *w, int b);

// Adds a static body to shape s, with its origin at x, as a part of body `of`:
// it has that one's material, family and filter.  The part was there before, if
// not among the bodies: it wakes nothing, and nothing when it is removed.  No
// other body has the shape.  Fails as world_add does.
status world_add_part(world *w, const shape *s, vec3 x, int of, int *number);
// Removes n of them.
void   world_remove_parts(world *w, const int *part, int n);

// Adds a piece of shape s to body `of`, which is dynamic: it has that one's
// frame, moves with it, and is removed before it.  Both shapes have one weight, and
// no other body has either.  Fails, adding nothing, for want of memory.
status world_add_piece(world *w, const shape *s, int of, int *number);

// The shape of such a place.
extern const shape WORLD_NOTHING;

// Adds a half-space that bodies stay out of, x . normal < offset.  The normal
// points to the free side; it need not be a unit vector (offset is in m times
// its length).  At any time.  Fails, adding nothing: a normal without direction,
// numbers that are not finite, or 1e60 m away; for want of memory.
status world_add_plane(world *w, vec3 normal, real offset);

// The number that it gets.  A plane that is removed leaves its place to a later
// one, and stands far below everything until then.
int    world_next_plane(const world *w);
void   world_remove_plane(world *w, int k);
bool   world_has_plane(const world *w, int k);

// Particle i of the deformable body b, which wakes.
particle *world_particle(world *w, int b, int i);

// Pins particle i of the deformable body b where it is.  At any time.
void   world_pin(world *w, int b, int i);
// And lets it go.
void   world_unpin(world *w, int b, int i);

// Gives the deformable body b a stiffness against bending: of a rope in N m^2,
// of a cloth in N m, see bend.h; 0, as it is added: none.  Fails, changing
// nothing, if that is negative or not finite.
status world_bend(world *w, int b, real stiffness);

// Lets the links of the deformable body b give: of a rope, by how much a newton
// stretches a metre of it (1/N); of a cloth, a newton for each metre of its
// width (m/N).  1e-4 m/N: denim.  0, as it is added: not at all.  Fails,
// changing nothing, if that is negative or not finite.
status world_stretch(world *w, int b, real compliance);

// m/N: what the links of a cloth give by while it is pinned, if nothing else is
// said.  (Without gravity there is no weight; a rope carries more than itself.)
real world_taut(const world *w, const body *b);

// Neither static nor kinematic nor asleep.
static inline bool body_moves(const world *w, int b)
{
    return body_is_dynamic(&w->body[b]) && !w->sleep.asleep[b];
}

// s: the particles of body b were at `previous` so long ago, a substep.
static inline real body_age(const world *w, int b)
{
    return body_is_soft(&w->body[b]) ? w->age : w->rigid.age[b];
}

// m, the radius of a body; of what is thin, less (cache_width).
static inline real rigid_width(const rigid_tables *t, int b)
{
    return cache_width(&t->body[b], t->now[b].radius);
}

// s: the velocity of rigid body b is that of a moment so long ago, the middle of its
// last substep.  Gravity has gone on since then, unless contacts or joints held it.
static inline real rigid_since(const world *w, int b)
{
    return w->rigid.held[b] ? 0 : w->rigid.age[b] / 2;
}

// m/s^2, on rigid body b.
static inline vec3 body_gravity(const world *w, int b)
{
    return vec3_scale(w->body[b].gravity, w->options.gravity);
}

// Kinematic, and not at rest.
static inline bool body_is_driven(const world *w, int b)
{
    const body_drive *d = &w->rigid.drive[b];
    return w->body[b].is_kinematic
        && (vec3_length_squared(d->velocity) > 0
            || vec3_length_squared(d->spin) > 0);
}

// Wakes body b, and all that sleep with it.
void world_wake(world *w, int b);

// Around body b where it is now.
sphere world_ball(const world *w, int b);

// Wakes body b, and what sleeps near it: that may lie on it, or hang on it.
void world_wake_around(world *w, int b);

// The steps look at body b again.  It wakes, comes or changes.
void world_notice(world *w, int b);

// Pins a sleeper where it lies: the other phases only look at what moves.
void world_pin_sleeper(world *w, int b);

// Body b stands there from now on, and nothing is known of it.
void world_place(world *w, int b, const placement *where);

// A body is another than it was: it counts as new.
void world_renew(world *w, int b);

// Body a comes near body b: if one of them sleeps and the other did not lie
// still in the last frame, the sleeper wakes, in time to take its part of the
// impact, and all that sleep with it.  Returns whether it did.
bool world_wake_near(world *w, int a, int b);

// Would it?  Nothing wakes.
bool world_wakes_near(const world *w, int a, int b);

// Writes to at where the vertices of body b are now: shape->particles of them.
void   world_vertices(const world *w, const body *b, vec3 *at);

// The same for the points that are drawn of it, see shape_skin.
void   world_skin(const world *w, const body *b, vec3 *at);

//<

//> world-end-of-header
//>   The header ends.
#endif
//<
