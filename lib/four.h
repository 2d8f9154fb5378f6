//> four-head
// four.h - any rigid body is four particles and six sticks.
//
// Paper: section 4 puts a particle at every vertex, whose inertia is 2.3 to 5
// times the solid's.  Here: Routh's four equal masses, with the mass, the
// centre and the inertia of the solid (Laus and Selig 2020).
// Book: chapter 12.
// Units: metres, kilograms.

#ifndef TUMBLE_FOUR_H
#define TUMBLE_FOUR_H

#include "body.h"

enum { FOUR = 4, FOUR_STICKS = 6 };

// The plan of a body of four particles.  The vertices of the mesh ride on them:
// vertex v is the weighted mean of the four, by fixed weights.
typedef struct four {
    vec3  at[FOUR];         // m, at rest, in the frame of the shape
    vec3  center;           // m, the solid's centre of mass, in that frame
    real  mass;             // kg, of each of the four
    real  radius;           // m, their largest distance from the centre
    real  reach;            // m, the vertices' largest distance from it
    struct stick stick[FOUR_STICKS];         // every pair
    real  inverse[FOUR_STICKS][FOUR_STICKS]; // of J J^T at rest, 1/m^4
    real (*weight)[FOUR];   // [shape->particles] their sum is 1
} four;
//<

//> four-declare
// The four particles of the solid that the closed mesh of s encloses, filled
// evenly with the mass of s.  Fails, leaving *f empty, if s has no volume (or
// one so thin that rounding loses it), or memory is refused.
status four_build(four *f, const shape *s);
void   four_free(four *f);      // an empty or zeroed one is fine

// Where the n vertices stand, when the particles stand at p.
void four_ride(const four *f, const particle *p, vec3 *at, int n);

// Brings the six sticks to their lengths at once: Newton's step for all of
// them, until none is off by more than options.tolerance, at most `steps`
// times.  The matrix that it needs is made of dot products of sticks, which are
// the same however a rigid body is turned: it is inverted once, in the plan.
// Gradients as options.gradient says; where this fails (violent turning), the
// sticks are relaxed one by one (fell_back = 1).  Nailed bodies stay.
relax_result four_relax(const four *f, particle *p, int steps,
                        relax_options options);

// How the particles, of `inverse_mass` (1/kg) each, standing at `at`, move when
// the point with these weights is pushed by 1 kg m along the unit vector d,
// while the sticks hold: answer[k], m/(kg m).  Returns how far the point itself
// goes along d: its inverse mass, 1/kg, which is that of a rigid body,
// 1/M + (r x d) . I^-1 (r x d), without a tensor.  All zero for a nailed body.
real four_answer(const four *f, const vec3 at[FOUR], real inverse_mass,
                 const real weight[FOUR], vec3 d, vec3 answer[FOUR]);

// Do the particles stand as in a mirror?  (No stick can tell.)
int four_is_mirrored(const four *f, const particle *p);
//<

//> four-end
#endif
//<
