// crate.c - a crate is pushed: friction holds it up to mu N, and brakes it beyond
// (chapter 00b).

#include "live.h"

#include <stdio.h>

enum { ROUGH };                                 // dial
static const real MASS = 10, GRAVITY = 9.81;    // kg, m/s^2
static const real SCALE = 0.02, MOST = 110;     // m/N, as it is drawn; N
static const real HALF = 0.5, HIGH = 0.8;       // m, of the crate

static const real PACE = 10, PEAK = 70;         // N/s, N: the push by itself

static real push, rub, x, speed;                // N, N, m, m/s
static real way;                                // 1: the push grows, -1: it falls, 0: a hand has taken it

static real holds(void) { return live_dial(ROUGH) * MASS * GRAVITY; }

static void begin(void)
{
    x = speed = rub = push = 0;
    way = 1;
}

// Friction takes away what speed there is, but no more than mu N gives in a step.
static void step(void)
{
    real h = 1.0 / 60, most = holds() * h / MASS;
    push = real_max(0, push + way * PACE * h);
    if (push > PEAK) way = -1;
    if (push == 0 && way < 0) way = 1;
    speed += push * h / MASS;
    real taken = real_max(-most, real_min(most, speed));
    speed -= taken;
    x += speed * h;
    rub = MASS * taken / h;
    if (speed > 0) live_say("It slides at %.1f m/s, and friction is μN, %.1f N. That is %.1f N %s than the push.", speed, rub, fabs(push - rub), rub > push ? "more" : "less");
    else live_say("It stands: friction is as large as the push, %.1f N. It could hold %.1f N.", rub, holds());
}

static void move(int number, vec3 to)
{
    (void)number;
    way = 0;
    push = real_max(0, real_min(MOST, (to.x - HALF) / SCALE));
}

// --- Drawing ----------------------------------------------------------------------
// The crate stays in the middle, and the floor goes by.
static void draw_floor(void)
{
    vec3 ground[4] = { { -4, -2, 0 }, { 4, -2, 0 }, { 4, 0, 0 }, { -4, 0, 0 } };
    live_band(LIVE_GREY, ground, 4);
    live_line(LIVE_QUIET, &ground[2], 2);
    real first = floor(x / 0.5) * 0.5 - x;
    for (int k = -5; k <= 6; k++) {
        real from = first + 0.5 * k;
        live_line(LIVE_QUIET, (vec3[]){ { from, 0, 0 }, { from - 0.12, -0.16, 0 } }, 2);
    }
}

static void draw_crate(void)
{
    vec3 side[4] = { { -HALF, 0, 0 }, { HALF, 0, 0 }, { HALF, HIGH, 0 }, { -HALF, HIGH, 0 } };
    live_area(LIVE_BLUE, side, 4);
    live_line(LIVE_BLUE, (vec3[]){ side[0], side[2] }, 2);
    live_label(LIVE_INK, vec3_make(-0.2, HIGH + 0.1, 0), "10 kg");
    if (rub > 0.5) live_arrow(LIVE_ORANGE, vec3_make(-HALF, 0.08, 0), vec3_make(-HALF - SCALE * rub, 0.08, 0));
    live_label(LIVE_ORANGE, vec3_make(-HALF - SCALE * holds() - 0.14, -0.36, 0), "μN");
    live_dashes(LIVE_ORANGE, (vec3[]){ { -HALF - SCALE * holds(), -0.16, 0 }, { -HALF - SCALE * holds(), 0.34, 0 } }, 2);
    live_arrow(LIVE_INK, vec3_make(HALF, 0.45, 0), vec3_make(HALF + SCALE * push, 0.45, 0));
    live_handle(0, LIVE_INK, vec3_make(HALF + SCALE * push, 0.45, 0), "push");
}

// Friction over push: first as large, and then no larger.
static void draw_law(void)
{
    vec3 law[3] = { { 0, 0, 0 }, { real_min(MOST, holds()), real_min(MOST, holds()), 0 }, { MOST, real_min(MOST, holds()), 0 } };
    live_pane(1);
    live_line(LIVE_QUIET, (vec3[]){ { 0, 105, 0 }, { 0, 0, 0 }, { 115, 0, 0 } }, 3);
    live_line(LIVE_ORANGE, law, 3);
    live_dot(LIVE_ORANGE, vec3_make(push, rub, 0), 6);
    live_label(LIVE_QUIET, vec3_make(76, -13, 0), "push, N");
    live_label(LIVE_QUIET, vec3_make(3, 105, 0), "friction, N");
}

static void draw(void)
{
    draw_floor();
    draw_crate();
    draw_law();
}

static unsigned long long hash(void)
{
    return live_hash(LIVE_HASH, (real[]){ x, speed, rub, push }, 4 * sizeof(real));
}

const live_figure figure = {
    .name = "crate",
    .says = "A crate on a floor, an arrow for the push and one for the friction against it; beside them friction over push, which rises and then stays",
    .pane = { { -2.75, -0.75, 5.6, 2.4 }, { -9, -20, 130, 150 } },
    .dial = { [ROUGH] = { "μ", NULL, 0, 1, 0.05, 0.5, NULL, false } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move,
};
