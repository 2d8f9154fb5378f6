//> manifold-view
//>   First the view: two axes across the normal. Its origin is the place where
//>   B is nearest, so that nothing is lost far out.
#include "manifold.h"

#include <assert.h>
#include <stddef.h>

// Both bodies as seen along the normal: x and y lie across it, z along it.
typedef struct {
    vec3 x, y, z;       // unit, a right-handed frame
    vec3 origin;        // m, in the world: where B is nearest
    real slack;         // m, what rounding may move: nearer counts as touching
} view;

static vec3 project_on_view(const view *w, vec3 p)
{
    vec3 r = vec3_sub(p, w->origin);
    return vec3_make(vec3_dot(r, w->x), vec3_dot(r, w->y), vec3_dot(r, w->z));
}

// A coordinate is known to 2^-53 of its distance from the world's origin, and
// what is computed here to a few 2^-53 of the larger body.
static view view_along(vec3 normal, vec3 origin, real size)
{
    vec3 across = fabs(normal.x) < 0.6 ? vec3_make(1, 0, 0)
                                       : vec3_make(0, 1, 0);
    view w = { .z = normal, .origin = origin };
    w.x = vec3_unit(vec3_cross(across, normal));
    w.y = vec3_cross(normal, w.x);
    w.slack = 0x1p-30 * size
            + 0x1p-48 * (fabs(origin.x) + fabs(origin.y) + fabs(origin.z));
    return w;
}
//<

//> manifold-patch
enum { PATCH_CORNERS = 32 };    // a rounder side is drawn with so many

// What one body turns towards the other: a vertex, an edge, or some faces, of
// which the convex polygon that they cover is kept.
typedef struct {
    const struct shape *shape;
    const vec3  *at;
    vec3 ahead;         // unit, towards the other body
    real lean;          // sine squared, of the face that may begin it
    vec3 side;          // unit, the normal of that face
    real turn;          // 1 if corners run counter-clockwise in the view, -1
    int  tip;           // the vertex where the body is nearest
    int  half, face;    // from it, into a face of the patch; -1: no face
    int  end;           // where an edge leads from it; -1: no edge
    int  count;         // corners
    int  vertex[PATCH_CORNERS];
    vec3 corner[PATCH_CORNERS];     // m, as seen
    vec3 inward[PATCH_CORNERS];     // unit, x and y: from edge k, which goes
                                    // from corner k to the next, inwards
} patch;

static int next_corner(const patch *p, int k)
{
    return k + 1 < p->count ? k + 1 : 0;
}

// v x w, of their x and y.
static real cross2(vec3 v, vec3 w)
{
    return v.x * w.y - v.y * w.x;
}

static real dot2(vec3 v, vec3 w)
{
    return v.x * w.x + v.y * w.y;
}
//<

//> manifold-look
//>   Does a face belong to the patch? This is the rule of 8 degrees, in
//>   squares.
// The sine, squared, of 8 degrees and what the bodies turn against each other
// (rad) while the touches are to be used: a face that will lie flat by then may
// begin the patch.
static real lean_squared(real turn)
{
    real t = real_min(turn, 0.5), sine = t - t * t * t / 6;
    real cosine = 1 - t * t / 2 + t * t * t * t / 24;
    real lean = LEAN_SINE * cosine + sqrt(1 - LEAN_SINE * LEAN_SINE) * sine;
    return lean * lean;
}

vec3 face_area(const shape *s, const vec3 *at, int f)
{
    const int *v = &s->face[3 * f];
    return vec3_cross(vec3_sub(at[v[1]], at[v[0]]),
                      vec3_sub(at[v[2]], at[v[0]]));
}

// The square of a face's normal, and of its part along d (0 if it looks away):
// their ratio is the cosine of the angle between the two, squared.
typedef struct {
    real whole, along;
} cosine_parts;

static cosine_parts face_cosine(const shape *s, const vec3 *at, int f, vec3 d)
{
    vec3 m = face_area(s, at, f);
    real along = vec3_dot(m, d);
    return (cosine_parts){ vec3_dot(m, m), along > 0 ? along * along : 0 };
}

int face_is_along(const shape *s, const vec3 *at, int f, vec3 d)
{
    cosine_parts l = face_cosine(s, at, f, d);
    return l.along > 0 && l.along >= (1 - LEAN_SINE * LEAN_SINE) * l.whole;
}

// Does the face to the left of half-edge h belong to the patch?  A side may be of
// many triangles, which lie in one plane up to what its points are off.  But a rim
// of flat sides is no side: of a drum on three of them the outer corners are kept,
// and it sinks between these, as it would by turning, by no more than the square of
// MANIFOLD_TURN times its radius: a quarter of a per cent.
static int belongs(const patch *p, int h)
{
    int f = p->shape->mesh.half[h].face;
    if (f < 0) return 0;
    cosine_parts l = face_cosine(p->shape, p->at, f, p->side);
    return l.along > 0 && l.along >= (1 - MANIFOLD_TURN * MANIFOLD_TURN) * l.whole;
}
//<

