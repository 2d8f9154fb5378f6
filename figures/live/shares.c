// shares.c - a corner in an edge, parted by equation 10 as printed, with its
// masses put right, and by the least move (chapter 7).

#include "constraint.h"
#include "hit_face.h"
#include "live.h"
#include "plane.h"
#include "response.h"

#include <stdio.h>
#include <string.h>

enum { RULE, MASS_A, MASS_B };                  // dials
enum { PRINTED, MENDED, LEAST, RULES };         // and lines of the charts
enum { LEFT, MOMENTUM };                        // charts
enum { A_CORNERS = 3, B_CORNERS = 4, CORNERS = A_CORNERS + B_CORNERS, STICKS = 3 + 6 };
enum { ITERATIONS = 16, BEFORE = 30, PUSHED = 100, PACE = 4, REST = 60 };   // frames
static const vec3 START[CORNERS] = {
    { 0.42, 0.72, 0 }, { 1.25, 2.0, 0 }, { -0.1, 2.15, 0 },
    { -1.3, 0, 0 }, { 1.3, 0, 0 }, { 1.3, 1.1, 0 }, { -1.3, 1.1, 0 },
};

static vec3 place_a, place_b, now[CORNERS];     // where they begin
// After the first push, and after each iteration over the sticks.
static particle state[RULES][ITERATIONS + 1][CORNERS];
static stick link[STICKS];
static feature_contact touch;
static real depth;                              // m; 0: they are apart
static int frame;

// --- Where do they touch? ---------------------------------------------------------
static feature_point flat_feature(const feature_point *f, int n, int first)
{
    feature_point flat = { 0 };
    for (int k = 0; k < f->count; k++) feature_add(&flat, first + f->vertex[k] % n, f->weight[k]);
    return flat;
}

static void find_contact(void)
{
    vec3 a[2 * A_CORNERS], b[2 * B_CORNERS];
    hull hull_a = plane_prism(now, A_CORNERS, a), hull_b = plane_prism(now + A_CORNERS, B_CORNERS, b);
    gjk_result apart = gjk_distance(hull_a, hull_b, 0, NULL);
    depth = 0;
    if (apart.status != GJK_OVERLAP) return;
    hit_result hit = hit_face_find(hull_a, hull_b, &apart.last);
    depth = hit.depth;
    touch = (feature_contact){ .normal = hit.normal, .mass_a = live_dial(MASS_A), .mass_b = live_dial(MASS_B) };
    touch.a = flat_feature(&hit.a, A_CORNERS, 0);
    touch.b = flat_feature(&hit.b, B_CORNERS, A_CORNERS);
}

// --- The response -----------------------------------------------------------------
static void part(int rule, particle *p)
{
    if (rule == LEAST) response_separate(&touch, p, 0);
    else response_printed(&touch, p, (response_errata){ .masses_exchanged = rule == PRINTED });
}

static void run(int rule)
{
    particle p[CORNERS];
    for (int i = 0; i < CORNERS; i++) {
        real mass = i < A_CORNERS ? live_dial(MASS_A) / A_CORNERS : live_dial(MASS_B) / B_CORNERS;
        p[i] = (particle){ now[i], now[i], 1 / mass };
    }
    for (int k = 0; k <= ITERATIONS; k++) {
        if (k > 0) sticks_iterate(link, STICKS, p, relax_options_pbd());
        part(rule, p);
        memcpy(state[rule][k], p, sizeof p);
    }
}

// The sum of mass times way, kg m.
static real momentum(const particle *p)
{
    vec3 sum = { 0, 0, 0 };
    for (int i = 0; i < CORNERS; i++)
        sum = vec3_add_scaled(sum, 1 / p[i].inverse_mass, vec3_sub(p[i].position, now[i]));
    return vec3_length(sum);
}

// What the sticks bring back, once they have their lengths again.
static real comes_back(const particle *p)
{
    particle q[CORNERS];
    memcpy(q, p, sizeof q);
    for (int k = 0; k < 30; k++) sticks_iterate(link, STICKS, q, relax_options_pbd());
    return real_max(0, contact_depth(&touch, q));
}

static void measure_rule(int rule)
{
    real left[ITERATIONS + 1], made[ITERATIONS + 1], whole = depth * (live_dial(MASS_A) + live_dial(MASS_B));
    for (int k = 0; k <= ITERATIONS; k++) {
        left[k] = 100 * comes_back(state[rule][k]) / depth;
        made[k] = 100 * momentum(state[rule][k]) / whole;
    }
    live_curve(LEFT, rule, left, ITERATIONS + 1);
    live_curve(MOMENTUM, rule, made, ITERATIONS + 1);
}

// By how much of the depth has the point of f moved out in the first push?
static real share(const feature_point *f)
{
    vec3 to = feature_position(f, state[live_choice(RULE)][0]);
    return 100 * fabs(vec3_dot(vec3_sub(to, feature_at(f, now)), touch.normal)) / depth;
}

