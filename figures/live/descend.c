// descend.c - two trees of spheres against each other, comparison by comparison, with
// the line of compare() lit; what one comparison leaves out is a block of the table of
// all pairs (chapter 6).

#include "live.h"
#include "sphere_tree.h"

#include <string.h>

enum { MARGIN };                                // dial
enum { CHAINS, TABLE };                         // panes
enum { LINKS = 8, POINTS = LINKS + 1, NODES = 2 * LINKS - 1, SIDES = 2, PACE = 24, REST = 150 };
typedef enum { UNSEEN, APART, FOUND } verdict;

static const vec3 START[SIDES][POINTS] = {
    { { -2.0, 0.35, 0 }, { -1.6, 0.75, 0 }, { -1.1, 0.85, 0 }, { -0.6, 0.6, 0 }, { -0.2, 0.15, 0 },
      { 0.3, -0.1, 0 }, { 0.85, 0.0, 0 }, { 1.3, 0.35, 0 }, { 1.65, 0.8, 0 } },
    { { -1.75, -0.75, 0 }, { -1.3, -1.05, 0 }, { -0.75, -1.1, 0 }, { -0.3, -0.8, 0 }, { 0.05, -0.35, 0 },
      { 0.5, -0.75, 0 }, { 1.0, -1.0, 0 }, { 1.5, -0.85, 0 }, { 1.9, -0.45, 0 } } };
static const live_colour COLOUR[SIDES] = { LIVE_BLUE, LIVE_GREEN };

static vec3 at[SIDES][POINTS];
static sphere_tree tree[SIDES];
static int line[SIDES][LINKS], first[SIDES][NODES], last[SIDES][NODES];
static verdict told[LINKS][LINKS];              // by places in the lines
static leaf_pair waiting[2 * NODES];            // nodes that are to be compared
static leaf_pair now;
static int left, compared, spared, found, frame;
static bool is_ready;

// The leaves below a node stand side by side in the table.
static int count_below(int side, int node, int place)
{
    const tree_node *n = &tree[side].node[node];
    first[side][node] = place;
    if (node < LINKS) line[side][place++] = node;
    else
        for (int c = 0; c < 2; c++) place = count_below(side, n->child[c], place);
    last[side][node] = place;
    return place;
}

static const sphere *ball(int side, int node)
{
    return &tree[side].node[node].ball;
}

static bool is_near(leaf_pair p)
{
    real near = ball(0, p.a)->radius + ball(1, p.b)->radius + live_dial(MARGIN);
    return vec3_distance(ball(0, p.a)->center, ball(1, p.b)->center) < near;
}

static bool opens_a(leaf_pair p)
{
    return p.b < LINKS || (p.a >= LINKS && ball(0, p.a)->radius >= ball(1, p.b)->radius);
}

static void mark(leaf_pair p, verdict what)
{
    for (int i = first[0][p.a]; i < last[0][p.a]; i++)
        for (int k = first[1][p.b]; k < last[1][p.b]; k++) told[i][k] = what;
}

static void tell(void)
{
    int pairs = (last[0][now.a] - first[0][now.a]) * (last[1][now.b] - first[1][now.b]);
    bool is_leaf = now.a < LINKS && now.b < LINKS;
    if (left < 0)
        live_say("%d comparisons for %d pairs: %d near, and %d left out.", compared, LINKS * LINKS, found, spared);
    else if (!is_near(now))
        live_say("Comparison %d: apart. That leaves out %d pair%s at one stroke.", compared, pairs, pairs == 1 ? "" : "s");
    else if (is_leaf) live_say("Comparison %d: two links are near each other.", compared);
    else live_say("Comparison %d: near. The larger sphere is opened.", compared);
    live_light(left < 0 ? "" : !is_near(now) ? ">= near * near" : is_leaf ? "report(q, i, j)"
               : opens_a(now) ? "open_node(q, q->a" : "open_node(q, q->b");
}

// As compare() goes on: what it calls first is compared first.
static void next(void)
{
    frame = 0;
    if (left == 0) { left = -1; return; }
    now = waiting[--left];
    compared++;
    if (!is_near(now)) {
        spared += (last[0][now.a] - first[0][now.a]) * (last[1][now.b] - first[1][now.b]);
        mark(now, APART);
    } else if (now.a < LINKS && now.b < LINKS) {
        found++;
        mark(now, FOUND);
    } else {
        int side = opens_a(now) ? 0 : 1;
        const int *child = tree[side].node[side ? now.b : now.a].child;
        for (int c = 1; c >= 0; c--)
            waiting[left++] = side ? (leaf_pair){ now.a, child[c] } : (leaf_pair){ child[c], now.b };
    }
}

