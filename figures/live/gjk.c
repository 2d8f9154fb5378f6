// gjk.c - GJK, one iteration after the other, on two polygons (chapter 4).
//
// gjk_distance_1 is lib/paper/gjk.c with one iteration at most, as
// figures/04/04-distance.edits makes it; gjk_distance is the module itself.

#include "../04/04-polygons.h"
#include "live.h"
#include "plane.h"

gjk_result gjk_distance_1(hull a, hull b, real margin, simplex *carried);

enum { TURN };                                  // dials
enum { UPPER, LOWER };                          // lines of the chart
enum { SHAPES, DIFFERENCE };                    // panes
enum { PACE = 40, REST = 80, ITERATIONS = 30 }; // frames an iteration, at the end

static vec3 place_a, place_b = { -0.15, -0.1, 0 };
static vec3 at_a[A_CORNERS], at_b[B_CORNERS];
static simplex now;                             // after `count` iterations
static gjk_status state;
static int count, frame;
static bool is_paced = true;                    // goes on by itself
static real bound[2][ITERATIONS];

static hull shape_a(void) { return (hull){ at_a, A_CORNERS }; }
static hull shape_b(void) { return (hull){ at_b, B_CORNERS }; }

static void place_shapes(void)
{
    plane_place(POLYGON_A, A_CORNERS, place_a, 0, at_a);
    plane_place(POLYGON_B, B_CORNERS, place_b, plane_tangent(live_dial(TURN)), at_b);
}

// The support that the next iteration asks for.
static corner next_support(void)
{
    return hull_support(shape_a(), shape_b(), vec3_scale(-1, now.v));
}

static void note_bounds(void)
{
    real v = vec3_length(now.v);
    corner w = next_support();
    bound[UPPER][count] = v;
    bound[LOWER][count] = v > 0 ? real_max(0, vec3_dot(now.v, w.at) / v) : 0;
    for (int k = UPPER; k <= LOWER; k++) live_curve(0, k, bound[k], count + 1);
}

static const char *simplex_name(void)
{
    static const char *const name[] = { "", "corner", "segment", "triangle", "tetrahedron" };
    return name[now.count];
}

static void tell(void)
{
    gjk_result r = gjk_distance(shape_a(), shape_b(), HUGE_VAL, NULL);
    if (state == GJK_APART)
        live_say("Done after %d iterations: w reaches no further than v. The distance is %.3f m.", count, r.distance);
    else if (state == GJK_OVERLAP)
        live_say("Done after %d iterations: the %s holds the origin. A and B overlap.", count, simplex_name());
    else
        live_say("Iteration %d: the simplex is a %s; its point v nearest the origin is %.3f m away, and nothing is nearer than %.3f m.",
                 count + 1, simplex_name(), bound[UPPER][count], bound[LOWER][count]);
}

// From the corner of A - B that is furthest from the origin, so that there is
// something to see.
static void begin(void)
{
    place_shapes();
    vec3 away = vec3_sub(plane_middle(at_a, A_CORNERS), plane_middle(at_b, B_CORNERS));
    corner far = hull_support(shape_a(), shape_b(), away);
    now = (simplex){ .count = 1, .of = { far }, .weight = { 1 }, .v = far.at };
    state = GJK_CAPPED;
    count = frame = 0;
    note_bounds();
    tell();
}

static void iterate(void)
{
    if (state != GJK_CAPPED || count == ITERATIONS - 1) {
        begin();
        return;
    }
    state = gjk_distance_1(shape_a(), shape_b(), HUGE_VAL, &now).status;
    if (state == GJK_CAPPED) count++;
    frame = 0;
    note_bounds();
    tell();
}

// The lines of an iteration, a quarter of its time each.
static void light(void)
{
    static const char *const line[] = { "corner w = hull_support", "if (vv - p->bound", "next.of[next.count++] = w", "nearest(&next)" };
    if (state == GJK_CAPPED) live_light(line[int_min(4 * frame / PACE, 3)]);
    else                     live_light(state == GJK_APART ? line[1] : "if (vv < 1e-120)");
}

static void step(void)
{
    note_bounds();
    tell();
    light();
    if (++frame >= (state == GJK_CAPPED ? PACE : REST) && is_paced) iterate();
}

static void press(int button)
{
    (void)button;
    is_paced = false;
    iterate();
}