//> manifold-corners
// How far corner k stands out from the line between its neighbours: the height
// of a triangle is twice its area over its base.  Both squared, with the sign
// of the area (< 0: the corner turns inwards).
static real stands_out(const patch *p, int k, real *base_squared)
{
    vec3 before = p->corner[k > 0 ? k - 1 : p->count - 1];
    vec3 base = vec3_sub(p->corner[next_corner(p, k)], before);
    real area = -p->turn * cross2(base, vec3_sub(p->corner[k], before));
    *base_squared = dot2(base, base);
    return area * fabs(area);
}

// Of the corners first to last the one that stands out least.
static int flattest(const patch *p, int first, int last)
{
    int best = first;
    real least = HUGE_VAL;
    for (int k = first; k <= last; k++) {
        real base, area = stands_out(p, k, &base);
        real height = base > 0 ? area / base : 0;
        if (height < least) { least = height; best = k; }
    }
    return best;
}

static int has_flat_corner(const patch *p, real slack)
{
    for (int k = 0; k < p->count; k++) {
        real base, area = stands_out(p, k, &base);
        if (area <= slack * slack * base) return 1;
    }
    return 0;
}
//<

//> manifold-add
//>   There is room for 32 corners. A new one pushes out the flattest.
static void patch_drop(patch *p, int k)
{
    p->count--;
    for (; k < p->count; k++) {
        p->vertex[k] = p->vertex[k + 1];
        p->corner[k] = p->corner[k + 1];
    }
}

// One corner more.  If there is no room, the flattest of those between the
// first and the last makes some.
static void patch_add(patch *p, int vertex, const view *w)
{
    if (p->count == PATCH_CORNERS)
        patch_drop(p, flattest(p, 1, p->count - 2));
    p->vertex[p->count] = vertex;
    p->corner[p->count++] = project_on_view(w, p->at[vertex]);
}

// Leaves only corners that stand out, and finds the edges' inward normals.
static void patch_close(patch *p, const view *w)
{
    while (p->count > 2 && has_flat_corner(p, w->slack))
        patch_drop(p, flattest(p, 0, p->count - 1));
    for (int k = 0; k < p->count; k++) {
        vec3 e = vec3_sub(p->corner[next_corner(p, k)], p->corner[k]);
        real length = sqrt(dot2(e, e)), s = length > 0 ? p->turn / length : 0;
        p->inward[k] = vec3_make(-s * e.y, s * e.x, 0);
    }
}
//<

//> manifold-rim
// A half-edge of the patch's rim: its left face belongs to the patch, the right
// one does not.  h leaves some vertex of the patch, with a face of it on its
// left.  We turn clockwise from face to face.  If the patch goes all around the
// vertex, we go on from the neighbour furthest in x, and again, until there is
// nothing further: so there is a rim.  -1 if rounding says otherwise.
static int rim_find(const patch *p, const view *w, int h)
{
    const mesh *m = &p->shape->mesh;
    for (int step = 0; step < p->shape->particles; step++) {
        int start = h, best = -1;
        real most = vec3_dot(p->at[m->half[h].origin], w->x);
        do {
            if (!belongs(p, mesh_twin(h))) return h;
            real x = vec3_dot(p->at[m->half[mesh_twin(h)].origin], w->x);
            if (x > most) { most = x; best = h; }
            h = m->half[mesh_twin(h)].next;
        } while (h != start);
        if (best < 0) break;
        h = mesh_twin(best);
    }
    return -1;
}

// Once along the rim.  A half-edge on it gives a corner, and leads to the next
// one of its face; from one inside we step over to the face beyond.
static void rim_walk(patch *p, const view *w, int start)
{
    const mesh *m = &p->shape->mesh;
    int h = start;
    for (int step = 0; step < 2 * m->edges; step++) {
        if (belongs(p, mesh_twin(h))) {
            h = m->half[mesh_twin(h)].next;
        } else {
            patch_add(p, m->half[h].origin, w);
            h = m->half[h].next;
        }
        if (h == start) return;
    }
}

// Once along the rim of the patch, from half-edge h of one of its faces.
static void patch_walk(patch *p, const view *w, int h)
{
    int start = rim_find(p, w, h);
    if (start >= 0) rim_walk(p, w, start);
}
//<

