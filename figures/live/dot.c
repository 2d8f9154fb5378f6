// dot.c - two vectors, and what both products say of them (chapter 0).

#include "live.h"
#include "plane.h"

static const real REACH = 2.6, LEAST = 0.1;     // m
static vec3 a, b;
static bool is_led;                             // by the reader, and not by itself
static int frame;

static real cross(void)
{
    return vec3_cross(a, b).z;
}

static void tell(void)
{
    real product = vec3_dot(a, b), size = vec3_length(b);
    const char *angle = product > 0 ? "an acute angle" : product < 0 ? "an obtuse angle" : "a right angle";
    live_say("a · b = %.2f = %.2f × %.2f: %s. a × b is %.2f, the area; a lies %s of b.", product, size, product / size, angle,
             cross(), cross() > 0 ? "to the right" : "to the left");
}

static void begin(void)
{
    frame = 0, is_led = false;
    a = vec3_make(0.95, 0.8, 0);
    b = vec3_make(1.9, -0.35, 0);
    tell();
}

// By itself a goes round, b stays.
static void step(void)
{
    frame++;
    if (!is_led) a = plane_turned(a, 0.006);
    tell();
}

static void move(int number, vec3 to)
{
    vec3 *v = number == 0 ? &a : &b;
    vec3 at = vec3_make(to.x, to.y, 0);
    is_led = true;
    if (vec3_length(at) < LEAST) return;
    *v = vec3_length(at) > REACH ? vec3_scale(REACH, vec3_unit(at)) : at;
    tell();
}

static void draw(void)
{
    const vec3 zero = { 0, 0, 0 };
    vec3 foot = vec3_scale(vec3_dot(a, b) / vec3_length_squared(b), b), line[2] = { vec3_scale(-3, vec3_unit(b)), vec3_scale(3, vec3_unit(b)) };
    live_area(LIVE_GREY, (vec3[]){ zero, b, vec3_add(a, b), a }, 4);
    live_line(LIVE_RULE, line, 2);
    live_dashes(LIVE_QUIET, (vec3[]){ a, foot }, 2);
    live_arrow(LIVE_INK, zero, b);
    live_arrow(LIVE_BLUE, zero, a);
    live_line(vec3_dot(a, b) < 0 ? LIVE_ORANGE : LIVE_GREEN, (vec3[]){ zero, foot }, 2);
    live_dot(vec3_dot(a, b) < 0 ? LIVE_ORANGE : LIVE_GREEN, foot, 6);
    live_handle(0, LIVE_BLUE, a, "a");
    live_handle(1, LIVE_INK, b, "b");
    live_label(LIVE_BLUE, vec3_add(a, vec3_make(0.14, 0.1, 0)), "a");
    live_label(LIVE_INK, vec3_add(b, vec3_make(0.14, 0.1, 0)), "b");
    live_label(LIVE_QUIET, vec3_add(foot, vec3_make(-0.1, -0.26, 0)), "part of a along b");
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, &a, sizeof a);
    return live_hash(h, &b, sizeof b);
}

const live_figure figure = {
    .name = "dot",
    .says = "Two arrows a and b from one point, the part of a along b, and their parallelogram",
    .pane = { { -3.1, -1.65, 6.2, 3.3 } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move,
};