static void move(int number, vec3 to)
{
    if (number == 0) place_a = vec3_sub(to, plane_middle(POLYGON_A, A_CORNERS));
    else             place_b = vec3_sub(to, plane_middle(POLYGON_B, B_CORNERS));
    begin();
}

// --- Drawing ----------------------------------------------------------------------
static void draw_shapes(void)
{
    live_pane(SHAPES);
    live_area(LIVE_BLUE, at_a, A_CORNERS);
    live_area(LIVE_ORANGE, at_b, B_CORNERS);
    gjk_result r = gjk_distance(shape_a(), shape_b(), HUGE_VAL, NULL);
    if (state == GJK_APART && r.status == GJK_APART)
        live_line(LIVE_INK, (vec3[]){ r.on_a, r.on_b }, 2);
    for (int k = 0; k < now.count; k++) {
        live_dot(LIVE_BLUE, at_a[now.of[k].a], 5);
        live_dot(LIVE_ORANGE, at_b[now.of[k].b], 5);
    }
    vec3 a = plane_middle(at_a, A_CORNERS), b = plane_middle(at_b, B_CORNERS);
    live_label(LIVE_BLUE, vec3_add(a, vec3_make(0.2, -0.05, 0)), "A");
    live_label(LIVE_ORANGE, vec3_add(b, vec3_make(0.2, -0.05, 0)), "B");
    live_handle(0, LIVE_BLUE, a, "polygon A");
    live_handle(1, LIVE_ORANGE, b, "polygon B");
}

// w, and the line through it beyond which all of A - B lies.
static void draw_support(void)
{
    corner w = next_support();
    vec3 n = vec3_unit(now.v), side = { -n.y, n.x, 0 };
    live_dashes(LIVE_GREEN, (vec3[]){ vec3_add_scaled(w.at, -9, side), vec3_add_scaled(w.at, 9, side) }, 2);
    live_dot(LIVE_GREEN, w.at, 5);
    live_label(LIVE_GREEN, vec3_add(w.at, vec3_make(0.1, 0.1, 0)), "w");
}

static void draw_difference(void)
{
    vec3 outline[MOST], at[4];
    int n = plane_difference(shape_a(), shape_b(), outline, MOST);
    for (int k = 0; k < now.count; k++) at[k] = now.of[k].at;
    live_pane(DIFFERENCE);
    live_area(LIVE_GREY, outline, n);
    live_label(LIVE_QUIET, vec3_add(plane_middle(outline, n), vec3_make(-0.2, 0, 0)), "A − B");
    if (state != GJK_OVERLAP) draw_support();
    live_area(LIVE_PURPLE, at, now.count);
    for (int k = 0; k < now.count; k++) live_dot(LIVE_PURPLE, at[k], 5);
    live_dashes(LIVE_INK, (vec3[]){ now.v, { 0, 0, 0 } }, 2);
    live_dot(LIVE_INK, now.v, 3);
    live_label(LIVE_INK, vec3_add(now.v, vec3_make(0.1, -0.2, 0)), "v");
    live_dot(LIVE_INK, vec3_make(0, 0, 0), 5);
    live_label(LIVE_INK, vec3_make(-0.62, -0.28, 0), "origin");
}

static void draw(void)
{
    draw_shapes();
    draw_difference();
}

static unsigned long long hash(void)
{
    gjk_result r = gjk_distance(shape_a(), shape_b(), HUGE_VAL, NULL);
    unsigned long long h = live_hash(LIVE_HASH, now.weight, (size_t)now.count * sizeof(real));
    h = live_hash(h, &now.v, sizeof(vec3));
    h = live_hash(h, &r.distance, sizeof(real));
    h = live_hash(h, &r.on_a, sizeof(vec3));
    return live_hash(h, &r.on_b, sizeof(vec3));
}

const live_figure figure = {
    .name = "gjk",
    .says = "Two polygons, A and B, and their difference, A - B, the origin, and the simplex that GJK holds",
    .code = "lib/paper/gjk.c step",
    .pane = { [SHAPES] = { -0.5, -0.95, 5.2, 4.77 }, [DIFFERENCE] = { -0.95, -1.75, 5.2, 4.77 } },
    .dial = { [TURN] = { "turn of B", "°", -90, 90, 1, 0, NULL, true } },
    .button = { "Next iteration" },
    .chart = { { "bounds of the distance, m", NULL, { [UPPER] = "|v|", [LOWER] = "lower bound" }, 0, 1, false, false, "iteration" } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .press = press, .move = move,
};
