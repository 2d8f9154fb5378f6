//> collide-rigid
// collide.c - see collide.h.

#include "collide.h"

manifold collide_rigid(const collider *a, const collider *b, real margin,
                       real turn, query_cache *carried)
{
    query_result nearest = query_nearest(a, b, margin, carried);
    if (!nearest.near) return (manifold){ .count = 0 };
    return manifold_find(a, b, &nearest, margin, turn);
}
//<

//> collide-swept
swept_status collide_swept(const collider *a, const collider *b, vec3 way,
                           real apart, vec3 *scratch, manifold *m)
{
    real fine = 0.001 * real_min(a->shape->radius, b->shape->radius);
    swept_result s = swept_first_touch(query_hull(a), way, query_hull(b),
                                       apart, fine, scratch);
    if (s.status != SWEPT_TOUCHES) return s.status;
    touch t;
    query_features(&s.last, &t.a, &t.b);
    vec3 gap = vec3_sub(feature_at(&t.a, a->at), feature_at(&t.b, b->at));
    t.gap = vec3_dot(gap, s.normal);
    *m = (manifold){ 1, s.normal, { t } };
    return s.status;
}
//<
