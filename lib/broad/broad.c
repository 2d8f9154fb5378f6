//> broad-init
//>   Memory comes first. The arrays double when bodies are added, so that a
//>   world to which bodies come one by one does not copy all of them each time.
#include "broad.h"
#include "table.h"

#include <assert.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

bool broad_grow(broad *s, int bodies)
{
    int n = table_room(bodies, s->room);
    bool ok = true;
    assert(bodies >= 0);
    if (!s->place || n > s->room) {
#define GROW(table, kept, room) TABLE_GROW(ok, s->table, kept, room);
        BROAD_TABLES(GROW, s, n)
#undef GROW
        if (ok) s->room = n;
    }
    for (; ok && s->bodies < bodies; s->bodies++) s->place[s->bodies] = -1;
    return ok;
}

void broad_free(broad *s)
{
#define FREE(table, kept, room) free(s->table);
    BROAD_TABLES(FREE, s, 0)
#undef FREE
    *s = (broad){ .bodies = 0 };
}
//<

//> broad-meet
// Do they touch or overlap?  They are apart only if the comparison says so, and
// with a NaN it says nothing.  Squares of lengths beyond 2^511 or below 2^-511
// would not be what they are of: there all is measured in another unit, by a
// power of two, which rounds nothing.
static int balls_meet(sphere a, sphere b)
{
    vec3 d = vec3_sub(a.center, b.center);
    real r = a.radius + b.radius;
    if (!(r > 0x1p-480 && r < 0x1p480)) {
        real unit = r < 1 ? 0x1p600 : 0x1p-600;
        d = vec3_scale(unit, d);
        r *= unit;
    }
    return !(vec3_length_squared(d) > r * r);
}

static int ball_is_empty(sphere ball)
{
    return ball.radius < 0;
}
//<

//> broad-box
//>   The box around a ball is a few roundings wider than the ball.
static bool ball_is_finite(sphere ball)
{
    return vec3_is_finite(ball.center) && ball.radius - ball.radius == 0;
}

// No pair may be lost that balls_meet would find.  With u = 2^-53, what one
// operation rounds, boxes of balls that pass it overlap but for 3 u (ra + rb).
// Each end here is wrong by at most 2.1 u (|x| + r).  So each is set further
// out, by 8 u (|x| + r), which is more than both.  A ball that is not finite may
// be anywhere.
static aabb box_of_ball(sphere ball)
{
    vec3 c = ball.center, all = { HUGE_VAL, HUGE_VAL, HUGE_VAL };
    real r = ball.radius;
    if (!ball_is_finite(ball)) return (aabb){ vec3_scale(-1, all), all };
    vec3 out = { r + 0x1p-50 * (fabs(c.x) + r), r + 0x1p-50 * (fabs(c.y) + r),
                 r + 0x1p-50 * (fabs(c.z) + r) };
    return (aabb){ vec3_sub(c, out), vec3_add(c, out) };
}
//<

//> broad-plant
//>   All balls are planted at once; one that has become another is put where it
//>   was, and the boxes above it follow.
static void plant(broad *s, const sphere *ball)
{
    aabb_tree *t = &s->tree;
    t->things = 0;
    for (int b = 0; b < s->bodies; b++) {
        s->place[b] = -1;
        if (ball_is_empty(ball[b])) continue;
        t->around[t->things] = box_of_ball(ball[b]);
        t->number[t->things++] = b;
    }
    aabb_tree_build(t);
    for (int k = 0; k < t->things; k++) s->place[t->number[k]] = k;
}

bool broad_update(broad *s, const sphere *ball, int b)
{
    aabb_tree *t = &s->tree;
    bool is_new = s->place[b] < 0;
    if (is_new && t->things >= t->leaves * A_LEAF) return false;
    if (is_new) s->place[b] = t->things++;
    int k = s->place[b];
    t->around[k] = ball_is_empty(ball[b]) ? aabb_empty() : box_of_ball(ball[b]);
    t->number[k] = b;
    aabb_tree_update(t, k);
    return true;
}
//<

//> broad-cross
//>   Two boxes of one height that do not meet have nothing in common. Those that
//>   do are opened, both at once, down to the leaves.
typedef struct {
    int (*at)[2];
    int capacity, found;    // those beyond capacity are counted, not stored
} found_pairs;

static void add_pair(found_pairs *out, int a, int b)
{
    if (out->found < out->capacity) {
        out->at[out->found][0] = int_min(a, b);
        out->at[out->found][1] = int_max(a, b);
    }
    out->found += out->found < INT_MAX;
}

// What is asked, and what has been found.
typedef struct {
    const broad *s;
    const sphere *ball;
    const char *moves;
    found_pairs out;
} pair_search;

static bool is_pair(const pair_search *q, int a, int b)
{
    return (q->moves[a] || q->moves[b]) && balls_meet(q->ball[a], q->ball[b]);
}

static void cross_leaves(pair_search *q, int one, int other)
{
    const aabb_tree *t = &q->s->tree;
    for (int i = one * A_LEAF; i < aabb_tree_end(t, one); i++) {
        int k = one == other ? i + 1 : other * A_LEAF;
        for (; k < aabb_tree_end(t, other); k++) {
            int a = t->number[i], b = t->number[k];
            if (is_pair(q, a, b)) add_pair(&q->out, a, b);
        }
    }
}

