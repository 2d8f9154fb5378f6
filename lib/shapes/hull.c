//> convex-hull-facet
//>   A face knows its neighbours and the list of its points; the builder holds
//>   the faces.
#include "hull.h"

#include <assert.h>
#include <stddef.h>
#include <stdlib.h>

enum { NONE = -1, COVERED = -2, HULL_VERTICES = 16384 };

// A triangle of the hull so far.  Its corners run counter-clockwise, seen from
// outside; beyond side k, from corner k to the next, lies facet beside[k].
typedef struct {
    int  corner[3];
    int  beside[3];
    vec3 normal;        // unit, outwards
    real offset;        // m, of its plane along the normal
    int  first;         // of the points outside its plane that are given to
                        // it, a list; NONE: there are none
    bool is_used;
    bool is_listed;     // among those that may have points outside
    bool is_seen;       // from the point that is being added
} facet;

// A side of the hole that is left when the facets that a point sees are gone.
typedef struct {
    int from, to;       // its ends, as the facet that goes ran
    int beyond;         // the facet that stays
    int made;           // the new one, from this side to the point
} rim_side;

typedef struct {
    vec3  *at;          // [points] m, from the first of them
    int   *after;       // [points] the next in its facet's list; COVERED: it
                        // is a corner, or outside of no facet
    int    points;
    real   size;        // m, their largest distance from the first
    real   near;        // m, what is no further outside a facet is on it
    facet *facet;       // [room]
    int    room, used;
    int   *spare;       // [room] facets of before, whose places are free
    int    spares;
    int   *open;        // [room] facets with points outside
    int    opens;
    int   *seen;        // [room]
    int    seens;
    rim_side *rim;      // [room]
    int    sides;
    int   *place;       // [points] the side of the rim that leaves a point;
                        // at the end, its number as a vertex of the shape
} hull_builder;
//<

//> convex-hull-room
//>   Memory is allocated once, in a block for each list.
static void builder_free(hull_builder *b)
{
    void *owned[] = { b->at, b->after, b->facet, b->spare, b->open, b->seen,
                      b->rim, b->place };
    for (size_t i = 0; i < sizeof owned / sizeof *owned; i++) free(owned[i]);
}

// A hull of v vertices has 2 v - 4 facets; while new ones are made, those that
// they replace are there as well.
static status builder_make(hull_builder *b, const vec3 *at, int n)
{
    size_t points = (size_t)n, most = 4 * (size_t)HULL_VERTICES;
    size_t room = 4 * points < most ? 4 * points : most;
    *b = (hull_builder){ .points = n, .room = (int)room,
        .at    = malloc(points * sizeof *b->at),
        .after = malloc(points * sizeof *b->after),
        .facet = malloc(room * sizeof *b->facet),
        .spare = malloc(room * sizeof *b->spare),
        .open  = malloc(room * sizeof *b->open),
        .seen  = malloc(room * sizeof *b->seen),
        .rim   = malloc(room * sizeof *b->rim),
        .place = malloc(points * sizeof *b->place) };
    if (!b->at || !b->after || !b->facet || !b->spare || !b->open || !b->seen
        || !b->rim || !b->place) return status_out_of_memory();
    for (int i = 0; i < n; i++) {
        if (!vec3_is_finite(at[i]))
            return status_fail("point %d is not at a finite place", i);
        b->at[i] = vec3_sub(at[i], at[0]);
        b->size = real_max(b->size, vec3_length(b->at[i]));
    }
    if (b->size > 0 && !(b->size >= 1e-30 && b->size <= 1e30))
        return status_fail("the points measure %g m: it must be from 1e-30 to "
                           "1e30", b->size);
    return status_ok();
}
//<

//> convex-hull-first
//>   Step 1: the four points. Each is as far from those before as can be.
// The point for which `far` is largest.  Where several are equally far, as on a
// flat side, the furthest of them from any one point is a corner of that side.
typedef struct {
    int  best;
    real most, beside;  // m, m^2
} edge_search;

static void consider(edge_search *s, int i, real far, real beside, real near)
{
    if (!(far > s->most - near)) return;
    if (far > s->most + near || beside > s->beside)
        *s = (edge_search){ i, far, beside };
}

// m, from the first of the known points, from the line of two, from the plane
// of three.
static real distance_off(const hull_builder *b, const int v[3], int known, vec3 x)
{
    vec3 from = b->at[v[0]], e = vec3_sub(x, from);
    if (known < 2) return vec3_length(e);
    vec3 along = vec3_unit(vec3_sub(b->at[v[1]], from));
    if (known == 2) return vec3_length(vec3_cross(along, e));
    vec3 side = vec3_sub(b->at[v[2]], from);
    return fabs(vec3_dot(vec3_unit(vec3_cross(along, side)), e));
}

