//> linkage-head
//>   One module holds all joints of a world, and the trees that they form.
// linkage.h - all joints of a world, and the impulses that hold them.
//
// Paper: not asked.  Here: all that is joined at once, in time that grows with the
// number of joints if it is a chain or a tree (Baraff 1996), and with the square of
// its width (the frontal method, Irons 1970).  Book: chapter 17.
// Units: metres, kilograms, seconds.

#pragma once

#include "joint.h"
#include "placed.h"
//<

//> linkage-struct
//>   Each body that is joined has a small record: the mass matrix of itself and
//>   all that hangs on it, and what it needs while its tree is found.
// What is joined is solved at once, unless it is too wide for that: then its joints
// are solved one after the other.
typedef enum { JOINT_IDLE, JOINT_ALONE, JOINT_SOLVED } joint_role;

// A body as the joints see it.
typedef struct {
    real speed[MOTIONS];    // the change of its velocity, and the impulses,
    real impulse[MOTIONS];  // while its group is solved
    solver_body end;        // how it will stand and go at the end of the
    motion go, last;        // substep, if it goes like this now, and
    bool has_end;           // that was asked in this substep
    motion rest;            // how it goes without its joints, of a group that is
    vec3 angular;           // jolted; kg m^2/s, its spin in that, about its
    bool is_jolted;         // centre
    bool is_heavy;          // its joints pull harder than a substep follows: by so
    real heavy[TURNS][TURNS];   // much more inertia it has, and so its turns
    real light[TURNS][TURNS];   // answer impulses;
    real stiff;             // (h w)^2, of its swings under these pulls, at most;
    real then[TURNS];       // how it turned when this pass began, and the
    real given[TURNS];      // impulses on its turns since; those of them that
    real kick[TURNS];       // no other body gave
    int  united;            // union-find: another body that hangs on it
    int  first, left;       // a joint of its list; so many are not solved yet
    int  step;              // that has it in its front; -1: none yet
    int  place;             // in `order`; -1: in none
    long seen;              // the last frame in which it is joined
} linkage_body;

// Bodies that are joined to each other, and the steps that solve their joints.
typedef struct {
    int  first, end;            // in `step`
    int  first_body, end_body;  // in `order`
    bool is_ready;          // matrices are made;
    bool is_solved;         // it was solved before this move;
    bool is_settled;        // nothing is left to be solved;
    bool is_limited;        // some joint has a limit
    bool is_heavy;          // its bodies are;
    bool is_jolted;         // it brings together what is far apart
} linkage_group;

// A joint is solved, and with it the bodies that earlier steps have brought together
// with its own are one front.  Of them those stay that have joints left.
typedef struct {
    int joint;
    int a, b;               // its bodies; -1: one that does not move
    int from[2];            // the steps whose fronts it brings together; -1: none
    int first, count;       // in `reach`: those that stay
    int block;              // the first of their count^2 blocks
} linkage_step;

// One of them.
typedef struct {
    int  body;
    real answer[JOINT_ROWS][MOTIONS];   // how a unit impulse along a row of the
                                        // joint moves it, and
    real back[JOINT_ROWS][MOTIONS];     // what the joint gives more for a unit
                                        // impulse on it
} linkage_reach;

// How one of a front answers impulses on another, or on itself: one over its mass.
typedef struct {
    real of[MOTIONS][MOTIONS];
} linkage_block;

typedef struct {
    joint      *joint;      // [count] JOINT_NONE: a place for the next one
    joint_rows *rows;       // [count]
    joint_role *role;       // [count]
    linkage_step *step;     // [steps] what is solved, in this order;
    linkage_group *group;   // [groups] of them those that are joined;
    int        *order;      // [bodies] theirs
    linkage_reach *reach;   // [reaches]
    linkage_block *block;   // [blocks]
    long long  *apart;      // [aparts] pairs of rigid bodies that do not meet
    int         aparts;
    body_tie *tied;         // [ties] and of a deformable and a rigid one
    int  ties, tie_room;
    int  count, capacity, gone;     // gone: places that are free
    int  steps, groups, reaches, blocks;
    int  reach_room, block_room;
    linkage_body *body;     // [bodies]
    int  bodies;
    bool is_plain;          // all is solved joint by joint: to measure
    long frames;            // so many began
    bool is_driven;         // one of those that are solved now is driven
    bool is_stale;          // one broke in this frame
    bool is_backward;       // joints that stand alone come last to first
    int  broken;            // so many, since this was set to 0
    real swing;             // rad/s, of the fastest swing about a joint in the
                            // last substep, which must follow it
    real worst;             // m, by which a joint's points are apart
    int  parted;            // joints apart by a hundredth of a body's radius, or
                            // of a radian
} linkage;
//<

//> linkage-declare
//>   The order of a substep is written into the declarations: warm start, push,
//>   move, relax.
// A zeroed one is empty.
void linkage_free(linkage *l);

// Adds a joint; its number in *number (which may be NULL).  Fails, adding
// nothing, for want of memory.
status linkage_add(linkage *l, const joint *j, int *number);

// Counts again what is pinned to what, after one has broken.  What was pinned
// stays tied until one of the next two says otherwise.
void linkage_count_pins(linkage *l);

// Forgets tie k, which has no pins; the last tie takes its number.
void linkage_untie(linkage *l, int k);

// Forgets all ties of body b, which is gone.
void linkage_untie_body(linkage *l, int b);

// Takes a joint away.  Its number goes to a later one.
void linkage_remove(linkage *l, int number);

// Was body b joined to something when this frame began?
static inline bool linkage_has(const linkage *l, int b)
{
    return b < l->bodies && l->body[b].seen > 0
        && l->body[b].seen >= l->frames;
}

// Sorts the pairs of bodies that are joined, and must not touch.  Until there are
// others: is that one of them?
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

// A frame begins: bodies stand as f says, and have not been moved.
void linkage_prepare(linkage *l, const linkage_pass *q);

// Joint k starts cold in the next frame: after one in which numbers were lost.
// Impulses that are none would stop its bodies again, in every frame to come.  A
// force that is no number is 0.
void linkage_forget_impulses(linkage *l, int k);

// Before a substep that may have to be done again; and to do it again, when the
// bodies stand where they did.
void linkage_mark(linkage *l);
void linkage_rewind(linkage *l, const linkage_pass *q);

// The next substep is so many times as long: its impulses are, too.
void linkage_scale(linkage *l, real times);

// A substep, in this order.  Gives every body the impulses of the last substep
// (warm starting);
void linkage_begin(linkage *l, const linkage_pass *q);

// brings the joints together by its end: before the contacts push, mostly by one
// solve, and to the last after them, so that an impact pulls no joint apart;
void linkage_push(linkage *l, const linkage_pass *q, bool is_last);

// puts a joined body where it goes;
void linkage_advance(linkage *l, const linkage_pass *q, int b, solver_body *now);

// after the bodies have moved: the rows for where they stand now; takes back
// the speed by which errors went; and breaks what had to bear too much.
void linkage_relax(linkage *l, const linkage_pass *q);

// Which bodies hang together by joints, over others that yield?  To be asked after
// the substeps of a frame.
void linkage_unite(linkage *l, const linkage_pass *q);
bool linkage_unites(linkage *l, int a, int b);
//<
