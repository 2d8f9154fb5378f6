// solution.c - down the rope with one division a link, and up again.

#include "thomas.h"

// Row k, freed of x[k - 1] by x[k - 1] = g - h x[k], is a row for x[k] and
// x[k + 1] alone.
int thomas_solve(int n, const real *lower, const real *diagonal,
                 const real *upper, const real *right, real *x, real *share)
{
    real g = 0, h = 0;
    for (int k = 0; k < n; k++) {
        real down = k > 0 ? lower[k] : 0;
        real pivot = diagonal[k] - down * h;
        if (!(fabs(pivot) > 1e-12 * fabs(diagonal[k]))) return 0;
        h = k + 1 < n ? upper[k] / pivot : 0;
        g = (right[k] - down * g) / pivot;
        share[k] = h;
        x[k] = g;
    }
    for (int k = n - 2; k >= 0; k--) x[k] -= share[k] * x[k + 1];
    return 1;
}

static vec3 link_of(const particle *p, int k)
{
    return vec3_sub(p[k + 1].position, p[k].position);
}

// A link hears its own pull and those of its neighbours.  Particle k goes by
// w_k (multiplier_k link_k - multiplier_(k-1) link_(k-1)).
int rope_step(particle *p, int links, real rest, real *room)
{
    real *lower = room, *diagonal = lower + links, *upper = diagonal + links;
    real *wrong = upper + links, *share = wrong + links;
    for (int k = 0; k < links; k++) {
        vec3 u = link_of(p, k);
        real w = p[k].inverse_mass, next = p[k + 1].inverse_mass;
        lower[k] = k > 0 ? -w * vec3_dot(u, link_of(p, k - 1)) : 0;
        diagonal[k] = (w + next) * vec3_dot(u, u);
        upper[k] = k + 1 < links ? -next * vec3_dot(u, link_of(p, k + 1)) : 0;
        wrong[k] = (vec3_dot(u, u) - rest * rest) / 2;
    }
    if (!thomas_solve(links, lower, diagonal, upper, wrong, wrong, share))
        return 0;
    vec3 before = { 0, 0, 0 };
    for (int k = 0; k <= links; k++) {
        vec3 pull = { 0, 0, 0 };
        if (k < links) pull = vec3_scale(wrong[k], link_of(p, k));
        p[k].position = vec3_add_scaled(p[k].position, p[k].inverse_mass,
                                        vec3_sub(pull, before));
        before = pull;
    }
    return 1;
}
