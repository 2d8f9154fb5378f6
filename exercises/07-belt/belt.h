// belt.h - a floor that runs.
//
// Units: metres, seconds, kilograms.  Frame: the world's.

#ifndef TUMBLE_BELT_H
#define TUMBLE_BELT_H

#include "response.h"

// A plane whose surface runs along itself.
typedef struct {
    vec3 point;         // m, any point of the surface
    vec3 normal;        // unit, out of the belt
    vec3 velocity;      // m/s, of the surface, perpendicular to the normal
    real friction;      // Coulomb's coefficient mu, >= 0
} belt;

// Lifts p out of the belt if it is in it, and brakes its sliding against the
// belt, in the last step of dt (s, > 0), by at most friction times the overlap.
// Returns the overlap before (m, >= 0).  A pinned particle stays.
real belt_push(const belt *b, particle *p, real dt);

#endif
