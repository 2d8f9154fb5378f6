// tin.c - what a floor meets of a tin that leans: a capsule along its axis, as the
// library's rim_towards() says (chapter 10).

#include "cylinder.h"
#include "live.h"
#include "plane.h"
#include "rim.h"

enum { ROUND = 25, MOST = 512 };                // of half a circle; vertices
static const real RADIUS = 0.55, LONG = 1.5;    // m
static const real PACE = 0.5, STEEPEST = 62;    // degrees a frame; degrees
static const vec3 DOWN = { 0, -1, 0 };

static shape tin;
static bool is_ready;
static vec3 at[MOST], edge[4];                  // m; edge: of its side view
static real lean;                               // degrees, of the axis
static int way;                                 // 1, -1; 0: led by hand
static rim_core core;
static bool is_seen;

// A place of the tin, along its axis and across, when it leans.
static vec3 turned(real along, real across, real beside)
{
    vec3 flat = plane_turned(vec3_make(along, across, 0), plane_tangent(lean));
    return vec3_make(flat.x, flat.y, beside);
}

static void place(void)
{
    real low = 0;
    for (int k = 0; k < 4; k++) {
        edge[k] = turned(k == 1 || k == 2 ? LONG / 2 : -LONG / 2, k < 2 ? -RADIUS : RADIUS, 0);
        low = real_min(low, edge[k].y);
    }
    for (int k = 0; k < 4; k++) edge[k].y -= low;
    for (int i = 0; i < tin.particles; i++) {
        at[i] = turned(tin.at[i].y, -tin.at[i].x, tin.at[i].z);
        at[i].y -= low;
    }
    is_seen = rim_towards(&tin, at, DOWN, &core);
}

static void tell(void)
{
    if (!is_seen) live_say("It stands on its end, up to 8°: now the flat end touches, as that of any body.");
    else live_say("It leans by %.0f°. The capsule has a radius of %.0f cm, and the tin of %.0f. Its lower end lies at %.0f %% of the axis.",
                  fabs(lean), 100 * core.core.round, 100 * RADIUS, 100 * (lean > 0 ? core.part[0] : core.part[1]));
}

static void begin(void)
{
    shape_free(&tin);
    is_ready = shape_cylinder(&tin, LONG, RADIUS, 1).ok && tin.particles <= MOST;
    lean = 0;
    way = 1;
    if (is_ready) place();
    tell();
}

static void step(void)
{
    if (!is_ready) return;
    lean += PACE * way;
    if (lean * way > STEEPEST) way = -way;
    place();
    tell();
}

// The lean that brings the middle of the right end nearest to the hand.
static void move(int number, vec3 to)
{
    real best = HUGE_VAL, found = lean;
    (void)number;
    if (!is_ready) return;
    way = 0;
    for (int k = -90; k <= 90; k++) {
        lean = k;
        place();
        real d = vec3_distance(vec3_scale(0.5, vec3_add(edge[1], edge[2])), vec3_make(to.x, to.y, 0));
        if (d < best) best = d, found = lean;
    }
    lean = found;
    place();
    tell();
}

// --- Drawing ----------------------------------------------------------------------
// Half a circle round an end of the core, from the side that `from` shows.
static int half_circle(vec3 middle, vec3 from, vec3 *out)
{
    for (int k = 0; k < ROUND; k++)
        out[k] = vec3_add(middle, plane_turned(from, plane_tangent(180.0 * k / (ROUND - 1))));
    return ROUND;
}

static void draw_capsule(void)
{
    vec3 end[2] = { { core.at[0].x, core.at[0].y, 0 }, { core.at[1].x, core.at[1].y, 0 } }, rim[2 * ROUND + 1];
    vec3 along = vec3_unit(vec3_sub(edge[1], edge[0])), up = vec3_make(-along.y * core.core.round, along.x * core.core.round, 0);
    int n = half_circle(end[0], up, rim);
    n += half_circle(end[1], vec3_scale(-1, up), rim + n);
    rim[n] = rim[0];
    live_dashes(LIVE_ORANGE, rim, n + 1);
    live_line(LIVE_ORANGE, end, 2);
    for (int k = 0; k < 2; k++) {
        live_dashes(LIVE_QUIET, (vec3[]){ end[k], { end[k].x, end[k].y - core.core.round, 0 } }, 2);
        live_dot(LIVE_ORANGE, end[k], 5);
    }
}

static void draw(void)
{
    vec3 ground[4] = { { -6, -2, 0 }, { 6, -2, 0 }, { 6, 0, 0 }, { -6, 0, 0 } };
    vec3 axis[2] = { vec3_scale(0.5, vec3_add(edge[0], edge[3])), vec3_scale(0.5, vec3_add(edge[1], edge[2])) };
    live_band(LIVE_GREY, ground, 4);
    live_line(LIVE_QUIET, &ground[2], 2);
    live_area(LIVE_BLUE, edge, 4);
    live_line(LIVE_BLUE, axis, 2);
    if (is_seen) draw_capsule();
    for (int k = 0; k < 4; k++)
        if (edge[k].y < 1e-9) live_dot(LIVE_RED, edge[k], 6);
    live_handle(0, LIVE_BLUE, axis[1], "the end of the tin");
}

static unsigned long long hash(void)
{
    return live_hash(live_hash(LIVE_HASH, edge, sizeof edge), core.at, sizeof core.at);
}

const live_figure figure = {
    .name = "tin",
    .says = "A tin leans on a floor, seen from the side; around its axis lies the capsule that the floor meets in its place",
    .pane = { { -2.9, -0.4, 5.8, 2.75 } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move,
};
