//> cache-update
//>   An update has six rounds, which the next pieces of code take in turn.
#include "cache.h"
#include "cylinder.h"
#include "seams.h"
#include "table.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

static void follow_lists(contact_cache *c, const cache_frame *f);
static void place_chunk(void *data, int item);
static void decide_chunk(void *data, int item);
static void ask_batch(contact_cache *c, const cache_frame *f, int first);
static void gather_active(contact_cache *c, const cache_frame *f);

// So many pairs are asked at once: many for threads, few for memory.
enum { BATCH = 32 * TASK_CHUNK };

void cache_update(contact_cache *c, const cache_frame *f)
{
    cache_work u = { c, f, 0 };
    c->lost = c->olds = 0;
    c->queries = 0;
    // (Memory for them may have been refused in the last frame.)
    if (f->is_new_list || c->pairs.count != f->list->count + f->list->walls)
        follow_lists(c, f);
    tasks_run(f->run, place_chunk, &u, task_chunks(f->awakes));
    c->updates++;
    tasks_run(f->run, decide_chunk, &u, task_chunks(c->pairs.count));
    for (int k = 0; k < c->pairs.count; k += BATCH) ask_batch(c, f, k);
    seams_correct(c, f);
    gather_active(c, f);
}
//<

//> cache-follow
//>   The list of pairs is sorted, so what is kept goes to its new place in two walks,
//>   without a second list.
static void release_pair(contact_cache *c, cache_pair *p)
{
    if (p->entry < 0) return;
    c->entry[p->entry].next = c->free_entry;
    c->free_entry = p->entry;
    p->entry = -1;
}

// Pairs of two bodies come before those with planes.
static int compare_pairs(const int a[2], const int b[2])
{
    bool is_wall = a[1] < 0;
    if (is_wall != (b[1] < 0)) return is_wall ? 1 : -1;
    if (a[0] != b[0]) return a[0] < b[0] ? -1 : 1;
    int order = (a[1] > b[1]) - (a[1] < b[1]);
    return is_wall ? -order : order;
}

static bool is_pair_of(const cache_pair *p, const int key[2])
{
    return p->key[0] == key[0] && p->key[1] == key[1];
}

static bool grow_list(cache_list *l, int need)
{
    int room = need + need / 8 + 4;
    bool ok = true;
    if (need <= l->capacity) return true;
    TABLE_GROW(ok, l->pair, l->count, room);
    if (ok) l->capacity = room;
    return ok;
}

// What was kept of pairs that are listed no more is let go.
static void drop_unlisted(contact_cache *c, cache_list *l, const pair_list *list)
{
    int count = list->count + list->walls, now = 0, kept = 0;
    for (int k = 0; k < l->count; k++) {
        cache_pair *p = &l->pair[k];
        while (now < count && compare_pairs(list->pair[now], p->key) < 0) now++;
        if (now == count || !is_pair_of(p, list->pair[now])) release_pair(c, p);
        else if (kept++ < k) l->pair[kept - 1] = *p;
    }
    l->count = kept;
}

// The rest moves to its places from the end on, and new pairs come in between.
static void follow_list(contact_cache *c, cache_list *l, const pair_list *list)
{
    drop_unlisted(c, l, list);
    int count = list->count + list->walls, old = l->count - 1;
    if (!grow_list(l, count)) {
        c->lost += count - l->count;
        return;
    }
    l->count = count;
    for (int k = count - 1; k > old; k--) {
        const int *now = list->pair[k];
        bool is_known = old >= 0 && is_pair_of(&l->pair[old], now);
        l->pair[k] = is_known ? l->pair[old--]
                   : (cache_pair){ .key = { now[0], now[1] }, .entry = -1, .was = -1,
                                   .seen = { -1, -1 } };
    }
}

static bool is_of_other(const cache_list *l, int k, const cache_list *other,
                        int j)
{
    return k == l->count || (j < other->count
                             && compare_pairs(other->pair[j].key, l->pair[k].key) < 0);
}

