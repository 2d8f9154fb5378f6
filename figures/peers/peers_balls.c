// peers_balls.c - the distance of two balls of 642 points: climbing from
// neighbour to neighbour beside looking at every point.

#include "peers.h"
#include "bodies.h"
#include "distance.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { PAIRS = 300, BLOCK = 10, BLOCKS = PAIRS / BLOCK, ROUNDS = 9, LEVEL = 3,
       POINTS = 642 };

static body ball;
static vec3 a[PAIRS][POINTS], b[PAIRS][POINTS];
static real climbed[PAIRS], scanned[PAIRS];

// Of radius 0.5 m, turned anyhow; up to half a metre apart.
static void make_balls(void)
{
    unsigned long long seed = 6;
    body_icosphere(&ball, LEVEL, 0.5);
    if (ball.count != POINTS) give_up("a ball does not have 642 points");
    for (int i = 0; i < PAIRS; i++) {
        vec3 by = random_vector(&seed, 1, 1.5);
        body_turn(&ball, &seed);
        for (int k = 0; k < POINTS; k++) a[i][k] = ball.at[k];
        body_turn(&ball, &seed);
        for (int k = 0; k < POINTS; k++) b[i][k] = vec3_add(ball.at[k], by);
    }
}

static real distance(int i, const int *ring_start, const int *ring)
{
    point_set p = { a[i], POINTS, ring_start, ring };
    point_set q = { b[i], POINTS, ring_start, ring };
    return distance_find(p, q, distance_options_default(), NULL).distance;
}

static void climb(int block)
{
    for (int i = block * BLOCK; i < (block + 1) * BLOCK; i++)
        climbed[i] = distance(i, ball.ring_start, ball.ring);
}

static void scan(int block)
{
    for (int i = block * BLOCK; i < (block + 1) * BLOCK; i++)
        scanned[i] = distance(i, NULL, NULL);
}

void peers_balls(void)
{
    const way ways[2] = { { NULL, climb }, { NULL, scan } };
    real worst = 0;
    make_balls();
    real *time = time_in_turn(ways, 2, BLOCKS, ROUNDS);
    for (int i = 0; i < PAIRS; i++)
        worst = fmax(worst, fabs(climbed[i] - scanned[i]) / scanned[i]);
    row r = { .what = "distance of two balls of 642 points, cold",
              .against = "ours, every point looked at", .unit = "ns",
              .ours = 1e9 / PAIRS * time_sum(time, BLOCKS, 0),
              .theirs = 1e9 / PAIRS * time_sum(time, BLOCKS, 1),
              .ratio = 0.15 };
    r.is_wrong = !(worst <= 1e-12);
    snprintf(r.our_error, TEXT, "differs by %.0e at most", worst);
    table_add(r);
    free(time);
}
