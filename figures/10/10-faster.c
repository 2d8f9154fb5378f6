// 10-faster.c - the plain queries of chapters 04 and 05 beside those of chapter
// 10, on the same pairs: nanoseconds of a query, cold and carried, and by how
// much the answers differ.
//
// index 0: row, ns plain and fast, for gnuplot; #queries| is the book's table
// Columns are separated by spaces.

#include "hit_face.h"
#include "penetration.h"
#include "query_pairs.h"

#include <stdio.h>

enum { PASSES = 8, LARGE = 642, BALLS = 200 };

static pair_at_gap pair[PAIRS];
static simplex plain_last[PAIRS];
static distance_cache fast_last[PAIRS];
static real answer[2][PAIRS];               // plain, fast; < 0: a depth
static penetration_scratch *scratch;

// The same bodies for both: points, and for the fast query a ring or none.
typedef struct {
    point_set a, b;
} two_sets;

static two_sets sets_of(int i, int moved)
{
    const pair_at_gap *p = &pair[i];
    return (two_sets){ points_of(moved ? &p->moved_a : &p->a),
                       points_of(moved ? &p->moved_b : &p->b) };
}

static hull hull_of(point_set p)
{
    return (hull){ p.at, p.count };
}

static real ask_plain(two_sets s, simplex *carried)
{
    hull a = hull_of(s.a), b = hull_of(s.b);
    gjk_result r = gjk_distance(a, b, HUGE_VAL, carried);
    if (r.status != GJK_OVERLAP) return r.distance;
    return -hit_face_find(a, b, &r.last).depth;
}

static real ask_fast(two_sets s, distance_cache *carried)
{
    distance_result r = distance_find(s.a, s.b, distance_options_default(),
                                      carried);
    if (r.status != DISTANCE_OVERLAP) return r.distance;
    return -penetration_find(s.a, s.b, &r.last, scratch).depth;
}

// ns a query of the block that begins at `first`; carried simplices are copied
// before the clock starts, so that every pass begins with the same.
static double time_block(int fast, int carried, int first)
{
    static simplex plain[BLOCK];
    static distance_cache quick[BLOCK];
    for (int k = 0; k < BLOCK; k++) {
        plain[k] = plain_last[first + k];
        quick[k] = fast_last[first + k];
        if (!carried) plain[k].count = quick[k].count = 0;
    }
    double start = now();
    for (int k = 0; k < BLOCK; k++) {
        two_sets s = sets_of(first + k, carried);
        answer[fast][first + k] = fast ? ask_fast(s, &quick[k])
                                       : ask_plain(s, &plain[k]);
    }
    return now() - start;
}

// The two take turns, block by block; ns[0] is the plain one's.  Returns the
// largest difference of their answers, m.
static double compete(int carried, double ns[2])
{
    static stopwatch w[2];
    for (int k = 0; k < 2; k++) stopwatch_reset(&w[k]);
    for (int pass = 0; pass < PASSES; pass++)
        for (int block = 0; block < PAIRS / BLOCK; block++)
            for (int k = 0; k < 2; k++) {
                int fast = k ^ (pass & 1);
                stopwatch_note(&w[fast], block,
                               time_block(fast, carried, block * BLOCK));
            }
    double worst = 0;
    for (int i = 0; i < PAIRS; i++)
        worst = fmax(worst, fabs(answer[0][i] - answer[1][i]));
    for (int k = 0; k < 2; k++) ns[k] = stopwatch_mean(&w[k]);
    return worst;
}

static void print_row(int row, const char *what, const double ns[2],
                      double worst)
{
    printf("%d %.0f %.0f\n", row, ns[0], ns[1]);
    printf("#queries| \"%s\",%.0f,%.0f,%.2f,%.1g\n", what, ns[0], ns[1],
           ns[0] / ns[1], worst);
}

static void icosahedra(real gap, int row, const char *cold, const char *warm)
{
    double ns[2], worst;
    make_pairs(pair, PAIRS, gap);
    for (int i = 0; i < PAIRS; i++) {
        plain_last[i].count = fast_last[i].count = 0;
        ask_plain(sets_of(i, 0), &plain_last[i]);
        ask_fast(sets_of(i, 0), &fast_last[i]);
    }
    worst = compete(0, ns);
    print_row(row, cold, ns, worst);
    worst = compete(1, ns);
    print_row(row + 1, warm, ns, worst);
}

// Two balls of 642 points, turned at random, 5 cm apart or so; the fast query
// knows who neighbours whom.
static void balls(int row)
{
    static ball_mesh ball;
    static vec3 at[BALLS][2][LARGE];
    double ns[2] = { HUGE_VAL, HUGE_VAL }, worst = 0;
    ball_make(&ball, 3);
    for (int i = 0; i < BALLS; i++) {
        vec3 one = random_direction(), other = random_direction();
        vec3 way = vec3_scale(2.05, random_direction());
        for (int k = 0; k < LARGE; k++) {
            at[i][0][k] = turned(ball.at[k], one, 2);
            at[i][1][k] = vec3_add(turned(ball.at[k], other, 1), way);
        }
    }
    for (int pass = 0; pass < PASSES; pass++)
        for (int fast = 0; fast < 2; fast++) {
            double start = now();
            for (int i = 0; i < BALLS; i++) {
                point_set p = { at[i][0], LARGE, ball.start, ball.ring }, q = p;
                q.at = at[i][1];
                answer[fast][i] = fast ? ask_fast((two_sets){ p, q }, NULL)
                                       : ask_plain((two_sets){ p, q }, NULL);
            }
            ns[fast] = fmin(ns[fast], (now() - start) / BALLS);
        }
    for (int i = 0; i < BALLS; i++)
        worst = fmax(worst, fabs(answer[0][i] - answer[1][i]));
    print_row(row, "distance of two balls of 642 corners, cold", ns, worst);
}

int main(void)
{
    scratch = penetration_scratch_new();
    if (!scratch) return 1;
    printf("# 10-faster: %d pairs of icosahedra of circumradius 0.5 m; %d of "
           "balls\n# compiler %s, flags %s\n# row plain_ns fast_ns\n"
           "#queries| query,\"plain, ns\",\"fast, ns\",times as long,"
           "\"largest difference, m\"\n", (int)PAIRS, (int)BALLS, __VERSION__,
           FLAGS);
    icosahedra(0.05, 1, "distance of two icosahedra, cold",
               "the same, moved a little, simplex carried");
    icosahedra(-0.1, 3, "depth of two icosahedra, 10 cm, cold",
               "the same, moved a little, simplex carried");
    balls(5);
    penetration_scratch_free(scratch);
    return 0;
}
