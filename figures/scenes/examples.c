// examples.c - the scenes, in the order of the book.
#include "example.h"

#include <math.h>
#include <stddef.h>

const example *const examples[] = {
    &pyramid, &dominoes, &cradle, &bridge, &ragdoll, &wrecker, &marbles, &flag,
    &curtain, &blanket, &car_scene, &crane, &terrain, &walker_scene,
    &belt_scene, &cape_scene, NULL };

double example_error(const example *s, tumble_world *w)
{
    if (s->error) return s->error(w);
    example_law is[EXAMPLE_LAWS];
    int n = s->laws(w, is);
    double worst = 0;
    for (int k = 0; k < n; k++) {
        double of = is[k].law == 0 ? 1 : fabs(is[k].law);
        double off = fabs(is[k].measured - is[k].law) / of;
        if (off != off) return off;
        if (off > worst) worst = off;
    }
    return worst;
}
