// whole.h - how do some particles move, as a whole?
//
// Units: metres, seconds, kilograms, joules, in the world's frame.

#ifndef TUMBLE_WHOLE_H
#define TUMBLE_WHOLE_H

#include "verlet.h"

// All is of the moment half a step ago: velocities are (position - previous) /
// dt, places the middle of the two.
typedef struct {
    real mass;          // kg
    vec3 center;        // m, of mass
    vec3 velocity;      // m/s, of the centre of mass
    vec3 angular;       // kg m^2/s, angular momentum about the centre
    vec3 spin;          // rad/s: a rigid body with these masses, these places
                        // and this angular momentum would turn so.  What
                        // stands in a line has none about that line
    real flight;        // J, of the mass, if it were all at the centre
    real turning;       // J, of that rigid body's turning about the centre
    real rest;          // J, of what the particles do beside: bending,
                        // stretching, trembling.  The three add up to all
} whole;

// Of n particles, whose last step took dt (s).  Pinned particles do not count.
// If none is free, everything is 0.
whole whole_of(const particle *p, int n, real dt);

#endif
