// island.c - what touches is one island, and each island takes the substeps that it
// needs: a box, a tower, and a load on a light box (chapter 18).

#include "handle.h"
#include "live.h"
#include "live_world.h"
#include "measure.h"
#include "step.h"

#include <stdio.h>

enum { LOAD };                                  // dial
enum { ALONE, TOWER, LIGHT = 5, HEAVY, BODIES };        // the tower: 1 to 4
enum { ISLANDS = 3 };
static const real SIDE = 0.5;                   // m
static const vec3 START[BODIES] = { { -1.7, 0.4, 0 }, { 0, 0.26, 0 }, { 0, 0.8, 0 }, { 0, 1.35, 0 },
                                    { 0, 1.9, 0 }, { 1.7, 0.26, 0 }, { 1.7, 1.2, 0 } };
static const live_colour COLOUR[ISLANDS] = { LIVE_GREEN, LIVE_BLUE, LIVE_ORANGE };

static world room;
static shape box, load;
static bool is_ready;

static int mass(void)
{
    static const int MASS[] = { 1, 10, 100, 1000 };
    return MASS[live_choice(LOAD)];
}

static void begin(void)
{
    if (is_ready) world_free(&room);
    shape_free(&box);
    shape_free(&load);
    status done = shape_box(&box, vec3_make(SIDE, SIDE, SIDE), 1);
    if (done.ok) done = shape_box(&load, vec3_make(SIDE, SIDE, SIDE), mass());
    world_options how = world_options_default();
    how.time_to_sleep = 3;              // s, to be looked at
    if (done.ok) done = world_init(&room, how);
    is_ready = done.ok;
    if (done.ok) done = world_add_plane(&room, vec3_make(0, 1, 0), 0);
    for (int b = 0; b < BODIES && done.ok; b++)
        done = world_add(&room, b == HEAVY ? &load : &box, placement_at(START[b]), NULL);
    if (!done.ok) live_say("%s", done.why);
}

// The body that stands for the island of body b.
static int island_of(int b)
{
    if (room.sleep.asleep[b]) return room.sleep.island[b];
    while (room.rigid.island[b].parent != b) b = room.rigid.island[b].parent;
    return b;
}

static bool is_first(int b)
{
    for (int k = 0; k < b; k++)
        if (island_of(k) == island_of(b)) return false;
    return true;
}

static void step(void)
{
    if (!is_ready) return;
    if (live_held() >= 0) live_world_pull(&room, live_held(), 0);
    world_step(&room);
    int islands = 0;
    for (int b = 0; b < BODIES; b++) islands += is_first(b);
    live_say("%d island%s; %d of %d bodies sleep.", islands, islands == 1 ? "" : "s", room.report.asleep, BODIES);
}

// Pushes the lone box towards the tower.
static void press(int button)
{
    (void)button;
    if (is_ready) live_world_hurry(&room, ALONE, vec3_make(4.5, 0, 0));
}

// --- Drawing ----------------------------------------------------------------------
// An island has the colour of the place where its first body began.
static live_colour colour_of(int b)
{
    int first = 0;
    while (island_of(first) != island_of(b)) first++;
    return room.sleep.asleep[b] ? LIVE_GREY : COLOUR[first == ALONE ? 0 : first < LIGHT ? 1 : 2];
}

static void draw_box(int b)
{
    placement at = world_where(&room, b);
    vec3 side[4], x = vec3_scale(SIDE / 2, at.x), y = vec3_scale(SIDE / 2, at.y);
    for (int k = 0; k < 4; k++)
        side[k] = vec3_add_scaled(vec3_add_scaled(at.position, k == 0 || k == 3 ? -1 : 1, x), k < 2 ? -1 : 1, y);
    live_area(colour_of(b), side, 4);
    live_handle(b, colour_of(b), at.position, b == HEAVY ? "the load" : "box");
}

// Above its highest body: how many substeps of a frame it takes.
static void draw_count(int b)
{
    real x = 0, high = 0;
    int n = 0;
    for (int k = b; k < BODIES; k++) {
        if (island_of(k) != island_of(b)) continue;
        vec3 at = world_where(&room, k).position;
        x += at.x, n++;
        high = real_max(high, at.y);
    }
    char words[32];
    if (room.sleep.asleep[b]) snprintf(words, sizeof words, "asleep");
    else snprintf(words, sizeof words, "%d substeps", room.rigid.choice[island_of(b)].now);
    live_label(colour_of(b), vec3_make(x / n - 0.42, high + 0.4, 0), words);
}

static void draw(void)
{
    vec3 ground[4] = { { -9, -1, 0 }, { 9, -1, 0 }, { 9, 0, 0 }, { -9, 0, 0 } };
    char words[16];
    live_band(LIVE_GREY, ground, 4);
    live_line(LIVE_QUIET, &ground[2], 2);
    for (int b = 0; b < BODIES && is_ready; b++) {
        draw_box(b);
        if (is_first(b)) draw_count(b);
    }
    snprintf(words, sizeof words, "%d kg", mass());
    if (is_ready) live_label(LIVE_INK, vec3_add(world_where(&room, HEAVY).position, vec3_make(0.32, -0.05, 0)), words);
}

static unsigned long long hash(void)
{
    return is_ready ? world_hash(&room) : 0;
}

const live_figure figure = {
    .name = "island",
    .says = "A box, a tower and a load on a light box, from the side; what touches has one colour, and above it stands how many substeps it takes",
    .pane = { { -3.2, -0.4, 6.4, 3.2 } },
    .dial = { [LOAD] = { "the load, kg", NULL, 0, 3, 1, 2, "1|10|100|1000", true } },
    .button = { "Push the lone box" },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .press = press,
};
