//> pairs-reach
#include "pairs.h"
#include "halves.h"

// m, what vertices may go beside what the fastest of them turns: what gravity
// adds in a frame; and a hundredth of the radius for what impacts add.
static real beside(const world *w, const body *b)
{
    real dt = w->options.dt;
    return vec3_length(w->options.gravity) * dt * dt / 2
         + b->plan->radius / 100;
}

// How a body of four moves: its vertices go as their weights say.
static real way_of_four(const rigid4 *f, const particle *p, int n, vec3 *mean)
{
    vec3 move[FOUR];
    real fastest = 0;
    *mean = (vec3){ 0, 0, 0 };
    for (int k = 0; k < FOUR; k++) {
        move[k] = vec3_sub(p[k].position, p[k].previous);
        *mean = vec3_add_scaled(*mean, f->middle[k], move[k]);
    }
    for (int k = 0; k < FOUR; k++) move[k] = vec3_sub(move[k], *mean);
    for (int v = 0; v < n; v++) {
        const real *a = f->weight[v];
        vec3 turn = vec3_scale(a[0], move[0]);
        for (int k = 1; k < FOUR; k++)
            turn = vec3_add_scaled(turn, a[k], move[k]);
        real square = vec3_length_squared(turn);
        fastest = square > fastest ? square : fastest;
    }
    return fastest;
}

static real way_of_vertices(const particle *p, int n, vec3 *mean)
{
    real fastest = 0;
    *mean = (vec3){ 0, 0, 0 };
    for (int v = 0; v < n; v++)
        *mean = vec3_add_scaled(*mean, 1.0 / n,
                                vec3_sub(p[v].position, p[v].previous));
    for (int v = 0; v < n; v++) {
        vec3 move = vec3_sub(p[v].position, p[v].previous);
        vec3 turn = vec3_sub(move, *mean);
        fastest = fmax(fastest, vec3_length_squared(turn));
    }
    return fastest;
}
//<

//> pairs-look-ahead
static void stand(body *b)
{
    b->way = (vec3){ 0, 0, 0 };
    b->turn = b->reach = 0;
}

// For a frame of dt: its middle goes straight on; its vertices beside that as
// much as the fastest of them turns.
void pairs_look_ahead(const world *w, body *b)
{
    int n = b->plan->particles;
    vec3 mean;
    const particle *p = w->pool.at + b->first;
    real ages = w->options.dt / w->age;
    real fastest = body_is_soft(b) ? way_of_vertices(p, n, &mean)
                                   : way_of_four(b->four, p, n, &mean);
    b->way = vec3_scale(ages, mean);
    b->turn = ages * sqrt(fastest) + beside(w, b);
    b->reach = vec3_length(b->way) + b->turn;
}
//<

//> pairs-look
// The same for a body that hardly moves, from above: no vertex goes further
// than so many times what its particles go.
static void look_ahead_still(const world *w, body *b)
{
    const particle *p = w->pool.at + b->first;
    real most = 0;
    for (int k = 0; k < FOUR; k++) {
        vec3 d = vec3_sub(p[k].position, p[k].previous);
        real square = vec3_length_squared(d);
        most = square > most ? square : most;
    }
    b->way = (vec3){ 0, 0, 0 };
    b->turn = b->reach = w->options.dt / w->age * b->four->swing * sqrt(most)
                       + beside(w, b);
}
//<

//> pairs-fresh
// Are the particles of b, but for a thousandth of its radius, where its
// contacts were found?
static int lies_where_seen(const world *w, const body *b)
{
    real far = w->options.stay * b->plan->radius, most = 0;
    if (far == 0 || w->softs > 0) return 0;
    for (int i = b->first; i < b->first + FOUR; i++) {
        vec3 d = vec3_sub(w->pool.at[i].position, w->of.seen[i]);
        real square = vec3_length_squared(d);
        most = square <= most ? most : square;
    }
    return most <= far * far;
}

