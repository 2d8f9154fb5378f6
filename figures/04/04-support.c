// 04-support.c - the support of A along d, of B along -d, and of A - B along d.
//
// 0 x y: polygon A, closed
// 1 x y: polygon B, closed
// 2 x y dx dy side: the sides of A - B
// 3 x y: the three supports, of A, B and A - B
// 4 x y: d
// 5 lengths: how far A, B and A - B reach along d, -d and d
// Metres; columns are separated by spaces.

#include "04-polygons.h"

int main(void)
{
    const vec3 d = { 0.8, 0.6, 0 };
    hull a = { POLYGON_A, A_CORNERS }, b = { POLYGON_B, B_CORNERS };
    corner c = hull_support(a, b, d);
    printf("# 04-support: supports of two polygons and of their difference\n"
           "# compiler %s, flags %s", __VERSION__, FLAGS);
    print_polygon(a, "A");
    print_polygon(b, "B");
    print_difference(a, b);
    printf("\n\n# the supports\n%.6f %.6f\n%.6f %.6f\n%.6f %.6f\n",
           a.at[c.a].x, a.at[c.a].y, b.at[c.b].x, b.at[c.b].y, c.at.x, c.at.y);
    printf("\n\n# d\n%.6f %.6f\n", d.x, d.y);
    printf("\n\n# heights along d: of A's support, of B's, of A - B's\n"
           "%.6f %.6f %.6f\n", vec3_dot(d, a.at[c.a]), vec3_dot(d, b.at[c.b]),
           vec3_dot(d, c.at));
    return 0;
}
