//> step-time
#include "step.h"
#include "soft.h"

#include <assert.h>
#include <stddef.h>

static real clock_now(const world *w)
{
    return w->options.clock ? w->options.clock() : 0;
}

// Books the time since *since to a stage, and starts the next.
static void lap(world *w, int stage, real *since)
{
    real now = clock_now(w);
    w->report.time[stage] += now - *since;
    *since = now;
}

static int moves(const world *w, int b)
{
    return !body_is_nailed(&w->body[b]) && !w->rest.asleep[b];
}
//<

//> step-integrate
static void integrate(world *w, real h)
{
    for (int b = 0; b < w->bodies; b++)
        if (moves(w, b))
            verlet_step(w->pool.at + w->body[b].first,
                        w->body[b].plan->particles, w->options.gravity,
                        NULL, h);
}
//<

//> step-reach
// How far body b may still go in this frame, in which it has just made the
// first of n substeps: n - 1 more like the fastest of its particles', and what
// gravity adds.  A hundredth of its radius covers what impacts add.
static void look_ahead(world *w, body *b, int is_moving)
{
    int n = w->options.substeps;
    real fastest = 0;
    b->reach = 0;
    if (!is_moving || !w->options.look_ahead) return;
    for (int i = b->first; i < b->first + b->plan->particles; i++) {
        const particle *p = &w->pool.at[i];
        real u = vec3_length_squared(vec3_sub(p->position, p->previous));
        if (u > fastest) fastest = u;
    }
    real dt = w->options.dt;
    b->reach = (n - 1) * sqrt(fastest)
        + vec3_length(w->options.gravity) * dt * dt / 2
        + b->plan->radius / 100;
}

static void look_at_rigid(world *w)
{
    for (int k = 0; k < w->bodies; k++) {
        body *b = &w->body[k];
        if (body_is_soft(b)) continue;
        if (moves(w, k)) world_look_again(w, b);
        w->ball[k] = sphere_tree_root(&b->tree, w->of.at + b->first);
        look_ahead(w, b, moves(w, k));
    }
}
//<

//> step-pairs
// Appends pair (a, b) with what the last frame's query of it left.  Both lists
// are sorted, so one finger moves along the old one.  0 if there is no room.
static int add_pair(world *w, int a, int b, int *old)
{
    const body_pair *was = w->old_pair;
    if (w->pairs == w->pair_capacity) return 0;
    while (*old < w->old_pairs && (was[*old].a < a
           || (was[*old].a == a && was[*old].b < b))) (*old)++;
    int known = *old < w->old_pairs && was[*old].a == a && was[*old].b == b;
    body_pair *pair = &w->pair[w->pairs++];
    if (known) *pair = was[*old];
    else       *pair = (body_pair){ .a = a, .b = b };
    return 1;
}

static int spheres_meet(sphere a, sphere b, real margin)
{
    vec3 d = vec3_sub(a.center, b.center);
    real r = a.radius + b.radius + margin;
    return vec3_length_squared(d) <= r * r;
}

// All pairs of rigid bodies whose spheres come within reach of each other.
// Returns how many found no room.  Paper: section 5 tests every pair; so do we.
static int find_pairs(world *w)
{
    int old = 0, lost = 0;
    w->pairs = 0;
    for (int a = 0; a < w->bodies; a++) {
        if (body_is_soft(&w->body[a])) continue;
        int a_moves = moves(w, a);
        for (int b = a + 1; b < w->bodies; b++)
            if (spheres_meet(w->ball[a], w->ball[b],
                             w->body[a].reach + w->body[b].reach)
                && !body_is_soft(&w->body[b]) && (a_moves || moves(w, b)))
                lost += !add_pair(w, a, b, &old);
    }
    return lost;
}

static void swap_pair_lists(world *w)
{
    body_pair *last = w->old_pair;
    w->old_pair = w->pair;
    w->old_pairs = w->pairs;
    w->pair = last;
}
//<

//> step-spread
// A body that is hit may go as far as what hits it.  So whoever is near a
// faster body looks as far ahead as that one does; twice, for a blow that is
// passed on.
static void spread_reach(world *w)
{
    for (int round = 0; round < 2; round++) {
        for (int b = 0; b < w->bodies; b++) w->spread[b] = w->body[b].reach;
        for (int k = 0; k < w->pairs; k++) {
            int a = w->pair[k].a, b = w->pair[k].b;
            real far = fmax(w->spread[a], w->spread[b]);
            if (moves(w, a)) w->body[a].reach = fmax(w->body[a].reach, far);
            if (moves(w, b)) w->body[b].reach = fmax(w->body[b].reach, far);
        }
    }
}
//<

