// 10-fewer.c - what does it cost to know, through a frame, where two bodies are
// nearest, and how far off is what is known?  The pair is asked 1, 2, 4 or 8
// times a frame, cold or with what it carries; in between, the two points that
// were found ride with their bodies.
//
// index 0: icosahedra 1 cm apart: queries a frame, cold: ns a frame, mean error
//          of the gap, m; carried: the same
// index 1: the same 1 cm deep in each other

#include "query_pairs.h"
#include "query.h"

#include <stdio.h>
#include <string.h>

enum { SOME = 1000, STEPS = 8, COUNTS = 4, GROUPS = 2, ROUNDS = 9,
       WAYS = GROUPS * 2 * COUNTS };
static const int COUNT[COUNTS] = { 1, 2, 4, STEPS };
static const real GAP[GROUPS] = { 0.01, -0.01 };

// The pairs of a group through one frame: B stands, and A is at `at[s]` in
// substep s.  Before it, the pair was asked where A was at the frame's start.
typedef struct {
    icosahedron at[SOME][STEPS], b[SOME];
    query_cache last[SOME];
    real truth[SOME][STEPS];    // m, the gap
    real error;                 // m, the sum over pairs and substeps
} group;

static shape ball;
static group all[GROUPS];

static query_result ask(const icosahedron *a, const icosahedron *b,
                        query_cache *carried)
{
    collider ca = { &ball, a->at, false }, cb = { &ball, b->at, false };
    return query_nearest(&ca, &cb, 0.05, carried);
}

// A goes about 5 mm and turns by half a degree in the frame.
static void make_group(group *g, real gap)
{
    static pair_at_gap pair[SOME];
    make_pairs(pair, SOME, gap);
    for (int i = 0; i < SOME; i++) {
        vec3 way = vec3_scale(0.005, random_direction(&seed));
        vec3 axis = random_direction(&seed), middle = { 0, 0, 0 };
        for (int k = 0; k < CORNERS; k++)
            middle = vec3_add_scaled(middle, 1.0 / CORNERS, pair[i].a.at[k]);
        g->b[i] = pair[i].b;
        g->last[i].count = 0;
        ask(&pair[i].a, &g->b[i], &g->last[i]);
        for (int s = 0; s < STEPS; s++) {
            real t = (s + 1) / (real)STEPS;
            for (int k = 0; k < CORNERS; k++) {
                vec3 r = turned(vec3_sub(pair[i].a.at[k], middle), axis,
                                0.0087 * t);
                g->at[i][s].at[k] = vec3_add(vec3_add_scaled(middle, t, way),
                                             r);
            }
            query_cache none = { .count = 0 };
            g->truth[i][s] = ask(&g->at[i][s], &g->b[i], &none).at.gap;
        }
    }
}

// m, between the points of r, on their bodies, along its normal.
static real gap_of(const query_result *r, const icosahedron *a,
                   const icosahedron *b)
{
    return vec3_dot(vec3_sub(feature_at(&r->at.a, a->at),
                             feature_at(&r->at.b, b->at)), r->normal);
}

// Ways 0 to 3 of a group are cold, with 1, 2, 4, 8 queries; 4 to 7 carried.
static void work(int way, void *with)
{
    group *g = &all[way / (2 * COUNTS)];
    int every = STEPS / COUNT[way % COUNTS], carried = way / COUNTS % 2;
    (void)with;
    g->error = 0;
    for (int i = 0; i < SOME; i++) {
        query_cache last = { .count = 0 };
        query_result r = { .near = false };
        if (carried) last = g->last[i];
        for (int s = 0; s < STEPS; s++) {
            if (s % every == 0) {
                if (!carried) last.count = 0;
                r = ask(&g->at[i][s], &g->b[i], &last);
            }
            g->error += fabs(gap_of(&r, &g->at[i][s], &g->b[i])
                             - g->truth[i][s]);
        }
    }
}

static void print_group(int k, const lap *l)
{
    real error[COUNTS];
    printf("%s# gap %g m: queries cold_ns error_m carried_ns error_m\n",
           k ? "\n\n" : "", GAP[k]);
    for (int c = 0; c < COUNTS; c++) {
        int cold = k * 2 * COUNTS + c, warm = cold + COUNTS;
        work(cold, NULL);
        error[c] = all[k].error / SOME / STEPS;
        printf("%d %.0f %.3g %.0f %.3g\n", COUNT[c],
               1e9 * l[cold].seconds / SOME, error[c],
               1e9 * l[warm].seconds / SOME, error[c]);
        printf("#frames| %s,%d,%.2f,%.2f,%.2g\n",
               k ? "1 cm deep" : "1 cm apart", COUNT[c], 1e6 * l[cold].seconds / SOME,
               1e6 * l[warm].seconds / SOME, 1e3 * error[c]);
    }
    char at[32];
    snprintf(at, sizeof at, "%.2g mm of the gap", 1e3 * error[0]);
    clock_print_row("query",
                    k ? "icosahedra 1 cm deep" : "icosahedra 1 cm apart", at,
                    "carried and once a frame", "cold in 8 substeps",
                    l[(2 * k + 1) * COUNTS - 1].seconds
                    / l[(2 * k + 1) * COUNTS].seconds);
}

int main(void)
{
    lap l[WAYS];
    if (!shape_icosahedron(&ball, 0.5, 1).ok) return 1;
    for (int k = 0; k < GROUPS; k++) make_group(&all[k], GAP[k]);
    clock_print_head("10-fewer: 1,000 pairs of icosahedra of circumradius "
                     "0.5 m", FLAGS);
    printf("#frames| pairs,queries a frame,\"cold, µs\",\"carried, µs\","
           "\"mean error of the gap, mm\"\n");
    clock_race((race){ WAYS, ROUNDS, 0, work, NULL }, l);
    for (int k = 0; k < GROUPS; k++) print_group(k, l);
    shape_free(&ball);
    return 0;
}
