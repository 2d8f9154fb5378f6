// leap.c - a ball that falls and bounces without loss, by explicit Euler: it comes
// higher each time (chapter 00).

#include "live.h"

#include <stdio.h>

enum { STEPS };                                 // dial
enum { TRAIL = 4800, MOMENTS = 400, REST = 150 };       // frames, before it begins again
static const real GRAVITY = 9.81, ALONG = 0.7, LONG = 9;        // m/s^2, m/s, s

static vec3 at, velocity, trail[TRAIL], ahead[MOMENTS];
static real from = 1, now, time_of, highest;    // m, s, s, m
static int trails, rested;

static int rate(void)
{
    static const int RATE[] = { 30, 60, 120, 480 };
    return RATE[live_choice(STEPS)];
}

// The exact path: the same parabola again and again, and it begins at the top.
static vec3 exact_at(real time)
{
    real top = sqrt(2 * from / GRAVITY), t = time + top;
    t -= 2 * top * floor(t / (2 * top)) + top;
    return vec3_make(ALONG * time, from - GRAVITY / 2 * t * t, 0);
}

static void begin(void)
{
    at = vec3_make(0, from, 0);
    velocity = vec3_make(ALONG, 0, 0);
    now = time_of = 0;
    highest = from;
    trails = rested = 0;
    for (int k = 0; k < MOMENTS; k++) ahead[k] = exact_at(k * LONG / (MOMENTS - 1));
}

// As chapter 00 does it: first move, then change the velocity; and the floor.
static void step_ball(real dt)
{
    at = vec3_add_scaled(at, dt, velocity);
    velocity.y -= GRAVITY * dt;
    if (at.y < 0 && velocity.y < 0) velocity.y *= -1;
    if (velocity.y < 0) highest = real_max(highest, at.y);
}

static void step(void)
{
    if (now > LONG && ++rested > REST) begin();
    if (now > LONG) return;
    now += 1.0 / 60;
    while (time_of + 1.0 / rate() < now + 1e-9) {
        step_ball(1.0 / rate());
        time_of += 1.0 / rate();
        if (trails < TRAIL) trail[trails++] = at;
    }
    live_say("After %.1f s the ball has come %.2f m high. It fell from %.2f m.", time_of, highest, from);
}

static void move(int number, vec3 to)
{
    (void)number;
    from = real_max(0.2, real_min(1.9, to.y));
    begin();
}

// --- Drawing ----------------------------------------------------------------------
static void draw(void)
{
    vec3 ground[4] = { { -1, -1, 0 }, { 8, -1, 0 }, { 8, 0, 0 }, { -1, 0, 0 } };
    live_band(LIVE_GREY, ground, 4);
    live_line(LIVE_QUIET, &ground[2], 2);
    for (int y = 1; y <= 2; y++) {
        char text[8];
        snprintf(text, sizeof text, "%d m", y);
        live_line(LIVE_RULE, (vec3[]){ { -1, y, 0 }, { 8, y, 0 } }, 2);
        live_label(LIVE_QUIET, vec3_make(-0.82, y + 0.05, 0), text);
    }
    live_dashes(LIVE_QUIET, ahead, MOMENTS);
    live_line(LIVE_BLUE, trail, trails);
    for (int k = 0; k < trails && rate() <= 60; k++) live_dot(LIVE_BLUE, trail[k], 2);
    if (highest > from + 0.01) live_dashes(LIVE_RED, (vec3[]){ { 0, highest, 0 }, { ALONG * now, highest, 0 } }, 2);
    live_circle(LIVE_BLUE, at, 0.07);
    live_handle(0, LIVE_ORANGE, vec3_make(0, from, 0), "height");
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, &at, sizeof at);
    return live_hash(h, &velocity, sizeof velocity);
}

const live_figure figure = {
    .name = "leap",
    .says = "A ball bounces to the right by explicit Euler, each time higher than before; dashes show the exact path, always equally high",
    .pane = { { -0.9, -0.3, 7.3, 3.4 } },
    .dial = { [STEPS] = { "steps a second", NULL, 0, 3, 1, 1, "30|60|120|480", true } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move,
};
