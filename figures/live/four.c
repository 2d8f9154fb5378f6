// four.c - four particles and six sticks beside the solid that they stand for: they
// turn as it does if their spread is that of the solid (chapter 13).

#include "handle.h"
#include "live.h"
#include "measure.h"
#include "rigid4.h"
#include "step.h"

enum { SPREAD };                                // dial
enum { CORNERS = 8, EDGES_OF_BOX = 12, FINE = 16, ROUNDS = 6, AGAIN = 1500 };   // frames
static const vec3 EDGES = { 0.8, 1.3, 2.1 };    // m
static const vec3 SPIN = { 0.7, 2.2, 0.5 };     // rad/s

static world space;
static shape box;
static rigid4 plan;
static particle four[FOUR];
static stick six[FOUR_STICKS];
static vec3 rest[FOUR];                         // m, at first: from the middle
static placement solid;
static bool is_ready;
static int frame;

static status build_solid(void)
{
    world_options o = world_options_default();
    o.gravity = vec3_make(0, 0, 0);
    status done = shape_box(&box, EDGES, 1);
    if (done.ok) done = rigid4_build(&plan, &box);
    if (done.ok) done = world_init(&space, o);
    if (done.ok) done = world_add(&space, &box, placement_at(vec3_make(0, 0, 0)), NULL);
    return done;
}

// The particles of the plan, but along the longest edge so many times as far out.
static void build_four(void)
{
    for (int k = 0; k < FOUR; k++) {
        rest[k] = plan.at[k];
        rest[k].z *= live_dial(SPREAD);
        four[k] = particle_start(rest[k], vec3_cross(SPIN, rest[k]), vec3_cross(SPIN, vec3_cross(SPIN, rest[k])), 4, 1.0 / 60 / FINE);
    }
    for (int k = 0, n = 0; k < FOUR; k++)
        for (int l = k + 1; l < FOUR; l++, n++)
            six[n] = (stick){ k, l, vec3_distance(rest[k], rest[l]), 1, STICK_EXACT };
}

static void begin(void)
{
    if (is_ready) {
        world_free(&space);
        rigid4_free(&plan);
        shape_free(&box);
    }
    status done = build_solid();
    is_ready = done.ok;
    frame = 0;
    if (!done.ok) { live_say("%s", done.why); return; }
    world_set_velocity(&space, 0, vec3_make(0, 0, 0), SPIN);
    solid = world_where(&space, 0);
    build_four();
}

// Where a place of the box at rest is now.
static vec3 on_solid(vec3 r)
{
    vec3 at = vec3_add_scaled(solid.position, r.x, solid.x);
    return vec3_add_scaled(vec3_add_scaled(at, r.y, solid.y), r.z, solid.z);
}

// m: how far the particles are from their places, in the mean.
static real off(void)
{
    real sum = 0;
    for (int k = 0; k < FOUR; k++) sum += vec3_distance(four[k].position, on_solid(rest[k]));
    return sum / FOUR;
}

static void step(void)
{
    if (!is_ready) return;
    if (++frame > AGAIN) begin();
    world_step(&space);
    solid = world_where(&space, 0);
    for (int n = 0; n < FINE; n++) {
        verlet_step(four, FOUR, vec3_make(0, 0, 0), NULL, 1.0 / 60 / FINE);
        for (int k = 0; k < ROUNDS; k++) sticks_iterate(six, FOUR_STICKS, four, relax_options_default());
    }
}

static void measure(void)
{
    if (is_ready) live_say("After %.1f s the four particles are %.1f mm away from their places in the solid.", frame / 60.0, 1000 * off());
}

// --- Drawing ----------------------------------------------------------------------
static void draw_solid(void)
{
    vec3 at[CORNERS];
    for (int k = 0; k < CORNERS; k++)
        at[k] = on_solid(vec3_make((k & 1 ? 0.5 : -0.5) * EDGES.x, (k & 2 ? 0.5 : -0.5) * EDGES.y, (k & 4 ? 0.5 : -0.5) * EDGES.z));
    for (int k = 0; k < CORNERS; k++)
        for (int bit = 1; bit < CORNERS; bit *= 2)
            if (!(k & bit)) live_tube(-1, LIVE_BLUE, at[k], at[k | bit], 0.012);
    for (int k = 0; k < FOUR; k++) live_ball(-1, LIVE_BLUE, on_solid(rest[k]), 0.045);
}

static void draw(void)
{
    if (!is_ready) return;
    draw_solid();
    for (int k = 0; k < FOUR_STICKS; k++) live_tube(-1, LIVE_ORANGE, four[six[k].a].position, four[six[k].b].position, 0.022);
    for (int k = 0; k < FOUR; k++) live_ball(-1, LIVE_ORANGE, four[k].position, 0.09);
}

static unsigned long long hash(void)
{
    return is_ready ? live_hash(world_hash(&space), four, sizeof four) : 0;
}

const live_figure figure = {
    .name = "four",
    .says = "The edges of a box that turns freely, and four balls on six sticks that turn with it, or part from it",
    .camera = { .distance = 4.2, .turn = 0.6, .rise = 0.3, .target = { 0, 0, 0 } },
    .dial = { [SPREAD] = { "how far out along the longest edge", NULL, 0.3, 1.7, 0.05, 1, NULL, true } },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash,
};
