//> ring-build
#include "ring.h"

#include <stdlib.h>

status rings_build(rings *r, const mesh *m)
{
    int filled = 0;
    r->start = calloc((size_t)m->vertices + 1, sizeof *r->start);
    r->list  = calloc(2 * (size_t)m->edges + 1, sizeof *r->list);
    if (!r->start || !r->list) {
        rings_free(r);
        return status_out_of_memory();
    }
    for (int v = 0; v < m->vertices; v++) {
        int start = m->vertex_half[v], h = start;
        r->start[v] = filled;
        if (start < 0) continue;
        do {
            r->list[filled++] = mesh_target(m, h);
            h = mesh_around(m, h);
        } while (h != start && filled < 2 * m->edges);
    }
    r->start[m->vertices] = filled;
    return status_ok();
}

void rings_free(rings *r)
{
    free(r->start);
    free(r->list);
    *r = (rings){ NULL, NULL };
}
//<

//> ring-inner
// The origin lies behind every face, and so far behind the nearest.
real shape_inner(const shape *s)
{
    if (s->kind != SHAPE_RIGID) return 0;
    real inner = s->radius;
    for (int f = 0; f < s->mesh.faces; f++) {
        const int *v = &s->face[3 * f];
        vec3 m = vec3_unit(vec3_cross(vec3_sub(s->at[v[1]], s->at[v[0]]),
                                      vec3_sub(s->at[v[2]], s->at[v[0]])));
        inner = real_max(real_min(inner, vec3_dot(m, s->at[v[0]])), 0);
    }
    return inner;
}
//<
