// spin.c - two weights turn about their middle, and a string lets them out or
// pulls them in (chapter 00b).

#include "live.h"

enum { DISTANCE };                      // dial
enum { KEPT, ENERGY };                  // charts
enum { STEPS = 400, TRAIL = 90 };
static const real DT = 1.0 / 60 / STEPS, PI = 3.14159265358979323846;
static const real M = 2;                // kg, each
static const real OMEGA = 3;            // rad/s, at a distance of 1 m
static const real STIFFNESS = 40000;    // N/m, of the string
static const real HAUL = 0.8;           // m/s, at most

typedef struct {
    vec3 x, v;
} weight;

static weight p[2];
static real reach;                      // m, half of the string at rest
static vec3 trail[2][TRAIL];
static int trails;

static real turning(void)
{
    return M * (vec3_cross(p[0].x, p[0].v).z + vec3_cross(p[1].x, p[1].v).z);
}

static void begin(void)
{
    p[0] = (weight){ { -1, 0, 0 }, { 0, -OMEGA, 0 } };
    p[1] = (weight){ { 1, 0, 0 }, { 0, OMEGA, 0 } };
    reach = 1 - M * OMEGA * OMEGA / STIFFNESS / 2;
    trails = 0;
}

static void pull(void)
{
    vec3 along = vec3_sub(p[1].x, p[0].x), unit = vec3_unit(along);
    real swing = vec3_dot(vec3_sub(p[1].v, p[0].v), unit);
    // A damper along the string: like the string, it turns nothing.
    real force = STIFFNESS * (vec3_length(along) - 2 * reach) + 100 * swing;
    p[0].v = vec3_add_scaled(p[0].v, DT * force / M, unit);
    p[1].v = vec3_add_scaled(p[1].v, -DT * force / M, unit);
    for (int i = 0; i < 2; i++) p[i].x = vec3_add_scaled(p[i].x, DT, p[i].v);
}

static void keep_trails(void)
{
    for (int i = 0; i < 2; i++) {
        if (trails == TRAIL)
            for (int k = 1; k < TRAIL; k++) trail[i][k - 1] = trail[i][k];
        trail[i][int_min(trails, TRAIL - 1)] = p[i].x;
    }
    trails = int_min(trails + 1, TRAIL);
}

static void step(void)
{
    for (int k = 0; k < STEPS; k++) {
        real missing = live_dial(DISTANCE) - reach;
        reach += real_max(-HAUL * DT, real_min(HAUL * DT, missing));
        pull();
    }
    keep_trails();
}

static void measure(void)
{
    real r = vec3_distance(p[0].x, p[1].x) / 2, inertia = 2 * M * r * r;
    live_value(KEPT, 0, turning());
    live_value(ENERGY, 0, M * (vec3_length_squared(p[0].v) + vec3_length_squared(p[1].v)) / 2);
    live_say("I = 2 × 2 kg × (%.2f m)² = %.2f kg m², so %.2f turns a second; I ω = %.3f kg m²/s.", r, inertia,
             turning() / inertia / (2 * PI), turning());
}

static void draw(void)
{
    for (int i = 0; i < 2; i++) live_line(i ? LIVE_ORANGE : LIVE_BLUE, trail[i], trails);
    live_line(LIVE_INK, (vec3[]){ p[0].x, p[1].x }, 2);
    live_circle(LIVE_INK, vec3_make(0, 0, 0), 0.05);
    for (int i = 0; i < 2; i++) {
        live_circle(i ? LIVE_ORANGE : LIVE_BLUE, p[i].x, 0.09);
        live_arrow(i ? LIVE_ORANGE : LIVE_BLUE, p[i].x, vec3_add_scaled(p[i].x, 0.12, p[i].v));
    }
}

static unsigned long long hash(void)
{
    return live_hash(LIVE_HASH, p, sizeof p);
}

const live_figure figure = {
    .name = "spin",
    .says = "Two weights at the ends of a string turn about its middle; when the string is shortened they turn faster",
    .pane = { { -2.4, -1.35, 4.8, 2.7 } },
    .dial = { [DISTANCE] = { "distance from the axis, m", NULL, 0.3, 1.2, 0.05, 0.5, NULL, false } },
    .chart = {
        [KEPT] = { "angular momentum", "kg m²/s", { NULL }, 0, 20, false, false, NULL },
        [ENERGY] = { "energy of motion", "J", { NULL }, 0, 120, false, false, NULL },
    },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash,
};
