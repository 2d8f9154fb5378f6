//> search-simplex
// search.c - see search.h.

#include "search.h"

#include <assert.h>
#include <stddef.h>

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
//>   A part of a simplex is a corner, an edge or a triangle of it.
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
    real fraction = 1 / d;
    s *= fraction, t *= fraction;
    p->count = 3;
    p->of[0] = i, p->of[1] = j, p->of[2] = k;
    p->weight[0] = s, p->weight[1] = t, p->weight[2] = 1 - s - t;
    p->v = vec3_add_scaled(vec3_add_scaled(a, s, e), t, f);
}
//<

//> search-tetrahedron
//>   Of a tetrahedron, only the faces that the origin is beyond are tried.
//>   Mostly it is one. If it is beyond none, it is inside, and the bodies
//>   overlap.
// A tetrahedron is thin where its volume, or the share of a corner in the point
// inside, is less than this part of what it could be.
static const real THIN_SIMPLEX = 1e-6;

// The face opposite to corner k, its newest corner last.
static const int FACE[4][3] = { { 1, 2, 3 }, { 2, 0, 3 }, { 0, 1, 3 },
                                { 0, 1, 2 } };

// Of the faces that the origin is beyond the nearest: w[k] <= 0.
static bool nearest_face(part *p, const corner *c, const int of[4],
                         const real w[4])
{
    part other, *to = p;
    for (int k = 0; k < 4; k++) {
        if (w[k] > 0) continue;
        const int *f = FACE[k];
        part_of_triangle(to, c, of[f[0]], of[f[1]], of[f[2]]);
        if (to == &other && vec3_dot(other.v, other.v) < vec3_dot(p->v, p->v))
            *p = other;
        to = &other;
    }
    return to == &other;
}

// If the origin is beyond no face it is inside, if it surely is.
static void part_of_tetrahedron(part *p, const corner *c, const int of[4])
{
    vec3 a = c[of[3]].at, e[3];
    for (int k = 0; k < 3; k++) e[k] = vec3_sub(c[of[k]].at, a);
    vec3 n = vec3_cross(e[1], e[2]);
    real volume = vec3_dot(e[0], n), fraction = -1 / volume, w[4];
    w[0] = fraction * vec3_dot(a, n);
    w[1] = fraction * vec3_dot(a, vec3_cross(e[2], e[0]));
    w[2] = fraction * vec3_dot(a, vec3_cross(e[0], e[1]));
    w[3] = 1 - w[0] - w[1] - w[2];
    if (nearest_face(p, c, of, w)) return;
    real least = real_min(real_min(w[0], w[1]), real_min(w[2], w[3]));
    p->is_thin = !(least > THIN_SIMPLEX)
              || !(volume * volume > THIN_SIMPLEX * THIN_SIMPLEX
                * vec3_dot(e[0], e[0]) * vec3_dot(e[1], e[1]) * vec3_dot(e[2], e[2]));
    p->count = 4;
    p->v = ORIGIN;
    for (int k = 0; k < 4; k++) p->of[k] = of[k], p->weight[k] = w[k];
}

// Of the corners of[0] to of[count - 1], the newest last.
static void nearest_part(part *p, const corner *c, const int *of, int count)
{
    if (count == 4) part_of_tetrahedron(p, c, of);
    if (count == 3) part_of_triangle(p, c, of[0], of[1], of[2]);
    if (count == 2) part_of_edge(p, c, of[0], of[1]);
    if (count == 1) set_corner(p, c, of[0]);
}
//<

//> search-step
// A search.  Corners stay where they are put; a part names them by their place.
typedef struct {
    const hull_mesh *a, *b;
    corner at[4];
    part   parts[2], *now, *next;   // the nearest part so far, and a nearer one
    int    steps;
    real   vv, bound;   // m^2, |v|^2 and the least v . w
} search;

static void begin_search(search *s, const hull_mesh *a, const hull_mesh *b)
{
    s->a = a, s->b = b;
    s->now = &s->parts[0], s->next = &s->parts[1];
    s->now->count = 0;
}

// A place that no corner of the nearest part has.
static int free_place(const part *p)
{
    static const int FREE[8] = { 0, 1, 0, 2, 0, 1, 0, 3 };
    int taken = 0;
    for (int k = 0; k < p->count; k++) taken |= 1 << p->of[k];
    return FREE[taken & 7];
}

