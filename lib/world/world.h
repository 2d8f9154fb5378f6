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

#pragma once

#include "cache.h"
#include "linkage.h"
#include "sleep.h"
#include "soft.h"

// The functions that the program around a world lends it; each may be NULL.
typedef struct {
    real (*clock)(void);    // the time (s), to measure the phases with
    tasks run;              // threads; see task.h
    // Called in each part of a frame, once `ahead` says how far bodies move in it.
    // Adds and removes parts of surfaces (world_add_part), and returns whether it
    // has added any.
    bool (*surround)(void *surroundings);
    // Called after that part of the frame, by several threads at once: does the
    // centre of body b, on its way between these two points, go in through a face
    // of those parts?  The first such face goes to *side.
    bool (*enters)(void *surroundings, int b, vec3 from, vec3 to, plane *side);
    void *surroundings;
    // Shall the bodies of this contact push each other in this part of a frame?
    // NULL: all do.
    bool (*meets)(void *chooser, const contact *c);
    void *chooser;
} world_host;

// The most substeps of a frame: of all its parts, and of those that are done again.
enum { ALL_SUBSTEPS = 10000 };

typedef struct {
    real dt;            // s, a frame: one call of world_step; at most 1
    int  substeps;      // the fewest of a frame, 1 to ALL_SUBSTEPS; 0:
                        // world_substeps chooses when the world is made
    int  most_substeps; // the most that a frame takes for loads, swings and
                        // cloth; of a frame in parts, of all parts together
    vec3 gravity;       // m/s^2
    real friction;      // Coulomb's coefficient, >= 0
    real restitution;   // 0 to 1, speed after an impact / speed before: of rigid
                        // bodies, and of cloth and rope at static bodies
    real hertz;         // 1/s, the stiffest spring of a contact; a substep of h
                        // allows 1 / (8 h).  The lower it is, the softer
                        // bodies land, and the deeper they overlap
    real stay;          // radii: a rigid body that has moved no further since its
                        // contacts were found keeps them; 0: they are found in
                        // every frame
    bool warm_start;    // contacts begin with the impulses of the last frame
    real sleep_speed;   // m/s, slower bodies fall asleep; 0: none does.  It is
                        // the speed for a radius of half a metre under 9.81
                        // m/s^2, see sleep.h
    real time_to_sleep; // s, for so long a whole island must have been slow
    bool certified;     // cloth never crosses cloth, see certificate.h
    int  iterations;    // the most over a cloth's columns and rows in a substep,
                        // 1 to 10000
    relax_options relax;    // of a cloth's links
    bool ledger;        // book what gives and takes energy
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
    int  substeps;      // of the island that took most; 0: all bodies sleep, and
                        // nothing was done
    int  pairs;         // pairs of rigid bodies that may meet
    int  queries;       // pairs of bodies, or body and plane, that were asked
    int  contacts;      // of two rigid bodies, or of a body and a plane,
    int  pushing;       // and how many of them pushed in the last substep
    int  near;          // pairs of particles, or of particle and body, in the list
    int  touching;      // and how many of them, and of particles and planes, were
                        // pushed in the last substep
    int  rebuilt;       // how often that list was made
    long tested;        // sticks whose length was tested
    long relaxed;       // sticks that were moved
    int  fell_back;     // strands that turned too far in a substep
    int  asleep;        // bodies that sleep
    int  unconverged;   // contacts that overlap by more than a tenth of the
                        // smaller radius, joints apart by a hundredth of it or
                        // of a radian, and ropes and cloths with a link that is
                        // off by a hundredth
    int  lost;          // bodies whose numbers were not finite after a part of
                        // the frame, and that were stopped: should be 0
    int  cut;           // parts of the frame with fewer substeps than the options
                        // ask for, because of ALL_SUBSTEPS: should be 0
    int  prevented;     // pairs of facets of cloth that were kept from crossing,
    int  crossed;       // and pairs that cross, as when the frame began
    int  dropped;       // contacts or pairs that found no memory: should be 0
    int  broken;        // joints that had to bear more than their strength
    real parted;        // m, the largest gap between the points of a joint
} step_report;
//<

//> ledger-struct
//>   Each phase books the energy and momentum that it gave.
// Where energy and momentum come from, and go to: gravity and motion, contacts with
// their friction, sticks, falling asleep.
enum { LEDGER_INTEGRATE, LEDGER_CONTACTS, LEDGER_STICKS, LEDGER_SLEEP,
       LEDGERS };

