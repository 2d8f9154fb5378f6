//> face-contacts
//>   What touches: a list is made when a program asks, and of sleeping bodies
//>   it holds what they touched when they fell asleep.
#include "inside.h"

#include <stdlib.h>

// Bodies that sleep are not asked: they touch as they did when they fell asleep.
static bool sleeps_there(const world *w, int b)
{
    return b < 0 || !body_moves(w, b);
}

// The contact that the cache keeps of a pair; NULL if the two do not push each
// other.
static const contact *pushing_contact(const world *w, const cache_pair *p)
{
    if (p->entry < 0 || p->count == 0) return NULL;
    const contact *c = &w->rigid.cache.entry[p->entry].contact;
    bool is_known = p->is_active
                 || (sleeps_there(w, c->a) && sleeps_there(w, c->b));
    return is_known && contact_load(c) > 0 ? c : NULL;
}

// s: the substep that its impulses are of.
static real contact_age(const world *w, const contact *c)
{
    return body_age(w, body_is_dynamic(&w->body[c->a]) ? c->a : c->b);
}

tumble_contact inside_contact(const tumble_world *w, const contact *c,
                              const rigid_frame *a, const rigid_frame *b,
                              bool has_pushed)
{
    tumble_contact t = { .a = inside_owner(w, c->a),
                         .b = inside_owner(w, c->b),
                         .normal = to_user(c->normal) };
    for (int k = 0; k < c->count; k++) {
        if (has_pushed && !(c->impulse[k] > 0)) continue;
        contact_arms arm = contact_arms_of(c, k, a, b);
        t.point[t.points] = to_user(vec3_add(a->center, arm.a));
        if (has_pushed)
            t.force[t.points] = c->impulse[k] / contact_age(&w->world, c);
        t.points++;
    }
    return t;
}

static tumble_contact public_contact(const tumble_world *w, const contact *c)
{
    rigid_frame a = inside_frame(w, c->a), b = inside_frame(w, c->b);
    return inside_contact(w, c, &a, c->b < 0 ? NULL : &b, true);
}

int tumble_world_contacts(const tumble_world *w, tumble_contact *out, int most)
{
    if (!w) return 0;
    const cache_list *list = &w->world.rigid.cache.pairs;
    const cache_list *still = &w->world.rigid.cache.still;
    int n = 0;
    for (int k = 0, j = 0; k < list->count || j < still->count;) {
        const cache_pair *p = cache_next(list, &k, still, &j);
        const contact *c = pushing_contact(&w->world, p);
        if (!c) continue;
        if (out && n < most) out[n] = public_contact(w, c);
        n++;
    }
    return n;
}
//<

//> face-events
static int by_bodies(const void *p, const void *q)
{
    const tumble_contact *a = p, *b = q;
    int order = inside_compare(a->a.place, b->a.place);
    if (order == 0) order = inside_compare(a->a.generation, b->a.generation);
    if (order == 0) order = inside_compare(a->b.place, b->b.place);
    return order != 0 ? order : inside_compare(a->b.generation, b->b.generation);
}

// The pairs that touch now, each once, sorted; n of them.
static tumble_contact *touching_now(const tumble_world *w, int *n)
{
    int all = tumble_world_contacts(w, NULL, 0);
    tumble_contact *list = malloc(((size_t)all + 1) * sizeof *list);
    *n = 0;
    if (!list) return NULL;
    tumble_world_contacts(w, list, all);
    if (all > 0) qsort(list, (size_t)all, sizeof *list, by_bodies);
    for (int k = 0; k < all; k++)
        if (*n == 0 || by_bodies(&list[*n - 1], &list[k]) != 0)
            list[(*n)++] = list[k];
    return list;
}

// The point that bears most, and what all bear together.
static tumble_event event_of(const tumble_contact *c, bool begins)
{
    tumble_event e = { .a = c->a, .b = c->b, .begins = begins,
                       .normal = c->normal };
    double most = 0;
    for (int k = 0; k < c->points; k++) {
        if (c->force[k] > most) e.point = c->point[k];
        most = c->force[k] > most ? c->force[k] : most;
        e.force += c->force[k];
    }
    return e;
}

// Pairs, each once, sorted.
typedef struct {
    tumble_contact *at;
    int count;
} pairs_told;

// Which comes first of pair i of those that were, and pair k of those that are now?
// < 0: the old one, which has ended; 0: they are one pair.
static int compare_contact_pairs(pairs_told was, int i, pairs_told now, int k)
{
    if (i == was.count) return 1;
    return k == now.count ? -1 : by_bodies(&was.at[i], &now.at[k]);
}

static int differences(pairs_told was, pairs_told now, tumble_event *out,
                       int most)
{
    int n = 0, i = 0, k = 0;
    while (i < was.count || k < now.count) {
        int first = compare_contact_pairs(was, i, now, k);
        if (first != 0 && out && n < most)
            out[n] = event_of(first < 0 ? &was.at[i] : &now.at[k], first > 0);
        n += first != 0;
        i += first <= 0;
        k += first >= 0;
    }
    return n;
}

int tumble_world_events(tumble_world *w, tumble_event *out, int most)
{
    int now;
    if (!inside_is_world(w)) return 0;
    tumble_contact *list = touching_now(w, &now);
    if (!list) return inside_is_ok(w, status_out_of_memory()), 0;
    int n = differences((pairs_told){ w->touching, w->touchings },
                        (pairs_told){ list, now }, out, most);
    free(w->touching);
    w->touching = list;
    w->touchings = now;
    return n;
}
//<

//> face-sensor-events
//>   The same for sensors and what is in them.
static bool add_sensed(tumble_world *w, tumble_body sensor, pairs_told *all)
{
    int n = tumble_body_sensed(w, sensor, NULL, 0), count = all->count;
    if (n == 0) return true;
    tumble_contact *more = realloc(all->at, (size_t)(count + n) * sizeof *more);
    tumble_body *in = malloc((size_t)n * sizeof *in);
    if (more) all->at = more;
    if (more && in) {
        tumble_body_sensed(w, sensor, in, n);
        for (int k = 0; k < n; k++)
            more[count + k] = (tumble_contact){ .a = sensor, .b = in[k] };
        all->count += n;
    }
    free(in);
    return more && in;
}

int tumble_world_sensor_events(tumble_world *w, tumble_event *out, int most)
{
    pairs_told now = { NULL, 0 };
    bool is_done = inside_is_world(w);
    if (!is_done) return 0;
    for (int k = 0; k < w->bodies.count && is_done; k++) {
        const body_place *x = slots_at(&w->bodies, k);
        if (x && x->is_sensor)
            is_done = add_sensed(w, inside_body_in(w, k), &now);
    }
    if (!is_done) {
        free(now.at);
        inside_is_ok(w, status_out_of_memory());
        return 0;
    }
    if (now.count > 0)
        qsort(now.at, (size_t)now.count, sizeof *now.at, by_bodies);
    int n = differences((pairs_told){ w->sensed, w->senses }, now, out, most);
    free(w->sensed);
    w->sensed = now.at;
    w->senses = now.count;
    return n;
}
//<
