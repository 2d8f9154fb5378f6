//> narrow-head
// narrow.h - where do rigid bodies touch each other, and planes?
//
// Paper: section 5.1.  Book: chapter 16.
//
// The narrow phase, after the broad one of pairs.h: contacts are found once a
// frame, as far ahead as bodies may get in it, and pushed in every substep.

#ifndef TUMBLE_NARROW_H
#define TUMBLE_NARROW_H

#include "world.h"
//<

//> narrow-declare
// The contacts of the pairs listed by pairs_find, and of all bodies that move
// with the planes.
void narrow_find(world *w);

// Substep number `substep`: bodies that pass each other quickly have other
// contacts by now.
void narrow_find_again(world *w, int substep);

#endif
//<
