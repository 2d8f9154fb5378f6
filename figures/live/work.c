// work.c - a planet by four methods, with the same number of pulls for each: what the
// work buys, point by point (chapter 21).

#include "live.h"

#include <math.h>
#include <stdio.h>

enum { ECCENTRICITY };                          // dial
enum { ORBIT, CHART };                          // panes
enum { EULER, SYMPLECTIC, VERLET, RUNGE, METHODS, LEVELS = 9, LEAST = 64, KEPT = 160,
       TRUTH = 1 << 15, PACE = 14, REST = 240 };
static const real ALL = 7.85398163397448;       // a round and a quarter, with a = GM = 1
static const real LOWEST = -7, HIGHEST = 1;     // the chart's decades of error
static const char *const NAME[METHODS] = { "explicit Euler", "symplectic Euler", "Verlet", "Runge-Kutta 4" };
static const live_colour COLOUR[METHODS] = { LIVE_RED, LIVE_ORANGE, LIVE_BLUE, LIVE_GREEN };

typedef struct { vec3 x, v; } planet;
static planet truth;
static vec3 path[METHODS][KEPT + 1];
static real error[METHODS][LEVELS];
static int level, frame;

static planet start(void)
{
    real e = live_dial(ECCENTRICITY);
    return (planet){ { 1 - e, 0, 0 }, { 0, sqrt((1 + e) / (1 - e)), 0 } };
}

static vec3 pull(vec3 x)
{
    real r2 = vec3_length_squared(x);
    return vec3_scale(-1 / (r2 * sqrt(r2)), x);
}

static planet moved(planet p, real h, planet by)
{
    return (planet){ vec3_add_scaled(p.x, h, by.x), vec3_add_scaled(p.v, h, by.v) };
}

static planet slope(planet p)
{
    return (planet){ p.v, pull(p.x) };
}

static planet runge_kutta(planet p, real h)
{
    planet a = slope(p), b = slope(moved(p, h / 2, a)), c = slope(moved(p, h / 2, b)), d = slope(moved(p, h, c));
    p = moved(moved(p, h / 6, a), h / 3, b);
    return moved(moved(p, h / 3, c), h / 6, d);
}

static planet one_step(int method, planet p, real h)
{
    if (method == EULER) return moved(p, h, slope(p));
    if (method == RUNGE) return runge_kutta(p, h);
    if (method == VERLET) p.x = vec3_add_scaled(p.x, h / 2, p.v);
    p.v = vec3_add_scaled(p.v, h, pull(p.x));
    p.x = vec3_add_scaled(p.x, method == VERLET ? h / 2 : h, p.v);
    return p;
}

// So many pulls in all: Runge and Kutta's method asks for four in a step.
static void fly(int method)
{
    int steps = (LEAST << level) / (method == RUNGE ? 4 : 1);
    planet p = start();
    path[method][0] = p.x;
    for (int n = 1, k = 1; n <= steps; n++) {
        p = one_step(method, p, ALL / steps);
        for (; k <= KEPT && k * (long)steps <= n * (long)KEPT; k++) path[method][k] = p.x;
    }
    real x = vec3_distance(p.x, truth.x), v = vec3_distance(p.v, truth.v);
    error[method][level] = sqrt(x * x + v * v);
}

static void tell(void)
{
    live_say("%d pulls: explicit Euler is off by %.1g, symplectic by %.1g, Verlet by %.1g, Runge-Kutta by %.1g.",
             LEAST << level, error[EULER][level], error[SYMPLECTIC][level], error[VERLET][level], error[RUNGE][level]);
}

static void fly_all(void)
{
    for (int method = 0; method < METHODS; method++) fly(method);
    tell();
}

static void begin(void)
{
    truth = start();
    for (int n = 0; n < TRUTH; n++) truth = runge_kutta(truth, ALL / TRUTH);
    level = frame = 0;
    fly_all();
}

static void step(void)
{
    if (++frame >= (level == LEVELS - 1 ? REST : PACE)) {
        frame = 0;
        level = (level + 1) % LEVELS;
        fly_all();
    }
    tell();
}

// --- Drawing ----------------------------------------------------------------------
static vec3 at_level(int n, real what)
{
    real decade = what > 0 ? log10(what) : LOWEST;
    return vec3_make(0.6 + 4.2 * n / (LEVELS - 1), real_min(real_max(decade, LOWEST), HIGHEST) * 0.42 + 1.4, 0);
}

static void draw_orbits(void)
{
    live_pane(ORBIT);
    live_dot(LIVE_INK, (vec3){ 0, 0, 0 }, 8);
    for (int method = 0; method < METHODS; method++) {
        int n = 0;
        while (n <= KEPT && vec3_length(path[method][n]) < 2.6) n++;
        live_line(COLOUR[method], path[method], n);
        if (n > KEPT) live_dot(COLOUR[method], path[method][KEPT], 5);
    }
    live_circle(LIVE_GREY, truth.x, 0.09);
    live_label(LIVE_QUIET, vec3_add(truth.x, vec3_make(0.1, -0.3, 0)), "truth");
}

static void draw_chart(void)
{
    char words[16];
    live_pane(CHART);
    for (int decade = (int)LOWEST; decade <= HIGHEST; decade += 2) {
        real one = 1;
        for (int k = 0; k < decade; k++) one *= 10;
        for (int k = 0; k > decade; k--) one /= 10;
        vec3 left = at_level(0, one), right = at_level(LEVELS - 1, one);
        live_line(LIVE_RULE, (vec3[]){ left, right }, 2);
        snprintf(words, sizeof words, "%g", one);
        live_label(LIVE_QUIET, vec3_add(left, vec3_make(-0.72, -0.05, 0)), words);
    }
    for (int n = 0; n < LEVELS; n += 2) {
        snprintf(words, sizeof words, "%d", LEAST << n);
        live_label(LIVE_QUIET, vec3_add(at_level(n, 1e-7), vec3_make(-0.12, -0.3, 0)), words);
    }
    for (int method = 0; method < METHODS; method++) {
        vec3 line[LEVELS];
        for (int n = 0; n <= level; n++) line[n] = at_level(n, error[method][n]);
        live_line(COLOUR[method], line, level + 1);
        for (int n = 0; n <= level; n++) live_dot(COLOUR[method], line[n], n == level ? 5 : 3);
        live_label(COLOUR[method], vec3_make(0.1 + 2.6 * (method % 2), -2.5 - 0.32 * (method / 2), 0), NAME[method]);
    }
}

static void draw(void)
{
    draw_orbits();
    draw_chart();
}

static unsigned long long hash(void)
{
    unsigned long long h = live_hash(LIVE_HASH, &truth, sizeof truth);
    for (int method = 0; method < METHODS; method++)
        h = live_hash(h, error[method], (size_t)(level + 1) * sizeof(real));
    return h;
}

const live_figure figure = {
    .name = "work",
    .says = "On the left a planet's path by four methods, on the right the error of each against the number of pulls, on logarithmic scales",
    .pane = { [ORBIT] = { -2.4, -2.1, 4.4, 4.4 }, [CHART] = { -0.3, -3, 5.4, 5.2 } },
    .dial = { [ECCENTRICITY] = { "eccentricity", NULL, 0, 0.8, 0.05, 0.4, NULL, true } },
    .begin = begin, .step = step, .draw = draw, .hash = hash,
};
