//> separation-head
// separation.h - contacts, and the push that parts what overlaps.
//
// Paper: section 6.1, Eqs 8 to 11.  Book: chapter 7.
// Units: metres, kilograms.  Every normal is a unit vector from B to A: A moves
// along it, B against it.  gap < 0: overlap.

#ifndef TUMBLE_SEPARATION_H
#define TUMBLE_SEPARATION_H

#include "penetration.h"
#include "verlet.h"

// How a push is shared between the two sides.
typedef enum {
    SHARE_MASS,         // least move of the particles, weighted by their
                        // masses: keeps linear momentum
    SHARE_BODY,         // q between pA and pB by the bodies' masses, the heavy
                        // body moving least; Eqs 8, 9 with it
    SHARE_PRINTED       // Eq. 10 as printed: the heavy body moves most
} share_rule;

// Which way a deformable body is pushed out of a rigid one.
typedef enum {
    PUSH_OUT,           // outwards
    PUSH_PRINTED        // -d/2 with d = pB - cA, as printed: deeper in
} push_rule;

typedef struct {
    share_rule share;
    push_rule  push;
    real gain;          // > 0, a contact's push is multiplied by it: the sticks
                        // take most of a push back (to 1/4 in a cube's corner,
                        // 1/12 in an icosahedron's), so one that is to last
                        // goes further.  Friction does not grow with it
    real friction;      // Coulomb's coefficient, >= 0
    real restitution;   // 0 to 1: speed after a bounce / speed before
} response_options;

// Two points that must not pass each other along a normal that stays fixed
// while the contact lives (a frame).  Particles are numbered in the pool.
typedef struct contact {
    feature_point a, b; // b.count = 0: B is immovable, its point is `fixed`
    vec3 fixed;         // m
    vec3 normal;        // unit, from B to A
    real thickness;     // m, gap that is kept between the points
    real mass_a, mass_b;// kg, whole bodies (SHARE_BODY, SHARE_PRINTED);
                        // HUGE_VAL: immovable under these two rules
    real pushed;        // m, sum of the overlaps that this contact has pushed
                        // apart since it began, without gain
    real worn;          // kg m^2, friction's work since then, times the square
                        // of a step
    real approach;      // m/s, > 0: speed of approach when it began
} contact;

// Two particles that must stay this far apart, in whatever direction they lie:
// leaf spheres of thickness around single vertices.
typedef struct {
    int  a, b;
    real distance;      // m
} sphere_contact;
//<

//> separation-declare
// SHARE_MASS, PUSH_OUT, gain 1, friction 0.5, restitution 0.
response_options response_options_default(void);

// The point that f stands for, now and one step ago.
vec3 feature_now(feature_point f, const particle *p);
vec3 feature_before(feature_point f, const particle *p);

// m, (pA - pB) . normal - thickness.
real contact_gap(const contact *c, const particle *p);

// Parts the features if their gap is negative, and brakes their sliding by at
// most friction times the push.  Returns the overlap before (m, >= 0).
// Paper: Eqs 8 to 10; here the push is depth / (sum w a^2 + sum w b^2), of
// which Eqs 8 and 9 are the case of equal masses.  An immovable side takes
// nothing under any rule; both sides immovable: nothing.  Under SHARE_BODY and
// SHARE_PRINTED only the part of q - p along the normal counts: what lies
// across it is sliding, and friction's.
real contact_separate(contact *c, particle *p, response_options options);

// Gives the features their speed of separation, restitution * approach (or
// -approach, if they were parting already), by moving the previous positions,
// shared by mass under any rule.  Only contacts that pushed do anything.  To be
// called after the last separation of a step of dt (s, > 0).
void contact_bounce(const contact *c, particle *p, response_options options,
                    real dt);

// Are the two nearer than they may be?  Quick to ask: most pairs are not.
static inline int sphere_contact_overlaps(const sphere_contact *c,
                                          const particle *p)
{
    vec3 across = vec3_sub(p[c->a].position, p[c->b].position);
    return vec3_length_squared(across) < c->distance * c->distance;
}

// Parts two particles nearer than c.distance, along the line between them, with
// friction, shared by mass.  options.gain and share do not apply.  Returns the
// overlap before (m, >= 0).  Coincident particles have no line: they are left,
// 0.  Paper: Eq. 11 with masses.
real sphere_contact_separate(sphere_contact c, particle *p,
                             response_options options);

// Eq. 11 as printed: two leaves of a deformable body (features fa and fb, with
// spheres ca, ra and cb, rb) part by d/2 each, without masses (nailed particles
// stay).  Returns the overlap before (m, >= 0).  Coincident centres: left, 0.
real leaves_separate(const int *fa, int na, vec3 ca, real ra,
                     const int *fb, int nb, vec3 cb, real rb, particle *p);

// Section 6.1, last paragraph: feature fa of a deformable body, whose sphere's
// centre ca lies inside a rigid body, against the point pb of its surface.
// PUSH_PRINTED moves fa by -(pb - ca)/2, PUSH_OUT by +(pb - ca)/2, half of the
// way out; the surface feature b (count 0: immovable) is moved to the midpoint
// by Eqs 8 and 9.
void deformable_separate(const int *fa, int na, vec3 ca, feature_point b,
                         vec3 pb, particle *p, response_options options);

#endif
//<
