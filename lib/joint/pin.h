//> pin-head
//>   A pin joins a particle to a body. It has two moments: before the strands
//>   are solved, and after.
// pin.h - a particle of a rope or a cloth that is tied to a rigid body.
//
// Book: chapter 17.
// Units: metres, kilograms, seconds.

#ifndef TUMBLE_PIN_H
#define TUMBLE_PIN_H

#include "linkage.h"
#include "near.h"

// In a substep.  When particles and rigid bodies have moved: each pinned
// particle and its place on the body come together, and until pins_end the
// strands feel it as heavy as the two of them;
void pins_begin(linkage *l, const soft_frame *f);

// when the strands have pulled: what they did to it is done to both.  Pins that
// bore too much break.
void pins_end(linkage *l, const soft_frame *f);

#endif
//<
