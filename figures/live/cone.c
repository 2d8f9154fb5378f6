// cone.c - one particle, one step, one floor: what the push and its friction may undo
// (chapter 7).

#include "live.h"
#include "response.h"

enum { FRICTION };                              // dial
static const real WIDE = 4;                     // m, of the floor that is drawn
static vec3 before = { -0.9, 0.55, 0 }, went = { 0.75, -0.6, 0 };
static particle after;
static bool is_led;                             // by the reader, and not by itself
static int frame;

static void part(void)
{
    after = (particle){ went, before, 1 };
    feature_contact c = { .a = { .count = 1, .vertex = { 0 }, .weight = { 1 } }, .normal = { 0, 1, 0 } };
    response_separate(&c, &after, live_dial(FRICTION));
}

static void tell(void)
{
    real depth = real_max(0, -went.y), slid = fabs(went.x - before.x), left = fabs(after.position.x - before.x);
    if (depth <= 0) live_say("It does not reach the floor: nothing is undone.");
    else if (left < 1e-9) live_say("d = %.2f m, it slid by s = %.2f m, and μ d = %.2f m is enough: it sticks.", depth, slid, live_dial(FRICTION) * depth);
    else live_say("d = %.2f m, it slid by s = %.2f m, and μ d = %.2f m of that is undone: %.2f m are left.", depth, slid,
                  live_dial(FRICTION) * depth, left);
}

static void begin(void)
{
    before = vec3_make(-0.9, 0.55, 0), went = vec3_make(0.75, -0.6, 0);
    frame = 0, is_led = false;
    part();
    tell();
}

// By itself it comes in ever more flatly, and steeply again.
static void step(void)
{
    frame++;
    int turn = frame % 240;
    real t = (turn < 120 ? turn : 240 - turn) / 120.0;
    if (!is_led) went = vec3_make(-0.75 + 2.7 * t, -0.75 + 0.3 * t, 0);
    part();
    tell();
}

static void move(int number, vec3 to)
{
    is_led = true;
    if (number == 0) before = vec3_make(to.x, real_max(0.05, to.y), 0);
    else             went = vec3_make(to.x, to.y, 0);
    part();
    tell();
}

// --- Drawing ----------------------------------------------------------------------
static void draw(void)
{
    real depth = real_max(0, -went.y), reach = live_dial(FRICTION) * depth;
    vec3 up = { went.x, 0, 0 }, ground[4] = { { -WIDE, 0, 0 }, { WIDE, 0, 0 }, { WIDE, -3, 0 }, { -WIDE, -3, 0 } };
    live_area(LIVE_GREY, ground, 4);
    if (depth > 0) live_area(LIVE_ORANGE, (vec3[]){ went, { up.x + reach, 0, 0 }, { up.x - reach, 0, 0 } }, 3);
    live_line(LIVE_RULE, (vec3[]){ { -WIDE, 0, 0 }, { WIDE, 0, 0 } }, 2);
    live_dashes(LIVE_QUIET, (vec3[]){ before, went }, 2);
    if (depth > 0) live_dashes(LIVE_QUIET, (vec3[]){ went, up }, 2);
    if (depth > 0) live_arrow(LIVE_GREEN, went, after.position);
    live_dot(LIVE_GREEN, after.position, 7);
    if (depth > 0.15) live_label(LIVE_QUIET, vec3_make(up.x + 0.06, -0.5 * depth, 0), "d");
    live_handle(0, LIVE_INK, before, "previous");
    live_handle(1, LIVE_BLUE, went, "position before the push");
    live_label(LIVE_INK, vec3_add(before, vec3_make(0.13, 0.12, 0)), "previous");
    live_label(LIVE_BLUE, vec3_add(went, vec3_make(0.13, -0.2, 0)), "position");
    live_label(LIVE_GREEN, vec3_add(after.position, vec3_make(-0.2, 0.14, 0)), "pushed");
}

static unsigned long long hash(void)
{
    return live_hash(LIVE_HASH, &after.position, sizeof(vec3));
}

const live_figure figure = {
    .name = "cone",
    .says = "A particle has moved into the floor and is pushed out; a cone on its tip shows which places friction may take it to",
    .pane = { { -1.9, -1.1, 4.6, 2.1 } },
    .dial = { [FRICTION] = { "friction, μ", NULL, 0, 1.5, 0.05, 0.6, NULL, false } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move,
};
