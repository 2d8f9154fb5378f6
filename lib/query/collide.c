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
// The manifold of both where they stand when they touch, with the gaps of now.
// One touch if faces do not lie along each other there.
static manifold touch_ahead(const collider *a, const collider *b, real near,
                            const swept_result *s, const vec3 *there)
{
    query_cache none = { .count = 0 };
    const collider x = { a->shape, there, false };
    const collider y = { b->shape, there + a->shape->particles, false };
    manifold m = collide_rigid(&x, &y, near, 0, &none);
    if (m.count == 0) {
        m = (manifold){ 1, s->normal, { { .gap = near } }, a->shape->round,
                        b->shape->round };
        query_features(&s->last, &m.point[0].a, &m.point[0].b);
    }
    for (int k = 0; k < m.count; k++) {
        touch *t = &m.point[k];
        vec3 gap = vec3_sub(feature_at(&t->a, a->at), feature_at(&t->b, b->at));
        t->gap = vec3_dot(gap, m.normal) - m.round_a - m.round_b;
    }
    return m;
}

// So near is touching, of the smaller radius.
static const real FINE = 0.0001;            // tuned, radii

swept_status collide_swept(const collider *a, const swept_motion *of_a,
                           const collider *b, const swept_motion *of_b,
                           real apart, vec3 *scratch, manifold *m)
{
    real fine = FINE * real_min(a->shape->radius, b->shape->radius);
    hull x = query_hull(a), y = query_hull(b);
    bool turns = vec3_length_squared(of_a->turn) > 0
              || vec3_length_squared(of_b->turn) > 0;
    vec3 delta = vec3_sub(of_a->delta, of_b->delta);
    // (A prism may miss what its cylinder touches.)
    apart += rim_sag(a->shape) + rim_sag(b->shape);
    real near = apart + query_round(a, b);
    swept_result s = turns
        ? swept_turning(x, of_a, y, of_b, near, fine, scratch)
        : swept_first_touch(x, delta, y, near, fine, scratch);
    if (s.status != SWEPT_TOUCHES) return s.status;
    swept_place(x, of_a, s.time, scratch);
    swept_place(y, of_b, s.time, scratch + a->shape->particles);
    *m = touch_ahead(a, b, apart + 2 * fine, &s, scratch);
    return s.status;
}
//<
