//> rungs-islands
//>   What pushes each other, or is joined, is an island. Bodies are united pair by
//>   pair (union-find), and one of them tells of all.
#include "rungs.h"
#include "substeps.h"
#include "table.h"

#include <stddef.h>
#include <string.h>

// The body that tells of b's island, with path halving.
static int island_root(island *i, int b)
{
    while (i[b].parent != b) {
        i[b].parent = i[i[b].parent].parent;
        b = i[b].parent;
    }
    return b;
}

static void unite(rigid_tables *t, int a, int b)
{
    t->island[island_root(t->island, b)].parent = island_root(t->island, a);
}

// Rope and cloth that is awake.
static bool is_awake_cloth(const world *w, int b)
{
    return body_is_soft(&w->body[b]) && body_moves(w, b);
}

static bool is_driven(const world *w, int b)
{
    return b >= 0 && w->rigid.moves[b] && w->rigid.now[b].is_driven;
}

// Does it move, and yield to others?
static bool goes(const world *w, int b)
{
    return b >= 0 && (w->rigid.moves[b] || is_awake_cloth(w, b))
        && !is_driven(w, b);
}

// A body, with all pieces that ride on it.
static bool may_meet_soft(const world *w, int b)
{
    for (int k = b + 1; k > 0; k = w->body[k - 1].next)
        if (soft_may_meet(&w->soft, k - 1)) return true;
    return false;
}

// All that is soft is one island, with what it may touch in this frame: it has one
// time.
static void unite_softs(world *w)
{
    rigid_tables *t = &w->rigid;
    int first = -1;
    for (int k = 0; k < t->awakes; k++) {
        int a = t->awake[k];
        if (!is_awake_cloth(w, a)) continue;
        if (first < 0) first = a;
        unite(t, first, a);
    }
    for (int k = 0; k < t->awakes && first >= 0; k++) {
        int b = t->awake[k];
        if (t->moves[b] && goes(w, b) && may_meet_soft(w, b)) unite(t, first, b);
    }
    if (first >= 0) t->island[island_root(t->island, first)].is_soft = true;
}

static void find_islands(world *w)
{
    rigid_tables *t = &w->rigid;
    for (int k = 0; k < t->awakes; k++)
        t->island[t->awake[k]] = (island){ .parent = t->awake[k], .ground = -1,
                                           .is_calm = true };
    for (int k = 0; k < t->solver.contacts; k++) {
        const active_contact *x = &t->solver.active[k];
        bool may_touch = x->count > 0 || t->cache.of[k]->passes;
        if (may_touch && x->sides == TWO_SIDED) unite(t, x->a, x->b);
    }
    for (int k = 0; k < w->joints.count; k++) {
        const joint *j = &w->joints.joint[k];
        if (joint_holds(j) && goes(w, j->a) && goes(w, j->b))
            unite(t, j->a, j->b);
    }
    if (w->softs > 0) unite_softs(w);
}
//<

//> rungs-ground
//>   What rides in a train is as calm, or as fast, as it is beside the train.
// Body b, of island i, touches `on`, or is joined to it: a driven body, or what is at
// rest.
static void stand_on(const world *w, island *i, int on)
{
    if (!is_driven(w, on)) i->rests = true;
    else if (i->ground < 0) i->ground = on;
}

static void find_grounds(world *w)
{
    rigid_tables *t = &w->rigid;
    for (int k = 0; k < t->solver.contacts; k++) {
        const active_contact *x = &t->solver.active[k];
        if (x->count > 0 && x->sides != TWO_SIDED)
            stand_on(w, &t->island[island_root(t->island, x->a)], x->b);
    }
    for (int k = 0; k < w->joints.count; k++) {
        const joint *j = &w->joints.joint[k];
        int a = goes(w, j->a) ? j->a : j->b, b = j->a + j->b - a;
        if (joint_holds(j) && goes(w, a) && !goes(w, b))
            stand_on(w, &t->island[island_root(t->island, a)], b);
    }
}

// m: how far the centre of body b goes in this frame, as it is seen from the driven
// body `on`; -1: from what is at rest.
static vec3 relative_path(const world *w, int b, int on)
{
    const rigid_tables *t = &w->rigid;
    vec3 delta = t->ahead[b].delta;
    if (on < 0) return delta;
    vec3 arm = vec3_sub(t->now[b].frame.center, t->now[on].frame.center);
    vec3 spin = motion_rotation(&t->now[on].basis, &t->velocity[on]);
    vec3 there = vec3_add_scaled(t->ahead[on].delta, w->frame,
                                 vec3_cross(spin, arm));
    return vec3_sub(delta, there);
}
//<