//> manifold-edge
//>   An edge may go on straight over several vertices. Its patch ends where it
//>   turns.
// The end of the edge that goes from vertex `from` to `to`, and straight on
// over further vertices, as far as rounding can tell (slack, m).
static int edge_end(const patch *p, int from, int to, real slack)
{
    const mesh *m = &p->shape->mesh;
    vec3 d = vec3_sub(p->at[to], p->at[from]);
    int h = m->vertex_half[to], start = h;
    for (int step = 0; step < m->vertices; ) {
        int next = mesh_target(m, h);
        vec3 e = vec3_sub(p->at[next], p->at[to]), off = vec3_cross(d, e);
        h = mesh_around(m, h);
        if (vec3_dot(d, e) > 0
            && vec3_dot(off, off) <= slack * slack * vec3_dot(d, d)) {
            to = next;
            h = start = m->vertex_half[to];
            step++;
        } else if (h == start) {
            break;
        }
    }
    return to;
}
//<

//> manifold-ahead
//>   Which kind of patch is it? A look at the faces and edges around the
//>   nearest vertex decides.
// Of the faces at vertex v, the one that looks ahead best, as the half-edge of
// it that leaves v; -1: none looks ahead.
static int face_ahead(const patch *p, int v)
{
    const mesh *m = &p->shape->mesh;
    int start = m->vertex_half[v], h = start, best = -1;
    cosine_parts most = { 1, 1 - p->lean };
    if (start < 0) return -1;
    do {
        int f = m->half[h].face;
        cosine_parts l = { 0, 0 };
        if (f >= 0) l = face_cosine(p->shape, p->at, f, p->ahead);
        if (l.along * most.whole > most.along * l.whole) {
            most = l;
            best = h;
        }
        h = m->half[mesh_twin(h)].next;
    } while (h != start);
    return best;
}

// Of the edges at vertex v, the one that lies flattest across the normal, if it
// leans by less than 8 degrees, as the vertex that it leads to; -1: none.
static int edge_across(const patch *p, int v)
{
    const mesh *m = &p->shape->mesh;
    real least = p->lean;
    int start = m->vertex_half[v], h = start, best = -1;
    if (start < 0) return -1;
    do {
        vec3 e = vec3_sub(p->at[mesh_target(m, h)], p->at[v]);
        real up = vec3_dot(e, p->ahead), lean = up * up / vec3_dot(e, e);
        if (lean < least) { least = lean; best = mesh_target(m, h); }
        h = mesh_around(m, h);
    } while (h != start);
    return best;
}
//<

//> manifold-find-patch
//>   Most pairs in a pile of icosahedra are a vertex and a face. For them that
//>   look settles everything, and no polygon is drawn. So `patch_begin` comes
//>   first for both bodies, and `patch_draw` only where it is needed.
// The vertex that carries most of f: none lies nearer the other body.
static int main_vertex(const feature_point *f)
{
    int best = 0;
    for (int k = 1; k < f->count; k++)
        if (f->weight[k] > f->weight[best]) best = k;
    return f->vertex[best];
}

// What does the body turn towards the other where it is nearest?  turn: -1 for
// A, whose faces look away from the viewer, 1 for B.  Returns 0 for no more
// than a vertex.
static int patch_begin(patch *p, const collider *body, real turn,
                       const view *w, const feature_point *nearest,
                       real turns)
{
    p->lean = lean_squared(turns);
    p->shape = body->shape;
    p->at = body->at;
    p->ahead = vec3_scale(turn, w->z);
    p->turn = turn;
    p->count = 0;
    p->tip = main_vertex(nearest);
    p->half = face_ahead(p, p->tip);
    p->face = p->half < 0 ? -1 : p->shape->mesh.half[p->half].face;
    p->end = p->half < 0 ? edge_across(p, p->tip) : -1;
    if (p->half >= 0) 
        p->side = vec3_unit(face_area(p->shape, p->at, p->face));
    return p->half >= 0 || p->end >= 0;
}

// Its corners.
static void patch_draw(patch *p, const view *w)
{
    if (p->half >= 0) {
        patch_walk(p, w, p->half);
    } else {
        patch_add(p, edge_end(p, p->end, p->tip, w->slack), w);
        patch_add(p, edge_end(p, p->tip, p->end, w->slack), w);
    }
    patch_close(p, w);
}
//<

//> manifold-bulge
// A patch bulges if a corner of it lies behind the plane of the face that begins
// it, by more than rounding.  Then the body comes to rest on that face, which may
// lie in the middle of the patch.  `middle` gets the corners of that face; it has
// none if the patch is flat.
static void patch_middle(patch *middle, const patch *p, const view *w)
{
    bool bulges = false;
    middle->count = 0;
    for (int k = 0; k < p->count && p->half >= 0; k++) {
        vec3 d = vec3_sub(p->at[p->vertex[k]], p->at[p->tip]);
        bulges |= vec3_dot(d, p->side) < -64 * w->slack;
    }
    if (!bulges) return;
    *middle = *p;
    middle->count = 0;
    for (int k = 0; k < 3; k++)
        patch_add(middle, p->shape->face[3 * p->face + k], w);
    patch_close(middle, w);
}
//<

