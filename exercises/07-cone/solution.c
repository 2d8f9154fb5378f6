// solution.c - the nearest push of a cone, and surfaces that take turns.

#include "cone.h"

// Seen in the plane of the normal and the wish: the wish is (n, t), t >= 0, and
// the cone is t <= mu n, whose rim has the direction (1, mu).  The foot of the
// wish on the rim is k (1, mu), with k = (n + mu t) / (1 + mu^2).
vec3 cone_nearest(vec3 wish, vec3 normal, real mu)
{
    real n = vec3_dot(wish, normal);
    vec3 across = vec3_add_scaled(wish, -n, normal);
    real t = vec3_length(across);
    if (t <= mu * n) return wish;
    // The foot would lie behind the tip.
    if (n + mu * t <= 0) return (vec3){ 0, 0, 0 };

    // Here t > 0: with t = 0, n would be in one of the cases above.
    real k = (n + mu * t) / (1 + mu * mu);
    return vec3_add_scaled(vec3_scale(k, normal), mu * k / t, across);
}

real grip(const vec3 *normal, int n, real mu, vec3 load, int rounds,
          vec3 *push)
{
    vec3 sum = load;
    for (int i = 0; i < n; i++) push[i] = (vec3){ 0, 0, 0 };
    for (int round = 0; round < rounds; round++) {
        for (int i = 0; i < n; i++) {
            vec3 others = vec3_sub(sum, push[i]);
            push[i] = cone_nearest(vec3_scale(-1, others), normal[i], mu);
            sum = vec3_add(others, push[i]);
        }
    }
    return vec3_length(sum);
}
