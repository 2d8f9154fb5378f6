//> pin-head
//>   A pin is a ball joint of a body and a particle. But a strand is solved
//>   directly, and the solve needs to know the mass at its end: that of the
//>   wrecking ball, and not that of the particle, which may be a hundred
//>   thousand times lighter. So in each substep one exact impulse first brings
//>   the particle to its place on the body. Then the strand is solved with a
//>   particle that is *as hard to move as particle and body together*. Its
//>   move gives the impulse of the strand, which particle and body then share.
//>   When a pin lets go, its particle lies nearer to the body than particles
//>   may come. If that counted at once, it would be thrown out. So the two
//>   count as joined until a frame begins in which they are apart.
// pin.h - a particle of a rope or a cloth that is tied to a rigid body.
//
// Book: chapter 17.
// Units: metres, kilograms, seconds.

#pragma once

#include "linkage.h"
#include "near.h"

// In a substep.  When particles and rigid bodies have moved: each pinned
// particle and its place on the body come together, and until pins_end the
// strands feel it as heavy as the two of them;
void pins_begin(linkage *l, const soft_frame *f);

// when the strands have pulled: what they did to it is done to both.  Pins that
// bore too much break.
void pins_end(linkage *l, const soft_frame *f);
//<
