// queries_box3d.c - Box3D's side of the program queries.

#include "queries.h"

#include <box3d/collision.h>

// Box3D takes bodies of up to so many corners.
enum { MOST = 32 };

static struct {
    b3Vec3 at[2][MOST];
    b3SimplexCache cache, next;
    int corners;
} body[QUERY_PAIRS];

// In floats, as seen from the middle of the pair's first corners.
void box3d_move(int k, const query_pair *p)
{
    const double *from[2] = { p->a, p->b };
    double origin[3];
    body[k].corners = p->corners < MOST ? p->corners : MOST;
    body[k].cache = body[k].next;
    for (int c = 0; c < 3; c++) origin[c] = (p->a[c] + p->b[c]) / 2;
    for (int side = 0; side < 2; side++)
        for (int i = 0; i < body[k].corners; i++) {
            const double *x = from[side] + 3 * i;
            body[k].at[side][i] = (b3Vec3){ (float)(x[0] - origin[0]),
                (float)(x[1] - origin[1]), (float)(x[2] - origin[2]) };
        }
}

void box3d_put(int k, const query_pair *p)
{
    body[k].next = (b3SimplexCache){ .count = 0 };
    box3d_move(k, p);
}

void box3d_learn(int k)
{
    box3d_ask(k);
    body[k].next = body[k].cache;
}

double box3d_ask(int k)
{
    b3DistanceInput in = {
        .proxyA = { body[k].at[0], body[k].corners, 0 },
        .proxyB = { body[k].at[1], body[k].corners, 0 },
        .transform = { { 0, 0, 0 }, { { 0, 0, 0 }, 1 } } };
    return (double)b3ShapeDistance(&in, &body[k].cache, NULL, 0).distance;
}
