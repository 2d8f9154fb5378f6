//> hear-write
//>   A contact has a line of a table, to which each substep adds what the contact gave;
//>   a substep that is done again counts once. Where it was is asked once, for that costs more than
//>   the sum. Every impact is one more line.
#include "hear.h"
#include "table.h"

// The points of c, each with its share; of an impact all alike.
static vec3 heard_at(const world *w, const contact *c)
{
    const solver_body *now = w->rigid.now;
    vec3 sum = { 0, 0, 0 };
    real load = contact_load(c), even = load > 0 ? 0 : 1.0 / c->count;
    for (int k = 0; k < c->count; k++) {
        contact_arms arm = contact_arms_of(c, k, &now[c->a].frame,
                                           c->b < 0 ? NULL : &now[c->b].frame);
        real fraction = load > 0 ? c->impulse[k] / load : even;
        sum = vec3_add_scaled(sum, fraction, arm.a);
    }
    return vec3_add(now[c->a].frame.center, sum);
}

// If there is no memory, it is not written.
static void hear_impact(void *listener, const contact *c, real impulse)
{
    world *w = listener;
    rigid_tables *t = &w->rigid;
    if (!(impulse > 0) || c->count == 0) return;
    if (!TABLE_ADD(t->heard, t->hears, t->heard_room)) return;
    t->heard[t->hears++] = (heard_impulse){ c->a, c->b, heard_at(w, c),
                                            c->normal, impulse };
}

// A line for each contact of the rung, in their order.  If there is no memory,
// this substep is not written, and the next one tries again.
static bool begin_lines(world *w)
{
    rigid_tables *t = &w->rigid;
    int from = t->hears;
    for (int k = t->solver.first; k < t->solver.end; k++) {
        const contact *c = t->cache.active[k];
        if (!TABLE_ADD(t->heard, t->hears, t->heard_room)) {
            t->hears = from;
            return false;
        }
        t->heard[t->hears++] = (heard_impulse){ .a = c->a, .b = c->b };
    }
    t->heard_from = from;
    return true;
}

void hear_contacts(world *w)
{
    rigid_tables *t = &w->rigid;
    solver_store(&t->solver, w->options.host.run, t->cache.active);
    if (t->heard_from < 0 && !begin_lines(w)) return;
    heard_impulse *line = t->heard + t->heard_from;
    for (int k = t->solver.first; k < t->solver.end; k++, line++) {
        const contact *c = t->cache.active[k];
        real load = contact_load(c);
        if (!(load > 0) || c->count == 0) continue;
        if (line->impulse == 0) {
            line->point = heard_at(w, c);
            line->normal = c->normal;
        }
        line->impulse += load;
    }
}

void hear_impacts(world *w, solver_frame *f)
{
    f->hear = hear_impact;
    f->listener = w;
    w->rigid.heard_from = -1;
}
//<

//> hear-choose
//>   What a program does not want in this part of a frame is left out, and carries
//>   nothing over to the next.
void hear_choose(world *w)
{
    contact_cache *cache = &w->rigid.cache;
    const world_host *host = &w->options.host;
    int kept = 0;
    for (int k = 0; k < cache->actives; k++) {
        contact *c = cache->active[k];
        if (c->count > 0 && !host->meets(host->chooser, c)) {
            contact_clear(c);
            cache->of[k]->is_active = false;
            continue;
        }
        cache->active[kept] = c;
        cache->of[kept] = cache->of[k];
        cache->reach[kept++] = cache->reach[k];
    }
    cache->actives = kept;
}
//<
