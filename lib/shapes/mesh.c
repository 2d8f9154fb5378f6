//> mesh-walk
#include "mesh.h"

#include <assert.h>
#include <limits.h>
#include <stdlib.h>

int mesh_target(const mesh *m, int h)
{
    return m->half[mesh_twin(h)].origin;
}

// The twin of h arrives where h leaves; what follows the twin leaves again.
int mesh_around(const mesh *m, int h)
{
    return m->half[mesh_twin(h)].next;
}

void mesh_face(const mesh *m, int f, int vertex[3])
{
    int h = m->face_half[f];
    for (int k = 0; k < 3; k++) {
        vertex[k] = m->half[h].origin;
        h = m->half[h].next;
    }
}
//<

//> mesh-euler
int mesh_euler(const mesh *m)
{
    return m->vertices - m->edges + m->faces;
}
//<

//> mesh-volume
// The sum of the signed tetrahedra from one point o to every face:
// (a - o) . ((b - o) x (c - o)) / 6.  The point o is a vertex of the mesh, so
// that a body far from the origin loses no digits.
real mesh_volume(const mesh *m, const vec3 *at)
{
    real six_volumes = 0;
    if (m->faces == 0) return 0;
    vec3 o = at[m->half[m->face_half[0]].origin];
    for (int f = 0; f < m->faces; f++) {
        int v[3];
        mesh_face(m, f, v);
        vec3 a = vec3_sub(at[v[0]], o);
        vec3 b = vec3_sub(at[v[1]], o);
        vec3 c = vec3_sub(at[v[2]], o);
        six_volumes += vec3_dot(a, vec3_cross(b, c));
    }
    return six_volumes / 6;
}
//<

//> mesh-find-half
// While a mesh is built, the half-edges that leave a vertex form a linked list.
typedef struct {
    int *first;         // [vertices] the newest half-edge of the list, or -1
    int *after;         // [6 * faces] the one after a half-edge, or -1
} fan_lists;

// The half-edge from a to b; -1 if there is none yet.  An edge stands in the
// lists of both its ends, so the search ends with the shorter of the two.
// While a mesh is built only origins are known: a half-edge ends where its twin
// begins.
static int find_half(const mesh *m, const fan_lists *fan, int a, int b)
{
    int h = fan->first[a], g = fan->first[b];
    for (; h >= 0 && g >= 0; h = fan->after[h], g = fan->after[g]) {
        if (m->half[mesh_twin(h)].origin == b) return h;
        if (m->half[mesh_twin(g)].origin == a) return mesh_twin(g);
    }
    return -1;
}

static int add_half(mesh *m, fan_lists *fan, int h, int origin)
{
    m->half[h] = (half_edge){ origin, -1, -1 };
    fan->after[h] = fan->first[origin];
    fan->first[origin] = h;
    return h;
}

// A new edge between a and b.  Returns its half-edge from a to b.
static int add_edge(mesh *m, fan_lists *fan, int a, int b)
{
    int h = 2 * m->edges++;
    add_half(m, fan, h + 1, b);
    return add_half(m, fan, h, a);
}
//<

//> mesh-add-face
static status check_triangle(const mesh *m, int f, const int v[3])
{
    for (int k = 0; k < 3; k++) {
        if (v[k] < 0 || v[k] >= m->vertices)
            return status_fail("triangle %d uses vertex %d, but there are only "
                               "%d vertices (0 to %d)", f, v[k], m->vertices,
                               m->vertices - 1);
        if (v[k] == v[(k + 1) % 3])
            return status_fail("triangle %d uses vertex %d twice", f, v[k]);
    }
    return status_ok();
}

// Face f wants half-edge h, which already has a face.
static status refuse_side(const mesh *m, int f, int h)
{
    return status_fail("triangle %d and triangle %d both run from vertex %d to "
                       "vertex %d: one of them is turned inside out, or the "
                       "edge has three triangles", m->half[h].face, f,
                       m->half[h].origin, m->half[mesh_twin(h)].origin);
}

