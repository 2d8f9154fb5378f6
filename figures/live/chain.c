// chain.c - a chain of boxes with a load, its joints solved one by one or as a
// tree (chapter 17).

#include "join.h"
#include "live.h"
#include "live_world.h"
#include "measure.h"
#include "step.h"

enum { SOLVER, LINKS, LOAD, SUBSTEPS };         // dials
enum { GAP, TIME };                             // charts
enum { MOST = 41, ONE_BY_ONE = 0 };
static const real LENGTH = 0.2, HIGH = 4.4;     // m, a link; the hook

static world chain;
static shape link_shape, load_shape;
static bool is_ready, is_cut;
static int bodies;

static status add_bodies(void)
{
    status done = status_ok();
    for (int k = 0; k < bodies && done.ok; k++) {
        bool is_load = k == bodies - 1;
        vec3 at = { LENGTH * k + (is_load ? 0.25 : 0.1), HIGH, 0 };
        done = world_add(&chain, is_load ? &load_shape : &link_shape, placement_at(at), NULL);
    }
    for (int k = 0; k < bodies && done.ok; k++)
        done = world_join(&chain, (joint_plan){ .kind = JOINT_BALL, .a = k - 1, .b = k,
                          .point = { LENGTH * k, HIGH, 0 } }, NULL);
    return done;
}

static status build(world_options how)
{
    status done = world_init(&chain, how);
    if (done.ok) done = shape_box(&link_shape, vec3_make(0.17, 0.09, 0.09), 1);
    if (done.ok) done = shape_box(&load_shape, vec3_make(0.5, 0.5, 0.5), live_dial(LOAD));
    if (done.ok) done = world_add_plane(&chain, vec3_make(0, 1, 0), 0);
    if (done.ok) done = add_bodies();
    return done;
}

static void begin(void)
{
    if (is_ready) {
        world_free(&chain);
        shape_free(&link_shape);
        shape_free(&load_shape);
    }
    world_options how = world_options_default();
    how.substeps = (int)live_dial(SUBSTEPS);
    how.sleep_speed = 0;
    bodies = (int)live_dial(LINKS) + 1;
    status done = build(how);
    is_ready = done.ok;
    chain.joints.is_plain = live_choice(SOLVER) == ONE_BY_ONE;
    is_cut = false;
    if (!done.ok) live_say("%s", done.why);
}

// --- Hands ------------------------------------------------------------------------
static void press(int button)
{
    if (!is_ready) return;
    if (button == 0) {
        live_world_hurry(&chain, bodies - 1, vec3_make(2.5, 0, -1.5));
    } else if (!is_cut) {
        world_unjoin(&chain, bodies / 2);
        is_cut = true;
    }
}

// --- Frames -----------------------------------------------------------------------
static void step(void)
{
    if (!is_ready) return;
    if (live_held() >= 0) live_world_pull(&chain, live_held(), 5);
    world_step(&chain);
}

static real gap_of(int k)
{
    return is_cut && k == bodies / 2 ? 0 : world_joint_gap(&chain, k);
}

static void measure(void)
{
    real worst = 0;
    int where = 0;
    for (int k = 0; k < bodies && is_ready; k++)
        if (gap_of(k) > worst) worst = gap_of(k), where = k;
    live_value(GAP, 0, 1000 * worst);
    live_say(worst < 1 ? "Joint %d of %d is torn furthest, by %.3g mm." : "Joint %d of %d is torn furthest, by %.1f m.",
             where + 1, bodies, worst < 1 ? 1000 * worst : worst);
}

static void draw_body(int b)
{
    bool is_torn = gap_of(b) > 0.01 || (b + 1 < bodies && gap_of(b + 1) > 0.01);
    live_colour c = b == bodies - 1 ? LIVE_ORANGE : is_torn ? LIVE_RED : LIVE_BLUE;
    live_world_body(&chain, b, c);
}

static void draw(void)
{
    if (!is_ready) return;
    live_ball(-1, LIVE_INK, vec3_make(0, HIGH, 0), 0.06);
    for (int b = 0; b < bodies; b++) draw_body(b);
}

static unsigned long long hash(void)
{
    return is_ready ? world_hash(&chain) : 0;
}

const live_figure figure = {
    .name = "chain",
    .says = "A chain of boxes swings from a hook, with a heavy load at its end; links whose joints are torn are red",
    .camera = { .distance = 9, .turn = 0.25, .rise = 0.14, .target = { 0.4, 2.35, 0 }, .has_floor = true },
    .dial = {
        [SOLVER] = { "joints are solved", NULL, 0, 1, 1, ONE_BY_ONE, "one by one|as a tree", true },
        [LINKS] = { "links of 1 kg", NULL, 1, MOST - 1, 1, 16, NULL, true },
        [LOAD] = { "load", "kg", 1, 200, 1, 100, NULL, true },
        [SUBSTEPS] = { "substeps a frame", NULL, 1, 64, 1, 8, NULL, true },
    },
    .button = { "Push the load", "Cut the chain" },
    .chart = {
        [GAP] = { "widest gap of a joint", "mm", { NULL }, 0.001, 1000, true, false, NULL },
        [TIME] = { "time of a frame", "ms", { NULL }, 0, 0.1, false, true, NULL },
    },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash,
    .press = press,
};
