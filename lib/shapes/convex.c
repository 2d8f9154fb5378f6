//> convex-centre
#include "convex.h"
#include "mesh_check.h"

#include <assert.h>
#include <stdlib.h>

// Moves the particles so that their mean, the centre of equal masses, is the
// origin.  Measured from particle 0, so that a body far away loses no digits.
static void move_to_centre(shape *s)
{
    vec3 first = s->at[0], sum = { 0, 0, 0 };
    for (int i = 0; i < s->particles; i++) {
        s->at[i] = vec3_sub(s->at[i], first);
        sum = vec3_add(sum, s->at[i]);
    }
    vec3 centre = vec3_scale(1 / (real)s->particles, sum);
    for (int i = 0; i < s->particles; i++)
        s->at[i] = vec3_sub(s->at[i], centre);
}

// Most of the sticks are edges, and the first particles have most of the
// others: so the few that are asked about are found by looking at all.
static void join(shape *s, int a, int b)
{
    for (int k = 0; k < s->sticks; k++) {
        stick t = s->stick[k];
        if ((t.a == a && t.b == b) || (t.a == b && t.b == a)) return;
    }
    shape_add_stick(s, a, b);
}
//<

//> convex-flat
// As a fraction of the radius: a tetrahedron lower than this holds nothing up.
static const real FLAT = 1e-3;

static vec3 face_normal(const shape *s, int f)
{
    const int *v = &s->face[3 * f];
    return vec3_unit(vec3_cross(vec3_sub(s->at[v[1]], s->at[v[0]]),
                                vec3_sub(s->at[v[2]], s->at[v[0]])));
}

// Does the apex, vertex 0, lie in the plane of every face around v?  Then all
// tetrahedra at v are flat, and sticks in a plane are all that hold v.
static bool is_flat_at(const shape *s, int v, real radius)
{
    int start = s->mesh.vertex_half[v], h = start;
    vec3 to_apex = vec3_sub(s->at[0], s->at[v]);
    do {
        vec3 normal = face_normal(s, s->mesh.half[h].face);
        if (vec3_dot(normal, to_apex) < -FLAT * radius) return false;
        h = mesh_around(&s->mesh, h);
    } while (h != start);
    return true;
}

// The vertex farthest below the plane of a face at v; the lowest index wins.
static int farthest_below(const shape *s, int v)
{
    vec3 normal = face_normal(s, s->mesh.half[s->mesh.vertex_half[v]].face);
    real lowest = 0;
    int bottom = v;
    for (int w = 0; w < s->particles; w++) {
        real height = vec3_dot(normal, vec3_sub(s->at[w], s->at[v]));
        if (height < lowest) { lowest = height; bottom = w; }
    }
    return bottom;
}
//<

//> convex-make
// A mesh of sphere type over n vertices has 3 n - 6 edges.  With a stick to
// vertex 0 and one across for each vertex, 5 n are enough.
enum { MOST_CONVEX = 16384 };

// Paper: "a restricted 3D triangulation", which a general polyhedron need not
// have; here: a fan from one vertex, because a convex body always has that.
static void add_tetrahedra(shape *s)
{
    real radius = 0;
    for (int v = 0; v < s->particles; v++)
        radius = real_max(radius, vec3_length(s->at[v]));
    shape_add_edges(s);
    for (int v = 1; v < s->particles; v++) join(s, 0, v);
    for (int v = 1; v < s->particles; v++)
        if (is_flat_at(s, v, radius)) join(s, v, farthest_below(s, v));
}

status shape_convex(shape *s, int vertices, const vec3 *at,
                    int faces, const int (*triangle)[3], real mass)
{
    assert(s && (at || vertices <= 0) && (triangle || faces <= 0));
    *s = (shape){ .kind = SHAPE_RIGID };
    if (vertices < 4 || vertices > MOST_CONVEX)
        return status_fail("the number of vertices is %d: it must be from 4 to "
                           "%d", vertices, MOST_CONVEX);
    status r = shape_begin(s, SHAPE_RIGID, vertices, 5 * vertices, mass);
    if (r.ok) r = shape_span(s, triangle, faces);
    if (r.ok) r = mesh_check_convex(&s->mesh, at);
    if (!r.ok) return shape_finish(s, r);

    for (int i = 0; i < vertices; i++) s->at[i] = at[i];
    move_to_centre(s);
    add_tetrahedra(s);
    return shape_finish(s, r);
}
//<
