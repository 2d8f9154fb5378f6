// 05-grow.c - the expanding polytope in the plane: a polygon inside A - B grows
// until its edge closest to the origin is one of A - B itself.
//
// Block 0, after two blank lines: A - B, closed.  Then for each panel three
// blocks: the polygon, closed; its closest edge and the point of it closest to
// the origin (x y of each); the next corner w and where its line of equal
// height meets the normal (x y of each; w is on the edge if this is the last).
// Metres; columns separated by spaces.

#include "gjk.h"

#include <stdio.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { A_CORNERS = 6, B_CORNERS = 4, MOST = 32, DIRECTIONS = 3600 };

static const vec3 A[A_CORNERS] = {
    { 0.35, 0.95, 0 }, { 1.65, 0.25, 0 }, { 3.05, 0.55, 0 }, { 3.55, 1.75, 0 },
    { 2.35, 2.75, 0 }, { 0.85, 2.35, 0 }
};
static const vec3 B[B_CORNERS] = {
    { 0.95, 0.55, 0 }, { 2.15, 0.35, 0 }, { 2.35, 1.35, 0 }, { 1.25, 1.65, 0 }
};
static const hull HULL_A = { A, A_CORNERS }, HULL_B = { B, B_CORNERS };

static vec3 support(vec3 d)
{
    return hull_support(HULL_A, HULL_B, d).at;
}

static vec3 outward(vec3 from, vec3 to)
{
    vec3 e = vec3_unit(vec3_sub(to, from));
    return (vec3){ e.y, -e.x, 0 };              // counter-clockwise polygons
}

static int closest_edge(const vec3 *p, int n)
{
    int best = 0;
    real least = HUGE_VAL;
    for (int k = 0; k < n; k++) {
        real height = vec3_dot(outward(p[k], p[(k + 1) % n]), p[k]);
        if (height < least) least = height, best = k;
    }
    return best;
}

static void print_polygon(const vec3 *p, int n, const char *name)
{
    printf("\n\n# %s\n", name);
    for (int k = 0; k <= n; k++) printf("%.6f %.6f\n", p[k % n].x, p[k % n].y);
}

static void print_difference(void)
{
    vec3 p[MOST];
    int n = 0;
    for (int k = 0; k < DIRECTIONS && n < MOST; k++) {
        real turn = 2 * 3.14159265358979 * k / DIRECTIONS;
        vec3 w = support((vec3){ cos(turn), sin(turn), 0 });
        if (n == 0 || vec3_distance(w, p[n - 1]) > 0) p[n++] = w;
    }
    print_polygon(p, n, "A - B");
}

int main(void)
{
    printf("# 05-grow: EPA in the plane, m\n# compiler %s, flags %s",
           __VERSION__, FLAGS);
    print_difference();
    vec3 p[MOST] = { support((vec3){ 1, 0.2, 0 }), support((vec3){ -0.9, 1, 0 }),
                     support((vec3){ -0.3, -1, 0 }) };
    int n = 3, on = 1;
    while (on && n < MOST) {
        int k = closest_edge(p, n);
        vec3 from = p[k], to = p[(k + 1) % n], d = outward(from, to);
        real height = vec3_dot(d, from);
        vec3 w = support(d), foot = vec3_scale(height, d);
        vec3 top = vec3_scale(vec3_dot(d, w), d);
        print_polygon(p, n, "the polygon");
        printf("\n\n# closest edge, and its point: %.6f m away\n", height);
        printf("%.6f %.6f\n%.6f %.6f\n%.6f %.6f\n", from.x, from.y, to.x, to.y,
               foot.x, foot.y);
        printf("\n\n# w, and as high above the origin: %.6f m\n",
               vec3_dot(d, w));
        printf("%.6f %.6f\n%.6f %.6f\n", w.x, w.y, top.x, top.y);
        on = vec3_dot(d, w) > height + 1e-12;
        for (int m = n; on && m > k + 1; m--) p[m] = p[m - 1];
        if (on) p[k + 1] = w, n++;
    }
    return 0;
}
