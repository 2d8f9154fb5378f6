//> rigid-reach
#include "ledger.h"
#include "rigid.h"

#include <stddef.h>

// m, how far corner v of body b went in the last substep.
static vec3 corner_move(const body *b, const particle *p, int v)
{
    vec3 move = { 0, 0, 0 };
    if (!b->four) return vec3_sub(p[v].position, p[v].previous);
    for (int k = 0; k < FOUR; k++)
        move = vec3_add_scaled(move, b->four->weight[v][k],
                               vec3_sub(p[k].position, p[k].previous));
    return move;
}

// How body b moves, for a frame of dt: its middle straight on; its corners
// beside that by as much as the fastest of them turns, and what gravity adds.
// A hundredth of its radius covers what impacts add.
void rigid_look_ahead(const world *w, body *b)
{
    int n = b->plan->particles;
    real fastest = 0, dt = w->options.dt, ages = dt / w->age;
    vec3 mean = { 0, 0, 0 };
    const particle *p = w->pool.at + b->first;
    for (int v = 0; v < n; v++)
        mean = vec3_add_scaled(mean, 1.0 / n, corner_move(b, p, v));
    for (int v = 0; v < n; v++) {
        vec3 turn = vec3_sub(corner_move(b, p, v), mean);
        fastest = fmax(fastest, vec3_length_squared(turn));
    }
    b->way = vec3_scale(ages, mean);
    b->turn = ages * sqrt(fastest)
            + vec3_length(w->options.gravity) * dt * dt / 2
            + b->plan->radius / 100;
    b->reach = vec3_length(b->way) + b->turn;
}

static void look_ahead(const world *w, body *b, int is_moving)
{
    b->way = (vec3){ 0, 0, 0 };
    b->turn = b->reach = 0;
    if (is_moving && w->options.look_ahead) rigid_look_ahead(w, b);
}

static void look_at_rigid(world *w)
{
    for (int k = 0; k < w->bodies; k++) {
        body *b = &w->body[k];
        w->moves[k] = (char)body_moves(w, k);
        // Deformable bodies have lists of their own.
        w->ball[k] = (sphere){ { 0, 0, 0 }, -1 };
        if (body_is_soft(b)) continue;
        if (w->moves[k]) world_look_again(w, b);
        w->ball[k] = sphere_tree_root(&b->tree, w->of.at + b->corner);
        look_ahead(w, b, w->moves[k]);
    }
}
//<

//> rigid-pairs
// Appends pair (a, b) with what the last frame's query of it left.  Both lists
// are sorted, so one finger moves along the old one.
static void add_pair(world *w, int a, int b, int *old)
{
    const body_pair *was = w->old_pair;
    while (*old < w->old_pairs && (was[*old].a < a
           || (was[*old].a == a && was[*old].b < b))) (*old)++;
    int known = *old < w->old_pairs && was[*old].a == a && was[*old].b == b;
    body_pair *pair = &w->pair[w->pairs++];
    if (known) *pair = was[*old];
    else       *pair = (body_pair){ .a = a, .b = b };
}

// All pairs of rigid bodies whose balls come within reach of each other: the
// balls, grown by the reach, meet.  Returns how many found no room.
// Paper: section 5 tests every pair; here: PAIRS_ALL.
static int list_pairs(world *w)
{
    int old = 0, room = w->pair_capacity, found;
    for (int b = 0; b < w->bodies; b++)
        if (!body_is_soft(&w->body[b])) w->ball[b].radius += w->body[b].reach;
    found = w->options.pairs == PAIRS_ALL
        ? broad_pairs_all(w->ball, w->moves, w->bodies, w->met, room)
        : broad_pairs(&w->broad, w->ball, w->moves, w->met, room);
    for (int b = 0; b < w->bodies; b++)
        if (!body_is_soft(&w->body[b])) w->ball[b].radius -= w->body[b].reach;
    w->pairs = 0;
    for (int k = 0; k < found && k < room; k++)
        add_pair(w, w->met[k][0], w->met[k][1], &old);
    return found > room ? found - room : 0;
}
//<

