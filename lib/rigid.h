//> rigid-head
// rigid.h - what rigid bodies touch: each other, and planes.
//
// Paper: sections 5.1 and 6.1.  Book: chapter 9.
//
// Contacts are looked for once a frame, as far ahead as bodies may get in it,
// and pushed in every substep.  Bodies with a particle at every vertex have
// contacts that forget (response.h), those of four particles such as remember
// (push.h).

#ifndef TUMBLE_RIGID_H
#define TUMBLE_RIGID_H

#include "world.h"
//<

//> rigid-declare
// How body b moves in a frame, as fast as it is now: its way, turn and reach.
void rigid_look_ahead(const world *w, body *b);

// Will rigid bodies a and b, which go further than an inner radius in this
// frame, come so near that they may touch?  After rigid_find_pairs.
int rigid_flies_into(const world *w, const body *a, const body *b);

// Looks at every body, says who moves, and lists the pairs of rigid ones that
// may meet in this frame.  Wakes sleepers that something quick comes near.
void rigid_find_pairs(world *w);

// The contacts of these pairs, and of all bodies that move with the planes.
void rigid_find_contacts(world *w);

// Substep number `substep`: bodies that pass each other quickly have other
// contacts by now (BODY_VERTICES).
void rigid_find_again(world *w, int substep);

// Parts what touches: pushes that remember, of a substep of h (s), the first of
// a frame or not; then contacts that do not.
void rigid_separate(world *w, real h);

// After relaxing: bodies that met in a blow part at restitution times the speed
// at which they met (BODY_VERTICES; of four particles: rigid_separate does it).
void rigid_bounce(world *w, real h);

// The end of a frame: what the contacts leave to the next.
void rigid_remember(world *w);

// Body a comes near body b: if one of them sleeps and the other is faster than
// the speed of rest, the sleeper wakes, in time to take its part of the blow,
// and all that sleep with it.  1 if so.
int rigid_wake(world *w, int a, int b);

// m/s, a body that goes slower may rest.
real rigid_rest_speed(const world *w, const body *b);

// Contact c of bodies a and b (-1: immovable), as one that remembers.  A
// deformable body is A, and touches with one particle.
push rigid_push(const world *w, const contact *c, int a, int b);
//<

//> rigid-end-of-header
#endif
//<
