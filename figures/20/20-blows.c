// 20-blows.c - hard cases 14, 15 and 16: a cradle of cubes, a bounce, a slope.
// Blocks for gnuplot: where the five cubes are; how high the cube is, at two
// steps; how far the block has slid, one degree on either side of sticking.

#include "hard_set.h"
#include "step.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { PASSES = 10 };
static const real PI = 3.14159265358979323846, G = 9.81;

static void begin(setting *s)
{
    status done = setting_begin(s);
    if (done.ok) return;
    fprintf(stderr, "20-blows: %s\n", done.why);
    exit(1);
}

// One cube comes in; a row for each frame, with their edges to left and right.
static void print_cradle(void)
{
    setting s;
    build_cradle(&s, best(PASSES), 0, 1, -1);
    begin(&s);
    real half = (s.start[2].x - s.start[1].x) / 2, from = s.start[2].x;
    printf("\n\n# the cradle: middles, at half a cube's width of %.4f m\n"
           "# t [s] x1 x2 x3 x4 x5 [m]\n", half);
    for (int f = 0; f <= 42; f++) {
        printf("%.6g", f * s.w.options.dt);
        for (int i = 0; i < CRADLE; i++)
            printf(" %.6g", middle(&s.w, i).x - from);
        printf("\n");
        world_step(&s.w);
    }
    setting_free(&s);
}

// m over the ground: what ought to be, of a cube that fell from 1 m at t = 0.
static real height_exact(real t, real restitution)
{
    real fall = sqrt(2 / G), speed = G * fall;
    if (t < fall) return 1 - G * t * t / 2;
    for (t -= fall; speed > 1e-3; t -= 2 * speed / G) {
        speed *= restitution;
        if (t < 2 * speed / G) return speed * t - G * t * t / 2;
        if (restitution == 0) break;
    }
    return 0;
}

static void print_bounces(void)
{
    static const int rate[2] = { 20, 240 };
    for (int e = 0; e <= 2; e++) {
        printf("\n\n# a bounce at restitution %g: exact\n# t [s] height [m]\n",
               e / 2.0);
        for (real t = 0; t < 1.8; t += 0.004)
            printf("%.4g %.6g\n", t, height_exact(t, e / 2.0));
        for (int k = 0; k < 2; k++) {
            world_options o = best(PASSES);
            o.dt = 1.0 / rate[k];
            o.restitution = e / 2.0;
            setting s;
            build_bounce(&s, o);
            begin(&s);
            printf("\n\n# a bounce at restitution %g, dt = 1/%d s\n"
                   "# t [s] height [m]\n", e / 2.0, rate[k]);
            for (int f = 0; f < 1.8 * rate[k]; f++) {
                printf("%.6g %.6g\n", f * o.dt,
                       middle(&s.w, 0).y - s.start[0].y + 1);
                world_step(&s.w);
            }
            setting_free(&s);
        }
    }
}

// 25 degrees, friction that would hold one degree less or one more.
static void print_slopes(void)
{
    const int seconds = 10;
    const real tilt = 25 * PI / 180;
    for (int over = -1; over <= 1; over += 2) {
        real mu = tan((25 + over) * PI / 180);
        real pull = fmax(0, G * (sin(tilt) - mu * cos(tilt)));
        setting s;
        build_slope(&s, best(PASSES), tilt, mu, 0);
        begin(&s);
        printf("\n\n# 25 degrees, friction for %d\n"
               "# t [s] way [m] exact [m]\n", 25 + over);
        for (int f = 0; f <= 60 * seconds; f++) {
            vec3 way = vec3_sub(middle(&s.w, 0), s.start[0]);
            real t = f * s.w.options.dt;
            if (f % 15 == 0)
                printf("%.6g %.6g %.6g\n", t, vec3_dot(way,
                       vec3_make(cos(tilt), -sin(tilt), 0)), pull * t * t / 2);
            world_step(&s.w);
        }
        setting_free(&s);
    }
}

int main(void)
{
    printf("# Hard cases 14, 15 and 16: a cradle, a bounce, a slope; %d "
           "passes\n# %s, %s\n", PASSES, __VERSION__, FLAGS);
    print_cradle();
    print_bounces();
    print_slopes();
    return 0;
}
