//> restitution-head
// restitution.h - impacts: bodies that meet fast bounce.
//
// Paper: section 6.1 only parts what overlaps.  Book: chapter 15.
// Units: metres, kilograms, seconds.  Normals point from B to A.

#pragma once

#include "impact.h"
#include "solver.h"
//<

//> restitution-declare
// Makes the impacts of one substep, and returns how many there were.  Two bodies whose
// gap closes within it, at more than material_slowest, part at restitution times the
// speed at which they met, at the time at which they met; friction acts in the impact,
// too.  The n contacts are gone over forward and backward, at most CONTACT_ROUNDS
// times, because an impact that is passed on, as in Newton's cradle, is one more
// impact.  It ends where what is passed on is slower than a tenth of the fastest one.
//
// velocity[bodies] is that of this substep, with gravity in it, and moved[bodies] the
// displacement since each body got its frame.  A body has its old velocity before the
// time of the impact, and the new one after it.  So a body that moves freely is put, in
// `body`, which is f->body, to where it would have begun with its new velocity, and
// is_struck is set.  For one that is joined, or beside a driven body, `moved` changes.
//
// No impact adds energy, to rounding, whatever its bodies, points and friction; with
// restitution 1 and no friction none takes any.  It keeps the momentum of the two
// bodies, and the angular momentum as far as the two points of the contact are in one
// place.  Numbers that are not finite make no impact.
//
// Call it before solver_warm.  If there were impacts, solver_update_gaps must follow,
// because the solver does not hold bodies that part.
int restitution_solve(const contact *const *table, int n, const solver_frame *f,
                      solver_body *body, motion *velocity, motion *moved);

// Of two balls, makes the normal of c the line of their centres at the end of the
// substep, at their velocities now, if it strikes or if the normal has turned by more
// than MANIFOLD_TURN.  Returns whether it did.
bool restitution_face(contact *c, const solver_frame *f,
                      const motion *velocity, const motion *moved);
//<