typedef struct {
    real energy;        // J
    vec3 momentum;      // kg m/s
    vec3 angular;       // kg m^2/s, about the origin
} ledger_entry;
//<

//> world-tables
// A shape in use, and what all bodies of that shape have in common.
typedef struct {
    const struct shape *shape;
    int  bodies;        // how many are made of it; 0: the entry is free
    rigid4 *rigid;      // NULL unless rigid
    real inner;         // m, see shape_inner
    line_scratch *line; // NULL unless deformable
} shape_entry;

// The force and torque from outside on a body, all through the next frame.
typedef struct {
    vec3 force, torque; // N, N m
} body_load;

// The impulse that a contact gave in a frame, and where it began.
typedef struct {
    int  a, b;          // as a contact has them
    vec3 point, normal;
    real impulse;       // N s
} heard_impulse;

// How a kinematic body moves.
typedef struct {
    vec3 velocity, spin;        // m/s, rad/s
} body_drive;

// The number of substeps of an island.
typedef struct {
    int now;            // in a frame
    int frames;         // for so many frames fewer would have been enough
} substep_choice;

// An island: bodies that push each other or are joined, and what decides how many
// substeps they take.  It is named by one of its bodies.  A driven body belongs to
// none, because nothing passes through it from one island to the next.
typedef struct {
    int  parent;        // union-find: a body of the same island
    int  ground;        // the driven body that it touches; -1: none
    bool rests;         // it touches something at rest, or is joined to it
    real lift;          // N m/s, of all contacts that bear this one body
    real pulls;         // N, gravity and forces from outside, summed over bodies
    vec3 carried;       // N, from planes, static and driven bodies
    real weight;        // 1/s^2, the largest weight on a contact / (effective
                        // mass, smaller width)
    real squares;       // 1/s^4, the sum of squares of the same for loads,
    int  bears;         // over so many contacts
    real low, high;     // m, how far its bodies reach along gravity
    real inner, width;  // m, the sums of their inner radii and their widths
    real largest;       // m, the largest radius of its bodies
    int  bodies;        // how many there are
    real pace;          // rad/s, of the fastest swing about its joints
    real lasts;         // s, in which a spring would bring it home at its speed
    bool rubs;          // one of its contacts presses
    bool hangs;         // it has joints, ropes or cloths
    bool is_soft;       // it has ropes or cloths
    bool is_calm;       // no body of it flies
    bool is_fast;       // a body moves by its inner radius in a frame
    real turn;          // rad, the largest turn of a body in the frame
    int  substeps;
    real energy, mass;  // J, kg, of the bodies that touch something
    vec3 momentum;      // kg m/s, likewise
    real loads;         // J, that forces from outside would give
    real drives;        // J^(1/2), the sum of the roots of what motors and springs
                        // would give
    real most;          // J, that it may have when the frame ends, see guard.h
    bool is_lost;       // some of its numbers are wrong, or not finite
} island;

// A rung: islands that take about the same number of substeps.  Their bodies are
// by_rung[first] to before by_rung[end], and their contacts likewise.
typedef struct {
    int substeps;
    int first, end, first_contact, end_contact;
    bool is_soft;       // it has all ropes and cloths: they share one time
    bool hangs;         // it has joints
} rung;

// Each rung has a quarter more substeps than the one below.
enum { RUNGS = 16 };    // tuned, rungs