//> rigid-spread
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
            if (w->moves[a]) w->body[a].reach = fmax(w->body[a].reach, far);
            if (w->moves[b]) w->body[b].reach = fmax(w->body[b].reach, far);
        }
    }
}
//<

//> rigid-wake
// Slow enough to rest: less than a twelfth of the speed, sqrt(2 g s), that a
// fall through its shortest stick gives.
real rigid_rest_speed(const world *w, const body *b)
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
        for (int i = x->first; i < x->first + body_particles(x); i++)
            w->pool.at[i].inverse_mass = w->of.inverse_mass[i];
    }
    w->trusted = -1;
}

int rigid_wake(world *w, int a, int b)
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
        woken |= rigid_wake(w, w->pair[k].a, w->pair[k].b);
    return woken;
}
//<

//> rigid-find-pairs
void rigid_find_pairs(world *w)
{
    look_at_rigid(w);
    int lost = list_pairs(w);
    if (wake_sleepers(w)) {
        look_at_rigid(w);
        lost = list_pairs(w);
    }
    if (w->options.look_ahead) {
        spread_reach(w);
        lost = list_pairs(w);
    }
    w->report.dropped += lost;
    w->report.pairs = w->pairs;
}
//<

//> rigid-keep
// m/s, the speed at which the features meet, if that makes a blow: four times
// the speed at which body b may rest, or more.  Slower ones are the unrest of a
// pile, and 0.
static real blow_speed(const world *w, const contact *c, const body *b)
{
    const particle *p = w->pool.at;
    vec3 move = vec3_sub(feature_now(c->a, p), feature_before(c->a, p));
    if (c->b.count > 0)
        move = vec3_sub(move, vec3_sub(feature_now(c->b, p),
                                       feature_before(c->b, p)));
    real speed = -vec3_dot(move, c->normal) / w->age;
    return speed > 4 * rigid_rest_speed(w, b) ? speed : 0;
}

static void keep_contact(world *w, const contact *found, int a, int b)
{
    if (w->contacts == w->contact_capacity) {
        w->report.dropped++;
        return;
    }
    w->between[w->contacts][0] = a;
    w->between[w->contacts][1] = b;
    w->contact[w->contacts] = *found;
    w->contact[w->contacts].approach = blow_speed(w, found, &w->body[a]);
    w->contacts++;
}
//<

//> rigid-push
// A point of the mesh is the weighted mean of vertices, which are weighted
// means of the four particles: so it is one of those, too.
static push_side side_of(const world *w, int number, const feature_point *f)
{
    push_side s = { .count = 0, .body = -1 };
    if (number < 0 || f->count == 0) return s;
    const body *b = &w->body[number];
    if (!b->four) {
        s = (push_side){ .first = f->vertex[0], .count = 1, .body = -1,
                         .share = { 1 } };
        return s;
    }
    s.ways = &w->ways[number];
    s.body = number;
    s.first = b->first;
    s.count = FOUR;
    for (int v = 0; v < f->count; v++)
        for (int k = 0; k < FOUR; k++)
            s.share[k] += f->weight[v] * b->four->weight[f->vertex[v]][k];
    return s;
}

push rigid_push(const world *w, const contact *c, int a, int b)
{
    push x = { .fixed = c->fixed, .thickness = c->thickness };
    x.a = side_of(w, a, &c->a);
    x.b = side_of(w, b, &c->b);
    push_directions(&x, c->normal);
    return x;
}
//<

//> rigid-memory
// Adds what pushes number `from` to `end` - 1 did in the last substep.
static void remember(world *w, int from, int end)
{
    for (int k = from; k < end; k++)
        if (w->push[k].pushed[NORMAL] > 0)
            w->memory[w->memories++] = push_remember(&w->push[k],
                w->pushed[k][0], w->pushed[k][1], w->age);
}
//<

//> rigid-recall
// The places of pushes and memories are sorted alike: bodies at planes first,
// then pairs of bodies, in order.
static int comes_before(const push_memory *m, int a, int b, int bodies)
{
    int was_plane = m->b >= bodies, is_plane = b >= bodies;
    if (was_plane != is_plane) return was_plane > is_plane;
    return m->a != a ? m->a < a : m->b < b;
}

