// bumper.h - a spring and a damper that push, and never explode.
//
// Units: metres, seconds, kilograms.  A push is an impulse times h, in
// kg m: what it changes are places.

#ifndef TUMBLE_BUMPER_H
#define TUMBLE_BUMPER_H

#include "verlet.h"

// Between particle a and particle b, which is away from it along `normal` by
// less than `thickness`: a bumper is pressed by depth = thickness - (b - a) .
// normal (m), and pushes b along normal, a against it, with
//     stiffness (N/m) depth + damping (N s/m) d(depth)/dt,
// but never less than nothing: it does not pull.
typedef struct {
    int  a, b;
    vec3 normal;        // unit
    real thickness;     // m
    real stiffness;     // N/m, >= 0
    real damping;       // N s/m, >= 0
    real pushed;        // kg m, in this substep so far
} bumper;

// One look at a bumper in a substep of h (s): the particles have moved, and
// c->pushed has pushed them already.  Corrects that sum so that it is h^2 times
// the force that the bumper has at the END of the substep, after the
// correction; moves the particles by the change; returns the change (kg m).
// Depth and its speed are those between `previous` and `position`.
real bumper_push(bumper *c, particle *p, real h);

// A substep for n bumpers that share particles: begins with nothing pushed, and
// looks at each in turn, there and back, until a round changes no sum by more
// than `enough` (kg m), but at most `rounds` times (>= 1).  Returns how many
// rounds it took.
int bumpers_solve(bumper *c, int n, particle *p, real h, real enough,
                  int rounds);

#endif
