//> plain-solver-head
// plain_solver.h - contacts solved one by one: slow, and short.
//
// The oracle of lib/contact/solver.c, which does the same with four contacts
// side by side.  Book: chapter 13.
// Units: metres, kilograms, seconds.  Normals point from B to A.

#ifndef TUMBLE_PLAIN_SOLVER_H
#define TUMBLE_PLAIN_SOLVER_H

#include "solver.h"

// A frame on its way.  The impulses of the last substep stand in the contacts.
typedef struct {
    const solver_frame *frame;      // what is_elsewhere there lies
    contact **contact;              // [contacts] in the order of solving
    int contacts;
    real (*gap)[CONTACT_POINTS];    // [contacts] m, as the bodies stand
    motion *velocity;               // [bodies + 1] the last is for planes
    motion *moved;                  // [bodies + 1] of what lies, since then
    solver_body *body;              // [bodies] where they stand now
    bool *is_first;                 // [contacts] no impulse was brought along
    bool *strikes;                  // [contacts] a point has struck in this substep
} plain_solver;

// The start of a frame.
void plain_begin(plain_solver *s);

// One substep under gravity (m/s^2), in four phases.
void plain_substep(plain_solver *s, vec3 gravity);

void plain_warm_start(plain_solver *s);
void plain_push(plain_solver *s);
void plain_move(plain_solver *s);
void plain_measure(plain_solver *s);        // all gaps
void plain_relax(plain_solver *s);

// The springs of contacts between two that move, or with one that does not.
softness plain_softness(const solver_frame *f, bool both_move);

#endif
//<