// Finds or makes the three half-edges of face f, and links them in a ring.
static status store_face(mesh *m, fan_lists *fan, int f, const int v[3])
{
    int h[3];
    status s = check_triangle(m, f, v);
    if (!s.ok) return s;
    for (int k = 0; k < 3; k++) {
        int a = v[k], b = v[(k + 1) % 3];
        h[k] = find_half(m, fan, a, b);
        if (h[k] < 0) h[k] = add_edge(m, fan, a, b);
        if (m->half[h[k]].face >= 0) return refuse_side(m, f, h[k]);
        m->half[h[k]].face = f;
    }
    for (int k = 0; k < 3; k++) m->half[h[k]].next = h[(k + 1) % 3];
    m->face_half[f] = h[0];
    return s;
}
//<

//> mesh-link-rims
// A rim that arrives at a vertex leaves it again: after a half-edge without a
// face comes the one without a face that leaves where it ends.
static void link_rims(mesh *m, const fan_lists *fan)
{
    for (int v = 0; v < m->vertices; v++) m->vertex_half[v] = fan->first[v];
    for (int h = 0; h < 2 * m->edges; h++)
        if (m->half[h].face < 0) m->vertex_half[m->half[h].origin] = h;
    for (int h = 0; h < 2 * m->edges; h++)
        if (m->half[h].face < 0)
            m->half[h].next = m->vertex_half[m->half[mesh_twin(h)].origin];
}

// One turn around a vertex must meet every half-edge that leaves it.  If it is
// back too early, there is a second fan, which the turn does not reach.
static status check_fans(const mesh *m, const fan_lists *fan)
{
    for (int v = 0; v < m->vertices; v++) {
        int start = m->vertex_half[v], h = start;
        for (int k = fan->first[v]; k >= 0; k = fan->after[k]) {
            h = mesh_around(m, h);
            if (h == start && fan->after[k] >= 0)
                return status_fail("two fans of triangles meet in vertex %d "
                                   "and nowhere else: the surface is pinched "
                                   "there", v);
        }
    }
    return status_ok();
}
//<

//> mesh-allocate
// The most triangles and vertices whose arrays stay below INT_MAX bytes.
enum {
    MOST_FACES    = INT_MAX / (6 * (int)sizeof(half_edge)),
    MOST_VERTICES = INT_MAX / (int)sizeof(int) - 1
};

// Three edges a triangle are enough, and every edge has two half-edges.  One
// element more than needed, because room for none may be NULL.
static status reserve_faces(mesh *m, fan_lists *fan)
{
    size_t vertices = (size_t)m->vertices + 1, faces = (size_t)m->faces + 1;
    m->half        = malloc(6 * faces * sizeof *m->half);
    m->vertex_half = malloc(vertices * sizeof *m->vertex_half);
    m->face_half   = malloc(faces * sizeof *m->face_half);
    fan->first     = malloc(vertices * sizeof *fan->first);
    fan->after     = malloc(6 * faces * sizeof *fan->after);
    if (!m->half || !m->vertex_half || !m->face_half || !fan->first
        || !fan->after) return status_out_of_memory();
    for (int v = 0; v < m->vertices; v++) fan->first[v] = -1;
    return status_ok();
}
//<

//> mesh-build
status mesh_build(mesh *m, int vertices, const int (*triangle)[3], int faces)
{
    assert(m && (triangle || faces <= 0));
    *m = (mesh){ 0 };
    if (vertices < 0 || vertices > MOST_VERTICES || faces < 0
        || faces > MOST_FACES)
        return status_fail("a mesh cannot have %d vertices and %d triangles",
                           vertices, faces);
    fan_lists fan;
    m->vertices = vertices;
    m->faces = faces;
    status s = reserve_faces(m, &fan);
    for (int f = 0; f < faces && s.ok; f++)
        s = store_face(m, &fan, f, triangle[f]);
    if (s.ok) {
        link_rims(m, &fan);
        s = check_fans(m, &fan);
    }
    free(fan.first);
    free(fan.after);
    if (!s.ok) mesh_free(m);
    return s;
}

void mesh_free(mesh *m)
{
    free(m->half);
    free(m->vertex_half);
    free(m->face_half);
    *m = (mesh){ 0 };
}
//<