// Four points that span a tetrahedron, each as far from those before as can be;
// v[0] is the one furthest from point 0.
static status find_first(const hull_builder *b, int v[4])
{
    const real flat = 1e-6;     // of the size
    const char *in[] = { "place", "place", "line", "plane" };
    v[0] = 0;
    for (int known = 0; known < 4; known++) {
        edge_search s = { 0, 0, 0 };
        for (int i = 0; i < b->points; i++)
            consider(&s, i, distance_off(b, v, known, b->at[i]),
                     vec3_length_squared(vec3_sub(b->at[i], b->at[v[0]])),
                     b->near);
        if (!(s.most > flat * b->size))
            return status_fail("the %d points stand in one %s, or nearly: they "
                               "span no body", b->points, in[known]);
        v[known] = s.best;
    }
    return status_ok();
}
//<

//> convex-hull-outside
//>   A new face, and a point given to it.
static real height_over(const facet *f, vec3 x)
{
    return vec3_dot(f->normal, x) - f->offset;
}

// A new facet; NONE if there is no room.
static int add_facet(hull_builder *b, int u, int v, int w)
{
    if (b->spares == 0 && b->used == b->room) return NONE;
    int n = b->spares > 0 ? b->spare[--b->spares] : b->used++;
    vec3 a = b->at[u];
    facet f = { { u, v, w }, { NONE, NONE, NONE }, .first = NONE,
                .is_used = true, .is_listed = b->facet[n].is_listed };
    f.normal = vec3_unit(vec3_cross(vec3_sub(b->at[v], a),
                                    vec3_sub(b->at[w], a)));
    f.offset = vec3_dot(f.normal, a);
    b->facet[n] = f;
    return n;
}

// Gives a point to facet n if it is outside of its plane.
static bool give_point(hull_builder *b, int i, int n)
{
    facet *f = &b->facet[n];
    if (!(height_over(f, b->at[i]) > b->near)) return false;
    b->after[i] = f->first;
    f->first = i;
    if (!f->is_listed) b->open[b->opens++] = n;
    f->is_listed = true;
    return true;
}
//<

//> convex-hull-tetrahedron
//>   With these the four points become four faces, joined side to side, and
//>   take their points.
// Side k of facet f is side j of facet g, the other way round.
static void join(hull_builder *b, int f, int k, int g, int j)
{
    b->facet[f].beside[k] = g;
    b->facet[g].beside[j] = f;
}

static void begin_hull(hull_builder *b, int v[4])
{
    vec3 a = b->at[v[0]], p = vec3_sub(b->at[v[1]], a);
    vec3 q = vec3_sub(b->at[v[2]], a), r = vec3_sub(b->at[v[3]], a);
    if (vec3_dot(vec3_cross(p, q), r) > 0) SWAP(int, v[1], v[2]);
    b->used = b->spares = b->opens = 0;
    for (int n = 0; n < b->room; n++) b->facet[n].is_listed = false;
    add_facet(b, v[0], v[1], v[2]);
    for (int k = 0; k < 3; k++) add_facet(b, v[(k + 1) % 3], v[k], v[3]);
    for (int k = 0; k < 3; k++) {
        join(b, 0, k, 1 + k, 0);
        join(b, 1 + k, 2, 1 + (k + 1) % 3, 1);
    }
    for (int i = 0; i < b->points; i++) {
        b->after[i] = COVERED;
        for (int n = 0; n < 4; n++)
            if (give_point(b, i, n)) break;
    }
}
//<

//> convex-hull-seen
// Of the size: a point that is further in front of a facet sees it.  Were this
// as coarse as what counts as outside, a facet that is left standing although
// the point is in front of it would be a dent, and a short one a deep dent.
static const real SEES = 4e-16;

// Facets that point x sees hang together: we go from one to the next.  What
// ends the way is the rim.
static void find_seen(hull_builder *b, int n, vec3 x)
{
    b->seens = b->sides = 0;
    b->seen[b->seens++] = n;
    b->facet[n].is_seen = true;
    for (int i = 0; i < b->seens; i++) {
        const facet *f = &b->facet[b->seen[i]];
        for (int k = 0; k < 3; k++) {
            int beyond = f->beside[k];
            facet *g = &b->facet[beyond];
            if (g->is_seen) continue;
            if (height_over(g, x) > SEES * b->size) {
                g->is_seen = true;
                b->seen[b->seens++] = beyond;
            } else {
                b->rim[b->sides++] = (rim_side){ f->corner[k],
                    f->corner[(k + 1) % 3], beyond, NONE };
            }
        }
    }
}

