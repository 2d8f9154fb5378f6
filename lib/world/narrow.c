//> narrow-asking
#include "narrow.h"
#include "contacts.h"
#include "halves.h"
#include "pairs.h"

// What is asked: once a frame everything, and then, in some substeps again, the
// quick pairs.
typedef struct {
    world *w;
    int again;
} asking;

// Body or pair number k is this half's.  In turns, by so many: those that have
// much to do stand together, for they were thrown together.
enum { TURN = 16 };

static int is_mine(int k, int half)
{
    return k / TURN % 2 == half;
}

// How many of n are the first half's.
static int firsts_of(int n)
{
    int rest = n % (2 * TURN);
    return n / (2 * TURN) * TURN + (rest < TURN ? rest : TURN);
}
//<

//> narrow-quick
// By more than a tenth of a radius in a frame?
static int is_quick(const body *a, const body *b)
{
    real far = vec3_distance(a->way, b->way) + a->turn + b->turn;
    return far > 0.1 * fmin(a->plan->radius, b->plan->radius);
}

// Every so many substeps what the quick pairs touch now replaces what they
// touched, and takes over what that pushed.  In 1/120 s a body that spins comes
// to touch with another corner, and sinks: of four substeps every second one is
// not enough.
static int quick_every(const world *w)
{
    return w->report.substeps > 4 ? 2 : 1;
}

// For how much of the frame are the contacts of this pair asked for?
static real share_of(const asking *j, const body_pair *pair)
{
    const world *w = j->w;
    const body *a = &w->body[pair->a], *b = &w->body[pair->b];
    if (!pair->quick || (!j->again && pairs_pass_far(a, b, 1))) return 1;
    return (real)quick_every(w) / w->report.substeps;
}
//<

//> narrow-decide
// m, so near that they may touch within a share of the frame.
static real needed(const body *a, const body *b, real share)
{
    return share * (a->reach + b->reach) + a->thickness + b->thickness;
}

// m, how much further than that it is asked, so that the answer is good for
// some frames.
static real slack_of(const world *w, const body_pair *pair)
{
    return pair->quick ? 0 : 2 * contacts_slack(w, pair->a, pair->b);
}

// Are the balls around two bodies, now, further apart than the margin?
static int balls_are_apart(const world *w, body *a, body *b, real margin)
{
    sphere x = pairs_ball(w, a), y = pairs_ball(w, b);
    real near = x.radius + y.radius + margin;
    return vec3_length_squared(vec3_sub(x.center, y.center)) > near * near;
}

static int choose(const asking *j, const body_pair *pair)
{
    const world *w = j->w;
    body *a = &w->body[pair->a], *b = &w->body[pair->b];
    real share = share_of(j, pair);
    if (!pair->quick && contacts_may_stay(w, &pair->is.run, pair->a, pair->b,
                                          needed(a, b, 1))) return ASK_STAYS;
    if (pairs_pass_far(a, b, share)) return ASK_SWEPT;
    if (balls_are_apart(w, a, b, needed(a, b, share) + slack_of(w, pair)))
        return ASK_NOTHING;
    return ASK_NEAREST;
}

static void decide_pair(const asking *j, body_pair *pair)
{
    const world *w = j->w;
    const body *a = &w->body[pair->a], *b = &w->body[pair->b];
    if (!j->again) pair->quick = is_quick(a, b);
    pair->is.was = pair->is.run;
    pair->is.found = pair->is.guard = 0;
    pair->is.ask = choose(j, pair);
    pair->is.margin = needed(a, b, 1) + slack_of(w, pair);
}

static void decide_planes(world *w, int k)
{
    inquiry *is = &w->narrow.wall[k].is;
    body *b = &w->body[k];
    is->was = is->run;
    is->found = 0;
    is->ask = ASK_NOTHING;
    is->margin = b->reach + 2 * contacts_slack(w, k, w->bodies);
    if (!w->flags.moves[k] || w->planes == 0 || body_is_soft(b)) return;
    is->ask = contacts_may_stay(w, &is->run, k, w->bodies, b->reach)
            ? ASK_STAYS : ASK_NEAREST;
}