// Of vertices i of A and j of B.
static void set(const search *s, corner *w, int i, int j)
{
    w->a = i, w->b = j;
    w->at = vec3_sub(s->a->hull.at[i], s->b->hull.at[j]);
}

// The corner of A - B furthest against v.  from: where to begin to climb.
static void support(const search *s, vec3 v, const corner *from, corner *w)
{
    vec3 d = vec3_scale(-1, v);
    set(s, w, hull_climb(s->a, d, from->a), hull_climb(s->b, v, from->b));
}

// The same of all vertices: a mesh is convex to 1e-9 of its size, and a climb
// may end in front of a dent that is no deeper.
static void surest(const search *s, vec3 v, corner *w)
{
    set(s, w, hull_scan(s->a->hull, vec3_scale(-1, v)), hull_scan(s->b->hull, v));
}

// The mean of some vertices.
static vec3 mean_of_some(hull h)
{
    vec3 sum = ORIGIN;
    int step = 1 + h.count / 16, n = 0;
    for (int k = 0; k < h.count; k += step, n++) sum = vec3_add(sum, h.at[k]);
    return vec3_scale(1 / (real)n, sum);
}

static vec3 between_middles(const search *s)
{
    return vec3_sub(mean_of_some(s->a->hull), mean_of_some(s->b->hull));
}
//<

//> search-loop
enum { MOST_STEPS = 40 };

typedef enum { FOUND, BEYOND, INSIDE, UNSURE } ending;

// What the corner w, furthest against v, says: that v is the nearest point, to
// a relative 1e-13 of its square; that all of A - B is further away than
// margin; or nothing yet.
static ending judged(const search *s, vec3 w, real margin)
{
    real bound = vec3_dot(s->now->v, w);
    if (bound > 0 && bound * bound > margin * margin * s->vv) return BEYOND;
    return s->vv - bound <= 1e-13 * s->vv ? FOUND : UNSURE;
}

// Are the bodies so near, or so far out, that their coordinates, like those of
// the corner c, may be rounded by more than a 10^-13th of their distance?
static bool is_doubtful(const search *s, const corner *c, real vv)
{
    vec3 at = s->a->hull.at[c->a];
    real far = real_max(vec3_dot(at, at), vec3_dot(c->at, c->at));
    return !(vv > 1e-5 * far);
}

// What the furthest of all vertices says, unless rounding may have said it.
static ending proved(search *s, corner *w, real margin)
{
    if (hull_climbs(s->a) || hull_climbs(s->b)) surest(s, s->now->v, w);
    s->bound = vec3_dot(s->now->v, w->at);
    if (is_doubtful(s, w, s->vv)) return UNSURE;
    return judged(s, w->at, margin);
}

// The nearest part of so many corners becomes the one of now, if it is nearer.
static bool takes_nearer(search *s, int count)
{
    nearest_part(s->next, s->at, s->now->of, count);
    part *p = s->next;
    real vv = vec3_dot(p->v, p->v);
    if (p->count < 4 && !(vv < s->vv)) return false;
    s->next = s->now, s->now = p, s->vv = vv;
    return true;
}

// Adds corners until one proves the end, or none brings v nearer.
static ending run(search *s, real margin)
{
    s->vv = HUGE_VAL;
    const corner *first = &s->at[s->now->of[0]];
    if (!takes_nearer(s, s->now->count)) return UNSURE;
    if (s->now->count < 4 && is_doubtful(s, first, s->vv)) {
        s->now = s->next;       // chapter 4 goes on from all corners
        return UNSURE;
    }
    for (s->steps = 1; s->steps < MOST_STEPS; s->steps++) {
        part *p = s->now;
        if (p->count == 4) return p->is_thin ? UNSURE : INSIDE;
        int place = free_place(p);
        corner *w = &s->at[place];
        support(s, p->v, &s->at[p->of[p->count - 1]], w);
        if (judged(s, w->at, margin) != UNSURE) return proved(s, w, margin);
        p->of[p->count] = place;
        if (!takes_nearer(s, p->count + 1)) return UNSURE;
    }
    return UNSURE;
}
//<

