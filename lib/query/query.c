//> query-cache
// query.c - see query.h.

#include "query.h"

#include <assert.h>

// 18 bytes, where a simplex has 192.  gjk_distance needs no more than the
// vertices: where the corners are now, and their weights, it computes itself.
static simplex cache_read(const query_cache *c)
{
    simplex s = { .count = c->count };
    for (int k = 0; k < s.count; k++) s.of[k].a = c->a[k], s.of[k].b = c->b[k];
    return s;
}

static void cache_write(query_cache *c, const simplex *s)
{
    c->count = (unsigned short)s->count;
    for (int k = 0; k < s->count; k++) {
        c->a[k] = (unsigned short)s->of[k].a;
        c->b[k] = (unsigned short)s->of[k].b;
    }
}
//<

//> query-results
void query_features(const simplex *s, feature_point *a, feature_point *b)
{
    *a = *b = (feature_point){ .count = 0 };
    for (int k = 0; k < s->count; k++) {
        feature_add(a, s->of[k].a, s->weight[k]);
        feature_add(b, s->of[k].b, s->weight[k]);
    }
}

static query_result apart_result(const gjk_result *g)
{
    query_result r = { true, vec3_scale(1 / g->distance, g->axis),
                       { .gap = g->distance } };
    query_features(&g->last, &r.at.a, &r.at.b);
    return r;
}

// Two bodies with no volume, in one plane, have no way out of each other.
static query_result overlap_result(const hit_result *h)
{
    bool near = h->status == HIT_FOUND || h->status == HIT_CAPPED;
    return (query_result){ near, h->normal, { h->a, h->b, -h->depth } };
}
//<

//> query-nearest
hull query_hull(const collider *c)
{
    assert(c->shape->particles <= 65535);
    return (hull){ c->at, c->shape->particles };
}

query_result query_nearest(const collider *a, const collider *b, real margin,
                           query_cache *carried)
{
    assert(!(margin < 0));
    query_result none = { .near = false };
    if (!(margin >= 0)) return none;
    hull ha = query_hull(a), hb = query_hull(b);
    simplex s = cache_read(carried);
    gjk_result g = gjk_distance(ha, hb, margin, &s);
    cache_write(carried, &s);
    if (g.status == GJK_OVERLAP) {
        hit_result h = hit_face_find(ha, hb, &g.last);
        return overlap_result(&h);
    }
    bool known = g.status == GJK_APART || g.status == GJK_CAPPED;
    if (!known || g.last.count > 3 || g.distance > margin) return none;
    return apart_result(&g);
}
//<
