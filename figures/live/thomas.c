// thomas.c - Thomas's walk: down the string each particle learns what it owes to the
// next, and up it all know where they are (chapter 12).

#include "live.h"
#include "taut.h"

enum { PULL };                                  // dial
enum { PARTICLES = 9, PACE = 14, REST = 110 };  // frames a particle, at the end
typedef enum { DOWN, UP, DONE } phase;

static vec3 hand[PARTICLES];                    // where the step before has left them
static real x[PARTICLES], y[PARTICLES], z[PARTICLES], weight[PARTICLES], stiffness[PARTICLES];
static real room[4 * PARTICLES];                // h of all, then g of all
static phase now;
static int at, frame;                           // the particle that is reached

static real h_of(int k) { return room[k]; }

// All of it is the library's one call; the picture then shows its numbers one by one.
static void solve(void)
{
    for (int k = 0; k < PARTICLES; k++) {
        x[k] = hand[k].x, y[k] = hand[k].y, z[k] = 0;
        weight[k] = k == 0 || k == PARTICLES - 1 ? 0 : 1;
        stiffness[k] = live_dial(PULL);
    }
    taut_step((taut_string){ PARTICLES, 1, x, y, z, weight, stiffness }, room);
}

static void tell(void)
{
    if (now == DOWN) live_say("Down, particle %d: where it will be is g + %.2f of where the next one will be. Nobody knows that yet.", at, h_of(at));
    else if (now == UP) live_say("Up, particle %d: the next one is known, and so is this one.", at);
    else live_say("One walk down and one up: all %d particles are where all pulls agree.", PARTICLES);
    live_light(now == DOWN ? frame < PACE / 2 ? "real scale =" : "h[k] = scale" : now == UP ? "x[c] = g[3 * k + c]" : "");
}

static void begin(void)
{
    now = DOWN, at = frame = 0;
    solve();
    tell();
}

static void reset(void)
{
    for (int k = 0; k < PARTICLES; k++) {
        real side = k % 2 ? 1 : -1;
        bool pinned = k == 0 || k == PARTICLES - 1;
        hand[k] = vec3_make(-2.4 + 0.6 * k, pinned ? 0 : 0.45 * side + 0.12 * k - 0.3, 0);
    }
    begin();
}

static void step(void)
{
    if (++frame >= (now == DONE ? REST : PACE)) {
        frame = 0;
        if (now == DOWN && ++at == PARTICLES) now = UP, at = PARTICLES - 1;
        else if (now == UP && --at < 0) now = DONE;
        else if (now == DONE) begin();
    }
    tell();
}

static void move(int number, vec3 to)
{
    hand[number] = vec3_make(to.x, to.y, 0);
    begin();
}

// --- Drawing ----------------------------------------------------------------------
static bool is_known(int k)
{
    return now == DONE || (now == UP && k >= at);
}

static void draw(void)
{
    vec3 known[PARTICLES];
    int n = 0;
    live_line(LIVE_GREY, hand, PARTICLES);
    for (int k = 0; k < PARTICLES; k++)
        if (is_known(k)) known[n++] = vec3_make(x[k], y[k], 0);
    live_line(LIVE_GREEN, known, n);
    for (int k = 0; k < PARTICLES; k++) {
        vec3 here = { x[k], y[k], 0 };
        // What it owes to the next one is still open: as long an arrow towards it.
        if (now == DOWN && k <= at && k + 1 < PARTICLES)
            live_arrow(k == at ? LIVE_ORANGE : LIVE_PURPLE, hand[k], vec3_add_scaled(hand[k], h_of(k), vec3_sub(hand[k + 1], hand[k])));
        if (is_known(k)) live_dot(now == UP && k == at ? LIVE_ORANGE : LIVE_GREEN, here, 6);
    }
    for (int k = 0; k < PARTICLES; k++) live_handle(k, now == DOWN && k == at ? LIVE_ORANGE : weight[k] > 0 ? LIVE_GREY : LIVE_INK, hand[k], k == 0 || k == PARTICLES - 1 ? "pin" : "particle");
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, x, sizeof x);
    h = live_hash(h, y, sizeof y);
    h = live_hash(h, room, sizeof room);
    return live_hash(h, (int[]){ (int)now, at }, 2 * sizeof(int));
}

const live_figure figure = {
    .name = "thomas",
    .says = "A string of nine particles in a zigzag; a walk down it leaves an arrow at each, a walk up puts each where it will be",
    .code = "lib/soft/taut.c eliminate_string taut_step",
    .pane = { { -3.1, -1.1, 6.2, 2.35 } },
    .dial = { [PULL] = { "stiffness", "kg", 0.1, 10, 0.1, 2, NULL, true } },
    .begin = reset, .step = step, .draw = draw, .hash = hash, .move = move,
};
