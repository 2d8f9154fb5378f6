// bounce.h - restitution, through the previous positions.
//
// Units: metres, seconds, kilograms.  Frame: the world's.

#ifndef TUMBLE_BOUNCE_H
#define TUMBLE_BOUNCE_H

#include "response.h"

// Gives the two points of c, which came together at `approach` (m/s, along the
// normal, > 0) in a step of dt (s, > 0), the speed of parting restitution *
// approach; or -approach, if that is positive.  Moves previous positions alone.
void bounce(const feature_contact *c, particle *p, real restitution,
            real approach, real dt);

#endif