const cache_pair *cache_next(const cache_list *l, int *k,
                             const cache_list *other, int *j)
{
    return is_of_other(l, *k, other, *j) ? &other->pair[(*j)++]
                                         : &l->pair[(*k)++];
}

// Two sorted lists become one, from the end on: what was kept of bodies that lie
// still is there for those that have woken.
static void take_back_pairs(contact_cache *c, cache_list *l, cache_list *still)
{
    int all = l->count + still->count, i = l->count - 1, j = still->count - 1;
    still->count = 0;
    if (!grow_list(l, all)) {
        c->lost += j + 1;
        for (; j >= 0; j--) release_pair(c, &still->pair[j]);
        return;
    }
    l->count = all;
    for (int k = all - 1; j >= 0; k--) {
        bool is_old = i >= 0
                   && compare_pairs(still->pair[j].key, l->pair[i].key) < 0;
        l->pair[k] = is_old ? l->pair[i--] : still->pair[j--];
    }
}

// And pairs of which nothing is loose leave the list, with what is kept of them.
static void set_aside(contact_cache *c, cache_list *l, cache_list *still,
                      const pair_list *list)
{
    int left = 0, aside = 0;
    for (int k = 0; k < l->count; k++)
        aside += pair_is_settled(list, l->pair[k].key);
    if (!grow_list(still, aside)) {
        c->lost += aside;
        return;
    }
    for (int k = 0; k < l->count; k++) {
        cache_pair *p = &l->pair[k];
        bool is_still = pair_is_settled(list, p->key);
        p->is_active &= !is_still;
        *(is_still ? &still->pair[still->count++] : &l->pair[left++]) = *p;
    }
    l->count = left;
}

static void follow_lists(contact_cache *c, const cache_frame *f)
{
    bool is_whole = f->list->is_whole;
    if (is_whole) take_back_pairs(c, &c->pairs, &c->still);
    follow_list(c, &c->pairs, f->list);
    if (is_whole) set_aside(c, &c->pairs, &c->still, f->list);
}
//<

//> cache-decide
//>   A pair is asked again when one of its bodies has been placed again, or may
//>   get further than the answer looked ahead.
// m, how far a body may get from where it was placed, while it counts as there.
static real stay_of(const cache_frame *f, int b)
{
    real radius = f->now[b].radius;
    return f->stay * (f->moves[b] ? cache_width(&f->body[b], radius) : radius);
}

// m, how far from there it may be now.  One that was placed in this very frame
// is exactly there; if it will not stay, nothing of the answer outlives the
// frame, and it need not look further than that.
static real slack_of_body(const contact_cache *c, const cache_frame *f, int b)
{
    bool is_there = c->placing[b].since == c->updates;
    return is_there && f->ahead[b].reach > stay_of(f, b) ? 0 : stay_of(f, b);
}

static real slack_of(const contact_cache *c, const cache_frame *f, int a, int b)
{
    return slack_of_body(c, f, a) + (b < 0 ? 0 : slack_of_body(c, f, b));
}

// m, by how much the gap of a pair may close in this frame, whichever of its bodies
// others stop.  None stops what is driven: what rides on it comes no nearer.
static real pair_reach(const cache_frame *f, int a, int b)
{
    const prediction *x = &f->ahead[a], *y = &f->ahead[b];
    if (b < 0) return x->reach;
    if (f->now[a].is_driven || f->now[b].is_driven)
        return vec3_distance(x->delta, y->delta) + x->turn + y->turn;
    return x->reach + y->reach;
}

// m, by how much a gap may be less than where two bodies were asked: they may have
// gone since they were placed, and what turns was asked as turned by half.
static real beside_of(const contact_cache *c, const cache_frame *f, int a, int b)
{
    return slack_of(c, f, a, b) + (f->ahead[a].arc + f->ahead[b].arc) / 2;
}

// m, how far the bodies of a pair have gone.
static real paths_of(const contact_cache *c, int a, int b)
{
    return c->placing[a].path + (b < 0 ? 0 : c->placing[b].path);
}

