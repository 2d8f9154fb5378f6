//> rigid-reach
#include "ledger.h"
#include "rigid.h"

#include <stddef.h>

// m, what vertices may go beside what the fastest of them turns: what gravity
// adds in a frame; and a hundredth of the radius for what impacts add.
static real beside(const world *w, const body *b)
{
    real dt = w->options.dt;
    return vec3_length(w->options.gravity) * dt * dt / 2
         + b->plan->radius / 100;
}

// How a body of four moves: its vertices go as their weights say.
static real way_of_four(const four *f, const particle *p, int n, vec3 *mean)
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

//> rigid-reach-frame
// For a frame of dt: its middle goes straight on; its vertices beside that as
// much as the fastest of them turns.
void rigid_look_ahead(const world *w, body *b)
{
    int n = b->plan->particles;
    vec3 mean;
    const particle *p = w->pool.at + b->first;
    real ages = w->options.dt / w->age;
    real fastest = b->four ? way_of_four(b->four, p, n, &mean)
                           : way_of_vertices(p, n, &mean);
    b->way = vec3_scale(ages, mean);
    b->turn = ages * sqrt(fastest) + beside(w, b);
    b->reach = vec3_length(b->way) + b->turn;
}
//<

//> rigid-look
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

static void look_ahead(const world *w, body *b, int is_moving)
{
    b->way = (vec3){ 0, 0, 0 };
    b->turn = b->reach = 0;
    if (is_moving && w->options.look_ahead) rigid_look_ahead(w, b);
}

//<

//> rigid-fresh
// Are the particles of b, but for a thousandth of its radius, where its
// contacts were found?
static int lies_where_seen(const world *w, const body *b)
{
    real far = w->options.stay * b->plan->radius, most = 0;
    if (!b->four || far == 0 || w->softs > 0) return 0;
    for (int i = b->first; i < b->first + FOUR; i++) {
        vec3 d = vec3_sub(w->pool.at[i].position, w->of.seen[i]);
        real square = vec3_length_squared(d);
        most = square <= most ? most : square;
    }
    return most <= far * far;
}

// The ball around a rigid body.  Sticks of four particles are never off by more
// than a hundredth.
static sphere ball_of(const world *w, body *b)
{
    const particle *p = w->pool.at + b->first;
    vec3 sum = { 0, 0, 0 };
    if (!b->four) return sphere_tree_root(&b->tree, w->of.at + b->corner);
    for (int k = 0; k < FOUR; k++)
        sum = vec3_add_scaled(sum, 1.0 / FOUR, p[k].position);
    return (sphere){ sum, 1.02 * b->four->reach };
}

// Where it is now, and how it can move.
static void look_anew(world *w, body *b)
{
    int k = (int)(b - w->body);
    w->fresh[k] = w->looked[k] = 1;
    if (!b->four || w->softs > 0) world_look_again(w, b);
    else                          world_look(w, b);
    world_find_ways(w, b);
    for (int i = b->first; i < b->first + body_particles(b); i++)
        w->of.seen[i] = w->pool.at[i].position;
}

