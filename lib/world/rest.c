//> rest-init
#include "rest.h"

#include <assert.h>
#include <stdlib.h>

status rest_init(rest_state *r, int bodies)
{
    assert(bodies >= 0);
    size_t n = bodies > 0 ? (size_t)bodies : 1;
    *r = (rest_state){ .bodies = bodies,
        .parent = calloc(n, sizeof *r->parent),
        .island = calloc(n, sizeof *r->island),
        .calm   = calloc(n, sizeof *r->calm),
        .asleep = calloc(n, sizeof *r->asleep),
        .restless = calloc(n, sizeof *r->restless) };
    if (!r->parent || !r->island || !r->calm || !r->asleep || !r->restless) {
        rest_free(r);
        return status_out_of_memory();
    }
    return status_ok();
}

void rest_free(rest_state *r)
{
    free(r->parent);
    free(r->island);
    free(r->calm);
    free(r->asleep);
    free(r->restless);
    *r = (rest_state){ .bodies = 0 };
}
//<

//> rest-touch
// The body that stands for b's island.  Every step shortens the way for the
// next one (path halving); parents never have a higher number, so it ends.
static int island_of(rest_state *r, int b)
{
    while (r->parent[b] != b) {
        r->parent[b] = r->parent[r->parent[b]];
        b = r->parent[b];
    }
    return b;
}

void rest_touch(rest_state *r, int a, int b)
{
    assert(a >= 0 && a < r->bodies && b >= 0 && b < r->bodies);
    int i = island_of(r, a), j = island_of(r, b);
    if (i < j) r->parent[j] = i;
    else       r->parent[i] = j;
}

// Bodies that fell asleep together stay one island until they wake, for
// nobody looks for contacts between sleepers.
void rest_begin(rest_state *r)
{
    for (int b = 0; b < r->bodies; b++) r->parent[b] = b;
    for (int b = 0; b < r->bodies; b++)
        if (r->asleep[b]) rest_touch(r, b, r->island[b]);
}
//<

//> rest-end
void rest_end(rest_state *r, const char *slow, real dt, real patience)
{
    for (int b = 0; b < r->bodies; b++) {
        r->calm[b] = slow[b] ? r->calm[b] + dt : 0;
        r->restless[b] = 0;
    }
    for (int b = 0; b < r->bodies; b++)
        if (r->calm[b] < patience) r->restless[island_of(r, b)] = 1;
    for (int b = 0; b < r->bodies; b++) {
        int root = island_of(r, b);
        if (r->restless[root]) continue;
        r->asleep[b] = 1;
        r->island[b] = root;
    }
}

void rest_wake(rest_state *r, int b)
{
    assert(b >= 0 && b < r->bodies);
    if (!r->asleep[b]) return;
    int island = r->island[b];
    for (int i = 0; i < r->bodies; i++) {
        if (!r->asleep[i] || r->island[i] != island) continue;
        r->asleep[i] = 0;
        r->calm[i] = 0;
    }
}
//<