// How far apart the points of two contacts lie, as the weights of A's particles
// tell it.
static real weights_apart(const push *c, const push_memory *m)
{
    real sum = 0;
    for (int k = 0; k < FOUR; k++) {
        real d = c->a.share[k] - m->share[k];
        sum += d * d;
    }
    return sum;
}

// Of n contacts the one whose point of A is nearest to that of m.
static push *nearest_to(const push_memory *m, push *c, int n)
{
    push *best = c;
    real least = HUGE_VAL;
    for (int i = 0; i < n; i++) {
        real d = weights_apart(&c[i], m);
        if (!(d < least)) continue;
        least = d;
        best = &c[i];
    }
    return best;
}

// Every old contact of bodies a and b hands what it pushed to the nearest of
// their n new ones.  So no push is lost, and none is taken over twice: a load
// that nobody bears throws the pile up, and it never comes to rest.
// The memory has two runs, sorted each: of contacts that were good for a frame,
// and of quick pairs.  `old` moves along in both as the pairs go by.
static void recall(world *w, push *c, int n, int a, int b, int old[2])
{
    const push_memory *m = w->memory;
    const int end[2] = { w->lasting_memories, w->memories };
    real h = w->options.dt / w->report.substeps;
    for (int run = 0; run < 2 && n > 0; run++) {
        int *k = &old[run];
        while (*k < end[run] && comes_before(&m[*k], a, b, w->bodies)) (*k)++;
        for (; *k < end[run] && m[*k].a == a && m[*k].b == b; (*k)++)
            push_recall(nearest_to(&m[*k], c, n), &m[*k], h);
    }
}
//<

//> rigid-keep-pushes
static void keep_push(world *w, push x, int a, int b)
{
    if (w->pushes == w->push_capacity) {
        w->report.dropped++;
        return;
    }
    real reach = w->body[a].reach + (b < w->bodies ? w->body[b].reach : 0);
    x.near = w->options.look_ahead ? 2 * reach / w->report.substeps : HUGE_VAL;
    w->pushed[w->pushes][0] = a;
    w->pushed[w->pushes][1] = b;
    w->push[w->pushes++] = x;
}

// Contacts of bodies a < b, or of body a with plane b - bodies.
static void keep_pushes(world *w, const contact *found, int n, int a, int b,
                        int old[2])
{
    int was = w->pushes, is_plane = b >= w->bodies;
    // An immovable body is B.
    int swap = body_is_nailed(&w->body[a]);
    int first = swap ? b : a, second = is_plane ? -1 : swap ? a : b;
    for (int k = 0; k < n; k++)
        keep_push(w, rigid_push(w, &found[k], first, second), a, b);
    if (w->options.memory)
        recall(w, &w->push[was], w->pushes - was, a, b, old);
}
//<

//> rigid-swept
// Bodies that go past each other by no more than the smaller one's inner radius
// in a share of the frame are not lost: they are seen to overlap, and on the
// right side.  Of those that go further it is asked when they first touch.
static int passes_far(const world *w, const body *a, const body *b, real share)
{
    real far = share * vec3_distance(a->way, b->way);
    return w->options.swept && far > fmin(a->plan->inner, b->plan->inner);
}

// Does A's ball, on its way as seen from B, come as near to B's as what they
// turn?  It is nearest after the share t of the way.
int rigid_flies_into(const world *w, const body *a, const body *b)
{
    if (!passes_far(w, a, b, 1)) return 0;
    sphere sa = w->ball[a - w->body], sb = w->ball[b - w->body];
    vec3 d = vec3_sub(sa.center, sb.center), way = vec3_sub(a->way, b->way);
    real t = -vec3_dot(d, way) / vec3_length_squared(way);
    t = fmin(fmax(t, 0), 1);
    real near = sa.radius + sb.radius + a->turn + b->turn;
    return vec3_length_squared(vec3_add_scaled(d, t, way)) <= near * near;
}