//> step-wake
// Slow enough to rest: less than a twelfth of the speed, sqrt(2 g s), that a
// fall through its shortest stick gives.
static real rest_speed(const world *w, const body *b)
{
    return sqrt(2 * vec3_length(w->options.gravity) * b->plan->spacing) / 12;
}

// Wakes b and all that sleep with it.  The near lists leave out what slept, so
// they are made anew.
static void rouse(world *w, int b)
{
    rest_wake(&w->rest, b);
    for (int k = 0; k < w->bodies; k++) {
        const body *x = &w->body[k];
        if (w->rest.asleep[k]) continue;
        for (int i = x->first; i < x->first + x->plan->particles; i++)
            w->pool.at[i].inverse_mass = w->of.inverse_mass[i];
    }
    w->trusted = -1;
}

// Body a comes near body b: if one of them sleeps and the other is faster than
// the speed of rest, the sleeper wakes, in time to take its part of the blow.
static int wake_sleeper(world *w, int a, int b)
{
    int sleeper = w->rest.asleep[a] ? a : b, other = a + b - sleeper;
    if (!w->rest.asleep[sleeper] || w->rest.asleep[other]) return 0;
    if (body_is_nailed(&w->body[sleeper])) return 0;
    if (body_is_nailed(&w->body[other]) || w->rest.calm[other] > 0) return 0;
    rouse(w, sleeper);
    return 1;
}

static int wake_sleepers(world *w)
{
    int woken = 0;
    for (int k = 0; k < w->pairs; k++)
        woken |= wake_sleeper(w, w->pair[k].a, w->pair[k].b);
    return woken;
}

// A deformable body wakes, and rests with, whatever its sphere meets, with
// twice the margin of the near lists for what this frame will bring.
static void join_soft(world *w)
{
    for (int b = 0; b < w->bodies; b++)
        if (moves(w, b)) world_look_again(w, &w->body[b]);
    for (int a = 0; a < w->bodies; a++) {
        body *soft = &w->body[a];
        if (!body_is_soft(soft) || body_is_nailed(soft)) continue;
        sphere ball = sphere_tree_root(&soft->tree, w->of.at + soft->first);
        for (int b = 0; b < w->bodies; b++) {
            body *x = &w->body[b];
            if (b == a || body_is_nailed(x)) continue;
            sphere other = sphere_tree_root(&x->tree, w->of.at + x->first);
            if (!spheres_meet(ball, other, 2 * w->list_margin)) continue;
            wake_sleeper(w, a, b);
            rest_touch(&w->rest, a, b);
        }
    }
}
//<

//> step-contacts
// m/s, the speed at which the features meet, if that makes a blow: four times
// the speed at which body b may rest, or more.  Slower ones are the unrest of a
// pile, and 0.
static real blow_speed(const world *w, const contact *c, const body *b)
{
    const particle *p = w->pool.at;
    real h = w->options.dt / w->options.substeps;
    vec3 move = vec3_sub(feature_now(c->a, p), feature_before(c->a, p));
    if (c->b.count > 0)
        move = vec3_sub(move, vec3_sub(feature_now(c->b, p),
                                       feature_before(c->b, p)));
    real speed = -vec3_dot(move, c->normal) / h;
    return speed > 4 * rest_speed(w, b) ? speed : 0;
}

static void keep_contacts(world *w, const contact *found, int n, int a, int b)
{
    for (int k = 0; k < n; k++) {
        if (w->contacts == w->contact_capacity) {
            w->report.dropped += n - k;
            return;
        }
        w->between[w->contacts][0] = a;
        w->between[w->contacts][1] = b;
        w->contact[w->contacts] = found[k];
        w->contact[w->contacts].approach =
            blow_speed(w, &found[k], &w->body[a]);
        w->contacts++;
    }
}

static int query_pair(world *w, body_pair *pair, real margin)
{
    contact found[PAIR_CONTACTS];
    collider a = world_collider(w, &w->body[pair->a]);
    collider b = world_collider(w, &w->body[pair->b]);
    real apart = w->body[pair->a].thickness + w->body[pair->b].thickness;
    int n = collide_rigid(&a, &b, margin + apart, w->options.manifold,
                          &pair->carried, w->hit, found);
    for (int k = 0; k < n; k++) found[k].thickness = apart;
    keep_contacts(w, found, n, pair->a, pair->b);
    return n;
}

// Once a frame: the contacts of every pair that may touch before its end.
// Those of two bodies that pass each other quickly, by more than a tenth of a
// radius, change within a frame: they come last, to be replaced.
static void query_pairs(world *w, int quick)
{
    for (int k = 0; k < w->pairs; k++) {
        body_pair *pair = &w->pair[k];
        const body *a = &w->body[pair->a], *b = &w->body[pair->b];
        real reach = a->reach + b->reach;
        int is_quick = reach > 0.1 * fmin(a->plan->radius, b->plan->radius);
        if (is_quick != quick) continue;
        int n = query_pair(w, pair, reach);
        pair->quick = is_quick && n > 0;
    }
}