//> manifold-foot
//>   Now the foot of a corner. Over which triangle of B does a vertex of A
//>   stand, and with which weights? We measure one triangle.
// A face, and where a point lies in it, as seen.
typedef struct {
    int  face;
    int  least;         // of its vertices, the one with the least weight
    int  outside;       // 1: the point is beyond the edge across from it
    real area;          // m^2, twice; has the sign of the patch's turn, or the
                        // face looks away
    real weight[3];
    real z;             // m, of the point
} footing;

// With the corners at e0, e1, e2 from the point, the weight of each is the area
// that the other two span with the point: e1 x e2, e2 x e0, e0 x e1, over the
// sum of all three.  A point that rounding may have put outside is not, or the
// search would go on to a face that is seen from its edge, and has no weights.
static void footing_in(footing *g, const patch *p, const view *w, int f,
                       vec3 point)
{
    const int *v = &p->shape->face[3 * f];
    vec3 e0 = vec3_sub(project_on_view(w, p->at[v[0]]), point);
    vec3 e1 = vec3_sub(project_on_view(w, p->at[v[1]]), point);
    vec3 e2 = vec3_sub(project_on_view(w, p->at[v[2]]), point);
    real a0 = cross2(e1, e2), a1 = cross2(e2, e0), a2 = cross2(e0, e1);
    real area = a0 + a1 + a2, s = 1 / area;
    real w0 = s * a0, w1 = s * a1, w2 = s * a2, least = w0 < w1 ? w0 : w1;
    int k = w2 < least ? 2 : w1 < w0;
    vec3 side = k == 0 ? vec3_sub(e2, e1)
              : k == 1 ? vec3_sub(e0, e2) : vec3_sub(e1, e0);
    real off = -p->turn * (k == 0 ? a0 : k == 1 ? a1 : a2);
    real may = 4 * w->slack;
    g->face = f;
    g->least = k;
    g->outside = off > 0 && off * off > may * may * dot2(side, side);
    g->area = area;
    g->weight[0] = w0;
    g->weight[1] = w1;
    g->weight[2] = w2;
    g->z = point.z + (w0 * e0.z + w1 * e1.z + w2 * e2.z);
}
//<

//> manifold-foot-find
//>   We know one triangle of the patch, and walk: out over the edge that the
//>   point is furthest outside of, and again.
// The face on the other side of the edge across from vertex k of face f.
static int face_across(const patch *p, int f, int k)
{
    const mesh *m = &p->shape->mesh;
    int h = m->face_half[f];
    for (int i = (k + 1) % 3; i > 0; i--) h = m->half[h].next;
    return m->half[mesh_twin(h)].face;
}

// The face of the body that lies under (or over) the point.  From face f of
// the patch we cross the edge that the point is furthest outside of, until it
// is outside of none, or there is nothing but the body's back beyond.
static footing footing_find(const patch *p, const view *w, int f, vec3 point)
{
    footing g, beyond;
    footing_in(&g, p, w, f, point);
    for (int step = 0; step < p->shape->mesh.faces; step++) {
        if (!g.outside) break;
        f = face_across(p, g.face, g.least);
        if (f < 0) break;
        footing_in(&beyond, p, w, f, point);
        if (!(beyond.area * p->turn > 0)) break;
        g = beyond;
    }
    return g;
}
//<

//> manifold-feature
// Corner k of the patch.
static feature_point at_corner(const patch *p, int k)
{
    return (feature_point){ 1, { p->vertex[k] }, { 1 } };
}

// The point at part t of the way from one vertex to another.
static feature_point between(int from, int to, real t)
{
    if (t == 0) return (feature_point){ 1, { from }, { 1 } };
    if (t == 1) return (feature_point){ 1, { to }, { 1 } };
    return (feature_point){ 2, { from, to }, { 1 - t, t } };
}

// The same on edge k of the patch.
static feature_point at_edge(const patch *p, int k, real t)
{
    return between(p->vertex[k], p->vertex[next_corner(p, k)], t);
}

// Its height.
static real edge_z(const patch *p, int k, real t)
{
    real from = p->corner[k].z, to = p->corner[next_corner(p, k)].z;
    return from + t * (to - from);
}

// Which part of the way is nearest to the point, 0 to 1?
static real part_between(vec3 from, vec3 to, vec3 point)
{
    vec3 e = vec3_sub(to, from);
    real t = dot2(vec3_sub(point, from), e) / dot2(e, e);
    return t > 0 ? (t < 1 ? t : 1) : 0;
}
//<

