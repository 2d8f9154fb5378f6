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
// What cloth and rope keep from frame to frame, and what a frame counts.
typedef struct {
    near_lists near;
    certificate proof;
    rigid_view view;
    prediction *ahead;  // [bodies] how each may move in this frame
    bool *held;         // [bodies] by nails, or by what it hangs on
    int  *sweeps;       // [bodies] that strands of held cloth take at least
    sunk_state *sunk;   // [bodies] of deformable ones
    real *fallen;       // [bodies] kg m^2, the sum of m move^2 of a sunk one, as
                        // this substep fell
    line_hold *hold;    // [particles] what each touches that does not move
    bend_row *bends;    // [rows] of the longest strand
    int  bodies, particles, rows;       // for so many there is room
    real pressed;       // 1/s, substeps that layers asked for in this frame,
    real pace;          // 1/s, and that they get
    int  frames;        // for so many they have asked for fewer
    bool is_backward;   // points at rigid bodies come last to first

    int  touching;      // parted in the last substep
    long tested;        // sticks looked at
    long relaxed;       // sticks moved
    int  fell_back;     // strands that turned too far in a substep
} soft_solver;
//<

//> soft-declare
//>   The five phases are functions of their own.
// Body b of `all` is new; there are so many now, with so many particles in the
// pool.  Costs nothing before one is deformable.  Fails, adding nothing, for
// want of memory.
status soft_add(soft_solver *s, const body *all, int b, int bodies,
                int particles);
void   soft_free(soft_solver *s);       // an empty or zeroed one is fine

// What is kept of body b is forgotten: it has been put elsewhere; or it is
// taken away, as well.
void soft_forget(soft_solver *s, int b);
void soft_remove(soft_solver *s, const body *all, int b);

// Something was set down that has no place in the lists: a plane.
void soft_doubt(soft_solver *s);

// A frame begins, and rigid bodies have been looked at: where are deformable
// ones, and how may they move?  held says which hang on something.
void soft_begin(soft_solver *s, const soft_frame *f);

// Is the deformable body a so near b that they may touch in this frame?
bool soft_may_touch(const soft_solver *s, int a, int b);

// After soft_begin: is rigid body b one that anything deformable may meet in this
// frame, if nothing gets faster than twice the fastest?
bool soft_may_meet(const soft_solver *s, int b);

// How many substeps this frame needs for deformable bodies, and for what they
// may meet.
int soft_substeps(const soft_solver *s, const soft_frame *f);

// A substep, in this order.  The particles move, and what is bent straightens;
void soft_move(soft_solver *s, const soft_frame *f);

// the diagonals of cloth draw them;
void soft_draw(soft_solver *s, const soft_frame *f);

// they are parted from planes, each other and rigid bodies, which take impulses
// where they stand, at f->now, moved by f->moved;
void soft_separate(soft_solver *s, const soft_frame *f);

// and their strands are relaxed, together with what they touch that does not
// move;
void soft_relax(soft_solver *s, const soft_frame *f);

// and what sticks have pulled back to edges and corners holds them by the weight of
// all that it hangs on.
void soft_hold(soft_solver *s, const soft_frame *f);

// What began in something is put out of it, and not thrown: all of it together gets
// no faster than it fell.
void soft_calm(const soft_solver *s, const soft_frame *f);

// J, what is stored in the bends and links of a deformable body.
real soft_energy(const body *b, const particle *all);

// When all substeps are over: what crosses does not.
void soft_certify(soft_solver *s, const soft_frame *f);

// How many deformable bodies that must not give have strands off by more than
// a hundredth, are deep in what they began in, or are cut by a rigid body.
int soft_unconverged(const soft_solver *s, const soft_frame *f);
//<
