//> broad-init
#include "broad.h"

#include <assert.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

status broad_init(broad *s, int bodies)
{
    assert(bodies >= 0);
    size_t n = (size_t)bodies + 1;
    *s = (broad){ .bodies = bodies,
        .order = malloc(n * sizeof *s->order),
        .low   = malloc(n * sizeof *s->low),
        .high  = malloc(n * sizeof *s->high),
        .first = malloc(n * sizeof *s->first),
        .start = malloc(n * sizeof *s->start),
        .line  = malloc(n * sizeof *s->line),
        .mover = malloc(n * sizeof *s->mover) };
    if (!s->order || !s->low || !s->high || !s->first
        || !s->start || !s->line || !s->mover) {
        broad_free(s);
        return status_out_of_memory();
    }
    for (int b = 0; b < bodies; b++) s->order[b] = b;
    return status_ok();
}

void broad_free(broad *s)
{
    free(s->order);
    free(s->low);
    free(s->high);
    free(s->first);
    free(s->start);
    free(s->line);
    free(s->mover);
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
// Where the shadows of the balls on the x axis begin and end.
//
// No pair may be lost that balls_meet would find.  With u = 2^-53, what one
// operation rounds, balls that pass it overlap along x but for 3 u (ra + rb).
// Each end here is wrong by at most 2.1 u (|x| + r).  So each is set further
// out, by 8 u (|x| + r), which is more than both.
static void find_ends(broad *s, const sphere *ball)
{
    for (int b = 0; b < s->bodies; b++) {
        real x = ball[b].center.x, r = ball[b].radius;
        real wider = 0x1p-50 * (fabs(x) + r);
        s->low[b]  = x - r - wider;
        s->high[b] = x + r + wider;
        // A ball that is not finite may be anywhere.
        if (!vec3_is_finite(ball[b].center) || !(r - r == 0)) {
            s->low[b]  = -HUGE_VAL;
            s->high[b] = HUGE_VAL;
        }
        // An empty one is nowhere, and waits at the end of the line.
        if (ball_is_empty(ball[b])) {
            s->low[b]  = HUGE_VAL;
            s->high[b] = -HUGE_VAL;
        }
    }
}
//<

//> broad-sort
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
enum { PATIENCE = 32 };

static void sort_line(broad *s)
{
    s->shifts = 0;
    if (insert_all(s, 1, (long)PATIENCE * s->bodies)) return;
    int gap = 1;
    while (gap < s->bodies / 9) gap = 3 * gap + 1;
    for (; gap > 0; gap /= 3) insert_all(s, gap, LONG_MAX);
}
//<

//> broad-line
// Lays out the line as the sweep will walk it, and says for each place who is
// the next to move.
static void lay_out(broad *s, const sphere *ball, const char *moves)
{
    int n = s->bodies;
    while (n > 0 && ball_is_empty(ball[s->order[n - 1]])) n--;
    s->in_line = s->mover[n] = n;
    for (int k = n - 1; k >= 0; k--) {
        int b = s->order[k];
        s->start[k] = s->low[b];
        s->line[k]  = ball[b];
        s->mover[k] = moves[b] ? k : s->mover[k + 1];
    }
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

// Lists the pair, and counts in first[a] the pairs (a, b).
static void meet(broad *s, int me, int other, pair_list *out)
{
    int a = me < other ? me : other, b = me < other ? other : me;
    s->first[a]++;
    add_pair(out, a, b);
}

// From each ball to the right, as far as balls begin before it ends: these
// overlap it along x, and no others do.  One that stands still only looks at
// those that move.  Stops when there are more pairs than room.
static void sweep(broad *s, pair_list *out)
{
    const real *start = s->start;
    int n = s->in_line;
    memset(s->first, 0, ((size_t)s->bodies + 1) * sizeof *s->first);
    for (int i = 0; i < n && out->found <= out->capacity; i++) {
        int me = s->order[i];
        real end = s->high[me];
        sphere ball = s->line[i];
        if (s->mover[i] == i) {
            for (int j = i + 1; j < n && start[j] <= end; j++)
                if (balls_meet(ball, s->line[j]))
                    meet(s, me, s->order[j], out);
        } else {
            for (int j = s->mover[i]; j < n && start[j] <= end;
                 j = s->mover[j + 1])
                if (balls_meet(ball, s->line[j]))
                    meet(s, me, s->order[j], out);
        }
    }
}
//<

//> broad-order-pairs
// Sorts pairs of one a by b: Shell's passes again, now over b.  No two are
// equal.
static void sort_by_b(int (*pair)[2], int n)
{
    int gap = 1;
    while (gap < n / 9) gap = 3 * gap + 1;
    for (; gap > 0; gap /= 3)
        for (int k = gap; k < n; k++) {
            int b = pair[k][1], at = k;
            for (; at >= gap && pair[at - gap][1] > b; at -= gap)
                pair[at][1] = pair[at - gap][1];
            pair[at][1] = b;
        }
}

// Sorts the pairs by a, then by b, where they lie.  The counts in first tell
// where each a's pairs begin.  A pair that lies among another's is exchanged
// with the first there that may be out of place, and is then home for good.
static void sort_pairs(broad *s, int (*pair)[2])
{
    int n = s->bodies, sum = 0;
    for (int a = 0; a <= n; a++) {
        int count = s->first[a];
        s->first[a] = s->mover[a] = sum;
        sum += count;
    }
    for (int a = 0; a < n; a++) {
        while (s->mover[a] < s->first[a + 1]) {
            int *here = pair[s->mover[a]];
            int *home = pair[s->mover[here[0]]++];
            int a_there = home[0], b_there = home[1];
            home[0] = here[0];
            home[1] = here[1];
            here[0] = a_there;
            here[1] = b_there;
        }
        sort_by_b(pair + s->first[a], s->first[a + 1] - s->first[a]);
    }
}
//<

//> broad-all
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
enum { LOOKS_A_PAIR = 16 };

int broad_pairs(broad *s, const sphere *ball, const char *moves,
                int (*out)[2], int capacity)
{
    assert(capacity >= 0);
    int n = s->bodies, b = 0;
    real most = 0.5 * n * (n - 1.0) / LOOKS_A_PAIR;
    pair_list list = { out, capacity < most ? capacity : (int)most, 0 };

    // Nobody moves: nobody need be sorted.
    while (b < n && !moves[b]) b++;
    if (b == n) return 0;

    find_ends(s, ball);
    sort_line(s);
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
