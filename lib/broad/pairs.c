//> pairs-left
//>   Who has left its larger ball? That takes one distance a body. The comparison
//>   is again written with a *not*, so that a body at NaN is asked again.
#include "pairs.h"
#include "contact.h"
#include "table.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

static bool has_left(const pair_list *l, const pair_query *q, int b)
{
    const sphere *was = &l->listed[b];
    real room = was->radius - q->ball[b].radius - q->reach[b];
    vec3 delta = vec3_sub(q->ball[b].center, was->center);
    if (!q->moves[b] || q->ball[b].radius < 0) return false;
    return !(room >= 0 && vec3_length_squared(delta) <= room * room);
}

// Where as many have been asked again as there are bodies, the boxes around them
// are large, and so are the balls of what was fast: all that moves is asked again.
static void find_left(pair_list *l, const pair_query *q)
{
    bool is_worn = l->asked > l->bodies;
    l->is_whole |= is_worn;
    if (is_worn) l->asked = 0;
    for (int k = 0; k < q->awakes; k++) {
        int b = q->awake[k];
        if (l->is_new[b] || !(is_worn || has_left(l, q, b))) continue;
        l->is_new[b] = l->has_new = true;
        l->asked += !is_worn;
    }
}
//<

//> pairs-loosen
//>   What has woken joins the sorted list of loose bodies.
// What has come is loose, too.
static void loosen(pair_list *l, const pair_query *q)
{
    int was = l->looses, both = was, at = 0;
    for (int k = 0; k < q->awakes; k++) {
        while (at < was && l->loose[at] < q->awake[k]) at++;
        both += at == was || l->loose[at] != q->awake[k];
    }
    l->looses = both;
    for (int k = q->awakes - 1, i = was - 1; both > 0;) {
        int a = k >= 0 ? q->awake[k] : -1, b = i >= 0 ? l->loose[i] : -1;
        l->loose[--both] = int_max(a, b);
        k -= a >= b;
        i -= b >= a;
    }
}
//<

//> pairs-enlarge
// A tenth of its radius, and once more what it may move: wide enough that the
// list holds for some frames, narrow enough that it is short.
static const real WIDER = 0.1;              // tuned, radii
static const real MOVES = 2;                // tuned, moves

static void enlarge(pair_list *l, const pair_query *q, int b)
{
    l->listed[b] = q->ball[b];
    if (q->ball[b].radius < 0) return;
    l->listed[b].radius += WIDER * q->ball[b].radius + MOVES * q->reach[b];
}
//<

//> pairs-lists
//>   All pairs, or only those of the bodies that are asked again.
// Are all pairs to be found again?  Where more than half of what is loose has
// come to lie still, that pays, however many bodies there are.
static bool is_unsettled(const pair_list *l, const pair_query *q)
{
    bool is = l->is_due || l->lists == 0 || l->is_cut
           || 2 * (long)q->awakes < l->looses;
    for (int k = 0; k < q->awakes && !is; k++) is = l->is_settled[q->awake[k]];
    return is;
}

// What is awake is loose.
static void settle_listed(pair_list *l, const pair_query *q)
{
    for (int b = 0; b < l->bodies; b++) l->is_settled[b] = true;
    for (int k = 0; k < q->awakes; k++) {
        l->loose[k] = q->awake[k];
        l->is_settled[q->awake[k]] = false;
    }
    l->looses = q->awakes;
}

// Which planes is each ball near?  Returns how many, stored or not.
static int find_plane_pairs(pair_list *l, const pair_query *q)
{
    int n = 0, bodies = l->is_whole ? l->bodies : l->looses;
    for (int i = 0; i < bodies; i++) {
        int b = l->is_whole ? i : l->loose[i];
        sphere ball = l->listed[b];
        if (!q->moves[b] || ball.radius < 0) continue;
        for (int k = 0; k < q->planes; k++) {
            real height = vec3_dot(q->plane[k].normal, ball.center)
                        - q->plane[k].offset;
            if (height > ball.radius) continue;
            if (l->count + n < l->capacity) {
                l->pair[l->count + n][0] = b;
                l->pair[l->count + n][1] = contact_with_plane(k);
            }
            n++;
        }
    }
    return n;
}

// Makes room for so many pairs, and half as many more, if there is too little.
// Returns whether there is more than before.
static bool grow_pairs(pair_list *l, int need)
{
    int room = need + need / 2;
    bool ok = true;
    if (need <= l->capacity) return false;
    TABLE_GROW(ok, l->pair, l->count, room);
    if (ok) l->capacity = room;
    return ok;
}

static void list_plane_pairs(pair_list *l, const pair_query *q, int *lost)
{
    int walls = find_plane_pairs(l, q);
    if (grow_pairs(l, l->count + walls)) find_plane_pairs(l, q);
    l->walls = int_min(walls, l->capacity - l->count);
    *lost += walls - l->walls;
    l->is_cut = *lost > 0;
    l->has_new = false;
    l->lists++;
}

static void list_all(pair_list *l, const pair_query *q, int *lost)
{
    int n = broad_pairs(&l->broad, l->listed, q->moves, l->pair, l->capacity);
    if (n > l->capacity && TABLE_RENEW(l->pair, l->capacity, n))
        n = broad_pairs(&l->broad, l->listed, q->moves, l->pair, l->capacity);
    // Where memory is refused, looking at every pair finds them in order, so that
    // it keeps the first.
    if (n > l->capacity)
        broad_pairs_all(l->listed, q->moves, l->bodies, l->pair, l->capacity);
    l->count = int_min(n, l->capacity);
    *lost = n - l->count;
    list_plane_pairs(l, q, lost);
    settle_listed(l, q);
    l->is_due = false;
}

