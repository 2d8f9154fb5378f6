// solution.c - marks, and Euler.

#include "handles.h"

#include <stdlib.h>

// Room for n marks, all 0; never NULL for want of size.
static int *marks(int n)
{
    return calloc((size_t)(n > 0 ? n : 1), sizeof(int));
}

int count_rims(const mesh *m)
{
    int *seen = marks(2 * m->edges), rims = 0;
    if (!seen) return -1;
    for (int start = 0; start < 2 * m->edges; start++) {
        if (m->half[start].face >= 0 || seen[start]) continue;
        rims++;
        for (int h = start; !seen[h]; h = m->half[h].next) seen[h] = 1;
    }
    free(seen);
    return rims;
}

// Marks and lists the neighbours of v that have no mark; the list has `listed`
// vertices, and has as many as returned when this is done.
static int list_neighbours(const mesh *m, int v, int *seen, int *list,
                           int listed)
{
    int start = m->vertex_half[v], h = start;
    do {
        int to = mesh_target(m, h);
        if (!seen[to]) list[listed++] = to;
        seen[to] = 1;
        h = mesh_around(m, h);
    } while (h != start);
    return listed;
}

int count_pieces(const mesh *m)
{
    int *seen = marks(m->vertices), *list = marks(m->vertices), pieces = 0;
    for (int start = 0; seen && list && start < m->vertices; start++) {
        if (seen[start] || m->vertex_half[start] < 0) continue;
        int listed = 1;
        pieces++;
        list[0] = start;
        seen[start] = 1;
        for (int k = 0; k < listed; k++)
            listed = list_neighbours(m, list[k], seen, list, listed);
    }
    int result = seen && list ? pieces : -1;
    free(seen);
    free(list);
    return result;
}

// A vertex alone adds 1 to Euler's number, and is no surface.
static int euler_of_surface(const mesh *m)
{
    int alone = 0;
    for (int v = 0; v < m->vertices; v++) alone += m->vertex_half[v] < 0;
    return mesh_euler(m) - alone;
}

int count_handles(const mesh *m)
{
    int pieces = count_pieces(m), rims = count_rims(m);
    if (pieces < 0 || rims < 0) return -1;
    // V - E + F = 2 pieces - 2 handles - rims.
    return (2 * pieces - rims - euler_of_surface(m)) / 2;
}
