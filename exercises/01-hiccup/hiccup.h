// hiccup.h - Verlet's step when the time step changes.

#ifndef TUMBLE_HICCUP_H
#define TUMBLE_HICCUP_H

#include "verlet.h"

// One step of dt (s) for n particles whose last step took dt_before (s), with
// a = gravity (m/s^2) + inverse_mass * force (N).  force holds n vectors, or is
// NULL for none.  Pinned particles stay, with previous = position.
void step_changed(particle *p, int n, vec3 gravity, const vec3 *force,
                  real dt_before, real dt);

#endif
