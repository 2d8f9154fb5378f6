// walk.c - an iteration goes from stick to stick, and what is too long walks along
// the chain (chapter 2).

#include "constraint.h"
#include "live.h"

enum { ORDER };                                 // dial
enum { OUTWARDS, INWARDS };
enum { STICKS = 8, PARTICLES = STICKS + 1, PACE = 16, REST = 120, MOST = 12 };
static const real LENGTH = 0.5;                 // m
static const real DONE = 1e-3;                  // strain that nobody sees

static particle p[PARTICLES];
static stick s[STICKS];
static vec3 end = { 2.75, 0.35, 0 };            // where the last particle is held
static int turn, count, frame;                  // of the sticks; iterations
static real error, worst;                       // m, of the stick before it moved
static bool is_done, has_moved;

// How wrong is a stick now?  m, > 0: too long.
static real wrong(int k)
{
    return vec3_distance(p[s[k].a].position, p[s[k].b].position) - LENGTH;
}

static int stick_number(void)
{
    return live_choice(ORDER) == OUTWARDS ? turn : STICKS - 1 - turn;
}

static void tell(void)
{
    if (is_done)
        live_say("After %d iterations no stick is wrong by more than %.1f mm.", count, 1000 * worst);
    else
        live_say("Iteration %d, stick %d of %d: it %s wrong by %.0f mm. The worst is now wrong by %.0f mm.", count + 1,
                 stick_number() + 1, STICKS, frame < PACE / 2 ? "is" : "was", 1000 * fabs(error), 1000 * worst);
    live_light(is_done || frame < PACE / 2 || !has_moved ? "if (fabs(c.error)" : "a->position =");
}

static void find_worst(void)
{
    worst = 0;
    for (int k = 0; k < STICKS; k++) worst = real_max(worst, fabs(wrong(k)));
}

// A straight chain; then its end is held elsewhere, and only the last stick is wrong.
static void begin(void)
{
    for (int i = 0; i < PARTICLES; i++)
        p[i] = (particle){ { -2.2 + LENGTH * i, 0, 0 }, { -2.2 + LENGTH * i, 0, 0 }, i == 0 || i == STICKS ? 0 : 1 };
    for (int k = 0; k < STICKS; k++) s[k] = (stick){ k, k + 1, LENGTH, 1, STICK_EXACT };
    p[STICKS].position = end;
    turn = count = frame = 0;
    is_done = false;
    error = wrong(stick_number());
    find_worst();
    tell();
}

static void next(void)
{
    frame = 0;
    if (++turn == STICKS) {
        turn = 0;
        count++;
        is_done = worst < DONE * LENGTH || count == MOST;
    }
    error = wrong(stick_number());
}

// In the middle of its time a stick is corrected.
static void step(void)
{
    frame++;
    if (is_done && frame == REST) begin();
    if (!is_done && frame == PACE / 2) has_moved = stick_relax(s[stick_number()], p, relax_options_pbd()).moved;
    if (!is_done && frame == PACE) next();
    find_worst();
    tell();
}

static void move(int number, vec3 to)
{
    (void)number;
    end = vec3_make(to.x, to.y, 0);
    begin();
}

// --- Drawing ----------------------------------------------------------------------
// Over each stick a bar, as long as it is wrong; above the line: too long.
static void draw_bars(void)
{
    const real base = 1.15, width = 0.15, scale = 2;
    live_line(LIVE_RULE, (vec3[]){ { -2.4, base, 0 }, { 2.0, base, 0 } }, 2);
    for (int k = 0; k < STICKS; k++) {
        real x = -2.2 + LENGTH * (k + 0.5), top = base + real_max(-0.3, real_min(0.6, scale * wrong(k)));
        vec3 bar[4] = { { x - width, base, 0 }, { x + width, base, 0 }, { x + width, top, 0 }, { x - width, top, 0 } };
        live_area(!is_done && k == stick_number() ? LIVE_ORANGE : LIVE_RED, bar, 4);
    }
    live_label(LIVE_QUIET, vec3_make(2.15, base - 0.04, 0), "error");
}

static void draw(void)
{
    draw_bars();
    for (int k = 0; k < STICKS; k++) {
        vec3 ends[2] = { p[s[k].a].position, p[s[k].b].position };
        bool is_now = !is_done && k == stick_number();
        live_line(is_now ? LIVE_ORANGE : fabs(wrong(k)) > 0.01 * LENGTH ? LIVE_RED : LIVE_BLUE, ends, 2);
    }
    for (int i = 0; i < STICKS; i++) live_dot(i == 0 ? LIVE_INK : LIVE_BLUE, p[i].position, i == 0 ? 7 : 5);
    live_handle(0, LIVE_INK, end, "end of the chain");
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, &worst, sizeof worst);
    for (int i = 0; i < PARTICLES; i++) h = live_hash(h, &p[i].position, sizeof(vec3));
    return h;
}

const live_figure figure = {
    .name = "walk",
    .says = "A chain of eight sticks between a pin and a hand; bars over it show how much each stick is too long or too short",
    .code = "lib/particles/constraint.c apply",
    .pane = { { -3.1, -1.1, 6.4, 3.0 } },
    .dial = { [ORDER] = { "first", NULL, 0, 1, 1, OUTWARDS, "the stick at the pin|the stick at the hand", true } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move,
};
