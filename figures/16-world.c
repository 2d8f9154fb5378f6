// 16-world.c - how the whole grows: rooms of 10 to 10,000 bodies, our way and
// (up to 3,000) the paper's, in their first second, and cloths of 20 to 160
// particles a side on the cube, with half, once and twice their substeps, while
// they fall.  Nobody sleeps.
//
// index 0, 1: bodies, ms a step (median), deepest overlap (of a radius),
//             largest strain; ours, the paper's
// index 2 to 5: substeps, ms a step, largest strain, overlap (m); a size each
// Columns are separated by spaces.

#include "clock.h"
#include "scene.h"
#include "step.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { FRAMES = 60, CLOTH_FRAMES = 40, LOOK = 10, SIZES = 7, CLOTHS = 4,
       STEPS = 3 };
static const int BODIES[SIZES] = { 10, 30, 100, 300, 1000, 3000, 10000 };
static const int CLOTH[CLOTHS] = { 20, 40, 80, 160 };

typedef struct {
    real ms, overlap, strain;
    int  frames;
} outcome;

static outcome run(scene_kind kind, scene_options what, world_options how,
                   int frames)
{
    static real took[FRAMES];
    outcome r = { 0, 0, 0, frames };
    scene s;
    how.resting = 0;
    if (!scene_build(&s, kind, what, how).ok) exit(1);
    for (int k = 0; k < frames; k++) {
        real start = clock_seconds();
        world_step(&s.world);
        took[k] = 1e3 * (clock_seconds() - start);
        if (k % LOOK != LOOK - 1) continue;
        measures m = world_measure(&s.world);
        r.overlap = fmax(r.overlap, m.penetration);
        r.strain = fmax(r.strain, m.strain);
    }
    r.ms = clock_median(took, frames);
    if (kind == SCENE_ROOM) r.overlap /= s.body_radius;
    scene_free(&s);
    return r;
}

// How steeply time grows over the last two sizes, which are ten times apart.
static real slope(const real *ms, int last)
{
    return log(ms[last] / ms[last - 2]) / log((real)BODIES[last]
                                              / BODIES[last - 2]);
}

static void print_rooms(void)
{
    real ms[2][SIZES], deep[2][SIZES];
    scene_options what = scene_options_default();
    for (int way = 0; way < 2; way++) {
        printf("%s# rooms, %s\n# bodies ms overlap strain\n",
               way ? "\n\n" : "", way ? "the paper's way" : "our way");
        int sizes = way ? SIZES - 1 : SIZES;
        for (int k = 0; k < sizes; k++) {
            what.bodies = BODIES[k];
            outcome r = run(SCENE_ROOM, what,
                            way ? world_options_paper()
                                : scene_world_options(SCENE_ROOM, 0), FRAMES);
            ms[way][k] = r.ms;
            deep[way][k] = r.overlap;
            printf("%d %.4g %.4g %.3g\n", BODIES[k], r.ms, r.overlap, r.strain);
        }
        printf("# grows as bodies^%.2f from %d on\n",
               slope(ms[way], sizes - 1), BODIES[sizes - 3]);
    }
    clock_print_row("world", "room of 1000", "overlap 3 % of a radius",
                    "ours", "the paper's",
                    deep[1][4] > 0.03 ? HUGE_VAL : ms[1][4] / ms[0][4]);
}

static void print_cloths(void)
{
    real ms[CLOTHS];
    scene_options what = scene_options_default();
    world_options how = scene_world_options(SCENE_CLOTH_ON_CUBE, 40);
    int usual = how.substeps;
    for (int k = 0; k < CLOTHS; k++) {
        what.cloth = CLOTH[k];
        printf("\n\n# cloth of %d x %d\n# substeps ms strain overlap\n",
               CLOTH[k], CLOTH[k]);
        for (int i = 0; i < STEPS; i++) {
            how.substeps = (usual << i) / 2;
            outcome r = run(SCENE_CLOTH_ON_CUBE, what, how, CLOTH_FRAMES);
            printf("%d %.4g %.3g %.3g\n", how.substeps, r.ms, r.strain,
                   r.overlap);
            if (i == 1) ms[k] = r.ms;
        }
    }
    printf("# %d substeps: grows as particles^%.2f from 40 on\n", usual,
           log(ms[CLOTHS - 1] / ms[1]) / log(16));
}

int main(void)
{
    clock_print_head("16-world: ms a step and error, by size", FLAGS);
    print_rooms();
    print_cloths();
    return 0;
}
