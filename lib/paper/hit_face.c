//> hit-face-polytope
// hit_face.c - a polytope inside A - B grows until its face closest to the
// origin is one of A - B itself.

#include "hit_face.h"

#include <assert.h>
#include <stdbool.h>

enum { CORNERS = 512, FACES = 2 * CORNERS };    // Euler: F = 2 V - 4

// Times the size of the polytope: lengths below are rounding errors.
static const real ROUNDING = 1e-14;
static const real THIN = 1e-5;      // times its square: areas of slivers
static const real OUT_ENOUGH = 2e-15;   // a dozen roundings: w is no further out

typedef struct {
    int  of[3];         // corners, counter-clockwise as seen from outside
    vec3 normal;        // outward, as long as ...
    real area;          // m^2, twice the triangle's
    real weight[3];     // barycentric coordinates (>= 0, sum 1) of ...
    vec3 v;             // m, a point of the triangle: where the origin projects
    real distance;      // m, |v|
} face;

typedef struct {
    hull_mesh a, b;
    corner corner[CORNERS];
    face   face[FACES];
    int    corners, faces;
    vec3   middle;      // of the first tetrahedron: a point well inside
    real   size;        // m, distance of the furthest corner from the origin
} polytope;
//<

//> hit-face-add
static void add_corner(polytope *p, corner c)
{
    p->size = real_max(p->size, vec3_length(c.at));
    p->corner[p->corners++] = c;
}

// In a sliver the weights, and so v, are rounding errors: it takes 106 bits.
static void measure_wide(const polytope *p, face *t)
{
    simplex s = { .count = 3 };
    for (int k = 0; k < 3; k++) s.of[k] = p->corner[t->of[k]];
    t->normal = triangle_nearest_wide(&s, p->a.hull, p->b.hull);
    t->v = s.v;
    for (int k = 0; k < 3; k++) t->weight[k] = s.weight[k];
    t->area = vec3_length(t->normal);
    t->distance = t->area > 0 ? vec3_length(t->v) : HUGE_VAL;
}

// Where the origin projects outside the triangle, a negative weight becomes 0:
// then v is not the nearest point, but still one of the triangle.
static void add_face(polytope *p, int i, int j, int k)
{
    vec3 a = p->corner[i].at, b = p->corner[j].at, c = p->corner[k].at;
    face t = { .of = { i, j, k }, .normal = triangle_normal(a, b, c) };
    real *w = t.weight, sum = 0;
    triangle_weigh(t.normal, a, b, c, w);
    for (int n = 0; n < 3; n++) sum += w[n] = real_max(w[n], 0);
    for (int n = 0; n < 3; n++)
        t.v = vec3_add_scaled(t.v, w[n] /= sum, p->corner[t.of[n]].at);
    t.area = vec3_length(t.normal);
    t.distance = sum > 0 ? vec3_length(t.v) : HUGE_VAL;     // 0: no area
    if (t.area < THIN * p->size * p->size) measure_wide(p, &t);
    p->face[p->faces++] = t;
}

// How far v is from where the origin projects on the plane of the face.
static real beside(const face *t)
{
    return vec3_length(vec3_cross(vec3_unit(t->normal), t->v));
}

// Of faces that rounding cannot tell apart, the one into which the origin
// projects, or most nearly so.
static int closest_face(const polytope *p)
{
    int best = 0;
    for (int f = 1; f < p->faces; f++)
        if (p->face[f].distance < p->face[best].distance) best = f;
    real level = (1 + ROUNDING) * p->face[best].distance;
    for (int f = 0; f < p->faces; f++)
        if (f != best && p->face[f].distance <= level
            && beside(&p->face[f]) < beside(&p->face[best])) best = f;
    return best;
}
//<

//> hit-face-begin
// For k = 0 to 5, directions that lead off the point, line or plane which the
// corners so far span: all that are needed.  No longer than 1.
static vec3 direction_off(const polytope *p, int k)
{
    real sign = k % 2 ? 1 : -1;
    vec3 d = { k < 2 ? sign : 0, k / 2 == 1 ? sign : 0, k > 3 ? sign : 0 };
    if (p->corners == 1) return d;
    vec3 e = vec3_unit(vec3_sub(p->corner[1].at, p->corner[0].at));
    if (p->corners == 2) return vec3_cross(e, d);
    vec3 n = triangle_normal(p->corner[0].at, p->corner[1].at, p->corner[2].at);
    return vec3_scale(sign, vec3_unit(n));
}

