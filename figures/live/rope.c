// rope.c - a rope of springs beside a rope of sticks (chapter 2).

#include "constraint.h"
#include "live.h"

enum { STEPS, STIFFNESS, ITERATIONS };          // dials
enum { ALONG, TIME };                           // charts
enum { SPRINGS, STICKS, ROPES };                // ropes, panes and lines of charts
enum { LINKS = 50 };
static const real REST = 0.02, MASS = 0.02;     // m, kg
static const vec3 GRAVITY = { 0, -9.81, 0 };
static const live_colour COLOUR[ROPES] = { LIVE_ORANGE, LIVE_BLUE };

static particle rope[ROPES][LINKS + 1];
static stick link[LINKS];
static vec3 pin = { 0, 1.12, 0 };
static bool is_gone;                            // the springs have exploded

static real dt(void)
{
    return 1 / (60 * live_dial(STEPS));
}

static real stiffness(void)
{
    static const real KAPPA[] = { 500, 5000, 50000 };
    return KAPPA[live_choice(STIFFNESS)];
}

static void begin(void)
{
    const vec3 along = { -0.6428, -0.7660, 0 };     // 40 degrees off the vertical
    for (int k = 0; k < ROPES; k++)
        for (int i = 0; i <= LINKS; i++)
            rope[k][i] = particle_start(vec3_add_scaled(pin, i * REST, along),
                                        vec3_make(0, 0, 0), GRAVITY, i > 0 ? 1 / MASS : 0, dt());
    for (int i = 0; i < LINKS; i++)
        link[i] = (stick){ i, i + 1, REST, 1, STICK_EXACT };
    is_gone = false;
}

static real worst(const particle *p)
{
    real most = 0;
    for (int i = 0; i < LINKS; i++) most = real_max(most, stick_strain(link[i], p));
    return most;
}

static void step_springs(particle *p)
{
    if (is_gone) return;
    vec3 force[LINKS + 1] = { { 0, 0, 0 } };
    for (int i = 0; i < LINKS; i++) {
        vec3 d = vec3_sub(p[i + 1].position, p[i].position);
        real pull = stiffness() * (vec3_length(d) - REST);
        force[i] = vec3_add_scaled(force[i], pull, vec3_unit(d));
        force[i + 1] = vec3_add_scaled(force[i + 1], -pull, vec3_unit(d));
    }
    verlet_step(p, LINKS + 1, GRAVITY, force, dt());
    is_gone = worst(p) > 1000;
}

static void step_sticks(particle *p)
{
    verlet_step(p, LINKS + 1, GRAVITY, NULL, dt());
    for (int k = 0; k < (int)live_dial(ITERATIONS); k++)
        sticks_iterate(link, LINKS, p, relax_options_pbd());
}

static void step(void)
{
    for (int k = 0; k < (int)live_dial(STEPS); k++) {
        step_springs(rope[SPRINGS]);
        step_sticks(rope[STICKS]);
    }
}

static void measure(void)
{
    for (int k = 0; k < ROPES; k++) {
        real strain[LINKS];
        for (int i = 0; i < LINKS; i++) strain[i] = 100 * stick_strain(link[i], rope[k]);
        live_curve(ALONG, k, strain, LINKS);
    }
    // Neighbours that swing against each other: omega = 2 sqrt(k / m).
    live_say("For the springs, omega times the step is %.2f. From 2 on they explode.%s",
             2 * sqrt(stiffness() / MASS) * dt(), is_gone ? " They have." : "");
}

static void draw_rope(int k)
{
    vec3 at[LINKS + 1];
    for (int i = 0; i <= LINKS; i++) at[i] = rope[k][i].position;
    live_line(COLOUR[k], at, LINKS + 1);
    for (int i = 0; i < LINKS; i++)
        if (stick_strain(link[i], rope[k]) > 0.01) live_line(LIVE_RED, &at[i], 2);
    for (int i = 0; i <= LINKS; i += 5) live_dot(COLOUR[k], at[i], 3);
}

static void draw(void)
{
    static const char *const name[ROPES] = { "springs", "sticks" };
    for (int k = 0; k < ROPES; k++) {
        live_pane(k);
        live_line(LIVE_QUIET, (vec3[]){ { pin.x - 0.3, pin.y, 0 }, { pin.x + 0.3, pin.y, 0 } }, 2);
        draw_rope(k);
        live_label(COLOUR[k], vec3_make(-0.74, 1.15, 0), name[k]);
        live_handle(k, LIVE_INK, rope[k][0].position, "the pin of the rope");
    }
}

static void move(int number, vec3 to)
{
    (void)number;
    pin = vec3_make(to.x, to.y, 0);
    for (int k = 0; k < ROPES; k++) rope[k][0].position = rope[k][0].previous = pin;
}

static unsigned long long hash(void)
{
    unsigned long long h = LIVE_HASH;
    for (int k = 0; k < ROPES; k++)
        for (int i = 0; i <= LINKS; i++)
            h = live_hash(h, &rope[k][i].position, sizeof(vec3));
    return h;
}

const live_figure figure = {
    .name = "rope",
    .says = "A rope of springs and a rope of sticks, each in a panel of its own, swing from a pin; links that are wrong by more than a hundredth are red",
    .pane = { { -0.8, -0.02, 1.6, 1.28 }, { -0.8, -0.02, 1.6, 1.28 } },
    .dial = {
        [STEPS] = { "steps a frame", NULL, 1, 60, 1, 28, NULL, true },
        [STIFFNESS] = { "stiffness of a spring, N/m", NULL, 0, 2, 1, 2, "500|5,000|50,000", true },
        [ITERATIONS] = { "iterations of sticks", NULL, 1, 60, 1, 1, NULL, false },
    },
    .chart = {
        [ALONG] = { "strain along the rope, %", NULL, { "springs", "sticks" }, 1e-3, 10, true, false, "link, from the pin" },
        [TIME] = { "time of a frame, both", "ms", { NULL }, 0, 0.1, false, true, NULL },
    },
    .begin = begin, .step = step, .measure = measure, .draw = draw, .hash = hash, .move = move,
};