// Once round the rim, from side to side, and there are no more, and the point
// is not on it?  (Rounding may tear it, where facets are slivers.)
static bool rim_is_ring(hull_builder *b, int point)
{
    int side = 0, steps = 0;
    for (int k = 0; k < b->sides; k++) b->place[b->rim[k].to] = NONE;
    for (int k = 0; k < b->sides; k++) b->place[b->rim[k].from] = k;
    for (int k = 0; k < b->sides; k++)
        if (b->rim[k].from == point) return false;
    do {
        side = b->place[b->rim[side].to];
        steps++;
    } while (side > 0 && steps < b->sides);
    return side == 0 && steps == b->sides;
}
//<

//> convex-hull-cone
// From every side of the rim a facet to the point.
static bool add_cone(hull_builder *b, int point)
{
    for (int k = 0; k < b->sides; k++) {
        rim_side *s = &b->rim[k];
        s->made = add_facet(b, s->from, s->to, point);
        if (s->made == NONE) return false;
        int j = 0;
        while (b->facet[s->beyond].corner[j] != s->to) j++;
        join(b, s->made, 0, s->beyond, j);
    }
    for (int k = 0; k < b->sides; k++)
        join(b, b->rim[k].made, 1, b->rim[b->place[b->rim[k].to]].made, 2);
    return true;
}

// The points of the facets that go are given to the new ones; what is outside
// of none is inside the hull.
static void hand_over(hull_builder *b, int point)
{
    for (int i = 0; i < b->seens; i++) {
        facet *old = &b->facet[b->seen[i]];
        for (int p = old->first, next; p != NONE; p = next) {
            next = b->after[p];
            b->after[p] = COVERED;
            for (int k = 0; k < b->sides && p != point; k++)
                if (give_point(b, p, b->rim[k].made)) break;
        }
        old->is_used = old->is_seen = false;
        b->spare[b->spares++] = b->seen[i];
    }
}
//<

//> convex-hull-points
//>   The loop takes the steps in turn.
// The furthest point outside of facet n is a corner of the hull.  Points of its
// list alone would not do: of a side's points, those at the corners may be in
// the lists of others.
static int furthest_outside(const hull_builder *b, int n)
{
    const facet *f = &b->facet[n];
    vec3 from = b->at[f->corner[0]];
    edge_search s = { f->first, 0, 0 };
    for (int i = 0; i < b->points; i++)
        if (b->after[i] != COVERED)
            consider(&s, i, height_over(f, b->at[i]),
                     vec3_length_squared(vec3_sub(b->at[i], from)), b->near);
    return s.best;
}

// Every round adds a point, or takes a facet from the list: it ends.
static status add_points(hull_builder *b)
{
    while (b->opens > 0) {
        int n = b->open[--b->opens];
        b->facet[n].is_listed = false;
        if (!b->facet[n].is_used || b->facet[n].first == NONE) continue;
        int point = furthest_outside(b, n);
        find_seen(b, n, b->at[point]);
        if (!rim_is_ring(b, point))
            return status_fail("the points lie so near one plane that their "
                               "hull cannot be told");
        if (!add_cone(b, point))
            return status_fail("the hull of the points has more than %d "
                               "vertices", HULL_VERTICES);
        hand_over(b, point);
    }
    return status_ok();
}
//<

//> convex-hull-slivers
// Keeps the corners of facets, in the order of the points, and of them those
// whose place is 0.
static void keep_corners(hull_builder *b)
{
    int kept = 0;
    for (int i = 0; i < b->points; i++)
        if (b->place[i] == 0) b->at[kept++] = b->at[i];
    b->points = kept;
}

static void mark_corners(hull_builder *b)
{
    for (int i = 0; i < b->points; i++) b->place[i] = NONE;
    for (int n = 0; n < b->used; n++)
        for (int k = 0; k < 3 && b->facet[n].is_used; k++)
            b->place[b->facet[n].corner[k]] = 0;
}

// The corner of facet n across from its longest side, if it is no further off
// that side than thin (m); else NONE.
static int sliver_tip(const hull_builder *b, int n, real thin)
{
    const int *v = b->facet[n].corner;
    int tip = 0;
    real longest = 0;
    for (int k = 0; k < 3; k++) {
        real side = vec3_distance(b->at[v[(k + 1) % 3]], b->at[v[(k + 2) % 3]]);
        if (side > longest) { longest = side; tip = k; }
    }
    vec3 e = vec3_sub(b->at[v[1]], b->at[v[0]]);
    vec3 f = vec3_sub(b->at[v[2]], b->at[v[0]]);
    bool is_thin = vec3_length(vec3_cross(e, f)) <= thin * longest;
    return is_thin ? v[tip] : NONE;
}

