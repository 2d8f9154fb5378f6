// 11-seams.c - a cube slides over tiles that lie side by side: how many seams does
// it pass if each tile is asked alone, and if the floor is asked as one?
//
// index 0: speed, m/s, then seams passed until it stands, of at most 100, mean of
//          400 throws: each tile alone; one throw by the plain form; and by the
//          law of the first
// Columns are separated by spaces.

#include "clock.h"
#include "plain_seam.h"
#include "random.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { SEAMS = 100, TILES = SEAMS + 5, THROWS = 400 };
static const real H = 1.0 / 240, SUNK = 0.001;

static unsigned long long seed = 1;
static plain_piece tile[TILES];

static real seam[TILES + 1];            // m, where they are

// Of 0.5 to 1.5 m.
static void lay_tiles(void)
{
    seam[0] = -1;
    for (int k = 0; k < TILES; k++) {
        real half = random_between(&seed, 0.25, 0.75);
        tile[k] = plain_box(vec3_make(seam[k] + half, -0.5, 0), vec3_make(half, 0.5, 2));
        seam[k + 1] = seam[k] + 2 * half;
    }
}

// Is the front corner of the cube held back by the tile that it is in?
static bool is_stopped(int b, vec3 corner, bool alone)
{
    if (!plain_holds(&tile[b], corner)) return false;
    int k = alone ? plain_way_out(tile + b, 1, 0, corner, 1e-6)
                  : plain_way_out(tile, TILES, b, corner, 1e-6);
    return tile[b].side[k].normal.x < 0;
}

static int seams_passed(real speed, bool alone)
{
    vec3 corner = { 0, -SUNK, 0.5 };
    int b = 0;
    lay_tiles();
    while (seam[b + 1] < 0) b++;
    for (int first = b; b - first < SEAMS; corner.x += speed * H) {
        while (corner.x >= seam[b + 1]) b++;
        if (is_stopped(b, corner, alone)) return b - first - 1;
    }
    return SEAMS;
}

// A tile stops the cube if a step ends less than SUNK past a seam, which is so in
// SUNK / (speed h) of all seams.
static real law(real speed)
{
    real p = real_min(SUNK / (speed * H), 1), go_on = 1, mean = 0;
    for (int k = 0; k < SEAMS; k++) mean += go_on *= 1 - p;
    return mean;
}

int main(void)
{
    clock_print_head("a cube that has sunk by 1 mm slides over tiles of 0.5 to 1.5 m, in"
                     " steps of 1/240 s", FLAGS);
    printf("# seams: speed alone plain law\n");
    for (int k = -1; k <= 6; k++) {
        real speed = pow(2, k), alone = 0;
        for (int i = 0; i < THROWS; i++)
            alone += (real)seams_passed(speed, true) / THROWS;
        real plain = seams_passed(speed, false);
        printf("%.3g %.3g %.3g %.3g\n", speed, alone, plain, law(speed));
    }
}