// m, for which ways an answer that looked `reach` ahead holds later, too: for
// none if it does not outlive the frame.
static real lasting_margin(const contact_cache *c, const cache_frame *f, int a,
                           int b, real reach)
{
    bool lasts = slack_of_body(c, f, a) > 0
                 && (b < 0 || slack_of_body(c, f, b) > 0);
    return lasts ? reach + slack_of(c, f, a, b) : -1;
}

// Of which placing of body b is an answer; a plane has none.
static int body_number(const contact_cache *c, int b)
{
    return b < 0 ? 0 : c->placing[b].number;
}

static void forget(cache_pair *p)
{
    p->count = 0;
    p->is_merged = p->passes = false;
    p->seen[0] = p->seen[1] = -1;
}

// Is body a of a pair so near to b, or to a plane, that its gap may close?
static bool is_near(const cache_frame *f, int a, int b, real reach)
{
    vec3 at = f->now[a].frame.center;
    real near = f->now[a].radius + reach;
    if (b < 0) {
        plane wall = f->plane[-1 - b];
        return vec3_dot(wall.normal, at) - wall.offset <= near;
    }
    vec3 d = vec3_sub(at, f->now[b].frame.center);
    near = f->now[a].radius + f->now[b].radius + reach;
    return vec3_length_squared(d) <= near * near;
}

// Asks again where a body was placed again, or gets further than it was asked
// for; not if there was a gap between them that they do not close yet.
static void decide(const contact_cache *c, const cache_frame *f, cache_pair *p)
{
    int a = p->key[0], b = p->key[1];
    real reach = pair_reach(f, a, b);
    p->is_asked = false;
    if (!f->moves[a] && (b < 0 || !f->moves[b])) return;
    if (!is_near(f, a, b, reach)) forget(p);
    else p->is_asked = (p->seen[0] != c->placing[a].number
                        || p->seen[1] != body_number(c, b)
                        || !(reach <= p->margin))
                    && !(p->count == 0 && p->near - paths_of(c, a, b) > reach);
}

static void decide_chunk(void *data, int item)
{
    const cache_work *u = data;
    const cache_list *l = &u->c->pairs;
    int end = task_end(item, l->count);
    for (int k = task_first(item); k < end; k++) decide(u->c, u->f, &l->pair[k]);
}
//<

//> cache-place
//>   A body's vertices are *placed*, computed from its frame, only when it has
//>   gone further than `stay` of its radius, or, on fewer than four points, has
//>   turned by a sixth of that.
// m, how far a corner, which has coordinates of up to two, may be from where it
// was when the vertices were placed.  As long as bodies only move, all gaps of a
// contact change alike, and its points stay the deepest.  When a body turns that
// stands on fewer than four, others become so: there a turn counts more.
static const real ON_CORNERS = 6;           // tuned, times

static real far_from(const rigid_frame *was, const rigid_frame *now,
                     bool is_on_corners)
{
    real times = is_on_corners ? 2 * ON_CORNERS : 2, turned = 0;
    for (int i = 0; i < FOUR_AXES; i++) {
        vec3 turn = vec3_sub(now->axis[i], was->axis[i]);
        turned += vec3_length_squared(turn);
    }
    vec3 delta = vec3_sub(now->center, was->center);
    return sqrt(vec3_length_squared(delta) + times * times * turned);
}

// In that update, or after it.
static void place_body(contact_cache *c, const cache_frame *f, int b,
                       unsigned in)
{
    struct placing *p = &c->placing[b];
    const rigid_frame *now = &f->asked[b];
    const body *x = &f->body[b];
    if (!x->rigid || (!f->moves[b] && p->number > 0)) return;
    if (p->number > 0 && far_from(&c->placed[b], now,
                                     p->corners == c->updates)
                         <= stay_of(f, b)) return;
    c->placed[b] = *now;
    p->number++;
    p->since = in;
    rigid4_ride(x->rigid, now, c->vertex + p->first, x->shape->particles);
    p->in_range = hull_in_range((hull){ c->vertex + p->first,
                                        x->shape->particles });
}

static void place_chunk(void *data, int item)
{
    const cache_work *u = data;
    int end = task_end(item, u->f->awakes);
    for (int k = item * TASK_CHUNK; k < end; k++)
        place_body(u->c, u->f, u->f->awake[k], u->c->updates + 1);
}
//<

