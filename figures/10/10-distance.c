// 10-distance.c - how the error of GJK falls with time, cold and carried.
//
// index 0: cap, then ns and mean relative error cold, ns and error carried
// index 1: gap, ns and iterations cold, carried, carried with a margin of 2 cm
// index 2: points, ns of one support by scan and by climb, and of a whole query
//          without and with a ring
// index 3: questions a cold search of two icosahedra asks, from any corner, from
//          the corner from middle to middle, and as distance_find begins
// index 4: ns of the plain GJK of chapter 04, and its mean relative difference
//          from the distance above: cold, then carried
// Columns are separated by spaces.

#include "gjk.h"
#include "query_pairs.h"

#include <stdio.h>
#include <stdlib.h>

enum { CAPS = 8, PASSES = 20 };

static pair_at_gap pair[PAIRS];
static distance_cache carried[PAIRS];
static real truth[PAIRS], moved_truth[PAIRS];

static distance_result ask(int i, int moved, distance_options o, distance_cache *s)
{
    return distance_find(points_of(moved ? &pair[i].moved_a : &pair[i].a),
                        points_of(moved ? &pair[i].moved_b : &pair[i].b), o, s);
}

// One pass over all pairs; the mean relative error and number of iterations.
static void pass_over(int moved, distance_options o, stopwatch *w,
                      double *error, double *iterations)
{
    *error = *iterations = 0;
    for (int block = 0; block < PAIRS / BLOCK; block++) {
        static distance_cache s[BLOCK];
        static real distance[BLOCK];
        int first = block * BLOCK;
        for (int k = 0; k < BLOCK; k++) s[k] = carried[first + k];
        double start = now();
        for (int k = 0; k < BLOCK; k++) {
            distance_result r = ask(first + k, moved, o, moved ? &s[k] : NULL);
            distance[k] = r.distance;
            *iterations += r.iterations;
        }
        stopwatch_note(w, block, now() - start);
        for (int k = 0; k < BLOCK; k++) {
            real d = moved ? moved_truth[first + k] : truth[first + k];
            if (d > 0) *error += fabs(distance[k] - d) / d;
        }
    }
    *error /= PAIRS;
    *iterations /= PAIRS;
}

// ns, and the mean relative error and number of iterations.
static double run(int moved, distance_options o, double *error,
                  double *iterations)
{
    static stopwatch w;
    stopwatch_reset(&w);
    for (int pass = 0; pass < PASSES; pass++)
        pass_over(moved, o, &w, error, iterations);
    return stopwatch_mean(&w);
}

static void prepare(real gap)
{
    make_pairs(pair, PAIRS, gap);
    distance_options o = distance_options_default();
    for (int i = 0; i < PAIRS; i++) {
        carried[i].count = 0;
        truth[i] = ask(i, 0, o, &carried[i]).distance;
        moved_truth[i] = ask(i, 1, o, NULL).distance;
    }
}

// The caps take turns: a minute in which the machine is busy spoils all of them
// alike.
static void by_cap(void)
{
    static stopwatch w[CAPS][2];
    double error[CAPS][2], n;
    for (int c = 0; c < CAPS; c++)
        for (int moved = 0; moved < 2; moved++) stopwatch_reset(&w[c][moved]);
    for (int pass = 0; pass < PASSES; pass++)
        for (int c = 0; c < CAPS; c++)
            for (int moved = 0; moved < 2; moved++) {
                distance_options o = distance_options_default();
                o.cap = c + 1;
                pass_over(moved, o, &w[c][moved], &error[c][moved], &n);
            }
    printf("# cap cold_ns cold_error carried_ns carried_error\n");
    for (int c = 0; c < CAPS; c++)
        printf("%d %.0f %.3g %.0f %.3g\n", c + 1, stopwatch_mean(&w[c][0]),
               error[c][0], stopwatch_mean(&w[c][1]), error[c][1]);
    printf("\n\n");
}

static void by_gap(void)
{
    const real gap[] = { 0.3, 0.05, 0.005, 1e-5, -0.005, -0.1 };
    printf("# gap cold_ns iterations carried_ns iterations margin_ns\n"
           "#gaps| \"gap, m\",\"cold, ns\",support points,\"carried, ns\","
           "support points\n");
    for (int g = 0; g < 6; g++) {
        distance_options o = distance_options_default(), near = o;
        double e, m, n;
        near.margin = 0.02;
        prepare(gap[g]);
        double cold = run(0, o, &e, &m), warm = run(1, o, &e, &n), j;
        printf("%g %.0f %.2f %.0f %.2f %.0f\n", gap[g], cold, m, warm, n,
               run(1, near, &e, &j));
        printf("#gaps| %g,%.0f,%.1f,%.0f,%.2f\n", gap[g], cold, m, warm, n);
    }
    printf("\n\n");
}

// ns of one whole cold query between two balls, turned and 5 cm apart.
static double query_ns(const ball_mesh *b, int climbing)
{
    enum { QUERIES = 200 };
    static vec3 at[QUERIES][2][700];
    double best = HUGE_VAL, sum = 0;
    random_state = 77;
    for (int i = 0; i < QUERIES; i++) {
        vec3 one = random_direction(), other = random_direction();
        vec3 way = vec3_scale(2.05, random_direction());
        for (int k = 0; k < b->count; k++) {
            at[i][0][k] = turned(b->at[k], one, 2);
            at[i][1][k] = vec3_add(turned(b->at[k], other, 1), way);
        }
    }
    for (int pass = 0; pass < 6; pass++) {
        double start = now();
        for (int i = 0; i < QUERIES; i++) {
            point_set p = { at[i][0], b->count, NULL, NULL }, q = p;
            q.at = at[i][1];
            if (climbing) {
                p.ring_start = q.ring_start = b->start;
                p.ring = q.ring = b->ring;
            }
            sum += distance_find(p, q, distance_options_default(), NULL).distance;
        }
        best = fmin(best, (now() - start) / QUERIES);
    }
    return sum > 0 ? best : 0;
}

