// clip.c - in which points do two faces touch?  The three cases, one after the other,
// with the line of meet_polygons() lit (chapter 11).

#include "live.h"
#include "plane.h"

// The library's own, so that it can be asked case by case.
#define manifold_find clip_find
#define manifold_on_plane clip_on_plane
#define face_is_along clip_looks
#define face_area clip_area
#include "../../lib/query/manifold.c"

enum { TURN };                                  // dial
enum { CORNERS = 8, PACE = 75, REST = 150 };
typedef enum { PATCHES, A_IN_B, B_IN_A, CROSSINGS, KEPT, MOMENTS } moment;
static const real MARGIN = 0.02;                // m

static shape box_a, box_b;
static bool is_ready;
static vec3 place_a = { 0.45, 0.25, 0.15 }, place_b = { -0.3, -0.15, -0.15 };
static vec3 at_a[CORNERS], at_b[CORNERS];
static patch patch_a, patch_b;
static view across;
static meetings met;
static int known[MOMENTS];                      // of met, at each moment's end
static manifold kept;
static moment now;
static int frame;

static void place_boxes(void)
{
    for (int i = 0; i < CORNERS; i++) {
        vec3 r = plane_turned(box_a.at[i], plane_tangent(live_dial(TURN)));
        at_a[i] = vec3_add(place_a, vec3_make(r.x, r.y, box_a.at[i].z));
        at_b[i] = vec3_add(place_b, box_b.at[i]);
    }
}

// As find_between, with a look after each case.
static void meet_in_turn(void)
{
    depths a_in_b, b_in_a;
    measure_depths(&patch_a, &patch_b, a_in_b);
    measure_depths(&patch_b, &patch_a, b_in_a);
    meet_corners(&patch_a, &patch_b, a_in_b, 1, &across, &met);
    known[A_IN_B] = met.count;
    meet_corners(&patch_b, &patch_a, b_in_a, -1, &across, &met);
    known[B_IN_A] = met.count;
    meet_crossings(&patch_a, &patch_b, a_in_b, b_in_a, across.slack, &met);
    known[CROSSINGS] = known[KEPT] = met.count;
}

static void solve(void)
{
    collider a = { &box_a, at_a, false }, b = { &box_b, at_b, false };
    query_cache none = { .count = 0 };
    query_result q = query_nearest(&a, &b, MARGIN, &none);
    met.count = kept.count = 0;
    for (int k = 0; k < MOMENTS; k++) known[k] = 0;
    if (!q.near) return;
    across = view_along(q.normal, feature_at(&q.at.b, at_b), real_max(box_a.radius, box_b.radius));
    met.margin = MARGIN;
    met.same = 64 * across.slack;
    kept = manifold_find(&a, &b, &q, MARGIN, 0);
    if (!patch_begin(&patch_a, &a, -1, &across, &q.at.a, 0) || !patch_begin(&patch_b, &b, 1, &across, &q.at.b, 0)) return;
    patch_draw(&patch_a, &across);
    patch_draw(&patch_b, &across);
    meet_in_turn();
}

static void tell(void)
{
    int n = known[now] - (now > PATCHES && now < KEPT ? known[now - 1] : 0);
    const char *s = n == 1 ? "" : "s";
    if (kept.count == 0) live_say("The two do not touch. Drag one over the other.");
    else if (now == PATCHES) live_say("Seen along the normal: the lower face of A, the upper face of B.");
    else if (now == A_IN_B) live_say("First case: %d corner%s of A in B.", n, s);
    else if (now == B_IN_A) live_say("Second case: %d corner%s of B in A.", n, s);
    else if (now == CROSSINGS) live_say("Third case: %d crossing%s of an edge of A and one of B. With it the overlap is complete.", n, s);
    else live_say("Of %d corners %d are kept: they span the largest area.", met.count, kept.count);
    live_light(now == PATCHES ? "measure_depths(p, q" : now == A_IN_B ? "meet_corners(p, q" : now == B_IN_A ? "meet_corners(q, p"
               : now == CROSSINGS ? "meet_crossings(p, q" : "");
}

