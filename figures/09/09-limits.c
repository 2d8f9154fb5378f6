// 09-limits.c - what the paper's system cannot do, mended as it is, and the
// engine beside it: six short experiments, a block of the CSV each.

#include "trial.h"
#include "clock.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

static void stop_if(status s)
{
    if (s.ok) return;
    fprintf(stderr, "09-limits: %s\n", s.why);
    exit(1);
}

static void print_block(const char *columns)
{
    static int blocks = 0;
    if (blocks++) printf("\n\n");
    printf("%s\n", columns);
}

static void add(scene *s, status built, shape *made, placement where)
{
    stop_if(built);
    stop_if(scene_add_shape(s, made));
    stop_if(scene_add(s, s->shapes - 1, where));
}

static void add_box(scene *s, vec3 sides, real mass, placement where)
{
    shape box;
    add(s, shape_box(&box, sides, mass), &box, where);
}

// ---- 1. Cloth stretches ------------------------------------------------------

// Strain of the cloth on the cube in five seconds, and ms a step.
static void print_strain(void)
{
    print_block("substeps,mended_ms,mended_strain_percent");
    scene_options what = scene_options_default();
    trial t;
    for (int n = 4; n <= 32; n *= 2) {
        runner r;
        system_options how = system_options_mended();
        how.substeps = n;
        how.find_every = n / 2;
        stop_if(runner_begin_system(&r, BY_PLAIN, SCENE_CLOTH_ON_CUBE, what,
                                    how));
        trial_run(&r, 5, &t);
        printf("%d,%.4g,%.4g\n", n, t.ms, 100 * t.strain);
    }
    print_block("substeps,engine_ms,engine_strain_percent");
    stop_if(trial_of(BY_ENGINE, SCENE_CLOTH_ON_CUBE, what, 5, &t));
    printf("9,%.4g,%.4g\n", t.ms, 100 * t.strain);
}

// ---- 2. Fast bodies overlap --------------------------------------------------

// Deepest overlap of two icosahedra that meet head on, % of their radius, after
// a way of so many frames.
static real overlap_from(runner_kind kind, real speed, real frames)
{
    scene s;
    runner r;
    real deepest = 0, way = 0.6 + frames * speed / 120;
    scene_init(&s);
    for (int side = -1; side <= 1; side += 2) {
        shape ball;
        placement p = placement_at(vec3_make(side * way, 0, 0));
        p.velocity = vec3_make(-side * speed / 2, 0, 0);
        add(&s, shape_icosahedron(&ball, 0.5, 1), &ball, p);
    }
    stop_if(runner_begin_scene(&r, kind, &s));
    for (int f = 0; f < 30; f++) {
        runner_step(&r);
        deepest = real_max(deepest, runner_poses(&r).overlap);
    }
    // Past each other: the deepest that there is.
    if (runner_middle(&r, 0).x > runner_middle(&r, 1).x) deepest = 1;
    runner_free(&r);
    return 100 * deepest / 0.5;
}

// The worst of ten moments at which the frame may find them.
static real overlap_at(runner_kind kind, real speed)
{
    real worst = 0;
    for (int k = 0; k < 10; k++)
        worst = real_max(worst, overlap_from(kind, speed, 1 + k / 10.0));
    return worst;
}

static void print_speed(void)
{
    const real speed[] = { 1, 2, 5, 10, 20, 50, 100 };
    print_block("closing_speed_m_s,mended_overlap_percent,"
                "engine_overlap_percent");
    for (size_t k = 0; k < sizeof speed / sizeof *speed; k++)
        printf("%g,%.4g,%.4g\n", speed[k], overlap_at(BY_PLAIN, speed[k]),
               overlap_at(BY_ENGINE, speed[k]));
}

// ---- 3. Heavy on light -------------------------------------------------------

// m, by which a box has left its place after five seconds on one of 1 kg.
static real moved_by(runner_kind kind, real mass)
{
    scene s;
    runner r;
    scene_init(&s);
    stop_if(scene_add_plane(&s, vec3_make(0, 1, 0), 0));
    for (int k = 0; k < 2; k++)
        add_box(&s, vec3_make(1, 1, 1), k ? mass : 1,
                placement_at(vec3_make(0, 0.51 + 1.01 * k, 0)));
    stop_if(runner_begin_scene(&r, kind, &s));
    for (int f = 0; f < 300; f++) runner_step(&r);
    real moved = vec3_distance(runner_middle(&r, 1), vec3_make(0, 1.51, 0));
    runner_free(&r);
    return moved;
}