//> rungs-demands
//>   Each island is asked how calm it is, and what its contacts bear; its choice
//>   is that of all its bodies.
// What flies does not sag.  (Velocities are half a substep old: see handle-where.)
static const real SIXTEENTH = 16;           // tuned, per radius

static bool is_calm(const world *w, int b, int on)
{
    const rigid_tables *t = &w->rigid;
    real since = w->frame * rigid_since(w, b);
    vec3 delta = vec3_add_scaled(relative_path(w, b, on), since, body_gravity(w, b));
    real far = t->now[b].radius / SIXTEENTH;
    return vec3_length_squared(delta) <= far * far;
}

// By its inner radius in a whole frame.
static bool is_fast(const world *w, int b, int on)
{
    const rigid_tables *t = &w->rigid;
    real delta = vec3_length(relative_path(w, b, on)) * w->options.dt / w->frame;
    return t->moves[b] && delta > t->body[b].inner;
}

static void judge_island(const world *w, island *i, int b, int on)
{
    i->is_calm &= is_calm(w, b, on);
    i->is_fast |= is_fast(w, b, on);
}

// Does what is driven turn its far end, in a whole frame, by more than the size of
// what it may hit?  The side that was found is another one by then.
bool rungs_sweeps(const world *w, int a, int b)
{
    const rigid_tables *t = &w->rigid;
    if (b < 0 || t->now[a].is_driven == t->now[b].is_driven) return false;
    int driven = t->now[a].is_driven ? a : b, other = a + b - driven;
    real far = t->ahead[driven].angle * t->now[driven].radius;
    return far * w->options.dt > t->body[other].inner * w->frame;
}

island *rungs_island(const world *w, int a, int b)
{
    island *i = w->rigid.island;
    if (goes(w, a)) return &i[island_root(i, a)];
    return goes(w, b) ? &i[island_root(i, b)] : NULL;
}

// An island that takes in another has what asks for more of both.
static void add_choice(const rigid_tables *t, int b, substep_choice *to)
{
    to->now = int_max(to->now, t->choice[b].now);
    to->frames = int_min(to->frames, t->choice[b].frames);
}

// m: by a share of this may a contact give way: the width of the smaller of its bodies
// that yield.  What is thin lies on its flat side, and an overlap that its radius hides
// is its whole thickness.
static real width_at(const rigid_tables *t, const active_contact *x)
{
    real width = rigid_width(t, x->a);
    return x->sides == TWO_SIDED ? real_min(width, rigid_width(t, x->b)) : width;
}

// How far the balls inside of an island's bodies reach along gravity, and how wide
// its bodies are.
static void add_layer(const rigid_tables *t, int b, vec3 down, island *i)
{
    real at = vec3_dot(t->now[b].frame.center, down), inner = t->body[b].inner;
    bool is_first = i->bodies == 0;
    i->low = is_first ? at - inner : real_min(i->low, at - inner);
    i->high = is_first ? at + inner : real_max(i->high, at + inner);
    i->inner += inner;
    i->width += rigid_width(t, b);
    i->largest = real_max(i->largest, t->now[b].radius);
    i->bodies++;
}

// Adds how hard (N) gravity and forces pull at a body.
static void add_pull(const world *w, int b, island *i)
{
    const rigid_tables *t = &w->rigid;
    real inverse = t->now[b].basis.inverse_mass;
    if (!(inverse > 0) || t->now[b].is_driven) return;
    vec3 pull = vec3_add_scaled(t->load[b].force, 1 / inverse, body_gravity(w, b));
    i->pulls += vec3_length(pull);
}

// A body's weight is shared by the contacts below it, as they bore it last; and what
// does not yield carries the island.
static void find_lifts(world *w)
{
    rigid_tables *t = &w->rigid;
    for (int k = 0; k < t->solver.contacts; k++) {
        const active_contact *x = &t->solver.active[k];
        if (x->above >= 0) t->island[x->above].lift += x->lift;
        if (!(x->load > 0)) continue;
        island *i = &t->island[island_root(t->island, x->a)];
        i->rubs = true;
        if (x->sides == TWO_SIDED) continue;
        const contact *c = t->cache.active[k];
        vec3 push = vec3_add_scaled(c->friction, x->load, c->normal);
        real per_age = (x->is_swapped ? -1 : 1) / t->age[x->a];
        i->carried = vec3_add_scaled(i->carried, per_age, push);
    }
}

