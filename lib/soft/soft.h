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
// Makes the lists of near particles anew, if one may have come near unlisted:
// once a substep, before soft_separate.  Pairs that neither move are left out,
// so w->near.trusted must be -1 after someone woke.
void soft_refresh(world *w);

// Parts what touches: particles and planes, pairs of particles, particles and
// rigid bodies.  Counts in the report what was watched, and what was pushed.
void soft_separate(world *w);

// m, how far off a rigid body the particles of a deformable one are kept: by
// their thicknesses, and an eighth more if it is nailed.
real soft_gap(const body *soft, const body *rigid);

// After relaxing: particles that the sticks have pulled nearer to a rigid body
// than half of what keeps them apart are held there.  What moves and has four
// particles is held by the deformable body as a whole, with all of its mass, or
// by its nails: linear momentum is kept, angular momentum is not.
void soft_hold(world *w);

#endif
//<
