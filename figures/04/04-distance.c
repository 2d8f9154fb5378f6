// 04-distance.c - GJK's error against iterations and against time, cold and with
// the simplex carried over from the last frame.
//
// 20,000 pairs of icosahedra of circumradius 0.5 m, turned at random, a gap of
// 5 cm apart; many, because a loop over few pairs teaches the processor's branch
// predictor the answers.  For the carried queries both bodies have moved on: by
// up to 0.5 degree and 2.5 mm.  The searches that stop early are made of
// lib/paper/gjk.c and 04-distance.edits when this program is built.
//
// index 0: cap cold_ns cold_error carried_ns carried_error (relative, mean)
// index 1: gap, ns and iterations, cold and carried
// Columns are separated by spaces.

#include "clock.h"
#include "gjk.h"
#include "random.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { PAIRS = 20000, BLOCK = 500, CORNERS = 12, CAPS = 9, PASSES = 8 };

typedef gjk_result find(hull a, hull b, real margin, simplex *carried);

find gjk_distance_1, gjk_distance_2, gjk_distance_3, gjk_distance_4,
     gjk_distance_5, gjk_distance_6, gjk_distance_7, gjk_distance_8;

static find *const stopped[CAPS] = {
    gjk_distance_1, gjk_distance_2, gjk_distance_3, gjk_distance_4,
    gjk_distance_5, gjk_distance_6, gjk_distance_7, gjk_distance_8,
    gjk_distance
};

typedef struct { vec3 at[CORNERS]; } body;
static struct { body a, b, moved_a, moved_b; } pair[PAIRS];
static simplex carried[PAIRS];
static real truth[PAIRS], moved_truth[PAIRS];
static unsigned long long seed;

// Turned by an angle (rad) about a unit axis (Rodrigues).
static vec3 turned(vec3 p, vec3 axis, real angle)
{
    real c = cos(angle), s = sin(angle), along = (1 - c) * vec3_dot(axis, p);
    return vec3_add_scaled(vec3_add_scaled(vec3_scale(c, p), s,
                                           vec3_cross(axis, p)), along, axis);
}

static body any_icosahedron(void)
{
    const real golden = (1 + sqrt(5.0)) / 2;
    const real k = 0.5 / sqrt(1 + golden * golden);
    vec3 axis = random_direction(&seed);
    real angle = 6.283185307179586 * random_fraction(&seed);
    body b;
    for (int i = 0; i < CORNERS; i++) {
        real one = i & 1 ? k : -k, phi = golden * (i & 2 ? k : -k);
        vec3 p = i / 4 == 0 ? (vec3){ 0, one, phi }
               : i / 4 == 1 ? (vec3){ one, phi, 0 } : (vec3){ phi, 0, one };
        b.at[i] = turned(p, axis, angle);
    }
    return b;
}

static void move(body *b, vec3 by)
{
    for (int i = 0; i < CORNERS; i++) b->at[i] = vec3_add(b->at[i], by);
}

static gjk_result ask(find *f, const body *a, const body *b, simplex *s)
{
    return f((hull){ a->at, CORNERS }, (hull){ b->at, CORNERS }, HUGE_VAL, s);
}

// Up to 0.5 degree and 2.5 mm further.
static body nudged(const body *b)
{
    vec3 axis = random_direction(&seed),
         by = vec3_scale(0.0025 * random_fraction(&seed),
                         random_direction(&seed));
    real angle = 0.5 / 180 * 3.141592653589793 * random_fraction(&seed);
    body out = *b;
    for (int i = 0; i < CORNERS; i++) {
        vec3 r = vec3_sub(b->at[i], b->at[0]);
        out.at[i] = vec3_add(vec3_add(b->at[0], by), turned(r, axis, angle));
    }
    return out;
}