// Adds the corner of A - B furthest off the span.  False if none lies off it.
static bool grow(polytope *p)
{
    corner best = p->corner[0];
    real most = ROUNDING * p->size;
    for (int k = 0; k < 6; k++) {
        vec3 d = direction_off(p, k);
        corner c = hull_support(p->a.hull, p->b.hull, d);
        real off = vec3_dot(d, vec3_sub(c.at, p->corner[0].at));
        if (off > most) most = off, best = c;
    }
    if (most > ROUNDING * p->size) add_corner(p, best);
    return most > ROUNDING * p->size;
}

// The tetrahedron of the first four corners.  i and j are 1 and 2, in the order
// that turns the normal of the face 0, i, j away from corner 3.
static void add_tetrahedron(polytope *p)
{
    const corner *c = p->corner;
    vec3 n = triangle_normal(c[0].at, c[1].at, c[2].at);
    int i = vec3_dot(n, vec3_sub(c[3].at, c[0].at)) > 0 ? 2 : 1, j = 3 - i;
    p->middle = vec3_scale(0.25, vec3_add(vec3_add(c[0].at, c[1].at),
                                          vec3_add(c[2].at, c[3].at)));
    add_face(p, 0, i, j);
    add_face(p, 0, 3, i);
    add_face(p, i, 3, j);
    add_face(p, j, 3, 0);
}

// Where bodies touch, GJK ends with fewer than four corners: others join them,
// until they span a volume.  False if all of A - B lies in a plane.
static bool begin_polytope(polytope *p, const simplex *start)
{
    assert(start->count > 0);
    p->corners = p->faces = 0, p->size = 0;
    for (int k = 0; k < start->count; k++) add_corner(p, start->of[k]);
    while (p->corners < 4)
        if (!grow(p)) return false;
    add_tetrahedron(p);
    return true;
}
//<

//> hit-face-rim
typedef struct { int from, to; } edge;
typedef struct { edge edge[3 * FACES]; int count; } rim;    // of a hole

static bool has_edge(const face *t, edge e)
{
    for (int k = 0; k < 3; k++)
        if (t->of[k] == e.from && t->of[(k + 1) % 3] == e.to) return true;
    return false;
}

// Removes a face.  An edge that the rim has already, the other way round, lay
// between two removed faces and goes; the others join the rim.
static void remove_face(polytope *p, int f, rim *r)
{
    face t = p->face[f];
    p->face[f] = p->face[--p->faces];
    for (int k = 0; k < 3; k++) {
        edge new = { t.of[k], t.of[(k + 1) % 3] };
        int e = 0;
        while (e < r->count && (r->edge[e].from != new.to
                                || r->edge[e].to != new.from)) e++;
        if (e < r->count) r->edge[e] = r->edge[--r->count];
        else r->edge[r->count++] = new;
    }
}
//<

//> hit-face-expand
// Would the face from an edge of the rim to w have its normal inwards?
static bool is_turned(const polytope *p, edge e, vec3 w)
{
    vec3 from = vec3_sub(p->corner[e.from].at, p->middle);
    vec3 to = vec3_sub(p->corner[e.to].at, p->middle);
    real volume = vec3_dot(vec3_cross(from, to), vec3_sub(w, p->middle));
    return volume < -ROUNDING * p->size * p->size * p->size;
}

// Removes all faces that w is clearly above, and closes the hole with faces
// from its rim to w.  Of faces nearly in one plane w may be above one and not
// the next; where that would turn a new face inside out, the next goes, too.
static void expand(polytope *p, int closest, corner w)
{
    rim r;
    r.count = 0;
    remove_face(p, closest, &r);
    for (int f = p->faces - 1; f >= 0; f--) {
        const face *t = &p->face[f];
        vec3 to_w = vec3_sub(w.at, p->corner[t->of[0]].at);
        real clear = ROUNDING * p->size * t->area;
        if (vec3_dot(t->normal, to_w) > clear) remove_face(p, f, &r);
    }
    for (int e = 0; e < r.count; e++) {
        if (!is_turned(p, r.edge[e], w.at)) continue;
        edge beyond = { r.edge[e].to, r.edge[e].from };
        int f = p->faces - 1;
        while (f >= 0 && !has_edge(&p->face[f], beyond)) f--;
        if (f < 0) continue;
        remove_face(p, f, &r);
        e = -1;                                 // the rim is another now
    }
    add_corner(p, w);
    for (int e = 0; e < r.count && p->faces < FACES; e++)
        add_face(p, r.edge[e].from, r.edge[e].to, p->corners - 1);
}
//<

