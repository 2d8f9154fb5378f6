//> contacts-blow
#include "contacts.h"

#include <stddef.h>

real contacts_blow_speed(const world *w, const body *b)
{
    return sqrt(2 * vec3_length(w->options.gravity) * b->plan->spacing) / 3;
}

// m/s, the speed at which the features meet, if that makes a blow for body b.
// Slower ones are the unrest of a pile, and 0.
static real speed_of_blow(const world *w, const contact *c, const body *b)
{
    const particle *p = w->pool.at;
    vec3 move = vec3_sub(feature_now(c->a, p), feature_before(c->a, p));
    if (c->b.count > 0)
        move = vec3_sub(move, vec3_sub(feature_now(c->b, p),
                                       feature_before(c->b, p)));
    real speed = -vec3_dot(move, c->normal) / w->age;
    return speed > contacts_blow_speed(w, b) ? speed : 0;
}

static void keep_one(world *w, const contact *found, int a, int b)
{
    if (w->contacts == w->contact_capacity) {
        w->report.dropped++;
        return;
    }
    w->between[w->contacts][0] = a;
    w->between[w->contacts][1] = b;
    w->contact[w->contacts] = *found;
    w->contact[w->contacts].approach = speed_of_blow(w, found, &w->body[a]);
    w->contacts++;
}
//<

//> contacts-push
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
    if (w->moves[number]) s.body = number;
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

push contacts_push(const world *w, const contact *c, int a, int b)
{
    push x = { .ready = 0 };
    begin_push(w, &x, c, a, b);
    push_directions(&x, c->normal);
    return x;
}
//<

//> contacts-remember
void contacts_remember(world *w, int from, int end)
{
    for (int k = from; k < end; k++)
        if (w->push[k].pushed[NORMAL] > 0)
            w->memory[w->memories++] = push_remember(&w->push[k],
                w->pushed[k][0], w->pushed[k][1], w->age);
}
//<

//> contacts-recall
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

//> contacts-room
real contacts_slack(const world *w, int a, int b)
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
    return 2 * (reach + contacts_slack(w, a, b)) / w->report.substeps;
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
//<

//> contacts-keep
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

void contacts_keep(world *w, const contact *found, int n, int a, int b,
                   int old[2])
{
    if (w->body[a].four) {
        keep_pushes(w, found, n, a, b, old);
        return;
    }
    // An immovable body is B.
    int swap = body_is_nailed(&w->body[a]), is_plane = b >= w->bodies;
    int first = swap ? b : a, second = is_plane ? -1 : swap ? a : b;
    for (int k = 0; k < n; k++) keep_one(w, &found[k], first, second);
}
//<

//> contacts-stay
void contacts_stay(world *w, push_run *run, int a, int b)
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

int contacts_may_stay(const world *w, const push_run *run, int a, int b,
                      real margin)
{
    return !w->fresh[a] && (b >= w->bodies || !w->fresh[b]) && run->margin > 0
        && margin + contacts_slack(w, a, b) <= run->margin;
}
//<

//> contacts-guard
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
void contacts_guard(world *w, const contact *touch, int a, int b)
{
    int swap = body_is_nailed(&w->body[a]);
    int first = swap ? b : a, second = swap ? a : b;
    const body *x = &w->body[first], *y = &w->body[second];
    push guard = contacts_push(w, touch, first, second), *kept;
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