static void begin_again(void)
{
    if (is_ready) {
        place_boxes();
        solve();
    }
    now = PATCHES;
    frame = 0;
    tell();
}

static void begin(void)
{
    if (!is_ready) is_ready = shape_box(&box_a, vec3_make(2.3, 1.35, 0.3), 1).ok && shape_box(&box_b, vec3_make(2.0, 1.7, 0.3), 1).ok;
    begin_again();
}

static void step(void)
{
    if (++frame >= (now == KEPT ? REST : PACE)) {
        frame = 0;
        now = (now + 1) % MOMENTS;
    }
    tell();
}

static void press(int button)
{
    (void)button;
    now = (now + 1) % MOMENTS;
    frame = -10000;                             // no further by itself
    tell();
}

static void move(int number, vec3 to)
{
    vec3 *place = number == 0 ? &place_a : &place_b;
    *place = vec3_make(to.x, to.y, place->z);
    begin_again();
}

// --- Drawing ----------------------------------------------------------------------
static vec3 in_world(vec3 as_seen)
{
    return vec3_add_scaled(vec3_add_scaled(across.origin, as_seen.x, across.x), as_seen.y, across.y);
}

// The side of a box that the other one faces: in its rest the lower or the upper.
static void draw_face(live_colour c, const vec3 *at, vec3 middle, bool upper)
{
    vec3 face[4];
    int n = 0;
    for (int i = 0; i < CORNERS; i++)
        if ((at[i].z > middle.z) == upper) face[n++] = at[i];
    // Of a box the corners come in pairs: the second pair runs the other way.
    vec3 swap = face[2];
    face[2] = face[3], face[3] = swap;
    live_area(c, face, 4);
}

static void draw_corners(void)
{
    static const live_colour colour[MOMENTS] = { LIVE_INK, LIVE_BLUE, LIVE_ORANGE, LIVE_GREEN, LIVE_GREEN };
    for (int k = 0; k < known[now]; k++) {
        moment of = k < known[A_IN_B] ? A_IN_B : k < known[B_IN_A] ? B_IN_A : CROSSINGS;
        live_dot(colour[of], in_world(met.at[k]), of == now ? 8 : 6);
    }
    for (int k = 0; k < kept.count && now == KEPT; k++)
        live_circle(LIVE_INK, feature_at(&kept.point[k].b, at_b), 0.11);
}

static void draw(void)
{
    if (!is_ready) return;
    draw_face(LIVE_ORANGE, at_b, place_b, true);
    draw_face(LIVE_BLUE, at_a, place_a, false);
    draw_corners();
    live_label(LIVE_BLUE, vec3_add(place_a, vec3_make(0.2, 0.1, 0)), "A");
    live_label(LIVE_ORANGE, vec3_add(place_b, vec3_make(-0.35, -0.2, 0)), "B");
    live_handle(0, LIVE_BLUE, place_a, "box A");
    live_handle(1, LIVE_ORANGE, place_b, "box B");
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, met.at, (size_t)met.count * sizeof(vec3));
    for (int k = 0; k < kept.count; k++) h = live_hash(h, &kept.point[k].gap, sizeof(real));
    return live_hash(h, (int[]){ (int)now, kept.count }, 2 * sizeof(int));
}

const live_figure figure = {
    .name = "clip",
    .says = "The touching faces of two boxes, one over the other; the corners of their overlap are found in three cases, and four are kept",
    .code = "lib/query/manifold.c meet_polygons",
    .pane = { { -3.1, -1.5, 6.2, 3.1 } },
    .dial = { [TURN] = { "turn of A", "°", -90, 90, 1, 20, NULL, true } },
    .button = { "Next case" },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .press = press, .move = move,
};
