// orbit.c - a planet under explicit Euler, Verlet and Runge-Kutta (chapter 1).

#include "live.h"
#include "verlet.h"

enum { STEPS, WORK };                           // dials
enum { EULER, VERLET, RK4, METHODS };
enum { TRAIL = 480, FRAMES_A_REVOLUTION = 80 };
static const real PI = 3.14159265358979323846;
static const live_colour COLOUR[METHODS] = { LIVE_ORANGE, LIVE_BLUE, LIVE_GREEN };

static vec3 start = { 1, 0, 0 };                // where the reader let go
static vec3 x[METHODS], v[METHODS];             // position and velocity now
static particle planet;                         // under Verlet
static real step_length[METHODS], time_of[METHODS], now, energy;
static vec3 trail[METHODS][TRAIL];
static int trails;

static vec3 pull(vec3 at)
{
    real r = vec3_length(at);
    return vec3_scale(-1 / (r * r * r), at);
}

static real energy_of(vec3 at, vec3 velocity)
{
    return vec3_length_squared(velocity) / 2 - 1 / vec3_length(at);
}

static void euler_step(real h)
{
    vec3 a = pull(x[EULER]);
    x[EULER] = vec3_add_scaled(x[EULER], h, v[EULER]);
    v[EULER] = vec3_add_scaled(v[EULER], h, a);
}

static void planet_step(real h)
{
    vec3 force = pull(planet.position);
    verlet_step(&planet, 1, vec3_make(0, 0, 0), &force, h);
    x[VERLET] = planet.position;
    v[VERLET] = verlet_velocity(&planet, pull(planet.position), h);
}

// The mean of the slopes k1 to k4, the middle ones counted twice.
static vec3 rk4_mean(vec3 k1, vec3 k2, vec3 k3, vec3 k4)
{
    vec3 middle = vec3_scale(2, vec3_add(k2, k3));
    return vec3_scale(1.0 / 6, vec3_add(vec3_add(k1, k4), middle));
}

static void rk4_step(real h)
{
    vec3 at = x[RK4], go = v[RK4];
    vec3 v1 = go,                              a1 = pull(at);
    vec3 v2 = vec3_add_scaled(go, h / 2, a1),  a2 = pull(vec3_add_scaled(at, h / 2, v1));
    vec3 v3 = vec3_add_scaled(go, h / 2, a2),  a3 = pull(vec3_add_scaled(at, h / 2, v2));
    vec3 v4 = vec3_add_scaled(go, h, a3),      a4 = pull(vec3_add_scaled(at, h, v3));
    x[RK4] = vec3_add_scaled(at, h, rk4_mean(v1, v2, v3, v4));
    v[RK4] = vec3_add_scaled(go, h, rk4_mean(a1, a2, a3, a4));
}

static void (*const step_of[METHODS])(real) = { euler_step, planet_step, rk4_step };

static void begin(void)
{
    real h = 2 * PI / live_dial(STEPS);
    vec3 go = { 0, 1, 0 };
    now = 0;
    trails = 0;
    energy = energy_of(start, go);
    for (int m = 0; m < METHODS; m++) {
        x[m] = start;
        v[m] = go;
        time_of[m] = 0;
        // RK4 asks for the force four times a step.
        step_length[m] = m == RK4 && live_choice(WORK) ? 4 * h : h;
    }
    planet = particle_start(start, go, pull(start), 1, h);
}

static void keep_trails(void)
{
    for (int m = 0; m < METHODS; m++) {
        if (trails == TRAIL)
            for (int k = 1; k < TRAIL; k++) trail[m][k - 1] = trail[m][k];
        trail[m][int_min(trails, TRAIL - 1)] = x[m];
    }
    trails = int_min(trails + 1, TRAIL);
}

static void step(void)
{
    now += 2 * PI / FRAMES_A_REVOLUTION;
    for (int m = 0; m < METHODS; m++) {
        for (; time_of[m] + step_length[m] < now + 1e-9; time_of[m] += step_length[m])
            step_of[m](step_length[m]);
        live_value(0, m, fabs((energy_of(x[m], v[m]) - energy) / energy));
    }
    keep_trails();
    int n = (int)live_dial(STEPS);
    live_say("The force is computed %d times a revolution for Euler and Verlet, %d times for RK4.",
             n, live_choice(WORK) ? n : 4 * n);
}

static void draw(void)
{
    static const char *const name[METHODS] = { "Euler", "Verlet", "RK4" };
    live_dot(LIVE_INK, vec3_make(0, 0, 0), 7);
    live_label(LIVE_QUIET, vec3_make(0.12, -0.22, 0), "sun");
    for (int m = 0; m < METHODS; m++) {
        live_line(COLOUR[m], trail[m], trails);
        live_dot(COLOUR[m], x[m], 5);
    }
    for (int m = 0; m < METHODS; m++)
        live_label(COLOUR[m], vec3_make(-3.05, 1.5 - 0.27 * m, 0), name[m]);
    live_handle(0, LIVE_INK, start, "the start of the planet");
}

static void move(int number, vec3 to)
{
    (void)number;
    real r = vec3_length(to);
    start = r < 0.3 ? vec3_scale(0.3, r > 0 ? vec3_unit(to) : vec3_make(1, 0, 0)) : to;
    start.z = 0;
    begin();
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, x, sizeof x);
    return live_hash(h, v, sizeof v);
}

const live_figure figure = {
    .name = "orbit",
    .says = "The sun, and the paths of one planet under explicit Euler, Verlet and RK4",
    .pane = { { -3.2, -1.8, 6.4, 3.6 } },
    .dial = {
        [STEPS] = { "steps a revolution", NULL, 12, 240, 1, 60, NULL, true },
        [WORK] = { "the same for all three", NULL, 0, 1, 1, 0, "steps|forces", true },
    },
    .chart = { { "error of the energy", NULL, { "Euler", "Verlet", "RK4" }, 1e-7, 1, true, false, NULL } },
    .begin = begin, .step = step, .draw = draw, .hash = hash, .move = move,
};
