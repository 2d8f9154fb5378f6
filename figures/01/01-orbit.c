// 01-orbit.c - the path of a planet on a circle, five orbits of 60 steps each,
// under explicit Euler and under Verlet.

#include "euler.h"
#include "verlet.h"

#include <math.h>
#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { STEPS = 60, ORBITS = 5 };

static vec3 pull(vec3 x)
{
    real r = vec3_length(x);
    return vec3_scale(-1 / (r * r * r), x);
}

int main(void)
{
    printf("# A circular orbit, %d steps each: position under explicit Euler "
           "and under Verlet\n# %s, %s\n# euler_x euler_y verlet_x verlet_y\n",
           STEPS, __VERSION__, FLAGS);
    vec3 x0 = { 1, 0, 0 }, v0 = { 0, 1, 0 }, none = { 0, 0, 0 };
    real dt = 2 * 3.14159265358979323846 / STEPS;
    euler_particle e = { x0, v0 };
    particle p = particle_start(x0, v0, pull(x0), 1, dt);
    real nearest = 1, furthest = 1, end = 1;
    for (int k = 0; k <= ORBITS * STEPS; k++) {
        printf("%.5f %.5f %.5f %.5f\n", e.position.x, e.position.y,
               p.position.x, p.position.y);
        nearest = fmin(nearest, vec3_length(p.position));
        furthest = fmax(furthest, vec3_length(p.position));
        end = vec3_length(e.position);
        vec3 force = pull(e.position);
        euler_step_explicit(&e, force, dt);
        force = pull(p.position);
        verlet_step(&p, 1, none, &force, dt);
    }
    printf("# Euler ends at %.2f radii; Verlet stays between %.4f and %.4f\n",
           end, nearest, furthest);
    return 0;
}
