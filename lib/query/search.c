//> search-support
// search.c - see search.h.

#include "search.h"

#include <assert.h>
#include <stddef.h>

// The vertex furthest along d, of any number.
static int scan(hull h, vec3 d)
{
    int best = 0;
    real most = vec3_dot(d, h.at[0]);
    for (int k = 1; k < h.count; k++) {
        real height = vec3_dot(d, h.at[k]);
        if (height > most) most = height, best = k;
    }
    return best;
}
//<

//> search-climb
// From vertex v uphill along the edges, to the highest neighbour of each.
static int climb(hull_mesh b, vec3 d, int v)
{
    const mesh *m = b.mesh;
    real most = vec3_dot(d, b.hull.at[v]);
    for (int steps = 0; steps < b.hull.count; steps++) {
        int best = v, h = m->vertex_half[v], start = h;
        do {
            half_edge back = m->half[mesh_twin(h)];
            real height = vec3_dot(d, b.hull.at[back.origin]);
            best = height > most ? back.origin : best;
            most = height > most ? height : most;
            h = back.next;
        } while (h != start);
        if (best == v) break;
        v = best;
    }
    return v;
}

// From so many vertices on climbing is quicker than to look at all.
enum { MANY = 48 };

static bool climbs(hull_mesh b)
{
    return b.hull.count >= MANY && b.mesh && b.mesh->vertices == b.hull.count;
}

// The corner of A - B furthest against v.  from: where to begin to climb.
static corner support(hull_mesh a, hull_mesh b, vec3 v, const corner *from)
{
    vec3 d = vec3_scale(-1, v);
    int i = climbs(a) ? climb(a, d, from->a) : scan(a.hull, d);
    int j = climbs(b) ? climb(b, v, from->b) : scan(b.hull, v);
    return (corner){ i, j, vec3_sub(a.hull.at[i], b.hull.at[j]) };
}

// The same of all vertices: a mesh is convex to 1e-9 of its size, and a climb
// may end in front of a dent that is no deeper.
static corner surest(hull_mesh a, hull_mesh b, vec3 v)
{
    const hull_mesh all[2] = { { a.hull, NULL }, { b.hull, NULL } };
    return support(all[0], all[1], v, NULL);
}
//<

//> search-simplex
// Of a simplex, the corner, edge or triangle nearest the origin.
typedef struct {
    int  count, of[4];  // which corners; 4: the origin is inside
    real weight[4];     // barycentric coordinates of v, of these corners
    vec3 v;             // m, its point nearest the origin
    bool is_thin;       // 4: rounding may have said so
} part;

static const vec3 ORIGIN = { 0, 0, 0 };
//<

//> search-edge
static void set_corner(part *p, const corner *c, int i)
{
    p->count = 1;
    p->of[0] = i;
    p->weight[0] = 1;
    p->v = c[i].at;
}

// Of the edge from the new corner k to the old one i.
static void part_of_edge(part *p, const corner *c, int i, int k)
{
    vec3 a = c[k].at, e = vec3_sub(c[i].at, a);
    real along = -vec3_dot(a, e), ee = vec3_dot(e, e);
    set_corner(p, c, along > 0 ? i : k);
    if (!(along > 0 && along < ee)) return;
    real t = along / ee;
    p->count = 2;
    p->of[1] = k;
    p->weight[0] = t;
    p->weight[1] = 1 - t;
    p->v = vec3_add_scaled(a, t, e);
}
//<

//> search-triangle
// Of the triangle of the new corner k and the old ones i, j.  With the edges
// e and f from k on, the point a + s e + t f is nearest the origin where it is
// perpendicular to both: two equations, solved by Cramer's rule.
static void part_of_triangle(part *p, const corner *c, int i, int j, int k)
{
    vec3 a = c[k].at, e = vec3_sub(c[i].at, a), f = vec3_sub(c[j].at, a);
    real ee = vec3_dot(e, e), ff = vec3_dot(f, f), ef = vec3_dot(e, f);
    real ae = -vec3_dot(a, e), af = -vec3_dot(a, f);
    real s = ae * ff - af * ef, t = af * ee - ae * ef, d = ee * ff - ef * ef;
    if (!((s > 0) & (t > 0) & (s + t < d))) {
        if (s > 0 && t > 0) part_of_edge(p, c, i, j);
        else if (s > 0 || (t <= 0 && ae > 0)) part_of_edge(p, c, i, k);
        else part_of_edge(p, c, j, k);
        return;
    }
    real share = 1 / d;
    s *= share, t *= share;
    p->count = 3;
    p->of[0] = i, p->of[1] = j, p->of[2] = k;
    p->weight[0] = s, p->weight[1] = t, p->weight[2] = 1 - s - t;
    p->v = vec3_add_scaled(vec3_add_scaled(a, s, e), t, f);
}
//<