// Rigid bodies in a frame, with a table for each phase: where they are -> which may
// meet -> where they touch -> what impulses part them -> how far they move.  A rope
// or cloth has a place in these tables, too; there it is immovable, and its ball has
// a negative radius.
typedef struct {
    const struct body *body;    // [bodies] the world's
    char        *dynamic;   // [bodies] it is rigid, and not static,
    char        *moves;     // [bodies] and neither asleep, nor kinematic and at
                            // rest
    solver_body *now;       // [bodies] where it is now
    sphere      *ball;      // [bodies]
    prediction  *ahead;     // [bodies]
    real        *reach;     // [bodies] of ahead
    real        *age;       // [bodies] s, see body_age
    real        *halfway;   // [bodies] s, see ledger_halfway
    motion_basis *lying;    // [bodies] see solver_frame
    rigid_frame *asked;     // [bodies] see cache_frame
    rigid_frame *middle;    // [bodies] where its rows are made, see advance.c
    real        *turned;    // [bodies] m, see ahead.c
    rigid_frame *began;     // [bodies] where it was when the substeps began
    int         *awake;     // [awakes] the bodies that a step goes over, by number:
    int          awakes;    // those that move, and those that may by now
    char        *is_awake;  // [bodies] it is in that list
    bool         has_noticed;           // some bodies are still to be added to it
    motion      *velocity;  // [motions] see solver.h
    motion      *moved;     // [motions] since it got its frame and basis
    char        *fresh;     // [bodies] it got them in the last substep
    char        *going;     // [bodies] see advance.c
    char        *touches;   // [bodies] it moves, and has contacts or joints
    real elapsed, elapsed_then;         // s, since the substeps began
    int          motions;
    solver_body *now_then;  // [bodies] as they were before this substep, in case
    motion *velocity_then, *moved_then;         // that it has to be done again
    char        *held;      // [bodies] contacts or joints held it in the last substep
    body_load   *load;      // [bodies]
    bool is_loaded;         // some loads are not 0
    material    *material;  // [bodies] of ropes and cloths, too
    body_drive  *drive;     // [bodies]
    substep_choice *choice; // [bodies] of the island that it was in last
    island      *island;    // [bodies]
    char        *rung;      // [bodies]
    int         *by_rung;   // [awakes] first the driven bodies, then those of one
    int          drivens;   // rung after the other
    rung         rungs[RUNGS];
    char         on_rung;   // the rung that is solved now
    pair_list      pairs;
    bool           is_new_list;         // of pairs
    contact_cache  cache;
    contact_solver solver;
    bool         listens;   // impulses of contacts are written down:
    heard_impulse *heard;   // [hears] those of the last frame
    int          hears, heard_room;
    int          heard_from;            // where contacts of this rung begin in
                                        // it; < 0: they are not in it yet
} rigid_tables;

// The tables with a place for each body: those that a saved world keeps, those that
// must be zeros where a frame begins, and those that a step fills before it reads them.
#define RIGID_TABLES(KEPT, ZEROS, FILLED)                                     \
    KEPT(dynamic) KEPT(ball) KEPT(age) KEPT(choice) KEPT(held) KEPT(load)     \
    KEPT(material) KEPT(drive)                                                \
    ZEROS(ahead) ZEROS(reach) ZEROS(halfway) ZEROS(rung) ZEROS(is_awake)      \
    FILLED(moves) FILLED(island) FILLED(by_rung) FILLED(asked) FILLED(middle) \
    FILLED(turned) FILLED(lying) FILLED(began) FILLED(awake) FILLED(fresh)    \
    FILLED(going) FILLED(touches) FILLED(now_then) FILLED(velocity_then)      \
    FILLED(moved_then) KEPT(now)
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
    int  room;              // the tables of bodies have so many places
    int  free_place, free_entry;    // no place of a body, or of a shape, before
                            // these is free
    int  planes, shapes, softs;     // places of planes and shapes; ropes and cloths
    int  plane_room, wall_room, shape_room;     // their tables have so many places
    struct body *body;
    struct plane *plane;
    material *wall;         // [planes] the material of each
    int *owner;             // [particles] the body of each
    bool is_damped;         // some rigid bodies are damped
    shape_entry *shape;     // [shapes]
    real time;              // s
    real age;               // s ago, particles of ropes, cloths and new bodies were
                            // at `previous`
    real frame;             // s, the frame, or the part of it that is computed
    bool is_still;          // all bodies slept when the last step ended, and the
                            // world has not been changed since then
    int  dynamic_bodies;    // neither static nor kinematic
    int  kinematic_bodies;
    bool has_pieces;        // some bodies have had several pieces
    real most_gravity;      // 1, the largest gravity scale of a body
    bool has_substeps;      // the options said how many
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

// The substeps of a frame in which nothing asks for more: options.substeps if it is
// not 0, else four, or as many as keep each at 1/240 s or less.
int world_substeps(const world_options *o);

// The same for this frame, of stiff bodies or of others.  If the options do not say,
// it is at least eight for stiff ones, in each part of a divided frame as well: for
// rope, because the errors of a swing go as h^2, and for cloth that hangs by pins or
// bears a body.
int world_usual(const world *w, bool is_stiff);

// An empty world.  Fails, with the option's name, if one is out of range: *w is
// empty then, too, and owns nothing.
status world_init(world *w, world_options options);
void   world_free(world *w);    // at any time after world_init, or zeroed

// Adds a body of shape s, which must stay where it is as long as the body exists, at
// any time between two steps.  Its number goes to *number, which may be NULL.
// Fails, adding nothing, if placement_check fails or memory is refused.
status world_add(world *w, const shape *s, placement where, int *number);

