// prune.c - sweep and prune, ball by ball along the line, with the line of the sweep
// lit (chapter 14).

#include "broad.h"
#include "live.h"

enum { BALLS = 9, PAIRS = BALLS * BALLS / 2, PACE = 22, REST = 60 };

static const sphere START[BALLS] = {
    { { -2.2, 0.5, 0 }, 0.42 }, { { -1.45, 1.35, 0 }, 0.3 }, { { -1.1, 0.25, 0 }, 0.48 }, { { -0.35, 1.1, 0 }, 0.36 },
    { { 0.15, 0.3, 0 }, 0.4 }, { { 0.75, 0.85, 0 }, 0.45 }, { { 1.5, 1.4, 0 }, 0.28 }, { { 1.75, 0.35, 0 }, 0.34 },
    { { 2.4, 1.0, 0 }, 0.38 }
};
static sphere ball[BALLS];
static broad line;
static bool is_ready;
static int pair[PAIRS][2], pairs;
static int me, other, frame, compared;          // places in the line
static bool is_asked;                           // other begins before me ends

static void find(void)
{
    char moves[BALLS];
    for (int k = 0; k < BALLS; k++) moves[k] = 1;
    pairs = broad_pairs(&line, ball, moves, pair, PAIRS);
    is_asked = line.start[1] <= line.high[line.who[0]];
    me = compared = frame = 0;
    other = 1;
}

static bool meets(int i, int j)
{
    int a = int_min(line.who[i], line.who[j]), b = int_max(line.who[i], line.who[j]);
    for (int k = 0; k < pairs; k++)
        if (pair[k][0] == a && pair[k][1] == b) return true;
    return false;
}

static void tell(void)
{
    static const int all = BALLS * (BALLS - 1) / 2;
    if (me >= BALLS - 1)
        live_say("%d of %d pairs were compared, and %d overlap.", compared, all, pairs);
    else if (!is_asked)
        live_say("The next ball begins where this one has ended already: it and all after it are left out. %d compared so far.", compared);
    else
        live_say("The next ball begins before this one ends: compare them. They are %s. %d compared so far.", meets(me, other) ? "overlapping" : "apart", compared);
    live_light(me >= BALLS - 1 ? "" : !is_asked ? "for (int j = i + 1" : frame < PACE / 2 ? "for (int j = i + 1"
               : meets(me, other) ? "meet(s, lane, me" : "if (balls_meet(ball, s->line[j]))");
}

static void begin(void)
{
    for (int k = 0; k < BALLS; k++) ball[k] = START[k];
    if (!is_ready) is_ready = broad_grow(&line, BALLS).ok;
    if (is_ready) find();
    tell();
}

static void next(void)
{
    frame = 0;
    if (me >= BALLS - 1) { find(); return; }
    compared += is_asked;
    if (is_asked && other + 1 < BALLS) other++;
    else other = ++me + 1;
    is_asked = other < BALLS && line.start[other] <= line.high[line.who[me]];
}

static void step(void)
{
    if (!is_ready) return;
    if (++frame >= (me >= BALLS - 1 ? REST : PACE)) next();
    tell();
}

static void move(int number, vec3 to)
{
    ball[number].center = vec3_make(to.x, real_max(to.y, 0.1), 0);
    if (is_ready) find();
    tell();
}

// --- Drawing ----------------------------------------------------------------------
static live_colour colour_of(int place)
{
    if (me >= BALLS - 1) return LIVE_BLUE;
    if (place == me) return LIVE_ORANGE;
    if (place == other && is_asked) return meets(me, other) ? LIVE_RED : LIVE_GREEN;
    return place < me ? LIVE_GREY : LIVE_BLUE;
}

// In the order of the line, one over the other, so that overlaps can be seen.
static void draw_shadow(int place)
{
    int b = line.who[place];
    real y = -1.3 + 0.1 * place;
    live_colour c = colour_of(place);
    live_line(c, (vec3[]){ { line.low[b], y, 0 }, { line.high[b], y, 0 } }, 2);
    live_dot(c, vec3_make(line.low[b], y, 0), 3);
}

static void draw(void)
{
    if (!is_ready) return;
    for (int k = 0; k < BALLS; k++) {
        live_circle(colour_of(k), ball[line.who[k]].center, ball[line.who[k]].radius);
        draw_shadow(k);
    }
    if (me < BALLS - 1) {
        real x = line.high[line.who[me]];
        live_dashes(LIVE_ORANGE, (vec3[]){ { x, -1.4, 0 }, { x, ball[line.who[me]].center.y, 0 } }, 2);
    }
    for (int k = 0; k < pairs; k++)
        live_line(LIVE_RED, (vec3[]){ ball[pair[k][0]].center, ball[pair[k][1]].center }, 2);
    for (int k = 0; k < BALLS; k++) live_handle(k, LIVE_INK, ball[k].center, "ball");
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, line.low, BALLS * sizeof(real));
    h = live_hash(h, pair, (size_t)pairs * sizeof *pair);
    return live_hash(h, (int[]){ me, other, compared }, 3 * sizeof(int));
}

const live_figure figure = {
    .name = "prune",
    .says = "Nine balls and their shadows on a line, sorted by where they begin; one ball after the other is compared with those that begin before it ends",
    .code = "lib/broad/broad.c sweep_lane",
    .pane = { { -3.1, -1.45, 6.2, 3.35 } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move,
};
