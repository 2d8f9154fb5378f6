// pile.c - boxes on one another, warm-started or not (chapter 13).

#include "handle.h"
#include "live.h"
#include "live_world.h"
#include "measure.h"
#include "step.h"

enum { WARM, HEAVIEST, SUBSTEPS };              // dials
enum { OVERLAP, SWAY };                         // charts
enum { BOXES = 10 };
static const real SIDE = 0.5;                   // m
static const live_colour COLOUR[] = { LIVE_BLUE, LIVE_ORANGE, LIVE_GREEN, LIVE_PURPLE };

static world piles;
static shape light, heavy;
static bool is_ready;
static vec3 start[BOXES];
static int frame;

static void drop_all(void)
{
    world_free(&piles);
    shape_free(&light);
    shape_free(&heavy);
    is_ready = false;
}

static status build(world_options how)
{
    real ratio = live_dial(HEAVIEST);
    status done = world_init(&piles, how);
    if (done.ok) done = shape_box(&light, vec3_make(SIDE, SIDE, SIDE), 1);
    if (done.ok) done = shape_box(&heavy, vec3_make(SIDE, SIDE, SIDE), ratio);
    if (done.ok) done = world_add_plane(&piles, vec3_make(0, 1, 0), 0);
    for (int b = 0; b < BOXES && done.ok; b++) {
        start[b] = vec3_make(b % 2 ? 0.003 : -0.003, (b + 0.5) * SIDE, b % 3 ? 0.002 : -0.004);
        done = world_add(&piles, b == BOXES - 1 ? &heavy : &light, placement_at(start[b]), NULL);
    }
    return done;
}

static void begin(void)
{
    if (is_ready) drop_all();
    world_options how = world_options_default();
    how.warm_start = live_choice(WARM);
    how.substeps = how.most_substeps = (int)live_dial(SUBSTEPS);
    how.sleep_speed = 0;
    status done = build(how);
    is_ready = done.ok;
    frame = 0;
    if (!done.ok) live_say("%s", done.why);
}

// --- Hands ------------------------------------------------------------------------
static void push(int b, vec3 along)
{
    if (is_ready) live_world_hurry(&piles, b, vec3_make(1.2 * along.x, 0, 1.2 * along.z));
}

static void press(int button)
{
    (void)button;
    push(BOXES / 2, vec3_make(0.8, 0, -0.6));
}

// --- Frames -----------------------------------------------------------------------
static void step(void)
{
    if (!is_ready) return;
    if (live_held() >= 0) live_world_pull(&piles, live_held(), 0);
    world_step(&piles);
    frame++;
}

static void measure(void)
{
    if (!is_ready || frame % 4) return;
    vec3 top = vec3_sub(world_where(&piles, BOXES - 1).position, start[BOXES - 1]);
    real aside = vec3_length(vec3_make(top.x, 0, top.z));
    live_value(OVERLAP, 0, 1000 * world_measure(&piles).penetration);
    live_value(SWAY, 0, 1000 * aside);
    if (top.y < -SIDE) live_say("The pile has fallen.");
    else live_say("The highest box stands %.1f mm lower than at the start, and %.1f mm aside.", -1000 * top.y, 1000 * aside);
}

static void draw(void)
{
    for (int b = 0; b < BOXES && is_ready; b++)
        live_world_body(&piles, b, b == BOXES - 1 ? LIVE_RED : COLOUR[b % 4]);
}

static unsigned long long hash(void)
{
    return is_ready ? world_hash(&piles) : 0;
}

const live_figure figure = {
    .name = "pile",
    .says = "Ten boxes on one another",
    .camera = { .distance = 10, .turn = 0.6, .rise = 0.2, .target = { 0, 2.5, 0 }, .has_floor = true },
    .dial = {
        [WARM] = { "contacts begin", NULL, 0, 1, 1, 0, "from nothing|warm", true },
        [HEAVIEST] = { "mass of the highest, others 1", "kg", 1, 100, 1, 20, NULL, true },
        [SUBSTEPS] = { "substeps a frame", NULL, 1, 32, 1, 8, NULL, true },
    },
    .button = { "Push the middle" },
    .chart = {
        [OVERLAP] = { "deepest overlap", "mm", { NULL }, 0.1, 100, true, false, NULL },
        [SWAY] = { "highest box, aside", "mm", { NULL }, 0.1, 100, true, false, NULL },
    },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash,
    .press = press, .tap = push,
};
