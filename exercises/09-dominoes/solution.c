// solution.c - a row, and a push.

#include "dominoes.h"

#include <stddef.h>

// I w^2 / 2 = m g (R - h/2), I = 2 m R^2, with 2 R the diagonal.  And
// R - h/2 = (R^2 - h^2/4) / (R + h/2) = (thickness^2 / 4) / (R + h/2).
real domino_least_spin(real thickness, real height, real g)
{
    real square = (thickness * thickness + height * height) / 4;
    real climb = thickness * thickness / 4 / (sqrt(square) + height / 2);
    return sqrt(g * climb / square);
}

status domino_row(scene *s, int number, vec3 sides, int n, real above, real gap,
                  real spin)
{
    for (int k = 0; k < n; k++) {
        placement p = placement_at((vec3){ k * (sides.x + gap),
                                           sides.y / 2 + above, 0 });
        if (k == 0) {
            vec3 from_edge = { -sides.x / 2, sides.y / 2, 0 };
            p.spin = (vec3){ 0, 0, -spin };
            p.velocity = vec3_cross(p.spin, from_edge);
        }
        status r = scene_add(s, number, p);
        if (!r.ok) return r;
    }
    return status_ok();
}

// From particle 0, below, to particle 2, above it.
real domino_lean(const particle_system *s, int b)
{
    const particle *p = &s->pool.at[s->body[b].first];
    vec3 up = vec3_sub(p[2].position, p[0].position);
    return atan2(sqrt(up.x * up.x + up.z * up.z), up.y);
}
