//> contacts-head
// contacts.h - the contacts of a frame, and what they leave to the next.
//
// Paper: section 6.1, where contacts do not outlive a step.  Book: chapter 12.
//
// Bodies with a particle at every vertex have contacts that forget
// (response.h), those of four particles such as remember (push.h).  Both are
// found by narrow.h, and pushed in every substep by solver.h; here they are
// written down, kept where nothing moved, and handed what the last frame's
// pushed.
//
// Two bodies are named by their numbers a < b; a body and plane k are a and
// w->bodies + k.

#ifndef TUMBLE_CONTACTS_H
#define TUMBLE_CONTACTS_H

#include "world.h"
//<

//> contacts-declare
// m/s, who meets body b faster than this strikes a blow: a third of the speed,
// sqrt(2 g s), that a fall through its shortest stick, s, gives.
real contacts_blow_speed(const world *w, const body *b);

// Contact c of bodies a and b (-1: immovable), as one that remembers.  A
// deformable body is A, and touches with one particle.
push contacts_push(const world *w, const contact *c, int a, int b);

// Writes down the n contacts found between a and b, which have one normal.
// What finds no room is counted in the report.  Contacts that remember begin
// with what the last frame's pushed: `old` are two places in that memory, 0 and
// w->lasting_memories before the first pair, that move on from pair to pair.
void contacts_keep(world *w, const contact *found, int n, int a, int b,
                   int old[2]);

// A second contact of bodies of four particles, beside `touch`, that keeps the
// ball inside the smaller one in front of the other.
void contacts_guard(world *w, const contact *touch, int a, int b);

// m, what a and b may have come nearer since their contacts were found, and
// still be taken to lie where they lay.
real contacts_slack(const world *w, int a, int b);

// Did neither move since their contacts `run` were found, and is there nothing
// new to be found within `margin` (m) of them?
int contacts_may_stay(const world *w, const push_run *run, int a, int b,
                      real margin);

// Then these go on as they are, and begin with what they pushed in the last
// frame, whose contacts are w->old_push.
void contacts_stay(world *w, push_run *run, int a, int b);

// Adds to the memory what pushes number `from` to `end` - 1 did in the last
// substep.
void contacts_remember(world *w, int from, int end);
//<

//> contacts-end-of-header
#endif
//<