//> cache-entries
//>   One thread hands out entries for the answers, in the order of the pairs, and takes
//>   those back that have no points: most pairs of a heap are near, and do not touch.
// An entry for whatever is asked: -1 where memory is refused.
static int new_entry(contact_cache *c)
{
    int k = c->free_entry;
    if (k >= 0) {
        c->free_entry = c->entry[k].next;
    } else {
        if (c->entries == c->entry_capacity) {
            int room = c->entry_capacity + c->entry_capacity / 8 + 64;
            bool ok = true;
            TABLE_GROW(ok, c->entry, c->entries, room);
            if (!ok) return -1;
            c->entry_capacity = room;
        }
        k = c->entries++;
    }
    return k;
}

// The one whose motion it has, of body or plane b.
static int whole_body(const cache_frame *f, int b)
{
    return b >= 0 && f->body[b].rides > 0 ? f->body[b].rides - 1 : b;
}

static void make_entry(contact_cache *c, const cache_frame *f, cache_pair *p)
{
    int a = p->key[0], b = p->key[1];
    if (!p->is_asked) return;
    c->queries++;
    if (p->entry < 0) p->entry = new_entry(c);
    if (p->entry >= 0) {
        contact *now = &c->entry[p->entry].contact;
        now->found = ++c->found;
        now->piece_a = a;
        now->piece_b = b;
        now->a = f->has_pieces ? whole_body(f, a) : a;
        now->b = f->has_pieces ? whole_body(f, b) : b;
    } else {
        p->is_asked = false;
        c->lost++;
    }
}

// Seams that find a contact on a floor again ask what it was: there is room for that.
static void make_old(contact_cache *c, const cache_frame *f, cache_pair *p)
{
    p->was = -1;
    if (seams_is_on_floor(f, p) && TABLE_ADD(c->was, c->olds, c->was_capacity))
        p->was = c->olds++;
}

static void make_entries(contact_cache *c, const cache_frame *f, int first, int end)
{
    for (int k = first; k < end; k++) {
        make_old(c, f, &c->pairs.pair[k]);
        make_entry(c, f, &c->pairs.pair[k]);
    }
}

// What has no points needs no entry, unless seams still ask what it was.
static void give_back_entries(contact_cache *c, int first, int end)
{
    for (int k = first; k < end; k++) {
        cache_pair *p = &c->pairs.pair[k];
        if (p->count == 0 && !p->passes && !p->is_merged && p->was < 0)
            release_pair(c, p);
    }
}
//<

//> cache-query
//>   Slow bodies are asked where they touch (chapters 10 and 11), fast ones
//>   when they first touch (chapter 15).
// Bodies that fly past each other by more than the smaller one's inner radius in a
// frame, or that turn past each other by more than both of them, may be lost to each
// other: they are asked when they first touch.
static bool flies(const cache_frame *f, int a, int b)
{
    real far = vec3_distance(f->ahead[a].delta, f->ahead[b].delta);
    return far > fmin(f->body[a].inner, f->body[b].inner);
}

// (What turns by half a turn and more is asked where it is.)
static const real HALF_TURN = 3;                 // rad

static real turned_arc(const cache_frame *f, int b)
{
    return f->ahead[b].angle < HALF_TURN ? f->ahead[b].arc : 0;
}

static bool turns(const cache_frame *f, int a, int b)
{
    real far = vec3_distance(f->ahead[a].delta, f->ahead[b].delta)
             + turned_arc(f, a) + turned_arc(f, b);
    return far > f->body[a].inner + f->body[b].inner;
}

// How it goes, and what it may go beside that (m), which is added to *apart.  What
// turns by half a turn and more is asked as if it went straight.
static swept_motion motion_ahead(const cache_frame *f, int b, real *apart)
{
    const prediction *p = &f->ahead[b];
    bool turns = p->angle > 0 && p->angle < HALF_TURN;
    *apart += turns ? p->turn - p->arc : p->turn;
    return (swept_motion){
        .center = f->now[b].frame.center, .delta = p->delta,
        .turn = turns ? p->spin : (vec3){ 0, 0, 0 },
        .out = turns ? p->arc / real_min(p->angle, 2) : 0 };
}

