//> tumble-contacts
#include "inside.h"

#include <stdlib.h>

static bool is_pushing(const contact *c)
{
    return contact_load(c) > 0;
}

// Where body b of the engine stands.
static rigid_frame frame_of(const tumble_world *w, int b)
{
    return rigid4_frame(w->world.pool.at + w->world.body[b].first);
}

static tumble_contact told(const tumble_world *w, const contact *c)
{
    tumble_contact t = { .a = inside_owner(w, c->a),
                         .b = inside_owner(w, c->b),
                         .normal = to_user(c->normal) };
    rigid_frame a = frame_of(w, c->a);
    for (int k = 0; k < c->count; k++) {
        if (!(c->impulse[k] > 0)) continue;
        t.point[t.points] = to_user(frame_point(&a, c->point[k].local_a));
        t.impulse[t.points++] = c->impulse[k];
    }
    return t;
}

int tumble_contacts(const tumble_world *w, tumble_contact *out, int most)
{
    const contact_cache *cache = &w->world.rigid.cache;
    int n = 0;
    for (int k = 0; k < cache->actives; k++) {
        if (!is_pushing(cache->active[k])) continue;
        if (n < most) out[n] = told(w, cache->active[k]);
        n++;
    }
    return n;
}
//<

//> tumble-events
static int by_bodies(const void *p, const void *q)
{
    const touching_pair *a = p, *b = q;
    if (a->a != b->a) return a->a < b->a ? -1 : 1;
    return (a->b > b->b) - (a->b < b->b);
}
//<