// How many contacts they have then, 0 or 1; -1: they cannot be told apart, and
// are looked at where they are.
static int query_swept(world *w, const body *a, const body *b, real share,
                       real apart, contact *c)
{
    collider ca = world_collider(w, a), cb = world_collider(w, b);
    vec3 way = vec3_scale(share, vec3_sub(a->way, b->way));
    switch (collide_swept(&ca, &cb, way, apart + share * (a->turn + b->turn),
                          w->swept, c)) {
    case SWEPT_PASSES:  return 0;
    case SWEPT_TOUCHES: return 1;
    default:            return -1;
    }
}
//<

//> rigid-guard
// The middle of the body's corners, as a point that rides on its particles.
static void ride_in_the_middle(push_side *s, const body *b)
{
    int corners = b->plan->particles;
    for (int k = 0; k < FOUR; k++) s->share[k] = 0;
    for (int v = 0; v < corners; v++)
        for (int k = 0; k < FOUR; k++)
            s->share[k] += b->four->weight[v][k] / corners;
}

// The touch of a bullet stops a point of it.  The rest would turn about that
// point, and be through before it is asked again.  But the ball inside the
// smaller body never gets behind the plane of touch either: a second contact,
// of its middle, keeps it in front.
static void keep_guard(world *w, const contact *touch, int a, int b)
{
    int swap = body_is_nailed(&w->body[a]);
    int first = swap ? b : a, second = swap ? a : b;
    const body *x = &w->body[first], *y = &w->body[second];
    push guard = rigid_push(w, touch, first, second);
    int is_a = x->plan->radius < y->plan->radius;
    push_side *small = is_a ? &guard.a : &guard.b;
    if (small->count != FOUR) return;
    ride_in_the_middle(small, is_a ? x : y);
    guard.thickness += (is_a ? x : y)->plan->inner;
    keep_push(w, guard, a, b);
}
//<

//> rigid-query
static int query_nearest(world *w, body_pair *pair, real margin,
                         contact found[PAIR_CONTACTS])
{
    collider a = world_collider(w, &w->body[pair->a]);
    collider b = world_collider(w, &w->body[pair->b]);
    return collide_rigid(&a, &b, margin, w->options.manifold, &pair->carried,
                         w->hit, found);
}

// The contacts of a pair in the next share of the frame; returns how many.
static int query_pair(world *w, body_pair *pair, real share, int old[2])
{
    contact found[PAIR_CONTACTS];
    const body *a = &w->body[pair->a], *b = &w->body[pair->b];
    real apart = a->thickness + b->thickness;
    int n = -1, is_bullet = passes_far(w, a, b, share);
    if (is_bullet) n = query_swept(w, a, b, share, apart, found);
    if (n < 0)
        n = query_nearest(w, pair, share * (a->reach + b->reach) + apart,
                          found);
    for (int k = 0; k < n; k++) found[k].thickness = apart;
    if (w->options.model == BODY_FOUR) {
        keep_pushes(w, found, n, pair->a, pair->b, old);
        if (is_bullet && n > 0) keep_guard(w, found, pair->a, pair->b);
        return n;
    }
    // An immovable body is B.
    int swap = body_is_nailed(a);
    for (int k = 0; k < n; k++)
        keep_contact(w, &found[k], swap ? pair->b : pair->a,
                     swap ? pair->a : pair->b);
    return n;
}
//<

//> rigid-query-all
// Once a frame: the contacts of every pair that may touch before its end.
// Those of two bodies that pass each other quickly, by more than a tenth of a
// radius, change within a frame: they come last, to be replaced.
static void query_pairs(world *w, int quick, int old[2])
{
    for (int k = 0; k < w->pairs; k++) {
        body_pair *pair = &w->pair[k];
        const body *a = &w->body[pair->a], *b = &w->body[pair->b];
        real reach = a->reach + b->reach;
        int is_quick = reach > 0.1 * fmin(a->plan->radius, b->plan->radius);
        if (is_quick != quick) continue;
        int n = query_pair(w, pair, 1, old);
        pair->quick = is_quick && (n > 0 || passes_far(w, a, b, 1));
    }
}

