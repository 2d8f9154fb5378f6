// 06-sphere.c - the smallest circle around points, round by round; and four
// links of a chain: the spheres of a layered tree and of a wrapped one.
//
//   index 0: points x y
//   index 1 to 3: rounds: circle x y r, then support points x y 0, then the
//                 farthest point x y -1
//   index 4: chain x y
//   index 5, 6: layered, wrapped: level x y r
#include "sphere.h"

#include <stdio.h>

enum { POINTS = 14, LINKS = 4 };

static const vec3 AT[POINTS] = {
    { 0.10, 0.35, 0 }, { 0.45, 0.80, 0 }, { 0.55, 0.15, 0 }, { 0.85, 0.60, 0 },
    { 1.10, 1.05, 0 }, { 0.30, 1.20, 0 }, { 1.25, 0.30, 0 }, { 0.75, 0.95, 0 },
    { 1.45, 0.75, 0 }, { 0.95, 0.05, 0 }, { 0.62, 0.50, 0 }, { 1.00, 0.80, 0 },
    { 0.15, 0.70, 0 }, { 0.70, 1.33, 0 }
};

// One round: the sphere of the support points, and who stands farthest out.
static int print_round(const int *set, int n, int round)
{
    int support[4], supports, far = 0;
    real weight[4], most = 0;
    sphere s = sphere_of_points(AT, set, n, support, weight, &supports);
    for (int i = 0; i < POINTS; i++) {
        real d = vec3_distance(AT[i], s.center);
        if (d > most) { most = d; far = i; }
    }
    int is_last = most <= s.radius * (1 + 1e-12);
    printf("\n\n# round %d: circle, support points, farthest\n", round);
    printf("%.4f %.4f %.4f\n", s.center.x, s.center.y, s.radius);
    for (int i = 0; i < supports; i++)
        printf("%.4f %.4f 0\n", AT[support[i]].x, AT[support[i]].y);
    if (!is_last) printf("%.4f %.4f -1\n", AT[far].x, AT[far].y);
    return is_last ? -1 : far;
}

// The set of the next round: the support points of this one, and the farthest.
static void print_rounds(void)
{
    int set[5] = { 0 }, n = 1;
    printf("# points x y\n");
    for (int i = 0; i < POINTS; i++) printf("%g %g\n", AT[i].x, AT[i].y);
    for (int round = 1, far = 0; far >= 0 && round < 10; round++) {
        int support[4], supports;
        real weight[4];
        far = print_round(set, n, round);
        sphere_of_points(AT, set, n, support, weight, &supports);
        for (n = 0; n < supports; n++) set[n] = support[n];
        if (far >= 0) set[n++] = far;
    }
}

static void print_sphere(int level, sphere s)
{
    printf("%d %.4f %.4f %.4f\n", level, s.center.x, s.center.y, s.radius);
}

static void print_chain(void)
{
    static const vec3 at[LINKS + 1] = {
        { 0, 0, 0 }, { 1, 0.55, 0 }, { 2, 0.1, 0 }, { 2.75, 0.9, 0 },
        { 3.6, 0.3, 0 } };
    sphere leaf[LINKS], pair[2];
    int all[LINKS + 1], support[4], supports;
    real weight[4];
    printf("\n\n# chain x y\n");
    for (int i = 0; i <= LINKS; i++) printf("%g %g\n", at[i].x, at[i].y);
    for (int i = 0; i <= LINKS; i++) all[i] = i;

    printf("\n\n# layered: level x y r\n");
    for (int i = 0; i < LINKS; i++) {
        leaf[i] = sphere_of_points(at + i, all, 2, support, weight, &supports);
        print_sphere(2, leaf[i]);
    }
    for (int i = 0; i < 2; i++) {
        pair[i] = sphere_of_spheres(leaf[2 * i], leaf[2 * i + 1]);
        print_sphere(1, pair[i]);
    }
    print_sphere(0, sphere_of_spheres(pair[0], pair[1]));

    printf("\n\n# wrapped: level x y r\n");
    for (int i = 0; i < LINKS; i++) print_sphere(2, leaf[i]);
    for (int i = 0; i < 2; i++)
        print_sphere(1, sphere_of_points(at, all + 2 * i, 3, support, weight,
                                         &supports));
    print_sphere(0, sphere_of_points(at, all, LINKS + 1, support, weight,
                                     &supports));
}

int main(void)
{
    print_rounds();
    print_chain();
    return 0;
}