static void restart(void)
{
    for (int side = 0; side < SIDES; side++) sphere_tree_refresh(&tree[side], at[side]);
    waiting[0] = (leaf_pair){ NODES - 1, NODES - 1 };
    left = 1;
    compared = spared = found = 0;
    mark(waiting[0], UNSEEN);
    next();
}

static void begin(void)
{
    leaf_feature leaf[LINKS];
    for (int k = 0; k < LINKS; k++) leaf[k] = (leaf_feature){ 2, { k, k + 1 } };
    is_ready = true;
    for (int side = 0; side < SIDES; side++) {
        memcpy(at[side], START[side], sizeof at[side]);
        sphere_tree_free(&tree[side]);
        is_ready &= sphere_tree_build(&tree[side], TREE_LAYERED, at[side], leaf, LINKS, 0.05, 0).ok;
        if (is_ready) count_below(side, NODES - 1, 0);
    }
    if (is_ready) restart();
}

static void step(void)
{
    if (!is_ready) return;
    if (++frame >= (left < 0 ? REST : PACE)) {
        if (left < 0) restart();
        else next();
    }
    tell();
}

static void turn(int dial)
{
    (void)dial;
    if (is_ready) restart();
}

// A chain is moved by its middle.
static void move(int side, vec3 to)
{
    vec3 by = vec3_sub(vec3_make(to.x, to.y, 0), at[side][LINKS / 2]);
    for (int k = 0; k < POINTS; k++) at[side][k] = vec3_add(at[side][k], by);
    if (is_ready) restart();
}

// --- Drawing ----------------------------------------------------------------------
static void draw_chain(int side)
{
    for (int k = 0; k < LINKS; k++) {
        bool is_met = false;
        for (int i = 0; i < LINKS; i++)
            for (int j = 0; j < LINKS; j++)
                is_met |= told[i][j] == FOUND && line[side][side ? j : i] == k;
        live_line(is_met ? LIVE_RED : COLOUR[side], &at[side][k], 2);
    }
    for (int k = 0; k < POINTS; k++) live_dot(COLOUR[side], at[side][k], 3);
    live_handle(side, COLOUR[side], at[side][LINKS / 2], side ? "the lower chain" : "the upper chain");
}

static void draw_block(live_colour c, int x, int y, int right, int high, bool is_filled)
{
    vec3 corner[5] = { { x, -y, 0 }, { right, -y, 0 }, { right, -high, 0 }, { x, -high, 0 }, { x, -y, 0 } };
    if (is_filled) live_area(c, corner, 4);
    else live_line(c, corner, 5);
}

static void draw_table(void)
{
    live_pane(TABLE);
    for (int i = 0; i < LINKS; i++)
        for (int k = 0; k < LINKS; k++) {
            if (told[i][k] == UNSEEN) live_dot(LIVE_INK, vec3_make(i + 0.5, -k - 0.5, 0), 3);
            else draw_block(told[i][k] == FOUND ? LIVE_RED : LIVE_GREY, i, k, i + 1, k + 1, true);
        }
    draw_block(LIVE_RULE, 0, 0, LINKS, LINKS, false);
    if (left >= 0)
        draw_block(LIVE_ORANGE, first[0][now.a], first[1][now.b], last[0][now.a], last[1][now.b], false);
    live_label(LIVE_BLUE, vec3_make(0, 0.25, 0), "links of the upper chain");
    live_label(LIVE_GREEN, vec3_make(0, -LINKS - 0.75, 0), "downwards: the lower chain");
}

static void draw(void)
{
    if (!is_ready) return;
    live_pane(CHAINS);
    if (left >= 0) {
        live_colour c = is_near(now) ? LIVE_ORANGE : LIVE_GREY;
        live_circle(c, ball(0, now.a)->center, ball(0, now.a)->radius);
        live_circle(c, ball(1, now.b)->center, ball(1, now.b)->radius);
    }
    for (int side = 0; side < SIDES; side++) draw_chain(side);
    draw_table();
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, told, sizeof told);
    h = live_hash(h, (int[]){ left, compared, spared, found }, 4 * sizeof(int));
    for (int side = 0; side < SIDES && is_ready; side++) h = live_hash(h, ball(side, NODES - 1), sizeof(sphere));
    return h;
}

const live_figure figure = {
    .name = "descend",
    .says = "Two chains of eight links with two spheres that are compared, and a table of all pairs of links, in which blocks are left out",
    .code = "lib/paper/sphere_tree.c compare",
    .pane = { [CHAINS] = { -2.45, -2.25, 4.9, 4.2 }, [TABLE] = { -0.4, -8.9, 9.2, 9.7 } },
    .dial = { [MARGIN] = { "margin", "m", 0, 0.6, 0.02, 0, NULL, false } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .turn = turn, .move = move,
};