// As it stands now, in room of its own.
static collider standing_body(const cache_frame *f, int b, vec3 *at)
{
    const body *x = &f->body[b];
    rigid4_ride(x->rigid, &f->now[b].frame, at, x->shape->particles);
    return (collider){ x->shape, at, false };
}

static swept_status query_swept(contact *c, const cache_frame *f)
{
    enum { ROOM = 256 };
    vec3 room[ROOM], *scratch = room;
    int first = f->body[c->piece_a].shape->particles;
    int both = first + f->body[c->piece_b].shape->particles;
    manifold m;
    if (2 * both > ROOM) scratch = malloc(2 * (size_t)both * sizeof *scratch);
    if (!scratch) return SWEPT_CAPPED;
    collider a = standing_body(f, c->piece_a, scratch);
    collider b = standing_body(f, c->piece_b, scratch + first);
    real apart = 0;
    swept_motion of_a = motion_ahead(f, c->piece_a, &apart);
    swept_motion of_b = motion_ahead(f, c->piece_b, &apart);
    swept_status s = collide_swept(&a, &of_a, &b, &of_b, apart, scratch + both,
                                   &m);
    if (scratch != room) free(scratch);
    if (s == SWEPT_TOUCHES) cache_take(c, &m, f, true);
    return s;
}
//<

//> cache-closing
// m, by how much the gap along the normal may close in this frame: as far as
// the centres approach along it, and as far as vertices go beside that.
static real closing_of(const cache_frame *f, const contact *c, vec3 normal)
{
    const prediction *a = &f->ahead[c->piece_a], *b = &f->ahead[c->piece_b];
    real closing = -vec3_dot(vec3_sub(a->delta, b->delta), normal);
    return real_max(closing, 0) + a->turn + b->turn;
}

// The manifold of two bodies that may come to touch; what has `margin` (m) more
// between it than closes has none.  *closes becomes what they were asked for.
static manifold find_touch(const cache_frame *f, const contact *c,
                           const collider *a, const collider *b, real margin,
                           query_cache *carried, real *closes)
{
    real turn = f->ahead[c->piece_a].angle + f->ahead[c->piece_b].angle;
    query_result r = query_nearest(a, b, *closes + margin, carried);
    manifold none = { .count = 0, .point = { r.at } };
    if (!r.near) return none;
    *closes = real_min(closing_of(f, c, r.normal), *closes);
    if (r.at.gap > *closes + margin) return none;
    return manifold_find(a, b, &r, *closes + margin, turn);
}
//<

//> cache-ahead
// The normal of balls and capsules turns as they pass each other.  So they are asked
// as they will stand when they touch: the one that is round is shifted, as seen from
// the other, by the part of its way that closes the gap along the normal; and again,
// for there the normal is another.  On a floor, one that does not touch in the frame
// is asked as it will stand at the end: a ball that comes to a crease sees the edge
// ahead of it, along a normal that leans back; and so does a cylinder that slides or
// rolls there.  Returns whether one was shifted.
static const real GLIDES = 0.02;            // tuned, radii: less does not count

enum { MOST_ROUND = 2 + 2 * CYLINDER_SIDES };

static bool is_asked_ahead(const shape *s, bool slides)
{
    return s->rim > 0 ? slides : s->round > 0 && s->particles <= 2;
}