//> manifold-foot-feature
//>   A point that is outside by less is drawn in to the rim.
// A point just outside face f, across from its vertex k, is drawn in to the
// edge there.
static void at_rim(feature_point *f, const patch *p, const view *w, int face,
                   int k, vec3 point, real *z)
{
    const int *v = &p->shape->face[3 * face];
    int from = v[(k + 1) % 3], to = v[(k + 2) % 3];
    vec3 x = project_on_view(w, p->at[from]), y = project_on_view(w, p->at[to]);
    real t = part_between(x, y, point);
    *f = between(from, to, t);
    *z = x.z + t * (y.z - x.z);
}

// The point of the patch, a polygon or an edge, across from a point over it,
// and its height.  face: where to begin the search; where it ended.
static void project_on_patch(feature_point *f, const patch *p, const view *w,
                             vec3 point, int *face, real *z)
{
    if (p->face < 0) {
        real t = part_between(p->corner[0], p->corner[1], point);
        *z = edge_z(p, 0, t);
        *f = at_edge(p, 0, t);
        return;
    }
    footing g = footing_find(p, w, *face, point);
    const int *v = &p->shape->face[3 * g.face];
    *face = g.face;
    *z = g.z;
    if (g.weight[g.least] > 0)
        *f = (feature_point){ 3, { v[0], v[1], v[2] },
                              { g.weight[0], g.weight[1], g.weight[2] } };
    else
        at_rim(f, p, w, g.face, g.least, point, z);
}
//<

//> manifold-meet
//>   Now the corners of the overlap. The list keeps no corner twice, and none
//>   that is further apart than the margin.
// Two convex polygons of n and m corners overlap in one of at most n + m, but
// where rounding cannot tell, corners are kept twice.
enum { MOST_MEETINGS = 4 * PATCH_CORNERS };

// The corners of the overlap.
typedef struct {
    real  margin;               // m, what is further apart does not count
    real  same;                 // m, corners nearer to each other are one
    int   middle;               // the first so many are of a face on which a body
                                // lies, because its patch bulges
    int   count;
    touch of[MOST_MEETINGS];
    vec3  at[MOST_MEETINGS];    // m, x and y: as seen
} meetings;

// Has this corner been met already, or one so near that it is the same?
static int is_known(const meetings *m, vec3 at)
{
    for (int k = 0; k < m->count; k++) {
        vec3 d = vec3_sub(m->at[k], at);
        if (dot2(d, d) <= m->same * m->same) return 1;
    }
    return m->count == MOST_MEETINGS;
}

static void meet(meetings *m, const feature_point *a, const feature_point *b,
                 real gap, vec3 at)
{
    if (!(gap <= m->margin)) return;
    m->at[m->count] = at;
    m->of[m->count++] = (touch){ *a, *b, gap };
}
//<

//> manifold-inside
// inside[i][j]: m, how far corner i of p lies inwards of edge j of q.
typedef real depths[PATCH_CORNERS][PATCH_CORNERS];

static void measure_depths(const patch *p, const patch *q, depths inside)
{
    for (int i = 0; i < p->count; i++)
        for (int j = 0; j < q->count; j++)
            inside[i][j] = dot2(vec3_sub(p->corner[i], q->corner[j]),
                                q->inward[j]);
}

// Does corner i of p lie in q?  An edge has no inside, but two ends.
static int lies_in(const patch *p, int i, const patch *q, depths inside,
                   real slack)
{
    int outside = 0;
    for (int j = 0; j < q->count; j++) outside |= !(inside[i][j] >= -slack);
    if (outside || q->count > 2) return !outside;
    vec3 from = vec3_sub(p->corner[i], q->corner[0]);
    vec3 e = vec3_sub(q->corner[1], q->corner[0]);
    real length = sqrt(dot2(e, e)), along = dot2(from, e);
    return along >= -slack * length && along <= (length + slack) * length;
}
//<

//> manifold-clip
// The corner of q that lies here, or -1.
static int corner_here(const patch *q, vec3 point, real slack)
{
    for (int j = 0; j < q->count; j++) {
        vec3 d = vec3_sub(q->corner[j], point);
        if (dot2(d, d) <= slack * slack) return j;
    }
    return -1;
}

