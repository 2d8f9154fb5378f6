//> climb-scan
// climb.c - see climb.h.

#include "climb.h"

hull_mesh hull_bare(hull h)
{
    real most = 0;
    for (int k = 1; k < h.count; k++)
        most = real_max(most, vec3_distance(h.at[k], h.at[0]));
    return (hull_mesh){ .hull = h, .size = 2 * most };
}

int hull_scan(hull h, vec3 d)
{
    int best = 0;
    real most = vec3_dot(d, h.at[0]);
    for (int k = 1; k < h.count; k++) {
        real height = vec3_dot(d, h.at[k]);
        if (height > most) most = height, best = k;
    }
    return best;
}
//<

//> climb-up
// From so many vertices on climbing is quicker than to look at all.
enum { MANY = 48 };

bool hull_climbs(const hull_mesh *b)
{
    return b->hull.count >= MANY && b->mesh
        && b->mesh->vertices == b->hull.count;
}

// From vertex v uphill along the edges, to the highest neighbour of each.
static int climb(const hull_mesh *b, vec3 d, int v)
{
    const mesh *m = b->mesh;
    real most = vec3_dot(d, b->hull.at[v]);
    for (int steps = 0; steps < b->hull.count; steps++) {
        int best = v, h = m->vertex_half[v], start = h;
        do {
            half_edge back = m->half[mesh_twin(h)];
            real height = vec3_dot(d, b->hull.at[back.origin]);
            best = height > most ? back.origin : best;
            most = height > most ? height : most;
            h = back.next;
        } while (h != start);
        if (best == v) break;
        v = best;
    }
    return v;
}

int hull_climb(const hull_mesh *b, vec3 d, int from)
{
    return hull_climbs(b) ? climb(b, d, from) : hull_scan(b->hull, d);
}
//<
