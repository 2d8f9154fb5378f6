// fade.c - a rope is struck, and relaxed in two orders: the rough part of its error is
// gone soon, the smooth part fades as slowly in one order as in the other (chapter 8).

#include "live.h"
#include "constraint.h"

#include <stdio.h>

enum { STICKS };                                // dial
enum { MOST = 40, ORDERS = 2, PACE = 7, REST = 90, ROUNDS = 90 };
static const real SIDE = 0.25, BLOW = 0.2;      // m
static const char *const NAME[ORDERS] = { "from end to end", "from the blow outwards" };

static particle p[ORDERS][MOST + 1];
static stick s[MOST];
static int order[ORDERS][MOST];
static real worst[ORDERS], before[ORDERS];
static real struck = 0.35;                      // of the length
static int sticks, rounds, frame;

static int hit(void)
{
    return int_min(int_max((int)(struck * sticks + 0.5), 1), sticks - 1);
}

// From the blow to both sides, in turns.
static void sort(void)
{
    int n = 0;
    for (int k = 0; k < sticks; k++) order[0][k] = k;
    for (int d = 0; d < sticks; d++) {
        if (hit() + d < sticks) order[1][n++] = hit() + d;
        if (hit() - 1 - d >= 0) order[1][n++] = hit() - 1 - d;
    }
}

static real strain(int which, int k)
{
    const particle *q = p[which];
    return fabs(vec3_distance(q[k].position, q[k + 1].position) / SIDE - 1);
}

static void look(int which)
{
    before[which] = worst[which];
    worst[which] = 0;
    for (int k = 0; k < sticks; k++) worst[which] = real_max(worst[which], strain(which, k));
}

static void tell(void)
{
    if (rounds == 0) live_say("Struck aside by %.0f %% of a stick. Only two sticks are wrong.", 100 * BLOW / SIDE);
    else
        live_say("Round %d leaves %.3f of the worst strain from end to end, and %.3f outwards.", rounds,
                 worst[0] / before[0], worst[1] / before[1]);
}

static void begin(void)
{
    sticks = (int)live_dial(STICKS);
    rounds = frame = 0;
    sort();
    for (int k = 0; k < sticks; k++) s[k] = (stick){ k, k + 1, SIDE, 1, STICK_EXACT };
    for (int which = 0; which < ORDERS; which++) {
        for (int k = 0; k <= sticks; k++) {
            vec3 at = { SIDE * k, k == hit() ? BLOW : 0, 0 };
            p[which][k] = (particle){ at, at, 1 };
        }
        look(which);
    }
    tell();
}

static void relax(void)
{
    for (int which = 0; which < ORDERS; which++) {
        for (int k = 0; k < sticks; k++) stick_relax(s[order[which][k]], p[which], relax_options_pbd());
        look(which);
    }
    rounds++;
}

static void step(void)
{
    bool is_done = rounds == ROUNDS;
    if (++frame >= (is_done || rounds == 0 ? REST / 2 : PACE)) {
        frame = 0;
        if (is_done) begin();
        else relax();
    }
    tell();
}

static void move(int number, vec3 to)
{
    (void)number;
    struck = real_min(real_max((to.x + 2.8) / 5.6, 0), 1);
    begin();
}

// --- Drawing ----------------------------------------------------------------------
static live_colour colour_of(real strain)
{
    return strain > 0.05 ? LIVE_RED : strain > 0.01 ? LIVE_ORANGE : LIVE_BLUE;
}

static real place(int k)
{
    return -2.8 + 5.6 * k / sticks;
}

// Each bar beside the worst of its row, so that the shape of the error is seen.
static void draw_row(int which, real floor)
{
    char words[64];
    for (int k = 0; k < sticks; k++) {
        real high = worst[which] > 0 ? floor + 1.0 * strain(which, k) / worst[which] : floor;
        real gap = 0.12 * (place(1) - place(0));
        live_area(colour_of(strain(which, k)), (vec3[]){ { place(k) + gap, floor, 0 }, { place(k + 1) - gap, floor, 0 },
                  { place(k + 1) - gap, high, 0 }, { place(k) + gap, high, 0 } }, 4);
    }
    live_line(LIVE_RULE, (vec3[]){ { -2.8, floor, 0 }, { 2.8, floor, 0 } }, 2);
    snprintf(words, sizeof words, "%s: worst strain %.2f %%", NAME[which], 100 * worst[which]);
    live_label(LIVE_INK, vec3_make(-2.8, floor + 1.12, 0), words);
}

static void draw(void)
{
    draw_row(0, 0.2);
    draw_row(1, -1.4);
    live_handle(0, LIVE_INK, vec3_make(place(hit()), 0.2, 0), "blow");
    live_dot(LIVE_INK, vec3_make(place(hit()), -1.4, 0), 4);
}

static unsigned long long hash(void)
{
    unsigned long long h = LIVE_HASH;
    for (int which = 0; which < ORDERS; which++)
        for (int k = 0; k <= sticks; k++) h = live_hash(h, &p[which][k].position, sizeof(vec3));
    return h;
}

const live_figure figure = {
    .name = "fade",
    .says = "Two rows of bars, the strains of the sticks of a rope, which is relaxed from end to end and from the blow outwards; spikes become the same smooth hump",
    .pane = { { -3, -1.6, 6, 3.3 } },
    .dial = { [STICKS] = { "sticks", NULL, 8, MOST, 1, 20, NULL, true } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move,
};
