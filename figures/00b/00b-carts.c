// 00b-carts.c - a cart of 2 kg runs into one of 1 kg with a buffer between them:
// force, impulse and energy, for a soft and a hard buffer and for coarse steps.

#include "vec3.h"

#include <stdio.h>

static const real LENGTH = 0.5;         // m, of the buffer at rest
static const real SHORT_STEP = 1e-5;    // s
enum { SOFT = 60, HARD = 960 };         // N/m

typedef struct {
    real x, v, m;                       // m, m/s, kg
} cart;

// What happened to the two carts.
typedef struct {
    real impulse, peak, lasts;          // N s, N, s
    real stored;                        // J, the most that the buffer held
} crash;

static real momentum(const cart *c) { return c[0].m * c[0].v + c[1].m * c[1].v; }

static real motion(const cart *c)
{
    return c[0].m * c[0].v * c[0].v / 2 + c[1].m * c[1].v * c[1].v / 2;
}

// How much the buffer is pressed together, m.
static real pressed(const cart *c)
{
    return real_max(0, LENGTH - (c[1].x - c[0].x));
}

static void start(cart *c)
{
    c[0] = (cart){ -LENGTH - 0.3, 3, 2 };
    c[1] = (cart){ 0, 0, 1 };
}

// Returns the force of the buffer.
static real step(cart *c, real stiffness, real dt)
{
    real force = stiffness * pressed(c);
    c[0].v -= force / c[0].m * dt;
    c[1].v += force / c[1].m * dt;
    for (int i = 0; i < 2; i++) c[i].x += c[i].v * dt;
    return force;
}

// Runs for 0.6 s; prints 300 rows if there is a column for them.
static crash run(cart *c, real stiffness, real dt, bool prints)
{
    crash r = { 0 };
    int steps = (int)(0.6 / dt + 0.5), each = int_max(1, steps / 300);
    start(c);
    for (int k = 0; k < steps; k++) {
        real stored = stiffness * pressed(c) * pressed(c) / 2;
        if (prints && k % each == 0)
            printf("%.3f %.4f %.4f %.4f\n", k * dt, stiffness * pressed(c), motion(c), stored);
        real force = step(c, stiffness, dt);
        r.impulse += force * dt;
        r.peak = real_max(r.peak, force);
        r.stored = real_max(r.stored, stored);
        if (force > 0) r.lasts += dt;
    }
    return r;
}

static void curve(const char *name, int stiffness)
{
    cart c[2];
    start(c);
    real before = momentum(c);
    printf("# %s: t force motion buffer\n", name);
    crash r = run(c, stiffness, SHORT_STEP, true);
    printf("# %s: impulse %.3f N s, peak %.2f N, lasts %.4f s, stored %.4f J\n", name, r.impulse,
           r.peak, r.lasts, r.stored);
    printf("# %s: then %.4f m/s and %.4f m/s, momentum off by %.0e kg m/s\n\n\n", name, c[0].v, c[1].v,
           fabs(momentum(c) - before));
}

int main(void)
{
    curve("soft", SOFT);
    curve("hard", HARD);
    printf("#steps| step ms,momentum,energy\n");
    for (int k = 0; k < 4; k++) {
        const real dt[] = { 0.0001, 0.01, 0.03, 0.05 };
        cart c[2];
        run(c, HARD, dt[k], false);
        printf("#steps| %g,%.12f,%.3f\n", 1000 * dt[k], momentum(c), motion(c));
    }
    return 0;
}
