//> hear
//>   A game plays a sound as loud as the blow was, and lets a player jump through a
//>   platform from below. Both look at the contacts while a frame goes on.
// hear.h - what contacts give in a frame is written down, and which of them count.
//
// Book: chapter 18.  Units: newtons, seconds, metres.

#pragma once

#include "world.h"

// A rung begins: its impacts are written from now on.
void hear_impacts(world *w, solver_frame *f);

// A substep is over: what the contacts of its rung gave in it is added up.
void hear_contacts(world *w);

// Of the contacts of this part of a frame, those stay that options.host.meets says.
void hear_choose(world *w);
//<