// In a calm island no contact bears more than the sum of all that pulls at its
// bodies, or than the sum of what carries it.  More than that is a jam between
// immovable sides.  Shorter substeps would not help: they make springs stiffer,
// and the jam presses them harder.
static real load_above(const rigid_tables *t, const active_contact *x,
                       const island *i)
{
    real most = real_max(i->pulls, vec3_length(i->carried)) * t->age[x->a];
    return x->load > most ? x->borne * most / x->load : x->borne;
}

// What nothing has borne yet has just been set down, if all is calm: each contact
// below it may have to bear all of it.
static real weight_on(const rigid_tables *t, const active_contact *x,
                      const island *i)
{
    real lift = x->above < 0 ? 0 : t->island[x->above].lift;
    if (lift > 0) return x->weight * x->lift / lift;
    return i->is_calm && !i->hangs ? x->weight : 0;
}

// rad, in this frame.  A ball counts as if it did not turn.
static real turn_of(const world *w, int b)
{
    const rigid_tables *t = &w->rigid;
    real out = t->now[b].radius - w->body[b].round;
    return t->ahead[b].angle * out / t->now[b].radius;
}

static void request_for_bodies(world *w)
{
    rigid_tables *t = &w->rigid;
    vec3 down = vec3_unit(w->options.gravity);
    for (int k = 0; k < t->awakes; k++) {
        int b = t->awake[k], of = island_root(t->island, b);
        const island *i = &t->island[of];
        judge_island(w, &t->island[of], b, i->rests ? -1 : i->ground);
        if (t->moves[b]) add_layer(t, b, down, &t->island[of]);
        if (t->moves[b]) add_pull(w, b, &t->island[of]);
        if (b != of) add_choice(t, b, &t->choice[of]);
    }
}

static void request_for_joints(world *w)
{
    for (int k = 0; k < w->joints.count; k++) {
        const joint *j = &w->joints.joint[k];
        island *i = rungs_island(w, j->a, j->b);
        if (!i || !joint_holds(j)) continue;
        i->pace = real_max(i->pace, w->joints.rows[k].pace);
        w->joints.rows[k].rubs = i->rubs;
        i->hangs = true;
        if (j->is_driven) i->pulls = HUGE_VAL;
        // A damper that bears all of a spring: d v = k (what is left to go).
        if (j->drive.stiffness > 0)
            i->lasts = real_max(i->lasts, j->drive.damping / j->drive.stiffness);
    }
}

static void request_for_contacts(world *w)
{
    rigid_tables *t = &w->rigid;
    for (int k = 0; k < t->solver.contacts; k++) {
        const active_contact *x = &t->solver.active[k];
        island *i = x->count > 0 ? rungs_island(w, x->a, -1) : NULL;
        if (!i) continue;
        real width = width_at(t, x), borne = load_above(t, x, i) / width;
        i->weight = real_max(i->weight, weight_on(t, x, i) / width);
        i->squares += borne * borne;
        i->bears += borne > 0;
        if (x->sides == DRIVEN_SIDED) judge_island(w, i, x->a, x->b);
        i->turn = real_max(i->turn, turn_of(w, x->a));
        if (x->sides != ONE_SIDED)
            i->turn = real_max(i->turn, turn_of(w, x->b));
    }
}

static void find_demands(world *w)
{
    request_for_bodies(w);
    find_lifts(w);
    request_for_joints(w);
    request_for_contacts(w);
}
//<

//> rungs-choose
//>   So many substeps as it wants, and the rung that has as many.
// The lowest is of those that need half as many more than usual, at most, and are
// no rope or cloth; each other of a quarter more than the one below.
static int rung_of(const world *w, int substeps, bool is_soft)
{
    real top = 1.5 * w->options.substeps * w->frame / w->options.dt;
    int k = is_soft;
    for (; top < substeps && k < RUNGS - 1; k++) top *= 1.25;
    return k;
}

// Each island takes what it asks for, at most what a frame may have.
static void choose_all(world *w)
{
    rigid_tables *t = &w->rigid;
    int all = substeps_all(w);
    bool is_cut = false;
    memset(t->rungs, 0, sizeof t->rungs);
    for (int k = 0; k < t->awakes; k++) {
        int b = t->awake[k];
        island *i = &t->island[b];
        if (i->parent != b || !goes(w, b)) continue;
        i->hangs |= i->is_soft;
        int need = substeps_choose(w, i, &t->choice[b]);
        is_cut |= need > all;
        i->substeps = int_min(need, all);
    }
    w->report.cut += is_cut;
}

