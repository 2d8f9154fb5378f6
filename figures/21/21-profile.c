// 21-profile.c - where does a step's time go?  The three scenes, phase by
// phase, as the world's own clock books it; nothing sleeps.
//
// An index for each scene: s, ms a step of the phases, in tenths of a second.
// Each run is repeated, and every frame counts with its median.  The table
// ends with the errors of the same runs.

#include "clock.h"
#include "measure.h"
#include "step.h"
#include "world_scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { SECONDS = 6, BIN = 6, FRAMES = 60 * SECONDS, RUNS = 3 };
static const char *const PHASE[PHASES] = {
    "pairs", "contacts", "prepare", "solve", "cloth", "move", "sleep"
};

static real took[SCENES][RUNS][FRAMES][PHASES];
static real median[SCENES][FRAMES][PHASES];
// Of the same runs, every BIN frames, at most.
static real overlap[SCENES], strain[SCENES];     // m; no unit

static void take_error(scene_kind kind, const world *w)
{
    measures m = world_measure(w);
    overlap[kind] = fmax(overlap[kind], m.penetration);
    strain[kind] = fmax(strain[kind], m.strain);
}

static void run(scene_kind kind, int again)
{
    world_scene s;
    world_options how = world_scene_options(kind, 40);
    how.sleep_speed = 0;
    how.host.clock = clock_seconds;
    if (!world_scene_build(&s, kind, scene_options_default(), how).ok) exit(1);
    for (int k = 0; k < FRAMES; k++) {
        world_step(&s.world);
        for (int phase = 0; phase < PHASES; phase++)
            took[kind][again][k][phase] = 1e3 * s.world.report.time[phase];
        if (k % BIN == 0) take_error(kind, &s.world);
    }
    world_scene_free(&s);
}

static void take_medians(scene_kind kind)
{
    for (int k = 0; k < FRAMES; k++)
        for (int phase = 0; phase < PHASES; phase++) {
            real x[RUNS];
            for (int r = 0; r < RUNS; r++) x[r] = took[kind][r][k][phase];
            median[kind][k][phase] = clock_median(x, RUNS);
        }
}

// ms a step of a phase, over frames first .. first + n - 1.
static real mean(scene_kind kind, int phase, int first, int n)
{
    real sum = 0;
    for (int k = first; k < first + n; k++) sum += median[kind][k][phase] / n;
    return sum;
}

static void print_scene(scene_kind kind)
{
    printf("\n\n# %s\n# s", scene_name(kind));
    for (int phase = 0; phase < PHASES; phase++) printf(", %s", PHASE[phase]);
    printf("\n");
    for (int k = 0; k < FRAMES; k += BIN) {
        printf("%.2f", (k + BIN / 2.0) / 60);
        for (int phase = 0; phase < PHASES; phase++)
            printf(" %.4g", mean(kind, phase, k, BIN));
        printf("\n");
    }
}

// The table: a phase a line, a scene a column.
static void print_table(void)
{
    real all[SCENES] = { 0 };
    for (int phase = 0; phase < PHASES; phase++)
        for (scene_kind k = 0; k < SCENES; k++)
            all[k] += mean(k, phase, 0, FRAMES);
    for (int phase = 0; phase < PHASES; phase++) {
        printf("#= %s", PHASE[phase]);
        for (scene_kind k = 0; k < SCENES; k++) {
            real ms = mean(k, phase, 0, FRAMES);
            printf(",%.3f ms (%.0f %%)", ms, 100 * ms / all[k]);
        }
        printf("\n");
    }
    printf("#= the whole step");
    for (scene_kind k = 0; k < SCENES; k++) printf(",%.3f ms", all[k]);
    printf("\n#= deepest overlap");
    for (scene_kind k = 0; k < SCENES; k++)
        printf(",%.2g mm", 1e3 * overlap[k]);
    printf("\n#= largest strain");
    for (scene_kind k = 0; k < SCENES; k++) printf(",%.2g %%", 100 * strain[k]);
    printf("\n");
}

int main(void)
{
    clock_print_head("21-profile: ms a step of each phase; 50 bodies, cloths "
                     "of 40 x 40", FLAGS);
    for (int again = 0; again < RUNS; again++)
        for (scene_kind k = 0; k < SCENES; k++) run(k, again);
    for (scene_kind k = 0; k < SCENES; k++) take_medians(k);
    print_table();
    for (scene_kind k = 0; k < SCENES; k++) print_scene(k);
    return 0;
}
