// 13-substeps.c - what is work best spent on, substeps or iterations?  Two
// piles by the plain solver: a heavy cube on a light one, and ten equal cubes.
//
// 0      mass ratio, then sag in mm with 2, 4, 8, 16 and 32 substeps
// 1      the same by the law: load / (effective mass omega^2)
// 2      ten cubes, one pass a substep: passes a frame, sag in mm
// 3      ten cubes, two substeps: passes a frame, sag in mm
// 4, 5   ten cubes, 8 substeps, warm started and not: s, sag in mm
// The springs are as stiff as a substep bears, 1 / (8 h).

#include "13-tower.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { FRAMES = 600, LAST = 300 };

// mm, after ten seconds; *drift: in the last five of them.
static real stand(tower *t, real *drift)
{
    real half = 0;
    for (int n = 0; n < FRAMES; n++) {
        tower_frame(t);
        if (n == FRAMES - LAST - 1) half = tower_sag(t);
    }
    *drift = 1e3 * fabs(tower_sag(t) - half);
    tower_free(t);
    return 1e3 * tower_sag(t);
}

static real two(real ratio, int substeps)
{
    tower t;
    real drift;
    tower_begin(&t, substeps, 1);
    tower_add(&t, 1);
    tower_add(&t, ratio);
    return stand(&t, &drift);
}

// mm.  The contact of the two carries the heavy one's weight, that with the
// ground both; against the ground a spring is twice as stiff.
static real law(real ratio, int substeps)
{
    const real pi = 3.141592653589793;
    real omega = 2 * pi * 0.125 * 60 * substeps;
    return 1e3 * (1 + ratio) * (1 + 0.25) * 9.81 / (omega * omega);
}

static real ten(int substeps, int iterations, real *drift)
{
    tower t;
    tower_begin(&t, substeps, iterations);
    for (int b = 0; b < 10; b++) tower_add(&t, 1);
    return stand(&t, drift);
}

static void ratios(void)
{
    for (int measured = 1; measured >= 0; measured--) {
        printf("\n\n# %s: ratio, mm with 2, 4, 8, 16, 32 substeps\n",
               measured ? "measured" : "the law");
        for (real ratio = 1; ratio < 2000; ratio *= 10) {
            printf("%g", ratio);
            for (int n = 2; n <= 32; n *= 2)
                printf(" %.4g", measured ? two(ratio, n) : law(ratio, n));
            printf("\n");
        }
    }
}

static void shares(void)
{
    printf("\n\n# ten cubes, one pass a substep: passes a frame, mm\n"
           "#work| substeps a frame,iterations a substep,sag (mm),"
           "drift in 5 s (mm)\n");
    for (int n = 2; n <= 32; n *= 2) {
        real drift, sag = ten(n, 1, &drift);
        printf("%d %.4g\n#work| %d,1,%.3g,%.1g\n", n, sag, n, sag, drift);
    }
    printf("\n\n# ten cubes, two substeps: passes a frame, mm\n");
    for (int n = 1; n <= 16; n *= 2) {
        real drift, sag = ten(2, n, &drift);
        printf("%d %.4g\n", 2 * n, sag);
        if (n > 1) printf("#work| 2,%d,%.3g,%.1g\n", n, sag, drift);
    }
}

static void memories(void)
{
    for (int warm = 1; warm >= 0; warm--) {
        tower t;
        tower_begin(&t, 8, 1);
        t.warm = warm;
        for (int b = 0; b < 10; b++) tower_add(&t, 1);
        printf("\n\n# ten cubes, 8 substeps, %s: s, mm\n",
               warm ? "warm started" : "from nothing");
        for (int n = 0; n <= 60; n++) {
            printf("%.4f %.5g\n", n / 60.0, 1e3 * tower_sag(&t));
            tower_frame(&t);
        }
        tower_free(&t);
    }
}

int main(void)
{
    printf("# 13-substeps: cubes of 1 m, one on the other, 10 s at 60 frames a "
           "second, by the plain solver\n# compiler: %s\n# flags: %s",
           __VERSION__, FLAGS);
    ratios();
    shares();
    memories();
    return 0;
}
