// 09-contact.c - one contact, four ways to fill it: the outlines, the two
// points and the normal of each, as the library finds them, seen from the front.

#include "hit_face.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { CORNERS = 4 };

// A square of this side, turned by the angle whose cosine and sine these are,
// as thick as it is wide.
static void make_box(vec3 *at, real x, real y, real side, real cosine, real sine)
{
    for (int i = 0; i < 2 * CORNERS; i++) {
        real u = (i & 1) != (i >> 1 & 1) ? side / 2 : -side / 2;
        real v = i & 2 ? side / 2 : -side / 2;
        real z = i & 4 ? side / 2 : -side / 2;
        at[i] = vec3_make(x + cosine * u - sine * v,
                          y + sine * u + cosine * v, z);
    }
}

static void print_outline(const vec3 *at, int n)
{
    for (int i = 0; i <= n; i++) printf("%.6g,%.6g\n", at[i % n].x, at[i % n].y);
    printf("\n\n");
}

// A point of A, a point of B; and a normal.
static void print_points(vec3 a, vec3 b, vec3 n)
{
    printf("%.6g,%.6g\n%.6g,%.6g\n\n\n%.6g,%.6g,%.6g,%.6g\n\n\n", a.x, a.y, b.x,
           b.y, b.x, b.y, 0.45 * n.x, 0.45 * n.y);
}

static void print_circle(real x, real y, real radius)
{
    const int n = 48;
    real c = 1, s = 0, dc = 0.99144486137381038, ds = 0.13052619222005157;
    for (int i = 0; i <= n; i++) {
        printf("%.6g,%.6g\n", x + radius * c, y + radius * s);
        real next = dc * c - ds * s;
        s = dc * s + ds * c;
        c = next;
    }
    printf("\n\n");
}

int main(void)
{
    vec3 a[2 * CORNERS], b[2 * CORNERS];
    hull hull_a = { a, 2 * CORNERS }, hull_b = { b, 2 * CORNERS };
    printf("# four contacts: outlines, points, normals (m)\n# compiler: %s\n"
           "# flags: %s\nx,y\n\n\n", __VERSION__, FLAGS);
    // 1, 2: a corner of A in the side of B, the points, the normal.
    make_box(a, 0.05, 0.98, 0.8, 0.8, 0.6);
    make_box(b, 0, 0, 1, 1, 0);
    gjk_result g = gjk_distance(hull_a, hull_b, 0, NULL);
    hit_result h = hit_face_find(hull_a, hull_b, &g.last);
    print_outline(a, CORNERS);
    print_outline(b, CORNERS);
    print_points(h.on_a, h.on_b, h.normal);
    // A leaf's sphere, its centre within its thickness of B.
    vec3 center = { -0.1, 0.62, 0 };
    hull leaf = { &center, 1 };
    g = gjk_distance(leaf, hull_b, HUGE_VAL, NULL);
    print_circle(center.x, center.y, 0.3);
    print_points(center, g.on_b, vec3_unit(g.axis));
    // Two leaves.
    vec3 p = { -0.2, 0.55, 0 }, q = { 0.2, 0.15, 0 };
    print_circle(p.x, p.y, 0.38);
    print_circle(q.x, q.y, 0.38);
    print_points(p, q, vec3_unit(vec3_sub(p, q)));
    // A particle behind a plane.
    make_box(a, 0.02, 0.42, 0.8, 0.8, 0.6);
    print_outline(a, CORNERS);
    vec3 low = a[0];
    for (int i = 0; i < CORNERS; i++) if (a[i].y < low.y) low = a[i];
    print_points(low, vec3_make(low.x, 0, 0), vec3_make(0, 1, 0));
    return 0;
}
