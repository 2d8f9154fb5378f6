//> collide-rigid
//>   The first puts the query of chapter 10 and the manifold of chapter 11
//>   together.
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
// The manifold of a as it will be when it has gone a share of the way, with the
// gaps of now.  One touch if faces do not lie along each other there.
static manifold touch_ahead(const collider *a, const collider *b, vec3 way,
                            real near, const swept_result *s, vec3 *scratch)
{
    query_cache none = { .count = 0 };
    vec3 gone = vec3_scale(s->time, way);
    for (int v = 0; v < a->shape->particles; v++)
        scratch[v] = vec3_add(a->at[v], gone);
    const collider ahead = { a->shape, scratch, false };
    manifold m = collide_rigid(&ahead, b, near, 0, &none);
    if (m.count == 0) {
        m = (manifold){ 1, s->normal, { { .gap = near } } };
        query_features(&s->last, &m.point[0].a, &m.point[0].b);
    }
    for (int k = 0; k < m.count; k++) {
        touch *t = &m.point[k];
        vec3 gap = vec3_sub(feature_at(&t->a, a->at), feature_at(&t->b, b->at));
        t->gap = vec3_dot(gap, m.normal) - query_round(a, b);
    }
    return m;
}

// So near is touching, of the smaller radius.
static const real FINE = 0.001;             // tuned, radii

swept_status collide_swept(const collider *a, const collider *b, vec3 way,
                           real apart, vec3 *scratch, manifold *m)
{
    real fine = FINE * real_min(a->shape->radius, b->shape->radius);
    swept_result s = swept_first_touch(query_hull(a), way, query_hull(b),
                                       apart + query_round(a, b), fine,
                                       scratch);
    if (s.status == SWEPT_TOUCHES)
        *m = touch_ahead(a, b, way, apart + 2 * fine, &s, scratch);
    return s.status;
}
//<