// The pairs of those that are asked again, in l->fresh.
static int find_fresh(pair_list *l, const pair_query *q)
{
    int n = 0;
    for (int k = 0; k < l->looses; k++)
        if (l->is_new[l->loose[k]])
            n = broad_near(&l->broad, l->listed, q->moves, l->is_new,
                           l->loose[k], l->fresh, l->fresh_capacity, n);
    return n;
}

static bool is_still_good(const void *list, const int pair[2])
{
    const pair_list *l = list;
    return !l->is_new[pair[0]] && !l->is_new[pair[1]];
}

// Two sorted lists become one, from the end on.
static void merge(pair_list *l, int fresh)
{
    int i = l->count - 1, j = fresh - 1;
    l->count += fresh;
    for (int k = l->count - 1; j >= 0; k--) {
        bool is_old = i >= 0 && broad_is_before(l->fresh[j], l->pair[i]);
        memcpy(l->pair[k], is_old ? l->pair[i--] : l->fresh[j--],
               sizeof l->pair[k]);
    }
}

// Those of the bodies that are new, or have left their larger balls; the others
// stay.
static void list_some(pair_list *l, const pair_query *q, int *lost)
{
    int n = find_fresh(l, q);
    if (n > l->fresh_capacity && TABLE_RENEW(l->fresh, l->fresh_capacity, n))
        n = find_fresh(l, q);
    int found = int_min(n, l->fresh_capacity);
    broad_order(&l->broad, l->fresh, found);
    l->walls = 0;               // those with planes are all found again
    pair_list_filter(l, is_still_good, l);
    grow_pairs(l, l->count + found);
    found = int_min(found, l->capacity - l->count);
    merge(l, found);
    *lost = n - found;
    list_plane_pairs(l, q, lost);
}

// Those that are new are given larger balls.
static void enlarge_new(pair_list *l, const pair_query *q)
{
    int n = l->is_whole ? l->bodies : l->looses;
    for (int k = 0; k < n; k++) {
        int b = l->is_whole ? k : l->loose[k];
        if (l->is_new[b]) enlarge(l, q, b);
    }
}

// Returns false if the tree has no room for one.
static bool place_new(pair_list *l)
{
    bool fits = true;
    for (int k = 0; k < l->looses && fits; k++)
        if (l->is_new[l->loose[k]])
            fits = broad_update(&l->broad, l->listed, l->loose[k]);
    return fits;
}
//<

//> pairs-update
bool pair_list_update(pair_list *l, const pair_query *q, int *lost)
{
    *lost = 0;
    l->is_whole = is_unsettled(l, q);
    find_left(l, q);
    if (!l->has_new && !l->is_whole) return false;
    if (!l->is_whole) loosen(l, q);
    enlarge_new(l, q);
    l->is_whole = l->is_whole || !place_new(l);
    if (l->is_whole) list_all(l, q, lost);
    else             list_some(l, q, lost);
    for (int b = 0; b < l->bodies; b++) l->is_new[b] = false;
    return true;
}
//<

//> pairs-wake
//>   What wakes, what falls asleep, and what a program puts elsewhere.
bool pair_list_wake(pair_list *l, const pair_query *q, int *lost)
{
    *lost = 0;
    if (!is_unsettled(l, q)) return false;
    l->is_whole = true;
    list_all(l, q, lost);
    return true;
}

static bool is_loose_pair(const void *list, const int pair[2])
{
    return !pair_is_settled(list, pair);
}

void pair_list_part(pair_list *l)
{
    int all = l->count;
    if (!l->is_whole) return;
    pair_list_filter(l, is_loose_pair, l);
    l->parted = all - l->count;
    l->is_whole = false;
}

void pair_list_renew(pair_list *l, int b)
{
    l->has_new = true;
    if (b >= 0) l->is_new[b] = true;
    // (What was nowhere when all were found had no pairs to be found again.)
    if (b >= 0 && l->listed[b].radius < 0) l->is_settled[b] = false;
    l->is_due |= b < 0 || l->is_settled[b];
}
//<

//> pairs-init
//>   The rest is memory. The list of pairs that is too short
//>   keeps nothing when it grows, because it is about to be made again.
static bool make_pair_room(pair_list *l, int bodies)
{
    int room = table_room(bodies, l->room), n = int_max(room, 1);
    bool ok = true;
    if (l->pair && l->fresh && bodies <= l->room) return true;
    TABLE_GROW(ok, l->listed, l->bodies, n);
    TABLE_GROW(ok, l->is_new, l->bodies, n);
    TABLE_GROW(ok, l->is_settled, l->bodies, n);
    TABLE_GROW(ok, l->loose, l->bodies, n);
    if (!l->pair) ok = ok && TABLE_RENEW(l->pair, l->capacity, 8 * n);
    if (!l->fresh) ok = ok && TABLE_RENEW(l->fresh, l->fresh_capacity, n);
    if (ok) l->room = room;
    return ok;
}

bool pair_list_grow(pair_list *l, int bodies)
{
    bool ok = make_pair_room(l, bodies) && broad_grow(&l->broad, bodies);
    for (; ok && l->bodies < bodies; l->bodies++) pair_list_renew(l, l->bodies);
    return ok;
}

void pair_list_free(pair_list *l)
{
    broad_free(&l->broad);
#define FREE(table, kept, room) free(l->table);
    PAIR_TABLES(FREE, FREE, l)
#undef FREE
    *l = (pair_list){ .bodies = 0 };
}
//<
