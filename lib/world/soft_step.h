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
// What cloth and rope are told of the world, for a substep of h (s).
soft_frame soft_frame_of(world *w, real h);

// A frame begins: deformable bodies wake, and rest with, whatever is near them.
// Returns whether anything woke.
bool soft_wake(world *w);

// How many substeps the frame needs for them.
int  soft_need(world *w);

// A substep of h (s).
void soft_step(world *w, real h);

// After the substeps: no cloth crosses cloth; see certificate.h.
void soft_prove(world *w);

// After the substeps: what they did goes into the report.
void soft_report(world *w);
//<
