// 03-cube.c - how many sticks until a cube stands?
//
// The corners of a cube of side 1 m, joined by 12 to 28 sticks, fall on one
// corner from half a metre.  Four blocks of lines, each after two blank lines:
// the sticks as they lie after 3 s (to be drawn), the rank as sticks are added,
// and the time of a step against the error of the shape.

#include "body.h"
#include "clock.h"
#include "interleave.h"
#include "rigidity.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { STEPS = 180, CUBES = 5, ROUNDS = 40, MOST = 28 };
static const real DT = 1.0 / 60;
static const int STICKS[CUBES] = { 12, 16, 18, 22, 28 };

// How many coordinates the ends of a stick differ in: 1 an edge, 2 a diagonal
// of a side, 3 a main diagonal.
static int class_of(int a, int b)
{
    int d = a ^ b;
    return (d & 1) + (d >> 1 & 1) + (d >> 2);
}

static int add(stick *s, int n, int class, int even, const vec3 *at)
{
    for (int a = 0; a < 8; a++)
        for (int b = a + 1; b < 8; b++) {
            int bits = (a & 1) + (a >> 1 & 1) + (a >> 2);
            if (class_of(a, b) != class) continue;
            if (class == 2 && even != (bits % 2 == 0)) continue;
            s[n++] = (stick){ a, b, vec3_distance(at[a], at[b]), 1,
                              STICK_EXACT };
        }
    return n;
}

// The sticks of cube number which: edges, then diagonals of sides, then main
// diagonals; number 1 leaves the sides out, number 4 has both of their
// diagonals.  Main diagonals come before the sides if main_first.
static int cube_sticks(stick *s, int which, int main_first, const vec3 *at)
{
    int n = add(s, 0, 1, 0, at);
    int main = which == 1 || which >= 3;
    if (main && main_first) n = add(s, n, 3, 0, at);
    if (which >= 2) n = add(s, n, 2, 1, at);
    if (which == 4) n = add(s, n, 2, 0, at);
    if (main && !main_first) n = add(s, n, 3, 0, at);
    return n;
}

static void cube_corners(vec3 *at)
{
    for (int k = 0; k < 8; k++)
        at[k] = vec3_make((k & 1) - 0.5, (k >> 1 & 1) - 0.5, (k >> 2) - 0.5);
}

// Turned so that a corner is down, a little off the balance.
static void start(particle *p, const vec3 *at)
{
    vec3 u = vec3_unit(vec3_make(1.0, 1.15, 0.9));
    vec3 r = vec3_unit(vec3_cross(u, vec3_make(0, 0, 1)));
    vec3 t = vec3_cross(r, u);
    real low = 0;
    for (int k = 0; k < 8; k++) low = fmin(low, vec3_dot(u, at[k]));
    for (int k = 0; k < 8; k++) {
        vec3 x = vec3_make(vec3_dot(r, at[k]), vec3_dot(u, at[k]) - low + 0.5,
                           vec3_dot(t, at[k]));
        p[k] = particle_start(x, vec3_make(0, 0, 0), vec3_make(0, -9.81, 0), 8,
                              DT);
    }
}

// The largest error of the 28 distances between corners, each as a fraction of
// what it should be.
static real shape_error(const particle *p, const vec3 *at)
{
    real worst = 0;
    for (int a = 0; a < 8; a++)
        for (int b = a + 1; b < 8; b++) {
            real rest = vec3_distance(at[a], at[b]);
            real now = vec3_distance(p[a].position, p[b].position);
            worst = fmax(worst, fabs(now - rest) / rest);
        }
    return worst;
}

// One step: fall, stay above the floor, pull the sticks right.  The floor holds
// what touches it by friction: it stays where it was.
static void step(particle *p, const stick *s, int n, int iterations)
{
    relax_options options = relax_options_pbd();
    verlet_step(p, 8, vec3_make(0, -9.81, 0), NULL, DT);
    for (int k = 0; k < 8; k++)
        if (p[k].position.y < 0) {
            p[k].position = p[k].previous;
            p[k].position.y = 0;
        }
    for (int k = 0; k < iterations; k++) sticks_iterate(s, n, p, options);
}

// Runs 3 s; returns the largest error of the shape on the way.
static real fall(particle *p, const stick *s, int n, int iterations,
                 const vec3 *at)
{
    real worst = 0;
    start(p, at);
    for (int k = 0; k < STEPS; k++) {
        step(p, s, n, iterations);
        worst = fmax(worst, shape_error(p, at));
    }
    return worst;
}

static void print_cubes(const vec3 *at)
{
    printf("# cube x1 y1 x2 y2, seen from the front and a little from above\n");
    for (int c = 0; c < CUBES - 1; c++) {
        stick s[MOST];
        particle p[8];
        int n = cube_sticks(s, c, 0, at);
        fall(p, s, n, 32, at);
        real middle = 0;
        for (int k = 0; k < 8; k++) middle += p[k].position.x / 8;
        for (int k = 0; k < n; k++) {
            vec3 a = p[s[k].a].position, b = p[s[k].b].position;
            printf("%d %.4f %.4f %.4f %.4f\n", STICKS[c],
                   a.x - middle + 0.35 * a.z, a.y + 0.3 * a.z,
                   b.x - middle + 0.35 * b.z, b.y + 0.3 * b.z);
        }
    }
}

static void print_ranks(vec3 *at)
{
    for (int main_first = 0; main_first < 2; main_first++) {
        stick s[MOST];
        int n = cube_sticks(s, 4, main_first, at);
        printf("\n\n# sticks rank: edges, then diagonals of %s\n",
               main_first ? "the body, then of sides"
                          : "sides, then of the body");
        for (int k = 0; k <= n; k++) {
            shape cube = { .particles = 8, .at = at, .sticks = k, .stick = s };
            printf("%d %d\n", k, shape_rank(&cube));
        }
    }
}

static void print_errors(const vec3 *at)
{
    for (int c = 0; c < CUBES; c++) {
        stick s[MOST];
        particle p[8];
        int n = cube_sticks(s, c, 0, at);
        if (!interleave(s, n, 8)) exit(1);
        printf("\n\n# sticks iterations ns_per_step largest_error\n");
        for (int iterations = 1; iterations <= 256; iterations *= 2) {
            real error = fall(p, s, n, iterations, at);
            double best = 1;
            for (int round = 0; round < ROUNDS; round++) {
                start(p, at);
                double before = clock_seconds();
                for (int k = 0; k < STEPS; k++) step(p, s, n, iterations);
                double took = clock_seconds() - before;
                if (took < best) best = took;
            }
            printf("%d %d %.1f %.3e\n", n, iterations, best / STEPS * 1e9,
                   error);
        }
    }
}

int main(void)
{
    vec3 at[8];
    cube_corners(at);
    printf("# A cube of 12 to 28 sticks falls on a corner: where it lies, rank,"
           " and error against time\n# %s, %s\n", __VERSION__, FLAGS);
    print_cubes(at);
    print_ranks(at);
    print_errors(at);
    return 0;
}
