//> hear
//>   A game plays a sound as loud as the blow was, and lets a player jump through a
//>   platform from below. Both look at the contacts while a frame goes on.
// hear.h - the impulses of contacts for the program, and its choice of contacts.
//
// Book: chapter 18.  Units: newtons, seconds, metres.

#pragma once

#include "world.h"

// Begins a rung: its impacts are written down from now on.
void hear_impacts(world *w, solver_frame *f);

// After a substep: adds up the impulses of the contacts of its rung.
void hear_contacts(world *w);

// Removes the contacts of this part of a frame that options.host.meets refuses.
void hear_choose(world *w);
//<
