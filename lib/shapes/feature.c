//> feature-add
// feature.c - see feature.h.

#include "feature.h"

#include <assert.h>

void feature_add(feature_point *f, int vertex, real weight)
{
    int k = 0;
    while (k < f->count && f->vertex[k] != vertex) k++;
    if (k == f->count) {
        assert(f->count < 3);
        f->vertex[f->count++] = vertex;
        f->weight[k] = 0;
    }
    f->weight[k] += weight;
}
//<

//> feature-at
// Measured from the first vertex, so that a body far from the origin loses no
// digit.
vec3 feature_at(const feature_point *f, const vec3 *at)
{
    vec3 first = at[f->vertex[0]], sum = { 0, 0, 0 };
    for (int k = 1; k < f->count; k++)
        sum = vec3_add_scaled(sum, f->weight[k],
                              vec3_sub(at[f->vertex[k]], first));
    return vec3_add(first, sum);
}
//<