// The corners of p that lie in q.  sign: 1 if p is A, -1 if it is B.
static void meet_corners(const patch *p, const patch *q, depths inside,
                         real sign, const view *w, meetings *m)
{
    int face = q->face;
    for (int i = 0; i < p->count; i++) {
        if (!lies_in(p, i, q, inside, w->slack)
            || is_known(m, p->corner[i])) continue;
        real z;
        feature_point self = at_corner(p, i), foot;
        int j = corner_here(q, p->corner[i], w->slack);
        if (j >= 0) {
            foot = at_corner(q, j);
            z = q->corner[j].z;
        } else {
            project_on_patch(&foot, q, w, p->corner[i], &face, &z);
        }
        real gap = sign * (p->corner[i].z - z);
        meet(m, sign > 0 ? &self : &foot, sign > 0 ? &foot : &self, gap,
             p->corner[i]);
    }
}
//<

//> manifold-cross
//>   Rule 2, and with it the three cases are complete.
// One in front, the other behind, and neither on the line?  | and & do not
// branch: half of the answers are yes, in no order that could be predicted.
static int parted(real u, real v, real slack)
{
    return ((u > slack) & (v < -slack)) | ((u < -slack) & (v > slack));
}

// The crossings of an edge of p and one of q: both ends of each lie on either
// side of the other.  An end that lies on the other's line is no crossing, but
// a corner in (or out of) the other patch.
static void meet_crossings(const patch *p, const patch *q, depths p_in_q,
                           depths q_in_p, real slack, meetings *m)
{
    // The two edges of a patch that is an edge are one.
    int n = p->count > 2 ? p->count : 1, o = q->count > 2 ? q->count : 1;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < o; j++) {
            real u = p_in_q[i][j], u1 = p_in_q[next_corner(p, i)][j];
            real v = q_in_p[j][i], v1 = q_in_p[next_corner(q, j)][i];
            if (!(parted(u, u1, slack) & parted(v, v1, slack))) continue;
            real s = u / (u - u1), t = v / (v - v1);
            vec3 e = vec3_sub(p->corner[next_corner(p, i)], p->corner[i]);
            vec3 x = vec3_add_scaled(p->corner[i], s, e);
            if (is_known(m, x)) continue;
            feature_point a = at_edge(p, i, s), b = at_edge(q, j, t);
            meet(m, &a, &b, edge_z(p, i, s) - edge_z(q, j, t), x);
        }
}

// The corners of the overlap of two patches, of which one at least is a
// polygon: the paper's three cases.
static void meet_polygons(const patch *p, const patch *q, const view *w,
                          meetings *m)
{
    depths p_in_q, q_in_p;
    measure_depths(p, q, p_in_q);
    measure_depths(q, p, q_in_p);
    meet_corners(p, q, p_in_q, 1, w, m);
    meet_corners(q, p, q_in_p, -1, w, m);
    meet_crossings(p, q, p_in_q, q_in_p, w->slack, m);
}
//<

//> manifold-edges
// Two edges side by side, within half a degree: each end that has the other
// edge beside it.  Edges that cross have one point, and it is known.
static void meet_edges(const patch *p, const patch *q, meetings *m)
{
    vec3 e = vec3_sub(p->corner[1], p->corner[0]);
    vec3 g = vec3_sub(q->corner[1], q->corner[0]);
    real off = cross2(e, g), ee = dot2(e, e), gg = dot2(g, g);
    if (!(off * off <= 1e-4 * ee * gg)) return;
    for (int i = 0; i < 4; i++) {
        const patch *of = i < 2 ? p : q, *beside = i < 2 ? q : p;
        vec3 point = of->corner[i % 2];
        real t = part_between(beside->corner[0], beside->corner[1], point);
        // Beyond the other's end, unless the ends are side by side.
        vec3 past = vec3_sub(point, beside->corner[t > 0]);
        if (!(t > 0 && t < 1)
            && !(fabs(dot2(past, e)) <= m->same * sqrt(ee))) continue;
        if (is_known(m, point)) continue;
        feature_point self = at_corner(of, i % 2), foot = at_edge(beside, 0, t);
        real gap = point.z - edge_z(beside, 0, t);
        if (i < 2) meet(m, &self, &foot, gap, point);
        else       meet(m, &foot, &self, -gap, point);
    }
}
//<

//> manifold-furthest
// Of equals, up to rounding, the first wins.
static int beats(real x, real best)
{
    return x > best + fabs(best) * 0x1p-20;
}

// m^2: how far a corner lies from the lines between those that are kept.
static real apart_from(vec3 at, const vec3 *kept, int n)
{
    real near = HUGE_VAL;
    for (int i = 0; i < n; i++)
        for (int j = n > 1 ? i + 1 : i; j < n; j++) {
            real t = i < j ? part_between(kept[i], kept[j], at) : 0;
            vec3 e = vec3_sub(kept[j], kept[i]);
            vec3 d = vec3_sub(at, vec3_add_scaled(kept[i], t, e));
            near = real_min(near, dot2(d, d));
        }
    return near;
}

