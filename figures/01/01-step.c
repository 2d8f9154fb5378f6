// 01-step.c - the idea of Verlet's step, and of Taylor's theorem: the points
// that 01-step.gp draws.

#include "verlet.h"

#include <math.h>
#include <stdio.h>

static void print(const char *name, vec3 v)
{
    printf("\"%s\" %.4f %.4f\n", name, v.x, v.y);
}

int main(void)
{
    // A thrown ball: three positions, and where it would be without gravity.
    real dt = 0.3;
    vec3 gravity = { 0, -9.81, 0 }, start = { 0, 0, 0 }, speed = { 3, 4.4, 0 };
    particle p = particle_start(start, speed, gravity, 1, dt);
    verlet_step(&p, 1, gravity, NULL, dt);
    printf("# name x y\n");
    print("before", p.previous);
    print("now", p.position);
    print("straight on", vec3_add(p.position, vec3_sub(p.position,
                                                       p.previous)));
    verlet_step(&p, 1, gravity, NULL, dt);
    print("after", p.position);

    printf("\n\n# the path: x y\n");
    for (int k = -2; k <= 22; k++) {
        real t = k * dt / 10;
        printf("%.4f %.4f\n", speed.x * t,
               speed.y * t + gravity.y * t * t / 2);
    }

    // A curve, x(t) = sin t, and what its derivatives at t = 0.7 say of it.
    const real at = 0.7, x = sin(at), v = cos(at), a = -sin(at);
    printf("\n\n# h x(t + h) and Taylor's first three guesses\n");
    for (int k = -14; k <= 26; k++) {
        real h = k * 0.1;
        printf("%.2f %.4f %.4f %.4f %.4f\n", h, sin(at + h), x, x + v * h,
               x + v * h + a * h * h / 2);
    }
    return 0;
}