// Removes body b.  Bodies that lay on it, or slept with it, wake.  Its number goes
// to a body that is added later; until then it stands for a static body without
// particles (body_is_gone).
void   world_remove(world *w, int b);

// Adds a static body of shape s, with its origin at x, as a part of the surface
// `of`, whose material, family and filter it has.  Nothing wakes when a part comes
// or goes, for the surface was there before.  No other body may have the shape.
// Fails as world_add does.
status world_add_part(world *w, const shape *s, vec3 x, int of, int *number);
// Removes n of them.
void   world_remove_parts(world *w, const int *part, int n);

// Adds a piece of shape s to the dynamic body `of`: it has that body's frame, moves
// with it, and must be removed before it.  Both shapes have the weight of the whole
// body, and no other body may have them.  Fails, adding nothing, if memory is refused.
status world_add_piece(world *w, const shape *s, int of, int *number);

// The shape of a place whose body is gone.
extern const shape WORLD_NOTHING;

// Adds a half-space that bodies stay out of, x . normal < offset, at any time.  The
// normal points to the free side, and may have any length > 0; offset is in metres
// times that length.  Fails, adding nothing, if the normal has no direction, a number
// is not finite, the plane is 1e60 m away, or memory is refused.
status world_add_plane(world *w, vec3 normal, real offset);

// The number that the next plane gets.  A plane that is removed leaves its place to a
// later one; until then the place holds a plane far below everything.
int    world_next_plane(const world *w);
void   world_remove_plane(world *w, int k);
bool   world_has_plane(const world *w, int k);

// Particle i of the deformable body b, which wakes.
particle *world_particle(world *w, int b, int i);

// Pins particle i of the rope or cloth b where it is, at any time; and lets it go.
void   world_pin(world *w, int b, int i);
void   world_unpin(world *w, int b, int i);

// Gives the rope (N m^2) or cloth (N m) b a stiffness against bending, see bend.h.
// It is 0 at first.  Fails, changing nothing, if that is negative or not finite.
status world_bend(world *w, int b, real stiffness);

// Lets the links of the rope or cloth b give: by how many metres a newton stretches a
// metre of a rope (1/N), or a newton on each metre of its width a metre of a cloth
// (m/N; 1e-4 is denim).  It is 0 at first.  Fails, changing nothing, if that is
// negative or not finite.
status world_stretch(world *w, int b, real compliance);

// m/N, by which the links of a pinned cloth give if no stretch was set; 0 without
// gravity, and of a rope.
real world_taut(const world *w, const body *b);

// Neither static nor kinematic nor asleep.
static inline bool body_moves(const world *w, int b)
{
    return body_is_dynamic(&w->body[b]) && !w->sleep.asleep[b];
}

// s, a substep: so long ago the particles of body b were at `previous`.
static inline real body_age(const world *w, int b)
{
    return body_is_soft(&w->body[b]) ? w->age : w->rigid.age[b];
}

// m, the radius of a body; less of a thin one (cache_width).
static inline real rigid_width(const rigid_tables *t, int b)
{
    return cache_width(&t->body[b], t->now[b].radius);
}

// s: the velocity of rigid body b is that of so long ago, in the middle of its last
// substep.  Since then gravity has acted on it, unless contacts or joints held it.
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

// Wakes body b, and all bodies that sleep with it.
void world_wake(world *w, int b);

// The bounding sphere of body b, where it is now.
sphere world_ball(const world *w, int b);

// Wakes body b and the sleepers near it, which may lie on it or hang on it.
void world_wake_around(world *w, int b);

// From now on steps go over body b again, because it wakes, comes or changes.
void world_notice(world *w, int b);

// Makes a sleeper immovable, as the other phases expect.
void world_pin_sleeper(world *w, int b);

// Puts body b at `where`, and forgets what was known of it.
void world_place(world *w, int b, const placement *where);

// Body b has changed: it counts as new.
void world_renew(world *w, int b);

// Body a comes near body b.  If one of them sleeps, and the other did not lie still
// in the last frame, the sleeper wakes with all that sleep with it, in time for the
// impact.  Returns whether it woke.
bool world_wake_near(world *w, int a, int b);

// The sleeper that world_wake_near would wake; -1: none.
int world_sleeper_near(const world *w, int a, int b);

// Writes where the vertices of body b are now: at[shape->particles].
void   world_vertices(const world *w, const body *b, vec3 *at);

// The same for the points by which it is drawn, see shape_skin.
void   world_skin(const world *w, const body *b, vec3 *at);
//<