// Who is asked what, and who must be looked at for it.
static void decide(void *data, int half)
{
    const asking *j = data;
    world *w = j->w;
    char *needs = w->narrow.needed[half];
    for (int b = 0; b < w->bodies; b++) needs[b] = 0;
    for (int k = 0; k < w->bodies && !j->again; k++) {
        if (!is_mine(k, half)) continue;
        decide_planes(w, k);
        if (w->narrow.wall[k].is.ask == ASK_NEAREST) needs[k] = 1;
    }
    for (int k = 0; k < w->pairs.count; k++) {
        body_pair *pair = &w->pairs.at[k];
        if (!is_mine(k, half)) continue;
        if (!j->again) decide_pair(j, pair);
        if (j->again ? !pair->quick : pair->is.ask < ASK_NEAREST) continue;
        needs[pair->a] = needs[pair->b] = 1;
    }
}
//<

//> narrow-look
// Blows may have turned its way; how far others may push it stays.
static void look_ahead_again(const world *w, body *b)
{
    real reach = b->reach;
    pairs_look_ahead(w, b);
    b->reach = reach;
}

static void look(void *data, int half)
{
    const asking *j = data;
    world *w = j->w;
    for (int k = 0; k < w->bodies; k++) {
        int is_needed = w->narrow.needed[0][k] || w->narrow.needed[1][k];
        if (!is_mine(k, half) || !is_needed || w->flags.looked[k]) continue;
        if (j->again) look_ahead_again(w, &w->body[k]);
        world_look(w, &w->body[k]);
        w->flags.looked[k] = 1;
    }
}
//<

//> narrow-swept
// How many contacts they have then, 0 or 1; -1: they cannot be told apart, and
// are looked at where they are.
static int query_swept(const world *w, const body *a, const body *b, real share,
                       int half, contact_point *c)
{
    if (body_is_nailed(a) && body_is_nailed(b)) return 0;
    if (body_is_nailed(a)) return query_swept(w, b, a, share, half, c);
    pooled pa = world_collider(w, a), pb = world_collider(w, b);
    collider ca = { a->plan, pa.at }, cb = { b->plan, pb.at };
    vec3 way = vec3_scale(share, vec3_sub(a->way, b->way));
    real apart = a->thickness + b->thickness;
    manifold m;
    switch (collide_swept(&ca, &cb, way, apart + share * (a->turn + b->turn),
                          w->narrow.swept[half], &m)) {
    case SWEPT_PASSES:  return 0;
    case SWEPT_TOUCHES: return contacts_of_manifold(&m, &pa, &pb, c);
    default:            return -1;
    }
}
//<

//> narrow-query
static int query_touches(const world *w, body_pair *pair, real margin,
                         contact_point found[PAIR_CONTACTS])
{
    const body *a = &w->body[pair->a], *b = &w->body[pair->b];
    if (body_is_nailed(a)) a = b, b = &w->body[pair->a];
    if (body_is_nailed(a)) return 0;
    pooled pa = world_collider(w, a), pb = world_collider(w, b);
    collider ca = { a->plan, pa.at }, cb = { b->plan, pb.at };
    manifold m = collide_rigid(&ca, &cb, margin,
                               &w->pairs.carried[pair - w->pairs.at]);
    return contacts_of_manifold(&m, &pa, &pb, found);
}

static void query_pair(const asking *j, body_pair *pair, int half)
{
    const world *w = j->w;
    const body *a = &w->body[pair->a], *b = &w->body[pair->b];
    contact_point *found = contacts_of_pair(w, pair);
    int n = -1, is_swept = pair->is.ask == ASK_SWEPT;
    real share = share_of(j, pair);
    if (is_swept) n = query_swept(w, a, b, share, half, found);
    if (n < 0)
        n = query_touches(w, pair, needed(a, b, share) + slack_of(w, pair),
                          found);
    for (int k = 0; k < n; k++)
        found[k].thickness = a->thickness + b->thickness;
    pair->is.found = n;
    pair->is.guard = is_swept && n > 0
                     && contacts_have_guard(w, pair->a, pair->b);
}

// Every particle or vertex of body k against the planes.
static void query_planes(world *w, int k)
{
    const body *b = &w->body[k];
    body_wall *wall = &w->narrow.wall[k];
    pooled c = world_collider(w, b);
    contact_point *found = contacts_of_planes(w, k);
    int n = 0;
    for (int p = 0; p < w->planes; p++) {
        wall->at[p] = collide_plane(&c, w->plane[p], wall->is.margin,
                                    b->thickness, found + n,
                                    b->plan->particles);
        n += wall->at[p];
    }
    wall->is.found = n;
}

