// top.c - a box turns freely about its middle axis: by the naive step, by one that
// keeps the angular momentum, and by the engine's (chapter 13).

#include "handle.h"
#include "live.h"
#include "step.h"

enum { HOW };                                   // dial
enum { SPIN_KEPT, MOMENTUM_KEPT, ENGINE };
enum { CORNERS = 8, FACES = 12 };
static const vec3 EDGES = { 0.5, 1.1, 1.9 };    // m
static const vec3 SPIN = { 0.02, 4, 0.05 };     // rad/s, about the middle axis and a little beside
static const real H = 1.0 / 60;                 // s

static vec3 axis[3], spin, momentum, inertia;   // inertia of 1 kg about the three axes
static world space;
static shape box;
static bool is_ready;
static int frame;

static vec3 turned(vec3 x, vec3 by)             // by: rad, Cayley's map
{
    vec3 k = vec3_scale(0.5, by), c = vec3_cross(k, x);
    return vec3_add_scaled(x, 2 / (1 + vec3_length_squared(k)), vec3_add(c, vec3_cross(k, c)));
}

static vec3 momentum_of(const vec3 *e, vec3 w)
{
    vec3 L = vec3_scale(inertia.x * vec3_dot(w, e[0]), e[0]);
    L = vec3_add_scaled(L, inertia.y * vec3_dot(w, e[1]), e[1]);
    return vec3_add_scaled(L, inertia.z * vec3_dot(w, e[2]), e[2]);
}

static vec3 spin_of(const vec3 *e, vec3 L)
{
    vec3 w = vec3_scale(vec3_dot(L, e[0]) / inertia.x, e[0]);
    w = vec3_add_scaled(w, vec3_dot(L, e[1]) / inertia.y, e[1]);
    return vec3_add_scaled(w, vec3_dot(L, e[2]) / inertia.z, e[2]);
}

static void begin(void)
{
    vec3 s = { EDGES.x * EDGES.x, EDGES.y * EDGES.y, EDGES.z * EDGES.z };
    inertia = vec3_make((s.y + s.z) / 12, (s.z + s.x) / 12, (s.x + s.y) / 12);
    axis[0] = vec3_make(1, 0, 0), axis[1] = vec3_make(0, 1, 0), axis[2] = vec3_make(0, 0, 1);
    spin = SPIN;
    momentum = momentum_of(axis, spin);
    if (is_ready) {
        world_free(&space);
        shape_free(&box);
    }
    world_options o = world_options_default();
    o.gravity = vec3_make(0, 0, 0);
    placement at = placement_at(vec3_make(0, 0, 0));
    status done = shape_box(&box, EDGES, 1);
    if (done.ok) done = world_init(&space, o);
    if (done.ok) done = world_add(&space, &box, at, NULL);
    is_ready = done.ok;
    if (done.ok) world_set_velocity(&space, 0, vec3_make(0, 0, 0), SPIN);
    else         live_say("%s", done.why);
    frame = 0;
}

static void step_engine(void)
{
    world_step(&space);
    placement at = world_where(&space, 0);
    axis[0] = at.x, axis[1] = at.y, axis[2] = at.z;
    spin = at.spin;
}

static void step(void)
{
    if (!is_ready) return;
    frame++;
    int how = live_choice(HOW);
    if (how == ENGINE) { step_engine(); return; }
    for (int k = 0; k < 3; k++)
        axis[k] = how == SPIN_KEPT ? vec3_add_scaled(axis[k], H, vec3_cross(spin, axis[k])) : turned(axis[k], vec3_scale(H, spin));
    if (how == MOMENTUM_KEPT) spin = spin_of(axis, momentum);
}

static void measure(void)
{
    real longest = 0;
    for (int k = 0; k < 3; k++) longest = real_max(longest, vec3_length(axis[k]) - 1);
    real off = vec3_distance(momentum_of(axis, spin), momentum) / vec3_length(momentum);
    real energy = vec3_dot(momentum_of(axis, spin), spin) / vec3_dot(momentum, SPIN);
    live_say("After %.1f s: axes longer by %.1f %%, angular momentum off by %.1f %%, energy %.3f of what it was.", frame * H,
             100 * longest, 100 * off, energy);
}

// --- Drawing ----------------------------------------------------------------------
static vec3 corner_at(int k)
{
    vec3 at = vec3_scale((k & 1 ? 0.5 : -0.5) * EDGES.x, axis[0]);
    at = vec3_add_scaled(at, (k & 2 ? 0.5 : -0.5) * EDGES.y, axis[1]);
    return vec3_add_scaled(at, (k & 4 ? 0.5 : -0.5) * EDGES.z, axis[2]);
}

static void draw_arrow(live_colour c, vec3 way, real radius)
{
    live_tube(-1, c, vec3_make(0, 0, 0), way, radius);
    live_ball(-1, c, way, 2.5 * radius);
}

static void draw(void)
{
    static const int FACE[FACES][3] = { { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 }, { 0, 1, 5 }, { 0, 5, 4 },
                                        { 2, 6, 7 }, { 2, 7, 3 }, { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 } };
    vec3 at[CORNERS];
    for (int k = 0; k < CORNERS; k++) at[k] = corner_at(k);
    live_mesh(-1, LIVE_BLUE, at, CORNERS, FACE[0], FACES, false);
    draw_arrow(LIVE_INK, vec3_scale(1.35, vec3_unit(momentum)), 0.02);
    draw_arrow(LIVE_ORANGE, vec3_scale(1.05 / vec3_length(SPIN), spin), 0.03);
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, axis, sizeof axis);
    return live_hash(h, &spin, sizeof spin);
}

const live_figure figure = {
    .name = "top",
    .says = "A box turns freely about its middle axis; dark: its angular momentum, orange: its spin",
    .camera = { .distance = 5.4, .turn = 0.7, .rise = 0.3, .target = { 0, 0, 0 } },
    .dial = { [HOW] = { "kept is", NULL, 0, 2, 1, MOMENTUM_KEPT, "the spin|the angular momentum|both, by the engine", true } },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash,
};
