//> obstacle-feature
#include "obstacle.h"

#include <assert.h>
#include <stddef.h>

// The features of the library's queries count from a body's first particle;
// those of a contact count in the pool.
static void feature_to_pool(feature_point *f, int first)
{
    for (int k = 0; k < f->count; k++) f->vertex[k] += first;
}

// Particle i of a body, as a feature.
static feature_point vertex_feature(int i)
{
    return (feature_point){ 1, { i, 0, 0 }, { 1, 0, 0 } };
}
//<

//> obstacle-contact
// A contact with nothing pushed yet.
static void contact_between(contact_point *c, const pooled *a,
                            const feature_point *fa, const pooled *b,
                            const feature_point *fb, vec3 on_b, vec3 normal)
{
    *c = (contact_point){ .a = *fa, .b = *fb, .fixed = on_b,
                          .normal = normal };
    feature_to_pool(&c->a, a->first);
    feature_to_pool(&c->b, b->first);
}

// An immovable side needs no feature, only the point where it stands.
static void forget_immovable(const pooled *b, contact_point *c, int n)
{
    for (int i = 0; i < n && !(b->mass < HUGE_VAL); i++) c[i].b.count = 0;
}
//<

//> obstacle-manifold
int contacts_of_manifold(const manifold *m, const pooled *a, const pooled *b,
                         contact_point out[PAIR_CONTACTS])
{
    for (int k = 0; k < m->count; k++)
        contact_between(&out[k], a, &m->point[k].a, b, &m->point[k].b,
                        feature_at(&m->point[k].b, b->at), m->normal);
    forget_immovable(b, out, m->count);
    return m->count;
}
//<

//> obstacle-plane
int collide_plane(const pooled *a, plane p, real margin, real thickness,
                  contact_point *out, int capacity)
{
    int n = 0;
    for (int i = 0; i < a->plan->particles; i++) {
        real up = plane_height(p, a->at[i]);
        if (up > margin + thickness) continue;
        if (n < capacity)
            out[n] = (contact_point){
                .a = vertex_feature(a->first + i),
                .fixed = vec3_add_scaled(a->at[i], -up, p.normal),
                .normal = p.normal, .thickness = thickness };
        n++;
    }
    return n;
}
//<

//> hull-planes
// Does face v lie in plane p, up to rounding?  It looks the same way, and no
// corner of it is off the plane by more than a billionth of the body's size.
static int lies_in_plane(const int *v, vec3 normal, const vec3 *at, plane p,
                         real size)
{
    if (!(vec3_dot(p.normal, normal) > 0)) return 0;
    for (int k = 0; k < 3; k++)
        if (!(fabs(plane_height(p, at[v[k]])) <= 1e-9 * size)) return 0;
    return 1;
}

int hull_planes(const shape *plan, const vec3 *at, plane *out, int *face)
{
    int n = 0;
    for (int f = 0; f < plan->mesh.faces; f++) {
        const int *v = &plan->face[3 * f];
        vec3 m = vec3_unit(vec3_cross(vec3_sub(at[v[1]], at[v[0]]),
                                      vec3_sub(at[v[2]], at[v[0]])));
        plane p = { m, vec3_dot(m, at[v[0]]) };
        int k = 0;
        while (k < n && !lies_in_plane(v, m, at, out[k], plan->radius)) k++;
        if (k < n) continue;
        out[n] = p;
        face[n++] = f;
    }
    return n;
}
//<

//> hull-ahead
int hull_ahead(vec3 x, const plane *p, int count)
{
    int best = 0;
    real most = -HUGE_VAL;
    for (int k = 0; k < count; k++) {
        real up = plane_height(p[k], x);
        if (up > most) { most = up; best = k; }
    }
    return best;
}
//<

//> obstacle-over
// The point of triangle (u, v, w) straight under x along the face's normal, as
// weights; 0 if it lies outside the triangle.
//
// With e1 = v - u, e2 = w - u, m = e1 x e2 the weights of the foot of x are
//   b2 = ((x - u) x e2) . m / m.m,  b3 = (e1 x (x - u)) . m / m.m,
//   b1 = 1 - b2 - b3.
static int weights_over(vec3 x, vec3 u, vec3 v, vec3 w, real weight[3])
{
    vec3 e1 = vec3_sub(v, u), e2 = vec3_sub(w, u), d = vec3_sub(x, u);
    vec3 m = vec3_cross(e1, e2);
    real mm = vec3_dot(m, m);
    if (!(mm > 0)) return 0;
    weight[1] = vec3_dot(vec3_cross(d, e2), m) / mm;
    weight[2] = vec3_dot(vec3_cross(e1, d), m) / mm;
    weight[0] = 1 - weight[1] - weight[2];
    return weight[0] >= 0 && weight[1] >= 0 && weight[2] >= 0;
}
//<

//> obstacle-edge
static int inside_planes(vec3 x, const plane *p, int count, real slack)
{
    for (int k = 0; k < count; k++)
        if (plane_height(p[k], x) > slack) return 0;
    return 1;
}

