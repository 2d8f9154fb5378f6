// swing.c - a mass on a spring, and the point on a circle whose shadow it is
// (chapter 00b).

#include "live.h"

enum { STIFFNESS };                     // dial
enum { ENERGY };                        // chart
enum { MOTION, STORED, SUM };           // its lines
enum { STEPS = 200, TRAIL = 240, TURNS = 14 };
static const real DT = 1.0 / 60 / STEPS, PI = 3.14159265358979323846;
static const real M = 1, START = 1;     // kg, m
static const real WALL = -2.2, LINE = -1.45;

static real x, v, start;                // m, m/s, m
static vec3 twin;                       // on the circle
static vec3 trail[TRAIL];
static int trails;

static real omega(void) { return sqrt(live_dial(STIFFNESS) / M); }

static void begin_at(real at)
{
    x = start = at;
    v = 0;
    twin = vec3_make(at, 0, 0);
    trails = 0;
}

static void begin(void) { begin_at(start != 0 ? start : START); }

// An arc of omega DT is so short that it is straight; then back onto the circle.
static void turn_twin(void)
{
    vec3 across = { -twin.y, twin.x, 0 };
    twin = vec3_scale(fabs(start), vec3_unit(vec3_add_scaled(twin, omega() * DT, across)));
}

static void step(void)
{
    for (int k = 0; k < STEPS; k++) {
        v -= live_dial(STIFFNESS) * x / M * DT;
        x += v * DT;
        turn_twin();
    }
    if (trails == TRAIL)
        for (int k = 1; k < TRAIL; k++) trail[k - 1] = trail[k];
    trail[int_min(trails, TRAIL - 1)] = vec3_make(x, 0, 0);
    trails = int_min(trails + 1, TRAIL);
}

static void measure(void)
{
    real motion = M * v * v / 2, stored = live_dial(STIFFNESS) * x * x / 2;
    live_value(ENERGY, MOTION, motion);
    live_value(ENERGY, STORED, stored);
    live_value(ENERGY, SUM, motion + stored);
    live_say("ω = √(%.0f N/m / 1 kg) = %.2f rad/s: a period takes %.2f s, or %.0f steps of 1/60 s.", live_dial(STIFFNESS), omega(),
             2 * PI / omega(), 2 * PI / omega() * 60);
}

static void draw_spring(void)
{
    vec3 at[TURNS + 1];
    for (int k = 0; k <= TURNS; k++)
        at[k] = vec3_make(WALL + (x - WALL) * k / TURNS, LINE + (k % TURNS == 0 ? 0 : k % 2 ? 0.09 : -0.09), 0);
    live_line(LIVE_INK, at, TURNS + 1);
    live_line(LIVE_INK, (vec3[]){ { WALL, LINE - 0.2, 0 }, { WALL, LINE + 0.2, 0 } }, 2);
}

// To the right, as a strip of paper that moves on.
static void draw_track(void)
{
    vec3 at[TRAIL];
    for (int k = 0; k < trails; k++) at[k] = vec3_make(1.9 + 2.4 * k / TRAIL, trail[trails - 1 - k].x, 0);
    live_line(LIVE_RULE, (vec3[]){ { 1.9, 0, 0 }, { 4.3, 0, 0 } }, 2);
    live_line(LIVE_GREEN, at, trails);
    live_label(LIVE_QUIET, vec3_make(3.35, 1.15, 0), "x over time");
}

static void draw(void)
{
    live_circle(LIVE_RULE, vec3_make(0, 0, 0), fabs(start));
    live_dashes(LIVE_QUIET, (vec3[]){ twin, { twin.x, LINE, 0 } }, 2);
    live_line(LIVE_RULE, (vec3[]){ { 0, 0, 0 }, twin }, 2);
    live_arrow(LIVE_ORANGE, twin, vec3_scale(0.55, twin));
    live_dot(LIVE_INK, twin, 6);
    draw_spring();
    draw_track();
    live_handle(0, LIVE_GREEN, vec3_make(x, LINE, 0), "the mass");
}

static void move(int number, vec3 to)
{
    (void)number;
    real at = real_max(-1.3, real_min(1.3, to.x));
    begin_at(fabs(at) < 0.1 ? 0.1 : at);
}

static unsigned long long hash(void)
{
    real state[] = { x, v, twin.x, twin.y };
    return live_hash(LIVE_HASH, state, sizeof state);
}

const live_figure figure = {
    .name = "swing",
    .says = "A mass swings on a spring; above it a point runs round a circle, always straight over the mass",
    .pane = { { -2.4, -1.8, 6.8, 3.3 } },
    .dial = { [STIFFNESS] = { "stiffness, N/m", NULL, 2, 400, 2, 50, NULL, false } },
    .chart = { [ENERGY] = { "energy", "J", { "of motion", "in the spring", "sum" }, 0, 30, false, false, NULL } },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash, .move = move,
};
