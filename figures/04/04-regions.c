// 04-regions.c - the signs of the barycentric coordinates, in the plane of a
// segment and of a triangle.
//
// 0     x y: the segment
// 1     x y: the triangle, closed
// 2     x y: the same triangle's sides, prolonged, each a block of two points
// 3     x y k signs: a point of each region of the triangle, with its signs
// 4     x y vx vy: an origin and the nearest point of the triangle
// Lengths have no unit here; columns are separated by spaces.

#include "gjk.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

static const vec3 CORNER[3] = { { 0, 0, 0 }, { 3.2, 0.3, 0 }, { 0.9, 2.2, 0 } };

static const char *sign(real w)
{
    return w > 0 ? "+" : "−";
}

// The signs of the weights of a triangle that is moved so that p is the origin.
static void print_signs(vec3 p)
{
    vec3 a = vec3_sub(CORNER[0], p), b = vec3_sub(CORNER[1], p);
    vec3 c = vec3_sub(CORNER[2], p);
    real w[3];
    triangle_weigh(triangle_normal(a, b, c), a, b, c, w);
    printf("%.3f %.3f %s%s%s\n", p.x, p.y, sign(w[0]), sign(w[1]), sign(w[2]));
}

static void print_nearest(vec3 p)
{
    gjk_result r = gjk_distance((hull){ CORNER, 3 }, (hull){ &p, 1 }, HUGE_VAL,
                                NULL);
    printf("%.4f %.4f %.4f %.4f\n", p.x, p.y, r.on_a.x, r.on_a.y);
}

int main(void)
{
    printf("# 04-regions: signs of barycentric coordinates\n"
           "# compiler %s, flags %s", __VERSION__, FLAGS);
    printf("\n\n# segment\n0.4 0.75\n2.8 1.35\n");
    printf("\n\n# triangle\n");
    for (int k = 0; k < 4; k++)
        printf("%.3f %.3f\n", CORNER[k % 3].x, CORNER[k % 3].y);
    printf("\n\n# sides\n");
    for (int k = 0; k < 3; k++) {
        vec3 a = CORNER[k], e = vec3_sub(CORNER[(k + 1) % 3], a);
        vec3 from = vec3_add_scaled(a, -2, e), to = vec3_add_scaled(a, 3, e);
        printf("%.3f %.3f\n%.3f %.3f\n\n", from.x, from.y, to.x, to.y);
    }
    printf("\n# signs\n");
    print_signs((vec3){ 1.35, 0.85, 0 });
    print_signs((vec3){ 0.95, -0.5, 0 });
    print_signs((vec3){ 2.75, 1.65, 0 });
    print_signs((vec3){ -0.35, 1.45, 0 });
    print_signs((vec3){ -0.75, -0.65, 0 });
    print_signs((vec3){ 4.3, 0.02, 0 });
    print_signs((vec3){ 0.75, 3.0, 0 });
    printf("\n\n# nearest\n");
    print_nearest((vec3){ 1.7, -0.85, 0 });
    print_nearest((vec3){ -0.45, -0.12, 0 });
    print_nearest((vec3){ 3.75, -0.35, 0 });
    return 0;
}
