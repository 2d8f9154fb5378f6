// 00b-spring.c - a mass on a spring: its period, its twin on a circle, and what
// becomes of it when a period has few steps.

#include "vec3.h"

#include <stdio.h>

static const real PI = 3.14159265358979323846;
static const real FINE = 1e-5;          // s, a step that is short for all of these
enum { PERIODS = 20 };

typedef struct {
    real x, v;                          // m, m/s
} mass;

static void step(mass *p, real stiffness, real m, real dt)
{
    p->v -= stiffness * p->x / m * dt;
    p->x += p->v * dt;
}

// s, between the first and the fifth time that it comes through the middle upwards.
static real period(real stiffness, real m)
{
    mass p = { 1, 0 };
    real first = 0;
    for (int k = 1, n = 0; k < 10000000; k++) {
        mass before = p;
        step(&p, stiffness, m, FINE);
        if (before.x > 0 || p.x <= 0) continue;
        real now = FINE * (k - p.x / (p.x - before.x));
        if (n++ == 0) first = now;
        if (n == 5) return (now - first) / 4;
    }
    return 0;
}

static void periods(void)
{
    const real list[][2] = { { 10, 1 }, { 40, 1 }, { 160, 1 }, { 40, 4 } };
    printf("#period| what,stiffness,mass,measured,formula\n");
    for (int i = 0; i < 4; i++) {
        real k = list[i][0], m = list[i][1];
        printf("#period| %g N/m and %g kg,%g,%g,%.5f,%.5f\n", k, m, k, m, period(k, m), 2 * PI * sqrt(m / k));
    }
}

// omega 1 rad/s: place and velocity of the spring, 24 times a period.
static void twin(void)
{
    enum { EACH = 20000, SHOWN = 24 };
    mass p = { 1, 0 };
    printf("\n\n# t x v\n");
    for (int k = 0; k <= EACH * SHOWN; k++) {
        if (k % EACH == 0) printf("%.4f %.4f %.4f\n", 2 * PI * k / (EACH * SHOWN), p.x, p.v);
        step(&p, 1, 1, 2 * PI / (EACH * SHOWN));
    }
}

// The largest swing of twenty periods, of a spring that begins with 1.
static real swing(real steps)
{
    mass p = { 1, 0 };
    real most = 1;
    for (int k = 0; k < PERIODS * steps; k++) {
        step(&p, 1, 1, 2 * PI / steps);
        most = real_max(most, fabs(p.x));
    }
    return most;
}

int main(void)
{
    const real steps[] = { 2.9, 3, 3.05, 3.1, 3.13, 3.15, 3.2, 3.3, 3.5, 4, 5, 6, 8, 10, 15, 20, 40, 60 };
    periods();
    twin();
    printf("\n\n# steps swing\n");
    for (int i = 0; i < 18; i++) printf("%g %.4g\n", steps[i], swing(steps[i]));
    return 0;
}
