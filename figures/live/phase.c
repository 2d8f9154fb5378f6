// phase.c - one mass on one spring, with fewer and fewer steps a swing: the curve of
// place and speed closes, until it does not (chapter 2).

#include "live.h"
#include "verlet.h"

#include <math.h>

enum { STEP };                                  // dial: omega times dt
enum { PHASE, TIME };                           // panes
enum { KEPT = 160, REST = 90 };
static const real PACE = 14;                    // frames in a time of 1 / omega
static const real FAR = 40;                     // m, where nothing is seen any more

static vec3 start = { 1, 0, 0 };                // x, and v / omega, both in m
static particle p;
static vec3 trail[KEPT];                        // time, x, v / omega: of each step
static int count, frame, until;                 // steps; frames; to the next step
static bool is_gone;

// The force of a spring that swings with omega = 1.
static void swing(void)
{
    vec3 none = { 0, 0, 0 }, pull = vec3_scale(-1, p.position), was = p.previous;
    real dt = live_dial(STEP);
    verlet_step(&p, 1, none, &pull, dt);
    vec3 speed = vec3_scale(1 / (2 * dt), vec3_sub(p.position, was));
    trail[count % KEPT] = vec3_make(count * dt, p.previous.x, speed.x);
    count++;
    is_gone = !(fabs(p.position.x) < FAR);
}

static void tell(void)
{
    real dt = live_dial(STEP), high = dt < 2 ? sqrt(1 - dt * dt / 4) : 0;
    if (is_gone) live_say("Gone after %d steps: each swing was longer than the last.", count);
    else if (dt < 2) live_say("%.1f steps a swing. The curve closes; it is %.0f %% as high as it is wide.", 6.2832 / dt, 100 * high);
    else live_say("Three steps a swing are too few: each throws the mass further than it was.");
}

static void begin(void)
{
    vec3 away = { -start.x, 0, 0 };
    p = particle_start(vec3_make(start.x, 0, 0), vec3_make(start.y, 0, 0), away, 1, live_dial(STEP));
    count = frame = until = 0;
    is_gone = false;
    tell();
}

static void step(void)
{
    if (is_gone && ++frame == REST) begin();
    if (!is_gone && --until <= 0) {
        swing();
        until = (int)real_max(1, PACE * live_dial(STEP));
    }
    tell();
}

static void move(int number, vec3 to)
{
    (void)number;
    start = vec3_make(to.x, to.y, 0);
    begin();
}

// --- Drawing ----------------------------------------------------------------------
static const vec3 *kept(int k)                  // the k-th of the last ones
{
    return &trail[(count > KEPT ? count + k : k) % KEPT];
}

static void draw_phase(int n)
{
    vec3 line[KEPT];
    live_pane(PHASE);
    live_line(LIVE_RULE, (vec3[]){ { -2.2, 0, 0 }, { 2.2, 0, 0 } }, 2);
    live_line(LIVE_RULE, (vec3[]){ { 0, -2.2, 0 }, { 0, 2.2, 0 } }, 2);
    for (int k = 0; k < n; k++) line[k] = vec3_make(kept(k)->y, kept(k)->z, 0);
    live_line(LIVE_BLUE, line, n);
    for (int k = 0; k < n; k++) live_dot(k == n - 1 ? LIVE_ORANGE : LIVE_BLUE, line[k], k == n - 1 ? 6 : 3);
    live_label(LIVE_QUIET, vec3_make(1.75, -0.22, 0), "place");
    live_label(LIVE_QUIET, vec3_make(0.08, 1.9, 0), "speed");
    live_handle(0, LIVE_INK, start, "start");
}

// The last swings, and as dashes what the spring would do.
static void draw_time(int n)
{
    enum { SMOOTH = 120 };
    const real span = 16;
    vec3 line[KEPT], exact[SMOOTH];
    real to = n > 0 ? real_max(span, kept(n - 1)->x) : span, scale = 5.0 / span;
    int shown = 0;
    live_pane(TIME);
    live_line(LIVE_RULE, (vec3[]){ { 0, 0, 0 }, { 5, 0, 0 } }, 2);
    for (int k = 0; k < SMOOTH; k++) {
        real t = to - span + span * k / (SMOOTH - 1);
        exact[k] = vec3_make(5.0 * k / (SMOOTH - 1), start.x * cos(t) + start.y * sin(t), 0);
    }
    live_dashes(LIVE_GREY, exact, SMOOTH);
    for (int k = 0; k < n; k++)
        if (kept(k)->x >= to - span) line[shown++] = vec3_make(scale * (kept(k)->x - to + span), kept(k)->y, 0);
    live_line(LIVE_BLUE, line, shown);
    for (int k = 0; k < shown; k++) live_dot(k == shown - 1 ? LIVE_ORANGE : LIVE_BLUE, line[k], k == shown - 1 ? 6 : 3);
    live_label(LIVE_QUIET, vec3_make(4.5, -0.25, 0), "time");
    live_label(LIVE_QUIET, vec3_make(0.08, 1.9, 0), "place");
}

static void draw(void)
{
    int n = int_min(count, KEPT);
    draw_phase(n);
    draw_time(n);
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, &p.position, sizeof(vec3));
    return live_hash(h, trail, (size_t)int_min(count, KEPT) * sizeof *trail);
}

const live_figure figure = {
    .name = "phase",
    .says = "Place and speed of a mass on a spring as a curve; beside it the place over time, step by step",
    .pane = { [PHASE] = { -2.3, -2.2, 4.6, 4.4 }, [TIME] = { -0.1, -2.2, 5.2, 4.4 } },
    .dial = { [STEP] = { "ω Δt", NULL, 0.1, 2.1, 0.02, 0.6, NULL, true } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move,
};