// Every second substep: what the quick pairs touch now replaces what they
// touched.
enum { QUICK_EVERY = 2 };

static void query_quick_pairs(world *w)
{
    w->contacts = w->lasting;
    for (int k = 0; k < w->pairs; k++) {
        body_pair *pair = &w->pair[k];
        if (!pair->quick) continue;
        body *a = &w->body[pair->a], *b = &w->body[pair->b];
        world_look(w, a);
        world_look(w, b);
        query_pair(w, pair, QUICK_EVERY * (a->reach + b->reach)
                            / w->options.substeps);
    }
}

//<

//> step-find
// Every particle that moves against every plane.  (What is rigid was looked at
// when its pairs were found.)
static void query_planes(world *w)
{
    for (int k = 0; k < w->bodies; k++) {
        body *b = &w->body[k];
        if (!moves(w, k)) continue;
        if (body_is_soft(b)) {
            look_ahead(w, b, 1);
            world_look(w, b);
        }
        collider c = world_collider(w, b);
        for (int p = 0; p < w->planes; p++) {
            int room = w->contact_capacity - w->contacts;
            contact *out = &w->contact[w->contacts];
            int n = collide_plane(&c, w->plane[p], b->reach, b->thickness,
                                  out, room);
            if (n > room) w->report.dropped += n - room;
            keep_contacts(w, out, n < room ? n : room, k, -1);
        }
    }
}

static void find_contacts(world *w, real *since)
{
    look_at_rigid(w);
    int lost = find_pairs(w);
    if (wake_sleepers(w)) {
        look_at_rigid(w);
        lost = find_pairs(w);
    }
    if (w->options.look_ahead) {
        spread_reach(w);
        lost = find_pairs(w);
    }
    w->report.dropped += lost;
    lap(w, STAGE_PAIRS, since);
    w->contacts = 0;
    query_pairs(w, 0);
    query_planes(w);
    w->lasting = w->contacts;
    query_pairs(w, 1);
    w->report.pairs = w->pairs;
    lap(w, STAGE_QUERY, since);
}
//<

//> step-separate
static void separate(world *w)
{
    for (int k = 0; k < w->contacts; k++) {
        int a = w->between[k][0], b = w->between[k][1];
        w->contact[k].pushed = 0;
        if (contact_separate(&w->contact[k], w->pool.at,
                             w->options.response) == 0) continue;
        w->collided[a] = 1;
        if (b < 0) continue;
        w->collided[b] = 1;
        if (!body_is_nailed(&w->body[a]) && !body_is_nailed(&w->body[b]))
            rest_touch(&w->rest, a, b);
    }
    if (w->softs == 0) return;
    if (w->options.leaves == LEAVES_FACE) soft_separate_leaves(w);
    else                                  soft_separate(w);
}
//<

//> step-relax
static const stick_lists *lists_of(const world *w, const shape *s)
{
    int k = 0;
    while (w->plan[k].shape != s) k++;
    return &w->plan[k].lists;
}

// Paper: section 6.2: a rigid body that collided is relaxed from the particle
// that separation moved most; every other body in the order of its plan.
static relax_result relax_body(world *w, const body *b, int is_ordered)
{
    const shape *s = b->plan;
    const world_options *o = &w->options;
    particle *p = w->pool.at + b->first;
    vec3 *before = w->of.before + b->first;
    if (!is_ordered)
        return sticks_relax(s->stick, s->sticks, p, s->particles, o->sweeps,
                            o->relax, before);
    int from = most_moved(p, before, s->particles);
    return sticks_relax_ordered(o->order, lists_of(w, s), s->stick, s->sticks,
                                p, s->particles, from, o->sweeps, o->relax,
                                w->orders);
}

static void relax(world *w)
{
    for (int b = 0; b < w->bodies; b++) {
        int collided = w->collided[b];
        w->collided[b] = 0;
        if (!moves(w, b)) continue;
        int is_ordered = w->options.order != ORDER_LISTED && collided
                         && !body_is_soft(&w->body[b]);
        relax_result r = relax_body(w, &w->body[b], is_ordered);
        w->report.tested += r.tested;
        w->report.relaxed += r.relaxed;
        w->report.fell_back += r.fell_back;
    }
}

static void remember(world *w, vec3 *where)
{
    for (int i = 0; i < w->pool.count; i++) where[i] = w->pool.at[i].position;
}
//<

