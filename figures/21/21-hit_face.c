// 21-hit_face.c - how deep are two balls in each other, when a ball is the hull
// of its corners?  Trying directions, more and more of them, and the hit face,
// each for balls of 12 to 642 corners.
//
// index 0: corners, ns of gjk and hit face, mean error beside the hull's own
//          depth, beside that of true balls (shares of it), points of A - B
//          asked for
// index 1 to 4: 12, 42, 162 and 642 corners; directions, ns, the same errors
// index 5 to 8: the same corners; points of A - B asked for, and the share of
//          queries that are not done by then

#include "query_pairs.h"
#include "ball.h"
#include "hit_face.h"

#include <stdio.h>
#include <stdlib.h>

// (As many sizes as kinds of directions: the ways count in fours.)
enum { QUERIES = 100, SIZES = 4, DIRECTIONS = SIZES, MOST = 1024, ROUNDS = 9,
       WAYS = SIZES * (DIRECTIONS + 1), ASKED = 25 };
static const int COUNT[DIRECTIONS] = { 16, 64, 256, 1024 };
// Of balls of 0.5 m.
static const real DEPTH = 0.2;

typedef struct {
    shape plan[SIZES];
    vec3 at[SIZES][QUERIES][2][BALL_CORNERS];
    vec3 way[DIRECTIONS][MOST];
    real depth[WAYS][QUERIES];
    int  asked[SIZES][QUERIES];     // points of A - B, by the hit face
} zoo;

// n directions spread over the sphere, on a spiral.
static void spread(vec3 *way, int n)
{
    for (int k = 0; k < n; k++) {
        real z = 1 - (2 * k + 1) / (real)n, turn = 2.399963229728653 * k;
        real r = sqrt(1 - z * z);
        way[k] = (vec3){ r * cos(turn), r * sin(turn), z };
    }
}

static int zoo_make(zoo *z)
{
    for (int k = 0; k < DIRECTIONS; k++) spread(z->way[k], COUNT[k]);
    for (int k = 0; k < SIZES; k++) {
        if (!ball_shape(&z->plan[k], k, 0.5, 1).ok) return 0;
        for (int q = 0; q < QUERIES; q++) {
            vec3 one = random_direction(&seed), other = random_direction(&seed);
            vec3 away = vec3_scale(1 - DEPTH, random_direction(&seed));
            real turn = 6 * random_fraction(&seed);
            for (int i = 0; i < z->plan[k].particles; i++) {
                vec3 x = z->plan[k].at[i];
                z->at[k][q][0][i] = turned(x, one, turn);
                z->at[k][q][1][i] = vec3_add(turned(x, other, 2), away);
            }
        }
    }
    return 1;
}

static hull points(const zoo *z, int k, int q, int side)
{
    return (hull){ z->at[k][q][side], z->plan[k].particles };
}

static real by_hit_face(zoo *z, int k, int q)
{
    hull a = points(z, k, q, 0), b = points(z, k, q, 1);
    gjk_result g = gjk_distance(a, b, HUGE_VAL, NULL);
    if (g.status != GJK_OVERLAP) return -g.distance;
    hit_result h = hit_face_find(a, b, &g.last);
    z->asked[k][q] = h.iterations;
    return h.depth;
}

// The least that A - B reaches along any of n directions.
static real by_directions(const zoo *z, int k, int q, const vec3 *way, int n)
{
    hull a = points(z, k, q, 0), b = points(z, k, q, 1);
    real best = HUGE_VAL;
    for (int d = 0; d < n; d++)
        best = fmin(best, vec3_dot(way[d], hull_support(a, b, way[d]).at));
    return best;
}

// Ways 0 to SIZES - 1 are hit faces, the others directions, size by size.
static void work(int way, void *with)
{
    zoo *z = with;
    int d = way % DIRECTIONS, k = way < SIZES ? way : way / DIRECTIONS - 1;
    for (int q = 0; q < QUERIES; q++)
        z->depth[way][q] = way < SIZES ? by_hit_face(z, k, q)
                         : by_directions(z, k, q, z->way[d], COUNT[d]);
}

// The mean error of a way, beside truth[q] or, if NULL, DEPTH.
static real error_of(const zoo *z, int way, const real *truth)
{
    real sum = 0;
    for (int q = 0; q < QUERIES; q++) {
        real right = truth ? truth[q] : DEPTH;
        sum += fabs(z->depth[way][q] - right) / right / QUERIES;
    }
    return sum;
}

// The share of queries that take more than n points.
static real share_beyond(const zoo *z, int k, int n)
{
    int beyond = 0;
    for (int q = 0; q < QUERIES; q++) beyond += z->asked[k][q] > n;
    return (real)beyond / QUERIES;
}

static void print_shares(const zoo *z)
{
    for (int k = 0; k < SIZES; k++) {
        printf("\n\n# %d corners\n# points not_done\n",
               z->plan[k].particles);
        for (int n = 0; n <= ASKED; n++)
            printf("%d %.3g\n", n, share_beyond(z, k, n));
    }
}

static void print_all(zoo *z)
{
    lap l[WAYS];
    clock_race((race){ WAYS, ROUNDS, 0, work, z }, l);
    printf("# corners ns error_of_hull error_of_ball points\n");
    for (int k = 0; k < SIZES; k++) {
        real asked = 0;
        work(k, z);
        for (int q = 0; q < QUERIES; q++) asked += z->asked[k][q];
        printf("%d %.4g 0 %.4g %.1f\n", z->plan[k].particles,
               1e9 * l[k].seconds / QUERIES, error_of(z, k, NULL),
               asked / QUERIES);
    }
    for (int k = 0; k < SIZES; k++) {
        printf("\n\n# %d corners\n# directions ns error_of_hull "
               "error_of_ball\n", z->plan[k].particles);
        for (int d = 0; d < DIRECTIONS; d++) {
            int way = SIZES + k * DIRECTIONS + d;
            printf("%d %.4g %.3g %.4g\n", COUNT[d],
                   1e9 * l[way].seconds / QUERIES,
                   error_of(z, way, z->depth[k]), error_of(z, way, NULL));
        }
    }
    print_shares(z);
    int last = WAYS - 1;
    char at[32];
    snprintf(at, sizeof at, "%.0f %% of the depth",
             100 * error_of(z, last, z->depth[SIZES - 1]));
    clock_print_row("hit_face", "balls of 642 corners", at, "gjk and hit face",
                    "1024 directions", l[last].seconds / l[SIZES - 1].seconds);
}

int main(void)
{
    static zoo z;
    clock_print_head("21-hit_face: time and error of a depth", FLAGS);
    if (!zoo_make(&z)) return 1;
    print_all(&z);
    for (int k = 0; k < SIZES; k++) shape_free(&z.plan[k]);
    return 0;
}
