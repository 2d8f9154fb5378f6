//> contacts-head
// contacts.h - the contacts of a frame, and what they leave to the next.
//
// Paper: section 6.1, where contacts do not outlive a step.  Book: chapter 16.
//
// They are found by narrow.h, and pushed in every substep by solver.h; here
// they are written down, kept where nothing moved, and handed what the last
// frame's pushed.
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
push contacts_push(const world *w, const contact_point *c, int a, int b);

// m, what a and b may have come nearer since their contacts were found, and
// still be taken to lie where they lay.
real contacts_slack(const world *w, int a, int b);

// Did neither move since their contacts `run` were found, and is there nothing
// new to be found within `margin` (m) of them?
int contacts_may_stay(const world *w, const contact_run *run, int a, int b,
                      real margin);

// What was found: room for the contacts of rigid body k with the planes, plane
// after plane, and for those of a pair.
contact_point *contacts_of_planes(const world *w, int k);
contact_point *contacts_of_pair(const world *w, const body_pair *pair);

// May the pair have, beside what was found, a contact that keeps the ball
// inside the smaller body in front of the other?  If that one can move.
int contacts_have_guard(const world *w, int a, int b);

// Gives all that was found, or stays, its place: in what order does not depend
// on who found it when.  `again`: quick pairs alone.  What finds no room is
// counted in the report.
void contacts_place(world *w, int again);

// Writes them there.  Contacts that remember begin with what those of the last
// frame pushed; those that stay go on as they are.
void contacts_write_pair(world *w, const body_pair *pair);
void contacts_write_planes(world *w, int k);
//<

//> contacts-end-of-header
#endif
//<
