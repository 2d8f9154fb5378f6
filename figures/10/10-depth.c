// 10-depth.c - how deep, and what it costs: trying many directions, trying all
// that can count, and the expanding polytope.
//
// index 0: directions tried, ns, mean relative error of the depth
// index 1: ns of penetration_find alone, its mean difference from the slow way,
//          ns with distance_find before it, ns of the slow way, largest
//          difference, ns of the plain queries and their mean difference
// index 2: gap, ns of distance cold, of distance and penetration cold, carried;
//          iterations; ns of penetration that begins with nothing, and its
//          iterations
// Columns are separated by spaces.

#include "query_pairs.h"
#include "penetration.h"
#include "hit_face.h"

#include <stdio.h>
#include <stdlib.h>

enum { PASSES = 10, SOME = 2000 };

static pair_at_gap pair[PAIRS];
static distance_cache last[PAIRS];
static real truth[PAIRS];

// How far A - B reaches along n and along -n, whichever is less: one pass over
// the corners answers for both.
static real width(const icosahedron *a, const icosahedron *b, vec3 n)
{
    real a_high = -HUGE_VAL, a_low = HUGE_VAL;
    real b_high = -HUGE_VAL, b_low = HUGE_VAL;
    for (int i = 0; i < CORNERS; i++) {
        real x = vec3_dot(n, a->at[i]), y = vec3_dot(n, b->at[i]);
        a_high = x > a_high ? x : a_high;
        a_low = x < a_low ? x : a_low;
        b_high = y > b_high ? y : b_high;
        b_low = y < b_low ? y : b_low;
    }
    real up = a_high - b_low, down = b_high - a_low;
    return up < down ? up : down;
}

// Edges and faces of an icosahedron, found by who its nearest vertices are: one
// of each parallel two, for the other gives the same directions again.
static int edge[30][2], face[20][3], edges, faces;

static int is_parallel(vec3 u, vec3 v)
{
    return vec3_length(vec3_cross(u, v))
         < 1e-9 * vec3_length(u) * vec3_length(v);
}

static vec3 edge_along(const vec3 *at, int e)
{
    return vec3_sub(at[edge[e][1]], at[edge[e][0]]);
}

static vec3 face_normal(const vec3 *at, int f)
{
    return vec3_cross(vec3_sub(at[face[f][1]], at[face[f][0]]),
                      vec3_sub(at[face[f][2]], at[face[f][0]]));
}

static void add_edge(const vec3 *at, int i, int j)
{
    edge[edges][0] = i;
    edge[edges][1] = j;
    for (int k = 0; k < edges; k++)
        if (is_parallel(edge_along(at, k), edge_along(at, edges))) return;
    edges++;
}

static void add_face(const vec3 *at, int i, int j, int k)
{
    face[faces][0] = i;
    face[faces][1] = j;
    face[faces][2] = k;
    for (int f = 0; f < faces; f++)
        if (is_parallel(face_normal(at, f), face_normal(at, faces))) return;
    faces++;
}

static void find_features(void)
{
    icosahedron body = icosahedron_turned((vec3){ 1, 0, 0 }, 0);
    static int joined[CORNERS][CORNERS];
    for (int i = 0; i < CORNERS; i++)
        for (int j = i + 1; j < CORNERS; j++) {
            if (vec3_distance(body.at[i], body.at[j]) > 0.6) continue;
            joined[i][j] = 1;
            add_edge(body.at, i, j);
        }
    for (int i = 0; i < CORNERS; i++)
        for (int j = i + 1; j < CORNERS; j++)
            for (int k = j + 1; k < CORNERS; k++)
                if (joined[i][j] && joined[j][k] && joined[i][k])
                    add_face(body.at, i, j, k);
}

static real try(const icosahedron *a, const icosahedron *b, vec3 n, real best)
{
    real length = vec3_length(n);
    if (!(length > 0)) return best;
    real w = width(a, b, vec3_scale(1 / length, n));
    return w < best ? w : best;
}