// Of the first `count` corners the one that comes deepest if the body turns by so
// much (rad) about those that are kept: by its distance from them, less how far it
// is open.  -1: none further from them than m->same, and deeper than `most` (m).
static int most_exposed(const meetings *m, int count, const vec3 *kept, int n,
                        real turn, real most)
{
    int best = -1;
    for (int k = 0; k < count; k++) {
        real near = apart_from(m->at[k], kept, n);
        if (!(near > m->same * m->same)) continue;
        real deep = turn * sqrt(near) - m->of[k].gap;
        if (!(best < 0 ? deep > most : beats(deep, most))) continue;
        most = deep;
        best = k;
    }
    return best;
}
//<

//> manifold-choose
// out[0] is corner `first`.  Then come, one by one, those three without which the
// body could sink deepest, first of those on which it lies: two vertices in the
// middle of a lens are near each other, and bear all of it.  Of a body that turns
// further than it is asked for, what still stays open goes.  Returns how many there
// are.
static int choose_exposed(const meetings *m, int first, real turn, touch *out)
{
    vec3 kept[MANIFOLD_POINTS] = { m->at[first] };
    real open = turn > MANIFOLD_TURN ? -out[0].gap : -HUGE_VAL;
    int n = 1;
    while (n < MANIFOLD_POINTS) {
        int k = most_exposed(m, m->middle, kept, n, turn, open);
        if (k < 0) k = most_exposed(m, m->count, kept, n, turn, open);
        if (k < 0) break;
        kept[n] = m->at[k];
        out[n++] = m->of[k];
    }
    return n;
}
//<

//> manifold-order
//>   The solver takes the points in turn, so their order is not rounding's.
// Which vertex is nearest, and so where a rim begins, is rounding's choice, of a
// body that lies flat.  So of corners that are all kept each kind begins with its
// lowest vertex, and goes on round the rim: in a world that is turned or moved the
// solver takes them as in this.
static int corner_kind(const touch *t)
{
    return 2 * (t->a.count > 1) + (t->b.count > 1);
}

static int stands_before(const touch *s, const touch *t)
{
    if (s->a.count == 1 && s->a.vertex[0] != t->a.vertex[0])
        return s->a.vertex[0] < t->a.vertex[0];
    return s->b.vertex[0] < t->b.vertex[0];
}

static void reverse_corners(meetings *m, int first, int end)
{
    for (--end; first < end; first++, end--) {
        SWAP(touch, m->of[first], m->of[end]);
        SWAP(vec3, m->at[first], m->at[end]);
    }
}

// Those from first to before end go round a rim.
static void turn_corners(meetings *m, int first, int end)
{
    int low = first;
    for (int k = first; k < end; k++)
        if (stands_before(&m->of[k], &m->of[low])) low = k;
    reverse_corners(m, first, low);
    reverse_corners(m, low, end);
    reverse_corners(m, first, end);
}

static void begin_with_lowest(meetings *m)
{
    int k = 0;
    while (k < m->count) {
        int first = k, kind = corner_kind(&m->of[k]);
        while (k < m->count && corner_kind(&m->of[k]) == kind) k++;
        turn_corners(m, first, k);
    }
}
//<

//> manifold-keep
// The touches from at least two corners; returns how many.
static int choose(const meetings *m, real slack, real turn,
                  touch out[MANIFOLD_POINTS])
{
    int deepest = 0, n = 1;
    turn = real_max(turn, MANIFOLD_TURN);
    for (int k = 0; k < m->count; k++)
        if (m->of[k].gap < m->of[deepest].gap - slack) deepest = k;
    out[0] = m->of[deepest];
    if (m->count > MANIFOLD_POINTS)
        return choose_exposed(m, deepest, turn, out);
    for (int k = 0; k < m->count; k++)
        if (k != deepest) out[n++] = m->of[k];
    return n;
}
//<

//> manifold-find
// All corners, first those of the face on which the body lies, if its patch bulges.
static void meet_patches(const patch *p, const patch *q, const view *w,
                         meetings *m)
{
    patch middle;
    if (p->count == 2 && q->count == 2) {
        meet_edges(p, q, m);
        return;
    }
    patch_middle(&middle, p, w);
    if (middle.count > 2) meet_polygons(&middle, q, w, m);
    patch_middle(&middle, q, w);
    if (middle.count > 2) meet_polygons(p, &middle, w, m);
    m->middle = m->count;
    meet_polygons(p, q, w, m);
}

// What is kept of the corners that were met, beside the pair.
static int keep_points(meetings *m, const touch *pair, const view *w, real turn,
                       touch out[MANIFOLD_POINTS])
{
    if (m->count <= MANIFOLD_POINTS && !m->middle) begin_with_lowest(m);
    out[0] = *pair;
    return m->count > 1 ? choose(m, w->slack, turn, out) : 1;
}

