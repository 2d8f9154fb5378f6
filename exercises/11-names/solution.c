// solution.c - a vertex is name enough.

#include "names.h"

// The same vertices, in any order?
static int same_corners(const feature_point *f, const feature_point *g)
{
    if (f->count != g->count) return 0;
    for (int i = 0; i < f->count; i++) {
        int found = 0;
        for (int k = 0; k < g->count; k++)
            found |= f->vertex[i] == g->vertex[k];
        if (!found) return 0;
    }
    return 1;
}

int touch_same(const touch *s, const touch *t)
{
    int a_vertex = s->a.count == 1 && t->a.count == 1;
    int b_vertex = s->b.count == 1 && t->b.count == 1;
    if (a_vertex && s->a.vertex[0] == t->a.vertex[0]) return 1;
    if (b_vertex && s->b.vertex[0] == t->b.vertex[0]) return 1;
    if (s->a.count == 1 || t->a.count == 1) return 0;
    if (s->b.count == 1 || t->b.count == 1) return 0;
    return same_corners(&s->a, &t->a) && same_corners(&s->b, &t->b);
}

void names_carry(const touch *old, const real *pushed, int olds,
                 const touch *now, real *begin, int n)
{
    int given[MANIFOLD_POINTS] = { 0 };
    for (int i = 0; i < n; i++) {
        begin[i] = 0;
        for (int k = 0; k < olds; k++) {
            if (given[k] || !touch_same(&old[k], &now[i])) continue;
            begin[i] = pushed[k];
            given[k] = 1;
            break;
        }
    }
}
