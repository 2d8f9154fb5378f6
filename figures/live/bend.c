// bend.c - strips of silk, denim and card that stick out over the edge of a table, as
// Peirce measured how limp a cloth is (chapter 12).

#include "bend.h"
#include "live.h"

enum { BEYOND };                                // dial
enum { SILK, DENIM, CARD, STRIPS };
enum { LINKS = 24, PARTICLES = LINKS + 2, SUBSTEPS = 16 };
static const real DENSITY[STRIPS] = { 0.06, 0.4, 0.3 };         // kg/m^2
static const real STIFFNESS[STRIPS] = { 5e-6, 1e-4, 0.016 };    // N m, of a metre of width
static const char *const NAME[STRIPS] = { "silk", "denim", "card" };
static const live_colour COLOUR[STRIPS] = { LIVE_PURPLE, LIVE_BLUE, LIVE_ORANGE };
static const real APART = 0.25, H = 1.0 / 60 / SUBSTEPS;        // m, s
static const real AIR = 5;                      // 1/s, slows all down

static shape strip;
static line_scratch *scratch;
static bend_row room[PARTICLES];
static particle p[STRIPS][PARTICLES];
static bool is_held[STRIPS];
static vec3 held_at[STRIPS];

// The edge of each table.
static vec3 edge_of(int k) { return vec3_make((k - 1) * APART - 0.07, 0, 0); }

// The clamp grips the first link in its middle, and only half a link hangs on the last
// particle.  Nothing else is of the material.
static void begin(void)
{
    real link = live_dial(BEYOND) / 100 / (LINKS + 0.5);
    line_scratch_free(scratch);
    shape_free(&strip);
    scratch = NULL;
    if (shape_rope(&strip, LINKS + 1, (LINKS + 1) * link, 1).ok) scratch = line_scratch_new(&strip);
    for (int k = 0; k < STRIPS; k++) {
        is_held[k] = false;
        for (int i = 0; i < PARTICLES; i++) {
            vec3 x = vec3_add(edge_of(k), vec3_make((i - 0.5) * link, 0, 0));
            real mass = DENSITY[k] * (i == PARTICLES - 1 ? link / 2 : link);
            p[k][i] = (particle){ x, x, i > 1 ? 1 / mass : 0 };
        }
    }
}

static void pull_end(int k)
{
    particle *end = &p[k][PARTICLES - 1];
    vec3 moved = vec3_sub(end->position, end->previous);
    vec3 a = vec3_add_scaled(vec3_scale(400, vec3_sub(held_at[k], end->position)), -40 / H, moved);
    end->previous = vec3_add_scaled(end->previous, -H * H, a);
}

static void substep(int k)
{
    relax_options o = relax_options_default();
    o.gradient = GRADIENT_OLD;
    for (int i = 2; i < PARTICLES; i++)
        p[k][i].previous = vec3_add_scaled(p[k][i].previous, AIR * H, vec3_sub(p[k][i].position, p[k][i].previous));
    if (is_held[k]) pull_end(k);
    verlet_step(p[k], PARTICLES, vec3_make(0, -9.81, 0), NULL, H);
    bend_relax(&strip, STIFFNESS[k], p[k], H, room);
    lines_relax(&strip, p[k], 1, 10, o, NULL, 0, scratch);
}

static void step(void)
{
    for (int k = 0; k < STRIPS && scratch; k++)
        for (int n = 0; n < SUBSTEPS; n++) substep(k);
}

static real hangs(int k) { return -100 * p[k][PARTICLES - 1].position.y; }

static void measure(void)
{
    live_say("The ends hang %.1f, %.1f and %.1f cm below the clamp.", hangs(SILK), hangs(DENIM), hangs(CARD));
}

static void move(int number, vec3 to)
{
    is_held[number] = true;
    held_at[number] = vec3_make(to.x, to.y, 0);
}

static void release(int number)
{
    is_held[number] = false;
}

// --- Drawing ----------------------------------------------------------------------
static void draw_block(live_colour c, vec3 edge, real left, real low, real high)
{
    vec3 block[4] = { { edge.x - left, low, 0 }, { edge.x, low, 0 }, { edge.x, high, 0 }, { edge.x - left, high, 0 } };
    live_band(c, block, 4);
    live_line(c, low < -0.1 ? &block[2] : block, 2);
}

static void draw(void)
{
    for (int k = 0; k < STRIPS; k++) {
        vec3 at[PARTICLES + 1], edge = edge_of(k);
        at[0] = vec3_make(edge.x - 0.06, 0, 0);
        for (int i = 0; i < PARTICLES; i++) at[i + 1] = p[k][i].position;
        draw_block(LIVE_QUIET, edge, 0.07, -0.3, -0.004);
        draw_block(LIVE_QUIET, edge, 0.03, 0.004, 0.013);
        live_line(COLOUR[k], at, PARTICLES + 1);
        live_label(COLOUR[k], vec3_make(edge.x - 0.07, 0.026, 0), NAME[k]);
        live_handle(k, COLOUR[k], at[PARTICLES], NAME[k]);
    }
}

static unsigned long long hash(void)
{
    return live_hash(LIVE_HASH, p, sizeof p);
}

const live_figure figure = {
    .name = "bend",
    .says = "Three strips are clamped at the edge of a table: silk hangs straight down, denim in a curve, card stands out",
    .pane = { { -0.4, -0.225, 0.8, 0.28 } },
    .dial = { [BEYOND] = { "beyond the edge", "cm", 3, 20, 1, 10, NULL, true } },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash, .move = move, .release = release,
};
