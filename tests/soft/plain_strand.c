//> plain-strand
#include "plain_strand.h"

#include <assert.h>

// How far a pull (kg m) moves a particle, if nothing lets go: W pull.
static vec3 answer(const plain_particle *p, vec3 pull)
{
    return vec3_add_scaled(vec3_scale(p->weight, pull),
                           -vec3_dot(p->hold, pull), p->hold);
}

// From what holds its ends, a link does not ask for quite all.
static real spared(const plain_particle *p, vec3 link)
{
    return 0.005 * vec3_length_squared(p->hold) * vec3_length_squared(link);
}

// Downwards: lambda_k = g_k - h_k lambda_(k+1).
static void eliminate(const plain_particle *p, const vec3 *u, int links,
                      real rest, real *g, real *h)
{
    for (int k = 0; k < links; k++) {
        const plain_particle *a = &p[k], *b = &p[k + 1];
        real wrong = (vec3_length_squared(u[k]) - rest * rest) / 2;
        real diagonal = vec3_dot(u[k], answer(a, u[k])) + spared(a, u[k])
                      + vec3_dot(u[k], answer(b, u[k])) + spared(b, u[k]);
        real lower = k == 0 ? 0 : -vec3_dot(u[k], answer(a, u[k - 1]));
        real upper = k + 1 == links ? 0 : -vec3_dot(u[k], answer(b, u[k + 1]));
        real pivot = diagonal - (k == 0 ? 0 : lower * h[k - 1]);
        h[k] = upper / pivot;
        g[k] = (wrong - (k == 0 ? 0 : lower * g[k - 1])) / pivot;
    }
}

// What a surface holds, it holds from outside: a pull away from it is free.
vec3 plain_move(const plain_particle *p, vec3 pull)
{
    bool lifts = vec3_dot(p->hold, pull) > 0;
    return lifts ? vec3_scale(p->weight, pull) : answer(p, pull);
}

void plain_strand(plain_particle *p, int links, real rest)
{
    vec3 u[PLAIN_LINKS], none = { 0, 0, 0 };
    real g[PLAIN_LINKS], h[PLAIN_LINKS];
    assert(links >= 1 && links <= PLAIN_LINKS);
    for (int k = 0; k < links; k++) u[k] = vec3_sub(p[k + 1].at, p[k].at);
    eliminate(p, u, links, rest, g, h);

    // Upwards.  Each particle moves as soon as it knows both its links' pulls.
    real lambda = 0;
    vec3 below = none;
    for (int k = links; k >= 0; k--) {
        if (k > 0) lambda = g[k - 1] - h[k - 1] * lambda;
        vec3 above = k > 0 ? vec3_scale(lambda, u[k - 1]) : none;
        vec3 pull = vec3_sub(below, above);
        p[k].at = vec3_add(p[k].at, plain_move(&p[k], pull));
        below = above;
    }
}
//<
