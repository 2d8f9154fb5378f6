// 18-world.c - how the whole grows: rooms of 10 to 10,000 bodies in their first
// second, by the engine and (up to 3,000) by the paper's system, and cloths of
// 20 to 160 particles a side that fall on the cube, all with 9, 18 and 36
// substeps.  Nobody sleeps.
//
// index 0 to 2: bodies, ms a step (median), deepest overlap (of a radius),
//               largest strain; the engine, the paper's system as mended and as
//               printed
// index 3 to 6: substeps, ms a step (median), largest strain, overlap (m),
//             what touches, for a particle, ms a step of the fall before it
//             touches, how often a step makes new lists; a size each
// Columns are separated by spaces.

#include "clock.h"
#include "runner.h"
#include "step.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { FRAMES = 60, CLOTH_FRAMES = 40, LOOK = 10, SIZES = 7, CLOTHS = 4,
       STEPS = 3, FALL = 6 };
static const int BODIES[SIZES] = { 10, 30, 100, 300, 1000, 3000, 10000 };
static const int CLOTH[CLOTHS] = { 20, 40, 80, 160 };

// A scene that runs, and what was seen of it.
typedef struct {
    world_scene s;
    real  took[FRAMES];         // ms
    real  overlap, strain, touching, lists;
    int   frames;
} trip;

static void start(trip *t, scene_kind kind, scene_options what,
                  world_options how)
{
    *t = (trip){ .frames = 0 };
    how.resting = 0;
    if (!world_scene_build(&t->s, kind, what, how).ok) exit(1);
}

// So many frames more, and a look at it.
static void go_on(trip *t)
{
    for (int k = 0; k < LOOK; k++) {
        real begin = clock_seconds();
        world_step(&t->s.world);
        t->took[t->frames++] = 1e3 * (clock_seconds() - begin);
        t->touching += (real)t->s.world.report.touching;
        t->lists += (real)t->s.world.report.rebuilt;
    }
    measures m = world_measure(&t->s.world);
    t->overlap = fmax(t->overlap, m.penetration);
    t->strain = fmax(t->strain, m.strain);
}

// How steeply time grows over the last two sizes, which are ten times apart.
static real slope(const real *ms, int last)
{
    return log(ms[last] / ms[last - 2]) / log((real)BODIES[last]
                                              / BODIES[last - 2]);
}

// One room: ms and overlap of its first second.
static void follow_room(runner_kind kind, int bodies, real *ms, real *deep)
{
    static runner run;
    real took[FRAMES], strain = 0;
    scene_options what = scene_options_default();
    world_options awake = world_scene_options(SCENE_ROOM, 0);
    what.bodies = bodies;
    awake.resting = 0;
    status done = kind == BY_ENGINE
        ? runner_begin_world(&run, SCENE_ROOM, what, awake)
        : runner_begin(&run, kind, SCENE_ROOM, what);
    if (!done.ok) exit(1);
    *deep = 0;
    for (int k = 0; k < FRAMES; k++) {
        real begin = clock_seconds();
        runner_step(&run);
        took[k] = 1e3 * (clock_seconds() - begin);
        if (k % LOOK != LOOK - 1) continue;
        measures m = runner_measure(&run);
        *deep = fmax(*deep, m.penetration / SCENE_BODY_RADIUS);
        strain = fmax(strain, m.strain);
    }
    *ms = clock_median(took, FRAMES);
    printf("%d %.4g %.4g %.3g\n", bodies, *ms, *deep, strain);
    runner_free(&run);
}

static void print_rooms(void)
{
    static const runner_kind kind[RUNNERS] = { BY_ENGINE, BY_PLAIN,
                                               AS_PRINTED };
    real ms[RUNNERS][SIZES], deep[RUNNERS][SIZES];
    for (int i = 0; i < RUNNERS; i++) {
        int sizes = kind[i] == BY_ENGINE ? SIZES : SIZES - 1;
        printf("%s# rooms, %s\n# bodies ms overlap strain\n",
               i ? "\n\n" : "", runner_name(kind[i]));
        for (int k = 0; k < sizes; k++)
            follow_room(kind[i], BODIES[k], &ms[i][k], &deep[i][k]);
        printf("# grows as bodies^%.2f from %d on\n",
               slope(ms[i], sizes - 1), BODIES[sizes - 3]);
    }
    clock_print_row("world", "room of 1000", "overlap 3 % of a radius",
                    "the engine", "the paper's system",
                    deep[1][4] > 0.03 ? HUGE_VAL : ms[1][4] / ms[0][4]);
}

// The same numbers for all; with the last one the finest, too, holds its
// strain.  With fewer it crumples, and has more to do than a cloth.
static const int SUBSTEPS[STEPS] = { 9, 18, 36 };

// All sizes take turns, so that all see the same of a machine whose pace
// changes.
static void run_cloths(trip *t, int substeps)
{
    scene_options what = scene_options_default();
    world_options how = world_scene_options(SCENE_CLOTH_ON_CUBE, 40);
    how.substeps = substeps;
    for (int k = 0; k < CLOTHS; k++) {
        what.cloth = CLOTH[k];
        start(&t[k], SCENE_CLOTH_ON_CUBE, what, how);
    }
    for (int i = 0; i < CLOTH_FRAMES; i += LOOK)
        for (int k = 0; k < CLOTHS; k++) go_on(&t[k]);
    for (int k = 0; k < CLOTHS; k++) world_scene_free(&t[k].s);
}

// ms of all frames, or of those of the free fall.  The first one makes lists.
static real time_of(const trip *t, int fall)
{
    real took[CLOTH_FRAMES];
    int first = fall ? 1 : 0, n = fall ? FALL : CLOTH_FRAMES;
    for (int i = 0; i < n; i++) took[i] = t->took[first + i];
    return clock_median(took, n);
}

static void print_cloths(void)
{
    static trip t[STEPS][CLOTHS];
    for (int i = 0; i < STEPS; i++) run_cloths(t[i], SUBSTEPS[i]);
    for (int k = 0; k < CLOTHS; k++) {
        printf("\n\n# cloth of %d x %d\n# substeps ms strain overlap touching "
               "fall lists\n", CLOTH[k], CLOTH[k]);
        for (int i = 0; i < STEPS; i++)
            printf("%d %.4g %.3g %.3g %.3f %.4g %.1f\n", SUBSTEPS[i],
                   time_of(&t[i][k], 0), t[i][k].strain, t[i][k].overlap,
                   t[i][k].touching / (CLOTH[k] * CLOTH[k] * CLOTH_FRAMES),
                   time_of(&t[i][k], 1), t[i][k].lists / CLOTH_FRAMES);
    }
    for (int i = 0; i < STEPS; i++) {
        const trip *first = &t[i][1], *last = &t[i][CLOTHS - 1];
        printf("# %d substeps: grows as particles^%.2f from 40 on, in free "
               "fall as particles^%.2f\n", SUBSTEPS[i],
               log(time_of(last, 0) / time_of(first, 0)) / log(16),
               log(time_of(last, 1) / time_of(first, 1)) / log(16));
    }
}

int main(void)
{
    clock_print_head("18-world: ms a step and error, by size", FLAGS);
    print_rooms();
    print_cloths();
    return 0;
}
