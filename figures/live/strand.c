// strand.c - a rope with a load: stick by stick, and all links at once
// (chapter 12).

#include "line.h"
#include "live.h"

enum { LOAD, ITERATIONS, NEWTON, SUBSTEPS };    // dials
enum { ALONG, WORST };                          // charts
enum { BY_STICKS, AT_ONCE, ROPES };             // ropes, panes and lines of charts
enum { LINKS = 50, END = LINKS };
static const real LOWEST = -4;                  // m, there the load is given up
static const vec3 GRAVITY = { 0, -9.81, 0 };
static const live_colour COLOUR[ROPES] = { LIVE_ORANGE, LIVE_BLUE };

static shape plan;
static line_scratch *scratch;
static particle rope[ROPES][LINKS + 1];
static vec3 pin = { 0, 0, 0 };
static bool is_held[ROPES], is_lost;
static vec3 held_at[ROPES];

static real load(void)
{
    static const real MASS[] = { 1, 100, 1000 };
    return MASS[live_choice(LOAD)];
}

static real substep(void)
{
    return 1 / (60 * live_dial(SUBSTEPS));
}

static void begin(void)
{
    const vec3 along = { -0.6, -0.8, 0 };
    if (!scratch) {
        status done = shape_rope(&plan, LINKS, 1, 1);
        if (done.ok) scratch = line_scratch_new(&plan);
        if (!scratch) return;
    }
    for (int r = 0; r < ROPES; r++) {
        for (int i = 0; i <= LINKS; i++) {
            real w = i == 0 ? 0 : i == END ? 1 / load() : 1;
            vec3 x = vec3_add_scaled(pin, (real)i / LINKS, along);
            rope[r][i] = particle_start(x, vec3_make(0, 0, 0), GRAVITY, w, substep());
        }
        is_held[r] = false;
    }
    is_lost = false;
}

static void pull_load(int r)
{
    particle *p = &rope[r][END];
    real h = substep();
    vec3 moved = vec3_sub(p->position, p->previous), way = vec3_sub(held_at[r], p->position);
    p->previous = vec3_add_scaled(vec3_add_scaled(p->previous, 8 * h, moved), -60 * h * h, way);
}

static void solve(int r)
{
    relax_options o = relax_options_pbd();
    o.tolerance = 0;
    if (r == AT_ONCE) {
        line_solve(shape_strands(&plan, 0), rope[r], (int)live_dial(NEWTON), o, scratch);
        return;
    }
    for (int k = 0; k < (int)live_dial(ITERATIONS); k++) sticks_iterate(plan.stick, LINKS, rope[r], o);
}

static void step(void)
{
    if (!scratch) return;
    for (int r = 0; r < ROPES; r++)
        for (int k = 0; k < (int)live_dial(SUBSTEPS); k++) {
            if (r == BY_STICKS && is_lost) break;
            if (is_held[r]) pull_load(r);
            verlet_step(rope[r], LINKS + 1, GRAVITY, NULL, substep());
            solve(r);
        }
    is_lost = is_lost || rope[BY_STICKS][END].position.y < LOWEST;
}

static void measure(void)
{
    real worst[ROPES] = { 0 };
    for (int r = 0; r < ROPES && scratch; r++) {
        real strain[LINKS];
        for (int i = 0; i < LINKS; i++) {
            strain[i] = real_max(1e-13, stick_strain(plan.stick[i], rope[r]));
            worst[r] = real_max(worst[r], strain[i]);
        }
        live_curve(ALONG, r, strain, LINKS);
        live_value(WORST, r, worst[r]);
    }
    if (is_lost) live_say("Stick by stick the load is lost. Start again with more iterations, or with a smaller load.");
    else live_say("The worst link is too long by %.2g times its length stick by stick, and by %.2g times all at once.",
                  worst[BY_STICKS], worst[AT_ONCE]);
}

// The load, as large as it is heavy, below the end of its rope.
static void draw_load(vec3 at)
{
    static const real WIDE[] = { 0.08, 0.2, 0.42 };
    static const char *const mass[] = { "1", "100", "1,000" };
    real w = WIDE[live_choice(LOAD)] / 2;
    vec3 box[4] = { { at.x - w, at.y, 0 }, { at.x + w, at.y, 0 }, { at.x + 1.1 * w, at.y - 1.6 * w, 0 }, { at.x - 1.1 * w, at.y - 1.6 * w, 0 } };
    live_area(LIVE_INK, box, 4);
    if (live_choice(LOAD) > 0) live_label(LIVE_INK, vec3_make(at.x - 0.07 * live_choice(LOAD), at.y - w - 0.06, 0), mass[live_choice(LOAD)]);
}

static void draw(void)
{
    static const char *const name[ROPES] = { "stick by stick", "all links at once" };
    for (int r = 0; r < ROPES; r++) {
        vec3 at[LINKS + 1];
        for (int i = 0; i <= LINKS; i++) at[i] = rope[r][i].position;
        live_pane(r);
        live_line(LIVE_QUIET, (vec3[]){ { -0.4, 0, 0 }, { 0.4, 0, 0 } }, 2);
        draw_load(at[END]);
        live_line(COLOUR[r], at, LINKS + 1);
        for (int i = 0; i < LINKS && scratch; i++)
            if (stick_strain(plan.stick[i], rope[r]) > 0.1) live_line(LIVE_RED, &at[i], 2);
        for (int i = 0; i <= LINKS; i += 5) live_dot(COLOUR[r], at[i], 3);
        live_dot(LIVE_INK, at[0], 4);
        live_label(COLOUR[r], vec3_make(-1.05, 0.14, 0), name[r]);
        live_handle(r, LIVE_INK, at[END], "the load");
    }
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

static unsigned long long hash(void)
{
    return live_hash(LIVE_HASH, rope, sizeof rope);
}

const live_figure figure = {
    .name = "strand",
    .says = "Two ropes swing with a heavy load: the links of one are corrected one after the other, those of the other all at once",
    .pane = { { -1.15, -1.75, 2.3, 2.05 }, { -1.15, -1.75, 2.3, 2.05 } },
    .dial = {
        [LOAD] = { "mass of the load, in particles", NULL, 0, 2, 1, 2, "1|100|1,000", true },
        [ITERATIONS] = { "iterations, one by one", NULL, 1, 300, 1, 16, NULL, false },
        [NEWTON] = { "Newton steps, at once", NULL, 1, 6, 1, 4, NULL, false },
        [SUBSTEPS] = { "substeps a frame", NULL, 1, 16, 1, 8, NULL, true },
    },
    .chart = {
        [ALONG] = { "strain along the rope", NULL, { "stick by stick", "at once" }, 1e-6, 10, true, false, "link, from the pin" },
        [WORST] = { "worst strain", NULL, { "stick by stick", "at once" }, 1e-6, 10, true, false, NULL },
    },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash, .move = move, .release = release,
};
