// slab.c - a box is set down on a slab: it touches in one point, or in up to four
// (chapter 11).

#include "live.h"
#include "manifold.h"
#include "plane.h"
#include "response.h"

enum { POINTS, LEAN, TURN, SUBSTEPS };          // dials
enum { ONE, CORNERS = 8, PASSES = 2 };
static const real DT = 1.0 / 60, MARGIN = 0.02, LOWEST = -0.2;  // s, m, m
static const real PULL = 150, BRAKE = 0.3;      // 1/s^2; of a substep's motion
static const vec3 GRAVITY = { 0, -9.81, 0 };

static shape box, slab;
static bool is_ready, is_held;
static particle p[2 * CORNERS];                 // the box's, then the slab's, pinned
static vec3 at[2 * CORNERS], held_at;
static feature_contact contact[MANIFOLD_POINTS];
static int contacts;

// Turns about y by an angle with the tangent of its half, t; then leans.
static vec3 placed(vec3 r, real t, real lean)
{
    real c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
    r = vec3_make(c * r.x + s * r.z, r.y, c * r.z - s * r.x);
    return vec3_make(r.x - lean * r.y, r.y + lean * r.x, r.z);
}

static void place(void)
{
    real lean = live_dial(LEAN) * 3.14159265358979 / 180, low = 0;
    for (int i = 0; i < CORNERS; i++) {
        at[i] = placed(box.at[i], plane_tangent(live_dial(TURN)), lean);
        low = real_min(low, at[i].y);
    }
    for (int i = 0; i < CORNERS; i++) {
        at[i] = vec3_add(at[i], vec3_make(0.06, 0.005 - low, 0.08));
        at[CORNERS + i] = vec3_add(slab.at[i], vec3_make(0, -0.15, 0));
        p[i] = particle_start(at[i], vec3_make(0, 0, 0), GRAVITY, 1 / box.mass[i], DT / live_dial(SUBSTEPS));
        p[CORNERS + i] = particle_start(at[CORNERS + i], vec3_make(0, 0, 0), GRAVITY, 0, DT);
    }
}

static void begin(void)
{
    shape_free(&box);
    shape_free(&slab);
    status done = shape_box(&box, vec3_make(1, 0.3, 1), 1);
    if (done.ok) done = shape_box(&slab, vec3_make(3, 0.3, 3), 1);
    is_ready = done.ok;
    is_held = false;
    contacts = 0;
    if (is_ready) place();
    else live_say("%s", done.why);
}

// --- Frames -----------------------------------------------------------------------
static void find_contacts(void)
{
    for (int i = 0; i < 2 * CORNERS; i++) at[i] = p[i].position;
    collider a = { &box, at, false }, b = { &slab, at + CORNERS, false };
    query_cache none = { .count = 0 };
    query_result q = query_nearest(&a, &b, MARGIN, &none);
    contacts = 0;
    if (!q.near) return;
    manifold m = { 1, q.normal, { q.at }, 0, 0 };
    if (live_choice(POINTS) != ONE) m = manifold_find(&a, &b, &q, MARGIN, 0);
    for (int k = 0; k < m.count; k++)
        contact[contacts++] = (feature_contact){
            .a = m.point[k].a, .normal = q.normal, .mass_a = 1, .mass_b = HUGE_VAL,
            .apart = vec3_dot(feature_at(&m.point[k].b, at + CORNERS), q.normal) };
}

static vec3 middle(void)
{
    vec3 sum = { 0, 0, 0 };
    for (int i = 0; i < CORNERS; i++) sum = vec3_add_scaled(sum, 1.0 / CORNERS, p[i].position);
    return sum;
}

// The hand pulls all of the box alike, and brakes it.
static void pull_held(real h)
{
    vec3 pull = vec3_scale(PULL * h * h, vec3_sub(held_at, middle()));
    for (int i = 0; i < CORNERS; i++) {
        vec3 moved = vec3_sub(p[i].position, p[i].previous);
        p[i].previous = vec3_add_scaled(vec3_sub(p[i].previous, pull), BRAKE / live_dial(SUBSTEPS), moved);
    }
}

