// 04-step.c - two iterations of GJK in the plane: the first finds a corner
// nearer the origin, the last one proves that there is none.
//
// 0      x y dx dy side: the sides of A - B
// 1, 2   x y: the simplex before the first and the last question
// 3      v and w of the first question, then of the last one
// Metres; columns are separated by spaces.

#include "04-polygons.h"

// Where B stands, m.
static const vec3 PLACE = { -0.6, -0.2, 0 };

static void print_simplex(const corner *c, int n)
{
    printf("\n\n# simplex\n");
    for (int k = 0; k < n; k++) printf("%.6f %.6f\n", c[k].at.x, c[k].at.y);
}

int main(void)
{
    vec3 at[B_CORNERS];
    for (int i = 0; i < B_CORNERS; i++) at[i] = vec3_add(POLYGON_B[i], PLACE);
    hull a = { POLYGON_A, A_CORNERS }, b = { at, B_CORNERS };
    corner first = hull_support(a, b, (vec3){ 0.3, -1, 0 });
    corner w = hull_support(a, b, vec3_scale(-1, first.at));
    gjk_result r = gjk_distance(a, b, HUGE_VAL, NULL);
    corner last = hull_support(a, b, vec3_scale(-1, r.axis));
    printf("# 04-step: two iterations of GJK, m\n# compiler %s, flags %s",
           __VERSION__, FLAGS);
    print_difference(a, b);
    print_simplex(&first, 1);
    print_simplex(r.last.of, r.last.count);
    printf("\n\n# vx vy wx wy\n%.6f %.6f %.6f %.6f\n%.6f %.6f %.6f %.6f\n",
           first.at.x, first.at.y, w.at.x, w.at.y, r.axis.x, r.axis.y,
           last.at.x, last.at.y);
    return 0;
}
