// nearest.c - two bodies, asked for their nearest points frame after frame: from
// nothing, and from what the last frame found (chapter 10).

#include "capsule.h"
#include "hull.h"
#include "live.h"
#include "plane.h"
#include "query.h"
#include "random.h"

enum { KIND, DISTANCE, TURN, EVERY };           // dials
enum { ASKED, OFF };                            // charts
enum { COLD, CARRIED };                         // lines of the first
enum { BOX, ICOSAHEDRON, STONE };               // A; B is a stone
enum { A, B, BODIES, POINTS = 150 };
static const vec3 AXIS = { 0.4, 0.86, 0.31 };   // A turns about it
static const real DOT = 0.035;                  // m
static const live_colour COLOUR[BODIES] = { LIVE_BLUE, LIVE_ORANGE };

static shape solid[BODIES];
static vec3 arm[BODIES][POINTS], at[BODIES][POINTS], middle[BODIES];
static bool is_ready;
static int frame, cold, carried;                // supports that GJK asked for
static simplex last;                            // of the frame before
static query_cache kept;
static query_result true_now, ridden;

// Points of a ball, thrown as dice are: a stone.
static status make_stone(shape *s, int points, real radius)
{
    unsigned long long seed = 13;
    vec3 p[POINTS];
    for (int i = 0; i < points; i++) p[i] = vec3_scale(radius, random_direction(&seed));
    return shape_hull(s, p, points, 1);
}

static status make_a(void)
{
    switch (live_choice(KIND)) {
    case BOX:         return shape_box(&solid[A], vec3_make(0.8, 0.7, 0.6), 1);
    case ICOSAHEDRON: return shape_icosahedron(&solid[A], 0.55, 1);
    default:          return make_stone(&solid[A], POINTS, 0.55);
    }
}

static collider body(int b)
{
    return (collider){ &solid[b], at[b], false };
}

static void ask(void)
{
    collider a = body(A), b = body(B);
    simplex none = { .count = 0 };
    // A cold search asks for its first corner, too.
    cold = gjk_distance(query_hull(&a), query_hull(&b), HUGE_VAL, &none).iterations + 1;
    carried = gjk_distance(query_hull(&a), query_hull(&b), HUGE_VAL, &last).iterations;
    true_now = query_nearest(&a, &b, HUGE_VAL, &kept);
    if (frame % (int)live_dial(EVERY) == 0) ridden = true_now;
}

static void place(void)
{
    for (int b = 0; b < BODIES; b++)
        for (int i = 0; i < solid[b].particles; i++) at[b][i] = vec3_add(middle[b], arm[b][i]);
}

static void begin(void)
{
    for (int b = 0; b < BODIES; b++) shape_free(&solid[b]);
    status done = make_a();
    if (done.ok) done = make_stone(&solid[B], 40, 0.6);
    is_ready = done.ok;
    if (!done.ok) {
        live_say("%s", done.why);
        return;
    }
    for (int b = 0; b < BODIES; b++) {
        middle[b] = vec3_make((b == A ? -0.5 : 0.5) * live_dial(DISTANCE), 0, 0);
        for (int i = 0; i < solid[b].particles; i++) arm[b][i] = solid[b].at[i];
    }
    frame = 0;
    last = (simplex){ .count = 0 };
    kept = (query_cache){ .count = 0 };
    place();
    ask();
}

// --- Frames -----------------------------------------------------------------------
// About the axis, by an angle with the tangent of its half, t: no sine is needed.
static vec3 turned(vec3 r, vec3 axis, real t)
{
    real c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
    vec3 along = vec3_scale((1 - c) * vec3_dot(axis, r), axis);
    return vec3_add(vec3_add_scaled(vec3_scale(c, r), s, vec3_cross(axis, r)), along);
}

static void step(void)
{
    if (!is_ready) return;
    vec3 axis = vec3_unit(AXIS);
    for (int i = 0; i < solid[A].particles; i++)
        arm[A][i] = turned(arm[A][i], axis, plane_tangent(live_dial(TURN)));
    frame++;
    place();
    ask();
}

static real ridden_gap(void)
{
    vec3 way = vec3_sub(feature_at(&ridden.at.a, at[A]), feature_at(&ridden.at.b, at[B]));
    return vec3_dot(way, ridden.normal);
}

static void measure(void)
{
    if (!is_ready) return;
    real gap = true_now.at.gap, off = fabs(ridden_gap() - gap);
    live_value(ASKED, COLD, cold);
    live_value(ASKED, CARRIED, carried);
    live_value(OFF, 0, 1000 * off);
    live_say("%s by %.1f mm. The points that ride say %.1f mm.", gap < 0 ? "They overlap" : "They are apart",
             1000 * fabs(gap), 1000 * (gap < 0 ? -ridden_gap() : ridden_gap()));
}

// --- Hands ------------------------------------------------------------------------
static void move(int number, vec3 to)
{
    if (!is_ready) return;
    middle[number] = to;
    place();
    ask();
}

// --- Drawing ----------------------------------------------------------------------
static void draw_points(live_colour c, const query_result *q, real radius)
{
    vec3 a = feature_at(&q->at.a, at[A]), b = feature_at(&q->at.b, at[B]);
    if (!q->near) return;
    live_ball(-1, c, a, radius);
    live_ball(-1, c, b, radius);
    if (vec3_distance(a, b) > 0) live_tube(-1, c, a, b, radius / 3);
}

static void draw(void)
{
    if (!is_ready) return;
    for (int b = 0; b < BODIES; b++)
        live_mesh(b, COLOUR[b], at[b], solid[b].particles, solid[b].face, solid[b].mesh.faces, false);
    draw_points(LIVE_INK, &true_now, DOT);
    draw_points(LIVE_RED, &ridden, 0.9 * DOT);
    for (int k = 0; k < last.count; k++) {
        live_ball(-1, LIVE_GREEN, at[A][last.of[k].a], 0.8 * DOT);
        live_ball(-1, LIVE_GREEN, at[B][last.of[k].b], 0.8 * DOT);
    }
}

static unsigned long long hash(void)
{
    vec3 points[] = { true_now.normal, feature_at(&true_now.at.a, at[A]), feature_at(&ridden.at.a, at[A]) };
    unsigned long long h = live_hash(LIVE_HASH, at[A], (size_t)solid[A].particles * sizeof(vec3));
    h = live_hash(h, points, sizeof points);
    return live_hash(h, &carried, sizeof carried);
}

const live_figure figure = {
    .name = "nearest",
    .says = "Two convex bodies, one of which turns; dark balls mark their nearest points, red ones those that ride with them since they were last asked for, green ones the corners that are carried to the next frame",
    .camera = { .distance = 3.3, .turn = 0, .rise = 0.22, .target = { 0, 0, 0 } },
    .dial = {
        [KIND] = { "the body that turns", NULL, 0, 2, 1, ICOSAHEDRON, "box|icosahedron|stone", true },
        [DISTANCE] = { "distance of the middles", "m", 0.5, 2, 0.01, 1.35, NULL, true },
        [TURN] = { "turn a frame", "°", 0, 10, 0.1, 0.6, NULL, false },
        [EVERY] = { "frames from query to query", NULL, 1, 60, 1, 40, NULL, false },
    },
    .chart = {
        [ASKED] = { "corners that GJK asks for", NULL, { "from nothing", "carried" }, 0, 8, false, false, NULL },
        [OFF] = { "gap of the points that ride, error", "mm", { NULL }, 0.001, 100, true, false, NULL },
    },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash, .move = move,
};
