//> linkage-head
//>   One module holds all joints of a world, and the trees that they form.
// linkage.h - all joints of a world, and the impulses that hold them.
//
// Paper: not asked.  Here all that is joined is solved at once.  The time grows with
// the number of joints for a chain or a tree (Baraff 1996), and with the square of the
// width (the frontal method, Irons 1970).  Book: chapter 17.
// Units: metres, kilograms, seconds.

#pragma once

#include "joint.h"
#include "placed.h"
//<

//> linkage-struct
//>   Each body that is joined has a small record: the mass matrix of itself and
//>   all that hangs on it, and what it needs while its tree is found.
// Joined bodies are solved at once.  If they are too wide for that, their joints are
// solved one after the other.
typedef enum { JOINT_IDLE, JOINT_ALONE, JOINT_SOLVED } joint_role;

// A body as the joints see it.
typedef struct {
    real speed[MOTIONS];    // the change of its velocity, and the impulses,
    real impulse[MOTIONS];  // while its group is solved
    solver_body end;        // where it is, and how it moves, at the end of the substep,
    motion go, last;        // with the velocity `go` now, and
    bool has_end;           // that was computed in this substep
    motion rest;            // of a group that is jolted: its motion without its joints,
    vec3 angular;           // and the angular momentum of that (kg m^2/s) about its
    bool is_jolted;         // centre
    bool is_heavy;          // its joints pull harder than a substep follows: by so
    real heavy[TURNS][TURNS];   // much more inertia it has, and so its turns
    real light[TURNS][TURNS];   // answer impulses;
    real stiff;             // (h w)^2, of its swings under these pulls, at most;
    real then[TURNS];       // how it turned when this pass began, and the
    real given[TURNS];      // impulses on its turns since; those of them that
    real kick[TURNS];       // no other body gave
    int  united;            // union-find: another body that is joined to it
    int  first, left;       // the first joint of its list; how many are still to solve
    int  step;              // the step that has it in its front; -1: none yet
    int  place;             // its place in `order`; -1: none
    long seen;              // the last frame in which it was joined
} linkage_body;

// Bodies that are joined to each other, and the steps that solve their joints.
typedef struct {
    int  first, end;            // in `step`
    int  first_body, end_body;  // in `order`
    bool is_ready;          // its matrices are computed
    bool is_solved;         // it was solved before this move
    bool is_settled;        // nothing is left to solve
    bool is_limited;        // some joint has a limit
    bool is_heavy;          // some body is_heavy
    bool is_jolted;         // it brings bodies together that are far apart
} linkage_group;

// One step solves a joint.  Its bodies, and those of the fronts of earlier steps that
// it brings together, become one front; of these, bodies with joints left stay in it.
typedef struct {
    int joint;
    int a, b;               // its bodies; -1: immovable
    int from[2];            // the steps whose fronts it brings together; -1: none
    int first, count;       // in `reach`: the bodies that stay
    int block;              // the first of their count^2 blocks
} linkage_step;

// A body that stays in a front.
typedef struct {
    int  body;
    real answer[JOINT_ROWS][MOTIONS];   // its motion after a unit impulse along a row
                                        // of the joint, and
    real back[JOINT_ROWS][MOTIONS];     // the impulse of the joint for a unit impulse
                                        // on the body
} linkage_reach;

// The motion of one body of a front after unit impulses on another, or on itself: an
// inverse mass matrix.
typedef struct {
    real of[MOTIONS][MOTIONS];
} linkage_block;

