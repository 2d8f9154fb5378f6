// queries_gjk.c - openGJK's side of the program queries.

#include "queries.h"

#include <openGJK/openGJK.h>

// Pair after pair, each as long as it is.
static double at[QUERY_PAIRS * 2 * QUERY_CORNERS][3];
static double *row[QUERY_PAIRS * 2 * QUERY_CORNERS];
static int corners;

static int first(int k, int side)
{
    return (2 * k + side) * corners;
}

void gjk_put(int k, const query_pair *p)
{
    const double *from[2] = { p->a, p->b };
    corners = p->corners;
    for (int side = 0; side < 2; side++)
        for (int i = 0; i < corners; i++) {
            double *to = at[first(k, side) + i];
            for (int c = 0; c < 3; c++) to[c] = from[side][3 * i + c];
            row[first(k, side) + i] = to;
        }
}

double gjk_ask(int k)
{
    gkPolytope p[2] = { { .numpoints = corners }, { .numpoints = corners } };
    gkSimplex s = { .nvrtx = 0 };
    for (int side = 0; side < 2; side++) {
        p[side].coord = &row[first(k, side)];
        for (int c = 0; c < 3; c++) p[side].s[c] = p[side].coord[0][c];
    }
    return compute_minimum_distance(p[0], p[1], &s);
}
