// 17-measure.c - chains of boxes by the engine: how far joints come apart, and
// how long that takes; and a box on a hinge: how well it keeps its time.
//
// 0, 1   50 boxes of 1 kg and a load of 100 kg, hanging: substeps, mm, ms a
//        frame; as a tree, and joint by joint
// 2, 3   the same, thrown from the horizontal
// 4      with the substeps that the engine chooses: load in kg; mm hanging, and
//        thrown; substeps of the frame that has most
// 5      a box on a hinge: substeps, period off by, for amplitudes of 0.3 and
//        1 rad
// mm: the furthest that the points of a joint have been apart at the end of a
// frame, in 4 s.

#include "clock.h"
#include "join.h"
#include "step.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

#define EARTH 9.81
#define PI 3.14159265358979

enum { LINKS = 50, FRAMES = 240 };

static world w;
static shape box, load;

static void need(status s)
{
    if (s.ok) return;
    fprintf(stderr, "17-measure: %s\n", s.why);
    exit(1);
}

// `most` substeps a frame; 0: as the engine likes.
static void begin(int substeps, int most)
{
    world_options o = world_options_default();
    o.sleep_speed = 0;
    o.substeps = substeps;
    if (most > 0) o.most_substeps = most;
    need(world_init(&w, o));
}

static void join(joint_plan p)
{
    need(world_join(&w, p, NULL));
}

static void hang_chain(real kg, bool aside)
{
    vec3 way = { aside, aside - 1.0, 0 };
    need(shape_box(&box, vec3_make(0.1, 0.1, 0.1), 1));
    need(shape_box(&load, vec3_make(0.5, 0.5, 0.5), kg));
    for (int k = 0; k < LINKS; k++)
        need(world_add(&w, &box, placement_at(vec3_scale(0.2 * k + 0.1, way)),
                       NULL));
    need(world_add(&w, &load, placement_at(vec3_scale(0.2 * LINKS + 0.25, way)),
                   NULL));
    for (int k = 0; k <= LINKS; k++)
        join((joint_plan){ .kind = JOINT_BALL, .a = k - 1, .b = k,
                           .point = vec3_scale(0.2 * k, way) });
}

static void end(void)
{
    world_free(&w);
    shape_free(&box);
    shape_free(&load);
}

typedef struct {
    real worst;         // mm
    real milliseconds;  // a frame
    int  substeps;      // of the frame that has most
} outcome;

static outcome run(void)
{
    outcome o = { 0, 0, 0 };
    real start = clock_seconds();
    for (int n = 0; n < FRAMES; n++) {
        world_step(&w);
        o.substeps = int_max(o.substeps, w.report.substeps);
        for (int k = 0; k < w.joints.count; k++) {
            real gap = 1e3 * world_joint_gap(&w, k);
            if (!(gap <= o.worst)) o.worst = gap;
        }
    }
    o.milliseconds = 1e3 * (clock_seconds() - start) / FRAMES;
    return o;
}

static void by_substeps(bool aside, bool is_plain)
{
    printf("\n\n# %s, %s: substeps, mm, ms a frame\n#%s| substeps,worst (mm),"
           "ms a frame\n", aside ? "thrown" : "hanging",
           is_plain ? "joint by joint" : "as a tree",
           aside ? (is_plain ? "tp" : "tt") : is_plain ? "hp" : "ht");
    for (int n = 4; n <= 128; n *= 2) {
        begin(n, n);
        hang_chain(100, aside);
        w.joints.is_plain = is_plain;
        outcome o = run();
        if (!(o.worst < 1e5)) o.worst = 1e5;
        printf("%d %.4g %.4g\n", n, o.worst, o.milliseconds);
        end();
    }
}

static void by_load(void)
{
    printf("\n\n# by load, the engine's substeps: kg, mm hanging, mm thrown, "
           "substeps\n#load| load (kg),hanging: worst (mm),thrown: worst (mm),"
           "substeps at most,ms a frame\n");
    for (real kg = 1; kg <= 10000; kg *= 10) {
        outcome o[2];
        for (int aside = 0; aside < 2; aside++) {
            begin(8, 0);
            hang_chain(kg, aside);
            o[aside] = run();
            end();
        }
        printf("%g %.4g %.4g %d\n#load| %g,%.2g,%.2g,%d,%.2g\n", kg, o[0].worst,
               o[1].worst, o[1].substeps, kg, o[0].worst, o[1].worst,
               o[1].substeps, o[1].milliseconds);
    }
}

// A pendulum of this amplitude takes 1 / AGM(1, cos(amplitude / 2)) times as
// long as one that hardly swings (Gauss): the arithmetic-geometric mean.
static real longer(real amplitude)
{
    real a = 1, b = cos(amplitude / 2);
    for (int k = 0; k < 6; k++) {
        real mean = (a + b) / 2;
        b = sqrt(a * b);
        a = mean;
    }
    return 1 / a;
}

// How far the mean of five periods is off that of its inertia.
static real period_error(int substeps, real amplitude)
{
    real c = cos(amplitude), s = sin(amplitude);
    placement p = placement_at(vec3_make(s / 2, -c / 2, 0));
    p.x = vec3_make(c, s, 0);
    p.y = vec3_make(-s, c, 0);
    begin(substeps, substeps);
    need(shape_box(&box, vec3_make(0.3, 1, 0.2), 3));
    need(world_add(&w, &box, p, NULL));
    join((joint_plan){ .kind = JOINT_HINGE, .a = -1, .b = 0,
                       .axis = { 0, 0, 1 } });
    real before = s, first = 0, last = 0;
    for (int n = 1, crossings = 0; crossings < 11; n++) {
        world_step(&w);
        real now = rigid4_frame(w.pool.at).center.x;
        if (now * before < 0) {
            last = (n - now / (now - before)) * w.options.dt;
            if (crossings++ == 0) first = last;
        }
        before = now;
    }
    end();
    real small = 2 * PI * sqrt(((0.09 + 1) / 12 + 0.25) / (EARTH / 2));
    return (last - first) / 5 / small / longer(amplitude) - 1;
}

int main(void)
{
    clock_print_head("17-measure: joints, by the engine, 60 frames a second",
                     FLAGS);
    for (int aside = 0; aside < 2; aside++)
        for (int plain = 0; plain < 2; plain++) by_substeps(aside, plain);
    by_load();
    printf("\n\n# a box on a hinge: substeps, period off by, 0.3 and 1 rad\n"
           "#swing| substeps,0.3 rad: period off by,1 rad\n");
    for (int n = 4; n <= 64; n *= 2) {
        real x = period_error(n, 0.3), y = period_error(n, 1);
        printf("%d %.3g %.3g\n#swing| %d,%.1e,%.1e\n", n, fabs(x), fabs(y), n, x,
               y);
    }
    return 0;
}