static bool query_ahead(const cache_frame *f, const contact *c, collider a,
                        collider b, real margin, query_cache *carried,
                        real *closes, manifold *m)
{
    int slider = seams_slider(f, c->piece_a, c->piece_b);
    bool is_a = is_asked_ahead(a.shape, slider == c->piece_a);
    collider *round = is_a ? &a : &b;
    vec3 delta = vec3_sub(f->ahead[c->piece_a].delta, f->ahead[c->piece_b].delta);
    vec3 at[MOST_ROUND];
    real least = GLIDES * (round->shape->round + round->shape->rim);
    real gone = 0, turn = f->ahead[c->piece_a].angle + f->ahead[c->piece_b].angle;
    const vec3 *now = round->at;
    if (!is_a && !is_asked_ahead(b.shape, slider == c->piece_b)) {
        *m = find_touch(f, c, &a, &b, margin, carried, closes);
        return false;
    }
    round->at = at;
    round->in_range = false;
    for (int k = 0; ; k++) {
        for (int v = 0; v < round->shape->particles; v++)
            at[v] = vec3_add_scaled(now[v], is_a ? gone : -gone, delta);
        if (k == CONTACT_ROUNDS || !(vec3_length(delta) > least)) break;
        query_result r = query_nearest(&a, &b, HUGE_VAL, carried);
        real closing = -vec3_dot(delta, r.normal);
        real touches = gone + r.at.gap / closing;
        if (!(r.at.gap > 0) || !(closing > 0) || gone == 1
            || (touches >= 1 && slider < 0)) break;
        gone = real_min(touches, 1);
    }
    *m = collide_rigid(&a, &b, *closes + margin, turn, carried);
    return gone > 0;
}
//<

//> cache-pair
//>   The answer goes into its entry, and inherits the impulses of the last one.
// The answer of now, for which bodies were looked `reach` (m) ahead.
static void date(const contact_cache *c, const cache_frame *f, cache_pair *p,
                 int a, int b, real reach)
{
    p->seen[0] = c->placing[a].number;
    p->seen[1] = body_number(c, b);
    p->margin = lasting_margin(c, f, a, b, reach);
}

static void query_bodies(contact_cache *c, const cache_frame *f, cache_pair *p,
                         contact *now)
{
    int a = now->piece_a, b = now->piece_b;
    collider x = cache_collider(c, f, a), y = cache_collider(c, f, b);
    swept_status swept = SWEPT_OVERLAP;
    now->count = 0;
    now->is_ahead = now->is_floor = false;
    // (What was out of reach is as if it had not been listed.)
    if (p->seen[0] < 0) p->carried.count = 0;
    p->seen[0] = p->seen[1] = -1;
    bool may_pass = flies(f, a, b);
    if (may_pass || turns(f, a, b)) swept = query_swept(now, f);
    p->passes = may_pass && swept == SWEPT_PASSES;
    if (swept == SWEPT_TOUCHES || p->passes) return;
    real slack = slack_of(c, f, a, b), reach = pair_reach(f, a, b);
    manifold m;
    bool is_ahead = query_ahead(f, now, x, y, 2 * slack, &p->carried, &reach,
                                &m);
    cache_take(now, &m, f, is_ahead);
    date(c, f, p, a, b, reach);
    if (m.count == 0 && !is_ahead)
        p->near = m.point[0].gap - beside_of(c, f, a, b) + paths_of(c, a, b);
}

// A plane needs no search: it is a face below the lowest vertex.
static void query_plane_pair(contact_cache *c, const cache_frame *f, cache_pair *p,
                             contact *now)
{
    int a = now->piece_a;
    plane wall = f->plane[-1 - now->piece_b];
    collider x = cache_collider(c, f, a);
    real slack = slack_of(c, f, a, -1), reach = pair_reach(f, a, -1);
    manifold m = manifold_on_plane(&x, wall.normal, wall.offset,
                                   reach + 2 * slack, f->ahead[a].angle);
    cache_take(now, &m, f, false);
    date(c, f, p, a, -1, reach);
}

static void query_pair(contact_cache *c, const cache_frame *f, cache_pair *p)
{
    contact own, *now = &c->entry[p->entry].contact;
    contact *was = p->was >= 0 ? &c->was[p->was] : &own;
    bool bequeaths = p->count > 0;
    if (bequeaths) *was = *now;
    p->near = -HUGE_VAL;
    if (now->piece_b < 0) query_plane_pair(c, f, p, now);
    else                  query_bodies(c, f, p, now);
    p->count = (signed char)now->count;
    p->is_merged = false;
    if (bequeaths) contact_inherit(now, was);
    else           contact_clear(now);
}
//<

