//> blow-head
// blow.h - what strikes is stopped through all that it strikes against.
//
// Paper: not asked.  Book: chapter 15.
// The passes see one contact after the other: of a heavy ball that falls on a
// light box they take what the box alone bears, and give that back in the next
// substep.  So the ball comes up again, as from a spring.  Here ball, box and
// ground are solved together, once, directly.
// Units: metres, kilograms, seconds.  Normals point from B to A.

#pragma once

#include "impact.h"
#include "solver.h"
//<

//> blow-declare
// After solver_push.  Where two bodies, one heavier than the other, still close
// faster than a load makes them, beyond their gap, the least impulses are given
// that stop them, and all that these make close faster than material_slowest.
// What bounces is left to restitution_solve.  Energy only falls.  IMPACT_ROWS
// points take part at most; the passes have the rest.
void blow_stop(contact_solver *s, const solver_frame *f, motion *velocity);

// After solver_relax, and when contacts have been heard: what a blow gave does
// not act again in the next substep, nor does friction where points struck.
void blow_forget(contact_solver *s);
//<
