// 18-both.c - the plain system of chapter 09, as printed and as mended, and the
// engine, in the paper's three scenes: time of a step beside what went wrong.
//
// index 0: the room; index 1: a cloth on a cube; index 2: on a rope.  Columns:
// way (0 printed, 1 mended, 2 engine), ms a step (the median), m deepest, m
// deepest in the end, largest strain, J left.  The last two scenes: m deepest
// of a particle in the cube.  Columns are separated by spaces; #scenes| is the
// book's table.

#include "clock.h"
#include "poses.h"
#include "step.h"
#include "system.h"
#include "world_scene.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { PRINTED, MENDED, ENGINE, WAYS };
enum { MOST_STEPS = 600 };

typedef struct {
    double ms, deepest, in_the_end, strain, joules;
} outcome;

// One scene, run by one of the ways.
typedef struct {
    int way;
    scene from;
    particle_system plain;
    world engine;
    vec3 *at, *before;      // [particles of the scene]
} run;

static void give_up(status s)
{
    if (s.ok) return;
    fprintf(stderr, "18-both: %s\n", s.why);
    exit(1);
}

static int particles_of(const scene *s)
{
    int n = 0;
    for (int k = 0; k < s->bodies; k++) n += scene_shape(s, k)->particles;
    return n;
}

static void begin(run *r, scene_kind kind, int way)
{
    scene_options what = scene_options_default();
    // The paper's diagonals are as stiff as the rest.
    if (way == PRINTED) what.diagonal = 1;
    r->way = way;
    give_up(scene_build(&r->from, kind, what));
    if (way == ENGINE) {
        world_options o = world_scene_options(kind, what.cloth);
        o.sleep_speed = 0;
        give_up(world_of_scene(&r->engine, &r->from, o));
    } else
        give_up(system_init(&r->plain, &r->from, way == PRINTED
                            ? system_options_printed()
                            : system_options_mended()));
    int n = particles_of(&r->from);
    r->at = calloc((size_t)n, sizeof *r->at);
    r->before = calloc((size_t)n, sizeof *r->before);
    if (!r->at || !r->before) give_up(status_out_of_memory());
}

static void end(run *r)
{
    if (r->way == ENGINE) world_free(&r->engine);
    else                  system_free(&r->plain);
    scene_free(&r->from);
    free(r->at);
    free(r->before);
}

static void read_places(run *r)
{
    int n = particles_of(&r->from);
    for (int i = 0; i < n; i++) r->before[i] = r->at[i];
    if (r->way != ENGINE) {
        for (int i = 0; i < n; i++) r->at[i] = r->plain.pool.at[i].position;
        return;
    }
    int first = 0;
    for (int k = 0; k < r->from.bodies; k++) {
        world_vertices(&r->engine, &r->engine.body[k], r->at + first);
        first += scene_shape(&r->from, k)->particles;
    }
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static outcome go(scene_kind kind, int way, int steps)
{
    static run r;
    static double ms[MOST_STEPS];
    outcome o = { 0 };
    begin(&r, kind, way);
    read_places(&r);
    for (int step = 0; step < steps; step++) {
        double start = clock_seconds();
        if (way == ENGINE) world_step(&r.engine);
        else               system_step(&r.plain);
        ms[step] = 1e3 * (clock_seconds() - start);
        read_places(&r);
        poses p = poses_measure(&r.from, r.at);
        o.in_the_end = fmax(fmax(p.overlap, p.behind), p.inside);
        o.deepest = fmax(o.deepest, o.in_the_end);
        o.strain = fmax(o.strain, p.strain);
    }
    o.joules = poses_kinetic(&r.from, r.before, r.at, 1.0 / 60);
    qsort(ms, (size_t)steps, sizeof *ms, by_size);
    o.ms = ms[steps / 2];
    end(&r);
    return o;
}

int main(void)
{
    static const char *const name[] = { "fifty icosahedra, 10 s",
        "cloth of 40 x 40 on a cube, 5 s", "on a rope, 5 s" };
    static const char *const way_name[] = { "plain, as printed",
        "plain, as mended", "engine" };
    printf("# 18-both: the three scenes, by the plain system and the engine\n"
           "# compiler %s, flags %s\n# way ms deepest_m in_the_end_m strain "
           "joules\n#scenes| scene,way,\"a step, ms\",\"deepest, mm\","
           "\"in the end, mm\",\"largest strain\",\"J left\"\n", __VERSION__,
           FLAGS);
    for (int k = 0; k < SCENES; k++) {
        for (int way = 0; way < WAYS; way++) {
            outcome o = go((scene_kind)k, way, k == SCENE_ROOM ? 600 : 300);
            printf("%d %.3f %.5g %.5g %.3g %.3g\n", way, o.ms, o.deepest,
                   o.in_the_end, o.strain, o.joules);
            printf("#scenes| \"%s\",\"%s\",%.2f,%.1f,%.1f,%.2g,%.2g\n", name[k],
                   way_name[way], o.ms, 1e3 * o.deepest, 1e3 * o.in_the_end,
                   o.strain, o.joules);
        }
        printf("\n\n");
    }
    return 0;
}
