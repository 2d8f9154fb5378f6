//> response-head
// response.h - a contact, and the push that parts its two features.
//
// Paper: section 6.1, Eqs 8 to 11.  Book: chapter 7.
// Units: metres, kilograms.  Frame: the world's.  Every normal is a unit vector
// from B to A: A moves out along it, B against it.

#pragma once

#include "feature.h"
#include "verlet.h"

// Two points that may not come nearer than `apart` along a normal, which stays
// fixed while the contact lives.  The features count particles from the first
// of the array that every function here is given.
typedef struct feature_contact {
    feature_point a, b; // b.count = 0: B is the static world, its point (0,0,0)
    vec3 normal;        // unit, from B to A
    real apart;         // m, least (pA - pB) . normal: 0 for rigid bodies, the
                        // sum of their margins for others, the offset of a
                        // plane for the static world
    real mass_a, mass_b;// kg, of the whole bodies, for response_printed only;
                        // HUGE_VAL: static
    bool soft_a, soft_b;// is that body deformable?  for response_printed only
} feature_contact;
//<

//> response-declare
// m: the point of f, a weighted mean of its particles' positions.
vec3 feature_position(const feature_point *f, const particle *p);

// 1/kg, sum w_i a_i^2: the inverse effective mass of that point.  0 if all its
// particles are pinned, or there are none.
real feature_inverse_mass(const feature_point *f, const particle *p);

// m: by how much the two points are nearer than they may be.  > 0: overlap.
real contact_depth(const feature_contact *c, const particle *p);

// Parts the two points by the least mass-weighted move of their particles, and
// undoes their sliding since the last step as far as Coulomb's law allows:
// by at most friction (a coefficient, >= 0) times the overlap.  Linear momentum
// stays, unless a particle is pinned.  Returns the overlap before (m), 0 if
// there is none.  Moves nothing if nothing can move, or the move would
// overflow.  Requires: A and B share no particle; friction >= 0.
// Paper: Eqs 8 to 11; here one formula, and inverse masses of particles.
real response_separate(const feature_contact *c, particle *p, real friction);
//<

//> response-declare-printed
// Two misprints of section 6.1, each kept as an option.
typedef struct {
    bool masses_exchanged;  // Eq. 10: the heavier body moves further
    bool pushed_inwards;    // d = pB - cA: a deformable body goes deeper into
                            // a rigid one
} response_errata;

// The paper's own way: q divides the overlap by the masses of the whole bodies
// (Eq. 10), or in the middle if a body is deformable; each feature follows to q
// by Eqs 8 and 9, which know no masses.  A static side stays, and the other
// goes all the way; pinned particles stay.  No friction.  Returns the overlap
// before (m), 0 if there is none.  Requires: mass_a and mass_b > 0.
real response_printed(const feature_contact *c, particle *p,
                      response_errata errata);
//<
