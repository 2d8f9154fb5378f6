//> broad-init
//>   Memory comes next. The arrays double when bodies are added, so that a
//>   world to which bodies come one by one does not copy all of them each time.
#include "broad.h"
#include "table.h"

#include <assert.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

// In a leaf of the tree.  The fewer, the fewer balls are
// compared, and the more memory the boxes take.
enum { A_LEAF = 4 };                        // tuned, balls

int broad_boxes(int bodies)
{
    int leaves = 1;
    while (leaves < 1 << 28 && leaves * A_LEAF < bodies) leaves *= 2;
    return 2 * leaves;
}

// Nothing is kept but the order: the rest is made by every call.
static bool grow(broad *s, int bodies)
{
    int n = table_room(bodies, s->room);
    bool ok = true;
    if (s->order && bodies <= s->room) return true;
#define GROW(table, kept, room) TABLE_GROW(ok, s->table, kept, room);
    BROAD_TABLES(GROW, GROW, s, n)
#undef GROW
    if (ok) s->room = n;
    return ok;
}

status broad_grow(broad *s, int bodies)
{
    assert(bodies >= 0);
    if (!grow(s, bodies)) return status_out_of_memory();
    for (; s->bodies < bodies; s->bodies++) {
        s->order[s->bodies] = s->bodies;
        s->place[s->bodies] = -1;
    }
    return status_ok();
}