// A direction that turns by about 20 degrees from one call to the next, as
// GJK's does.
static void support_by_points(void)
{
    enum { CALLS = 4000 };
    static ball_mesh b;
    static vec3 way[CALLS];
    way[0] = random_direction();
    for (int i = 1; i < CALLS; i++)
        way[i] = vec3_unit(vec3_add_scaled(way[i - 1], 0.36,
                                           random_direction()));
    printf("# points scan_ns climb_ns query_ns query_with_ring_ns\n"
           "#points| points,\"one scan, ns\",\"one climb, ns\","
           "\"a query without a ring, ns\",\"with a ring, ns\"\n");
    for (int level = 0; level <= 3; level++) {
        double scan = HUGE_VAL, climb = HUGE_VAL;
        ball_make(&b, level);
        point_set p = { b.at, b.count, b.start, b.ring };
        for (int pass = 0; pass < 8; pass++) {
            int at = 0, sum = 0;
            double start = now();
            for (int i = 0; i < CALLS; i++) sum += support_scan(p, way[i]);
            double middle = now();
            for (int i = 0; i < CALLS; i++)
                sum -= at = support_climb(p, way[i], at);
            double end = now();
            if (sum != 0) exit(1);
            scan = fmin(scan, (middle - start) / CALLS);
            climb = fmin(climb, (end - middle) / CALLS);
        }
        double scanned = query_ns(&b, 0), climbed = query_ns(&b, 1);
        printf("%d %.0f %.0f %.0f %.0f\n", b.count, scan, climb, scanned,
               climbed);
        printf("#points| %d,%.0f,%.0f,%.0f,%.0f\n", b.count, scan, climb,
               scanned, climbed);
    }
}

static vec3 middle(point_set p)
{
    vec3 sum = { 0, 0, 0 };
    for (int i = 0; i < p.count; i++) sum = vec3_add(sum, p.at[i]);
    return vec3_scale(1 / (real)p.count, sum);
}

// The corner from middle to middle costs a question, any other does not.
static void questions_by_start(void)
{
    distance_options o = distance_options_default();
    long any = 0, between = 0, three = 0;
    for (int i = 0; i < PAIRS; i++) {
        point_set a = points_of(&pair[i].a), b = points_of(&pair[i].b);
        vec3 d = vec3_sub(middle(b), middle(a));
        distance_cache first = { .count = 1, .weight = { 1 } }, facing = first;
        facing.a[0] = support_scan(a, d);
        facing.b[0] = support_scan(b, vec3_scale(-1, d));
        any += distance_find(a, b, o, &first).iterations;
        between += 1 + distance_find(a, b, o, &facing).iterations;
        three += distance_find(a, b, o, NULL).iterations;
    }
    printf("\n\n# questions from_any_corner from_middle_to_middle as_we_begin\n"
           "%.2f %.2f %.2f\n", (double)any / PAIRS, (double)between / PAIRS,
           (double)three / PAIRS);
}

static simplex plain_last[PAIRS];

static double time_plain(int moved, double *error)
{
    static stopwatch w;
    stopwatch_reset(&w);
    *error = 0;
    for (int pass = 0; pass < PASSES; pass++)
        for (int block = 0; block < PAIRS / BLOCK; block++) {
            static simplex s[BLOCK];
            static real distance[BLOCK];
            int first = block * BLOCK;
            for (int k = 0; k < BLOCK; k++) {
                s[k] = plain_last[first + k];
                if (!moved) s[k].count = 0;
            }
            double start = now();
            for (int k = 0; k < BLOCK; k++) {
                const pair_at_gap *p = &pair[first + k];
                hull a = { moved ? p->moved_a.at : p->a.at, CORNERS };
                hull b = { moved ? p->moved_b.at : p->b.at, CORNERS };
                distance[k] = gjk_distance(a, b, HUGE_VAL, &s[k]).distance;
            }
            stopwatch_note(&w, block, now() - start);
            for (int k = 0; k < BLOCK; k++) {
                real d = moved ? moved_truth[first + k] : truth[first + k];
                *error += fabs(distance[k] - d) / d / PASSES / PAIRS;
            }
        }
    return stopwatch_mean(&w);
}

static void plain_way(void)
{
    for (int i = 0; i < PAIRS; i++) {
        hull a = { pair[i].a.at, CORNERS }, b = { pair[i].b.at, CORNERS };
        plain_last[i].count = 0;
        gjk_distance(a, b, HUGE_VAL, &plain_last[i]);
    }
    double difference;
    printf("\n\n# plain_ns difference\n");
    for (int moved = 0; moved < 2; moved++) {
        double ns = time_plain(moved, &difference);
        printf("%.0f %.3g\n", ns, difference);
    }
}

int main(void)
{
    printf("# 10-distance: GJK on %d pairs of icosahedra of circumradius 0.5 m,"
           " 5 cm apart\n# compiler %s, flags %s\n", (int)PAIRS, __VERSION__,
           FLAGS);
    prepare(0.05);
    by_cap();
    by_gap();
    support_by_points();
    prepare(0.05);
    questions_by_start();
    plain_way();
    return 0;
}
