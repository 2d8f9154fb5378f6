// 10-slow.c - what the slow oracles cost beside the queries of chapters 04 and
// 05, asked about the same pairs: two hulls of n points each on a ball of 0.5 m
// radius, once apart and once overlapping.
//
// Columns: points of a body; ns of one answer, slow and quick, of the distance
// and of the depth; the largest relative difference of the slow answers from
// the quick ones.

#include "bodies.h"
#include "clock.h"
#include "hit_face.h"
#include "oracle.h"
#include "random.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

// The quick ones are asked about many pairs, so that no branch is learnt by
// heart; the slow ones about as many as an eighth of a second allows.
enum { PAIRS = 5000, BLOCK = 500, PASSES = 10, SIZES = 6, MOST = 24 };

static vec3 a[PAIRS][MOST], b[PAIRS][MOST];
static int points;              // of each body
static real quick[PAIRS];       // the quick answers

// Ways to an answer.
enum { SLOW_DISTANCE, SLOW_DEPTH, QUICK };

// About pair i; the depth, if the bodies overlap.
static real answer(int way, int i)
{
    hull p = { a[i], points }, q = { b[i], points };
    if (way == SLOW_DISTANCE) return (real)oracle_distance(p, q);
    if (way == SLOW_DEPTH) return (real)oracle_depth(p, q);
    gjk_result r = gjk_distance(p, q, HUGE_VAL, NULL);
    if (r.status != GJK_OVERLAP) return r.distance;
    return hit_face_find(p, q, &r.last).depth;
}

static void make_pairs(int overlap, unsigned long long *seed)
{
    for (int i = 0; i < PAIRS; ) {
        vec3 by = random_vector(seed, overlap ? 0.1 : 0.9, overlap ? 0.5 : 1.2);
        for (int k = 0; k < points; k++) {
            a[i][k] = random_vector(seed, 0.5, 0.5);
            b[i][k] = vec3_add(by, random_vector(seed, 0.5, 0.5));
        }
        hull p = { a[i], points }, q = { b[i], points };
        gjk_result r = gjk_distance(p, q, HUGE_VAL, NULL);
        // Another pair if this one is not of the kind that was asked for.
        i += r.status == (overlap ? GJK_OVERLAP : GJK_APART);
    }
}

static double now(void)                 // ns
{
    return 1e9 * clock_seconds();
}

// ns a pair, every block of pairs at its quickest pass.
static double time_quick(int way)
{
    double sum = 0;
    for (int first = 0; first < PAIRS; first += BLOCK) {
        double best = HUGE_VAL;
        for (int pass = 0; pass < PASSES; pass++) {
            double start = now();
            for (int i = first; i < first + BLOCK; i++)
                quick[i] = answer(way, i);
            best = fmin(best, now() - start);
        }
        sum += best;
    }
    return sum / PAIRS;
}

// ns a pair: the best of groups of four, for an eighth of a second; `worst`
// grows to the largest difference from the quick answer.
static double time_slow(int way, double *worst)
{
    double best = HUGE_VAL, begun = now();
    for (int i = 0; i + 4 <= PAIRS && now() - begun < 1.25e8; i += 4) {
        real slow[4];
        double start = now();
        for (int k = 0; k < 4; k++) slow[k] = answer(way, i + k);
        best = fmin(best, (now() - start) / 4);
        for (int k = 0; k < 4; k++)
            *worst = fmax(*worst, fabs(slow[k] - quick[i + k]) / slow[k]);
    }
    return best;
}

int main(void)
{
    static const int sizes[SIZES] = { 4, 6, 8, 12, 16, MOST };
    unsigned long long seed = 12;
    printf("# 10-slow: %d pairs of hulls of n points on a ball of radius 0.5 m;"
           " ns of one answer\n# compiler %s, flags %s\n"
           "points,slow distance,slow depth,quick distance,quick depth,"
           "largest difference\n", (int)PAIRS,
           __VERSION__, FLAGS);
    for (int s = 0; s < SIZES; s++) {
        double worst = 0, slow[2], fast[2];
        points = sizes[s];
        for (int overlap = 0; overlap < 2; overlap++) {
            make_pairs(overlap, &seed);
            fast[overlap] = time_quick(QUICK);
            slow[overlap] = time_slow(SLOW_DISTANCE + overlap, &worst);
        }
        printf("%d,%.0f,%.0f,%.0f,%.0f,%.1e\n", points, slow[0], slow[1],
               fast[0], fast[1], worst);
    }
    return 0;
}
