// solution.c - Taylor backward for the velocity, and forward with it.

#include "hiccup.h"

void step_changed(particle *p, int n, vec3 gravity, const vec3 *force,
                  real dt_before, real dt)
{
    real carry = dt / dt_before, square = dt * (dt_before + dt) / 2;
    for (int i = 0; i < n; i++) {
        vec3 here = p[i].position;
        if (p[i].inverse_mass > 0) {
            vec3 a = gravity;
            if (force) a = vec3_add_scaled(a, p[i].inverse_mass, force[i]);
            vec3 last_move = vec3_sub(here, p[i].previous);
            vec3 move = vec3_add_scaled(vec3_scale(carry, last_move), square, a);
            p[i].position = vec3_add(here, move);
        }
        p[i].previous = here;
    }
}
