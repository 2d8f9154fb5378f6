//> plain-impact-head
// plain_impact.h - two bodies that strike each other within a substep: slow, and
// short.
//
// The oracle of lib/contact/restitution.c, which does the same for all contacts
// of a world, and asks far less often.  Book: chapter 15.
// Units: metres, kilograms, seconds.  The normal points from B to A.

#ifndef TUMBLE_PLAIN_IMPACT_H
#define TUMBLE_PLAIN_IMPACT_H

#include "contact.h"
#include "motion.h"

typedef struct {
    rigid_frame frame;
    motion_basis basis;
    motion velocity;
} plain_body;

// Points that are apart, or touch.  No gravity, and no friction.
typedef struct {
    plain_body body[2];             // A and B
    vec3 normal;                    // unit
    int  points;
    vec3 at[2][CONTACT_POINTS];     // on A and on B, in the body's own frame
    real restitution;
} plain_impact;

// A substep of h seconds, with one impact at most.  Returns when that was (s); h:
// there was none.
real plain_impact_step(plain_impact *x, real h);

#endif
//<