static void tell(void)
{
    if (!(depth > 0)) {
        live_say("A and B are apart. Drag A into B.");
        return;
    }
    real made = 100 * momentum(state[live_choice(RULE)][0]) / (depth * (live_dial(MASS_A) + live_dial(MASS_B)));
    live_say("The first push moves A's point by %.1f %% of the depth, and B's by %.1f %%. Momentum out of nothing: %.1f %% of all mass times the depth.",
             share(&touch.a), share(&touch.b), made);
}

static void begin(void)
{
    for (int i = 0; i < CORNERS; i++)
        now[i] = vec3_add(START[i], i < A_CORNERS ? place_a : place_b);
    int n = 0;
    for (int a = 0; a < CORNERS; a++)
        for (int b = a + 1; b < CORNERS; b++)
            if ((a < A_CORNERS) == (b < A_CORNERS))
                link[n++] = (stick){ a, b, vec3_distance(now[a], now[b]), 1, STICK_EXACT };
    frame = 0;
    find_contact();
    for (int rule = 0; rule < RULES && depth > 0; rule++) {
        run(rule);
        measure_rule(rule);
    }
    tell();
}

static void step(void)
{
    if (++frame == BEFORE + PUSHED + PACE * ITERATIONS + REST) frame = 0;
}

static void turn(int dial)
{
    (void)dial;
    tell();
}

static void move(int number, vec3 to)
{
    const vec3 *at = number == 0 ? START : START + A_CORNERS;
    vec3 *place = number == 0 ? &place_a : &place_b;
    *place = vec3_sub(vec3_make(to.x, to.y, 0), plane_middle(at, number == 0 ? A_CORNERS : B_CORNERS));
    begin();
}

// --- Drawing ----------------------------------------------------------------------
static void draw_body(live_colour c, const vec3 *at, int n, bool filled)
{
    vec3 closed[CORNERS + 1];
    for (int i = 0; i <= n; i++) closed[i] = at[i % n];
    if (filled) live_area(c, at, n);
    else        live_dashes(c, closed, n + 1);
}

static void label_share(live_colour c, const char *name, const feature_point *f, vec3 at)
{
    char text[40];
    snprintf(text, sizeof text, "%s: %.0f %% of the depth", name, share(f));
    live_label(c, at, text);
}

static void draw(void)
{
    vec3 at[CORNERS];
    int k = int_max(0, int_min(ITERATIONS, (frame - BEFORE - PUSHED) / PACE));
    bool is_pushed = depth > 0 && frame >= BEFORE;
    const particle *p = state[live_choice(RULE)][k];
    for (int i = 0; i < CORNERS; i++) at[i] = is_pushed ? p[i].position : now[i];
    draw_body(LIVE_BLUE, at, A_CORNERS, true);
    draw_body(LIVE_ORANGE, at + A_CORNERS, B_CORNERS, true);
    if (is_pushed) {
        draw_body(LIVE_BLUE, now, A_CORNERS, false);
        draw_body(LIVE_ORANGE, now + A_CORNERS, B_CORNERS, false);
        for (int i = 0; i < CORNERS; i++)
            if (vec3_distance(now[i], at[i]) > 0.02) live_arrow(LIVE_INK, now[i], at[i]);
        label_share(LIVE_BLUE, "A", &touch.a, vec3_make(-2.2, 2.15, 0));
        label_share(LIVE_ORANGE, "B", &touch.b, vec3_add(plane_middle(now + A_CORNERS, B_CORNERS), vec3_make(-0.6, -0.4, 0)));
    } else if (depth > 0) {
        live_dot(LIVE_BLUE, feature_at(&touch.a, now), 5);
        live_dot(LIVE_ORANGE, feature_at(&touch.b, now), 5);
        live_arrow(LIVE_GREEN, feature_at(&touch.a, now), feature_at(&touch.b, now));
    }
    live_handle(0, LIVE_BLUE, plane_middle(now, A_CORNERS), "body A");
    live_handle(1, LIVE_ORANGE, plane_middle(now + A_CORNERS, B_CORNERS), "body B");
}

static unsigned long long hash(void)
{
    return live_hash(LIVE_HASH, state, sizeof state);
}

const live_figure figure = {
    .name = "shares",
    .says = "A triangle, A, stands with a corner in a box, B; both are moved until they part",
    .pane = { { -2.3, -0.5, 4.6, 2.9 } },
    .dial = {
        [RULE] = { "parted by", NULL, 0, 2, 1, 0, "Eq. 10|mended|least move", false },
        [MASS_A] = { "mass of A", "kg", 1, 50, 1, 1, NULL, true },
        [MASS_B] = { "mass of B", "kg", 1, 50, 1, 20, NULL, true },
    },
    .chart = {
        [LEFT] = { "overlap left, % of the depth", NULL, { "Eq. 10", "mended", "least move" }, 0, 100, false, false, "iterations, sticks and push in turns" },
        [MOMENTUM] = { "momentum out of nothing, %", NULL, { "Eq. 10", "mended", "least move" }, 0, 100, false, false, "iterations" },
    },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .turn = turn, .move = move,
};
