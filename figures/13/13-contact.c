// 13-contact.c - one contact in the plane: its normal, its gap, its arms, and
// the impulses that it may give.
//
// 0, 1   x y: the sides of A and of B
// 2      x y: their centres
// 3      x y: the point of A, the point of B
// 4      x y dx dy: the two arms
// 5      x y dx dy: the normal
// 6      x y dx dy: the impulse on A, and that on B
// 7, 8   x y dx dy: how that turns A, and B, around their centres
// Metres; columns are separated by spaces.

#include "motion.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { CORNERS = 4 };

typedef struct {
    vec3 center, x, y;          // m, half its sides
} rectangle;

static vec3 corner(const rectangle *r, int k)
{
    return vec3_add_scaled(vec3_add_scaled(r->center, k == 1 || k == 2 ? 1 : -1,
                                           r->x), k < 2 ? -1 : 1, r->y);
}

static void print_sides(const rectangle *r)
{
    printf("\n\n");
    for (int k = 0; k <= CORNERS; k++) {
        vec3 c = corner(r, k % CORNERS);
        printf("%.5f %.5f\n", c.x, c.y);
    }
}

static void print_arrow(vec3 from, vec3 way)
{
    printf("%.5f %.5f %.5f %.5f\n", from.x, from.y, way.x, way.y);
}

// An arc around a centre, from one angle to another (degrees), in pieces.
static void print_arc(vec3 center, real from, real to)
{
    enum { PIECES = 10 };
    const real degree = 3.141592653589793 / 180, radius = 0.24;
    printf("\n\n");
    for (int k = 0; k < PIECES; k++) {
        real a = degree * (from + (to - from) * k / PIECES);
        real b = degree * (from + (to - from) * (k + 1) / PIECES);
        vec3 start = { cos(a), sin(a), 0 }, end = { cos(b), sin(b), 0 };
        print_arrow(vec3_add_scaled(center, radius, start),
                    vec3_scale(k < PIECES - 1 ? radius : 2 * radius,
                               vec3_sub(end, start)));
    }
}

int main(void)
{
    const real gap = 0.16;
    const vec3 up = { 0, 1, 0 };
    rectangle b = { { 0, 0, 0 }, { 0.95, 0, 0 }, { 0, 0.4, 0 } };
    rectangle a = { { 0, 0, 0 }, { 0.677, 0.181, 0 }, { -0.103, 0.386, 0 } };
    vec3 lowest = corner(&a, 0), on_b = { -0.42, 0.4, 0 };
    vec3 on_a = vec3_add_scaled(on_b, gap, up);
    a.center = vec3_sub(on_a, lowest);
    printf("# 13-contact: one contact in the plane, m\n# compiler %s, flags %s",
           __VERSION__, FLAGS);
    print_sides(&a);
    print_sides(&b);
    printf("\n\n%.5f %.5f\n%.5f %.5f\n", a.center.x, a.center.y, b.center.x,
           b.center.y);
    printf("\n\n%.5f %.5f\n%.5f %.5f\n", on_a.x, on_a.y, on_b.x, on_b.y);
    printf("\n\n");
    print_arrow(a.center, vec3_sub(on_a, a.center));
    print_arrow(b.center, vec3_sub(on_b, b.center));
    printf("\n\n");
    print_arrow(on_b, vec3_scale(0.55, up));
    printf("\n\n");
    print_arrow(on_a, vec3_scale(0.55, up));
    print_arrow(on_b, vec3_scale(-0.55, up));
    print_arc(a.center, 160, 20);
    print_arc(b.center, 20, 160);
    return 0;
}