//> hit-face-answer
//>   What the hit face says: the normal from B to A, the depth, and the
//>   features with their weights.
static hit_result result_of(const polytope *p, const corner *c, const real *w,
                            int count)
{
    hit_result r = { .status = HIT_FLAT };
    for (int k = 0; k < count; k++) {
        r.hit[k] = c[k];
        feature_add(&r.a, c[k].a, w[k]);
        feature_add(&r.b, c[k].b, w[k]);
    }
    r.on_a = feature_at(&r.a, p->a.hull.at);
    r.on_b = feature_at(&r.b, p->b.hull.at);
    r.kind = r.a.count < r.b.count ? TOUCH_VERTEX_FACE
           : r.a.count > r.b.count ? TOUCH_FACE_VERTEX : TOUCH_EDGE_EDGE;
    return r;
}

static hit_result flat_result(const polytope *p, const simplex *start)
{
    hit_result r = result_of(p, start->of, start->weight, start->count);
    for (int k = 1; k < 6 && !(vec3_length(r.normal) > 0); k += 2)
        r.normal = vec3_unit(direction_off(p, k));
    return r;
}

// The depth is how far A - B reaches along the normal: to w.
static hit_result face_result(const polytope *p, face *t, vec3 w)
{
    corner hit[3];
    for (int k = 0; k < 3; k++) hit[k] = p->corner[t->of[k]];
    hit_result r = result_of(p, hit, t->weight, 3);
    r.normal = vec3_unit(vec3_scale(-1, t->normal));
    r.depth = real_max(-vec3_dot(r.normal, w), 0);
    return r;
}
//<

//> hit-face-find
// Is the corner w clearly beyond the face t, which has the unit normal n?
static bool is_beyond(const polytope *p, const face *t, vec3 n, corner w)
{
    return vec3_dot(n, vec3_sub(w.at, t->v)) > OUT_ENOUGH * p->size;
}

// The corner of A - B furthest along n.  Where a climb from the face finds none
// beyond it, all are looked at.
static corner furthest_beyond(const polytope *p, const face *t, vec3 n)
{
    const hull_mesh *a = &p->a, *b = &p->b;
    corner w = p->corner[t->of[0]];
    if (hull_climbs(a) || hull_climbs(b)) {
        w.a = hull_climb(a, n, w.a);
        w.b = hull_climb(b, vec3_scale(-1, n), w.b);
        w.at = vec3_sub(a->hull.at[w.a], b->hull.at[w.b]);
        if (is_beyond(p, t, n, w)) return w;
    }
    return hull_support(a->hull, b->hull, n);
}

static const hit_result NOTHING = { .status = HIT_NOT_FINITE };

hit_result hit_face_climb(const hull_mesh *a, const hull_mesh *b,
                          const simplex *start)
{
    assert(a->hull.count >= 1 && b->hull.count >= 1);
    polytope p;
    face t;
    corner w = start->of[0];
    bool found = false;
    int iterations = 0;
    p.a = *a, p.b = *b;
    if (!begin_polytope(&p, start)) return flat_result(&p, start);
    for (; !found && p.faces > 0 && p.corners < CORNERS; iterations++) {
        int closest = closest_face(&p);
        t = p.face[closest];
        vec3 n = vec3_unit(t.normal);
        w = furthest_beyond(&p, &t, n);
        found = !is_beyond(&p, &t, n, w);
        if (!found) expand(&p, closest, w);
    }
    hit_result r = face_result(&p, &t, found ? w.at : t.v);
    r.status = found ? HIT_FOUND : HIT_CAPPED;
    r.iterations = iterations;
    return vec3_length(r.normal) > 0 && vec3_is_finite(r.on_b) ? r : NOTHING;
}

hit_result hit_face_find(hull a, hull b, const simplex *start)
{
    const hull_mesh of_a = { .hull = a }, of_b = { .hull = b };
    if (!hull_in_range(a) || !hull_in_range(b)) return NOTHING;
    return hit_face_climb(&of_a, &of_b, start);
}
//<
