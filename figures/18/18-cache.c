// 18-cache.c - what is kept from frame to frame, and what keeping it saves: a
// room of 1,000 icosahedra, and a pyramid of 210 boxes.  No body sleeps.
//
// Three ways, frame beside frame: contacts are kept while bodies lie where they
// lay; every pair is asked in every frame, and impulses are handed on; and
// everything is forgotten before each frame (cache_clear), which also takes
// the warm start between frames away.
//
// A block for each scene: seconds; questions in a frame, mean over a tenth of a
// second, the three ways; J of motion at its end, the three ways.  Columns are separated by spaces; lines that open
// with #cache are the table of chapter 18.

#include "clock.h"
#include "forget.h"
#include "step.h"
#include "world_scene.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { SCENES_HERE = 2, WAYS = 3, FRAMES = 600, MEAN = 6, ROWS = 20 };

static const char *const title[SCENES_HERE] = {
    "room of 1,000", "pyramid of 210"
};
static const char *const way_name[WAYS] = {
    "kept", "asked in every frame", "forgotten in every frame"
};

typedef struct {
    scene scene;
    world world;
    real ms[FRAMES];
    long queries, lists;
    real deepest, kinetic;
} run;

static status build_pyramid(scene *s)
{
    shape box;
    scene_init(s);
    status done = shape_box(&box, vec3_make(1, 1, 1), 1);
    if (done.ok) done = scene_add_shape(s, &box);
    if (done.ok) done = scene_add_plane(s, vec3_make(0, 1, 0), 0);
    for (int row = 0; row < ROWS; row++)
        for (int k = 0; k < ROWS - row && done.ok; k++)
            done = scene_add(s, 0, placement_at(vec3_make(
                1.05 * (k - (ROWS - row - 1) / 2.0), 0.5 + row, 0)));
    return done;
}

static status build(run *r, int which, int way)
{
    world_options o = world_options_default();
    scene_options what = scene_options_default();
    what.bodies = 1000;
    o.sleep_speed = 0;
    if (way > 0) o.stay = 0;
    *r = (run){ .queries = 0 };
    status done = which == 0 ? scene_build(&r->scene, SCENE_ROOM, what)
                             : build_pyramid(&r->scene);
    return done.ok ? world_of_scene(&r->world, &r->scene, o) : done;
}

static void step(run *r, int way, int frame)
{
    if (way == WAYS - 1) cache_clear(&r->world.rigid.cache);
    real start = clock_seconds();
    world_step(&r->world);
    r->ms[frame] = 1e3 * (clock_seconds() - start);
    r->queries += r->world.report.queries;
    r->lists = r->world.rigid.pairs.lists;
    if ((frame + 1) % MEAN != 0) return;
    measures m = world_measure(&r->world);
    r->deepest = fmax(r->deepest, m.penetration);
    r->kinetic = m.kinetic;
}

static void print_rows(run *r, int which)
{
    real ratio[FRAMES];
    for (int way = 0; way < WAYS; way++) {
        for (int k = 0; k < FRAMES; k++) ratio[k] = r[way].ms[k] / r[0].ms[k];
        printf("#cache| \"%s\",%s,%.0f,%ld,%.2f,%.1f,%.1e\n", title[which],
               way_name[way], (real)r[way].queries / FRAMES, r[way].lists,
               clock_median(ratio, FRAMES), 1e3 * r[way].deepest,
               r[way].kinetic);
    }
}

static status race_scene(int which)
{
    static run r[WAYS];
    status done = status_ok();
    for (int way = 0; way < WAYS && done.ok; way++)
        done = build(&r[way], which, way);
    long before[WAYS] = { 0 };
    printf("\n\n");
    for (int k = 0; k < FRAMES && done.ok; k++) {
        for (int way = 0; way < WAYS; way++) step(&r[way], way, k);
        if ((k + 1) % MEAN != 0) continue;
        printf("%.3f", (k + 1 - MEAN / 2) / 60.0);
        for (int way = 0; way < WAYS; way++) {
            printf(" %.2f", (real)(r[way].queries - before[way]) / MEAN);
            before[way] = r[way].queries;
        }
        for (int way = 0; way < WAYS; way++) printf(" %.3e", r[way].kinetic);
        printf("\n");
    }
    if (done.ok) print_rows(r, which);
    for (int way = 0; way < WAYS; way++) {
        world_free(&r[way].world);
        scene_free(&r[way].scene);
    }
    return done;
}

int main(void)
{
    clock_print_head("18-cache", FLAGS);
    printf("#cache| scene,what was found is,questions a frame,"
           "lists of pairs in 600 frames,time of a step,"
           "\"deepest, mm\",J at the end\n");
    for (int k = 0; k < SCENES_HERE; k++) {
        status done = race_scene(k);
        if (done.ok) continue;
        fprintf(stderr, "18-cache: %s\n", done.why);
        return 1;
    }
    return 0;
}
