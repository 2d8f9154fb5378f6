// 04-difference.c - two convex polygons, apart and overlapping, and the shape
// of their difference: the origin lies outside, then inside.
//
// Two cases, each of five blocks, each after two blank lines:
// 5c     x y: polygon A, closed
// 5c + 1 x y: polygon B, closed
// 5c + 2 x y dx dy side: the sides of A - B; side 1: a side of A, 2: of B,
//        turned round
// 5c + 3 ax ay bx by status: the nearest points of A and B
// 5c + 4 x y: the corners of the simplex that GJK ended with, closed
// Metres; columns are separated by spaces.

#include "04-polygons.h"

enum { CASES = 2 };

// Where B stands in the two cases, m.
static const vec3 PLACE[CASES] = { { -0.6, -0.2, 0 }, { 1.6, -0.2, 0 } };

static void print_answer(hull a, hull b)
{
    gjk_result r = gjk_distance(a, b, HUGE_VAL, NULL);
    printf("\n\n# %s, distance %.6f m, %d iterations\n",
           r.status == GJK_OVERLAP ? "overlap" : "apart", r.distance,
           r.iterations);
    printf("%.6f %.6f %.6f %.6f %d\n", r.on_a.x, r.on_a.y, r.on_b.x, r.on_b.y,
           (int)r.status);
    printf("\n\n# the last simplex\n");
    for (int k = 0; k <= r.last.count; k++) {
        vec3 p = r.last.of[k % r.last.count].at;
        printf("%.6f %.6f\n", p.x, p.y);
    }
}

int main(void)
{
    printf("# 04-difference: two polygons and their difference, m\n"
           "# compiler %s, flags %s", __VERSION__, FLAGS);
    for (int k = 0; k < CASES; k++) {
        vec3 at[B_CORNERS];
        for (int i = 0; i < B_CORNERS; i++)
            at[i] = vec3_add(POLYGON_B[i], PLACE[k]);
        hull a = { POLYGON_A, A_CORNERS }, b = { at, B_CORNERS };
        print_polygon(a, "A");
        print_polygon(b, "B");
        print_difference(a, b);
        print_answer(a, b);
    }
    return 0;
}
