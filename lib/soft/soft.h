//> soft-head
// soft.h - cloth and rope: their part of a frame, and of its substeps.
//
// Paper: sections 5.2 and 6.1.  Book: chapter 16.

#pragma once

#include "bend.h"
#include "certificate.h"
#include "touch.h"
//<

//> soft-struct
//>   What is kept from frame to frame.
// The tables that ropes and cloths keep from frame to frame, and the counts of a frame.
typedef struct {
    near_lists near;
    certificate proof;
    rigid_view view;
    prediction *ahead;  // [bodies] how each may move in this frame
    bool *held;         // [bodies] it is pinned, or hangs on something
    int  *sweeps;       // [bodies] the fewest sweeps over strands of held cloth
    sunk_state *sunk;   // [bodies] of ropes and cloths
    real *fallen;       // [bodies] kg m^2, the sum of m move^2 of a sunk one, as
                        // this substep fell
    vec3 *owed;         // [bodies] kg m^2, see owe_angular
    line_hold *hold;    // [particles] the immovable thing that each touches
    bend_row *bends;    // [rows] of the longest strand
    int  bodies, particles, rows;       // for so many there is room
    real pressed;       // 1/s, the substeps that layers asked for in this frame,
    real pace;          // 1/s, and those that they get
    int  frames;        // for so many frames they have asked for fewer
    bool is_backward;   // points at rigid bodies are solved last to first

    int  touching;      // parted in the last substep
    long tested;        // sticks looked at
    long relaxed;       // sticks moved
    int  fell_back;     // strands that turned too far in a substep
} soft_solver;
//<

//> soft-declare
//>   The five phases are functions of their own.
// Makes room for the new body b of `all`, when there are so many bodies and particles.
// Costs nothing before there is a rope or cloth.  Fails, adding nothing, if memory is
// refused.
status soft_add(soft_solver *s, const body *all, int b, int bodies,
                int particles);
void   soft_free(soft_solver *s);       // an empty or zeroed one is fine

// Forgets what is kept of body b, because it was put elsewhere; or removes it, too.
void soft_forget(soft_solver *s, int b);
void soft_remove(soft_solver *s, const body *all, int b);

// Takes nothing for granted in the next frame, because a plane was added.
void soft_doubt(soft_solver *s);

// Begins a frame, after the predictions of rigid bodies: finds where ropes and cloths
// are, and how far they may move.  `held` says which hang on something.
void soft_begin(soft_solver *s, const soft_frame *f);

// May the rope or cloth a touch body b in this frame?
bool soft_may_touch(const soft_solver *s, int a, int b);

// After soft_begin: may any rope or cloth meet rigid body b in this frame, if no speed
// more than doubles?
bool soft_may_meet(const soft_solver *s, int b);

// The number of substeps that this frame needs for ropes and cloths, and for what they
// may meet.
int soft_substeps(const soft_solver *s, const soft_frame *f);

// One substep, in this order.  Moves the particles, and lets bends straighten.
void soft_move(soft_solver *s, const soft_frame *f);

// Relaxes the diagonals of cloth.
void soft_draw(soft_solver *s, const soft_frame *f);

// Parts particles from planes, from each other and from rigid bodies, which take
// impulses where they are: at f->now, moved by f->moved.
void soft_separate(soft_solver *s, const soft_frame *f);

// Relaxes the strands, together with the immovable things that they touch.
void soft_relax(soft_solver *s, const soft_frame *f);

// Parts facets from rigid bodies to which strands have drawn them, with the weight of
// all that they hang on.
void soft_hold(soft_solver *s, const soft_frame *f);

// Lets bodies that began inside of something come out of it without being thrown: all
// particles of such a body together get no faster than it fell.
void soft_calm(const soft_solver *s, const soft_frame *f);

// J, the energy stored in the bends and links of a rope or cloth.
real soft_energy(const body *b, const particle *all);

// After the substeps: proves that nothing crosses, and parts what would.
void soft_certify(soft_solver *s, const soft_frame *f);

// The number of ropes and cloths that must not give and have strands off by more than a
// hundredth, are deep in what they began in, or are cut by a rigid body.
int soft_unconverged(const soft_solver *s, const soft_frame *f);
//<
