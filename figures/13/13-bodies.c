// 13-bodies.c - what passes, substeps and a memory are good for.  The ladder:
// the room of 50 bodies, time against error.  And ten cubes, one on the other,
// that may not sleep: how far do they drift?

#include "clock.h"
#include "world_scene.h"
#include "step.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

// --- the room ----------------------------------------------------------------

enum { STEPS = 360, LAST = 60, SEEDS = 5, LOOK = 4 };

// ms: median over the steps; overlap: the deepest of all, % of a radius; left:
// J, mean of the last second; strain: the largest, %.
typedef struct {
    real ms, overlap, left, strain;
} outcome;

static outcome room(world_options how, unsigned long long seed)
{
    outcome r = { 0, 0, 0, 0 };
    real taken[STEPS];
    world_scene s;
    scene_options what = scene_options_default();
    what.seed = seed;
    how.resting = 0;
    if (!world_scene_build(&s, SCENE_ROOM, what, how).ok) exit(1);
    for (int k = 0; k < STEPS; k++) {
        real start = clock_seconds();
        world_step(&s.world);
        taken[k] = 1e3 * (clock_seconds() - start);
        if (k % LOOK != 0) continue;
        measures m = world_measure(&s.world);
        r.overlap = fmax(r.overlap, 100 * m.penetration / s.body_radius);
        r.strain = fmax(r.strain, 100 * m.strain);
        if (k >= STEPS - LAST) r.left += m.kinetic * LOOK / LAST;
    }
    r.ms = clock_median(taken, STEPS);
    world_scene_free(&s);
    return r;
}

// The median of five throws.
static void rung(int number, world_options how)
{
    real ms[SEEDS], overlap[SEEDS], left[SEEDS], strain[SEEDS];
    for (int k = 0; k < SEEDS; k++) {
        outcome r = room(how, (unsigned long long)k + 1);
        ms[k] = r.ms;
        overlap[k] = r.overlap;
        left[k] = r.left;
        strain[k] = r.strain;
    }
    printf("%d %.4f %.4g %.4g %.3g\n", number, clock_median(ms, SEEDS),
           clock_median(overlap, SEEDS), clock_median(left, SEEDS),
           clock_median(strain, SEEDS));
}

static void ladder(void)
{
    printf("\n\n# 4 substeps: passes, ms a step, deepest overlap (%% of a "
           "radius), joules left, strain (%%)\n");
    for (int n = 2; n <= 8; n *= 2) {
        world_options how = world_options_default();
        how.passes = n;
        rung(n, how);
    }
    printf("\n\n# 4 passes: substeps, ...\n");
    for (int n = 1; n <= 8; n *= 2) {
        world_options how = world_options_default();
        how.substeps = n;
        rung(n, how);
    }
}

// --- ten cubes ---------------------------------------------------------------

enum { CUBES = 10, FRAMES = 600 };

static vec3 middle(const world *w, int b)
{
    const body *x = &w->body[b];
    int n = body_particles(x);
    vec3 sum = { 0, 0, 0 };
    for (int i = 0; i < n; i++)
        sum = vec3_add_scaled(sum, 1.0 / n, w->pool.at[x->first + i].position);
    return sum;
}

static void pile_up(world *w, const shape *cube, world_options how)
{
    real skin = how.skin * cube->radius;
    int ok = world_init(w, how).ok
        && world_add_plane(w, vec3_make(0, 1, 0), 0).ok;
    for (int b = 0; b < CUBES; b++) {
        vec3 at = { 0, 0.5 + b + skin * (1 + 2 * b), 0 };
        ok = ok && world_add(w, cube, placement_at(at), NULL).ok;
    }
    if (!ok || !world_begin(w).ok) exit(1);
}

// mm, the furthest way of a cube in ten seconds, over the number of cubes up to
// it.
static real drift(world_options how)
{
    world w;
    shape cube;
    vec3 start[CUBES];
    real most = 0;
    how.resting = 0;
    if (!shape_box(&cube, vec3_make(1, 1, 1), 1).ok) exit(1);
    pile_up(&w, &cube, how);
    for (int b = 0; b < CUBES; b++) start[b] = middle(&w, b);
    for (int k = 0; k < FRAMES; k++) {
        world_step(&w);
        for (int b = 0; b < CUBES; b++)
            most = fmax(most, vec3_distance(middle(&w, b), start[b]) / (b + 1));
    }
    world_free(&w);
    shape_free(&cube);
    return 1e3 * most;
}

static void stacks(void)
{
    for (int memory = 1; memory >= 0; memory--) {
        printf("\n\n# ten cubes, %s: passes, drift in mm a cube\n",
               memory ? "with memory" : "without");
        for (int n = 2; n <= 64; n *= 2) {
            world_options how = world_options_default();
            how.memory = memory;
            how.passes = n;
            printf("%d %.4g\n", n, drift(how));
        }
    }
}

int main(void)
{
    printf("# the room of 50 bodies, 6 s, nobody sleeps, the median of %d "
           "throws; ten cubes of 1 m, one on the other, 10 s awake\n"
           "# compiler: %s\n# flags: %s\n", SEEDS, __VERSION__, FLAGS);
    ladder();
    stacks();
    return 0;
}
