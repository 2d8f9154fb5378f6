// 01-spring.c - neighbouring positions (x_k, x_k+1) of a spring under Verlet's
// step: on an ellipse while omega dt < 2, on a hyperbola beyond.

#include "verlet.h"

#include <math.h>
#include <stdio.h>

int main(void)
{
    const struct { real omega_dt; int steps; } run[] = {
        { 1.2, 40 }, { 1.9, 60 }, { 2.05, 6 }
    };
    const vec3 none = { 0, 0, 0 };
    for (int i = 0; i < 3; i++) {
        real square = run[i].omega_dt * run[i].omega_dt, c = 2 - square;
        particle p = particle_start((vec3){ 1, 0, 0 }, none,
                                    (vec3){ -square, 0, 0 }, 1, 1);
        real first = 0, off = 0;
        printf("%s# omega dt %.2f: x_k x_k+1\n", i ? "\n\n" : "",
               run[i].omega_dt);
        for (int k = 0; k < run[i].steps; k++) {
            vec3 force = vec3_scale(-square, p.position);
            verlet_step(&p, 1, none, &force, 1);
            real x = p.previous.x, y = p.position.x;
            real kept = y * y - c * x * y + x * x;
            if (k == 0) first = kept;
            off = fmax(off, fabs(kept - first));
            printf("%.5f %.5f\n", x, y);
        }
        printf("# X^2 - c X Y + Y^2 = %.4f, kept to %.0e\n", first, off);
    }
    return 0;
}