//> search-start
//>   A search begins with the corners of the last one. If there are none, each
//>   body is asked for what it has furthest towards the other: a small one for
//>   two vertices, which takes one scan, as for one. They make a triangle of
//>   corners, mostly near the answer.
static void add_vertex(search *s, int i, int j)
{
    part *p = s->now;
    set(s, &s->at[p->count], i, j);
    p->of[p->count] = p->count;
    p->count++;
}

// The vertex furthest along d, and the next; a single one is both.
static void scan_two(hull h, vec3 d, int of[2])
{
    real most = vec3_dot(d, h.at[0]), next = -HUGE_VAL;
    of[0] = of[1] = 0;
    for (int k = 1; k < h.count; k++) {
        real height = vec3_dot(d, h.at[k]);
        if (height > most) {
            next = most, of[1] = of[0];
            most = height, of[0] = k;
        } else if (height > next) {
            next = height, of[1] = k;
        }
    }
}

// The corner between the two middles comes last, as the newest.
static void start_cold(search *s)
{
    vec3 d = between_middles(s);
    int i[2], j[2];
    if (hull_climbs(s->a) || hull_climbs(s->b)) {
        corner w;
        surest(s, d, &w);
        add_vertex(s, w.a, w.b);
        return;
    }
    scan_two(s->a->hull, vec3_scale(-1, d), i);
    scan_two(s->b->hull, d, j);
    if (i[1] != i[0]) add_vertex(s, i[1], j[0]);
    if (j[1] != j[0]) add_vertex(s, i[0], j[1]);
    add_vertex(s, i[0], j[0]);
}

static void start(search *s, const simplex *from)
{
    for (int k = 0; from && k < from->count; k++)
        add_vertex(s, from->of[k].a, from->of[k].b);
    if (s->now->count == 0) start_cold(s);
}
//<

//> search-nearest
//>   Then `gjk_search` goes on, which is `gjk_distance` without the test of the
//>   range, from the simplex of the quick search. So an answer is either proven
//>   here or given by chapter 04.
// What the search found: not where it is unsure.
static gjk_result search_result(const search *s, ending end)
{
    gjk_result r;
    const part *p = s->now;
    r.status = end == INSIDE ? GJK_OVERLAP : end == BEYOND ? GJK_BEYOND
                                                           : GJK_APART;
    real length = sqrt(s->vv);
    r.distance = end == INSIDE ? 0 : end == BEYOND ? s->bound / length : length;
    r.axis = r.last.v = p->v;
    r.on_a = ORIGIN;
    r.iterations = s->steps;
    r.wide = false;
    r.last.count = p->count;
    for (int k = 0; k < 4; k++) {
        r.last.of[k] = s->at[p->of[k < p->count ? k : 0]];
        r.last.weight[k] = k < p->count ? p->weight[k] : 0;
        if (k < p->count)
            r.on_a = vec3_add_scaled(r.on_a, p->weight[k],
                                     s->a->hull.at[r.last.of[k].a]);
    }
    r.on_b = vec3_sub(r.on_a, r.axis);
    return r;
}

static void carry_simplex(simplex *to, const search *s)
{
    to->count = s->now->count;
    for (int k = 0; k < to->count; k++) to->of[k] = s->at[s->now->of[k]];
}

gjk_result search_nearest(const hull_mesh *a, const hull_mesh *b, real margin,
                          simplex *carried)
{
    assert(a->hull.count >= 1 && b->hull.count >= 1 && margin >= 0);
    search s;
    begin_search(&s, a, b);
    start(&s, carried);
    ending end = run(&s, margin);
    if (carried) carry_simplex(carried, &s);
    if (end != UNSURE) return search_result(&s, end);
    simplex last;
    carry_simplex(&last, &s);
    return gjk_search(a->hull, b->hull, margin, carried ? carried : &last);
}
//<

//> search-heights
//>   The heights of two bodies along an axis, for the bare question of chapter 10.
hull_mesh hull_bare(hull h)
{
    real most = 0;
    for (int k = 1; k < h.count; k++)
        most = real_max(most, vec3_distance(h.at[k], h.at[0]));
    return (hull_mesh){ .hull = h, .size = 2 * most };
}