//> search-tetrahedron
// A tetrahedron is thin where its volume, or the share of a corner in the point
// inside, is less than this part of what it could be.
static const real THIN = 1e-6;

// The face opposite to corner k, its newest corner last.
static const int FACE[4][3] = { { 1, 2, 3 }, { 2, 0, 3 }, { 0, 1, 3 },
                                { 0, 1, 2 } };

// Of the faces that the origin is beyond the nearest.  If it is beyond none it
// is inside, if it surely is.
static void part_of_tetrahedron(part *p, const corner *c)
{
    vec3 a = c[3].at, e[3];
    for (int k = 0; k < 3; k++) e[k] = vec3_sub(c[k].at, a);
    vec3 n = vec3_cross(e[1], e[2]);
    real volume = vec3_dot(e[0], n), share = -1 / volume, w[4];
    w[0] = share * vec3_dot(a, n);
    w[1] = share * vec3_dot(a, vec3_cross(e[2], e[0]));
    w[2] = share * vec3_dot(a, vec3_cross(e[0], e[1]));
    w[3] = 1 - w[0] - w[1] - w[2];
    real least = real_min(real_min(w[0], w[1]), real_min(w[2], w[3]));
    real nearest = HUGE_VAL;
    for (int k = 0; k < 4 && !(least > 0); k++) {
        if (w[k] > 0) continue;
        part now;
        part_of_triangle(&now, c, FACE[k][0], FACE[k][1], FACE[k][2]);
        real vv = vec3_dot(now.v, now.v);
        if (vv < nearest) nearest = vv, *p = now;
    }
    if (nearest < HUGE_VAL) return;
    p->is_thin = !(least > THIN) || !(volume * volume > THIN * THIN
        * vec3_dot(e[0], e[0]) * vec3_dot(e[1], e[1]) * vec3_dot(e[2], e[2]));
    p->count = 4;
    p->v = ORIGIN;
    for (int k = 0; k < 4; k++) p->of[k] = k, p->weight[k] = w[k];
}

static void nearest_part(part *p, const corner *c, int count)
{
    if (count == 4) part_of_tetrahedron(p, c);
    if (count == 3) part_of_triangle(p, c, 0, 1, 2);
    if (count == 2) part_of_edge(p, c, 0, 1);
    if (count == 1) set_corner(p, c, 0);
}
//<

//> search-step
// The mean of some vertices.
static vec3 middle(hull h)
{
    vec3 sum = ORIGIN;
    int step = 1 + h.count / 16, n = 0;
    for (int k = 0; k < h.count; k += step, n++) sum = vec3_add(sum, h.at[k]);
    return vec3_scale(1 / (real)n, sum);
}

// Keeps a part of the simplex.  Its corners are in the order of a cycle.
static void keep(corner *c, const part *p)
{
    corner x = c[p->of[0]];
    if (p->count == 1) { c[0] = x; return; }
    corner y = c[p->of[1]];
    if (p->count == 3) c[2] = c[p->of[2]];
    c[0] = x, c[1] = y;
}

//<

//> search-loop
enum { MOST_STEPS = 40 };

typedef enum { FOUND, BEYOND, INSIDE, UNSURE } ending;

// A search, from some corners on.
typedef struct {
    corner of[4];
    int    count, steps;
    part   now;
    real   vv, bound;   // m^2, |v|^2 and the least v . w
} search;

// What the corner w, furthest against v, says: that v is the nearest point, to
// a relative 1e-13 of its square; that all of A - B is further away than
// margin; or nothing yet.
static ending judged(const search *s, vec3 w, real margin)
{
    real bound = vec3_dot(s->now.v, w);
    if (bound > 0 && bound * bound > margin * margin * s->vv) return BEYOND;
    return s->vv - bound <= 1e-13 * s->vv ? FOUND : UNSURE;
}

// Are the bodies so near, or so far out, that their coordinates, like those of
// the corner c, may be rounded by more than a 10^-13th of their distance?
static bool is_doubtful(const search *s, hull a, const corner *c)
{
    vec3 at = a.at[c->a];
    real far = real_max(vec3_dot(at, at), vec3_dot(c->at, c->at));
    return !(s->vv > 1e-5 * far);
}

// What the furthest of all vertices says, unless rounding may have said it.
static ending proved(search *s, hull_mesh a, hull_mesh b, real margin)
{
    corner *w = &s->of[s->count];
    if (climbs(a) || climbs(b)) *w = surest(a, b, s->now.v);
    s->bound = vec3_dot(s->now.v, w->at);
    if (is_doubtful(s, a.hull, w)) return UNSURE;
    return judged(s, w->at, margin);
}