// Every so many substeps what the quick pairs touch now replaces what they
// touched, and takes over what that pushed.  In 1/120 s a body that spins comes
// to touch with another corner, and sinks: of four substeps every second one is
// not enough.
static int quick_every(const world *w)
{
    return w->report.substeps > 4 ? 2 : 1;
}

// Blows may have turned its way; how far others may push it stays.
static void look_again(world *w, body *b)
{
    real reach = b->reach;
    if (!body_moves(w, (int)(b - w->body))) return;
    rigid_look_ahead(w, b);
    b->reach = reach;
    world_look(w, b);
}

void rigid_find_again(world *w, int substep)
{
    int every = quick_every(w), old[2] = { 0, 0 };
    real share = (real)every / w->report.substeps;
    if (substep % every != 0) return;
    w->memories = w->lasting_memories = 0;
    remember(w, w->lasting_pushes, w->pushes);
    w->contacts = w->lasting;
    w->pushes = w->lasting_pushes;
    for (int k = 0; k < w->pairs; k++) {
        body_pair *pair = &w->pair[k];
        if (!pair->quick) continue;
        body *a = &w->body[pair->a], *b = &w->body[pair->b];
        look_again(w, a);
        look_again(w, b);
        query_pair(w, pair, share, old);
    }
}
//<

//> rigid-planes
// Every particle or vertex that moves against plane p.
static void query_plane(world *w, int k, int p, int old[2])
{
    const body *b = &w->body[k];
    collider c = world_collider(w, b);
    int room = w->contact_capacity - w->contacts;
    contact *out = &w->contact[w->contacts];
    int n = collide_plane(&c, w->plane[p], b->reach, b->thickness, out, room);
    if (n > room) {
        w->report.dropped += n - room;
        n = room;
    }
    if (b->four) {
        keep_pushes(w, out, n, k, w->bodies + p, old);
        return;
    }
    for (int i = 0; i < n; i++) keep_contact(w, &out[i], k, -1);
}

// (What is rigid was looked at when its pairs were found.)
static void query_planes(world *w, int old[2])
{
    for (int k = 0; k < w->bodies; k++) {
        body *b = &w->body[k];
        if (!w->moves[k]) continue;
        if (body_is_soft(b) && w->planes > 0) {
            look_ahead(w, b, 1);
            world_look(w, b);
        }
        for (int p = 0; p < w->planes; p++) query_plane(w, k, p, old);
    }
}

void rigid_find_contacts(world *w)
{
    int old[2] = { 0, w->lasting_memories };
    int quick[2] = { 0, w->lasting_memories };
    w->contacts = w->pushes = 0;
    world_find_ways(w);
    query_planes(w, old);
    query_pairs(w, 0, old);
    w->lasting = w->contacts;
    w->lasting_pushes = w->pushes;
    query_pairs(w, 1, quick);
}
//<

//> rigid-separate
static void touch_again(world *w, int a, int b)
{
    w->collided[a] = 1;
    if (b < 0 || b >= w->bodies) return;
    w->collided[b] = 1;
    if (!body_is_nailed(&w->body[a]) && !body_is_nailed(&w->body[b]))
        rest_touch(&w->rest, a, b);
}

static void separate_contacts(world *w)
{
    for (int k = 0; k < w->contacts; k++) {
        w->contact[k].pushed = w->contact[k].worn = 0;
        if (contact_separate(&w->contact[k], w->pool.at,
                             w->options.response) > 0)
            touch_again(w, w->between[k][0], w->between[k][1]);
    }
}

// Bodies at rest overlap by so much of what keeps them apart, which is no
// overlap of the bodies themselves: their skins only.
static const real SLOP = 0.05;

static push_options options_of(const world *w, real h)
{
    const world_options *o = &w->options;
    return (push_options){ o->response.friction, o->response.restitution,
                           o->mend, o->mend_speed,
                           vec3_scale(h * h, o->gravity), SLOP };
}

// How many contacts from k on, forward or backward, are of one pair.
static int of_one_pair(const world *w, int k, int step)
{
    int n = 1;
    for (int i = k + step; i >= 0 && i < w->pushes
         && w->pushed[i][0] == w->pushed[k][0]
         && w->pushed[i][1] == w->pushed[k][1]; i += step) n++;
    return n;
}

