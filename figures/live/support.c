// support.c - which corner lies furthest along d?  Corner by corner, with the line
// of furthest() lit (chapter 4).

#include "gjk.h"
#include "live.h"

enum { CORNERS = 7, PACE = 24, REST = 90 };     // frames a corner, at the end

static const vec3 A[CORNERS] = {
    { -1.9, -0.35, 0 }, { -0.9, -1.05, 0 }, { 0.5, -1.0, 0 }, { 1.55, -0.4, 0 },
    { 1.7, 0.35, 0 }, { 0.3, 1.0, 0 }, { -1.35, 0.7, 0 }
};
static vec3 tip = { 1.9, 0.75, 0 };             // of d, which begins at the origin
static int now, best, frame;                    // corner that is asked; so far
static real height[CORNERS];                    // of each, times the length of d

static void begin(void)
{
    now = 0, best = 0, frame = 0;
    for (int k = 0; k < CORNERS; k++) height[k] = vec3_dot(tip, vec3_sub(A[k], A[0]));
}

static real along(int k)                        // m, from corner 0
{
    return height[k] / vec3_length(tip);
}

static void tell(void)
{
    static const vec3 nothing = { 0, 0, 0 };
    corner w = hull_support((hull){ A, CORNERS }, (hull){ &nothing, 1 }, tip);
    if (now == CORNERS)
        live_say("Corner %d is the support of A along d: all of A lies behind the line through it. hull_support says corner %d.", best, w.a);
    else if (now == 0)
        live_say("Begin with corner 0: heights along d are measured from it.");
    else
        live_say("Corner %d is %.2f m along d. The furthest so far is corner %d, with %.2f m.", now, along(now), best, along(best));
    live_light(now == 0 ? "int best = 0" : now == CORNERS ? "return best"
               : frame < PACE / 2 ? "real height =" : "if (height > most)");
}

static void step(void)
{
    if (++frame == (now == CORNERS ? REST : PACE)) {
        if (now == CORNERS) begin();
        else now++, frame = 0;
    }
    // The test of the second half of a corner's time.
    if (now < CORNERS && frame >= PACE / 2 && height[now] > height[best]) best = now;
    tell();
}

static void move(int number, vec3 to)
{
    (void)number;
    real long_enough = vec3_length(to) > 0.4 ? 1 : 0.4 / real_max(vec3_length(to), 0.01);
    tip = vec3_make(long_enough * to.x, long_enough * to.y, 0);
    begin();
    tell();
}

// --- Drawing ----------------------------------------------------------------------
// The line across d through a corner: nothing of A that is lower lies beyond it.
static void draw_across(live_colour c, int k)
{
    vec3 d = vec3_unit(tip), side = { -d.y, d.x, 0 };
    live_dashes(c, (vec3[]){ vec3_add_scaled(A[k], -6, side), vec3_add_scaled(A[k], 6, side) }, 2);
}

static void draw(void)
{
    static const char *const digit[CORNERS] = { "0", "1", "2", "3", "4", "5", "6" };
    live_area(LIVE_BLUE, A, CORNERS);
    if (now < CORNERS && now != best) draw_across(LIVE_QUIET, now);
    draw_across(LIVE_GREEN, best);
    for (int k = 0; k < CORNERS; k++) {
        bool is_now = k == now, is_best = k == best;
        live_dot(is_best ? LIVE_GREEN : is_now ? LIVE_ORANGE : LIVE_BLUE, A[k], is_best || is_now ? 7 : 4);
        live_label(is_best ? LIVE_GREEN : LIVE_QUIET, vec3_add_scaled(vec3_add(A[k], vec3_make(-0.05, -0.05, 0)), 0.17, vec3_unit(A[k])), digit[k]);
    }
    live_arrow(LIVE_INK, vec3_make(0, 0, 0), tip);
    live_label(LIVE_INK, vec3_add_scaled(tip, 0.2, vec3_unit(tip)), "d");
    live_label(LIVE_BLUE, vec3_make(-0.6, 0.1, 0), "A");
    live_handle(0, LIVE_INK, tip, "direction d");
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, height, sizeof height);
    return live_hash(h, (int[]){ now, best, frame }, 3 * sizeof(int));
}

const live_figure figure = {
    .name = "support",
    .says = "A polygon A with numbered corners, and a direction d; a line across d goes through the corner that is furthest along it",
    .code = "lib/paper/gjk.c furthest",
    .pane = { { -3.1, -1.55, 6.2, 3.1 } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move,
};
