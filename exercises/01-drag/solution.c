// solution.c - drag by the velocity in the middle, which is still to come.

#include "drag.h"

#include <assert.h>

//     m (x' - 2 x + x_previous) / dt^2
//         = m g - drag ((x' - x_previous) / 2 dt - wind)
// is linear in x'.  With k = drag dt / 2 m, and moves instead of places,
//     move' (1 + k) = move (1 - k) + g dt^2 + 2 k dt wind.
// |1 - k| / (1 + k) is never more than 1: no drag is too large.
static vec3 next_move(vec3 move, real k, vec3 gravity, vec3 wind, real dt)
{
    vec3 sum = vec3_scale(1 - k, move);
    sum = vec3_add_scaled(sum, dt * dt, gravity);
    sum = vec3_add_scaled(sum, 2 * k * dt, wind);
    return vec3_scale(1 / (1 + k), sum);
}

void drag_step(particle *p, int n, vec3 gravity, real drag, vec3 wind, real dt)
{
    assert(n >= 0 && drag >= 0 && dt > 0);
    for (int i = 0; i < n; i++) {
        vec3 here = p[i].position;
        if (p[i].inverse_mass > 0) {
            vec3 move = vec3_sub(here, p[i].previous);
            real k = drag * p[i].inverse_mass * dt / 2;
            move = next_move(move, k, gravity, wind, dt);
            p[i].position = vec3_add(here, move);
        }
        p[i].previous = here;
    }
}
