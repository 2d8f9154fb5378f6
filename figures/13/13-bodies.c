// 13-bodies.c - what four particles and warm-started contacts are good for.
// The ladder: the room of 50 bodies, time against error, by the paper's system
// as printed and as mended, and by the engine.  And ten cubes, one on the
// other, that may not sleep: how far do they drift?

#include "clock.h"
#include "runner.h"
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

static void follow(runner *run, outcome *r)
{
    real taken[STEPS];
    for (int k = 0; k < STEPS; k++) {
        real start = clock_seconds();
        runner_step(run);
        taken[k] = 1e3 * (clock_seconds() - start);
        if (k % LOOK != 0) continue;
        measures m = runner_measure(run);
        r->overlap = fmax(r->overlap, 100 * m.penetration / SCENE_BODY_RADIUS);
        r->strain = fmax(r->strain, 100 * m.strain);
        if (k >= STEPS - LAST) r->left += m.kinetic * LOOK / LAST;
    }
    r->ms = clock_median(taken, STEPS);
}

// What runs the room: the engine, or the paper's system.
typedef struct {
    runner_kind kind;
    world_options engine;
    system_options plain;
} way;

static outcome room(way how, unsigned long long seed)
{
    static runner run;
    outcome r = { 0, 0, 0, 0 };
    scene_options what = scene_options_default();
    what.seed = seed;
    how.engine.sleep_speed = 0;
    status done = how.kind == BY_ENGINE
        ? runner_begin_world(&run, SCENE_ROOM, what, how.engine)
        : runner_begin_system(&run, how.kind, SCENE_ROOM, what, how.plain);
    if (!done.ok) exit(1);
    follow(&run, &r);
    runner_free(&run);
    return r;
}

// The median of five throws.
static outcome line_of(int number, way how)
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
    return (outcome){ ms[SEEDS / 2], overlap[SEEDS / 2], left[SEEDS / 2],
                      strain[SEEDS / 2] };
}

static real ms_at_error(const outcome *r, int n)
{
    real ms[8], overlap[8];
    for (int k = 0; k < n; k++) {
        ms[k] = r[k].ms;
        overlap[k] = r[k].overlap;
    }
    return clock_at_error(ms, overlap, n, 1.5);
}

static void print_plain(outcome mended[5])
{
    way how = { .kind = AS_PRINTED, .plain = runner_options(AS_PRINTED) };
    printf("\n\n# chapter 09, as printed: substeps, ...\n");
    line_of(how.plain.substeps, how);
    how = (way){ .kind = BY_PLAIN, .plain = runner_options(BY_PLAIN) };
    printf("\n\n# chapter 09, as mended: substeps, ...\n"
           "#substeps| substeps,\"deepest overlap, %% of a radius\","
           "joules left after 6 s,ms a step\n");
    for (int n = 2, k = 0; k < 5; n *= 2, k++) {
        how.plain.substeps = n;
        mended[k] = line_of(n, how);
        printf("#substeps| %d,%.2g,%.2g,%.2f\n", n, mended[k].overlap,
               mended[k].left, mended[k].ms);
    }
}

static void ladder(void)
{
    outcome mended[5], engine[5];
    way how = { .kind = BY_ENGINE };
    printf("\n\n# engine: substeps, ms a step, deepest overlap (%% of a "
           "radius), joules left, strain (%%)\n"
           "#engine| substeps,\"deepest overlap, %% of a radius\","
           "joules left after 6 s,ms a step\n");
    for (int n = 2, k = 0; k < 5; n *= 2, k++) {
        how.engine = world_options_default();
        how.engine.substeps = how.engine.most_substeps = n;
        engine[k] = line_of(n, how);
        printf("#engine| %d,%.2g,%.2g,%.2f\n", n, engine[k].overlap,
               engine[k].left, engine[k].ms);
    }
    print_plain(mended);
    clock_print_row("world", "room of 50 by substeps",
                    "overlap 1.5 % of a radius",
                    "the engine", "the paper's system",
                    ms_at_error(mended, 5) / ms_at_error(engine, 5));
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
    int ok = world_init(w, how).ok
        && world_add_plane(w, vec3_make(0, 1, 0), 0).ok;
    for (int b = 0; b < CUBES; b++) {
        vec3 at = { 0, 0.5 + b, 0 };
        ok = ok && world_add(w, cube, placement_at(at), NULL).ok;
    }
    if (!ok) exit(1);
}

// mm: by how much the highest cube has sunk after ten seconds, and the furthest
// way of a cube in the last five.
static void stand(world_options how, real *sag, real *drift)
{
    world w;
    shape cube;
    vec3 half[CUBES] = { { 0, 0, 0 } };
    how.sleep_speed = 0;
    if (!shape_box(&cube, vec3_make(1, 1, 1), 1).ok) exit(1);
    pile_up(&w, &cube, how);
    *drift = 0;
    for (int k = 0; k < FRAMES; k++) {
        world_step(&w);
        for (int b = 0; b < CUBES && k == FRAMES / 2 - 1; b++)
            half[b] = middle(&w, b);
    }
    for (int b = 0; b < CUBES; b++)
        *drift = fmax(*drift, 1e3 * vec3_distance(middle(&w, b), half[b]));
    *sag = 1e3 * (CUBES - 0.5 - middle(&w, CUBES - 1).y);
    world_free(&w);
    shape_free(&cube);
}

static void stacks(void)
{
    printf("\n\n# ten cubes: substeps, warm-started: sag and drift in mm; from "
           "nothing: the same\n");
    for (int n = 2; n <= 32; n *= 2) {
        real sag[2], drift[2];
        for (int warm = 0; warm < 2; warm++) {
            world_options how = world_options_default();
            how.warm_start = warm;
            how.substeps = how.most_substeps = n;
            stand(how, &sag[warm], &drift[warm]);
        }
        printf("%d %.4g %.4g %.4g %.4g\n", n, sag[1], drift[1], sag[0],
               drift[0]);
    }
}

int main(void)
{
    printf("# the room of 50 bodies, 6 s, sleeping is off, the median of %d "
           "throws; ten cubes of 1 m, one on the other, 10 s awake\n"
           "# compiler: %s\n# flags: %s\n", SEEDS, __VERSION__, FLAGS);
    ladder();
    stacks();
    return 0;
}
