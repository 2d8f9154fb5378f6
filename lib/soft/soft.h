//> soft-head
// soft.h - what deformable bodies touch: themselves, each other, rigid bodies.
//
// Paper: section 5.2 and the end of 6.1.  Book: chapter 16.
//
// The trees are asked which particles are near each other, the planes of rigid
// bodies which are near them; the answer, with a margin, is good until the
// moves of two differ by it (the neighbour list of Verlet 1967).  In between, a
// substep only looks down the lists.

#ifndef TUMBLE_SOFT_H
#define TUMBLE_SOFT_H

#include "world.h"
//<

//> soft-declare
// A frame begins, and rigid bodies have been looked at: deformable bodies wake,
// and rest with, whatever is near them.  Returns whether anything woke.
bool soft_begin(world *w);

// How many substeps this frame needs for deformable bodies, and for what they
// may meet.
int soft_substeps(const world *w);

// A substep of h (s): moves the particles of deformable bodies, parts them from
// planes, each other and rigid bodies, and relaxes their sticks.  Rigid bodies
// stand at rigid.now, moved by rigid.moved, and take impulses there.
void soft_substep(world *w, real h);

// How many deformable bodies have strands off by more than a hundredth.
int soft_stretched(const world *w);
//<

//> soft-declare-parts
// Its parts, in their order.  The lists are brought up to date,
void soft_refresh(world *w, real h);

// particles are parted from all that they touch,
void soft_separate(world *w, real h);

// and those that sticks have pulled back into a rigid body hold it by the
// weight of all that they hang on.
void soft_hold(world *w, real h);

// m, how far particles of `soft` are kept from the surface of `rigid`.
real soft_gap(const body *soft, const body *rigid);

#endif
//<
