// 21-verlet.c - four ways to step, and what an error costs with each: a mass on
// a spring, and a pendulum let go at 90 degrees.  Both are asked for at the
// same moment, after an orbit and a quarter, where the true answer is 0.
//
// Columns: steps a period, ns for the whole run, error (of the amplitude, or
// rad).

#include "clock.h"
#include "euler.h"
#include "verlet.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

typedef enum { EXPLICIT, SYMPLECTIC, VERLET, RUNGE_KUTTA, METHODS } method;
static const char *const NAME[METHODS] = {
    "explicit Euler", "symplectic Euler", "Verlet", "Runge-Kutta 4"
};

enum { LEAST = 16, STEPS = 12, ROUNDS = 9 };

// x'' = -x from x = 1, or x'' = -sin x from x = pi / 2.
typedef struct {
    const char *name;
    int  swings;        // sin x
    real start, period;
    real speed;         // in the middle
} motion;

static real pull(const motion *m, real x)
{
    return m->swings ? -sin(x) : -x;
}

// K of the pendulum by Gauss: the period is 2 pi over the arithmetic-geometric
// mean of 1 and cos(start / 2).
static real pendulum_period(real start)
{
    real a = 1, g = cos(start / 2);
    for (int k = 0; k < 8; k++) {
        real mean = (a + g) / 2;
        g = sqrt(a * g);
        a = mean;
    }
    return 2 * acos(-1.0) / a;
}

// ---- the four ways, along x ------------------------------------------------

static const vec3 NO_GRAVITY = { 0, 0, 0 };

// Runge and Kutta's classic: four pulls a step.
static void runge_kutta_step(const motion *m, euler_particle *p, real dt)
{
    real x = p->position.x, v = p->velocity.x;
    real v1 = v,               a1 = pull(m, x);
    real v2 = v + dt / 2 * a1, a2 = pull(m, x + dt / 2 * v1);
    real v3 = v + dt / 2 * a2, a3 = pull(m, x + dt / 2 * v2);
    real v4 = v + dt * a3,     a4 = pull(m, x + dt * v3);
    p->position.x = x + dt / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    p->velocity.x = v + dt / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
}

// How far place and velocity are from (0, -speed).
static real miss(const motion *m, real x, real v)
{
    return sqrt(x * x + (v + m->speed) * (v + m->speed));
}

static real run_euler(const motion *m, method way, int steps, real dt)
{
    euler_particle p = { { m->start, 0, 0 }, { 0, 0, 0 } };
    for (int k = 0; k < steps; k++) {
        vec3 force = { 0, 0, 0 };
        if (way == RUNGE_KUTTA) {
            runge_kutta_step(m, &p, dt);
            continue;
        }
        force.x = pull(m, p.position.x);
        if (way == EXPLICIT) euler_step_explicit(&p, force, dt);
        else euler_step_symplectic(&p, force, dt);
    }
    return miss(m, p.position.x, p.velocity.x);
}

static real run_verlet(const motion *m, int steps, real dt)
{
    vec3 x = { m->start, 0, 0 }, rest = { 0, 0, 0 };
    vec3 a = { pull(m, m->start), 0, 0 };
    particle p = particle_start(x, rest, a, 1, dt);
    for (int k = 0; k < steps; k++) {
        vec3 force = { pull(m, p.position.x), 0, 0 };
        verlet_step(&p, 1, NO_GRAVITY, &force, dt);
    }
    a.x = pull(m, p.position.x);
    return miss(m, p.position.x, verlet_velocity(&p, a, dt).x);
}

// ---- the race --------------------------------------------------------------

typedef struct {
    const motion *m;
    real error[METHODS * STEPS];
} field;

static int steps_of(int way)
{
    return LEAST << way % STEPS;
}

static void work(int way, void *with)
{
    field *f = with;
    method m = (method)(way / STEPS);
    int a_period = steps_of(way), steps = a_period / 4 * 5;
    real dt = f->m->period / a_period;
    f->error[way] = m == VERLET ? run_verlet(f->m, steps, dt)
                                : run_euler(f->m, m, steps, dt);
}

// How much longer the others take than Verlet, at this error.
static void print_rows(const field *f, const lap *t, real wanted)
{
    real took[METHODS], seconds[STEPS];
    char error[32];
    for (int m = 0; m < METHODS; m++) {
        for (int k = 0; k < STEPS; k++) seconds[k] = t[m * STEPS + k].seconds;
        took[m] = clock_at_error(seconds, &f->error[m * STEPS], STEPS, wanted);
    }
    snprintf(error, sizeof error, "%g", wanted);
    for (int m = 0; m < METHODS; m++) {
        if (m == VERLET || !(took[m] < HUGE_VAL)) continue;
        int quicker = took[m] < took[VERLET];
        clock_print_row("verlet", f->m->name, error,
                        NAME[quicker ? m : VERLET], NAME[quicker ? VERLET : m],
                        quicker ? took[VERLET] / took[m]
                                : took[m] / took[VERLET]);
    }
}

static void print_motion(const motion *m)
{
    static field f;
    static lap t[METHODS * STEPS];
    f.m = m;
    clock_race((race){ METHODS * STEPS, ROUNDS, 1e-3, work, &f }, t);
    for (int way = 0; way < METHODS * STEPS; way++) {
        if (way % STEPS == 0)
            printf("\n\n# %s, %s\n# steps_a_period ns error\n", m->name,
                   NAME[way / STEPS]);
        printf("%d %.4g %.4g\n", steps_of(way), 1e9 * t[way].seconds,
               f.error[way]);
    }
    print_rows(&f, t, 1e-2);
    print_rows(&f, t, 1e-6);
}

int main(void)
{
    const real pi = acos(-1.0);
    motion spring = { "spring", 0, 1, 2 * pi, 1 };
    motion pendulum = { "pendulum", 1, pi / 2, pendulum_period(pi / 2),
                        sqrt(2) };
    clock_print_head("21-verlet: time and error of a period and a quarter",
                     FLAGS);
    print_motion(&spring);
    print_motion(&pendulum);
    return 0;
}
