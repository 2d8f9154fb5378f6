// crowd.c - balls fly about in a plane: which of them are compared, on one axis
// and in lanes? (chapter 14)

#include "broad.h"
#include "live.h"
#include "random.h"

#include <string.h>

enum { ROOM, BALLS, RADIUS, SPEED };            // dials
enum { EVERY, AXIS, LANES, FOUND };             // lines of the chart
enum { MOST = 1000, PAIRS = 100000 };
static const vec3 HALF[] = { { 2.5, 1.4, 0 }, { 2.5, 0.15, 0 }, { 0.2, 1.4, 0 } };  // m

typedef enum { ALONE, ON_AXIS, IN_LANE, TOUCHES } relation;     // to the watched ball

static broad sorted;
static sphere ball[MOST];
static vec3 velocity[MOST];
static char moves[MOST];
static relation to_watched[MOST];
static int pair[PAIRS][2], plain[PAIRS][2];
static int balls, found, listed, by_axis, by_lane, frame;
static bool is_equal;

static void begin(void)
{
    unsigned long long seed = 5;
    vec3 half = HALF[live_choice(ROOM)];
    broad_free(&sorted);
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
    if (!broad_grow(&sorted, balls).ok) balls = 0;
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

// In lanes: as the library's walk goes, place by place.
static void count_lanes(void)
{
    by_lane = 0;
    for (int l = 0; l < sorted.lanes[0] * sorted.lanes[1]; l++)
        for (int i = sorted.lane[l]; i < sorted.lane[l + 1]; i++)
            for (int k = i + 1; k < sorted.lane[l + 1]; k++) {
                if (sorted.start[k] > sorted.line[i].center.x + sorted.line[i].radius) break;
                by_lane++;
                relate(sorted.who[i], sorted.who[k], IN_LANE);
            }
}

static void step(void)
{
    fly();
    frame++;
    found = broad_pairs(&sorted, ball, moves, pair, PAIRS);
    listed = int_min(found, PAIRS);     // what has no room is only counted
}

static void measure(void)
{
    int all = broad_pairs_all(ball, moves, balls, plain, PAIRS);
    is_equal = all == found && memcmp(pair, plain, (size_t)listed * sizeof *pair) == 0;
    memset(to_watched, 0, sizeof to_watched);
    count_axis();
    count_lanes();
    for (int k = 0; k < listed; k++) relate(pair[k][0], pair[k][1], TOUCHES);
    live_value(0, EVERY, balls * (balls - 1) / 2);
    live_value(0, AXIS, by_axis);
    live_value(0, LANES, by_lane);
    live_value(0, FOUND, found);
    live_say("%d lane%s. The sorted search and the one that compares every pair find %s.",
             sorted.lanes[0], sorted.lanes[0] == 1 ? "" : "s", is_equal ? "the same pairs" : "different pairs");
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

// The lanes, side by side along y, in which the watched ball stands.
static void draw_lanes(void)
{
    real low = HUGE_VAL, high = -HUGE_VAL;
    if (!sorted.lane || sorted.lanes[0] <= 1) return;
    for (int i = 0; i < balls; i++) {
        low = real_min(low, ball[i].center.y - ball[i].radius);
        high = real_max(high, ball[i].center.y + ball[i].radius);
    }
    real lane = (high - low) / sorted.lanes[0];
    draw_box(LIVE_ORANGE, -WIDE, low + sorted.reach[0][0].first * lane, WIDE, low + (sorted.reach[0][0].last + 1) * lane);
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
    draw_lanes();
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
    .chart = { { "comparisons a frame", NULL, { "every pair", "one axis", "lanes", "pairs found" }, 10, 10000, true, false, NULL } },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash, .move = move,
};
