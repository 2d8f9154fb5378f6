// 10-difference.c - two convex polygons, apart and overlapping, and the shape
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

#include "distance.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { CASES = 2, A_CORNERS = 5, B_CORNERS = 4, DIRECTIONS = 3600,
       MOST = A_CORNERS + B_CORNERS + 1 };

static const vec3 POLYGON_A[A_CORNERS] = {
    { 2.05, 0.75, 0 }, { 3.35, 0.55, 0 }, { 4.05, 1.60, 0 }, { 3.05, 2.65, 0 },
    { 1.95, 2.00, 0 }
};
static const vec3 POLYGON_B[B_CORNERS] = {
    { 0.35, 0.20, 0 }, { 1.45, 0.60, 0 }, { 1.25, 1.75, 0 }, { 0.10, 1.30, 0 }
};

// Where B stands in the two cases, m.
static const vec3 PLACE[CASES] = { { -0.6, -0.2, 0 }, { 1.6, -0.2, 0 } };

// A corner of A - B and the corners that it is made of.
typedef struct {
    int a, b;
} corner;

// Asks for the support of A - B all the way round, and notes each new corner.
static int corners_of(point_set a, point_set b, corner *c)
{
    int n = 0;
    for (int k = 0; k < DIRECTIONS; k++) {
        real turn = 2 * 3.14159265358979 * k / DIRECTIONS;
        vec3 d = { cos(turn), sin(turn), 0 };
        corner now = { support_scan(a, d),
                       support_scan(b, vec3_scale(-1, d)) };
        if (n > 0 && c[n - 1].a == now.a && c[n - 1].b == now.b) continue;
        if (n < MOST) c[n++] = now;
    }
    // The round ends with the corner that it began with.
    if (n > 1 && c[n - 1].a == c[0].a && c[n - 1].b == c[0].b) n--;
    return n;
}

static vec3 difference(point_set a, point_set b, corner c)
{
    return vec3_sub(a.at[c.a], b.at[c.b]);
}

static void print_polygon(point_set p, const char *name)
{
    printf("\n\n# %s\n", name);
    for (int k = 0; k <= p.count; k++)
        printf("%.6f %.6f\n", p.at[k % p.count].x, p.at[k % p.count].y);
}

static void print_difference(point_set a, point_set b)
{
    corner c[MOST];
    int n = corners_of(a, b, c);
    printf("\n\n# A - B, %d sides: x y dx dy side\n", n);
    for (int k = 0; k < n; k++) {
        corner next = c[(k + 1) % n];
        vec3 p = difference(a, b, c[k]);
        vec3 d = vec3_sub(difference(a, b, next), p);
        printf("%.6f %.6f %.6f %.6f %d\n", p.x, p.y, d.x, d.y,
               next.b == c[k].b ? 1 : 2);
    }
}

static void print_answer(point_set a, point_set b)
{
    distance_result r = distance_find(a, b, distance_options_default(), NULL);
    printf("\n\n# %s, distance %.6f m, %d support points\n",
           r.status == DISTANCE_OVERLAP ? "overlap" : "apart", r.distance,
           r.iterations);
    printf("%.6f %.6f %.6f %.6f %d\n", r.on_a.x, r.on_a.y, r.on_b.x, r.on_b.y,
           (int)r.status);
    printf("\n\n# the last simplex\n");
    for (int k = 0; k <= r.last.count; k++) {
        int i = k % r.last.count;
        vec3 p = difference(a, b, (corner){ r.last.a[i], r.last.b[i] });
        printf("%.6f %.6f\n", p.x, p.y);
    }
}

int main(void)
{
    printf("# 10-difference: two polygons and their difference, m\n"
           "# compiler %s, flags %s", __VERSION__, FLAGS);
    for (int k = 0; k < CASES; k++) {
        vec3 at[B_CORNERS];
        for (int i = 0; i < B_CORNERS; i++)
            at[i] = vec3_add(POLYGON_B[i], PLACE[k]);
        point_set a = { POLYGON_A, A_CORNERS, NULL, NULL };
        point_set b = { at, B_CORNERS, NULL, NULL };
        print_polygon(a, "A");
        print_polygon(b, "B");
        print_difference(a, b);
        print_answer(a, b);
    }
    return 0;
}
