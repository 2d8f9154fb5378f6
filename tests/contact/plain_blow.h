//> plain-blow-head
// plain_blow.h - a heavy body strikes a light one, and all that stands behind it:
// slow, and short.
//
// The oracle of lib/contact/blow.c, which solves for all points at once.
// Book: chapter 15.
// Units: metres, kilograms, seconds.  Normals point from B to A.

#ifndef TUMBLE_PLAIN_BLOW_H
#define TUMBLE_PLAIN_BLOW_H

#include "contact.h"
#include "motion.h"

typedef struct {
    int  body[2];                   // A and B; B < 0: a plane
    vec3 normal;                    // unit
    int  points;
    vec3 arm[2][CONTACT_POINTS];    // m, from the centres: impulses act there
    real gap[CONTACT_POINTS];       // m
    bool bounces;                   // it takes part in no blow
    int  wave;                      // of the blow that it joined in; 0: none
    real impulse[CONTACT_POINTS];   // N s, of the blow
} plain_touch;

typedef struct {
    int touches;
    plain_touch *touch;
    const motion_basis *basis;      // of each body
    motion *velocity;
    real h;                         // s, a substep
    real slowest;                   // m/s, material_slowest
} plain_blow;

// m/s: how fast the two sides of point k part, beyond the gap that they have.
real plain_blow_parting(const plain_blow *x, const plain_touch *c, int k);

// Stops what strikes.  Returns how many blows there were.
int plain_blow_stop(plain_blow *x);

#endif
//<