// What a half finds stands one after the other: most pairs touch in one point,
// and with room for PAIR_CONTACTS each they would fill much more memory.
static void query(void *data, int half)
{
    const asking *j = data;
    world *w = j->w;
    int place = half ? PAIR_CONTACTS * firsts_of(w->pairs.count) : 0;
    for (int k = 0; k < w->bodies && !j->again; k++)
        if (is_mine(k, half) && w->narrow.wall[k].is.ask == ASK_NEAREST)
            query_planes(w, k);
    for (int k = 0; k < w->pairs.count; k++) {
        body_pair *pair = &w->pairs.at[k];
        if (!is_mine(k, half) || (j->again && !pair->quick)) continue;
        if (j->again) decide_pair(j, pair);
        pair->place = place;
        if (pair->is.ask >= ASK_NEAREST) query_pair(j, pair, half);
        place += pair->is.found;
    }
}
//<

//> narrow-ask
static void write(void *data, int half)
{
    const asking *j = data;
    world *w = j->w;
    for (int k = 0; k < w->bodies && !j->again; k++)
        if (is_mine(k, half)) contacts_write_planes(w, k);
    for (int k = 0; k < w->pairs.count; k++)
        if (is_mine(k, half) && (!j->again || w->pairs.at[k].quick))
            contacts_write_pair(w, &w->pairs.at[k]);
}

static void ask_all(world *w, int again)
{
    asking j = { w, again };
    halves_do(w, decide, &j);
    halves_do(w, look, &j);
    halves_do(w, query, &j);
    contacts_place(w, again);
    halves_do(w, write, &j);
    halves_sort(w);
}
//<

//> narrow-find
// Are all contacts of the last frame those of this one?  Then they are left
// where they are.
static int all_stay(const world *w)
{
    int found = 0;
    if (w->age != w->options.dt / w->report.substeps || !w->options.memory
        || w->pushes.count > w->pushes.lasting || w->softs > 0)
        return 0;
    for (int k = 0; k < w->bodies; k++) {
        const contact_run *run = &w->narrow.wall[k].is.run;
        if (!w->flags.moves[k]) continue;
        if (!contacts_may_stay(w, run, k, w->bodies, w->body[k].reach))
            return 0;
        found += run->count;
    }
    for (int k = 0; k < w->pairs.count; k++) {
        const body_pair *x = &w->pairs.at[k];
        const body *a = &w->body[x->a], *b = &w->body[x->b];
        if (is_quick(a, b) || !contacts_may_stay(w, &x->is.run, x->a, x->b,
                                                 needed(a, b, 1)))
            return 0;
        found += x->is.run.count;
    }
    return found == w->pushes.count;
}

static void swap_pushes(push_tables *t)
{
    push *x = t->at;
    int (*of)[2] = t->between;
    t->at = t->old;
    t->between = t->old_between;
    t->old = x;
    t->old_between = of;
}

void narrow_find(world *w)
{
    if (all_stay(w)) {
        halves_sort(w);
        return;
    }
    swap_pushes(&w->pushes);
    ask_all(w, 0);
}
//<

//> narrow-again
static int some_are_quick(const world *w)
{
    for (int k = 0; k < w->pairs.count; k++)
        if (w->pairs.at[k].quick) return 1;
    return 0;
}

// What they have pushed, where that of the last frame stood, which nobody needs
// any more.
static void keep_quick(push_tables *t)
{
    for (int k = t->lasting; k < t->count; k++) {
        t->old_between[k][1] = t->between[k][1];
        if (t->at[k].pushed[NORMAL] > 0) t->old[k] = t->at[k];
        else                             t->old[k].pushed[NORMAL] = 0;
    }
}

void narrow_find_again(world *w, int substep)
{
    if (substep % quick_every(w) != 0) return;
    if (!some_are_quick(w)) return;
    keep_quick(&w->pushes);
    for (int b = 0; b < w->bodies; b++) w->flags.looked[b] = !w->flags.moves[b];
    ask_all(w, 1);
}
//<