// Drops the tips of slivers, of each other's corners no more than one at a
// time.  Returns whether there were any; then only corners are left.
static bool drop_slivers(hull_builder *b, real thin)
{
    enum { DROPPED = -2, HELD = 1 };
    bool any = false;
    mark_corners(b);
    for (int n = 0; n < b->used; n++) {
        if (!b->facet[n].is_used) continue;
        const int *v = b->facet[n].corner;
        int tip = sliver_tip(b, n, thin), *place = b->place;
        if (tip == NONE || place[tip] != 0 || place[v[0]] == DROPPED
            || place[v[1]] == DROPPED || place[v[2]] == DROPPED) continue;
        for (int k = 0; k < 3; k++) place[v[k]] = HELD;
        place[tip] = DROPPED;
        any = true;
    }
    for (int i = 0; i < b->points; i++)
        if (b->place[i] == HELD) b->place[i] = 0;
    if (any) keep_corners(b);
    return any;
}
//<

//> convex-hull-centre
//>   The shape's origin becomes the centre of mass of the solid.
// Moves the shape so that its centre of mass is the origin: the tetrahedra from
// the origin over all faces have their centres a quarter of the way from three
// corners and the origin.
static void move_to_solid_centre(shape *s)
{
    vec3 sum = { 0, 0, 0 };
    real volume = 0;
    for (int f = 0; f < s->mesh.faces; f++) {
        const int *v = &s->face[3 * f];
        vec3 a = s->at[v[0]], b = s->at[v[1]], c = s->at[v[2]];
        real part = vec3_dot(a, vec3_cross(b, c));
        volume += part;
        sum = vec3_add_scaled(sum, part / 4, vec3_add(a, vec3_add(b, c)));
    }
    vec3 centre = vec3_scale(1 / volume, sum);
    for (int i = 0; i < s->particles; i++)
        s->at[i] = vec3_sub(s->at[i], centre);
}
//<

//> convex-hull-make
// The corners of facets, numbered in the order of the points, and the facets.
static int number_corners(hull_builder *b, vec3 *at, int (*triangle)[3], int *faces)
{
    int vertices = 0;
    *faces = 0;
    mark_corners(b);
    for (int i = 0; i < b->points; i++) {
        if (b->place[i] == NONE) continue;
        at[vertices] = b->at[i];
        b->place[i] = vertices++;
    }
    for (int n = 0; n < b->used; n++) {
        if (!b->facet[n].is_used) continue;
        for (int k = 0; k < 3; k++)
            triangle[*faces][k] = b->place[b->facet[n].corner[k]];
        ++*faces;
    }
    return vertices;
}

static status make_shape(hull_builder *b, shape *s, real mass)
{
    vec3 *at = malloc((size_t)b->points * sizeof *at);
    int (*triangle)[3] = malloc((size_t)b->used * sizeof *triangle), faces;
    status done = status_out_of_memory();
    if (at && triangle) {
        int vertices = number_corners(b, at, triangle, &faces);
        done = shape_convex(s, vertices, at, faces,
                            (const int (*)[3])triangle, mass);
    }
    free(at);
    free(triangle);
    if (!done.ok) return done;
    move_to_solid_centre(s);
    return shape_finish(s, done);
}

// A finer tolerance than the hull's triangles bear leaves slivers, whose
// planes rounding turns: then points that make them are dropped, and if that
// does not do, the tolerances grow.
static status build(hull_builder *b, shape *s, real mass)
{
    status done = status_ok();
    real near = 1e-12, thin = 4e-9;     // of the size
    for (int round = 0; round < 100 && thin < 1e-6; round++) {
        int v[4];
        b->near = near * b->size;
        done = find_first(b, v);
        if (!done.ok) return done;
        begin_hull(b, v);
        done = add_points(b);
        if (done.ok && drop_slivers(b, thin * b->size)) continue;
        if (done.ok) done = make_shape(b, s, mass);
        if (done.ok) return done;
        near = real_min(10 * near, 1e-10);
        thin *= 3;
    }
    return done;
}

status shape_hull(shape *s, const vec3 *at, int n, real mass)
{
    assert(s && (at || n <= 0));
    hull_builder b;
    *s = (shape){ .kind = SHAPE_RIGID };
    if (n < 4 || n > 1 << 24)
        return status_fail("the number of points is %d: it must be from 4 to "
                           "%d", n, 1 << 24);
    status done = builder_make(&b, at, n);
    if (done.ok) done = build(&b, s, mass);
    builder_free(&b);
    return done;
}
//<