// Every face normal and every crossing of edges that is not parallel to one
// already tried: 10 + 10 + 15 * 15 = 245 directions, each both ways.
static real every_direction(const icosahedron *a, const icosahedron *b)
{
    real best = HUGE_VAL;
    for (int f = 0; f < faces; f++) {
        best = try(a, b, face_normal(a->at, f), best);
        best = try(a, b, face_normal(b->at, f), best);
    }
    for (int i = 0; i < edges; i++)
        for (int j = 0; j < edges; j++)
            best = try(a, b, vec3_cross(edge_along(a->at, i),
                                        edge_along(b->at, j)), best);
    return best;
}

static real best_of(const pair_at_gap *p, const vec3 *way, int n)
{
    real best = HUGE_VAL;
    for (int k = 0; k < n; k++) {
        real w = width(&p->a, &p->b, way[k]);
        best = w < best ? w : best;
    }
    return best;
}

// n directions spread over the sphere: half of them on a spiral, which winds
// round the upper half of the sphere, and their opposites.
static void by_directions(void)
{
    static vec3 way[2048];
    printf("# directions ns error\n");
    for (int n = 16; n <= 4096; n *= 4) {
        for (int k = 0; k < n / 2; k++) {
            real z = 1 - (2 * k + 1) / (real)n, turn = 2.399963229728653 * k;
            real r = sqrt(1 - z * z);
            way[k] = (vec3){ r * cos(turn), r * sin(turn), z };
        }
        int count = n > 1000 ? SOME / 10 : SOME;
        double error = 0, ns = HUGE_VAL;
        static real depth[SOME];
        for (int pass = 0; pass < PASSES; pass++) {
            double start = now();
            for (int i = 0; i < count; i++)
                depth[i] = best_of(&pair[i], way, n / 2);
            ns = fmin(ns, (now() - start) / count);
        }
        for (int i = 0; i < count; i++)
            error += fabs(depth[i] - truth[i]) / truth[i] / count;
        printf("%d %.0f %.3g\n", n, ns, error);
    }
    printf("\n\n");
}

// The queries of chapters 04 and 05.
static real plain_depth(const pair_at_gap *p)
{
    hull a = { p->a.at, CORNERS }, b = { p->b.at, CORNERS };
    gjk_result r = gjk_distance(a, b, HUGE_VAL, NULL);
    return r.status == GJK_OVERLAP ? hit_face_find(a, b, &r.last).depth : 0;
}

// ns a query of what = 0: distance; 1: distance and penetration; 2: penetration
// alone, from the simplex of distance; 4: penetration alone, with an empty
// simplex; 5: the plain way; for the moved pairs with the carried simplex if
// `moved`.
static double run(int what, int moved, penetration_scratch *scratch, double *error,
                  double *iterations)
{
    static stopwatch w;
    stopwatch_reset(&w);
    for (int pass = 0; pass < PASSES; pass++) {
        *error = *iterations = 0;
        for (int block = 0; block < PAIRS / BLOCK; block++) {
            static distance_cache s[BLOCK];
            static real depth[BLOCK];
            int first = block * BLOCK;
            for (int k = 0; k < BLOCK; k++) s[k] = last[first + k];
            double start = now();
            for (int k = 0; k < BLOCK; k++) {
                const pair_at_gap *p = &pair[first + k];
                point_set a = points_of(moved ? &p->moved_a : &p->a);
                point_set b = points_of(moved ? &p->moved_b : &p->b);
                if (!moved && what != 2) s[k].count = 0;
                distance_result g = { .status = DISTANCE_OVERLAP };
                penetration_result r = { .status = PENETRATION_APART };
                if (what == 5) {
                    depth[k] = plain_depth(p);
                    continue;
                }
                if (what != 2 && what != 4)
                    g = distance_find(a, b, distance_options_default(), &s[k]);
                depth[k] = -g.distance;
                if (what == 0 || g.status != DISTANCE_OVERLAP) continue;
                r = penetration_find(a, b, &s[k], scratch);
                depth[k] = r.depth;
                *iterations += r.iterations;
            }
            stopwatch_note(&w, block, now() - start);
            for (int k = 0; k < BLOCK && !moved; k++)
                *error += fabs(depth[k] - truth[first + k])
                        / truth[first + k] / PAIRS;
        }
        *iterations /= PAIRS;
    }
    return stopwatch_mean(&w);
}

