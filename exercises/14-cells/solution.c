// solution.c - counted, laid out, and asked cell by cell.

#include "cells.h"

// floor, not a cast: a cast goes towards 0, and 0 would have two cells in one.
int cell_of(vec3 at, real size, cell *c)
{
    const real most = 0x1p40;
    real x = floor(at.x / size), y = floor(at.y / size), z = floor(at.z / size);
    if (!(fabs(x) <= most && fabs(y) <= most && fabs(z) <= most)) return 0;
    *c = (cell){ (long long)x, (long long)y, (long long)z };
    return 1;
}

// Counted first: start[s + 1] is how many slot s holds.  Added up, start[s] is
// where slot s begins.  Each point then takes the place at which its slot's
// start stands, and moves it on; so in the end all starts have moved to where
// the next slot begins, and go back by one slot.
int cells_fill(cells *g, const vec3 *at, real size)
{
    for (int s = 0; s <= g->slots; s++) g->start[s] = 0;
    for (int p = 0; p < g->points; p++) {
        if (!cell_of(at[p], size, &g->in[p])) return 0;
        g->start[cell_slot(g->in[p], g->slots) + 1]++;
    }
    for (int s = 0; s < g->slots; s++) g->start[s + 1] += g->start[s];
    for (int p = 0; p < g->points; p++)
        g->member[g->start[cell_slot(g->in[p], g->slots)]++] = p;
    for (int s = g->slots; s > 0; s--) g->start[s] = g->start[s - 1];
    g->start[0] = 0;
    return 1;
}

static int same_cell(cell a, cell b)
{
    return a.i == b.i && a.j == b.j && a.k == b.k;
}

// Those with higher numbers in cell c.  A slot may hold points of other cells,
// which have their own turn, or none.
static int ask_cell(cells *g, const vec3 *at, int a, cell c, real reach,
                    int (*out)[2], int capacity, int found)
{
    int slot = cell_slot(c, g->slots);
    for (int m = g->start[slot]; m < g->start[slot + 1]; m++) {
        int b = g->member[m];
        if (b <= a || !same_cell(g->in[b], c)) continue;
        g->looked++;
        if (!(vec3_length_squared(vec3_sub(at[a], at[b])) <= reach * reach))
            continue;
        if (found < capacity) {
            out[found][0] = a;
            out[found][1] = b;
        }
        found++;
    }
    return found;
}

int cells_pairs(cells *g, const vec3 *at, real size, real reach,
                int (*out)[2], int capacity)
{
    int found = 0;
    g->looked = 0;
    if (!(reach >= 0 && reach <= size) || !cells_fill(g, at, size)) return -1;
    for (int a = 0; a < g->points; a++)
        for (int n = 0; n < 27; n++) {
            cell c = g->in[a];
            c.i += n % 3 - 1;
            c.j += n / 3 % 3 - 1;
            c.k += n / 9 - 1;
            found = ask_cell(g, at, a, c, reach, out, capacity, found);
        }
    return found;
}