static void look_at_rigid(world *w)
{
    for (int k = 0; k < w->bodies; k++) {
        body *b = &w->body[k];
        int moves = body_moves(w, k), changed = moves != w->moves[k];
        w->moves[k] = (char)moves;
        // Deformable bodies have lists of their own.
        if (body_is_soft(b)) w->ball[k] = (sphere){ { 0, 0, 0 }, -1 };
        if (body_is_soft(b) || (!moves && !changed && w->ball[k].radius > 0))
            continue;
        if (changed || (moves && !lies_where_seen(w, b))) look_anew(w, b);
        w->ball[k] = ball_of(w, b);
        if (moves && !w->fresh[k] && w->options.look_ahead)
            look_ahead_still(w, b);
        else
            look_ahead(w, b, moves);
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
        if (!body_is_soft(&w->body[b])) {
            w->listed[b] = w->body[b].reach + w->body[b].thickness
                         + 4 * w->options.stay * w->body[b].plan->radius;
            w->ball[b].radius += w->listed[b];
        }
    found = w->options.pairs == PAIRS_ALL
        ? broad_pairs_all(w->ball, w->moves, w->bodies, w->met, room)
        : broad_pairs(&w->broad, w->ball, w->moves, w->met, room);
    for (int b = 0; b < w->bodies; b++)
        if (!body_is_soft(&w->body[b])) w->ball[b].radius -= w->listed[b];
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
// Is nobody elsewhere, and nobody faster, than when pairs were listed?  Then
// these are the pairs, and no ball need be looked at.
static int list_is_good(world *w)
{
    for (int b = 0; b < w->bodies; b++) {
        const body *x = &w->body[b];
        if (w->fresh[b] || body_is_soft(x)) return 0;
        real slack = 2 * w->options.stay * x->plan->radius;
        if (!(x->reach + x->thickness + slack <= w->listed[b])) return 0;
    }
    return w->options.look_ahead && w->options.stay > 0;
}

// This frame's list becomes the last one's.
static void start_list(world *w)
{
    body_pair *last = w->old_pair;
    w->old_pair = w->pair;
    w->old_pairs = w->pairs;
    w->pair = last;
}

// The list of the last frame, if it is good, and nobody wakes.
static int keep_list(world *w)
{
    if (!list_is_good(w) || wake_sleepers(w)) return 0;
    spread_reach(w);
    return list_is_good(w);
}

void rigid_find_pairs(world *w)
{
    for (int b = 0; b < w->bodies; b++) w->fresh[b] = w->looked[b] = 0;
    look_at_rigid(w);
    w->report.pairs = w->pairs;
    if (keep_list(w)) return;
    start_list(w);
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

// All but the directions.
static void begin_push(const world *w, push *x, const contact *c, int a, int b)
{
    for (int d = 0; d < DIRECTIONS; d++) x->pushed[d] = 0;
    x->worn = 0;
    x->ready = x->far = 0;
    x->fixed = c->fixed;
    x->thickness = c->thickness;
    x->a = side_of(w, a, &c->a);
    x->b = side_of(w, b, &c->b);
}

push rigid_push(const world *w, const contact *c, int a, int b)
{
    push x = { .ready = 0 };
    begin_push(w, &x, c, a, b);
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
// m, what two bodies may have come nearer since their contacts were found, and
// still be taken to lie where they lay.
static real slack_of(const world *w, int a, int b)
{
    real radius = w->body[a].plan->radius;
    if (b < w->bodies) radius += w->body[b].plan->radius;
    return 2 * w->options.stay * radius;
}

// m, twice what two bodies may come nearer in a substep.
static real near_of(const world *w, int a, int b)
{
    real reach = w->body[a].reach + (b < w->bodies ? w->body[b].reach : 0);
    if (!w->options.look_ahead) return HUGE_VAL;
    return 2 * (reach + slack_of(w, a, b)) / w->report.substeps;
}

// Room for one more contact of a and b; NULL: there is none.
static push *next_push(world *w, int a, int b)
{
    if (w->pushes == w->push_capacity) {
        w->report.dropped++;
        return NULL;
    }
    push *x = &w->push[w->pushes];
    w->pushed[w->pushes][0] = a;
    w->pushed[w->pushes][1] = b;
    w->pushes++;
    return x;
}

// Contacts of bodies a < b, or of body a with plane b - bodies.  All have one
// normal.
static void keep_pushes(world *w, const contact *found, int n, int a, int b,
                        int old[2])
{
    int was = w->pushes, is_plane = b >= w->bodies;
    // An immovable body is B.
    int swap = body_is_nailed(&w->body[a]);
    int first = swap ? b : a, second = is_plane ? -1 : swap ? a : b;
    real near = near_of(w, a, b);
    for (int k = 0; k < n; k++) {
        push *x = next_push(w, a, b);
        if (!x) continue;
        begin_push(w, x, &found[k], first, second);
        x->near = near;
        if (k == 0) push_directions(x, found[0].normal);
        for (int d = 0; k > 0 && d < DIRECTIONS; d++)
            x->along[d] = x[-1].along[d];
    }
    if (w->options.memory)
        recall(w, &w->push[was], w->pushes - was, a, b, old);
}
//<

//> rigid-stay
// The last frame's contacts of a and b go on as they are, and begin with what
// they pushed.
static void stay(world *w, push_run *run, int a, int b)
{
    real h = w->options.dt / w->report.substeps, longer = h / w->age;
    int from = run->first;
    run->first = w->pushes;
    if (w->pushes + run->count > w->push_capacity) {
        w->report.dropped += run->count;
        run->count = 0;
    }
    for (int k = 0; k < run->count; k++) {
        push *x = &w->push[w->pushes];
        int *bodies = w->pushed[w->pushes++];
        *x = w->old_push[from + k];
        bodies[0] = w->old_pushed[from + k][0];
        bodies[1] = w->old_pushed[from + k][1];
        x->near = near_of(w, a, b);
        x->far = 0;
        for (int d = 0; d < DIRECTIONS; d++)
            x->pushed[d] *= w->options.memory ? longer * longer : 0;
    }
}

// Is there nothing new to be found within `margin` of a and b?
static int may_stay(const world *w, const push_run *run, int a, int b,
                    real margin)
{
    return !w->fresh[a] && (b >= w->bodies || !w->fresh[b]) && run->margin > 0
        && margin + slack_of(w, a, b) <= run->margin;
}

static void look_now(world *w, int k)
{
    if (w->looked[k]) return;
    world_look(w, &w->body[k]);
    w->looked[k] = 1;
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
    push guard = rigid_push(w, touch, first, second), *kept;
    int is_a = x->plan->radius < y->plan->radius;
    push_side *small = is_a ? &guard.a : &guard.b;
    if (small->count != FOUR) return;
    ride_in_the_middle(small, is_a ? x : y);
    guard.thickness += (is_a ? x : y)->plan->inner;
    guard.near = near_of(w, a, b);
    kept = next_push(w, a, b);
    if (kept) *kept = guard;
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

// Are the balls around two bodies, now, further apart than the margin?
static int balls_are_apart(const world *w, body *a, body *b, real margin)
{
    if (!a->four || !b->four) return 0;
    sphere x = ball_of(w, a), y = ball_of(w, b);
    real near = x.radius + y.radius + margin;
    return vec3_length_squared(vec3_sub(x.center, y.center)) > near * near;
}

// The contacts of a pair in the next share of the frame, and those that are no
// more than a slack (m) further.
static void query_pair(world *w, body_pair *pair, real share, real slack,
                       int old[2])
{
    contact found[PAIR_CONTACTS];
    body *a = &w->body[pair->a], *b = &w->body[pair->b];
    real apart = a->thickness + b->thickness;
    real margin = share * (a->reach + b->reach) + apart + slack;
    int n = -1, is_bullet = passes_far(w, a, b, share);
    if (!is_bullet && balls_are_apart(w, a, b, margin)) return;
    look_now(w, pair->a);
    look_now(w, pair->b);
    if (is_bullet) n = query_swept(w, a, b, share, apart, found);
    if (n < 0) n = query_nearest(w, pair, margin, found);
    for (int k = 0; k < n; k++) found[k].thickness = apart;
    if (w->options.model == BODY_FOUR) {
        keep_pushes(w, found, n, pair->a, pair->b, old);
        if (is_bullet && n > 0) keep_guard(w, found, pair->a, pair->b);
        return;
    }
    // An immovable body is B.
    int swap = body_is_nailed(a);
    for (int k = 0; k < n; k++)
        keep_contact(w, &found[k], swap ? pair->b : pair->a,
                     swap ? pair->a : pair->b);
}
//<

//> rigid-query-all
// Every so many substeps what the quick pairs touch now replaces what they
// touched, and takes over what that pushed.  In 1/120 s a body that spins comes
// to touch with another corner, and sinks: of four substeps every second one is
// not enough.
static int quick_every(const world *w)
{
    return w->report.substeps > 4 ? 2 : 1;
}

//<

//> rigid-query-frame
// By more than a tenth of a radius in a frame?
static int is_quick(const body *a, const body *b)
{
    real far = vec3_distance(a->way, b->way) + a->turn + b->turn;
    return far > 0.1 * fmin(a->plan->radius, b->plan->radius);
}

// m, so near that they may touch within the frame.
static real needed(const body *a, const body *b)
{
    return a->reach + b->reach + a->thickness + b->thickness;
}

// Once a frame: the contacts of every pair that may touch before its end.
// Those of two bodies that pass each other quickly change within a frame: they
// come last, to be replaced.
static void query_pairs(world *w, int quick, int old[2])
{
    real share = quick ? (real)quick_every(w) / w->report.substeps : 1;
    for (int k = 0; k < w->pairs; k++) {
        body_pair *pair = &w->pair[k];
        const body *a = &w->body[pair->a], *b = &w->body[pair->b];
        real margin = needed(a, b);
        if (is_quick(a, b) != quick) continue;
        if (!quick && may_stay(w, &pair->run, pair->a, pair->b, margin)) {
            stay(w, &pair->run, pair->a, pair->b);
            continue;
        }
        int first = w->pushes, dropped = w->report.dropped;
        real slack = quick ? 0 : 2 * slack_of(w, pair->a, pair->b);
        query_pair(w, pair, passes_far(w, a, b, 1) ? 1 : share, slack, old);
        int is_whole = w->options.model == BODY_FOUR && !quick
                       && dropped == w->report.dropped;
        pair->run = (push_run){ first, w->pushes - first,
                                is_whole ? margin + slack : 0 };
        pair->quick = quick;
    }
}

//<

//> rigid-query-again
// Blows may have turned its way; how far others may push it stays.
static void look_again(world *w, body *b)
{
    real reach = b->reach;
    int k = (int)(b - w->body);
    if (!body_moves(w, k) || w->looked[k]) return;
    rigid_look_ahead(w, b);
    b->reach = reach;
    look_now(w, k);
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
    for (int b = 0; b < w->bodies; b++) w->looked[b] = !w->moves[b];
    for (int k = 0; k < w->pairs; k++) {
        body_pair *pair = &w->pair[k];
        if (!pair->quick) continue;
        body *a = &w->body[pair->a], *b = &w->body[pair->b];
        look_again(w, a);
        look_again(w, b);
        query_pair(w, pair, share, 0, old);
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
    real margin = b->reach + 2 * slack_of(w, k, w->bodies);
    int n = collide_plane(&c, w->plane[p], margin, b->thickness, out, room);
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

static void query_walls(world *w, int k, int old[2])
{
    const body *b = &w->body[k];
    push_run *run = &w->wall[k];
    if (b->four && may_stay(w, run, k, w->bodies, b->reach)) {
        stay(w, run, k, w->bodies);
        return;
    }
    int first = w->pushes, dropped = w->report.dropped;
    look_now(w, k);
    for (int p = 0; p < w->planes; p++) query_plane(w, k, p, old);
    real margin = b->reach + 2 * slack_of(w, k, w->bodies);
    *run = (push_run){ first, w->pushes - first,
                       dropped == w->report.dropped ? margin : 0 };
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
            w->looked[k] = 1;
        }
        query_walls(w, k, old);
    }
}

//<

//> rigid-find-contacts
// Are all contacts of the last frame those of this one?  Then they are left
// where they are.
static int all_stay(const world *w)
{
    int found = 0;
    if (w->age != w->options.dt / w->report.substeps || !w->options.memory
        || w->pushes > w->lasting_pushes || w->softs > 0 || w->contacts > 0)
        return 0;
    for (int k = 0; k < w->bodies; k++) {
        const push_run *run = &w->wall[k];
        if (!w->moves[k]) continue;
        if (!may_stay(w, run, k, w->bodies, w->body[k].reach)) return 0;
        found += run->count;
    }
    for (int k = 0; k < w->pairs; k++) {
        const body_pair *x = &w->pair[k];
        const body *a = &w->body[x->a], *b = &w->body[x->b];
        if (is_quick(a, b)
            || !may_stay(w, &x->run, x->a, x->b, needed(a, b))) return 0;
        found += x->run.count;
    }
    return found == w->pushes;
}

static void swap_pushes(world *w)
{
    push *x = w->push;
    int (*of)[2] = w->pushed;
    w->push = w->old_push;
    w->pushed = w->old_pushed;
    w->old_push = x;
    w->old_pushed = of;
}

void rigid_find_contacts(world *w)
{
    int old[2] = { 0, w->lasting_memories };
    int quick[2] = { 0, w->lasting_memories };
    if (all_stay(w)) return;
    swap_pushes(w);
    w->contacts = w->pushes = 0;
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
                           vec3_scale(h * h, o->gravity), SLOP, o->ledger };
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
    if (!w->options.ledger) return;
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
static real pass_twice(push_pile *s, real enough, push_options how)
{
    real forward = pile_pass(s, 1, enough, how);
    return fmax(forward, pile_pass(s, -1, enough, how));
}

// Passes shrink what is wrong in a stack of n by 1 - 1/n^2 a time, with m under
// M by 1 - m/M.  With Nesterov's momentum these are 1 - 1/n and 1 - sqrt(m/M):
// each pair begins a little further on than the last one ended, by more and
// more, until that leads back: then it begins anew (O'Donoghue, Candes 2015).
static real lean_on(push_pile *s, real pace, push_options how)
{
    if (pile_leads_on(s) < 0) pace = 1;
    real next = (1 + sqrt(1 + 4 * pace * pace)) / 2;
    pile_lean(s, (pace - 1) / next, how);
    return next;
}

static void solve_all(world *w, push_options how, real h)
{
    push_pile s = { w->push, w->pushes, w->drift, w->bodies, w->near_push, 0 };
    real enough = w->options.content * w->least_radius, pace = 1;
    pile_begin(&s, w->pool.at, how, h);
    if (s.nears == 0) return;
    for (int pass = 0; pass < w->options.passes; pass += 2) {
        if (pass > 0) pace = lean_on(&s, pace, how);
        if (!(pass_twice(&s, enough, how) > enough)) break;
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
