//> blow-head
// blow.h - what strikes is stopped through all that it strikes against.
//
// Paper: not asked.  Book: chapter 15.
// The passes see one contact after the other.  When a heavy ball falls on a light box,
// they stop it by only so much as the box alone bears, and the overlap throws the ball
// up again in the next substeps, as from a spring.  Here ball, box and ground are
// solved together, once, directly.
// Units: metres, kilograms, seconds.  Normals point from B to A.

#pragma once

#include "impact.h"
#include "solver.h"
//<

//> blow-declare
// Call it after solver_push.  Where two bodies, one heavier than the other, still close
// their gap faster than a load would make them, it gives the least impulses that stop
// them, and stop all that these would make close faster than material_slowest.  Bodies
// that bounce are left to restitution_solve.  Energy only falls.  At most IMPACT_ROWS
// points take part; the rest is left to the passes.
void blow_stop(contact_solver *s, const solver_frame *f, motion *velocity);

// After solver_relax, and when contacts have been heard: what a blow gave does
// not act again in the next substep, nor does friction where points struck.
void blow_forget(contact_solver *s);
//<
