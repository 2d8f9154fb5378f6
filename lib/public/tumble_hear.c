//> face-hear
//>   What was written down in a step is a line for each contact and each impact. They
//>   are sorted, and those of a pair added. What has not pushed is left out.
#include "inside.h"
#include "table.h"

#include <stdlib.h>

bool tumble_world_listen(tumble_world *w, bool on)
{
    if (!inside_is_world(w)) return false;
    w->world.rigid.listens = on;
    if (!on) w->world.rigid.hears = 0;
    return true;
}

// The body that came first is a.
static tumble_impulse impulse_of(const tumble_world *w, const heard_impulse *h)
{
    tumble_impulse x = { inside_owner(w, h->a), inside_owner(w, h->b),
                         to_user(h->point), to_user(h->normal), h->impulse };
    if (x.a.place <= x.b.place) return x;
    SWAP(tumble_body, x.a, x.b);
    x.normal = to_user(vec3_scale(-1, h->normal));
    return x;
}

static int by_pair(const void *p, const void *q)
{
    const tumble_impulse *x = p, *y = q;
    int order = inside_compare(x->a.place, y->a.place);
    if (order == 0) order = inside_compare(x->b.place, y->b.place);
    if (order != 0) return order;
    // Those of a pair, too, always in one order: their sum has bits.
    if (x->impulse != y->impulse) return x->impulse < y->impulse ? -1 : 1;
    if (x->point.x != y->point.x) return x->point.x < y->point.x ? -1 : 1;
    return (x->point.z > y->point.z) - (x->point.z < y->point.z);
}

// Those of one pair, n of them, as one.
static tumble_impulse added_up(const tumble_impulse *x, int n)
{
    vec3 point = { 0, 0, 0 }, normal = { 0, 0, 0 };
    tumble_impulse all = *x;
    all.impulse = 0;
    for (int k = 0; k < n; k++) {
        point = vec3_add_scaled(point, x[k].impulse, from_user(x[k].point));
        normal = vec3_add_scaled(normal, x[k].impulse, from_user(x[k].normal));
        all.impulse += x[k].impulse;
    }
    all.point = to_user(vec3_scale(1 / all.impulse, point));
    all.normal = to_user(vec3_unit(normal));
    return all;
}

int tumble_world_impulses(const tumble_world *w, tumble_impulse *out, int most)
{
    int n = 0, count = 0, lines = w ? w->world.rigid.hears : 0;
    if (lines == 0) return 0;
    tumble_impulse *list = malloc((size_t)lines * sizeof *list);
    if (!list) return 0;
    for (int k = 0; k < lines; k++) {
        const heard_impulse *h = &w->world.rigid.heard[k];
        if (h->impulse > 0) list[count++] = impulse_of(w, h);
    }
    qsort(list, (size_t)count, sizeof *list, by_pair);
    for (int k = 0, end; k < count; k = end) {
        for (end = k + 1; end < count; end++)
            if (list[k].a.place != list[end].a.place
                || list[k].b.place != list[end].b.place) break;
        if (out && n < most) out[n] = added_up(list + k, end - k);
        n++;
    }
    free(list);
    return n;
}
//<

//> face-choose
//>   A program that chooses sees a contact as tumble_world_contacts tells of
//>   it, before it has pushed.
static bool call_filter(void *chooser, const contact *c)
{
    const tumble_world *w = chooser;
    const solver_body *now = w->world.rigid.now;
    tumble_contact t = inside_contact(w, c, &now[c->a].frame,
                                      c->b < 0 ? NULL : &now[c->b].frame, false);
    return w->meets(w->meets_context, &t);
}

bool tumble_world_choose_contacts(tumble_world *w,
                                  bool (*meets)(void *context,
                                                const tumble_contact *c),
                                  void *context)
{
    if (!inside_is_world(w)) return false;
    world_host *host = &w->world.options.host;
    w->meets = meets;
    w->meets_context = context;
    host->meets = meets ? call_filter : NULL;
    host->chooser = w;
    return true;
}
//<
