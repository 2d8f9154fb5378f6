// crowd.c - balls fly about in a plane: which of them are compared, on one axis
// and by a tree? (chapter 14)

#include "broad.h"
#include "live.h"
#include "random.h"

#include <string.h>

enum { ROOM, BALLS, RADIUS, SPEED };            // dials
enum { EVERY, AXIS, TREE, FOUND };             // lines of the chart
enum { MOST = 1000, PAIRS = 100000 };
static const vec3 HALF[] = { { 2.5, 1.4, 0 }, { 2.5, 0.15, 0 }, { 0.2, 1.4, 0 } };  // m

typedef enum { ALONE, ON_AXIS, IN_LEAF, TOUCHES } relation;     // to the watched ball

static broad state;
static sphere ball[MOST];
static vec3 velocity[MOST];
static char moves[MOST];
static relation to_watched[MOST];
static int pair[PAIRS][2], plain[PAIRS][2];
static int balls, found, listed, by_axis, by_tree, frame;
static bool is_equal;

static void begin(void)
{
    unsigned long long seed = 5;
    vec3 half = HALF[live_choice(ROOM)];
    broad_free(&state);
    memset(ball, 0, sizeof ball);       // also those that are no more
    balls = (int)live_dial(BALLS);
    for (int i = 0; i < balls; i++) {
        real number[4];
        for (int k = 0; k < 4; k++) number[k] = random_real(&seed);
        ball[i] = (sphere){ vec3_make(half.x * number[0], half.y * number[1], 0), live_dial(RADIUS) };
        velocity[i] = vec3_make(number[2], number[3], 0);
        moves[i] = 1;
    }
    ball[0].center = vec3_make(0.1, 0.05, 0);
    velocity[0] = vec3_scale(0.3, velocity[0]);
    frame = 0;
    if (!broad_grow(&state, balls)) balls = 0;
}

// --- Frames -----------------------------------------------------------------------
static real bounced(real x, real half, real *v)
{
    if (x > half && *v > 0) *v = -*v;
    if (x < -half && *v < 0) *v = -*v;
    return real_max(-half, real_min(half, x));
}

static void fly(void)
{
    vec3 half = HALF[live_choice(ROOM)];
    for (int i = 0; i < balls; i++) {
        vec3 *x = &ball[i].center;
        *x = vec3_add_scaled(*x, live_dial(SPEED) / 60, velocity[i]);
        x->x = bounced(x->x, half.x, &velocity[i].x);
        x->y = bounced(x->y, half.y, &velocity[i].y);
    }
}

static void relate(int a, int b, relation how)
{
    if (a > 0 && b > 0) return;
    int other = a > 0 ? a : b;
    if (how > to_watched[other]) to_watched[other] = how;
}

// On one axis, all are compared whose shadows overlap.
static void count_axis(void)
{
    by_axis = 0;
    for (int a = 0; a < balls; a++)
        for (int b = a + 1; b < balls; b++)
            if (fabs(ball[a].center.x - ball[b].center.x) <= ball[a].radius + ball[b].radius) {
                by_axis++;
                relate(a, b, ON_AXIS);
            }
}

// By the tree: balls of leaves whose boxes meet.
static void compare_leaves(int one, int two)
{
    const aabb_tree *t = &state.tree;
    for (int i = one * A_LEAF; i < aabb_tree_end(t, one); i++)
        for (int k = one == two ? i + 1 : two * A_LEAF; k < aabb_tree_end(t, two); k++) {
            by_tree++;
            relate(t->number[i], t->number[k], IN_LEAF);
        }
}

static void count_tree(void)
{
    const aabb_tree *t = &state.tree;
    by_tree = 0;
    for (int i = 0; i < t->leaves; i++)
        for (int k = i; k < t->leaves; k++)
            if (aabbs_meet(&t->node[t->leaves + i], &t->node[t->leaves + k])) compare_leaves(i, k);
}

static void step(void)
{
    fly();
    frame++;
    found = broad_pairs(&state, ball, moves, pair, PAIRS);
    listed = int_min(found, PAIRS);     // what has no room is only counted
}

