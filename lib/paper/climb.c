//> climb
// climb.c - see climb.h.
#include "climb.h"

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

// Goes to the highest neighbour, and on from there, until none is higher.
int hull_climb(const hull_mesh *b, vec3 d, int from)
{
    if (!hull_climbs(b)) return hull_scan(b->hull, d);
    const mesh *m = b->mesh;
    int best = from, v = -1;
    real most = vec3_dot(d, b->hull.at[from]);
    for (int steps = 0; best != v && steps < b->hull.count; steps++) {
        int h = m->vertex_half[v = best], start = h;
        do {
            half_edge back = m->half[mesh_twin(h)];
            real height = vec3_dot(d, b->hull.at[back.origin]);
            best = height > most ? back.origin : best;
            most = height > most ? height : most;
            h = back.next;
        } while (h != start);
    }
    return best;
}
//<
