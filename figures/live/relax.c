// relax.c - push, move, relax: a box that overlaps the floor, phase by phase, and
// beside it one whose speed of parting is never taken back (chapter 13c).

#include "live.h"

#include "../13/13-tower.h"

enum { RELAXED, KEPT, BOXES };                  // the box that is relaxed; the other one
enum { SLOWEST = 36, LAST = 200 };              // frames of a phase; substeps
typedef enum { WARM, PUSH, MOVE, RELAX, PHASES } phase;
static const real HALF = 0.5, ASIDE = 1.3;      // m, of a cube; of its middle
static const live_colour COLOUR[BOXES] = { LIVE_BLUE, LIVE_ORANGE };

static tower box[BOXES];
static real depth = 0.16;                       // m, at first
static real before[BOXES], highest;             // m, of middles: before the move; ever
static phase now;
static int frame, substep;

static plain_solver solver_of(tower *t)
{
    return (plain_solver){ &t->frame, t->list, t->cubes, t->gap, t->velocity, t->moved, t->body,
                           t->is_first, t->strikes };
}

static real height(int k) { return box[k].body[0].frame.center.y; }
static real speed(int k) { return box[k].velocity[0].of[1]; }

// One phase of plain_substep(), of both boxes.
static void run(void)
{
    for (int k = 0; k < BOXES; k++) {
        tower *t = &box[k];
        if (now == WARM) tower_find(t);
        plain_solver s = solver_of(t);
        before[k] = height(k);
        if (now == WARM) {
            plain_begin(&s);
            t->velocity[0].of[1] -= 9.81 * t->frame.h;
            plain_warm_start(&s);
        } else if (now == PUSH) plain_push(&s);
        else if (now == MOVE) plain_move(&s);
        else if (k == RELAXED) plain_relax(&s);
        if (now == RELAX) tower_put(t);
        highest = real_max(highest, height(KEPT) - HALF);
    }
}

static void tell(void)
{
    static const char *const words[PHASES] = { "plain_warm_start(s)", "plain_push(s)", "plain_move(s)", "plain_relax(s)" };
    real left = 1000 * (HALF - height(RELAXED));
    live_light(words[now]);
    if (substep > 12) live_say("The left box lies still, %.1f mm deep. The right one has jumped %.0f mm high.", 1000 * tower_sag(&box[RELAXED]), 1000 * highest);
    else if (now == WARM) live_say("Substep %d. Gravity, and the push of the last substep: %.2f N s at each corner, on the left.", substep + 1, box[RELAXED].contact[0].impulse[0]);
    else if (now == PUSH) live_say("Push: what overlaps gets a speed of parting, %.2f m/s on the left.", speed(RELAXED));
    else if (now == MOVE) live_say("Move: both go by h times their speed. %.1f mm of overlap are left, on the left.", left);
    else live_say("Relax: on the left that speed is taken back. On the right it stays, %.2f m/s.", speed(KEPT));
}

static void begin(void)
{
    (void)tower_frame;          // here its phases are made one by one
    for (int k = 0; k < BOXES; k++) {
        tower_free(&box[k]);
        tower_begin(&box[k], 2, 1);
        tower_add(&box[k], 1);
        for (int i = 0; i < FOUR; i++) box[k].p[0][i].position.y -= depth, box[k].p[0][i].previous.y -= depth;
    }
    frame = substep = 0;
    highest = 0;
    now = WARM;
    run();
    tell();
}

// The first substeps are seen phase by phase, and then it goes faster and faster.
static int pace(void)
{
    return substep < 2 ? SLOWEST : int_max(1, SLOWEST / (2 * substep - 1));
}

static void step(void)
{
    if (substep > LAST || ++frame < pace()) return;
    frame = 0;
    do {
        now = (now + 1) % PHASES;
        substep += now == WARM;
        run();
    } while (substep > 12 && now != RELAX);
    tell();
}

static void move(int number, vec3 to)
{
    (void)number;
    depth = real_max(-0.3, real_min(0.35, HALF - to.y));
    begin();
}

// --- Drawing ----------------------------------------------------------------------
static void draw_box(int k)
{
    real x = k == RELAXED ? -ASIDE : ASIDE, y = height(k), v = speed(k);
    // A move is seen on its way.
    if (now == MOVE) y = before[k] + (y - before[k]) * real_min(1, 2.0 * (frame + 1) / pace());
    vec3 side[4] = { { x - HALF, y - HALF, 0 }, { x + HALF, y - HALF, 0 }, { x + HALF, y + HALF, 0 }, { x - HALF, y + HALF, 0 } };
    vec3 deep[4] = { side[0], side[1], { x + HALF, 0, 0 }, { x - HALF, 0, 0 } };
    live_area(COLOUR[k], side, 4);
    if (y < HALF) live_area(LIVE_RED, deep, 4);
    if (fabs(v) > 0.02) live_arrow(LIVE_INK, vec3_make(x, y, 0), vec3_make(x, y + 0.25 * v, 0));
    live_label(COLOUR[k], vec3_make(x - HALF, 1.62, 0), k == RELAXED ? "push, move, relax" : "push, move");
    live_handle(k, COLOUR[k], vec3_make(x, y, 0), "box");
}

static void draw(void)
{
    vec3 ground[4] = { { -4, -1, 0 }, { 4, -1, 0 }, { 4, 0, 0 }, { -4, 0, 0 } };
    live_band(LIVE_GREY, ground, 4);
    live_line(LIVE_QUIET, &ground[2], 2);
    for (int k = 0; k < BOXES; k++) draw_box(k);
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, (int[]){ (int)now, frame, substep }, 3 * sizeof(int));
    for (int k = 0; k < BOXES; k++) h = live_hash(h, (real[]){ height(k), speed(k) }, 2 * sizeof(real));
    return h;
}

const live_figure figure = {
    .name = "relax",
    .says = "Two boxes that overlap the floor are pushed out of it; the speed of one is taken back after each move, and the other one jumps",
    .code = "tests/contact/plain_solver.c plain_substep",
    .pane = { { -2.6, -0.5, 5.2, 2.35 } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move,
};
