// shadow.c - a page that bends, before a lamp: while its shadow has no fold, no two
// points of it are in one place (chapter 16).

#include "live.h"
#include "plane.h"

enum { LAMP };                                  // dial
enum { ABOVE, TURNS };
enum { STEPS = 36, POINTS = STEPS + 1, MOST_BENT = 300, FOLLOWED = 150 };
static const real LONG = 2.2, PACE = 0.6;       // m; degrees a frame
static const vec3 MIDDLE = { 0, 0.25, 0 };      // of the page, wherever it is bent to

static vec3 at[POINTS];
static real bent;                               // degrees, between the ends
static int way;                                 // 1, -1; 0: led by hand

// An arc whose last step has turned by so many degrees.
static void bend_page(void)
{
    vec3 along = { LONG / STEPS, 0, 0 };
    real turn = plane_tangent(bent / (STEPS - 1));
    at[0] = vec3_make(0, 0, 0);
    for (int i = 0; i < STEPS; i++) {
        at[i + 1] = vec3_add(at[i], along);
        along = plane_turned(along, turn);
    }
    vec3 off = vec3_sub(MIDDLE, plane_middle(at, POINTS));
    for (int i = 0; i < POINTS; i++) at[i] = vec3_add(at[i], off);
}

// Unit: along the shadow, and so across the light.  The mean step of the page, or the
// page's first.
static vec3 across(void)
{
    return live_choice(LAMP) == TURNS ? vec3_unit(vec3_sub(at[STEPS], at[0])) : vec3_make(1, 0, 0);
}

static bool goes_back(int i)
{
    return !(vec3_dot(across(), vec3_sub(at[i + 1], at[i])) > 0);
}

static int back_steps(void)
{
    int n = 0;
    for (int i = 0; i < STEPS; i++) n += goes_back(i);
    return n;
}

static void tell(void)
{
    int n = back_steps();
    if (n == 0) live_say("Bent by %.0f°: no step of the shadow goes back. So no two points of the page are in one place.", bent);
    else live_say("Bent by %.0f°: %d steps of the shadow go back (red). Two points have one shadow, and this lamp proves nothing.", bent, n);
}

static void begin(void)
{
    bent = 30;
    way = 1;
    bend_page();
    tell();
}

static void step(void)
{
    bent += PACE * way;
    if (bent > 240 || bent < 15) way = -way;
    bend_page();
    tell();
}

// The bend that brings the page's end nearest to the hand.
static void move(int number, vec3 to)
{
    real best = HUGE_VAL, found = bent;
    (void)number;
    way = 0;
    for (int k = 0; k <= 2 * FOLLOWED; k++) {
        bent = (real)k * MOST_BENT / (2 * FOLLOWED);
        bend_page();
        real d = vec3_distance(at[STEPS], vec3_make(to.x, to.y, 0));
        if (d < best) best = d, found = bent;
    }
    bent = found;
    bend_page();
    tell();
}

// --- Drawing ----------------------------------------------------------------------
// Where a point of the page has its shadow: on a line below it, and a little lower where
// it goes back, so that a fold is seen.
static vec3 shadow_of(vec3 point, real lower)
{
    vec3 p = across(), down = { p.y, -p.x, 0 };
    return vec3_add_scaled(vec3_add_scaled(MIDDLE, vec3_dot(p, vec3_sub(point, MIDDLE)), p), 1 + lower, down);
}

static void draw_light(void)
{
    vec3 p = across(), up = { -p.y, p.x, 0 };
    for (int k = -4; k <= 4; k++) {
        vec3 from = vec3_add_scaled(vec3_add_scaled(MIDDLE, 0.3 * k, p), 1.15, up);
        live_arrow(LIVE_QUIET, from, vec3_add_scaled(from, -0.25, up));
    }
}

// The steps that go on are one piece of the page, and those that go back another.
static void draw_pieces(void)
{
    for (int i = 0, n = 0; i < STEPS; i += n) {
        bool is_back = goes_back(i);
        for (n = 1; i + n < STEPS && goes_back(i + n) == is_back;) n++;
        real lower = is_back ? 0.09 : 0;
        live_line(is_back ? LIVE_RED : LIVE_BLUE, &at[i], n + 1);
        live_line(is_back ? LIVE_RED : LIVE_INK, (vec3[]){ shadow_of(at[i], lower), shadow_of(at[i + n], lower) }, 2);
    }
}

static void draw(void)
{
    draw_light();
    for (int i = 0; i < POINTS; i += STEPS / 6) live_dashes(LIVE_RULE, (vec3[]){ at[i], shadow_of(at[i], 0) }, 2);
    draw_pieces();
    live_handle(0, LIVE_BLUE, at[STEPS], "the end of the page");
}

static unsigned long long hash(void)
{
    return live_hash(live_hash(LIVE_HASH, at, sizeof at), &bent, sizeof bent);
}

const live_figure figure = {
    .name = "shadow",
    .says = "A page, seen from its edge, bends up and over; below it is its shadow, which is red where it goes back",
    .pane = { { -2.7, -1.1, 5.4, 2.6 } },
    .dial = { [LAMP] = { "the lamp", NULL, 0, 1, 1, 0, "stays above|turns with the page", true } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move,
};
