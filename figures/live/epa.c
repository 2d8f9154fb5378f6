// epa.c - the expanding polytope, one iteration after the other, in the plane
// (chapter 5).
//
// The polygon grows here, by the supports of lib/paper/gjk.c; the depth, the
// normal and the contact points are those of lib/paper/hit_face.c, for the two
// shapes as long prisms.

#include "hit_face.h"
#include "live.h"
#include "plane.h"

enum { CORNERS_A, TURN };                       // dials
enum { LOWER, UPPER };                          // lines of the chart
enum { SHAPES, DIFFERENCE };                    // panes
enum { PACE = 30, REST = 100 };                 // frames an iteration, at the end
enum { MOST_A = 32, CORNERS_B = 5, MOST = MOST_A + CORNERS_B + 3 };

static const vec3 B_START[CORNERS_B] = {
    { -0.85, -0.7, 0 }, { 0.5, -0.95, 0 }, { 1.05, 0.1, 0 }, { 0.3, 0.95, 0 }, { -0.8, 0.55, 0 }
};

static vec3 place_a = { 0.75, 0.5, 0 }, place_b = { -0.2, -0.2, 0 };
static vec3 at_a[MOST_A], at_b[CORNERS_B];
static int corners_a;
static vec3 grown[MOST], w;                     // counter-clockwise; the next corner
static int corners, closest, count, frame;
static bool overlaps, is_done, is_paced = true; // paced: goes on by itself
static real bound[2][MOST];
static hit_result hit;

static hull shape_a(void) { return (hull){ at_a, corners_a }; }
static hull shape_b(void) { return (hull){ at_b, CORNERS_B }; }

// A's corners lie on an ellipse, half by half.
static void place_shapes(void)
{
    vec3 rest[MOST_A];
    corners_a = 4 << live_choice(CORNERS_A);
    for (int i = 0; i < corners_a; i++) {
        int half = corners_a / 2;
        vec3 on_circle = plane_turned(vec3_make(i < half ? 1 : -1, 0, 0), (2.0 * (i % half) + 1) / half - 1);
        rest[i] = vec3_make(1.25 * on_circle.x, 0.95 * on_circle.y, 0);
    }
    plane_place(rest, corners_a, place_a, 0.2, at_a);
    plane_place(B_START, CORNERS_B, place_b, plane_tangent(live_dial(TURN)), at_b);
}

// --- The polygon that grows -------------------------------------------------------
static vec3 outward(int k)
{
    vec3 e = vec3_unit(vec3_sub(grown[(k + 1) % corners], grown[k]));
    return vec3_make(e.y, -e.x, 0);
}

static real height(int k)
{
    return vec3_dot(outward(k), grown[k]);
}

// Looks for the closest edge, and for the corner of A - B beyond it.
static void look(void)
{
    closest = 0;
    for (int k = 1; k < corners; k++)
        if (height(k) < height(closest)) closest = k;
    w = hull_support(shape_a(), shape_b(), outward(closest)).at;
    bound[LOWER][count] = real_max(0, height(closest));
    bound[UPPER][count] = vec3_dot(outward(closest), w);
    is_done = bound[UPPER][count] <= bound[LOWER][count] + 1e-12;
}

static void expand(void)
{
    for (int k = corners++; k > closest + 1; k--) grown[k] = grown[k - 1];
    grown[closest + 1] = w;
    count++;
    look();
}

// GJK ends with a segment or a triangle that holds the origin.
static void begin_polygon(const simplex *last)
{
    corners = int_min(3, last->count);
    for (int k = 0; k < corners; k++) grown[k] = last->of[k].at;
    vec3 n = vec3_cross(vec3_sub(grown[1], grown[0]), vec3_sub(grown[corners - 1], grown[0]));
    if (n.z >= 0) return;
    vec3 swap = grown[1];
    grown[1] = grown[2], grown[2] = swap;
}

static void show(void)
{
    for (int k = LOWER; k <= UPPER && overlaps; k++) live_curve(0, k, bound[k], count + 1);
    if (!overlaps)
        live_say("A and B are apart: there is no depth. Drag one into the other.");
    else if (is_done)
        live_say("Done after %d iterations: w is no further out than the edge. The depth is %.4f m; hit_face_find says %.4f m.",
                 count, bound[LOWER][count], hit.depth);
    else
        live_say("Iteration %d: the closest edge is %.3f m away, w reaches %.3f m. The depth is between them.",
                 count + 1, bound[LOWER][count], bound[UPPER][count]);
}

static void begin(void)
{
    vec3 a[2 * MOST_A], b[2 * CORNERS_B];
    place_shapes();
    count = frame = 0;
    hull prism_a = plane_prism(at_a, corners_a, a), prism_b = plane_prism(at_b, CORNERS_B, b);
    gjk_result flat = gjk_distance(shape_a(), shape_b(), 0, NULL);
    gjk_result whole = gjk_distance(prism_a, prism_b, 0, NULL);
    overlaps = flat.status == GJK_OVERLAP && flat.last.count > 1 && whole.status == GJK_OVERLAP;
    if (overlaps) {
        hit = hit_face_find(prism_a, prism_b, &whole.last);
        begin_polygon(&flat.last);
        look();
    }
    show();
}

