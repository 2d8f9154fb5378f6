//> restitution-head
// restitution.h - bodies that meet fast part again: impacts.
//
// Paper: section 6.1 only parts what overlaps.  Book: chapter 15.
// Units: metres, kilograms, seconds.  Normals point from B to A.

#ifndef TUMBLE_RESTITUTION_H
#define TUMBLE_RESTITUTION_H

#include "impact.h"
#include "solver.h"
//<

//> restitution-declare
// The impacts of one substep.  Two bodies whose gap closes within it, and that
// meet faster than material_slowest, part at f->restitution times the speed
// at which they met, at the time at which they met; friction acts in the
// impact, too.  Forward and backward over the n contacts, at most CONTACT_ROUNDS
// times: an impact that is passed on, as in Newton's cradle, is one more impact.
// What is passed on at less than a tenth of the fastest blow's speed strikes no
// more.  Returns how many there were.
//
// velocity and moved, [bodies], say how the bodies move in this substep, with
// gravity in it, and how far they have gone since they got their frames.
// The end of the substep is where a body comes that has its old velocity before
// the impact and the new one after it.  So what flies freely is put, in `body`,
// which is f->body, to where it would have begun with its new velocity: it
// is_struck.  Of what is joined, or beside a driven body, `moved` changes.
//
// No impact adds energy, to rounding, whatever its bodies, points and friction;
// with restitution 1 and no friction, none takes any.  It keeps the momentum of
// its two bodies, and, as far as the two points of a contact are in one place
// when they touch, the angular momentum.  Numbers that are not finite strike
// nothing.
//
// To be called before solver_warm; and if there were any, solver_update_gaps must
// follow: bodies that part after an impact are not held by the solver.
int restitution_solve(const contact *const *table, int n, const solver_frame *f,
                      solver_body *body, motion *velocity, motion *moved);

// If c is of two balls, its normal becomes the line of their centres when the
// substep ends, as they go now: if it strikes, or if the normal has turned by more
// than MANIFOLD_TURN.  Returns whether it does.
bool restitution_face(contact *c, const solver_frame *f,
                      const motion *velocity, const motion *moved);
//<

//> restitution-end-of-header
//>   The header ends.
#endif
//<
