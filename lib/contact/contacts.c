//> contacts-blow
#include "contacts.h"
#include "halves.h"

real contacts_blow_speed(const world *w, const body *b)
{
    return sqrt(2 * vec3_length(w->options.gravity) * b->plan->spacing) / 3;
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
    if (body_is_soft(b)) {
        s = (push_side){ .first = f->vertex[0], .count = 1, .body = -1,
                         .share = { 1 } };
        return s;
    }
    s.ways = &w->pushes.ways[number];
    if (w->flags.moves[number]) s.body = number;
    s.first = b->first;
    s.count = FOUR;
    for (int v = 0; v < f->count; v++)
        for (int k = 0; k < FOUR; k++)
            s.share[k] += f->weight[v] * b->four->weight[f->vertex[v]][k];
    return s;
}

// All but the directions.
static void begin_push(const world *w, push *x, const contact_point *c, int a, int b)
{
    for (int d = 0; d < DIRECTIONS; d++) x->pushed[d] = 0;
    x->worn = 0;
    x->ready = x->far = 0;
    x->fixed = c->fixed;
    x->thickness = c->thickness;
    x->a = side_of(w, a, &c->a);
    x->b = side_of(w, b, &c->b);
}

push contacts_push(const world *w, const contact_point *c, int a, int b)
{
    push x = { .ready = 0 };
    begin_push(w, &x, c, a, b);
    push_directions(&x, c->normal);
    return x;
}
//<

//> contacts-recall
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

