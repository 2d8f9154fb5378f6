// solution.c - each attracts each.

#include "eight.h"

// Every pair once: what pulls i to j pulls j to i.
void attract(const particle *p, const real *mass, int n, real G, vec3 *force)
{
    for (int i = 0; i < n; i++) force[i] = (vec3){ 0, 0, 0 };
    for (int i = 0; i < n; i++)
        for (int j = i + 1; j < n; j++) {
            vec3 r = vec3_sub(p[j].position, p[i].position);
            real d = vec3_length(r);
            if (d == 0) continue;
            real k = G * mass[i] * mass[j] / (d * d * d);
            force[i] = vec3_add_scaled(force[i], k, r);
            force[j] = vec3_add_scaled(force[j], -k, r);
        }
}

vec3 area_swept(const particle *p, vec3 sun)
{
    vec3 before = vec3_sub(p->previous, sun);
    vec3 now = vec3_sub(p->position, sun);
    return vec3_scale(0.5, vec3_cross(before, now));
}
