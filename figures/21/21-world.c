// 21-world.c - how the whole grows: rooms of 10 to 10,000 bodies in their first
// second, and cloths of 20 to 160 particles a side that fall on the cube, all
// with 9, 18 and 36 substeps.  Nobody sleeps.
//
// index 0: bodies, ms a step (median), deepest overlap (of a radius), largest
//          strain
// index 1 to 4: substeps, ms a step (median), largest strain, overlap (m),
//             what touches, for a particle, ms a step of the fall before it
//             touches, how often a step makes new lists; a size each
// index 5 and 6: the rooms of index 0 by the plain system of chapter 09, as
//             printed and as mended, up to 3,000 bodies
// Columns are separated by spaces.

#include "clock.h"
#include "poses.h"
#include "system.h"
#include "world_scene.h"
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
    how.sleep_speed = 0;
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

static void print_rooms(void)
{
    real ms[SIZES];
    scene_options what = scene_options_default();
    printf("# rooms\n# bodies ms overlap strain\n");
    for (int k = 0; k < SIZES; k++) {
        what.bodies = BODIES[k];
        static trip t;
        start(&t, SCENE_ROOM, what, world_scene_options(SCENE_ROOM, 0));
        while (t.frames < FRAMES) go_on(&t);
        ms[k] = clock_median(t.took, FRAMES);
        printf("%d %.4g %.4g %.3g\n", BODIES[k], ms[k],
               t.overlap / t.s.body_radius, t.strain);
        world_scene_free(&t.s);
    }
    printf("# grows as bodies^%.2f from %d on\n", slope(ms, SIZES - 1),
           BODIES[SIZES - 3]);
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

static real plain_overlap(const scene *from, const particle_system *s, vec3 *at)
{
    for (int i = 0; i < s->pool.count; i++) at[i] = s->pool.at[i].position;
    poses p = poses_measure(from, at);
    return fmax(p.overlap, p.behind) / SCENE_BODY_RADIUS;
}

// One room by the plain system: ms a step (median), deepest overlap.
static void print_plain_room(int bodies, system_options how)
{
    static scene from;
    static particle_system s;
    static real took[FRAMES];
    scene_options what = scene_options_default();
    real deepest = 0;
    what.bodies = bodies;
    if (!scene_build(&from, SCENE_ROOM, what).ok) exit(1);
    if (!system_init(&s, &from, how).ok) exit(1);
    vec3 *at = malloc((size_t)s.pool.count * sizeof *at);
    if (!at) exit(1);
    for (int frame = 0; frame < FRAMES; frame++) {
        real begin = clock_seconds();
        system_step(&s);
        took[frame] = 1e3 * (clock_seconds() - begin);
        if (frame % LOOK == LOOK - 1)
            deepest = fmax(deepest, plain_overlap(&from, &s, at));
    }
    printf("%d %.4g %.4g\n", bodies, clock_median(took, FRAMES), deepest);
    free(at);
    system_free(&s);
    scene_free(&from);
}

static void print_plain(void)
{
    for (int mended = 0; mended < 2; mended++) {
        printf("\n\n# rooms by the plain system, %s\n# bodies ms overlap\n",
               mended ? "as mended" : "as printed");
        for (int k = 0; k < SIZES - 1; k++)
            print_plain_room(BODIES[k], mended ? system_options_mended()
                                               : system_options_printed());
    }
}

int main(void)
{
    clock_print_head("21-world: ms a step and error, by size", FLAGS);
    print_rooms();
    print_cloths();
    print_plain();
    return 0;
}
