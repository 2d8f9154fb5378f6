// 16-distance.c - how exact, and how soon: gjk asked for less and less error, with
// nothing to begin from and with what the last frame left; and the corners of a
// body, looked at one after the other or by climbing from one to the next.
//
// index 0: error asked for, cold: ns, mean error; carried: ns, mean error
// index 1: corners, a query by scanning and by climbing: ns, largest relative
//          difference of the distance

#include "query_pairs.h"
#include "ball.h"
#include "ring.h"

#include <stdio.h>
#include <stdlib.h>

enum { BOUNDS = 14, ROUNDS = 13, SIZES = 5, QUERIES = 64 };
static const real BOUND[BOUNDS] = { 0.9, 0.5, 0.25, 0.1, 0.03, 1e-2, 1e-3, 1e-4,
    1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 0 };

static pair_at_gap pair[PAIRS];
static distance_cache carried[PAIRS];
static real truth[2][PAIRS], answer[PAIRS];

static distance_result ask(int i, int moved, distance_options o, distance_cache *last)
{
    const pair_at_gap *p = &pair[i];
    return moved ? distance_find(points_of(&p->moved_a), points_of(&p->moved_b),
                                o, last)
                 : distance_find(points_of(&p->a), points_of(&p->b), o, last);
}

// ---- tolerance -------------------------------------------------------------

// All pairs, the first half of the ways cold, the other carried.
static void work_bound(int way, void *with)
{
    distance_options o = distance_options_default();
    int moved = way >= BOUNDS;
    (void)with;
    o.relative_error = BOUND[way % BOUNDS];
    for (int i = 0; i < PAIRS; i++) {
        distance_cache s = carried[i];
        answer[i] = ask(i, moved, o, moved ? &s : NULL).distance;
    }
}

static real mean_error(int way)
{
    real sum = 0;
    work_bound(way, NULL);
    for (int i = 0; i < PAIRS; i++) {
        real right = truth[way >= BOUNDS][i];
        sum += fabs(answer[i] - right) / right / PAIRS;
    }
    return sum;
}

static void print_bounds(void)
{
    lap l[2 * BOUNDS];
    real error[2 * BOUNDS], seconds[2 * BOUNDS];
    make_pairs(pair, PAIRS, 0.05);
    for (int i = 0; i < PAIRS; i++) {
        carried[i].count = 0;
        truth[0][i] = ask(i, 0, distance_options_default(), &carried[i]).distance;
        truth[1][i] = ask(i, 1, distance_options_default(), NULL).distance;
    }
    for (int way = 0; way < 2 * BOUNDS; way++) error[way] = mean_error(way);
    clock_race((race){ 2 * BOUNDS, ROUNDS, 0, work_bound, NULL }, l);
    for (int way = 0; way < 2 * BOUNDS; way++) seconds[way] = l[way].seconds;
    printf("# bound cold_ns cold_error carried_ns carried_error\n");
    for (int k = 0; k < BOUNDS; k++)
        printf("%g %.1f %.3g %.1f %.3g\n", BOUND[k],
               1e9 * seconds[k] / PAIRS, error[k],
               1e9 * seconds[BOUNDS + k] / PAIRS, error[BOUNDS + k]);
    clock_print_row("gjk", "icosahedra 5 cm apart", "1e-2", "carried", "cold",
                    clock_at_error(seconds, error, BOUNDS, 1e-2)
                    / clock_at_error(seconds + BOUNDS, error + BOUNDS, BOUNDS,
                                     1e-2));
    clock_print_row("gjk", "icosahedra 5 cm apart", "rounding", "carried",
                    "cold", seconds[BOUNDS - 1] / seconds[2 * BOUNDS - 1]);
    clock_print_row("gjk", "icosahedra 5 cm apart", "1e-2 and rounding",
                    "asked for 1e-2", "asked for all", seconds[BOUNDS - 1]
                    / clock_at_error(seconds, error, BOUNDS, 1e-2));
}

// ---- corners ---------------------------------------------------------------

typedef struct {
    shape plan[SIZES];
    rings ring[SIZES];
    vec3 at[SIZES][QUERIES][2][BALL_CORNERS];
    real distance[2 * SIZES][QUERIES];
} zoo;

static int zoo_make(zoo *z)
{
    if (!shape_box(&z->plan[0], vec3_make(1, 1, 1), 1).ok) return 0;
    for (int k = 1; k < SIZES; k++)
        if (!ball_shape(&z->plan[k], k - 1, 1, 1).ok) return 0;
    for (int k = 0; k < SIZES; k++)
        if (!rings_build(&z->ring[k], &z->plan[k].mesh).ok) return 0;
    for (int k = 0; k < SIZES; k++)
        for (int q = 0; q < QUERIES; q++) {
            vec3 one = random_direction(), other = random_direction();
            real apart = 2 * z->plan[k].radius + 0.05;
            vec3 way = vec3_scale(apart, random_direction());
            for (int i = 0; i < z->plan[k].particles; i++) {
                vec3 x = z->plan[k].at[i];
                z->at[k][q][0][i] = turned(x, one, 2);
                z->at[k][q][1][i] = vec3_add(turned(x, other, 1), way);
            }
        }
    return 1;
}

static point_set points(const zoo *z, int k, int q, int side, int climb)
{
    const shape *s = &z->plan[k];
    point_set p = { z->at[k][q][side], s->particles, NULL, NULL };
    if (climb) {
        p.ring_start = z->ring[k].start;
        p.ring = z->ring[k].list;
    }
    return p;
}

// Even ways scan, odd ones have a ring to climb along.
static void work_corners(int way, void *with)
{
    zoo *z = with;
    int k = way / 2, climb = way % 2;
    for (int q = 0; q < QUERIES; q++)
        z->distance[way][q] =
            distance_find(points(z, k, q, 0, climb), points(z, k, q, 1, climb),
                         distance_options_default(), NULL).distance;
}

static void print_corners(zoo *z)
{
    lap l[2 * SIZES];
    clock_race((race){ 2 * SIZES, ROUNDS, 2e-3, work_corners, z }, l);
    printf("\n\n# corners scan_ns climb_ns difference\n");
    for (int k = 0; k < SIZES; k++) {
        real most = 0;
        for (int q = 0; q < QUERIES; q++) {
            real d = z->distance[2 * k][q];
            most = fmax(most, fabs(d - z->distance[2 * k + 1][q]) / d);
        }
        printf("%d %.1f %.1f %.3g\n", z->plan[k].particles,
               1e9 * l[2 * k].seconds / QUERIES,
               1e9 * l[2 * k + 1].seconds / QUERIES, most);
    }
    clock_print_row("gjk", "balls of 642 corners", "rounding", "climbing",
                    "scanning", l[2 * SIZES - 2].seconds
                                / l[2 * SIZES - 1].seconds);
}

int main(void)
{
    static zoo z;
    if (!zoo_make(&z)) return 1;
    clock_print_head("18-gjk: time and error of a distance", FLAGS);
    print_bounds();
    print_corners(&z);
    for (int k = 0; k < SIZES; k++) {
        rings_free(&z.ring[k]);
        shape_free(&z.plan[k]);
    }
    return 0;
}
