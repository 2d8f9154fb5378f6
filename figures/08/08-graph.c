// 08-graph.c - the paper's constraint graph, its sticks by distance from the
// particle v; and the list of v, round by round.

#include "ordering.h"

#include <stdio.h>

enum { PARTICLES = 5, STICKS = 7, V = 0 };

// c1 to c7 are 0 to 6.
static const stick BODY[STICKS] = {
    { 0, 1, 1, 1, STICK_EXACT }, { 1, 2, 1, 1, STICK_EXACT },
    { 2, 3, 1, 1, STICK_EXACT }, { 3, 4, 1, 1, STICK_EXACT },
    { 4, 0, 1, 1, STICK_EXACT }, { 1, 3, 1, 1, STICK_EXACT },
    { 4, 2, 1, 1, STICK_EXACT } };
static const real PLACE[PARTICLES][2] = { { 0, 1.25 }, { -1.3, 0.35 },
    { -0.8, -1.1 }, { 0.8, -1.1 }, { 1.3, 0.35 } };

// from[i]: sticks on the shortest path from v to particle i.
static void find(int *from)
{
    for (int i = 0; i < PARTICLES; i++) from[i] = i == V ? 0 : PARTICLES;
    for (int again = 0; again < PARTICLES; again++)
        for (int k = 0; k < STICKS; k++) {
            int *a = &from[BODY[k].a], *b = &from[BODY[k].b];
            *a = int_min(*a, *b + 1);
            *b = int_min(*b, *a + 1);
        }
}

static void print_list(const stick_lists *l, const int *distance)
{
    printf("\n\n# round, place in it, distance, name\n");
    int round = 0, place = 0;
    for (int i = l->start[V]; i < l->start[V + 1]; i++, place++) {
        int k = l->stick[i];
        if (i > l->start[V] && k == l->stick[l->start[V]]) round++, place = 0;
        printf("%d %d %d c_%d\n", round, place, distance[k], k + 1);
    }
}

int main(void)
{
    int from[PARTICLES], distance[STICKS];
    find(from);
    printf("# x y of the particles, v first\n");
    for (int i = 0; i < PARTICLES; i++)
        printf("%g %g\n", PLACE[i][0], PLACE[i][1]);
    printf("\n\n# sticks: x y dx dy distance name\n");
    for (int k = 0; k < STICKS; k++) {
        const real *a = PLACE[BODY[k].a], *b = PLACE[BODY[k].b];
        distance[k] = 1 + int_min(from[BODY[k].a], from[BODY[k].b]);
        printf("%g %g %g %g %d c_%d\n", a[0], a[1], b[0] - a[0], b[1] - a[1],
               distance[k], k + 1);
    }
    for (int repeated = 0; repeated < 2; repeated++) {
        stick_lists l;
        if (!stick_lists_build(&l, BODY, STICKS, PARTICLES, repeated).ok)
            return 1;
        print_list(&l, distance);
        stick_lists_free(&l);
    }
    return 0;
}
