// 04-corners.c - why corners are not enough: two boxes that nearly touch, whose
// nearest corners are far apart; and two that overlap with no corner inside.
//
// Two cases, each of three blocks, each after two blank lines:
// 3c     x y: box A, closed
// 3c + 1 x y: box B, closed
// 3c + 2 ax ay bx by ax ay bx by: nearest corners, then nearest points
// Metres; columns are separated by spaces.

#include "gjk.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { CORNERS = 4 };

static const vec3 LEFT_A[CORNERS] = {
    { 0.3, 0.2, 0 }, { 3.9, 0.2, 0 }, { 3.9, 1.2, 0 }, { 0.3, 1.2, 0 }
};
static const vec3 LEFT_B[CORNERS] = {
    { 2.0, 1.35, 0 }, { 3.2, 2.35, 0 }, { 2.2, 3.55, 0 }, { 1.0, 2.55, 0 }
};
static const vec3 RIGHT_A[CORNERS] = {
    { 0.2, 1.3, 0 }, { 4.0, 1.3, 0 }, { 4.0, 2.3, 0 }, { 0.2, 2.3, 0 }
};
static const vec3 RIGHT_B[CORNERS] = {
    { 1.5, 0.1, 0 }, { 2.6, 0.1, 0 }, { 2.6, 3.6, 0 }, { 1.5, 3.6, 0 }
};

static void print_box(const vec3 *at, const char *name)
{
    printf("\n\n# %s\n", name);
    for (int k = 0; k <= CORNERS; k++)
        printf("%.6f %.6f\n", at[k % CORNERS].x, at[k % CORNERS].y);
}

static void print_nearest(const vec3 *a, const vec3 *b)
{
    int i = 0, j = 0;
    for (int k = 0; k < CORNERS * CORNERS; k++)
        if (vec3_distance(a[k / CORNERS], b[k % CORNERS])
            < vec3_distance(a[i], b[j])) i = k / CORNERS, j = k % CORNERS;
    gjk_result r = gjk_distance((hull){ a, CORNERS }, (hull){ b, CORNERS },
                                HUGE_VAL, NULL);
    printf("\n\n# nearest corners, nearest points: %.3f m, %.3f m\n"
           "%.6f %.6f %.6f %.6f %.6f %.6f %.6f %.6f\n",
           vec3_distance(a[i], b[j]), r.distance, a[i].x, a[i].y, b[j].x,
           b[j].y, r.on_a.x, r.on_a.y, r.on_b.x, r.on_b.y);
}

int main(void)
{
    printf("# 04-corners: two pairs of boxes, m\n# compiler %s, flags %s",
           __VERSION__, FLAGS);
    print_box(LEFT_A, "A");
    print_box(LEFT_B, "B");
    print_nearest(LEFT_A, LEFT_B);
    print_box(RIGHT_A, "A");
    print_box(RIGHT_B, "B");
    print_nearest(RIGHT_A, RIGHT_B);
    return 0;
}
