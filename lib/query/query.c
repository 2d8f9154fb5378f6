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

static query_result apart_result(const gjk_result *g, real round)
{
    query_result r = { true, vec3_scale(1 / g->distance, g->axis),
                       { .gap = g->distance - round } };
    query_features(&g->last, &r.at.a, &r.at.b);
    return r;
}

// Two bodies with no volume, in one plane, have no way out of each other; but if
// they are cores, all ways out of the plane are as long as their radii.
static query_result overlap_result(const hit_result *h, real round)
{
    bool near = h->status == HIT_FOUND || h->status == HIT_CAPPED
             || (h->status == HIT_FLAT && round > 0);
    return (query_result){ near, h->normal, { h->a, h->b, -h->depth - round } };
}
//<

//> query-nearest
hull query_hull(const collider *c)
{
    assert(c->shape->particles <= 65535);
    return (hull){ c->at, c->shape->particles };
}

static hull_mesh mesh_of(const collider *c)
{
    return (hull_mesh){ query_hull(c), &c->shape->mesh, 2 * c->shape->radius };
}

real query_round(const collider *a, const collider *b)
{
    return a->shape->round + b->shape->round;
}

static bool is_in_range(const collider *c)
{
    return c->in_range || hull_in_range(query_hull(c));
}

query_result query_nearest(const collider *a, const collider *b, real margin,
                           query_cache *carried)
{
    assert(!(margin < 0));
    query_result none = { .near = false };
    if (!(margin >= 0)) return none;
    if (!is_in_range(a) || !is_in_range(b)) return none;
    hull_mesh ma = mesh_of(a), mb = mesh_of(b);
    simplex s = cache_read(carried);
    real round = query_round(a, b);
    gjk_result g = search_nearest(&ma, &mb, margin + round, &s);
    cache_write(carried, &s);
    if (g.status == GJK_OVERLAP) {
        hit_result h = hit_face_climb(&ma, &mb, &g.last);
        return overlap_result(&h, round);
    }
    bool known = g.status == GJK_APART || g.status == GJK_CAPPED;
    if (!known || g.last.count > 3 || g.distance > margin + round) return none;
    return apart_result(&g, round);
}
//<