// Sticks of four particles are never off by more than a hundredth.
sphere pairs_ball(const world *w, body *b)
{
    const particle *p = w->pool.at + b->first;
    vec3 sum = { 0, 0, 0 };
    for (int k = 0; k < FOUR; k++)
        sum = vec3_add_scaled(sum, 1.0 / FOUR, p[k].position);
    return (sphere){ sum, 1.02 * b->four->reach };
}

// Where it is now, and how it can move.
static void look_anew(world *w, body *b)
{
    int k = (int)(b - w->body);
    w->flags.fresh[k] = w->flags.looked[k] = 1;
    if (w->softs > 0) world_look_again(w, b);
    else              world_look(w, b);
    world_find_ways(w, b);
    for (int i = b->first; i < b->first + body_particles(b); i++)
        w->of.seen[i] = w->pool.at[i].position;
}

static void look_at_side(void *data, int side)
{
    world *w = data;
    int n;
    const int *mine = halves_bodies(w, side, &n);
    for (int i = 0; i < n; i++) {
        int k = mine[i];
        body *b = &w->body[k];
        int moves = body_moves(w, k), changed = moves != w->flags.moves[k];
        w->flags.moves[k] = (char)moves;
        // Deformable bodies have lists of their own.
        if (body_is_soft(b)) w->pairs.ball[k] = (sphere){ { 0, 0, 0 }, -1 };
        if (body_is_soft(b)
            || (!moves && !changed && w->pairs.ball[k].radius > 0)) continue;
        if (changed || (moves && !lies_where_seen(w, b))) look_anew(w, b);
        w->pairs.ball[k] = pairs_ball(w, b);
        if (!moves)                 stand(b);
        else if (w->flags.fresh[k]) pairs_look_ahead(w, b);
        else                        look_ahead_still(w, b);
    }
}

static void look_at_rigid(world *w)
{
    halves_do(w, look_at_side, w);
}
//<

//> pairs-list
// Appends pair (a, b) with what the last frame's query of it left.  Both lists
// are sorted, so one finger moves along the old one.
static void add_pair(pair_tables *t, int a, int b, int *old)
{
    const body_pair *was = t->old;
    while (*old < t->old_count && (was[*old].a < a
           || (was[*old].a == a && was[*old].b < b))) (*old)++;
    int known = *old < t->old_count && was[*old].a == a && was[*old].b == b;
    body_pair *pair = &t->at[t->count++];
    query_cache *carried = &t->carried[pair - t->at];
    *pair = known ? was[*old] : (body_pair){ .a = a, .b = b };
    *carried = known ? t->old_carried[*old] : (query_cache){ .count = 0 };
}

// All pairs of rigid bodies whose balls come within reach of each other: the
// balls, grown by the reach, meet.  Returns how many found no room.
static int list_pairs(world *w)
{
    pair_tables *t = &w->pairs;
    int old = 0, room = t->capacity, found;
    for (int b = 0; b < w->bodies; b++)
        if (!body_is_soft(&w->body[b])) {
            t->listed[b] = w->body[b].reach + w->body[b].thickness
                         + 4 * w->options.stay * w->body[b].plan->radius;
            t->ball[b].radius += t->listed[b];
        }
    found = broad_pairs(&t->broad, t->ball, w->flags.moves, t->met, room);
    for (int b = 0; b < w->bodies; b++)
        if (!body_is_soft(&w->body[b])) t->ball[b].radius -= t->listed[b];
    t->count = 0;
    for (int k = 0; k < found && k < room; k++)
        add_pair(t, t->met[k][0], t->met[k][1], &old);
    return found > room ? found - room : 0;
}
//<

