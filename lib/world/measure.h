//> measure-head
//>   How good is a step? A contact list that missed a pair shows no overlap. So
//>   the measures use nothing that the step found: they ask every pair whose
//>   spheres meet.
// measure.h - how far from right is the world?
//
// Paper: section 7 measures time only.  Book: chapter 18.
// Units: metres, kilograms, seconds, joules, in the world's frame.

#pragma once

#include "world.h"
//<

//> measure-struct
// How far from right the world is, measured from the positions alone.
typedef struct {
    real strain;        // largest of |length - rest| / rest, stiff sticks
    real strain_rms;    // over the same
    real shear;         // largest over the soft sticks (a cloth's diagonals)
    real penetration;   // m, deepest: rigid bodies in each other, in planes,
                        // particles of deformable bodies in rigid ones
    real kinetic;       // J, half a substep ago, as all that follows:
    real potential;     // J, 0 at the origin's height
    vec3 momentum;      // kg m/s
    vec3 angular;       // kg m^2/s, about the origin
} measures;
//<

//> measure-declare
// Measures the world from the positions of its particles.  It is no part of a step, and
// slower than one, because it allocates room for all vertices and asks all pairs.  A
// body whose numbers are not finite shows as a strain of HUGE_VAL and a penetration of
// NaN; if memory is refused, the penetration is NaN, too.
measures world_measure(const world *w);

// FNV-1a over the bytes of all positions: equal bits, equal hash, between
// machines that store numbers in the same order of bytes.
unsigned long long world_hash(const world *w);
//<
