//> plain-proof-apart
//>   A feature is a corner, an edge or a triangle. What it sweeps over lies in the
//>   hull of where its corners begin and where they end, and if those hulls of two
//>   features are apart, the two never meet.
#include "plain_proof.h"

#include <stdbool.h>

typedef struct {
    int count, corner[3];
} feature;

// m: so far apart nothing is rounding (of places within a few hundred metres).
static const real APART = 1e-12;

static hull swept_over(const plain_cloth *c, const feature *f, vec3 at[6])
{
    for (int k = 0; k < f->count; k++) {
        at[k] = c->from[f->corner[k]];
        at[f->count + k] = c->to[f->corner[k]];
    }
    return (hull){ at, 2 * f->count };
}

static bool never_meet(const plain_cloth *c, const feature *f, const feature *g)
{
    vec3 of_f[6], of_g[6];
    hull a = swept_over(c, f, of_f), b = swept_over(c, g, of_g);
    simplex none = { .count = 0 };
    return gjk_distance(a, b, HUGE_VAL, &none).distance > APART;
}
//<

//> plain-proof
//>   Two that may meet go half as far, as often as it takes. A shorter move stays in
//>   its hull, so no proof is lost, and each pair is looked at once.
static void halve(plain_cloth *c, const feature *f)
{
    for (int k = 0; k < f->count; k++) {
        int v = f->corner[k];
        c->to[v] = vec3_scale(0.5, vec3_add(c->from[v], c->to[v]));
    }
}

static int prove(plain_cloth *c, const feature *f, const feature *g)
{
    int halved = 0;
    for (int k = 0; k < 3 * g->count; k++)
        if (f->corner[k / g->count % f->count] == g->corner[k % g->count]) return 0;
    while (halved < 50 && !never_meet(c, f, g)) {
        halve(c, f);
        halve(c, g);
        halved++;
    }
    return halved;
}

static feature edge_of(const plain_cloth *c, int e)
{
    const int *v = c->face[e / 3];
    return (feature){ 2, { v[e % 3], v[(e + 1) % 3] } };
}

// What all do together crosses nothing, and is not shortened.
static vec3 mean_move(const plain_cloth *c)
{
    vec3 sum = { 0, 0, 0 };
    for (int v = 0; v < c->particles; v++)
        sum = vec3_add(sum, vec3_sub(c->to[v], c->from[v]));
    return vec3_scale(1.0 / c->particles, sum);
}

int plain_proof(plain_cloth *c)
{
    int halved = 0;
    vec3 mean = mean_move(c);
    for (int v = 0; v < c->particles; v++) c->to[v] = vec3_sub(c->to[v], mean);
    for (int k = 0; k < c->faces; k++) {
        const int *v = c->face[k];
        feature face = { 3, { v[0], v[1], v[2] } };
        for (int p = 0; p < c->particles; p++)
            halved += prove(c, &(feature){ 1, { p } }, &face);
    }
    for (int e = 0; e < 3 * c->faces; e++)
        for (int d = 0; d < e; d++) {
            feature one = edge_of(c, e), other = edge_of(c, d);
            halved += prove(c, &one, &other);
        }
    for (int v = 0; v < c->particles; v++) c->to[v] = vec3_add(c->to[v], mean);
    return halved;
}
//<