// Of the last frame's contacts `was` every one with b hands what it pushed to
// the nearest of the n new ones.  So no push is lost, and none is taken over
// twice: a load that nobody bears throws the pile up, and it never comes to
// rest.
static void recall(const world *w, push *c, int n, int b, contact_run was)
{
    real h = w->options.dt / w->report.substeps;
    for (int k = was.first; k < was.first + was.count && n > 0; k++) {
        const push *old = &w->pushes.old[k];
        if (w->pushes.old_between[k][1] != b || !(old->pushed[NORMAL] > 0))
            continue;
        push_memory m = push_remember(old, w->age);
        push_recall(nearest_to(&m, c, n), &m, h);
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
    return 2 * (reach + contacts_slack(w, a, b)) / w->report.substeps;
}
//<

//> contacts-write
// Who is A and who B: what is immovable is B.
typedef struct {
    int a, b;               // B: -1: a plane
} sides;

static sides sides_of(const world *w, int a, int b)
{
    if (b >= w->bodies) return (sides){ a, -1 };
    return body_is_nailed(&w->body[a]) ? (sides){ b, a } : (sides){ a, b };
}

// Contacts number first to first + n - 1, of a and b; all have one normal.
static void write_found(world *w, int first, const contact_point *found, int n,
                        int a, int b, contact_run was)
{
    push *x = &w->pushes.at[first];
    sides of = sides_of(w, a, b);
    real near = near_of(w, a, b);
    for (int k = 0; k < n; k++) {
        begin_push(w, &x[k], &found[k], of.a, of.b);
        x[k].near = near;
        if (k == 0) push_directions(x, found[0].normal);
        for (int d = 0; k > 0 && d < DIRECTIONS; d++)
            x[k].along[d] = x[0].along[d];
        w->pushes.between[first + k][0] = a;
        w->pushes.between[first + k][1] = b;
    }
    if (w->options.memory) recall(w, x, n, b, was);
}
//<

//> contacts-stay
int contacts_may_stay(const world *w, const contact_run *run, int a, int b,
                      real margin)
{
    const char *fresh = w->flags.fresh;
    return !fresh[a] && (b >= w->bodies || !fresh[b]) && run->margin > 0
        && margin + contacts_slack(w, a, b) <= run->margin;
}

// The last frame's contacts of a and b go on as they are, and begin with what
// they pushed.
static void write_same(world *w, const inquiry *is, int a, int b)
{
    push_tables *t = &w->pushes;
    real h = w->options.dt / w->report.substeps, longer = h / w->age;
    real near = near_of(w, a, b);
    for (int k = 0; k < is->run.count; k++) {
        int to = is->run.first + k, from = is->was.first + k;
        push *x = &t->at[to];
        *x = t->old[from];
        t->between[to][0] = t->old_between[from][0];
        t->between[to][1] = t->old_between[from][1];
        x->near = near;
        x->far = 0;
        for (int d = 0; d < DIRECTIONS; d++)
            x->pushed[d] *= w->options.memory ? longer * longer : 0;
    }
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

static int is_smaller(const world *w, int a, int b)
{
    return w->body[a].plan->radius < w->body[b].plan->radius;
}

int contacts_have_guard(const world *w, int a, int b)
{
    sides of = sides_of(w, a, b);
    int small = is_smaller(w, of.a, of.b) ? of.a : of.b;
    return !body_is_nailed(&w->body[small]);
}

// The touch of a bullet stops a point of it.  The rest would turn about that
// point, and be through before it is asked again.  But the ball inside the
// smaller body never gets behind the plane of touch either: a second contact,
// of its middle, keeps it in front.
static void write_guard(world *w, int place, const contact_point *at, int a,
                        int b)
{
    sides of = sides_of(w, a, b);
    push *guard = &w->pushes.at[place];
    int is_a = is_smaller(w, of.a, of.b);
    const body *small = &w->body[is_a ? of.a : of.b];
    *guard = contacts_push(w, at, of.a, of.b);
    ride_in_the_middle(is_a ? &guard->a : &guard->b, small);
    guard->thickness += small->inner;
    guard->near = near_of(w, a, b);
    w->pushes.between[place][0] = a;
    w->pushes.between[place][1] = b;
}
//<

//> contacts-found
contact_point *contacts_of_planes(const world *w, int k)
{
    return w->narrow.found + w->planes * (w->body[k].corner - w->pool.count);
}

contact_point *contacts_of_pair(const world *w, const body_pair *pair)
{
    return w->narrow.found + w->planes * (w->of.corners - w->pool.count)
         + pair->place;
}

void contacts_write_pair(world *w, const body_pair *x)
{
    const inquiry *is = &x->is;
    const contact_point *found = contacts_of_pair(w, x);
    int n = int_min(is->found, is->run.count);
    if (is->ask == ASK_STAYS) {
        write_same(w, is, x->a, x->b);
        return;
    }
    write_found(w, is->run.first, found, n, x->a, x->b, is->was);
    if (n < is->run.count)
        write_guard(w, is->run.first + n, found, x->a, x->b);
}

void contacts_write_planes(world *w, int k)
{
    const inquiry *is = &w->narrow.wall[k].is;
    const contact_point *found = contacts_of_planes(w, k);
    if (is->ask == ASK_STAYS) write_same(w, is, k, w->bodies);
    if (is->ask != ASK_NEAREST) return;
    for (int p = 0, at = 0; p < w->planes; p++) {
        int n = int_min(w->narrow.wall[k].at[p], is->run.count - at);
        write_found(w, is->run.first + at, found + at, n, k, w->bodies + p,
                    is->was);
        at += n;
    }
}
//<

//> contacts-place
// Where the next contact of each kind goes: the lasting ones stand before those
// of quick pairs, and of either the parts of the pile one after the other.
typedef struct {
    int push[2][PILE_PARTS];
} places;

static int *place_of(places *p, const world *w, int a, int b, int quick)
{
    return &p->push[quick][halves_part(w, a, b)];
}

static int count_of(const inquiry *is)
{
    return is->ask == ASK_STAYS ? is->was.count : is->found + is->guard;
}

static void count_all(const world *w, int again, places *p)
{
    for (int k = 0; k < w->bodies && !again; k++)
        if (w->flags.moves[k])
            *place_of(p, w, k, w->bodies, 0) += count_of(&w->narrow.wall[k].is);
    for (int k = 0; k < w->pairs.count; k++) {
        const body_pair *x = &w->pairs.at[k];
        if (!again || x->quick)
            *place_of(p, w, x->a, x->b, x->quick) += count_of(&x->is);
    }
}

// What begins at *end ends n later; returns where it begins.
static int begins(int *end, int n)
{
    *end += n;
    return *end - n;
}

// Counts become places: where those before them end.
static void sum_up(places *p, world *w, int again)
{
    int pushes = again ? w->pushes.lasting : 0;
    for (int quick = 0; quick < 2; quick++) {
        if (quick && !again)
            w->pushes.lasting = int_min(pushes, w->pushes.capacity);
        for (int part = 0; part < PILE_PARTS; part++)
            p->push[quick][part] = begins(&pushes, p->push[quick][part]);
    }
    w->pushes.count = int_min(pushes, w->pushes.capacity);
}
//<

//> contacts-place-all
// Contacts of a and b get their room.
static void place(world *w, places *p, inquiry *is, int a, int b, int quick)
{
    int *next = place_of(p, w, a, b, quick), n = count_of(is);
    int room = w->pushes.capacity - *next;
    int count = room > n ? n : room > 0 ? room : 0;
    real margin = is->ask == ASK_STAYS ? is->was.margin : is->margin;
    if (count < n || quick) margin = 0;
    is->run = (contact_run){ *next, count, margin };
    w->report.dropped += n - count;
    *next += n;
}

void contacts_place(world *w, int again)
{
    places p = { .push = { { 0 } } };
    count_all(w, again, &p);
    sum_up(&p, w, again);
    for (int k = 0; k < w->bodies && !again; k++) {
        inquiry *is = &w->narrow.wall[k].is;
        is->run = (contact_run){ 0, 0, 0 };
        if (w->flags.moves[k]) place(w, &p, is, k, w->bodies, 0);
    }
    for (int k = 0; k < w->pairs.count; k++) {
        body_pair *x = &w->pairs.at[k];
        if (!again || x->quick) place(w, &p, &x->is, x->a, x->b, x->quick);
    }
}
//<