// By how much a vertex of b may be higher along d than v, where a climb ended.
// A mesh is convex to 1e-9 of its size, and its place is rounded: no vertex is
// further above the plane of a face than `uneven`.  Let c, a point of b, lie below
// v and at least r below all planes of the faces at v.  If x is a vertex, the
// point p = c + s (x - c) with s = r / (r + uneven) is above none of the planes.
// So it is no higher than v, because the edges from v lead down, and c is below.
// Then x is higher than v by no more than uneven / r of what c is lower.  The
// sine of a face's angle makes r less if edges lead down by rounding.  Where
// r, or what c is lower, is no more than rounding, nothing is proved.
static real dent(const hull_mesh *b, vec3 d, int v)
{
    const mesh *m = b->mesh;
    const vec3 *at = b->hull.at;
    vec3 up = vec3_sub(at[v], mean_of_some(b->hull));
    real r = HUGE_VAL, far = vec3_length(at[v]) + b->size;
    int h = m->vertex_half[v], start = h;
    do {
        vec3 e = vec3_sub(at[mesh_target(m, h)], at[v]);
        h = mesh_around(m, h);
        vec3 f = vec3_sub(at[mesh_target(m, h)], at[v]);
        real sides = sqrt(vec3_dot(e, e) * vec3_dot(f, f));
        r = real_min(vec3_dot(vec3_cross(f, e), up) / sides, r);
    } while (h != start);
    real uneven = 2e-9 * b->size + 0x1p-49 * far, low = vec3_dot(d, up);
    bool is_below = r > 2 * uneven && low > uneven * vec3_length(d);
    return is_below ? uneven / (r - uneven) * low : HUGE_VAL;
}

// A height along d that no vertex of b is above, but for rounding.
static real highest(hull h, vec3 d)
{
    real most = vec3_dot(d, h.at[0]);
    for (int k = 1; k < h.count; k++)
        most = real_max(vec3_dot(d, h.at[k]), most);
    return most;
}

// The same of a body that climbs.  v: a vertex to begin with, or -1: then all are
// looked at.  Receives the highest.
static real climbed(const hull_mesh *b, vec3 d, int *v)
{
    bool is_known = *v >= 0;
    *v = is_known ? hull_climb(b, d, *v) : hull_scan(b->hull, d);
    return vec3_dot(d, b->hull.at[*v]) + (is_known ? dent(b, d, *v) : 0);
}

static inline real top(const hull_mesh *b, vec3 d, int *v)
{
    return hull_climbs(b) ? climbed(b, d, v) : highest(b->hull, d);
}

// m, no vertex of b is further from the origin.
static real furthest_out(const hull_mesh *b)
{
    vec3 x = b->hull.at[0];
    return fabs(x.x) + fabs(x.y) + fabs(x.z) + b->size;
}
//<

//> search-apart
// Is all of A - B further along the axis than margin, beyond what rounding may
// hide?
static bool separates(const hull_mesh *a, const hull_mesh *b, real margin,
                      separating_axis *s)
{
    real gap = -top(a, vec3_scale(-1, s->axis), &s->a)
             - top(b, s->axis, &s->b);
    real far = furthest_out(a) + furthest_out(b);
    return gap > (margin + 0x1p-50 * far) * vec3_length(s->axis);
}

bool search_apart(const hull_mesh *a, const hull_mesh *b, real margin,
                  separating_axis *carried)
{
    assert(a->hull.count >= 1 && b->hull.count >= 1 && margin >= 0);
    search s;
    begin_search(&s, a, b);
    if (!(vec3_dot(carried->axis, carried->axis) > 0))
        *carried = (separating_axis){ between_middles(&s), -1, -1 };
    if (separates(a, b, margin, carried)) return true;
    corner w = { .a = carried->a, .b = carried->b };
    support(&s, carried->axis, &w, &s.at[0]);
    s.now->of[s.now->count++] = 0;
    ending end = run(&s, margin);
    if (end == INSIDE) return false;
    w = s.at[s.now->of[0]];
    if (end == FOUND || end == BEYOND) {
        *carried = (separating_axis){ s.now->v, w.a, w.b };
        return s.bound > margin * sqrt(s.vv);
    }
    simplex last;
    carry_simplex(&last, &s);
    gjk_result g = gjk_search(a->hull, b->hull, margin, &last);
    if (vec3_dot(g.axis, g.axis) > 0)
        *carried = (separating_axis){ g.axis, w.a, w.b };
    return g.status == GJK_BEYOND
        || (g.status == GJK_APART && g.distance > margin);
}
//<
