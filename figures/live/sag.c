// sag.c - as many passes a frame, spent on iterations or on substeps: how far does a
// pile of cubes sag (chapter 13c)?

#include "live.h"

#include "../13/13-tower.h"

#include <stdio.h>

enum { PASSES };                                // dial
enum { PILES = 3, HIGH = 6 };
static const int SUBSTEPS[PILES][PILES] = { { 1, 2, 4 }, { 1, 2, 8 }, { 1, 4, 16 } };
static const real TIMES = 6, APART = 3.2;       // the sag is drawn so large; m
static const live_colour COLOUR[PILES] = { LIVE_ORANGE, LIVE_PURPLE, LIVE_BLUE };

static tower pile[PILES];

static int passes(void) { return 4 << live_choice(PASSES); }

static void begin(void)
{
    for (int k = 0; k < PILES; k++) {
        int n = SUBSTEPS[live_choice(PASSES)][k];
        tower_free(&pile[k]);
        tower_begin(&pile[k], n, passes() / n);
        for (int b = 0; b < HIGH; b++) tower_add(&pile[k], 1);
        tower_find(&pile[k]);
    }
}

static void step(void)
{
    for (int k = 0; k < PILES; k++) tower_frame(&pile[k]);
}

static void measure(void)
{
    live_say("Each pile costs %d passes a frame. The highest cubes have sunk by %.1f, %.1f and %.1f mm.", passes(),
             1000 * tower_sag(&pile[0]), 1000 * tower_sag(&pile[1]), 1000 * tower_sag(&pile[2]));
}

// All are hit from above.
static void press(int button)
{
    (void)button;
    for (int k = 0; k < PILES; k++)
        for (int i = 0; i < FOUR; i++) pile[k].p[HIGH - 1][i].previous.y += 1.5 * pile[k].frame.h;
}

// --- Drawing ----------------------------------------------------------------------
// m: how high cube b is drawn, with its sag TIMES as large.
static real drawn(int k, int b)
{
    real should = b + 0.5, is = rigid4_frame(pile[k].p[b]).center.y;
    return should - TIMES * (should - is);
}

static void draw_pile(int k)
{
    real x = (k - 1) * APART, under = 0;
    for (int b = 0; b < HIGH; b++) {
        real y = drawn(k, b);
        vec3 side[4] = { { x - 0.5, y - 0.5, 0 }, { x + 0.5, y - 0.5, 0 }, { x + 0.5, y + 0.5, 0 }, { x - 0.5, y + 0.5, 0 } };
        vec3 deep[4] = { side[0], side[1], { x + 0.5, under, 0 }, { x - 0.5, under, 0 } };
        live_area(COLOUR[k], side, 4);
        if (under > y - 0.5) live_band(LIVE_RED, deep, 4);
        under = y + 0.5;
    }
    char words[40];
    int n = pile[k].substeps;
    snprintf(words, sizeof words, "%d × %d", n, passes() / n);
    live_label(COLOUR[k], vec3_make(x - 0.4, HIGH + 0.35, 0), words);
}

static void draw(void)
{
    vec3 ground[4] = { { -9, -1.5, 0 }, { 9, -1.5, 0 }, { 9, 0, 0 }, { -9, 0, 0 } };
    live_band(LIVE_GREY, ground, 4);
    live_line(LIVE_QUIET, &ground[2], 2);
    live_dashes(LIVE_QUIET, (vec3[]){ { -4.4, HIGH, 0 }, { 4.4, HIGH, 0 } }, 2);
    for (int k = 0; k < PILES; k++) draw_pile(k);
    live_label(LIVE_QUIET, vec3_make(-6.4, -0.72, 0), "substeps a frame × passes a substep");
}

static unsigned long long hash(void)
{
    unsigned long long h = LIVE_HASH;
    for (int k = 0; k < PILES; k++) h = live_hash(h, pile[k].p, HIGH * sizeof *pile[k].p);
    return h;
}

const live_figure figure = {
    .name = "sag",
    .says = "Three piles of cubes, seen from the side, that sink into each other the more the fewer substeps they have",
    .pane = { { -6.6, -1, 13.2, 7.8 } },
    .dial = { [PASSES] = { "passes a frame", NULL, 0, 2, 1, 1, "4|8|16", true } },
    .button = { "Hit them from above" },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash, .press = press,
};