typedef struct {
    joint      *joint;      // [count] JOINT_NONE: a free place
    joint_rows *rows;       // [count]
    joint_role *role;       // [count]
    linkage_step *step;     // [steps] in the order of the solve,
    linkage_group *group;   // [groups] by what is joined,
    int        *order;      // [bodies] with the bodies of each
    linkage_reach *reach;   // [reaches]
    linkage_block *block;   // [blocks]
    long long  *apart;      // [aparts] pairs of rigid bodies that do not collide,
    int         aparts;
    body_tie *tied;         // [ties] and pairs of a rope or cloth and a rigid body
    int  ties, tie_room;
    int  count, capacity, gone;     // gone: free places
    int  steps, groups, reaches, blocks;
    int  reach_room, block_room;
    linkage_body *body;     // [bodies]
    int  bodies;
    bool is_plain;          // for measurements: all joints are solved one by one
    long frames;            // how many have begun
    bool is_driven;         // a joint of this solve has a motor or a spring
    bool is_stale;          // a joint broke in this frame
    bool is_backward;       // joints that stand alone are solved last to first
    int  broken;            // joints that broke since this was set to 0
    real swing;             // rad/s, the fastest swing about a joint in the last
                            // substep
    real worst;             // m, the largest gap of a joint
    int  parted;            // joints with a gap of a hundredth of a body's radius, or
                            // off by a hundredth of a radian
} linkage;
//<

//> linkage-declare
//>   The order of a substep is written into the declarations: warm start, push,
//>   move, relax.
// A zeroed one is empty.
void linkage_free(linkage *l);

// Adds a joint.  Its number goes to *number, which may be NULL.  Fails, adding nothing,
// if memory is refused.
status linkage_add(linkage *l, const joint *j, int *number);

// Counts the pins of each pair again, after one has broken.  A pair stays tied until
// one of the next two functions ends that.
void linkage_count_pins(linkage *l);

// Forgets tie k, which has no pins; the last tie takes its number.
void linkage_untie(linkage *l, int k);

// Forgets all ties of body b, which is gone.
void linkage_untie_body(linkage *l, int b);

// Removes a joint.  Its number goes to a later one.
void linkage_remove(linkage *l, int number);

// Was body b joined to something when this frame began?
static inline bool linkage_has(const linkage *l, int b)
{
    return b < l->bodies && l->body[b].seen > 0
        && l->body[b].seen >= l->frames;
}

// Sorts the pairs of joined bodies that must not collide; until joints change, the
// second function says whether a pair is one of them.
void linkage_find_apart(linkage *l);
bool linkage_keeps_apart(const linkage *l, int a, int b);

// The impulses of the joints in a frame, and in each of its substeps.
// velocity and moved are as solver.h has them.
typedef struct {
    const solver_frame *f;
    motion *velocity;
    const motion *moved;
    const char *rung;                   // [bodies] the joints of those with
    char of;                            // rung[b] == of; NULL: all
} linkage_pass;

// Begins a frame, in which no body has moved yet.
void linkage_prepare(linkage *l, const linkage_pass *q);

// Sets the impulses of joint k to 0, and its force if that is not finite, after a frame
// in which numbers were lost.  With such impulses its bodies would be stopped in every
// frame to come.
void linkage_forget_impulses(linkage *l, int k);

// Remembers the state before a substep that may have to be done again; and restores it,
// once the bodies are back.
void linkage_mark(linkage *l);
void linkage_rewind(linkage *l, const linkage_pass *q);

// Multiplies all impulses, when the next substep is so many times as long.
void linkage_scale(linkage *l, real times);

// One substep, in this order.  Warm starting: gives every body the impulses of the last
// substep.
void linkage_begin(linkage *l, const linkage_pass *q);

// Finds the impulses with which the joints are together at the end of the substep:
// before the contacts push, mostly with one solve, and after them (is_last) until all
// is exact, so that an impact pulls no joint apart.
void linkage_push(linkage *l, const linkage_pass *q, bool is_last);

// Moves a joined body.
void linkage_advance(linkage *l, const linkage_pass *q, int b, solver_body *now);

// After the bodies have moved: makes rows from where they are now, takes back the speed
// with which errors were corrected, and breaks joints that had to bear too much.
void linkage_relax(linkage *l, const linkage_pass *q);

// Which bodies are joined, directly or through others that yield?  To be called after
// the substeps of a frame.
void linkage_unite(linkage *l, const linkage_pass *q);
bool linkage_unites(linkage *l, int a, int b);
//<
