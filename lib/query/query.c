//> query-cache
// query.c - see query.h.

#include "query.h"

#include <assert.h>
#include <stddef.h>

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

static query_result nearest_hulls(const collider *a, const collider *b,
                                  real margin, query_cache *carried)
{
    query_result none = { .near = false };
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
    if (g.status == GJK_BEYOND) none.at.gap = g.distance - round;
    bool known = g.status == GJK_APART || g.status == GJK_CAPPED;
    if (!known || g.last.count > 3 || g.distance > margin + round) return none;
    return apart_result(&g, round);
}
//<

//> query-rims
//>   What the search found on the prism of a cylinder is moved out to its rim.
void query_move_to_rims(rim_pair *p, const collider *a, const collider *b, vec3 n)
{
    rim_towards(a->shape, a->at, vec3_scale(-1, n), &p->a);
    rim_towards(b->shape, b->at, n, &p->b);
}

collider query_core(const collider *c, const rim_core *r)
{
    return r->is_seen ? (collider){ &r->core, r->at, false } : *c;
}

static bool is_on_core(const feature_point *f)
{
    for (int k = 0; k < f->count; k++)
        if (f->vertex[k] > 1) return false;
    return true;
}

void query_touch_cores(const collider *a, const collider *b, const rim_pair *p,
                       vec3 n, touch *t)
{
    if (!p->a.is_seen && !p->b.is_seen) return;
    collider x = query_core(a, &p->a), y = query_core(b, &p->b);
    if (p->a.is_seen && !is_on_core(&t->a))
        t->a = rim_furthest(&p->a, vec3_scale(-1, n));
    if (p->b.is_seen && !is_on_core(&t->b)) t->b = rim_furthest(&p->b, n);
    vec3 apart = vec3_sub(feature_at(&t->a, x.at), feature_at(&t->b, y.at));
    t->gap = vec3_dot(n, apart) - query_round(&x, &y);
}

// Is the normal still across the axis, and the answer found on the side?
static bool stays_flat(const rim_pair *was, const rim_pair *now)
{
    return now->a.is_flat >= was->a.is_flat && now->b.is_flat >= was->b.is_flat;
}

// A side that faces the other body is asked as the capsule that it belongs to: over
// an edge, or along another cylinder, its normal turns steadily.
static bool query_sides(const collider *a, const collider *b, query_result *r,
                        const rim_pair *p)
{
    query_cache none = { .count = 0 };
    if (!p->a.is_flat && !p->b.is_flat) return false;
    collider x = *a, y = *b;
    if (p->a.is_flat) x.shape = &p->a.core;
    if (p->b.is_flat) y.shape = &p->b.core;
    query_result side = nearest_hulls(&x, &y, HUGE_VAL, &none);
    rim_pair now;
    if (!side.near) return false;
    query_move_to_rims(&now, a, b, side.normal);
    if (!stays_flat(p, &now)) return false;
    *r = side;
    return true;
}

static query_result nearest_rims(const collider *a, const collider *b,
                                 real margin, query_cache *carried)
{
    real sags = rim_sag(a->shape) + rim_sag(b->shape);
    query_result r = nearest_hulls(a, b, margin + sags, carried);
    if (!r.near) r.at.gap -= sags;
    if (!r.near) return r;
    rim_pair p;
    query_move_to_rims(&p, a, b, r.normal);
    if (query_sides(a, b, &r, &p)) query_move_to_rims(&p, a, b, r.normal);
    query_touch_cores(a, b, &p, r.normal, &r.at);
    r.near = r.at.gap <= margin;
    return r;
}

query_result query_nearest(const collider *a, const collider *b, real margin,
                           query_cache *carried)
{
    assert(!(margin < 0));
    if (!(margin >= 0)) return (query_result){ .near = false };
    return a->shape->rim > 0 || b->shape->rim > 0
        ? nearest_rims(a, b, margin, carried)
        : nearest_hulls(a, b, margin, carried);
}
//<
