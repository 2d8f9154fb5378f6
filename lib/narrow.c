//> narrow-swept
#include "narrow.h"
#include "contacts.h"
#include "halves.h"
#include "pairs.h"

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

//> narrow-query
static void look_now(world *w, int k)
{
    if (w->looked[k]) return;
    world_look(w, &w->body[k]);
    w->looked[k] = 1;
}

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
    sphere x = pairs_ball(w, a), y = pairs_ball(w, b);
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
    int n = -1, is_bullet = pairs_pass_far(w, a, b, share);
    if (!is_bullet && balls_are_apart(w, a, b, margin)) return;
    look_now(w, pair->a);
    look_now(w, pair->b);
    if (is_bullet) n = query_swept(w, a, b, share, apart, found);
    if (n < 0) n = query_nearest(w, pair, margin, found);
    for (int k = 0; k < n; k++) found[k].thickness = apart;
    contacts_keep(w, found, n, pair->a, pair->b, old);
    if (is_bullet && n > 0) contacts_guard(w, found, pair->a, pair->b);
}
//<

//> narrow-every
// Every so many substeps what the quick pairs touch now replaces what they
// touched, and takes over what that pushed.  In 1/120 s a body that spins comes
// to touch with another corner, and sinks: of four substeps every second one is
// not enough.
static int quick_every(const world *w)
{
    return w->report.substeps > 4 ? 2 : 1;
}
//<

//> narrow-pairs
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
        if (!quick
            && contacts_may_stay(w, &pair->run, pair->a, pair->b, margin)) {
            contacts_stay(w, &pair->run, pair->a, pair->b);
            continue;
        }
        int first = w->pushes, dropped = w->report.dropped;
        real slack = quick ? 0 : 2 * contacts_slack(w, pair->a, pair->b);
        query_pair(w, pair, pairs_pass_far(w, a, b, 1) ? 1 : share, slack, old);
        int is_whole = w->options.model == BODY_FOUR && !quick
                       && dropped == w->report.dropped;
        pair->run = (push_run){ first, w->pushes - first,
                                is_whole ? margin + slack : 0 };
        pair->quick = quick;
    }
}
//<

//> narrow-again
// Blows may have turned its way; how far others may push it stays.
static void look_again(world *w, body *b)
{
    real reach = b->reach;
    int k = (int)(b - w->body);
    if (!body_moves(w, k) || w->looked[k]) return;
    pairs_look_ahead(w, b);
    b->reach = reach;
    look_now(w, k);
}

void narrow_find_again(world *w, int substep)
{
    int every = quick_every(w), old[2] = { 0, 0 };
    real share = (real)every / w->report.substeps;
    if (substep % every != 0) return;
    w->memories = w->lasting_memories = 0;
    contacts_remember(w, w->lasting_pushes, w->pushes);
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
    halves_sort(w);
}
//<

//> narrow-planes
// Every particle or vertex that moves against plane p.
static void query_plane(world *w, int k, int p, int old[2])
{
    const body *b = &w->body[k];
    collider c = world_collider(w, b);
    int room = w->contact_capacity - w->contacts;
    contact *out = &w->contact[w->contacts];
    real margin = b->reach + 2 * contacts_slack(w, k, w->bodies);
    int n = collide_plane(&c, w->plane[p], margin, b->thickness, out, room);
    if (n > room) {
        w->report.dropped += n - room;
        n = room;
    }
    contacts_keep(w, out, n, k, w->bodies + p, old);
}

static void query_walls(world *w, int k, int old[2])
{
    const body *b = &w->body[k];
    push_run *run = &w->wall[k];
    if (b->four && contacts_may_stay(w, run, k, w->bodies, b->reach)) {
        contacts_stay(w, run, k, w->bodies);
        return;
    }
    int first = w->pushes, dropped = w->report.dropped;
    look_now(w, k);
    for (int p = 0; p < w->planes; p++) query_plane(w, k, p, old);
    real margin = b->reach + 2 * contacts_slack(w, k, w->bodies);
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
            pairs_look_ahead(w, b);
            world_look(w, b);
            w->looked[k] = 1;
        }
        query_walls(w, k, old);
    }
}
//<

//> narrow-find
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
        if (!contacts_may_stay(w, run, k, w->bodies, w->body[k].reach))
            return 0;
        found += run->count;
    }
    for (int k = 0; k < w->pairs; k++) {
        const body_pair *x = &w->pair[k];
        const body *a = &w->body[x->a], *b = &w->body[x->b];
        if (is_quick(a, b)
            || !contacts_may_stay(w, &x->run, x->a, x->b, needed(a, b)))
            return 0;
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

static void find_anew(world *w)
{
    int old[2] = { 0, w->lasting_memories };
    int quick[2] = { 0, w->lasting_memories };
    swap_pushes(w);
    w->contacts = w->pushes = 0;
    query_planes(w, old);
    query_pairs(w, 0, old);
    w->lasting = w->contacts;
    w->lasting_pushes = w->pushes;
    query_pairs(w, 1, quick);
}

void narrow_find(world *w)
{
    if (!all_stay(w)) find_anew(w);
    halves_sort(w);
}
//<
