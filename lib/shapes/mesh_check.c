//> mesh-validate-half
#include "mesh_check.h"

#include <assert.h>
#include <limits.h>
#include <stdlib.h>

// The vertex that h reaches, read from the array: only what is written there is
// on trial.
static int end_of(const mesh *m, int h)
{
    return m->half[mesh_twin(h)].origin;
}

// The rules for one half-edge alone.  Indices come first, because the other
// rules follow them.
static status validate_half(const mesh *m, int h)
{
    half_edge e = m->half[h];
    if (e.origin < 0 || e.origin >= m->vertices)
        return status_fail("half-edge %d leaves vertex %d, which does not "
                           "exist", h, e.origin);
    if (e.next < 0 || e.next >= 2 * m->edges)
        return status_fail("half-edge %d is followed by half-edge %d, which "
                           "does not exist", h, e.next);
    if (e.face < -1 || e.face >= m->faces)
        return status_fail("half-edge %d borders face %d, which does not "
                           "exist", h, e.face);
    if (e.face < 0 && m->half[mesh_twin(h)].face < 0)
        return status_fail("edge %d has no face on either side", h / 2);
    if (e.origin == end_of(m, h))
        return status_fail("edge %d begins and ends in vertex %d", h / 2,
                           e.origin);
    return status_ok();
}

// What comes next leaves where h ends, along the same face; and around a face
// three steps lead back.
static status validate_next(const mesh *m, int h)
{
    int face = m->half[h].face, second = m->half[h].next;
    if (m->half[second].origin != end_of(m, h))
        return status_fail("half-edge %d is followed by half-edge %d, which "
                           "does not leave where it ends", h, second);
    if (m->half[second].face != face)
        return status_fail("half-edge %d borders face %d, but half-edge %d "
                           "after it borders face %d", h, face, second,
                           m->half[second].face);
    if (face >= 0 && m->half[m->half[second].next].next != h)
        return status_fail("half-edge %d is not back at itself after three "
                           "steps around face %d", h, face);
    return status_ok();
}
//<

//> mesh-validate-faces
// Every face has a half-edge, so it has three.  If some face has six, then all
// of them together are too many.
static status validate_faces(const mesh *m)
{
    long long bordered = 0;
    for (int h = 0; h < 2 * m->edges; h++) bordered += m->half[h].face >= 0;
    for (int f = 0; f < m->faces; f++) {
        int h = m->face_half[f];
        if (h < 0 || h >= 2 * m->edges || m->half[h].face != f)
            return status_fail("face %d begins with half-edge %d, which does "
                               "not border it", f, h);
    }
    if (bordered != 3LL * m->faces)
        return status_fail("%lld half-edges border the %d faces: three times "
                           "as many as faces it must be", bordered, m->faces);
    return status_ok();
}
//<

//> mesh-validate-vertices
// One turn around v meets every half-edge that leaves it, and only the first
// may run along a rim.
static status validate_vertex(const mesh *m, int v, int leaving)
{
    int start = m->vertex_half[v], h = start;
    if (start == -1 && leaving == 0) return status_ok();
    if (start < 0 || start >= 2 * m->edges || m->half[start].origin != v)
        return status_fail("vertex %d begins with half-edge %d, which does not "
                           "leave it", v, start);
    for (int met = 1; met < leaving; met++) {
        h = mesh_around(m, h);
        if (h == start)
            return status_fail("%d half-edges leave vertex %d, but a turn "
                               "around it does not meet each of them once",
                               leaving, v);
        if (m->half[h].face < 0)
            return status_fail("vertex %d begins with half-edge %d, but "
                               "half-edge %d runs along a rim", v, start, h);
    }
    return status_ok();
}

static status validate_vertices(const mesh *m)
{
    int *leaving = calloc((size_t)m->vertices + 1, sizeof *leaving);
    if (!leaving) return status_out_of_memory();
    status s = status_ok();
    for (int h = 0; h < 2 * m->edges; h++) leaving[m->half[h].origin]++;
    for (int v = 0; v < m->vertices && s.ok; v++)
        s = validate_vertex(m, v, leaving[v]);
    free(leaving);
    return s;
}
//<

//> mesh-validate
status mesh_validate(const mesh *m)
{
    assert(m);
    status s = status_ok();
    if (m->vertices < 0 || m->edges < 0 || m->faces < 0
        || m->edges > INT_MAX / 2)
        return status_fail("the mesh counts %d vertices, %d edges and %d faces",
                           m->vertices, m->edges, m->faces);
    if ((m->edges > 0 && !m->half) || (m->vertices > 0 && !m->vertex_half)
        || (m->faces > 0 && !m->face_half))
        return status_fail("the mesh counts elements that it does not hold");
    for (int h = 0; h < 2 * m->edges && s.ok; h++) s = validate_half(m, h);
    for (int h = 0; h < 2 * m->edges && s.ok; h++) s = validate_next(m, h);
    if (s.ok) s = validate_faces(m);
    return s.ok ? validate_vertices(m) : s;
}
//<

//> mesh-convex-form
// As a fraction of the size of a mesh, what counts as zero.
static const real FLAT = 1e-9;

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
            if (vec3_distance(at[v], at[w]) <= FLAT * size)
                return status_fail("vertex %d and vertex %d stand in the same "
                                   "place", v, w);
    return status_ok();
}
//<

//> mesh-convex-faces
// The unit outward normal of a face.  Fails if the height of the triangle over
// its longest side, which is twice its area / that side, is zero.
static status face_normal(const vec3 *at, const int v[3], int f, real size,
                          vec3 *normal)
{
    vec3 a = vec3_sub(at[v[1]], at[v[0]]), b = vec3_sub(at[v[2]], at[v[0]]);
    real longest = real_max(vec3_distance(at[v[1]], at[v[2]]),
                            real_max(vec3_length(a), vec3_length(b)));
    vec3 twice_area = vec3_cross(a, b);
    *normal = vec3_unit(twice_area);
    if (vec3_length(twice_area) > FLAT * size * longest) return status_ok();
    return status_fail("triangle %d is flat: vertex %d, vertex %d and vertex "
                       "%d stand in one line", f, v[0], v[1], v[2]);
}

// Every vertex lies in the plane of face f or below it, and one well below.
static status check_face(const mesh *m, const vec3 *at, int f, real size)
{
    vec3 normal;
    real highest = 0, lowest = 0;
    int v[3], top = 0;
    mesh_face(m, f, v);
    status s = face_normal(at, v, f, size, &normal);
    for (int w = 0; w < m->vertices; w++) {
        real height = vec3_dot(normal, vec3_sub(at[w], at[v[0]]));
        if (height > highest) { highest = height; top = w; }
        lowest = real_min(lowest, height);
    }
    if (s.ok && highest > FLAT * size)
        s = status_fail("vertex %d stands %.2g of the size outside the plane "
                        "of triangle %d: the mesh is not convex", top,
                        highest / size, f);
    if (s.ok && lowest >= -FLAT * size)
        s = status_fail("the mesh has no thickness: no vertex stands below the "
                        "plane of triangle %d", f);
    return s;
}
//<

//> mesh-check-convex
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
