// margin.c - a pair that was far apart need not be asked until both paths together have
// used up the distance (chapter 14).

#include "live.h"

enum { MARGIN };                                // dial
enum { BALLS = 22, FLASH = 10, MEAN = 120 };    // frames
static const real RADIUS = 0.09, WIDE = 3, HIGH = 1.35;     // m; halves of the room
static const real SPEED = 0.9 / 60, DARTED = 0.02;          // m a frame; a tenth of a margin

static vec3 at[BALLS], go[BALLS];               // m, m a frame
static real path[BALLS];                        // m, so far each has gone
static real left_until[BALLS];                  // m, of its path and that of ball 0
static int  asked_ago[BALLS], frame, asked, missed;
static real mean;                               // pairs asked a frame, of the last frames

// From 0 to below 1: the places of a number that never repeats.
static real share(int k, real by) { return k * by - floor(k * by); }

static real room_for(int k) { return path[0] + path[k]; }
static real gap(int k) { return vec3_distance(at[0], at[k]) - 2 * RADIUS; }
static real margin(void) { return live_dial(MARGIN) / 100; }

// How far is it?  Until both have gone as far it will not be within the margin; and
// what is within it is asked again soon.
static void ask(int k)
{
    left_until[k] = room_for(k) + real_max(gap(k) - margin(), DARTED * margin());
    asked_ago[k] = 0;
    asked++;
}

static void begin(void)
{
    frame = missed = 0;
    mean = 0;
    for (int k = 0; k < BALLS; k++) {
        at[k] = vec3_make((2 * share(k, 0.6180339887) - 1) * (WIDE - 0.3), (2 * share(k, 0.7548776662) - 1) * (HIGH - 0.2), 0);
        go[k] = vec3_scale(SPEED * (0.4 + share(k, 0.5698402909)), vec3_unit(vec3_make(share(k, 0.7320508076) - 0.5, share(k, 0.4142135624) - 0.5, 0)));
        path[k] = 0;
    }
    at[0] = vec3_make(0, 0, 0);
    for (int k = 1; k < BALLS; k++) ask(k);
    asked = 0;
}

// --- Frames -----------------------------------------------------------------------
static void fly(int k)
{
    at[k] = vec3_add(at[k], go[k]);
    if (fabs(at[k].x) > WIDE - RADIUS && at[k].x * go[k].x > 0) go[k].x = -go[k].x;
    if (fabs(at[k].y) > HIGH - RADIUS && at[k].y * go[k].y > 0) go[k].y = -go[k].y;
    path[k] += vec3_length(go[k]);
}

// Balls of one mass exchange what they have along the line between them.
static void bounce(int a, int b)
{
    vec3 n = vec3_unit(vec3_sub(at[b], at[a]));
    real closing = vec3_dot(n, vec3_sub(go[a], go[b]));
    if (vec3_distance(at[a], at[b]) > 2 * RADIUS || closing <= 0) return;
    go[a] = vec3_add_scaled(go[a], -closing, n);
    go[b] = vec3_add_scaled(go[b], closing, n);
}

static void step(void)
{
    asked = 0;
    frame++;
    for (int k = 0; k < BALLS; k++)
        if (k != live_held()) fly(k);
    for (int a = 0; a < BALLS; a++)
        for (int b = a + 1; b < BALLS; b++) bounce(a, b);
    for (int k = 1; k < BALLS; k++) {
        asked_ago[k]++;
        if (room_for(k) >= left_until[k]) ask(k);
        else missed += gap(k) < margin() - DARTED * margin();
    }
    mean += (asked - mean) / int_min(frame, MEAN);
}

static void measure(void)
{
    live_say("Of %d pairs with the blue ball %.1f are asked in a frame. Pairs within the margin that were not known: %d.", BALLS - 1, mean, missed);
}

static void move(int number, vec3 to)
{
    vec3 where = { real_max(-WIDE + RADIUS, real_min(WIDE - RADIUS, to.x)), real_max(-HIGH + RADIUS, real_min(HIGH - RADIUS, to.y)), 0 };
    path[number] += vec3_distance(where, at[number]);
    at[number] = where;
}

// --- Drawing ----------------------------------------------------------------------
// As much of the way to it as may still be used up; orange for a while when it is asked.
static void draw_fuse(int k)
{
    real d = vec3_distance(at[0], at[k]), rest = real_max(0, real_min(1, (left_until[k] - room_for(k)) / real_max(d, 1e-9)));
    vec3 end[2] = { at[k], vec3_add_scaled(at[k], rest, vec3_sub(at[0], at[k])) };
    bool is_new = asked_ago[k] < FLASH;
    live_line(is_new ? LIVE_ORANGE : LIVE_GREY, end, 2);
    live_circle(gap(k) < margin() ? LIVE_RED : is_new ? LIVE_ORANGE : LIVE_GREY, at[k], RADIUS);
}

static void draw(void)
{
    if (margin() > 0) live_circle(LIVE_BLUE, at[0], 2 * RADIUS + margin());
    for (int k = 1; k < BALLS; k++) draw_fuse(k);
    live_circle(LIVE_BLUE, at[0], RADIUS);
    live_handle(0, LIVE_BLUE, at[0], "the blue ball");
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, at, sizeof at);
    return live_hash(h, left_until, sizeof left_until);
}

const live_figure figure = {
    .name = "margin",
    .says = "Balls fly about; from each a line towards the blue one grows shorter as both move, and when it is used up the pair is asked again",
    .pane = { { -3.05, -1.4, 6.1, 2.8 } },
    .dial = { [MARGIN] = { "margin", "cm", 0, 60, 1, 15, NULL, true } },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash, .move = move,
};
