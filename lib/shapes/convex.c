//> mesh-convex-form
//>   Is the mesh a closed convex surface? All tolerances are fractions of its
//>   size.
#include "convex.h"

#include <assert.h>
#include <stdlib.h>

// As a fraction of the size of a mesh, what counts as zero.
static const real FLATNESS = 1e-9;

// A closed surface of sphere type, every vertex in use.
static status check_sphere_type(const mesh *m)
{
    for (int v = 0; v < m->vertices; v++)
        if (m->vertex_half[v] < 0)
            return status_fail("vertex %d belongs to no triangle", v);
    for (int h = 0; h < 2 * m->edges; h++)
        if (m->half[h].face < 0)
            return status_fail("the edge from vertex %d to vertex %d has a "
                               "triangle on one side only: the mesh is open",
                               m->half[h].origin, mesh_target(m, h));
    if (mesh_euler(m) != 2)
        return status_fail("the mesh is not one sphere: vertices - edges + "
                           "triangles is %d, not 2", mesh_euler(m));
    return status_ok();
}

// The largest distance from vertex 0.  The squares of areas must be numbers,
// and those are fourth powers of the size.
static status measure_size(const mesh *m, const vec3 *at, real *size)
{
    *size = 0;
    for (int v = 0; v < m->vertices; v++) {
        if (!vec3_is_finite(at[v]))
            return status_fail("vertex %d is not at a finite place", v);
        *size = real_max(*size, vec3_distance(at[v], at[0]));
    }
    if (!(*size > 1e-60 && *size < 1e60))
        return status_fail("the mesh measures %g m: too %s to compute with",
                           *size, *size < 1 ? "small" : "large");
    return status_ok();
}

// Two vertices in one place would let a surface wind twice around its body.
static status check_apart(const mesh *m, const vec3 *at, real size)
{
    for (int v = 0; v < m->vertices; v++)
        for (int w = v + 1; w < m->vertices; w++)
            if (vec3_distance(at[v], at[w]) <= FLATNESS * size)
                return status_fail("vertex %d and vertex %d stand in the same "
                                   "place", v, w);
    return status_ok();
}
//<

//> mesh-convex-faces
// The vertices of face f, and its outward normal, as long as twice its area.
static vec3 face_normal(const mesh *m, const vec3 *at, int f, int v[3])
{
    mesh_face(m, f, v);
    return vec3_cross(vec3_sub(at[v[1]], at[v[0]]),
                      vec3_sub(at[v[2]], at[v[0]]));
}

// A triangle is flat if its height over its longest side, which is twice its
// area / that side, is zero.
static status check_area(const mesh *m, const vec3 *at, int f, real size)
{
    int v[3];
    real twice_area = vec3_length(face_normal(m, at, f, v));
    real longest = real_max(vec3_distance(at[v[1]], at[v[2]]),
                            real_max(vec3_distance(at[v[0]], at[v[1]]),
                                     vec3_distance(at[v[0]], at[v[2]])));
    if (twice_area > FLATNESS * size * longest) return status_ok();
    return status_fail("triangle %d is flat: vertex %d, vertex %d and vertex "
                       "%d stand in one line", f, v[0], v[1], v[2]);
}

// Every vertex lies in the plane of face f or below it, and one well below.
static status check_face(const mesh *m, const vec3 *at, int f, real size)
{
    real highest = 0, lowest = 0;
    int v[3], top = 0;
    vec3 normal = vec3_unit(face_normal(m, at, f, v));
    status s = check_area(m, at, f, size);
    for (int w = 0; w < m->vertices; w++) {
        real height = vec3_dot(normal, vec3_sub(at[w], at[v[0]]));
        if (height > highest) { highest = height; top = w; }
        lowest = real_min(lowest, height);
    }
    if (s.ok && highest > FLATNESS * size)
        s = status_fail("vertex %d stands %.2g of the size outside the plane "
                        "of triangle %d: the mesh is not convex", top,
                        highest / size, f);
    if (s.ok && lowest >= -FLATNESS * size)
        s = status_fail("the mesh has no thickness: no vertex stands below the "
                        "plane of triangle %d", f);
    return s;
}
//<

//> mesh-check-convex
//>   A mesh that is not convex is refused with a sentence that names the face.
status mesh_check_convex(const mesh *m, const vec3 *at)
{
    assert(m && (at || m->vertices == 0));
    real size = 0;
    status s = check_sphere_type(m);
    if (s.ok) s = measure_size(m, at, &size);
    if (s.ok) s = check_apart(m, at, size);
    if (!s.ok) return s;

    // All faces turned round look inwards; 1e-12 of the cube is rounding.
    if (mesh_volume(m, at) < -1e-12 * (size * size * size))
        return status_fail("the triangles look inwards: every one of them must "
                           "be turned round");
    for (int f = 0; f < m->faces && s.ok; f++) s = check_face(m, at, f, size);
    return s;
}
//<

//> convex-centre
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

// A stick between a and b, unless they are joined already.
static void join_sets(shape *s, int a, int b)
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

// Does the apex, vertex 0, lie in the plane of every face around v?  Then all
// tetrahedra at v are flat, and sticks in a plane are all that hold v.
static bool is_flat_at(const shape *s, int v, real radius)
{
    int start = s->mesh.vertex_half[v], h = start, of[3];
    vec3 to_apex = vec3_sub(s->at[0], s->at[v]);
    do {
        vec3 normal = vec3_unit(face_normal(&s->mesh, s->at,
                                            s->mesh.half[h].face, of));
        if (vec3_dot(normal, to_apex) < -FLAT * radius) return false;
        h = mesh_around(&s->mesh, h);
    } while (h != start);
    return true;
}

// The vertex farthest below the plane of a face at v; the lowest index wins.
static int farthest_below(const shape *s, int v)
{
    int face = s->mesh.half[s->mesh.vertex_half[v]].face, bottom = v, of[3];
    vec3 normal = face_normal(&s->mesh, s->at, face, of);
    real lowest = 0;
    for (int w = 0; w < s->particles; w++) {
        real height = vec3_dot(normal, vec3_sub(s->at[w], s->at[v]));
        if (height < lowest) { lowest = height; bottom = w; }
    }
    return bottom;
}
//<

//> convex-make
//>   And the whole method.
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
    for (int v = 1; v < s->particles; v++) join_sets(s, 0, v);
    for (int v = 1; v < s->particles; v++)
        if (is_flat_at(s, v, radius)) join_sets(s, v, farthest_below(s, v));
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