static void print_ratio(void)
{
    print_block("mass_ratio,mended_moved_m,engine_moved_m");
    for (real ratio = 1; ratio <= 1000; ratio *= 10)
        printf("%g,%.4g,%.4g\n", ratio, moved_by(BY_PLAIN, ratio),
               moved_by(BY_ENGINE, ratio));
}

// ---- 4. It creeps ------------------------------------------------------------

// mm/s of a box on a slope (rise over run), in the third and fourth second.
static real creep_at(runner_kind kind, real slope)
{
    scene s;
    runner r;
    real c = 1 / sqrt(1 + slope * slope);
    placement p = placement_at(vec3_make(0, 0, 0));
    p.x = vec3_make(c, -slope * c, 0);
    p.y = vec3_make(slope * c, c, 0);
    p.position = vec3_scale(0.256, p.y);
    scene_init(&s);
    stop_if(scene_add_plane(&s, p.y, 0));
    add_box(&s, vec3_make(1, 0.5, 1), 1, p);
    stop_if(runner_begin_scene(&r, kind, &s));
    for (int f = 0; f < 120; f++) runner_step(&r);
    vec3 before = runner_middle(&r, 0);
    for (int f = 0; f < 120; f++) runner_step(&r);
    real creep = 1e3 * vec3_distance(runner_middle(&r, 0), before) / 2;
    runner_free(&r);
    return creep;
}

static void print_creep(void)
{
    print_block("slope,mended_mm_s,engine_mm_s");
    for (int k = 0; k <= 9; k++)
        printf("%g,%.4g,%.4g\n", 0.05 * k, creep_at(BY_PLAIN, 0.05 * k),
               creep_at(BY_ENGINE, 0.05 * k));
}

// ---- 5. Nothing ever rests ---------------------------------------------------

// J in the room of 50, the mean of each half second.
static void print_rest(void)
{
    runner r[RUNNERS];
    print_block("seconds,mended_J,engine_J,printed_J");
    for (int k = 0; k < RUNNERS; k++)
        stop_if(runner_begin(&r[k], (runner_kind)k, SCENE_ROOM,
                             scene_options_default()));
    for (int half = 1; half <= 40; half++) {
        real sum[RUNNERS] = { 0 };
        for (int f = 0; f < 30; f++)
            for (int k = 0; k < RUNNERS; k++) {
                runner_step(&r[k]);
                sum[k] += runner_measure(&r[k]).kinetic / 30;
            }
        printf("%g,%.4g,%.4g,%.4g\n", 0.5 * half, sum[BY_PLAIN], sum[BY_ENGINE],
               sum[AS_PRINTED]);
    }
    for (int k = 0; k < RUNNERS; k++) runner_free(&r[k]);
}

// ---- 6. Many are slow --------------------------------------------------------

static real ms_of(runner_kind kind, int bodies)
{
    enum { STEPS = 30 };
    runner r;
    scene_options what = scene_options_default();
    real taken[STEPS];
    what.bodies = bodies;
    stop_if(runner_begin(&r, kind, SCENE_ROOM, what));
    for (int f = 0; f < 180; f++) runner_step(&r);
    for (int f = 0; f < STEPS; f++) {
        real start = clock_seconds();
        runner_step(&r);
        taken[f] = 1e3 * (clock_seconds() - start);
    }
    runner_free(&r);
    return clock_median(taken, STEPS);
}

static void print_many(void)
{
    const int bodies[] = { 10, 30, 100, 300, 1000 };
    print_block("bodies,mended_ms,engine_ms");
    for (size_t k = 0; k < sizeof bodies / sizeof *bodies; k++)
        printf("%d,%.4g,%.4g\n", bodies[k], ms_of(BY_PLAIN, bodies[k]),
               ms_of(BY_ENGINE, bodies[k]));
}

int main(void)
{
    printf("# what the paper's system cannot do, as mended, and the engine\n"
           "# compiler: %s\n# flags: %s\n", __VERSION__, FLAGS);
    print_strain();
    print_speed();
    print_ratio();
    print_creep();
    print_rest();
    print_many();
    return 0;
}