//> pairs-spread
// A body that is hit may go as far as what hits it.  So whoever is near a
// faster body looks as far ahead as that one does; twice, for a blow that is
// passed on.
static void spread_reach(world *w)
{
    const char *moves = w->flags.moves;
    real *spread = w->pairs.spread;
    for (int round = 0; round < 2; round++) {
        for (int b = 0; b < w->bodies; b++) spread[b] = w->body[b].reach;
        for (int k = 0; k < w->pairs.count; k++) {
            int a = w->pairs.at[k].a, b = w->pairs.at[k].b;
            real far = fmax(spread[a], spread[b]);
            if (moves[a]) w->body[a].reach = fmax(w->body[a].reach, far);
            if (moves[b]) w->body[b].reach = fmax(w->body[b].reach, far);
        }
    }
}
//<

//> pairs-wake
// Wakes b and all that sleep with it.  The near lists leave out what slept, so
// they are made anew.
static void rouse(world *w, int b)
{
    rest_wake(&w->rest, b);
    for (int k = 0; k < w->bodies; k++) {
        const body *x = &w->body[k];
        if (w->rest.asleep[k]) continue;
        for (int i = x->first; i < x->first + body_particles(x); i++)
            w->pool.at[i].inverse_mass = w->of.inverse_mass[i];
    }
    w->near.trusted = -1;
}

int pairs_wake(world *w, int a, int b)
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
    for (int k = 0; k < w->pairs.count; k++)
        woken |= pairs_wake(w, w->pairs.at[k].a, w->pairs.at[k].b);
    return woken;
}
//<

//> pairs-find
// Is nobody elsewhere, and nobody faster, than when pairs were listed?  Then
// these are the pairs, and no ball need be looked at.
static int list_is_good(world *w)
{
    for (int b = 0; b < w->bodies; b++) {
        const body *x = &w->body[b];
        if (w->flags.fresh[b] || body_is_soft(x)) return 0;
        real slack = 2 * w->options.stay * x->plan->radius;
        if (!(x->reach + x->thickness + slack <= w->pairs.listed[b])) return 0;
    }
    return w->options.stay > 0;
}

// This frame's list becomes the last one's.
static void start_list(pair_tables *t)
{
    body_pair *last = t->old;
    t->old = t->at;
    t->old_count = t->count;
    t->at = last;
    query_cache *carried = t->old_carried;
    t->old_carried = t->carried;
    t->carried = carried;
}

// The list of the last frame, if it is good, and nobody wakes.
static int keep_list(world *w)
{
    if (!list_is_good(w) || wake_sleepers(w)) return 0;
    spread_reach(w);
    return list_is_good(w);
}

void pairs_find(world *w)
{
    for (int b = 0; b < w->bodies; b++)
        w->flags.fresh[b] = w->flags.looked[b] = 0;
    look_at_rigid(w);
    w->report.pairs = w->pairs.count;
    if (keep_list(w)) return;
    start_list(&w->pairs);
    look_at_rigid(w);
    int lost = list_pairs(w);
    if (wake_sleepers(w)) {
        look_at_rigid(w);
        lost = list_pairs(w);
    }
    spread_reach(w);
    lost = list_pairs(w);
    halves_cut(w);
    w->report.dropped += lost;
    w->report.pairs = w->pairs.count;
}
//<

//> pairs-pass
// Bodies that go past each other by no more than the smaller one's inner radius
// are not lost: they are seen to overlap, and on the right side.
int pairs_pass_far(const body *a, const body *b, real share)
{
    real far = share * vec3_distance(a->way, b->way);
    return far > fmin(a->inner, b->inner);
}

// Does A's ball, on its way as seen from B, come as near to B's as what they
// turn?  It is nearest after the share t of the way.
int pairs_fly_into(const world *w, const body *a, const body *b)
{
    if (!pairs_pass_far(a, b, 1)) return 0;
    sphere sa = w->pairs.ball[a - w->body], sb = w->pairs.ball[b - w->body];
    vec3 d = vec3_sub(sa.center, sb.center), way = vec3_sub(a->way, b->way);
    real t = -vec3_dot(d, way) / vec3_length_squared(way);
    t = fmin(fmax(t, 0), 1);
    real near = sa.radius + sb.radius + a->turn + b->turn;
    return vec3_length_squared(vec3_add_scaled(d, t, way)) <= near * near;
}
//<
