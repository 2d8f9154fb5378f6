// carry.c - what each contact of a pile pushes, beside what it has to carry: begun
// from nothing in each step, or from the last one (chapter 13b).

#include "handle.h"
#include "live.h"
#include "live_world.h"
#include "measure.h"
#include "step.h"

enum { WARM };                                  // dial
enum { BOXES = 6, SUBSTEPS = 4, SLOW = 6 };     // frames of the page a frame
static const real SIDE = 0.5, MASS = 1, GRAVITY = 9.81;     // m, kg, m/s^2
static const real LONGEST = 3;                  // m, of a bar of all the weights

static world pile;
static shape box;
static bool is_ready;
static int frame, steps;
static real carried[BOXES];                     // N, under each box

static void build(void)
{
    world_options how = world_options_default();
    how.warm_start = live_choice(WARM);
    how.substeps = how.most_substeps = SUBSTEPS;
    how.sleep_speed = 0;
    status done = world_init(&pile, how);
    if (done.ok) done = shape_box(&box, vec3_make(SIDE, SIDE, SIDE), MASS);
    if (done.ok) done = world_add_plane(&pile, vec3_make(0, 1, 0), 0);
    for (int b = 0; b < BOXES && done.ok; b++)
        done = world_add(&pile, &box, placement_at(vec3_make(0, (b + 0.5) * SIDE, 0)), NULL);
    is_ready = done.ok;
    if (!done.ok) live_say("%s", done.why);
}

static void begin(void)
{
    if (is_ready) {
        world_free(&pile);
        shape_free(&box);
    }
    frame = steps = 0;
    for (int b = 0; b < BOXES; b++) carried[b] = 0;
    build();
}

// The push of the last substep, of each contact under a box.
static void look(void)
{
    const contact_cache *c = &pile.rigid.cache;
    real h = 1.0 / 60 / SUBSTEPS;
    for (int b = 0; b < BOXES; b++) carried[b] = 0;
    for (int k = 0; k < c->actives; k++) {
        const contact *one = c->active[k];
        int upper = one->b < 0 ? one->a : int_max(one->a, one->b);
        carried[upper] += contact_load(one) / h;
    }
}

static real top_has_sunk(void)
{
    return (BOXES - 0.5) * SIDE - world_where(&pile, BOXES - 1).position.y;
}

static void step(void)
{
    if (!is_ready || frame++ % SLOW) return;
    world_step(&pile);
    steps++;
    look();
    live_say("After %d frames the lowest contact pushes with %.1f N of %.1f N. The top has sunk by %.1f mm.",
             steps, carried[0], BOXES * MASS * GRAVITY, 1000 * top_has_sunk());
}

static void press(int button)
{
    (void)button;
    if (is_ready) live_world_hurry(&pile, BOXES - 1, vec3_make(0, -1.5, 0));
}

// --- Drawing ----------------------------------------------------------------------
static void draw_box(int b)
{
    placement at = world_where(&pile, b);
    vec3 side[4], x = vec3_scale(SIDE / 2, at.x), y = vec3_scale(SIDE / 2, at.y);
    for (int k = 0; k < 4; k++)
        side[k] = vec3_add_scaled(vec3_add_scaled(at.position, k == 0 || k == 3 ? -1 : 1, x), k < 2 ? -1 : 1, y);
    live_area(LIVE_BLUE, side, 4);
}

static void draw_bar(int b)
{
    real scale = LONGEST / (BOXES * MASS * GRAVITY), y = b * SIDE, high = 0.13;
    real has = scale * carried[b], wants = scale * (BOXES - b) * MASS * GRAVITY;
    real long_enough = real_min(has, 1.25 * LONGEST);
    vec3 bar[4] = { { 0.4, y, 0 }, { 0.4 + long_enough, y, 0 }, { 0.4 + long_enough, y + high, 0 }, { 0.4, y + high, 0 } };
    live_area(fabs(has - wants) < 0.05 * wants ? LIVE_GREEN : LIVE_RED, bar, 4);
    live_dashes(LIVE_INK, (vec3[]){ { 0.4 + wants, y - 0.06, 0 }, { 0.4 + wants, y + high + 0.06, 0 } }, 2);
}

static void draw(void)
{
    live_line(LIVE_RULE, (vec3[]){ { -2, 0, 0 }, { 0.35, 0, 0 } }, 2);
    for (int b = 0; b < BOXES && is_ready; b++) {
        draw_box(b);
        draw_bar(b);
    }
    live_label(LIVE_QUIET, vec3_make(0.4, BOXES * SIDE - 0.08, 0), "what each contact pushes");
}

static unsigned long long hash(void)
{
    return is_ready ? world_hash(&pile) : 0;
}

const live_figure figure = {
    .name = "carry",
    .says = "A pile of six boxes from the side; beside each contact a bar as long as its push, and a mark at the weight above it",
    .pane = { { -2.1, -0.55, 6.4, 3.8 } },
    .dial = { [WARM] = { "contacts begin", NULL, 0, 1, 1, 0, "from nothing|from the last step", true } },
    .button = { "Hit the top" },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .press = press,
};