static void step(void)
{
    int substeps = (int)live_dial(SUBSTEPS);
    if (!is_ready) return;
    find_contacts();
    for (int k = 0; k < substeps; k++) {
        if (is_held) pull_held(DT / substeps);
        verlet_step(p, CORNERS, GRAVITY, NULL, DT / substeps);
        for (int pass = 0; pass < PASSES; pass++) {
            for (int c = 0; c < contacts; c++) response_separate(&contact[c], p, 0.5);
            sticks_iterate(box.stick, box.sticks, p, relax_options_pbd());
        }
    }
    if (middle().y < LOWEST) begin();
}

// Degrees between the box's upright edges and the vertical.
static real tilt(void)
{
    vec3 up = { 0, 0, 0 };
    for (int k = 0; k < CORNERS; k++) up = vec3_add_scaled(up, k & 2 ? 1 : -1, p[k].position);
    return atan2(hypot(up.x, up.z), up.y) * 180 / 3.14159265358979;
}

static void measure(void)
{
    if (!is_ready) return;
    live_value(0, 0, tilt());
    live_say("The box leans by %.3g degrees, and touches in %d point%s.", tilt(), contacts, contacts == 1 ? "" : "s");
}

static void move(int number, vec3 to)
{
    (void)number;
    is_held = true;
    held_at = to;
}

static void release(int number)
{
    (void)number;
    is_held = false;
}

static void press(int button)
{
    (void)button;
    for (int i = 1; i < CORNERS; i += 2) p[i].previous.y -= 0.8 * DT / live_dial(SUBSTEPS);
}

// --- Drawing ----------------------------------------------------------------------
static void draw_frame(live_colour c, const vec3 *corners)
{
    for (int i = 0; i < CORNERS; i++)
        for (int d = 1; d < CORNERS; d *= 2)
            if (!(i & d)) live_tube(-1, c, corners[i], corners[i | d], 0.012);
}

// The box is drawn as its edges and its lower side, so that the points are seen.
static void draw(void)
{
    static const int lower[] = { 0, 1, 5, 0, 5, 4 };
    vec3 now[CORNERS];
    if (!is_ready) return;
    for (int i = 0; i < CORNERS; i++) now[i] = p[i].position;
    live_ground(LIVE_GREY, at + CORNERS, slab.face, slab.mesh.faces, 0.5);
    live_mesh(0, LIVE_BLUE, now, CORNERS, lower, 2, false);
    draw_frame(LIVE_BLUE, now);
    for (int c = 0; c < contacts; c++)
        live_ball(-1, LIVE_RED, feature_position(&contact[c].a, p), 0.06);
}

static unsigned long long hash(void)
{
    return live_hash(LIVE_HASH, p, sizeof p);
}

const live_figure figure = {
    .name = "slab",
    .says = "A flat box, drawn as a frame, is set down on a slab; red balls mark the points in which they touch",
    .camera = { .distance = 6.4, .turn = 0.5, .rise = 0.36, .target = { 0, 0, 0 }, .has_floor = true, .floor = -0.3 },
    .dial = {
        [POINTS] = { "contact points", NULL, 0, 1, 1, ONE, "one|up to four", true },
        [LEAN] = { "lean at the start", "°", 0, 10, 0.5, 0.5, NULL, true },
        [TURN] = { "turn of the box", "°", -45, 45, 1, 11, NULL, true },
        [SUBSTEPS] = { "substeps a frame", NULL, 1, 32, 1, 8, NULL, true },
    },
    .button = { "Tip it" },
    .chart = { { "lean", "°", { NULL }, 1e-4, 100, true, false, NULL } },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash,
    .press = press, .move = move, .release = release,
};