//> step-bounce
static void slow_sticks(world *w, int b)
{
    if (b < 0 || !moves(w, b)) return;
    const shape *plan = w->body[b].plan;
    sticks_sweep_speeds(plan->stick, plan->sticks,
                        w->pool.at + w->body[b].first);
}

// Did this contact, in this substep, part bodies that met in a blow?
static int is_blow(const contact *c)
{
    return c->pushed > 0 && c->approach > 0;
}

// A push moves places, and so gives a speed as well that nobody asked for.
// After a blow the features part at restitution times the speed at which they
// met: contact_bounce gives that speed to the features alone, and the sticks
// spread it over the bodies: in turn, so often that both nearly agree.
static void bounce(world *w, real h)
{
    enum { ROUNDS = 40 };
    int blows = 0;
    for (int k = 0; k < w->contacts; k++) blows += is_blow(&w->contact[k]);
    for (int round = 0; blows > 0 && round < ROUNDS; round++)
        for (int k = 0; k < w->contacts; k++) {
            if (!is_blow(&w->contact[k])) continue;
            contact_bounce(&w->contact[k], w->pool.at, w->options.response, h);
            slow_sticks(w, w->between[k][0]);
            slow_sticks(w, w->between[k][1]);
        }
    for (int k = 0; blows > 0 && k < w->contacts; k++)
        if (is_blow(&w->contact[k])) w->contact[k].approach = 0;
}
//<

//> step-rest
// Did every particle of b go slower than the speed of rest over the frame?
static int went_slow(const world *w, const body *b)
{
    real far = rest_speed(w, b) * w->options.dt;
    for (int i = b->first; i < b->first + b->plan->particles; i++) {
        vec3 d = vec3_sub(w->pool.at[i].position, w->of.start[i]);
        if (!(vec3_length_squared(d) <= far * far)) return 0;
    }
    return 1;
}

// Whoever sleeps is nailed where it lies, and seen there: the other stages only
// look at what moves.
static void put_to_bed(world *w, body *b)
{
    for (int i = b->first; i < b->first + b->plan->particles; i++) {
        particle *p = &w->pool.at[i];
        p->inverse_mass = 0;
        p->previous = p->position;
    }
    world_look_again(w, b);
}

// s, how long an island must lie still: half a second, but longer where gravity
// is weak or a body large.  Whoever is thrown straight up is slower than the
// speed of rest, v, for 2 v / g about the top, and nobody is to sleep there:
// twice that.
static real patience(const world *w)
{
    real most = 0.5, gravity = vec3_length(w->options.gravity);
    for (int b = 0; b < w->bodies && gravity > 0; b++)
        if (moves(w, b))
            most = fmax(most, 2 * 2 * rest_speed(w, &w->body[b]) / gravity);
    return most;
}

// Bodies that pushed each other in this frame, and lay still for as long as
// patience asks, fall asleep together.
static void rest(world *w)
{
    for (int b = 0; b < w->bodies; b++)
        w->slow[b] = (char)(!moves(w, b) || went_slow(w, &w->body[b]));
    rest_end(&w->rest, w->slow, w->options.dt, patience(w));
    w->report.asleep = 0;
    for (int b = 0; b < w->bodies; b++) {
        if (!w->rest.asleep[b] || body_is_nailed(&w->body[b])) continue;
        put_to_bed(w, &w->body[b]);
        w->report.asleep++;
    }
}
//<

//> step
void world_step(world *w)
{
    assert(w->ready);
    const world_options *o = &w->options;
    real h = o->dt / o->substeps, since = clock_now(w);
    w->report = (step_report){ .pairs = 0 };
    remember(w, w->of.start);
    rest_begin(&w->rest);
    if (w->softs > 0) join_soft(w);

    for (int k = 0; k < o->substeps; k++) {
        integrate(w, h);
        lap(w, STAGE_INTEGRATE, &since);
        if (k == 0) find_contacts(w, &since);
        else if (k % QUICK_EVERY == 0) query_quick_pairs(w);
        lap(w, STAGE_QUERY, &since);
        if (w->softs > 0 && o->leaves == LEAVES_VERTEX) soft_refresh(w);
        lap(w, STAGE_PAIRS, &since);
        if (o->order != ORDER_LISTED) remember(w, w->of.before);
        separate(w);
        lap(w, STAGE_SEPARATE, &since);
        relax(w);
        if (o->blows) bounce(w, h);
        lap(w, STAGE_RELAX, &since);
    }
    swap_pair_lists(w);
    if (o->resting) rest(w);
    w->time += o->dt;
    w->report.contacts = w->contacts;
    lap(w, STAGE_REST, &since);
}
//<
