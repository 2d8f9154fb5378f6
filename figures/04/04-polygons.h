// 04-polygons.h - the two polygons that chapter 4 draws, and how to print them.

#ifndef FIGURE_POLYGONS_H
#define FIGURE_POLYGONS_H

#include "gjk.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { A_CORNERS = 5, B_CORNERS = 4, DIRECTIONS = 3600,
       MOST = A_CORNERS + B_CORNERS + 1 };

static const vec3 POLYGON_A[A_CORNERS] = {
    { 2.05, 0.75, 0 }, { 3.35, 0.55, 0 }, { 4.05, 1.60, 0 }, { 3.05, 2.65, 0 },
    { 1.95, 2.00, 0 }
};
static const vec3 POLYGON_B[B_CORNERS] = {
    { 0.35, 0.20, 0 }, { 1.45, 0.60, 0 }, { 1.25, 1.75, 0 }, { 0.10, 1.30, 0 }
};

// Asks for the support of A - B all the way round, and notes each new corner.
static inline int corners_of(hull a, hull b, corner *c)
{
    int n = 0;
    for (int k = 0; k < DIRECTIONS; k++) {
        real turn = 2 * 3.14159265358979 * k / DIRECTIONS;
        corner now = hull_support(a, b, (vec3){ cos(turn), sin(turn), 0 });
        if (n > 0 && c[n - 1].a == now.a && c[n - 1].b == now.b) continue;
        if (n < MOST) c[n++] = now;
    }
    // The round ends with the corner that it began with.
    if (n > 1 && c[n - 1].a == c[0].a && c[n - 1].b == c[0].b) n--;
    return n;
}

static inline void print_polygon(hull p, const char *name)
{
    printf("\n\n# %s\n", name);
    for (int k = 0; k <= p.count; k++)
        printf("%.6f %.6f\n", p.at[k % p.count].x, p.at[k % p.count].y);
}

static inline void print_difference(hull a, hull b)
{
    corner c[MOST];
    int n = corners_of(a, b, c);
    printf("\n\n# A - B, %d sides: x y dx dy side\n", n);
    for (int k = 0; k < n; k++) {
        corner next = c[(k + 1) % n];
        vec3 d = vec3_sub(next.at, c[k].at);
        printf("%.6f %.6f %.6f %.6f %d\n", c[k].at.x, c[k].at.y, d.x, d.y,
               next.b == c[k].b ? 1 : 2);
    }
}

#endif
