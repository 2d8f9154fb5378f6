// 17-joint.c - two bodies that share a point, in the plane; and what a hinge
// and a tree are.
//
// 0, 1   x y: the sides of A and of B, a gap between their points
// 2      x y: their centres; 3: the two points
// 4      x y dx dy: the arms
// 5      x y dx dy: the impulse on A, and that on B
// 6      x y: the sides of bodies of a tree, one after the other
// 7      x y: its joints; 8: x y dx dy: from the tips to the root
// Metres; columns are separated by spaces.

#include "vec3.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

typedef struct {
    vec3 center;
    real angle;             // rad
    real half[2];           // m, its sides
} rectangle;

static vec3 at(const rectangle *r, real x, real y)
{
    real c = cos(r->angle), s = sin(r->angle);
    x *= r->half[0];
    y *= r->half[1];
    return vec3_add(r->center, vec3_make(c * x - s * y, s * x + c * y, 0));
}

static void print_sides(const rectangle *r)
{
    const int x[] = { -1, 1, 1, -1, -1 }, y[] = { -1, -1, 1, 1, -1 };
    for (int k = 0; k < 5; k++) {
        vec3 p = at(r, x[k], y[k]);
        printf("%.5f %.5f\n", p.x, p.y);
    }
}

static void print_arrow(vec3 from, vec3 to)
{
    printf("%.5f %.5f %.5f %.5f\n", from.x, from.y, to.x - from.x,
           to.y - from.y);
}

static void print_point(vec3 p)
{
    printf("%.5f %.5f\n", p.x, p.y);
}

static void two_bodies(void)
{
    rectangle a = { { -0.75, 0.55, 0 }, -0.35, { 0.6, 0.26 } };
    rectangle b = { { 0.72, 0.5, 0 }, 0.5, { 0.66, 0.24 } };
    vec3 on_a = at(&a, 0.85, 0), on_b = at(&b, -0.85, 0);
    vec3 push = vec3_scale(1.6, vec3_sub(on_b, on_a));
    printf("\n\n");
    print_sides(&a);
    printf("\n\n");
    print_sides(&b);
    printf("\n\n");
    print_point(a.center);
    print_point(b.center);
    printf("\n\n");
    print_point(on_a);
    print_point(on_b);
    printf("\n\n");
    print_arrow(a.center, on_a);
    print_arrow(b.center, on_b);
    printf("\n\n");
    print_arrow(on_a, vec3_add(on_a, push));
    print_arrow(on_b, vec3_sub(on_b, push));
}

// A body, two arms of two, and a leg.
enum { PARTS = 6 };

static void tree(void)
{
    const rectangle part[PARTS] = {
        { { 0, 0.55, 0 }, 0, { 0.26, 0.42 } },
        { { 0.53, 0.85, 0 }, 0.2, { 0.24, 0.1 } },
        { { 1.0, 1.05, 0 }, 0.6, { 0.22, 0.09 } },
        { { -0.53, 0.85, 0 }, 0.1, { 0.24, 0.1 } },
        { { -0.98, 0.75, 0 }, 0.35, { 0.22, 0.09 } },
        { { 0.1, -0.18, 0 }, 1.75, { 0.3, 0.11 } } };
    const int on[PARTS] = { -1, 0, 1, 0, 3, 0 };
    const vec3 joint[PARTS] = { { 0, 0, 0 }, { 0.27, 0.8, 0 }, { 0.8, 0.92, 0 },
                                { -0.27, 0.83, 0 }, { -0.76, 0.81, 0 },
                                { 0.06, 0.13, 0 } };
    printf("\n\n");
    for (int k = 0; k < PARTS; k++) {
        print_sides(&part[k]);
        printf("\n");
    }
    printf("\n");
    for (int k = 1; k < PARTS; k++) print_point(joint[k]);
    printf("\n\n");
    for (int k = 1; k < PARTS; k++) {
        vec3 half = vec3_scale(0.5, vec3_add(joint[k], part[on[k]].center));
        print_arrow(part[k].center, joint[k]);
        print_arrow(joint[k], on[k] == 0 ? half : part[on[k]].center);
    }
}

int main(void)
{
    printf("# 17-joint: a ball joint in the plane, and a tree of bodies, m\n"
           "# compiler %s, flags %s", __VERSION__, FLAGS);
    two_bodies();
    tree();
    return 0;
}