//> cache-near
//>   Can a contact push in this frame at all? The solver notes the least gap
//>   that it has seen, and each body how far it has gone since. The gap can
//>   have shrunk by no more than the sum of both: one subtraction, and in a
//>   falling heap it spares most contacts.
// A contact whose gap cannot close in this frame is left out: both bodies
// together have not gone as far yet.
static void activate_pair(const contact_cache *c, const cache_frame *f,
                          cache_pair *p)
{
    int a = p->key[0], b = p->key[1];
    p->is_active = false;
    if ((p->count == 0 && !p->passes) || p->entry < 0) return;
    if (!f->moves[a] && (b < 0 || !f->moves[b])) return;
    real paths = paths_of(c, a, b);
    if (p->near - paths > pair_reach(f, a, b)) return;
    p->near = paths;
    p->is_active = true;
}
//<

//> cache-query-all
//>   All threads ask. None writes where another reads.
static void query_chunk(void *data, int item)
{
    const cache_work *u = data;
    const cache_list *l = &u->c->pairs;
    int first = u->first + task_first(item);
    int end = int_min(first + TASK_CHUNK, l->count);
    for (int k = first; k < end; k++) {
        cache_pair *p = &l->pair[k];
        if (k + 1 < end && p[1].is_asked)
            contact_expect(&u->c->entry[p[1].entry].contact);
        if (p->is_asked) query_pair(u->c, u->f, p);
        activate_pair(u->c, u->f, p);
    }
}

static void ask_batch(contact_cache *c, const cache_frame *f, int first)
{
    cache_work u = { c, f, first };
    int end = int_min(first + BATCH, c->pairs.count);
    make_entries(c, f, first, end);
    tasks_run(f->run, query_chunk, &u, task_chunks(end - first));
    give_back_entries(c, first, end);
}
//<

//> cache-active
//>   The others are gathered in the order of the pairs.
static void gather_pair(contact_cache *c, const cache_frame *f, cache_pair *p)
{
    if (!p->is_active) return;
    contact *now = &c->entry[p->entry].contact;
    if (p->count < CONTACT_POINTS && contact_load(now) > 0) {
        c->placing[now->piece_a].corners = c->updates;
        if (now->piece_b >= 0) c->placing[now->piece_b].corners = c->updates;
    }
    c->passing += p->passes;
    c->fast += p->count > 0 && p->seen[0] < 0 && now->b >= 0
             && flies(f, now->piece_a, now->piece_b);
    c->reach[c->actives] = pair_reach(f, now->piece_a, now->piece_b);
    c->active[c->actives] = now;
    c->of[c->actives++] = p;
}

static bool grow_active(contact_cache *c, int need)
{
    int of = c->active_capacity, reach = of;
    return TABLE_RENEW(c->of, of, need) && TABLE_RENEW(c->reach, reach, need)
        && TABLE_RENEW(c->active, c->active_capacity, need);
}

static void gather_active(contact_cache *c, const cache_frame *f)
{
    c->actives = c->fast = c->passing = 0;
    if (!grow_active(c, c->entries)) {
        c->lost += c->entries;
        return;
    }
    for (int k = 0; k < c->pairs.count; k++) gather_pair(c, f, &c->pairs.pair[k]);
}

// Within a frame what was to meet on one side of a body meets on no other: if it is
// through, or past, by turning since it was asked, it comes back.  What stands on
// something fixed, and turns there, does not meet the side of a neighbouring piece:
// the seams are looked at between frames only (seams.h).
static bool is_through(const cache_frame *f, const contact *now, const contact *was)
{
    real along = vec3_dot(now->normal, was->normal);
    bool lies = !f->moves[was->piece_a] || !f->moves[was->piece_b];
    return (was->is_ahead && (now->count == 0 || along < 0))
        || (lies && was->count > 0 && now->count > 0 && along < CONTACT_SAME);
}

// A floor of pieces is a plane until the frame ends: one piece alone has edges that
// the floor has not.  So points that lie on one stay as they are.
static void query_again(contact_cache *c, const cache_frame *f, cache_pair *p)
{
    if (c->entry[p->entry].contact.is_floor) p->near = -HUGE_VAL;
    else query_pair(c, f, p);
}