static void iterate(void)
{
    frame = 0;
    if (!overlaps || is_done || corners == MOST) begin();
    else expand();
}

// The lines of an iteration, a quarter of its time each.
static void light(void)
{
    static const char *const line[] = { "closest_face(&p)", "w = furthest_beyond", "found = !is_beyond", "if (!found) expand" };
    if (!overlaps) live_light("");
    else           live_light(is_done && 4 * frame / PACE > 2 ? "face_result(" : line[int_min(4 * frame / PACE, 3)]);
}

static void step(void)
{
    if (++frame >= (is_done ? REST : PACE) && is_paced) iterate();
    show();
    light();
}

static void press(int button)
{
    (void)button;
    is_paced = false;
    iterate();
}

static void move(int number, vec3 to)
{
    *(number == 0 ? &place_a : &place_b) = vec3_make(to.x, to.y, 0);
    begin();
}

// --- Drawing ----------------------------------------------------------------------
static vec3 beside(vec3 at, real x, real y)
{
    return vec3_add(at, vec3_make(x, y, 0));
}

// A moves out, as far as the depth says.
static void draw_way_out(void)
{
    vec3 out[MOST_A + 1], way = vec3_scale(hit.depth, hit.normal);
    real part = real_min(1, (real)frame / (REST / 2));
    for (int i = 0; i <= corners_a; i++)
        out[i] = vec3_add_scaled(at_a[i % corners_a], part, way);
    live_dashes(LIVE_GREEN, out, corners_a + 1);
    live_arrow(LIVE_GREEN, hit.on_a, hit.on_b);
}

static void draw_shapes(void)
{
    live_pane(SHAPES);
    live_area(LIVE_BLUE, at_a, corners_a);
    live_area(LIVE_ORANGE, at_b, CORNERS_B);
    if (overlaps && is_done) draw_way_out();
    live_label(LIVE_BLUE, beside(place_a, 0.15, 0.1), "A");
    live_label(LIVE_ORANGE, beside(place_b, -0.45, -0.2), "B");
    live_handle(0, LIVE_BLUE, place_a, "shape A");
    live_handle(1, LIVE_ORANGE, place_b, "shape B");
}

static void draw_closest(void)
{
    vec3 n = outward(closest), edge[] = { grown[closest], grown[(closest + 1) % corners] };
    vec3 top = vec3_scale(bound[UPPER][count], n), side = vec3_make(-n.y, n.x, 0);
    live_dashes(LIVE_GREEN, (vec3[]){ vec3_add_scaled(top, -9, side), vec3_add_scaled(top, 9, side) }, 2);
    live_line(LIVE_RED, edge, 2);
    live_arrow(LIVE_RED, vec3_make(0, 0, 0), vec3_scale(height(closest), n));
    live_dot(LIVE_GREEN, w, 5);
    live_label(LIVE_GREEN, vec3_add_scaled(beside(w, -0.06, -0.06), -0.25, n), "w");
}

static void draw_difference(void)
{
    vec3 outline[MOST];
    live_pane(DIFFERENCE);
    live_area(LIVE_GREY, outline, plane_difference(shape_a(), shape_b(), outline, MOST));
    live_label(LIVE_QUIET, beside(vec3_sub(place_a, place_b), 0.5, 1.1), "A − B");
    if (overlaps) {
        live_area(LIVE_PURPLE, grown, corners);
        for (int k = 0; k < corners; k++) live_dot(LIVE_PURPLE, grown[k], 4);
        draw_closest();
    }
    live_dot(LIVE_INK, vec3_make(0, 0, 0), 5);
    live_label(LIVE_INK, vec3_make(0.12, 0.12, 0), "origin");
}

static void draw(void)
{
    draw_shapes();
    draw_difference();
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, grown, (size_t)corners * sizeof(vec3));
    h = live_hash(h, &hit.depth, sizeof(real));
    h = live_hash(h, &hit.normal, sizeof(vec3));
    return live_hash(h, &hit.on_a, sizeof(vec3));
}

const live_figure figure = {
    .name = "epa",
    .says = "Two overlapping shapes, A and B, and their difference, A - B, with the polygon of EPA that grows to the edge closest to the origin",
    .code = "lib/paper/hit_face.c hit_face_climb",
    .pane = { [SHAPES] = { -2.0, -1.75, 4.6, 4.174 }, [DIFFERENCE] = { -2.2, -2.1, 5.8, 5.263 } },
    .dial = {
        [CORNERS_A] = { "corners of A", NULL, 0, 3, 1, 1, "4|8|16|32", true },
        [TURN] = { "turn of B", "°", -90, 90, 1, 23, NULL, true },
    },
    .button = { "Next iteration" },
    .chart = { { "bounds of the depth, m", NULL, { [LOWER] = "closest edge", [UPPER] = "w" }, 0, 1, false, false, "iteration" } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .press = press, .move = move,
};
