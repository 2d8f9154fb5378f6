// prune.c - sweep and prune, ball by ball along the line, with the line of the sweep
// lit (chapter 14).

#include "live.h"
#include "sphere.h"
#include "table.h"

enum { BALLS = 9, PACE = 22, REST = 60 };

static const sphere START[BALLS] = {
    { { -2.2, 0.5, 0 }, 0.42 }, { { -1.45, 1.35, 0 }, 0.3 }, { { -1.1, 0.25, 0 }, 0.48 }, { { -0.35, 1.1, 0 }, 0.36 },
    { { 0.15, 0.3, 0 }, 0.4 }, { { 0.75, 0.85, 0 }, 0.45 }, { { 1.5, 1.4, 0 }, 0.28 }, { { 1.75, 0.35, 0 }, 0.34 },
    { { 2.4, 1.0, 0 }, 0.38 }
};
static sphere ball[BALLS];
static int line[BALLS];                         // from left to right
static int me, other, frame, compared, met;     // places in the line
static bool is_asked;                           // other begins before me ends

static real left_of(int place)
{
    return ball[line[place]].center.x - ball[line[place]].radius;
}

static real right_of(int place)
{
    return ball[line[place]].center.x + ball[line[place]].radius;
}

static void find(void)
{
    for (int k = 1; k < BALLS; k++)
        for (int i = k; i > 0 && left_of(i - 1) > left_of(i); i--) SWAP(int, line[i - 1], line[i]);
    is_asked = left_of(1) <= right_of(0);
    me = compared = met = frame = 0;
    other = 1;
}

// The boxes around them: what the little program compares.
static bool meets(int i, int j)
{
    sphere a = ball[line[i]], b = ball[line[j]];
    real r = a.radius + b.radius;
    return fabs(a.center.x - b.center.x) <= r && fabs(a.center.y - b.center.y) <= r;
}

static void tell(void)
{
    static const int all = BALLS * (BALLS - 1) / 2;
    if (me >= BALLS - 1)
        live_say("%d of %d pairs were compared, and %d overlap.", compared, all, met);
    else if (!is_asked)
        live_say("The next box begins where this one has ended already: it and all after it are left out. %d compared so far.", compared);
    else
        live_say("The next box begins before this one ends: compare them. They are %s. %d compared so far.", meets(me, other) ? "overlapping" : "apart", compared);
    live_light(me >= BALLS - 1 ? "" : !is_asked || frame < PACE / 2 ? "for (; b < list + n" : meets(me, other) ? "pairs[count++]" : "if (!boxes_apart");
}

static void begin(void)
{
    for (int k = 0; k < BALLS; k++) {
        ball[k] = START[k];
        line[k] = k;
    }
    find();
    tell();
}

static void next(void)
{
    frame = 0;
    if (me >= BALLS - 1) { find(); return; }
    compared += is_asked;
    met += is_asked && meets(me, other);
    if (is_asked && other + 1 < BALLS) other++;
    else other = ++me + 1;
    is_asked = other < BALLS && left_of(other) <= right_of(me);
}

static void step(void)
{
    if (++frame >= (me >= BALLS - 1 ? REST : PACE)) next();
    tell();
}

static void move(int number, vec3 to)
{
    ball[number].center = vec3_make(to.x, real_max(to.y, 0.1), 0);
    find();
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
    real y = -1.3 + 0.1 * place;
    live_colour c = colour_of(place);
    live_line(c, (vec3[]){ { left_of(place), y, 0 }, { right_of(place), y, 0 } }, 2);
    live_dot(c, vec3_make(left_of(place), y, 0), 3);
}

static void draw_box(int place)
{
    real r = ball[line[place]].radius, low = ball[line[place]].center.y - r, high = low + 2 * r;
    real left = left_of(place), right = right_of(place);
    live_line(colour_of(place), (vec3[]){ { left, low, 0 }, { right, low, 0 }, { right, high, 0 }, { left, high, 0 }, { left, low, 0 } }, 5);
}

static void draw(void)
{
    for (int k = 0; k < BALLS; k++) {
        live_circle(colour_of(k), ball[line[k]].center, ball[line[k]].radius);
        draw_box(k);
        draw_shadow(k);
    }
    if (me < BALLS - 1)
        live_dashes(LIVE_ORANGE, (vec3[]){ { right_of(me), -1.4, 0 }, { right_of(me), ball[line[me]].center.y, 0 } }, 2);
    for (int k = 0; k < BALLS; k++) live_handle(k, LIVE_INK, ball[k].center, "ball");
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, line, sizeof line);
    h = live_hash(h, ball, sizeof ball);
    return live_hash(h, (int[]){ me, other, compared, met }, 4 * sizeof(int));
}

const live_figure figure = {
    .name = "prune",
    .says = "Nine balls, the boxes around them and their shadows on a line, sorted by where they begin; one box after the other is compared with those that begin before it ends",
    .code = "chapters/little/18-pairs.c boxes_sweep",
    .pane = { { -3.1, -1.45, 6.2, 3.35 } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move,
};