// The manifold of two cores, or of bodies that are not round.
static manifold find_between(const collider *a, const collider *b,
                             const touch *pair, vec3 normal, real margin,
                             real turn)
{
    view w = view_along(normal, feature_at(&pair->b, b->at),
                        fmax(a->shape->radius, b->shape->radius));
    manifold found = { 1, normal, { *pair }, a->shape->round, b->shape->round };
    patch p, q;
    meetings m;

    // A vertex touches in one point, whatever it stands on.
    if (!patch_begin(&p, a, -1, &w, &pair->a, turn)
        || !patch_begin(&q, b, 1, &w, &pair->b, turn)) return found;
    patch_draw(&p, &w);
    patch_draw(&q, &w);
    if (p.count < 2 || q.count < 2) return found;

    m.margin = margin;
    m.same = 64 * w.slack;
    m.count = m.middle = 0;
    meet_patches(&p, &q, &w, &m);
    found.count = keep_points(&m, pair, &w, turn, found.point);
    return found;
}

static manifold find_round(const collider *a, const collider *b, touch pair,
                           vec3 normal, real margin, real turn)
{
    real round = query_round(a, b);
    pair.gap += round;
    manifold m = find_between(a, b, &pair, normal, margin + round, turn);
    for (int k = 0; k < m.count; k++) m.point[k].gap -= round;
    return m;
}
//<

//> manifold-rims
//>   The side of a cylinder is that of a capsule, whose ends are given back as points
//>   on its axis.
static manifold find_rims(const collider *a, const collider *b,
                          const query_result *nearest, real margin, real turn)
{
    rim_pair p;
    vec3 n = nearest->normal;
    touch pair = nearest->at;
    query_move_to_rims(&p, a, b, n);
    query_touch_cores(a, b, &p, n, &pair);
    collider x = query_core(a, &p.a), y = query_core(b, &p.b);
    manifold m = find_round(&x, &y, pair, n, margin, turn);
    for (int k = 0; k < m.count; k++) {
        m.point[k].a = rim_feature(&p.a, &m.point[k].a);
        m.point[k].b = rim_feature(&p.b, &m.point[k].b);
    }
    return m;
}

manifold manifold_find(const collider *a, const collider *b,
                       const query_result *nearest, real margin, real turn)
{
    assert(nearest->near && nearest->at.a.count > 0 && nearest->at.b.count > 0);
    return a->shape->rim > 0 || b->shape->rim > 0
        ? find_rims(a, b, nearest, margin, turn)
        : find_round(a, b, nearest->at, nearest->normal, margin, turn);
}
//<

//> manifold-plane
//>   A plane is a face without a rim: all of the body's patch lies over it.
// All corners of the patch, of which the lowest vertex has that gap.
static void meet_plane(const patch *p, real gap, meetings *m)
{
    const feature_point none = { .count = 0 };
    for (int k = 0; k < p->count; k++) {
        feature_point self = at_corner(p, k);
        if (!is_known(m, p->corner[k]))
            meet(m, &self, &none, gap + p->corner[k].z, p->corner[k]);
    }
}

static manifold find_on_plane(const collider *a, vec3 normal, real offset,
                              real margin, real turn)
{
    int lowest = hull_scan(query_hull(a), vec3_scale(-1, normal));
    touch pair = { .a = { 1, { lowest }, { 1 } } };
    manifold found = { 0, normal, { pair }, a->shape->round, 0 };
    patch p, middle;
    meetings m;

    pair.gap = vec3_dot(a->at[lowest], normal) - offset - a->shape->round;
    if (!(pair.gap <= margin)) return found;
    found.count = 1;
    found.point[0] = pair;
    view w = view_along(normal, a->at[lowest], a->shape->radius);
    if (!patch_begin(&p, a, -1, &w, &pair.a, turn)) return found;
    patch_draw(&p, &w);
    m.margin = margin;
    m.same = 64 * w.slack;
    m.count = 0;
    patch_middle(&middle, &p, &w);
    meet_plane(&middle, pair.gap, &m);
    m.middle = m.count;
    meet_plane(&p, pair.gap, &m);
    found.count = keep_points(&m, &pair, &w, turn, found.point);
    return found;
}

manifold manifold_on_plane(const collider *a, vec3 normal, real offset,
                           real margin, real turn)
{
    rim_core side;
    if (!rim_towards(a->shape, a->at, vec3_scale(-1, normal), &side))
        return find_on_plane(a, normal, offset, margin, turn);
    collider core = query_core(a, &side);
    manifold m = find_on_plane(&core, normal, offset, margin, turn);
    for (int k = 0; k < m.count; k++)
        m.point[k].a = rim_feature(&side, &m.point[k].a);
    return m;
}
//<