void broad_free(broad *s)
{
#define FREE(table, kept, room) free(s->table);
    BROAD_TABLES(FREE, FREE, s, 0)
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

//> broad-ends
// Where the shadow of a ball on an axis (0: x) begins and ends.
//
// No pair may be lost that balls_meet would find.  With u = 2^-53, what one
// operation rounds, balls that pass it overlap along x but for 3 u (ra + rb).
// Each end here is wrong by at most 2.1 u (|x| + r).  So each is set further
// out, by 8 u (|x| + r), which is more than both.
static int ball_is_finite(sphere ball)
{
    return vec3_is_finite(ball.center) && ball.radius - ball.radius == 0;
}

static shadow shadow_of(sphere ball, int axis)
{
    vec3 c = ball.center;
    real x = axis == 0 ? c.x : axis == 1 ? c.y : c.z, r = ball.radius;
    real wider = 0x1p-50 * (fabs(x) + r);
    return (shadow){ x - r - wider, x + r + wider };
}

// A ball that is not finite may be anywhere.  An empty one is nowhere, and waits
// at the end of the line.
static shadow whole_shadow(sphere ball, int axis)
{
    if (ball_is_empty(ball))   return (shadow){ HUGE_VAL, -HUGE_VAL };
    if (!ball_is_finite(ball)) return (shadow){ -HUGE_VAL, HUGE_VAL };
    return shadow_of(ball, axis);
}

static void find_ends(broad *s, const sphere *ball)
{
    for (int k = 0; k < s->bodies; k++) {
        int b = s->order[k];
        shadow x = whole_shadow(ball[b], 0);
        s->low[b]  = x.low;
        s->high[b] = x.high;
    }
}
//<

//> broad-sort
//>   Ends are sorted by insertion; from frame to frame little has changed.
static int is_left_of(const broad *s, int a, int b)
{
    return s->low[a] < s->low[b] || (s->low[a] == s->low[b] && a < b);
}

// Moves each body up past those `gap`, 2 gap, ... before it that it is left of.
// With gap 1 this is insertion sort.  Gives up, 0, after `most` moves.
static int insert_all(broad *s, int gap, long most)
{
    int *order = s->order;
    for (int k = gap; k < s->bodies && s->shifts <= most; k++) {
        int b = order[k], at = k;
        for (; at >= gap && is_left_of(s, b, order[at - gap]); at -= gap)
            order[at] = order[at - gap];
        order[at] = b;
        s->shifts += (k - at) / gap;
    }
    return s->shifts <= most;
}

// An order that was right a frame ago costs a look and a few moves a body.  One
// that is far from right would cost n / 4 of them; after PATIENCE it is sorted
// after Shell (1959), in passes of gaps 1, 4, 13, 40, ... from the largest
// down: not more than about n^1.5 moves whatever the order (Pratt 1972).
enum { PATIENCE = 32 };                     // tuned, moves of a body

static void sort_line(broad *s)
{
    s->shifts = 0;
    if (insert_all(s, 1, (long)PATIENCE * s->bodies)) return;
    int gap = 1;
    while (gap < s->bodies / 9) gap = 3 * gap + 1;
    for (; gap > 0; gap /= 3) insert_all(s, gap, LONG_MAX);
}
//<

//> broad-lanes
// The finite balls along an axis: from where to where, and how wide in all.
typedef struct {
    shadow all;
    real   widths;          // m
} spread;

static void measure(const broad *s, const sphere *ball, spread along[2])
{
    for (int k = 0; k < 2; k++)
        along[k] = (spread){ { HUGE_VAL, -HUGE_VAL }, 0 };
    for (int i = 0; i < s->bodies; i++) {
        int b = s->order[i];
        if (ball_is_empty(ball[b]) || !ball_is_finite(ball[b])) continue;
        for (int k = 0; k < 2; k++) {
            shadow x = shadow_of(ball[b], 1 + k), *all = &along[k].all;
            all->low = x.low < all->low ? x.low : all->low;
            all->high = x.high > all->high ? x.high : all->high;
            along[k].widths += x.high - x.low;
        }
    }
}

// As many as there is room for, each twice as wide as a ball is on average: it
// stands in 1.5 of them then.
static int lanes_along(const spread *along, int bodies)
{
    enum { BODIES_A_LANE = 8 };             // tuned, bodies
    real most = bodies / BODIES_A_LANE;
    real lanes = (along->all.high - along->all.low) * bodies
               / (2 * along->widths);
    // (This may be no number, or too large for an int.)
    return lanes > 1 ? (int)(lanes < most ? lanes : most) : 1;
}

// A larger x never has a lower lane, however that is rounded: so shadows that
// overlap have a lane in common.
static int lane_of(real x, real low, real per_metre, int lanes)
{
    real k = (x - low) * per_metre;
    return k >= lanes ? lanes - 1 : k >= 1 ? (int)k : 0;
}
//<

//> broad-divide
//>   The lanes are chosen so that a ball stands in four of them at most, on
//>   average. Few bodies need no lanes: below four hundred it takes longer to
//>   lay them out than to walk down one line.
// Into which lanes does each ball reach?  One that is not finite, into all.
// Returns how many places they take together.
static real find_reach(broad *s, const sphere *ball, const spread along[2])
{
    real per_metre[2], places = 0;
    for (int k = 0; k < 2; k++)
        per_metre[k] = s->lanes[k] / (along[k].all.high - along[k].all.low);
    for (int i = 0; i < s->bodies; i++) {
        int b = s->order[i];
        lane_range *r = s->reach[b];
        for (int k = 0; k < 2; k++) {
            r[k] = (lane_range){ 0, s->lanes[k] - 1 };
            if (s->lanes[k] == 1 || !ball_is_finite(ball[b])) continue;
            real low = along[k].all.low;
            shadow x = shadow_of(ball[b], 1 + k);
            r[k].first = lane_of(x.low, low, per_metre[k], s->lanes[k]);
            r[k].last = lane_of(x.high, low, per_metre[k], s->lanes[k]);
        }
        if (ball_is_empty(ball[b])) r[0].last = -1;
        places += (r[0].last - r[0].first + 1.0)
                * (r[1].last - r[1].first + 1.0);
    }
    return places;
}

// Where a few balls are much larger than the others, these reach into many
// lanes.  Half as many, each way, then: in the end there is one, with room for
// everybody.  (Few bodies walk down one line before lanes are laid out.)
static void divide(broad *s, const sphere *ball)
{
    enum { FEW = 400 };                     // tuned, bodies
    spread along[2] = { { { 0, 0 }, 0 } };
    int n = s->bodies;
    for (int k = 0; k < 2; k++) s->lanes[k] = 1;
    if (n >= FEW) {
        measure(s, ball, along);
        for (int k = 0; k < 2; k++) s->lanes[k] = lanes_along(&along[k], n);
    }
    while ((real)s->lanes[0] * s->lanes[1] > n
           || find_reach(s, ball, along) > (real)LANES_A_BODY * n)
        for (int k = 0; k < 2; k++) s->lanes[k] = (s->lanes[k] + 1) / 2;
}
//<

//> broad-line
//>   The lanes need not be sorted. A walk down the sorted line that sends each
//>   body to its lanes leaves every lane sorted. The balls are copied in the
//>   order of their lane, so that the sweep reads memory from front to back.
// How many stand in each lane, as of two further on; then where each lane, as
// of one further on, begins.  Laying out moves that to its end, which is where
// the next one begins.
static void make_room(broad *s)
{
    int lanes = s->lanes[0] * s->lanes[1];
    memset(s->lane, 0, ((size_t)lanes + 2) * sizeof *s->lane);
    for (int k = 0; k < s->bodies; k++) {
        const lane_range *r = s->reach[s->order[k]];
        for (int y = r[0].first; y <= r[0].last; y++)
            for (int z = r[1].first; z <= r[1].last; z++)
                s->lane[y * s->lanes[1] + z + 2]++;
    }
    for (int l = 0; l < lanes; l++) s->lane[l + 2] += s->lane[l + 1];
    s->places = s->lane[lanes + 1];
}

static void stand_in(broad *s, int lane, int b, sphere ball)
{
    int at = s->lane[lane + 1]++;
    s->start[at] = s->low[b];
    s->line[at] = ball;
    s->who[at] = b;
}

// Lays out the line, lane by lane as the sweep will walk it, and says for each
// place which is the next of one that moves.
static void lay_out(broad *s, const sphere *ball, const char *moves)
{
    make_room(s);
    for (int k = 0; k < s->bodies; k++) {
        int b = s->order[k];
        const lane_range *r = s->reach[b];
        for (int y = r[0].first; y <= r[0].last; y++)
            for (int z = r[1].first; z <= r[1].last; z++)
                stand_in(s, y * s->lanes[1] + z, b, ball[b]);
    }
    s->mover[s->places] = s->places;
    for (int k = s->places - 1; k >= 0; k--)
        s->mover[k] = moves[s->who[k]] ? k : s->mover[k + 1];
}
//<

//> broad-sweep
typedef struct {
    int (*at)[2];
    int capacity, found;    // those beyond capacity are counted, not stored
} pair_list;

static void add_pair(pair_list *out, int a, int b)
{
    if (out->found < out->capacity) {
        out->at[out->found][0] = a;
        out->at[out->found][1] = b;
    }
    out->found += out->found < INT_MAX;
}

// Lists the pair, and counts in first[a] the pairs (a, b); but only in the
// first of the lanes that both stand in.
static void meet(broad *s, int lane, int me, int other, pair_list *out)
{
    int a = me < other ? me : other, b = me < other ? other : me;
    const lane_range *x = s->reach[a], *y = s->reach[b];
    if (lane != int_max(x[0].first, y[0].first) * s->lanes[1]
                + int_max(x[1].first, y[1].first)) return;
    s->first[a]++;
    add_pair(out, a, b);
}

// From each ball to the right, as far as balls begin before it ends: these
// overlap it along x, and no others do.  One that stands still only looks at
// those that move.  Stops when there are more pairs than room.
static void sweep_lane(broad *s, int lane, pair_list *out)
{
    const real *start = s->start;
    int n = s->lane[lane + 1];
    for (int i = s->lane[lane]; i < n && out->found <= out->capacity; i++) {
        int me = s->who[i];
        real end = s->high[me];
        sphere ball = s->line[i];
        if (s->mover[i] == i) {
            for (int j = i + 1; j < n && start[j] <= end; j++)
                if (balls_meet(ball, s->line[j]))
                    meet(s, lane, me, s->who[j], out);
        } else {
            for (int j = s->mover[i]; j < n && start[j] <= end;
                 j = s->mover[j + 1])
                if (balls_meet(ball, s->line[j]))
                    meet(s, lane, me, s->who[j], out);
        }
    }
}

static void sweep(broad *s, pair_list *out)
{
    for (int k = 0; k < s->bodies; k++) s->first[s->order[k]] = 0;
    for (int l = 0; l < s->lanes[0] * s->lanes[1]; l++)
        sweep_lane(s, l, out);
}
//<

//> broad-order-pairs
//>   Pairs stand in one order, whatever the tree found first.
void broad_order(int (*pair)[2], int n)
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

// Sorts the pairs by a, then by b, where they lie.  The counts in first tell
// where each a's pairs begin.  A pair that lies among another's is exchanged
// with the first there that may be out of place, and is then home for good.
static void sort_pairs(broad *s, int (*pair)[2])
{
    int n = s->bodies, sum = 0;
    for (int a = 0; a < n; a++) {
        int count = s->first[a];
        s->first[a] = s->mover[a] = sum;
        sum += count;
    }
    for (int a = 0; a < n; a++) {
        int end = a + 1 < n ? s->first[a + 1] : sum;
        while (s->mover[a] < end) {
            int *here = pair[s->mover[a]];
            int *home = pair[s->mover[here[0]]++];
            SWAP(int, here[0], home[0]);
            SWAP(int, here[1], home[1]);
        }
        broad_order(pair + s->first[a], end - s->first[a]);
    }
}
//<

//> broad-all
//>   The paper's way is short, and hard to get wrong. It is the oracle of the
//>   tests.
int broad_pairs_all(const sphere *ball, const char *moves, int bodies,
                    int (*out)[2], int capacity)
{
    assert(bodies >= 0 && capacity >= 0);
    pair_list list = { out, capacity, 0 };
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
// To bring one pair into its place takes as long as to look at this many, or
// longer.
enum { LOOKS_A_PAIR = 16 };                 // tuned, looks

int broad_pairs(broad *s, const sphere *ball, const char *moves,
                int (*out)[2], int capacity)
{
    assert(capacity >= 0);
    int n = s->bodies, k = 0;
    real most = 0.5 * n * (n - 1.0) / LOOKS_A_PAIR;
    pair_list list = { out, capacity < most ? capacity : (int)most, 0 };

    // Where no body moves, none needs to be sorted.
    while (k < n && !moves[k]) k++;
    s->places = 0;
    if (k == n) return 0;

    find_ends(s, ball);
    sort_line(s);
    divide(s, ball);
    lay_out(s, ball, moves);
    sweep(s, &list);
    // Too many to be worth sorting, or to be kept: looking at every pair finds
    // them in order, so that it keeps the first.
    if (list.found > list.capacity)
        return broad_pairs_all(ball, moves, n, out, capacity);
    if (list.found > 0) sort_pairs(s, out);
    return list.found;
}
//<

//> broad-tree
//>   All balls are put into a tree when all pairs are found: its leaves are a few
//>   neighbours on a curve. One that has become another asks the tree, from the top
//>   down, and goes into a box only if it may touch it. So a ball among ten thousand
//>   looks at a few dozen boxes, and at none that is far.
static const shadow NOTHING = { HUGE_VAL, -HUGE_VAL };

static shadow around(shadow x, shadow y)
{
    return (shadow){ x.low < y.low ? x.low : y.low,
                     x.high > y.high ? x.high : y.high };
}

static void box_leaf(broad *s, const sphere *ball, int leaf)
{
    int end = int_min((leaf + 1) * A_LEAF, s->in_tree);
    for (int axis = 0; axis < 3; axis++) {
        shadow *box = &s->box[s->leaves + leaf][axis];
        *box = NOTHING;
        for (int k = leaf * A_LEAF; k < end; k++)
            *box = around(*box, whole_shadow(ball[s->tree[k]], axis));
    }
}

static void box_two(broad *s, int k)
{
    for (int axis = 0; axis < 3; axis++)
        s->box[k][axis] = around(s->box[2 * k][axis], s->box[2 * k + 1][axis]);
}

// Cells of a box around all, along each axis; a power of two.
enum { CELLS = 256 };

// The bits of a number below CELLS, with two zeros between each.
static int spread_bits(int x)
{
    int sum = 0;
    for (int bit = 1, at = 0; bit < CELLS; bit *= 2, at += 2)
        sum |= (x & bit) << at;
    return sum;
}

// Where balls are on Morton's curve through all cells, which mostly goes from one
// cell to the next.
static void find_curve(broad *s, const sphere *ball, int (*key)[2])
{
    shadow all[3] = { NOTHING, NOTHING, NOTHING };
    for (int k = 0; k < s->in_tree; k++)
        for (int axis = 0; axis < 3 && ball_is_finite(ball[key[k][1]]); axis++)
            all[axis] = around(all[axis], shadow_of(ball[key[k][1]], axis));
    for (int k = 0; k < s->in_tree; k++) {
        vec3 c = ball[key[k][1]].center;
        real at[3] = { c.x, c.y, c.z };
        for (int axis = 0; axis < 3; axis++) {
            shadow x = all[axis];
            int cell = lane_of(at[axis], x.low, CELLS / (x.high - x.low), CELLS);
            key[k][0] |= spread_bits(cell) << axis;
        }
    }
}

void broad_plant(broad *s, const sphere *ball)
{
    s->in_tree = 0;
    for (int b = 0; b < s->bodies; b++) {
        s->place[b] = -1;
        if (ball_is_empty(ball[b])) continue;
        s->key[s->in_tree][0] = 0;
        s->key[s->in_tree++][1] = b;
    }
    find_curve(s, ball, s->key);
    broad_order(s->key, s->in_tree);
    for (int k = 0; k < s->in_tree; k++) {
        s->tree[k] = s->key[k][1];
        s->place[s->tree[k]] = k;
    }
    s->leaves = broad_boxes(s->in_tree) / 2;
    for (int k = 0; k < s->leaves; k++) box_leaf(s, ball, k);
    for (int k = s->leaves - 1; k > 0; k--) box_two(s, k);
}

bool broad_put(broad *s, const sphere *ball, int b)
{
    if (s->place[b] < 0 && s->in_tree >= s->leaves * A_LEAF) return false;
    if (s->place[b] < 0) {
        s->place[b] = s->in_tree;
        s->tree[s->in_tree++] = b;
    }
    int leaf = s->place[b] / A_LEAF;
    box_leaf(s, ball, leaf);
    for (int k = (s->leaves + leaf) / 2; k > 0; k /= 2) box_two(s, k);
    return true;
}

static bool overlaps(const shadow x[3], const shadow y[3])
{
    for (int axis = 0; axis < 3; axis++)
        if (x[axis].low > y[axis].high || x[axis].high < y[axis].low)
            return false;
    return true;
}

//<

//> broad-ask
// What a body asks of the tree.
typedef struct {
    const broad *s;
    const sphere *ball;
    const char *moves;
    const bool *is_asked;
    int b;
    shadow box[3];
    pair_list out;
} tree_query;

static void ask_leaf(tree_query *q, int leaf)
{
    int end = int_min((leaf + 1) * A_LEAF, q->s->in_tree), b = q->b;
    for (int k = leaf * A_LEAF; k < end; k++) {
        int c = q->s->tree[k];
        if (c == b || (c < b && q->is_asked[c])) continue;
        if (ball_is_empty(q->ball[c])) continue;
        if ((q->moves[b] || q->moves[c])
            && balls_meet(q->ball[b], q->ball[c]))
            add_pair(&q->out, int_min(b, c), b < c ? c : b);
    }
}

// It calls itself no deeper than an int has bits.
static void ask_box(tree_query *q, int k)
{
    if (!overlaps(q->s->box[k], q->box)) return;
    if (k >= q->s->leaves) {
        ask_leaf(q, k - q->s->leaves);
        return;
    }
    ask_box(q, 2 * k);
    ask_box(q, 2 * k + 1);
}

int broad_near(const broad *s, const sphere *ball, const char *moves,
               const bool *is_asked, int b, int (*out)[2], int capacity,
               int found)
{
    tree_query q = { s, ball, moves, is_asked, b, { { 0, 0 } },
                     { out, capacity, found } };
    for (int axis = 0; axis < 3; axis++)
        q.box[axis] = whole_shadow(ball[b], axis);
    if (s->in_tree > 0 && !ball_is_empty(ball[b])) ask_box(&q, 1);
    return q.out.found;
}
//<