// The face of b, among those that look like face f, that lies under x.  Over
// an edge rounding, or a body's strain, may leave x a little outside them all:
// then the one that it is least outside of, x drawn in to its rim.
static feature_point face_under(vec3 x, const pooled *b, int f, vec3 normal)
{
    const int *v = &b->plan->face[3 * f];
    feature_point best = { 3, { v[0], v[1], v[2] }, { 1, 0, 0 } };
    real most = -HUGE_VAL, sum = 0;
    for (int g = 0; g < b->plan->mesh.faces; g++) {
        const int *u = &b->plan->face[3 * g];
        feature_point here = { 3, { u[0], u[1], u[2] }, { 1, 0, 0 } };
        const real *w = here.weight;
        if (!face_looks(b->plan, b->at, g, normal)) continue;
        if (weights_over(x, b->at[u[0]], b->at[u[1]], b->at[u[2]],
                         here.weight)) return here;
        real least = fmin(w[0], fmin(w[1], w[2]));
        if (least > most) { most = least; best = here; }
    }
    for (int k = 0; k < 3; k++) sum += best.weight[k] = fmax(best.weight[k], 0);
    for (int k = 0; k < 3; k++) best.weight[k] /= sum;
    return best;
}

// Outside a convex body, over no face: an edge or a corner is nearest.  If x is
// in front of just two planes n1, n2, at heights d1, d2, the point nearest it
// on the line where they meet is y = x - s1 n1 - s2 n2 with n1.y, n2.y in their
// planes:  s1 + c s2 = d1,  c s1 + s2 = d2,  c = n1.n2.  It is the nearest of
// the whole body if s1, s2 >= 0 and y is in the body.  1 if so.
static int nearest_on_edge(vec3 x, const plane *p, int count, real slack,
                           vec3 *y)
{
    int front[2], n = 0;
    real d[2];
    for (int k = 0; k < count; k++) {
        real up = plane_height(p[k], x);
        if (up <= 0) continue;
        if (n == 2) return 0;
        front[n] = k;
        d[n++] = up;
    }
    if (n < 2) return 0;
    vec3 n1 = p[front[0]].normal, n2 = p[front[1]].normal;
    real c = vec3_dot(n1, n2), det = 1 - c * c;
    real s1 = d[0] - c * d[1], s2 = d[1] - c * d[0];
    if (!(det > 1e-6) || s1 < 0 || s2 < 0) return 0;
    *y = vec3_add_scaled(vec3_add_scaled(x, -s1 / det, n1), -s2 / det, n2);
    return inside_planes(*y, p, count, slack);
}

// The contact of particle i of a with point on_b of b.
static int point_contact(contact_point *c, const pooled *a, int i,
                         const pooled *b, const feature_point *fb,
                         vec3 on_b, vec3 normal)
{
    feature_point self = vertex_feature(i);
    contact_between(c, a, &self, b, fb, on_b, normal);
    forget_immovable(b, c, 1);
    return 1;
}

// In every other case the query of two bodies finds the nearest point, one of
// them being a point.
static int collide_point_edge(const pooled *a, int i, const pooled *b,
                              real reach, contact_point *c)
{
    hull point = { &a->at[i], 1 }, body = { b->at, b->plan->particles };
    gjk_result g = gjk_distance(point, body, reach, NULL);
    if (g.status != GJK_APART || g.distance > reach) return 0;
    feature_point self, other;
    query_features(&g.last, &self, &other);
    return point_contact(c, a, i, b, &other, g.on_b,
                         vec3_scale(1 / g.distance, g.axis));
}
//<

//> obstacle-point
// Over no face of an immovable body, whose contacts need no feature.
static int collide_point_outside(const pooled *a, int i, const pooled *b,
                                 const plane *planes, int count, real reach,
                                 contact_point *c)
{
    vec3 y, x = a->at[i];
    if (b->mass < HUGE_VAL
        || !nearest_on_edge(x, planes, count, 1e-12 * b->plan->radius, &y))
        return collide_point_edge(a, i, b, reach, c);
    vec3 out = vec3_sub(x, y);
    real distance = vec3_length(out);
    if (!(distance > 0) || distance > reach) return 0;
    feature_point none = { .count = 0 };
    return point_contact(c, a, i, b, &none, y,
                         vec3_scale(1 / distance, out));
}

int collide_point(const pooled *a, int i, const pooled *b,
                  const plane *planes, const int *face, int count,
                  real reach, contact_point *c)
{
    assert(count > 0);
    vec3 x = a->at[i];
    int k = hull_ahead(x, planes, count);
    real up = plane_height(planes[k], x);
    if (!(up <= reach)) return 0;
    vec3 foot = vec3_add_scaled(x, -up, planes[k].normal);
    if (up > 0 && !inside_planes(foot, planes, count, 1e-12 * b->plan->radius))
        return collide_point_outside(a, i, b, planes, count, reach, c);

    feature_point under = { .count = 0 };
    if (b->mass < HUGE_VAL)
        under = face_under(x, b, face[k], planes[k].normal);
    return point_contact(c, a, i, b, &under, foot, planes[k].normal);
}
//<
