//> linkage-head
//>   One module holds all joints of a world, and the trees that they form.
// linkage.h - all joints of a world, and the impulses that hold them.
//
// Paper: not asked.  Here: chains and trees of bodies at once (Baraff 1996),
// what closes a ring one by one.  Book: chapter 17.
// Units: metres, kilograms, seconds.

#ifndef TUMBLE_LINKAGE_H
#define TUMBLE_LINKAGE_H

#include "joint.h"
#include "placed.h"
//<

//> linkage-struct
//>   Each body that is joined has a small record: the mass matrix of itself and
//>   all that hangs on it, and what it needs while its tree is found.
// Does a joint hang by itself on the world, or join two bodies of a tree?  All
// others are solved one after the other.
typedef enum { JOINT_IDLE, JOINT_ALONE, JOINT_ANCHOR, JOINT_BRANCH } joint_role;

// A body as the joints see it.
typedef struct {
    real answer[MOTIONS][MOTIONS];  // to impulses, with all that hangs on it:
                                    // one over its mass, in all directions
    real speed[MOTIONS];    // the change of its velocity, and the impulses,
    real impulse[MOTIONS];  // while its tree is solved
    solver_body end;        // how it will stand and go at the end of the
    motion go, last;        // substep, if it goes like this now, and
    bool has_end;           // that was asked in this substep
    motion rest;            // how it goes without its joints, of a tree that is
    vec3 angular;           // jolted; kg m^2/s, its spin in that, about its
    bool is_jolted;         // centre
    int  group;             // union-find: a body of its tree
    int  first;             // of that body: the first joint of the tree
    bool is_ready;          // of the root: matrices are made;
    bool is_solved;         // it was solved before this move;
    bool is_settled;        // nothing is left to be solved;
    bool is_limited;        // some joint has a limit
    int  branches, one;     // not yet followed; the last, if there is one
    bool is_done;
    long seen;              // the last frame in which it is joined
} linkage_body;

// From the tips of a tree to its root: a body, -1 if it cannot move, and the
// joint that leads on to the next one.
typedef struct {
    int body, joint, on;    // joint = -1: it is the root
} linkage_step;

typedef struct {
    joint      *joint;      // [count] JOINT_NONE: a place for the next one
    joint_rows *rows;       // [count]
    joint_role *role;       // [count]
    linkage_step *step;     // [2 count]
    long long  *apart;      // [aparts] pairs of rigid bodies that do not meet
    int         aparts;
    body_tie *tied;         // [ties] and of a deformable and a rigid one
    int  ties, tie_room;
    int  count, capacity, gone, steps;  // gone: places that are free
    linkage_body *body;     // [bodies]
    int  bodies;
    bool is_plain;          // trees, too, are solved joint by joint: to measure
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

#endif
//<
