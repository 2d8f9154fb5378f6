// carts.c - a cart runs into another one: force, momentum, energy (chapter 00b).

#include "live.h"

#include <stdio.h>

enum { BUFFER };                        // dial
enum { FORCE, ENERGY };                 // charts
enum { MOTION, STORED, SUM };           // lines of the second
enum { STEPS = 100 };                   // a frame
static const real DT = 1.0 / 60 / STEPS;
static const real LENGTH = 0.6;         // m, of the buffer at rest
static const real LONG = 1.1, HIGH = 0.66, WHEEL = 0.14;
static const real OVER = 2.6;           // s, then it begins again

typedef struct {
    real x, v, m;                       // m, of its front or back; m/s; kg
} cart;

static cart c[2];
static real now, impulse, lost;
static bool couples, is_coupled;

static real pressed(void) { return real_max(0, LENGTH - (c[1].x - c[0].x)); }
static real momentum(void) { return c[0].m * c[0].v + c[1].m * c[1].v; }
static real motion(void) { return (c[0].m * c[0].v * c[0].v + c[1].m * c[1].v * c[1].v) / 2; }
static real stored(void) { return live_dial(BUFFER) * pressed() * pressed() / 2; }

static void begin(void)
{
    c[0] = (cart){ -3.1, 3, 2 };
    c[1] = (cart){ 0, 0, 1 };
    now = impulse = lost = 0;
    is_coupled = false;
}

// The latch falls when the carts are equally fast: the buffer is shortest then.
static void couple(void)
{
    if (!couples || is_coupled || pressed() == 0 || c[0].v > c[1].v) return;
    is_coupled = true;
    lost = stored();
    c[0].v = c[1].v = momentum() / (c[0].m + c[1].m);
}

static void step(void)
{
    real most = 0;
    if (now > OVER) begin();
    now += 1.0 / 60;
    for (int k = 0; k < STEPS; k++) {
        real force = is_coupled ? 0 : live_dial(BUFFER) * pressed();
        c[0].v -= force / c[0].m * DT;
        c[1].v += force / c[1].m * DT;
        for (int i = 0; i < 2; i++) c[i].x += c[i].v * DT;
        impulse += force * DT;
        most = real_max(most, force);
        couple();
    }
    live_value(FORCE, 0, most);
}

static void measure(void)
{
    real held = is_coupled ? lost : stored();
    live_value(ENERGY, MOTION, motion());
    live_value(ENERGY, STORED, held);
    live_value(ENERGY, SUM, motion() + held);
    live_say("Momentum: 2 kg × %.2f m/s + 1 kg × %.2f m/s = %.2f kg m/s. Impulse so far: %.2f N s.", c[0].v, c[1].v,
             momentum(), impulse);
}

static void draw_cart(live_colour colour, real left)
{
    vec3 box[5] = { { left, WHEEL, 0 }, { left + LONG, WHEEL, 0 }, { left + LONG, HIGH, 0 }, { left, HIGH, 0 }, { left, WHEEL, 0 } };
    live_area(colour, box, 5);
    live_line(colour, box, 5);
    for (int k = 0; k < 2; k++) live_circle(colour, vec3_make(left + LONG * (k ? 0.78 : 0.22), WHEEL, 0), WHEEL);
}

// The buffer is fixed to the second cart.
static void draw_buffer(void)
{
    enum { TURNS = 10 };
    vec3 at[TURNS + 1];
    real length = LENGTH - pressed();
    for (int k = 0; k <= TURNS; k++)
        at[k] = vec3_make(c[1].x - length + length * k / TURNS, 0.4 + (k % TURNS == 0 ? 0 : k % 2 ? 0.1 : -0.1), 0);
    live_line(is_coupled ? LIVE_RED : LIVE_INK, at, TURNS + 1);
}

static void draw(void)
{
    live_line(LIVE_INK, (vec3[]){ { -5, 0, 0 }, { 9, 0, 0 } }, 2);
    draw_cart(LIVE_BLUE, c[0].x - LONG);
    draw_cart(LIVE_ORANGE, c[1].x);
    draw_buffer();
    for (int i = 0; i < 2; i++) {
        vec3 middle = { c[i].x + (i ? LONG / 2 : -LONG / 2), HIGH + 0.22, 0 };
        char speed[24];
        snprintf(speed, sizeof speed, "%.1f m/s", c[i].v);
        live_label(i ? LIVE_ORANGE : LIVE_BLUE, vec3_make(middle.x - 0.2, 0.38, 0), i ? "1 kg" : "2 kg");
        live_label(i ? LIVE_ORANGE : LIVE_BLUE, vec3_make(middle.x - 0.3, middle.y + 0.22, 0), speed);
        if (fabs(c[i].v) > 0.05) live_arrow(i ? LIVE_ORANGE : LIVE_BLUE, middle, vec3_make(middle.x + 0.3 * c[i].v, middle.y, 0));
    }
}

static void press(int button)
{
    (void)button;
    couples = !couples;
    begin();
}

static unsigned long long hash(void)
{
    return live_hash(live_hash(LIVE_HASH, c, sizeof c), &impulse, sizeof impulse);
}

const live_figure figure = {
    .name = "carts",
    .says = "A cart of 2 kg rolls into a cart of 1 kg that stands; a buffer between them is pressed together",
    .pane = { { -3.6, -0.25, 7.2, 1.75 } },
    .dial = { [BUFFER] = { "stiffness of the buffer, N/m", NULL, 40, 1000, 10, 60, NULL, true } },
    .button = { "With a latch, or without" },
    .chart = {
        [FORCE] = { "force", "N", { NULL }, 0, 80, false, false, NULL },
        [ENERGY] = { "energy", "J", { "of motion", "in the buffer", "sum" }, 0, 10, false, false, NULL },
    },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash, .press = press,
};
