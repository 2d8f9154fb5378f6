// regions.c - which point of a triangle is nearest to the origin?  The origin is
// led about, and corners with a weight of 0 or less are dropped (chapter 4).

#include "gjk.h"
#include "live.h"
#include "plane.h"

enum { CORNERS = 3, PATH = 600 };               // frames once around

static const vec3 C[CORNERS] = { { -1.0, -0.75, 0 }, { 1.25, -0.6, 0 }, { 0.1, 0.95, 0 } };
static const char *const NAME[CORNERS] = { "0", "1", "2" };
static vec3 origin;
static int frame;
static bool is_led;                             // by the reader, and not by itself
static gjk_result nearest;
static real weight[CORNERS];                    // of the corners of the triangle

// GJK of the triangle and a point is GJK of the triangle seen from that point.
static void find(void)
{
    nearest = gjk_distance((hull){ C, CORNERS }, (hull){ &origin, 1 }, HUGE_VAL, NULL);
    for (int k = 0; k < CORNERS; k++) weight[k] = 0;
    for (int k = 0; k < nearest.last.count; k++)
        weight[nearest.last.of[k].a] = nearest.last.weight[k];
}

static bool is_inside(void)
{
    return nearest.status == GJK_OVERLAP;
}

static void tell(void)
{
    static const char *const kept[] = { "", "one corner", "two corners, an edge", "all three corners" };
    if (is_inside()) live_say("All weights are positive: the origin lies inside, and v is the origin itself.");
    else live_say("What is kept: %s. The weights are %.2f, %.2f and %.2f, and v is %.3f m away.",
                  kept[nearest.last.count], weight[0], weight[1], weight[2], nearest.distance);
    live_light(is_inside() ? "if (weigh(s))" : "side.of[k] = side.of[--side.count]");
}

// Once around on a figure of eight, which comes through all seven regions.
static void lead(void)
{
    real t = 2.0 * (frame % (PATH / 2)) / (PATH / 2) - 1;
    vec3 d = plane_turned(vec3_make(frame % PATH < PATH / 2 ? 1 : -1, 0, 0), t);
    origin = vec3_make(2.35 * d.x, 0.2 + 1.5 * d.y * (0.45 + 0.55 * d.x * d.x), 0);
}

static void begin(void)
{
    frame = 0, is_led = false;
    lead();
    find();
    tell();
}

static void step(void)
{
    frame++;
    if (!is_led) lead();
    find();
    tell();
}

static void move(int number, vec3 to)
{
    (void)number;
    is_led = true;
    origin = vec3_make(to.x, to.y, 0);
    find();
    tell();
}

// --- Drawing ----------------------------------------------------------------------
// The strips of the edges end at lines across them, through the corners.
static void draw_borders(void)
{
    for (int k = 0; k < CORNERS; k++) {
        vec3 a = C[k], b = C[(k + 1) % CORNERS], e = vec3_unit(vec3_sub(b, a)), out = { e.y, -e.x, 0 };
        live_dashes(LIVE_QUIET, (vec3[]){ a, vec3_add_scaled(a, 6, out) }, 2);
        live_dashes(LIVE_QUIET, (vec3[]){ b, vec3_add_scaled(b, 6, out) }, 2);
    }
}

static void draw(void)
{
    vec3 kept[CORNERS], v = is_inside() ? origin : nearest.on_a;
    int n = 0;
    draw_borders();
    live_area(LIVE_GREY, C, CORNERS);
    for (int k = 0; k < CORNERS; k++)
        if (weight[k] > 0 || is_inside()) kept[n++] = C[k];
    live_area(LIVE_PURPLE, kept, n);
    for (int k = 0; k < n; k++) live_dot(LIVE_PURPLE, kept[k], 7);
    for (int k = 0; k < CORNERS; k++)
        live_label(LIVE_INK, vec3_add_scaled(vec3_add(C[k], vec3_make(-0.05, -0.06, 0)), 0.2, vec3_unit(C[k])), NAME[k]);
    live_dashes(LIVE_INK, (vec3[]){ origin, v }, 2);
    live_dot(LIVE_INK, v, 4);
    if (!is_inside()) live_label(LIVE_INK, vec3_add(v, vec3_make(0.08, 0.1, 0)), "v");
    live_handle(0, LIVE_INK, origin, "origin");
    live_label(LIVE_INK, vec3_add(origin, vec3_make(0.15, 0.12, 0)), "origin");
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, weight, sizeof weight);
    return live_hash(h, &nearest.on_a, sizeof(vec3));
}

const live_figure figure = {
    .name = "regions",
    .says = "A triangle, the origin, and the nearest point v of the triangle; dashed lines divide the plane in seven regions",
    .code = "lib/paper/gjk.c nearest",
    .pane = { { -3.1, -1.6, 6.2, 3.3 } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move,
};