static void measure(void)
{
    int all = broad_pairs_all(ball, moves, balls, plain, PAIRS);
    is_equal = all == found && memcmp(pair, plain, (size_t)listed * sizeof *pair) == 0;
    memset(to_watched, 0, sizeof to_watched);
    count_axis();
    count_tree();
    for (int k = 0; k < listed; k++) relate(pair[k][0], pair[k][1], TOUCHES);
    live_value(0, EVERY, balls * (balls - 1) / 2);
    live_value(0, AXIS, by_axis);
    live_value(0, TREE, by_tree);
    live_value(0, FOUND, found);
    live_say("%d leaves. The tree and the search that compares every pair find %s.", state.tree.leaves,
             is_equal ? "the same pairs" : "different pairs");
}

static void move(int number, vec3 to)
{
    (void)number;
    vec3 half = HALF[live_choice(ROOM)];
    ball[0].center = vec3_make(real_max(-half.x, real_min(half.x, to.x)), real_max(-half.y, real_min(half.y, to.y)), 0);
    velocity[0] = vec3_make(0, 0, 0);
}

// --- Drawing ----------------------------------------------------------------------
static const live_colour COLOUR[] = { LIVE_RULE, LIVE_BLUE, LIVE_ORANGE, LIVE_RED };
static const real FLOOR = -1.65, WIDE = 2.6, HIGH = 1.5;    // m, of what is drawn

static void draw_box(live_colour c, real left, real low, real right, real high)
{
    live_band(c, (vec3[]){ { left, low, 0 }, { right, low, 0 }, { right, high, 0 }, { left, high, 0 } }, 4);
}

// The box of the watched ball's leaf, and those of the leaves that it meets.
static void draw_leaves(void)
{
    const aabb_tree *t = &state.tree;
    if (balls == 0 || t->things == 0) return;
    const aabb *own = &t->node[t->leaves + state.place[0] / A_LEAF];
    for (const aabb *b = t->node + t->leaves; b < t->node + 2 * t->leaves; b++)
        if (b->low.x <= b->high.x && aabbs_meet(b, own))
            draw_box(LIVE_ORANGE, b->low.x, b->low.y, b->high.x, b->high.y);
}

// What a ball is to an axis: its shadow on it.
static void draw_shadow(int i, live_colour c, real y)
{
    real x = ball[i].center.x, r = ball[i].radius;
    live_line(c, (vec3[]){ { x - r, y, 0 }, { x + r, y, 0 } }, 2);
}

static void draw(void)
{
    vec3 x = ball[0].center;
    real r = ball[0].radius;
    draw_leaves();
    draw_box(LIVE_BLUE, x.x - r, FLOOR, x.x + r, HIGH);
    live_line(LIVE_RULE, (vec3[]){ { -WIDE, FLOOR, 0 }, { WIDE, FLOOR, 0 } }, 2);
    live_label(LIVE_QUIET, vec3_make(-WIDE, FLOOR - 0.12, 0), "x");
    // First those that nobody asks about.
    for (relation how = ALONE; how <= TOUCHES; how++)
        for (int i = 1; i < balls; i++) {
            if (to_watched[i] != how) continue;
            live_circle(COLOUR[how], ball[i].center, ball[i].radius);
            if (how != ALONE) draw_shadow(i, COLOUR[how], FLOOR + 0.03);
        }
    live_circle(LIVE_INK, x, r);
    draw_shadow(0, LIVE_INK, FLOOR);
    live_handle(0, LIVE_INK, x, "the ball that is watched");
}

static unsigned long long hash(void)
{
    return live_hash(live_hash(LIVE_HASH, ball, sizeof ball), pair, (size_t)listed * sizeof *pair);
}

const live_figure figure = {
    .name = "crowd",
    .says = "Balls fly about in a plane; those that are compared with one of them are coloured",
    .pane = { { -2.7, -1.8, 5.4, 3.4 } },
    .dial = {
        [ROOM] = { "they fly in a", NULL, 0, 2, 1, 0, "room|row|tower", true },
        [BALLS] = { "balls", NULL, 20, MOST, 20, 400, NULL, true },
        [RADIUS] = { "radius", "m", 0.02, 0.2, 0.01, 0.04, NULL, true },
        [SPEED] = { "speed", "m/s", 0, 5, 0.1, 0.5, NULL, false },
    },
    .chart = { { "comparisons a frame", NULL, { "every pair", "one axis", "the tree", "pairs found" }, 10, 10000, true, false, NULL } },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash, .move = move,
};
