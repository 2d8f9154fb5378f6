//> separation-head
//>   So particles are kept apart from each other, and from static surfaces.
//>   Both are the least move of chapter 07, with friction.
// separation.h - particles kept apart, from each other and from surfaces.
//
// Paper: section 6.1.  Book: chapter 16.
// Units: metres, kilograms.  Every normal is a unit vector from B to A.

#pragma once

#include "verlet.h"

// Two particles that must stay this far apart, in whatever direction they lie.
typedef struct {
    int  a, b;          // in the pool
    real distance;      // m
} particle_contact;
//<

//> separation-declare
//>   Two functions part, and a third asks cheaply whether there is anything to
//>   do.
// Are the two nearer than they may be?  Quick to ask: most pairs are not.
static inline bool particle_contact_overlaps(const particle_contact *c,
                                             const particle *p)
{
    vec3 across = vec3_sub(p[c->a].position, p[c->b].position);
    return vec3_length_squared(across) < c->distance * c->distance;
}

// Parts two particles nearer than c.distance, along the line between them and
// shared by mass, and brakes their sliding by at most friction times the push.
// Returns the overlap before (m, >= 0).  Coincident particles have no line:
// they are left, 0; so are those of which a number is lost.  Paper: Eq. 11 with
// masses.
real particle_contact_separate(particle_contact c, particle *p, real friction);

// The two were parted.  Takes back how far they slid past each other, and how far
// what comes next will draw a from b, `drawn` (m), but together no more than `most`
// (m): friction times what parted them.
void particle_contact_brake(particle_contact c, particle *p, vec3 drawn, real most);

// The same as the first for particle p and an immovable surface, of which `foot` is the
// point under p: keeps p `distance` (m) from it along the normal (unit, out of
// the surface).  Returns the overlap before (m, >= 0); a pinned p stays.
real surface_separate(particle *p, vec3 foot, vec3 normal, real distance,
                      real friction);
//<