static int strike_in_turn(world *w, int step, push_options how, real h)
{
    int again = 0;
    for (int k = step > 0 ? 0 : w->pushes - 1, n; k >= 0 && k < w->pushes;
         k += step * n) {
        n = of_one_pair(w, k, step);
        push *first = &w->push[step > 0 ? k : k - n + 1];
        real slow = 4 * rigid_rest_speed(w, &w->body[w->pushed[k][0]]) * h;
        again |= push_blow(first, n, w->pool.at, how, slow);
    }
    return again;
}

// Every pair in turn, until none strikes again: a blow that is passed on, as in
// Newton's cradle, is one more blow.  Forward and backward, so that one round
// takes it through a row, whichever way that is numbered.
static void strike_all(world *w, push_options how, real h)
{
    enum { ROUNDS = 8 };
    int again = how.restitution > 0;
    for (int round = 0; again && round < ROUNDS; round++)
        again = strike_in_turn(w, round % 2 ? -1 : 1, how, h);
}

static void book_friction(world *w, real h)
{
    real worn = 0;
    for (int k = 0; k < w->pushes; k++) {
        worn += w->push[k].worn;
        w->push[k].worn = 0;
    }
    for (int k = 0; k < w->contacts; k++) worn += w->contact[k].worn;
    ledger_friction(w, worn / (h * h));
}
//<

//> rigid-solve
// One pass forward, one backward, for only both together converge without
// swinging.  Returns the largest change of a gap (m).
static real pass_twice(push_pile *s, push_options how)
{
    real forward = pile_pass(s, 1, how);
    return fmax(forward, pile_pass(s, -1, how));
}

// Passes shrink what is wrong in a stack of n by 1 - 1/n^2 a time, with m under
// M by 1 - m/M.  With Nesterov's momentum these are 1 - 1/n and 1 - sqrt(m/M):
// each pair begins a little further on than the last one ended, by more and
// more, until that leads back: then it begins anew (O'Donoghue, Candes 2015).
static real lean_on(push_pile *s, real pace)
{
    if (pile_leads_on(s) < 0) pace = 1;
    real next = (1 + sqrt(1 + 4 * pace * pace)) / 2;
    pile_lean(s, (pace - 1) / next);
    return next;
}

static void solve_all(world *w, push_options how, real h)
{
    push_pile s = { w->push, w->pushes, w->drift, w->bodies, w->near_push, 0 };
    real enough = w->options.content * w->least_radius, pace = 1;
    pile_begin(&s, w->pool.at, how, h);
    if (s.nears == 0) return;
    pile_mark(&s);
    for (int pass = 0; pass < w->options.passes; pass += 2) {
        if (pass > 0) pace = lean_on(&s, pace);
        if (!(pass_twice(&s, how) > enough)) break;
    }
    for (int b = 0; b < w->bodies; b++)
        if (w->body[b].four && body_moves(w, b))
            drift_apply(&w->drift[b], &w->ways[b],
                        w->pool.at + w->body[b].first);
}

void rigid_separate(world *w, real h)
{
    push_options how = options_of(w, h);
    separate_contacts(w);
    strike_all(w, how, h);
    if (w->pushes > 0) solve_all(w, how, h);
    book_friction(w, h);
}
//<

//> rigid-remember
void rigid_remember(world *w)
{
    body_pair *last = w->old_pair;
    w->old_pair = w->pair;
    w->old_pairs = w->pairs;
    w->pair = last;
    for (int k = 0; k < w->pushes; k++)
        if (w->push[k].pushed[NORMAL] > 0)
            touch_again(w, w->pushed[k][0], w->pushed[k][1]);
    w->memories = 0;
    remember(w, 0, w->lasting_pushes);
    w->lasting_memories = w->memories;
    remember(w, w->lasting_pushes, w->pushes);
    w->report.contacts = w->contacts + w->pushes;
    w->report.pushing = w->memories;
}
//<

//> rigid-bounce
static void slow_sticks(world *w, int b)
{
    if (b < 0 || !w->moves[b]) return;
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
void rigid_bounce(world *w, real h)
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