// Returns the highest that is taken.
static int take_rungs(world *w)
{
    rigid_tables *t = &w->rigid;
    int highest = 0;
    for (int k = 0; k < t->awakes; k++) {
        int b = t->awake[k], of = island_root(t->island, b);
        int n = t->island[of].substeps;
        int r = rung_of(w, n, t->island[of].is_soft);
        t->rung[b] = (char)r;
        t->island[b].parent = of;
        t->choice[b] = t->choice[of];
        t->rungs[r].substeps = int_max(t->rungs[r].substeps, n);
        t->rungs[r].is_soft |= t->island[of].is_soft;
        t->rungs[r].hangs |= t->island[of].hangs;
        highest = int_max(highest, r);
    }
    return highest;
}
//<

//> rungs-sort
//>   Bodies and contacts of a rung stand side by side (counting sort), so that
//>   the solver takes them as a piece of its table.
static rung *of_body(world *w, int b, int highest)
{
    return &w->rigid.rungs[goes(w, b) ? (int)w->rigid.rung[b] : highest];
}

// From how many there are on each rung to where they begin; `end` follows as they
// are put there.
static void begin_at(rigid_tables *t)
{
    int first = t->drivens, first_contact = 0;
    for (rung *r = t->rungs; r < t->rungs + RUNGS; r++) {
        int bodies = r->end, contacts = r->end_contact;
        r->first = r->end = first;
        r->first_contact = r->end_contact = first_contact;
        first += bodies;
        first_contact += contacts;
    }
}

static void swap_contacts(rigid_tables *t, int a, int b)
{
    SWAP(active_contact, t->solver.active[a], t->solver.active[b]);
    SWAP(contact *, t->cache.active[a], t->cache.active[b]);
    SWAP(cache_pair *, t->cache.of[a], t->cache.of[b]);
    SWAP(int, t->solver.order[a], t->solver.order[b]);
}

// What is driven goes with every rung: it stands before the bodies of the first.
static void insert_driven(world *w)
{
    rigid_tables *t = &w->rigid;
    t->drivens = 0;
    for (int k = 0; k < t->awakes && w->kinematic_bodies > 0; k++)
        if (is_driven(w, t->awake[k])) t->by_rung[t->drivens++] = t->awake[k];
}

// Bodies and contacts keep their order on a rung.  What does not move is nowhere
// in the way: it goes with the highest.
static void sort_by_rung(world *w, int highest)
{
    rigid_tables *t = &w->rigid;
    contact_solver *s = &t->solver;
    if (highest == 0) {
        t->drivens = 0;
        t->rungs->end = t->awakes;
        t->rungs->end_contact = s->contacts;
        for (int k = 0; k < t->awakes; k++) t->by_rung[k] = t->awake[k];
        return;
    }
    insert_driven(w);
    for (int k = 0; k < t->awakes; k++)
        if (!is_driven(w, t->awake[k])) of_body(w, t->awake[k], highest)->end++;
    for (int k = 0; k < s->contacts; k++)
        of_body(w, s->active[k].a, highest)->end_contact++;
    begin_at(t);
    for (int k = 0; k < t->awakes; k++)
        if (!is_driven(w, t->awake[k]))
            t->by_rung[of_body(w, t->awake[k], highest)->end++] = t->awake[k];
    for (int k = 0; k < s->contacts; k++)
        s->order[k] = of_body(w, s->active[k].a, highest)->end_contact++;
    for (int k = 0; k < s->contacts; k++)
        while (s->order[k] != k) swap_contacts(t, k, s->order[k]);
}

// Rungs that have someone on them, from the lowest; or one where nothing goes.
static int close_up(world *w)
{
    rigid_tables *t = &w->rigid;
    int count = 0, to[RUNGS];
    for (int k = 0; k < RUNGS; k++) {
        rung r = t->rungs[k];
        to[k] = count;
        if (r.substeps > 0) t->rungs[count++] = r;
    }
    for (int k = 0; k < t->awakes; k++)
        t->rung[t->awake[k]] = (char)to[(int)t->rung[t->awake[k]]];
    if (count > 0) return count;
    t->rungs[0].substeps = w->options.substeps;
    return 1;
}

int rungs_find(world *w)
{
    find_islands(w);
    if (w->kinematic_bodies > 0) find_grounds(w);
    find_demands(w);
    choose_all(w);
    sort_by_rung(w, take_rungs(w));
    return close_up(w);
}
//<