void cache_again(contact_cache *c, const cache_frame *f, int k)
{
    cache_pair *p = c->of[k];
    const contact was = *c->active[k];
    int a = was.piece_a, b = was.piece_b;
    place_body(c, f, a, c->updates);
    if (b >= 0) place_body(c, f, b, c->updates);
    p->is_asked = true;
    make_entry(c, f, p);
    query_again(c, f, p);
    if (b >= 0 && is_through(f, c->active[k], &was)) {
        *c->active[k] = was;
        p->count = (signed char)was.count;
        p->seen[0] = -1;                    // it is kept for this frame only
    }
    c->reach[k] = pair_reach(f, a, b);
}

void cache_note(contact_cache *c, const contact_solver *s)
{
    for (int k = 0; k < s->contacts; k++)
        if (c->of[k]->count > 0) c->of[k]->near += s->active[k].least;
}

void cache_moved(contact_cache *c, int b, real delta)
{
    c->placing[b].path += delta;
}
//<

//> cache-init
//>   Memory for contacts, made and given back.
static bool make_cache_room(contact_cache *c, int bodies, int vertices)
{
    int room = table_room(bodies, c->room);
    int vertex_room = table_room(vertices, c->vertex_room);
    bool ok = true;
    if (room > c->room) {
        TABLE_GROW(ok, c->placed, c->room, room);
        TABLE_GROW(ok, c->placing, c->room, room);
        TABLE_GROW(ok, c->first, 0, room);
        TABLE_GROW(ok, c->last, 0, room);
        if (ok) c->room = room;
    }
    if (ok && vertex_room > c->vertex_room) {
        TABLE_GROW(ok, c->vertex, c->vertices, vertex_room);
        if (ok) c->vertex_room = vertex_room;
    }
    return ok;
}

bool cache_add(contact_cache *c, int b, int vertices)
{
    bool has_room = b < c->room && vertices <= c->placing[b].vertices;
    int more = has_room ? 0 : vertices;
    if (!make_cache_room(c, b + 1, c->vertices + more)) return false;
    struct placing *p = &c->placing[b];
    *p = has_room ? (struct placing){ .first = p->first, .vertices = p->vertices }
                  : (struct placing){ .first = c->vertices, .vertices = vertices };
    c->vertices += more;
    return true;
}

void cache_free(contact_cache *c)
{
    cache_list *list[] = { &c->pairs, &c->still };
    for (int k = 0; k < 2; k++) free(list[k]->pair);
#define FREE(table, kept, room) free(c->table);
    CACHE_TABLES(FREE, FREE, c)
#undef FREE
    *c = (contact_cache){ .free_entry = -1 };
}
//<

//> cache-forget
//>   What a body leaves behind is forgotten with it.
static void drop_kept(contact_cache *c, cache_pair *p)
{
    if (p->entry >= 0) c->entry[p->entry].contact.count = 0;
    release_pair(c, p);
    forget(p);
    p->near = -HUGE_VAL;
}

// Drops what is kept of bodies that are not placed, and of a plane, if `wall` is one
// (contact_with_plane); 0: of none.
static void clear_kept(contact_cache *c, cache_list *l, int wall)
{
    for (int k = 0; k < l->count; k++) {
        cache_pair *p = &l->pair[k];
        int a = p->key[0], b = p->key[1];
        if (c->placing[a].number == 0 || b == wall
            || (b >= 0 && c->placing[b].number == 0)) drop_kept(c, p);
    }
}

void cache_forget(contact_cache *c, const int *b, int n)
{
    for (int k = 0; k < n; k++) c->placing[b[k]].number = 0;
    clear_kept(c, &c->pairs, 0);
    clear_kept(c, &c->still, 0);
}

void cache_forget_plane(contact_cache *c, int wall)
{
    clear_kept(c, &c->pairs, contact_with_plane(wall));
    clear_kept(c, &c->still, contact_with_plane(wall));
}
//<