// Moves B along the normal until they are so deep.
static void settle(pair_at_gap *p, real depth, penetration_scratch *scratch)
{
    for (int tries = 0; tries < 60; tries++) {
        distance_cache s = ask_pair(&p->a, &p->b).last;
        penetration_result r = penetration_find(points_of(&p->a), points_of(&p->b), &s,
                                     scratch);
        if (fabs(r.depth - depth) < 1e-9) break;
        shift(&p->b, vec3_scale(depth - r.depth, r.normal));
    }
    nudge(p);
}

static void prepare(real gap, penetration_scratch *scratch)
{
    make_pairs(pair, PAIRS, gap);
    for (int i = 0; i < PAIRS; i++) {
        settle(&pair[i], -gap, scratch);
        point_set a = points_of(&pair[i].a), b = points_of(&pair[i].b);
        last[i] = distance_find(a, b, distance_options_default(), NULL).last;
    }
}

// Against the clock and the slow way; the truth of the rest is penetration's own,
// which agrees with the slow way on the first SOME pairs.
static void by_way(penetration_scratch *scratch)
{
    double error = 0, worst = 0, n, slow_ns = HUGE_VAL;
    static real slow[SOME];
    for (int pass = 0; pass < PASSES; pass++) {
        double start = now();
        for (int i = 0; i < SOME; i++)
            slow[i] = every_direction(&pair[i].a, &pair[i].b);
        slow_ns = fmin(slow_ns, (now() - start) / SOME);
    }
    for (int i = 0; i < SOME; i++) {
        real e = fabs(truth[i] - slow[i]) / slow[i];
        error += e / SOME;
        worst = e > worst ? e : worst;
    }
    double e, alone = run(2, 0, scratch, &e, &n);
    double both = run(1, 0, scratch, &e, &n), off;
    double plain = run(5, 0, scratch, &off, &n);
    printf("# %d directions, both ways\n"
           "# penetration_ns error both_ns every_direction_ns worst_error "
           "plain_ns plain_difference\n"
           "%.0f %.3g %.0f %.0f %.3g %.0f %.3g\n\n\n", 2 * faces + edges * edges,
           alone, error, both, slow_ns, worst, plain, off);
    clock_print_row("penetration", "depth of icosahedra", "rounding",
                    "distance and penetration", "all 245 directions",
                    slow_ns / both);
}

static void by_gap(penetration_scratch *scratch)
{
    const real gap[] = { -1e-5, -0.005, -0.02, -0.1, -0.3 };
    printf("# gap gjk_ns both_ns carried_ns hit_iterations "
           "alone_ns alone_iterations\n"
           "#depths| \"depth, m\",\"distance, ns\",\"and penetration, ns\","
           "expansions,\"penetration alone, ns\",\"both, carried, ns\"\n");
    for (int g = 0; g < 5; g++) {
        double e, n, m, k;
        prepare(gap[g], scratch);
        for (int i = 0; i < PAIRS; i++) truth[i] = 1;
        double apart = run(0, 0, scratch, &e, &m);
        double both = run(1, 0, scratch, &e, &n);
        double carried = run(1, 1, scratch, &e, &m);
        double alone = run(4, 0, scratch, &e, &k);
        printf("%g %.0f %.0f %.0f %.2f %.0f %.2f\n", gap[g], apart, both,
               carried, n, alone, k);
        printf("#depths| %g,%.0f,%.0f,%.1f,%.0f,%.0f\n", -gap[g], apart, both,
               n, alone, carried);
    }
}

int main(void)
{
    penetration_scratch *scratch = penetration_scratch_new();
    if (!scratch) return 1;
    find_features();
    printf("# 10-depth: %d pairs of icosahedra of circumradius 0.5 m, 10 cm"
           " deep\n# compiler %s, flags %s\n", (int)PAIRS, __VERSION__, FLAGS);
    prepare(-0.1, scratch);
    for (int i = 0; i < PAIRS; i++)
        truth[i] = penetration_find(points_of(&pair[i].a), points_of(&pair[i].b),
                                 &last[i], scratch).depth;
    by_directions();
    by_way(scratch);
    by_gap(scratch);
    penetration_scratch_free(scratch);
    return 0;
}
