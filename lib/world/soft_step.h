//> soft-step-head
//>   The step lends the world to the cloth of chapter 16, and wakes what it
//>   meets.
// soft_step.h - cloth and rope in the world's step.
//
// Book: chapter 18.

#pragma once

#include "world.h"
//<

//> soft-step-declare
// The tables of the world that rope and cloth read, for a substep of h (s).
soft_frame soft_frame_of(world *w, real h);

// Begins a frame: unites ropes and cloths with the islands of all that is near them,
// and wakes sleepers there.  Returns whether one woke.
bool soft_wake(world *w);

// The number of substeps that the frame needs for them.
int  soft_need(world *w);

// Moves them through a substep of h (s).
void soft_step(world *w, real h);

// After the substeps: proves that no cloth crosses cloth, see certificate.h.
void soft_prove(world *w);

// After the substeps: writes what they did to the report.
void soft_report(world *w);
//<