// It calls itself no deeper than an int has bits.
static void cross(pair_search *q, int i, int k)
{
    const aabb_tree *t = &q->s->tree;
    if (!aabbs_meet(&t->node[i], &t->node[k])) return;
    if (i >= t->leaves) {
        cross_leaves(q, i - t->leaves, k - t->leaves);
        return;
    }
    cross(q, 2 * i, 2 * k);
    cross(q, 2 * i, 2 * k + 1);
    if (i != k) cross(q, 2 * i + 1, 2 * k);
    cross(q, 2 * i + 1, 2 * k + 1);
}
//<

//> broad-order-pairs
//>   Pairs stand in one order, whatever the tree found first.
static void order_few(int (*pair)[2], int n)
{
    int gap = 1;
    while (gap < n / 9) gap = 3 * gap + 1;
    for (; gap > 0; gap /= 3)
        for (int k = gap; k < n; k++) {
            int here[2] = { pair[k][0], pair[k][1] }, at = k;
            for (; at >= gap && broad_is_before(here, pair[at - gap]); at -= gap)
                memcpy(pair[at], pair[at - gap], sizeof here);
            memcpy(pair[at], here, sizeof here);
        }
}

// Many pairs are sorted by a, then by b, where they lie.  The counts in first tell
// where each a's pairs begin.  A pair that lies among another's is exchanged
// with the first there that may be out of place, and is then home for good.
static void sort_pairs(broad *s, int (*pair)[2])
{
    int n = s->bodies, sum = 0;
    for (int a = 0; a < n; a++) {
        int count = s->first[a];
        s->first[a] = s->next[a] = sum;
        sum += count;
    }
    for (int a = 0; a < n; a++) {
        int end = a + 1 < n ? s->first[a + 1] : sum;
        while (s->next[a] < end) {
            int *here = pair[s->next[a]];
            int *home = pair[s->next[here[0]]++];
            SWAP(int, here[0], home[0]);
            SWAP(int, here[1], home[1]);
        }
        order_few(pair + s->first[a], end - s->first[a]);
    }
}

void broad_order(broad *s, int (*pair)[2], int n)
{
    if (n < s->bodies) {
        order_few(pair, n);
        return;
    }
    for (int b = 0; b < s->bodies; b++) s->first[b] = 0;
    for (int k = 0; k < n; k++) s->first[pair[k][0]]++;
    sort_pairs(s, pair);
}
//<

//> broad-all
//>   The paper's way is short, and hard to get wrong. It is the oracle of the
//>   tests.
int broad_pairs_all(const sphere *ball, const char *moves, int bodies,
                    int (*out)[2], int capacity)
{
    assert(bodies >= 0 && capacity >= 0);
    found_pairs list = { out, capacity, 0 };
    for (int a = 0; a < bodies; a++) {
        if (ball_is_empty(ball[a])) continue;
        for (int b = a + 1; b < bodies; b++)
            if (balls_meet(ball[a], ball[b]) && !ball_is_empty(ball[b])
                && (moves[a] || moves[b]))
                add_pair(&list, a, b);
    }
    return list.found;
}
//<

//> broad-pairs
//>   All of it together.
int broad_pairs(broad *s, const sphere *ball, const char *moves,
                int (*out)[2], int capacity)
{
    assert(capacity >= 0);
    pair_search q = { s, ball, moves, { out, capacity, 0 } };
    if (s->bodies == 0) return 0;
    plant(s, ball);
    cross(&q, 1, 1);
    if (q.out.found <= capacity) broad_order(s, out, q.out.found);
    return q.out.found;
}
//<

//> broad-ask
//>   A single ball asks the tree from the top down.
// What body b asks, and of which others it is left to ask.
typedef struct {
    pair_search q;
    const bool *is_asked;
    int b;
    aabb around;
} one_search;

static void near_leaf(one_search *o, int leaf)
{
    const aabb_tree *t = &o->q.s->tree;
    for (int k = leaf * A_LEAF; k < aabb_tree_end(t, leaf); k++) {
        int b = o->b, c = t->number[k];
        if (c == b || (c < b && o->is_asked[c])) continue;
        if (ball_is_empty(o->q.ball[c])) continue;
        if (is_pair(&o->q, b, c)) add_pair(&o->q.out, b, c);
    }
}

static void near_box(one_search *o, int k)
{
    const aabb_tree *t = &o->q.s->tree;
    if (!aabbs_meet(&t->node[k], &o->around)) return;
    if (k >= t->leaves) {
        near_leaf(o, k - t->leaves);
        return;
    }
    near_box(o, 2 * k);
    near_box(o, 2 * k + 1);
}

int broad_near(const broad *s, const sphere *ball, const char *moves,
               const bool *is_asked, int b, int (*out)[2], int capacity,
               int found)
{
    one_search o = { { s, ball, moves, { out, capacity, found } }, is_asked, b,
                     box_of_ball(ball[b]) };
    if (s->tree.things > 0 && !ball_is_empty(ball[b])) near_box(&o, 1);
    return o.q.out.found;
}
//<