// Adds corners until one proves the end, or none brings v nearer.
static ending run(search *s, hull_mesh a, hull_mesh b, real margin)
{
    part *p = &s->now;
    nearest_part(p, s->of, s->count);
    s->vv = vec3_dot(p->v, p->v);
    if (p->count < 4 && is_doubtful(s, a.hull, &s->of[0])) return UNSURE;
    for (s->steps = 1; s->steps < MOST_STEPS; s->steps++) {
        s->count = p->count;
        if (p->count == 4) return p->is_thin ? UNSURE : INSIDE;
        keep(s->of, p);
        corner *w = &s->of[s->count];
        *w = support(a, b, p->v, w - 1);
        if (judged(s, w->at, margin) != UNSURE) return proved(s, a, b, margin);
        nearest_part(p, s->of, s->count + 1);
        real vv = vec3_dot(p->v, p->v);
        if (p->count < 4 && !(vv < s->vv)) return UNSURE;
        s->vv = vv;
    }
    return UNSURE;
}
//<

//> search-nearest
static void carry_on(search *s, hull_mesh a, hull_mesh b, const simplex *from)
{
    s->count = from->count;
    for (int k = 0; k < s->count; k++) {
        int i = from->of[k].a, j = from->of[k].b;
        s->of[k] = (corner){ i, j, vec3_sub(a.hull.at[i], b.hull.at[j]) };
    }
}

static void begin(search *s, hull_mesh a, hull_mesh b)
{
    vec3 d = vec3_sub(middle(a.hull), middle(b.hull));
    const corner first = { .a = 0 };
    s->of[s->count++] = support(a, b, d, &first);
}

// What the search found: not where it is unsure.
static gjk_result result_of(const search *s, ending end, hull a)
{
    gjk_result r;
    const part *p = &s->now;
    r.status = end == INSIDE ? GJK_OVERLAP : end == BEYOND ? GJK_BEYOND
                                                           : GJK_APART;
    real length = sqrt(s->vv);
    r.distance = end == INSIDE ? 0 : end == BEYOND ? s->bound / length : length;
    r.axis = r.last.v = p->v;
    r.on_a = ORIGIN;
    r.iterations = s->steps;
    r.last.count = s->count;
    for (int k = 0; k < 4; k++) {
        r.last.of[k] = s->of[k < s->count ? k : 0];
        r.last.weight[k] = k < s->count ? p->weight[k] : 0;
        if (k < s->count)
            r.on_a = vec3_add_scaled(r.on_a, p->weight[k], a.at[s->of[k].a]);
    }
    r.on_b = vec3_sub(r.on_a, r.axis);
    return r;
}

static void carry(simplex *to, const search *s)
{
    to->count = s->count;
    for (int k = 0; k < s->count; k++) to->of[k] = s->of[k];
}

gjk_result search_nearest(hull_mesh a, hull_mesh b, real margin,
                          simplex *carried)
{
    assert(a.hull.count >= 1 && b.hull.count >= 1 && margin >= 0);
    search s;
    s.count = 0;
    if (carried) carry_on(&s, a, b, carried);
    if (s.count == 0) begin(&s, a, b);
    ending end = run(&s, a, b, margin);
    if (carried) carry(carried, &s);
    if (end != UNSURE) return result_of(&s, end, a.hull);
    simplex last;
    carry(&last, &s);
    return gjk_search(a.hull, b.hull, margin, carried ? carried : &last);
}
//<

//> search-apart
// Is all of A - B further along d than margin, beyond what rounding may hide?
static bool separates(hull_mesh a, hull_mesh b, vec3 d, real margin, corner *w)
{
    *w = surest(a, b, d);
    vec3 p = a.hull.at[w->a], q = b.hull.at[w->b];
    real far = fabs(p.x) + fabs(p.y) + fabs(p.z)
             + fabs(q.x) + fabs(q.y) + fabs(q.z);
    return vec3_dot(d, w->at) > (margin + 0x1p-50 * far) * vec3_length(d);
}

bool search_apart(hull_mesh a, hull_mesh b, real margin, vec3 *axis)
{
    assert(a.hull.count >= 1 && b.hull.count >= 1 && margin >= 0);
    search s;
    s.count = 1;
    vec3 d = *axis;
    if (!(vec3_dot(d, d) > 0)) d = vec3_sub(middle(a.hull), middle(b.hull));
    if (separates(a, b, d, margin, &s.of[0])) {
        *axis = d;
        return true;
    }
    ending end = run(&s, a, b, margin);
    if (end == INSIDE) return false;
    if (end == FOUND || end == BEYOND) {
        *axis = s.now.v;
        return s.bound > margin * sqrt(s.vv);
    }
    simplex last;
    carry(&last, &s);
    gjk_result g = gjk_search(a.hull, b.hull, margin, &last);
    if (vec3_dot(g.axis, g.axis) > 0) *axis = g.axis;
    return g.status == GJK_BEYOND
        || (g.status == GJK_APART && g.distance > margin);
}
//<
