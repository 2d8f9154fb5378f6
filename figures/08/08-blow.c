// 08-blow.c - one particle of a lattice is struck: which sticks are wrong after
// so many relaxations, in the order of the list and in the order of a blow?

#include "ordering.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

// A hexagon of particles, SIDE sticks of 1 m along each of its sides.
enum { SIDE = 7, ACROSS = 2 * SIDE + 1, LOOKS = 5, ORDERS = 2, MOST = 100000,
       PARTICLES = 3 * SIDE * (SIDE + 1) + 1, STICKS = 9 * SIDE * SIDE
                                                     + 3 * SIDE };
static const int LOOK[LOOKS] = { 0, 10, 30, 100, 300 };
static const char *const NAME[ORDERS] = { "listed", "repeated" };
static const real TOLERANCE = 1e-4;

typedef struct {
    int particles, sticks, struck;
    particle p[PARTICLES];
    stick s[STICKS];
} lattice;

static int in_hexagon(int i, int j)
{
    return abs(i) <= SIDE && abs(j) <= SIDE && abs(i + j) <= SIDE;
}

// Row by row, from below; and each particle's sticks to the ones before it.
static void lattice_make(lattice *l)
{
    const real rise = sqrt(3) / 2;
    static int number[ACROSS][ACROSS];
    *l = (lattice){ .particles = 0 };
    for (int j = -SIDE; j <= SIDE; j++)
        for (int i = -SIDE; i <= SIDE; i++) {
            if (!in_hexagon(i, j)) continue;
            int me = l->particles++;
            vec3 at = { i + 0.5 * j, rise * j, 0 };
            number[i + SIDE][j + SIDE] = me;
            l->p[me] = (particle){ at, at, 1 };
            const int back[3][2] = { { i - 1, j }, { i, j - 1 },
                                     { i + 1, j - 1 } };
            for (int k = 0; k < 3; k++)
                if (in_hexagon(back[k][0], back[k][1]))
                    l->s[l->sticks++] = (stick){
                        number[back[k][0] + SIDE][back[k][1] + SIDE], me, 1, 1,
                        STICK_EXACT };
            if (i == 0 && j == 0) l->struck = me;
        }
}

static real worst_strain(const lattice *l)
{
    real worst = 0;
    for (int k = 0; k < l->sticks; k++) {
        real strain = stick_strain(l->s[k], l->p);
        if (strain > worst) worst = strain;
    }
    return worst;
}

// The sticks as they lie now: two ends and the signed strain.
static void print_sticks(const lattice *l, int order, int look)
{
    real worst = worst_strain(l);
    int off = 0;
    for (int k = 0; k < l->sticks; k++)
        off += stick_strain(l->s[k], l->p) > 0.01;
    printf("\n\n# %s, %d relaxations: worst strain %.4f, %d of %d sticks off "
           "by more than 1 %%\n", NAME[order], LOOK[look], worst, off,
           l->sticks);
    printf("# x y to_x to_y strain worst off\n");
    for (int k = 0; k < l->sticks; k++) {
        vec3 a = l->p[l->s[k].a].position, b = l->p[l->s[k].b].position;
        printf("%.3f %.3f %.3f %.3f %.5f %.5f %d\n", a.x, a.y, b.x, b.y,
               vec3_distance(a, b) / l->s[k].rest_length - 1, worst, off);
    }
}

// Goes round the list and relaxes each stick that it finds off; looks at the
// body on the way.  Ends after MOST, or when no stick is off by more than 1 %.
static void run(lattice *l, const int *list, int n, int order)
{
    relax_options o = relax_options_pbd();
    int relaxed = 0, look = 0;
    for (int k = 0; relaxed < MOST; k = k + 1 < n ? k + 1 : 0) {
        while (look < LOOKS && LOOK[look] == relaxed)
            print_sticks(l, order, look++);
        stick s = l->s[list[k]];
        if (!(stick_strain(s, l->p) > TOLERANCE)) continue;
        relaxed += stick_relax(s, l->p, o).moved;
        if (look == LOOKS && worst_strain(l) <= 0.01) break;
    }
    printf("\n# %s: within 1 %% after %d relaxations\n", NAME[order], relaxed);
}

int main(void)
{
    static lattice rest, struck;
    lattice_make(&rest);
    stick_lists repeated;
    if (!stick_lists_build(&repeated, rest.s, rest.sticks, rest.particles,
                           1).ok) return 1;
    static int listed[STICKS];
    for (int k = 0; k < rest.sticks; k++) listed[k] = k;

    printf("# a hexagon of %d particles and %d sticks; the particle in the "
           "middle struck aside by 0.9 m\n# relaxed: sticks off by more than "
           "%g\n# %s, %s\n", rest.particles, rest.sticks, TOLERANCE,
           __VERSION__, FLAGS);
    for (int order = 0; order < ORDERS; order++) {
        struck = rest;
        vec3 *x = &struck.p[struck.struck].position;
        *x = vec3_add(*x, vec3_make(0.78, 0.45, 0));
        const int first = repeated.start[struck.struck];
        const int next = repeated.start[struck.struck + 1];
        if (order == 0) run(&struck, listed, rest.sticks, order);
        else run(&struck, repeated.stick + first, next - first, order);
    }
    stick_lists_free(&repeated);
    return 0;
}