// B comes in along a line until the gap is right: the distance falls along it,
// at a rate that the axis tells (Newton).  A negative gap: pushed in so far.
static void make_pair(int i, real gap)
{
    real wanted = gap > 1e-6 ? gap : 1e-6;
    vec3 way = random_direction(&seed);
    pair[i].a = any_icosahedron();
    pair[i].b = any_icosahedron();
    move(&pair[i].b, vec3_scale(1.5, way));
    gjk_result r = ask(gjk_distance, &pair[i].a, &pair[i].b, NULL);
    for (int k = 0; k < 60 && fabs(r.distance - wanted) > 1e-9; k++) {
        real slope = -vec3_dot(r.axis, way) / r.distance;
        move(&pair[i].b, vec3_scale((wanted - r.distance) / slope, way));
        r = ask(gjk_distance, &pair[i].a, &pair[i].b, NULL);
    }
    if (gap < 0) move(&pair[i].b, vec3_scale(-gap / r.distance, r.axis));
    pair[i].moved_a = nudged(&pair[i].a);
    pair[i].moved_b = nudged(&pair[i].b);
    carried[i].count = 0;
    truth[i] = ask(gjk_distance, &pair[i].a, &pair[i].b, &carried[i]).distance;
    moved_truth[i] = ask(gjk_distance, &pair[i].moved_a, &pair[i].moved_b,
                         NULL).distance;
}

typedef struct { double ns, error, iterations; } cost;

// One block of pairs, asked once: ns.
static double run_block(find *f, int first, int warm, cost *c)
{
    static simplex s[BLOCK];
    static real distance[BLOCK];
    for (int k = 0; k < BLOCK; k++) s[k] = carried[first + k];
    double start = clock_seconds();
    for (int k = 0; k < BLOCK; k++) {
        int i = first + k;
        gjk_result r = warm
            ? ask(f, &pair[i].moved_a, &pair[i].moved_b, &s[k])
            : ask(f, &pair[i].a, &pair[i].b, NULL);
        distance[k] = r.distance;
        c->iterations += r.iterations;
    }
    double ns = 1e9 * (clock_seconds() - start);
    for (int k = 0; k < BLOCK; k++) {
        real d = warm ? moved_truth[first + k] : truth[first + k];
        if (d > 0) c->error += fabs(distance[k] - d) / d / PAIRS;
    }
    return ns;
}

// Every block at its quickest pass.
static cost run(find *f, int warm)
{
    cost all = { 0, 0, 0 };
    for (int b = 0; b < PAIRS / BLOCK; b++) {
        double best = HUGE_VAL;
        for (int pass = 0; pass < PASSES; pass++) {
            cost c = { 0, 0, 0 };
            best = fmin(best, run_block(f, b * BLOCK, warm, &c));
            if (pass > 0) continue;
            all.error += c.error;
            all.iterations += c.iterations / PAIRS;
        }
        all.ns += best / PAIRS;
    }
    return all;
}

static void prepare(real gap)
{
    seed = 1;
    for (int i = 0; i < PAIRS; i++) make_pair(i, gap);
}

int main(void)
{
    const real gap[] = { 0.3, 0.05, 0.005, 1e-5, -0.005, -0.1 };
    printf("# 04-distance: GJK on %d pairs of icosahedra of circumradius 0.5 m,"
           " 5 cm apart\n# compiler %s, flags %s\n"
           "# cap cold_ns cold_error carried_ns carried_error\n", (int)PAIRS,
           __VERSION__, FLAGS);
    prepare(0.05);
    for (int k = 0; k < CAPS; k++) {
        cost cold = run(stopped[k], 0), warm = run(stopped[k], 1);
        printf("%d %.0f %.3g %.0f %.3g\n", k + 1, cold.ns, cold.error, warm.ns,
               warm.error);
    }
    printf("\n\n# gap cold_ns iterations carried_ns iterations\n"
           "#gaps| \"gap, m\",\"cold, ns\",iterations,\"carried, ns\","
           "iterations\n");
    for (int g = 0; g < 6; g++) {
        prepare(gap[g]);
        cost cold = run(gjk_distance, 0), warm = run(gjk_distance, 1);
        printf("%g %.0f %.2f %.0f %.2f\n", gap[g], cold.ns, cold.iterations,
               warm.ns, warm.iterations);
        printf("#gaps| %g,%.0f,%.1f,%.0f,%.2f\n", gap[g], cold.ns,
               cold.iterations, warm.ns, warm.iterations);
    }
    return 0;
}
