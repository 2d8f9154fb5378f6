//> mesh-plan
#include "mesh.h"

#include <assert.h>
#include <limits.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

// What mesh_build works on.  Corner 3 f + k is the side of triangle f that
// runs from its vertex k to the one after it; every half-edge with a face is
// one corner.
typedef struct {
    const int (*triangle)[3];
    int vertices, corners;
    int *order;         // [corners] sorted so that equal sides are neighbours
    int *half;          // [corners] its half-edge (before: scratch)
    int *mate;          // [corners] the corner across its side; -1: none
    int *count;         // [vertices + 1] of a counting sort; of a turn
} mesh_plan;

static int corner_from(const mesh_plan *p, int corner)
{
    return p->triangle[corner / 3][corner % 3];
}

static int corner_to(const mesh_plan *p, int corner)
{
    return p->triangle[corner / 3][(corner % 3 + 1) % 3];
}

// The lower or the upper end of a side: the same for both its directions.
static int corner_end(const mesh_plan *p, int corner, int upper)
{
    int a = corner_from(p, corner), b = corner_to(p, corner);
    return (a < b) == (upper != 0) ? b : a;
}
//<

//> mesh-check-triangles
static status check_triangles(const mesh_plan *p)
{
    for (int c = 0; c < p->corners; c++) {
        int f = c / 3, v = corner_from(p, c);

        // A vertex that does not exist.
        if (v < 0 || v >= p->vertices)
            return status_fail("triangle %d uses vertex %d, but there are only "
                               "%d vertices (0 to %d)", f, v, p->vertices,
                               p->vertices - 1);

        // Two corners in one vertex: a line, not a triangle.
        if (v == corner_to(p, c))
            return status_fail("triangle %d uses vertex %d twice", f, v);
    }
    return status_ok();
}
//<

//> mesh-sort-corners
// A stable counting sort by one end of the side: time in proportion to corners
// and vertices, whatever the mesh.  Sorted by the upper end and then by the
// lower, the two directions of an edge stand side by side.
static void sort_corners(const mesh_plan *p, const int *in, int *out, int upper)
{
    size_t counts = (size_t)p->vertices + 1;
    memset(p->count, 0, counts * sizeof *p->count);

    // How many sides have their end below v: the place of v's first.
    for (int i = 0; i < p->corners; i++)
        p->count[corner_end(p, i, upper) + 1]++;
    for (int v = 0; v < p->vertices; v++)
        p->count[v + 1] += p->count[v];

    for (int i = 0; i < p->corners; i++) {
        int c = in ? in[i] : i;
        out[p->count[corner_end(p, c, upper)]++] = c;
    }
}
//<

//> mesh-pair-corners
static int same_side(const mesh_plan *p, int a, int b)
{
    return corner_end(p, a, 0) == corner_end(p, b, 0)
        && corner_end(p, a, 1) == corner_end(p, b, 1);
}

// Finds for every corner the one that runs along the same edge the other way.
static status pair_corners(const mesh_plan *p)
{
    sort_corners(p, NULL, p->half, 1);
    sort_corners(p, p->half, p->order, 0);

    for (int i = 0; i < p->corners; i++) {
        int a = p->order[i], from = corner_from(p, a), to = corner_to(p, a);
        int b = i + 1 < p->corners ? p->order[i + 1] : -1;
        p->mate[a] = -1;
        if (b < 0 || !same_side(p, a, b)) continue;     // a side on a rim

        // A third triangle: the surface would fork along this edge.
        int c = i + 2 < p->corners ? p->order[i + 2] : -1;
        if (c >= 0 && same_side(p, a, c))
            return status_fail("triangle %d, triangle %d and triangle %d share "
                               "the edge from vertex %d to vertex %d: an edge "
                               "has two sides", a / 3, b / 3, c / 3, from, to);

        // Both run the same way: one of them shows its inside.
        if (corner_from(p, b) == from)
            return status_fail("triangle %d and triangle %d both run from "
                               "vertex %d to vertex %d: one of them is turned "
                               "inside out", a / 3, b / 3, from, to);
        p->mate[a] = b;
        p->mate[b] = a;
        i++;
    }
    return status_ok();
}
//<

//> mesh-number-edges
// Numbers the edges in the order in which the corners first name them: the
// first corner becomes half-edge 2e, its mate 2e + 1.  Returns their number.
static int number_edges(const mesh_plan *p)
{
    int edges = 0;
    for (int c = 0; c < p->corners; c++) {
        int mate = p->mate[c];
        int seen = mate >= 0 && mate < c;
        p->half[c] = seen ? mesh_twin(p->half[mate]) : 2 * edges++;
    }
    return edges;
}

// Writes the half-edges of the faces, and the origins of those on a rim.
static void fill_faces(mesh *m, const mesh_plan *p)
{
    for (int v = 0; v < m->vertices; v++) m->vertex_half[v] = -1;

    for (int c = 0; c < p->corners; c++) {
        int f = c / 3, h = p->half[c], v = corner_from(p, c);
        int after = 3 * f + (c % 3 + 1) % 3;
        m->half[h] = (half_edge){ v, p->half[after], f };
        if (p->mate[c] < 0)
            m->half[mesh_twin(h)] = (half_edge){ corner_to(p, c), -1, -1 };
        if (m->vertex_half[v] < 0) m->vertex_half[v] = h;
        if (c % 3 == 0) m->face_half[f] = h;
    }
}
//<

//> mesh-link-rims
// A rim arrives at a vertex and leaves it again: with one fan of triangles
// around every vertex there is one way to go on.  (With two, the rims that
// arrive would both go on along the second; check_fans finds that.)
static void link_rims(mesh *m)
{
    for (int h = 0; h < 2 * m->edges; h++)
        if (m->half[h].face < 0) m->vertex_half[m->half[h].origin] = h;
    for (int h = 0; h < 2 * m->edges; h++)
        if (m->half[h].face < 0)
            m->half[h].next = m->vertex_half[mesh_target(m, h)];
}

// One turn around a vertex meets every half-edge that leaves it, or it is back
// too early: there is a second fan that the turn cannot reach.
static status check_fans(const mesh *m, int *leaving)
{
    memset(leaving, 0, ((size_t)m->vertices + 1) * sizeof *leaving);
    for (int h = 0; h < 2 * m->edges; h++) leaving[m->half[h].origin]++;

    for (int v = 0; v < m->vertices; v++) {
        int start = m->vertex_half[v], h = start;
        for (int met = 1; met < leaving[v]; met++) {
            h = mesh_around(m, h);
            if (h == start)
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

// Room for n elements; never NULL for want of size, only for want of memory.
static void *allocate(int n, size_t size)
{
    return malloc((size_t)(n > 0 ? n : 1) * size);
}

static void plan_free(mesh_plan *p)
{
    free(p->order);
    free(p->half);
    free(p->mate);
    free(p->count);
}

static status plan_allocate(mesh_plan *p)
{
    p->order = allocate(p->corners, sizeof *p->order);
    p->half  = allocate(p->corners, sizeof *p->half);
    p->mate  = allocate(p->corners, sizeof *p->mate);
    p->count = allocate(p->vertices + 1, sizeof *p->count);
    if (p->order && p->half && p->mate && p->count) return status_ok();
    return status_out_of_memory();
}

static status mesh_allocate(mesh *m, int vertices, int edges, int faces)
{
    *m = (mesh){ .vertices = vertices, .edges = edges, .faces = faces };
    m->half        = allocate(2 * edges, sizeof *m->half);
    m->vertex_half = allocate(vertices, sizeof *m->vertex_half);
    m->face_half   = allocate(faces, sizeof *m->face_half);
    if (m->half && m->vertex_half && m->face_half) return status_ok();
    return status_out_of_memory();
}
//<

//> mesh-build
// From triangles that passed every check of their own to a linked mesh.
static status build_from_plan(mesh *m, mesh_plan *p)
{
    status s = plan_allocate(p);
    if (s.ok) s = pair_corners(p);
    if (!s.ok) return s;

    int edges = number_edges(p);
    s = mesh_allocate(m, p->vertices, edges, p->corners / 3);
    if (!s.ok) return s;

    fill_faces(m, p);
    link_rims(m);
    return check_fans(m, p->count);
}

status mesh_build(mesh *m, int vertices, const int (*triangle)[3], int faces)
{
    assert(m && (triangle || faces <= 0));
    *m = (mesh){ 0 };
    if (vertices < 0 || faces < 0)
        return status_fail("a mesh cannot have %d vertices and %d triangles",
                           vertices, faces);
    if (vertices > MOST_VERTICES || faces > MOST_FACES)
        return status_fail("a mesh of %d vertices and %d triangles is too "
                           "large: the most are %d and %d", vertices, faces,
                           MOST_VERTICES, MOST_FACES);

    mesh_plan p = { .triangle = triangle,
                    .vertices = vertices, .corners = 3 * faces };
    status s = check_triangles(&p);
    if (s.ok) s = build_from_plan(m, &p);
    plan_free(&p);
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

//> mesh-walk
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

int mesh_is_closed(const mesh *m)
{
    for (int h = 0; h < 2 * m->edges; h++)
        if (m->half[h].face < 0) return 0;
    return 1;
}

int mesh_euler(const mesh *m)
{
    return m->vertices - m->edges + m->faces;
}
//<

//> mesh-validate-half
// The rules that one half-edge can be asked for.  Every index is checked
// before it is used.
static status validate_half(const mesh *m, int h)
{
    int halves = 2 * m->edges;
    half_edge at = m->half[h];
    if (at.origin < 0 || at.origin >= m->vertices)
        return status_fail("half-edge %d leaves vertex %d, which does not "
                           "exist", h, at.origin);
    if (at.next < 0 || at.next >= halves)
        return status_fail("half-edge %d is followed by half-edge %d, which "
                           "does not exist", h, at.next);
    if (at.face < -1 || at.face >= m->faces)
        return status_fail("half-edge %d borders face %d, which does not "
                           "exist", h, at.face);
    if (at.face < 0 && m->half[mesh_twin(h)].face < 0)
        return status_fail("edge %d has no face on either side", h / 2);
    if (at.origin == mesh_target(m, h))
        return status_fail("edge %d begins and ends in vertex %d", h / 2,
                           at.origin);
    return status_ok();
}
//<

//> mesh-validate-next
// The rules about what follows a half-edge; the indices are known to be good.
// Three steps around a face lead back: so the next of faces is one to one.
static status validate_next(const mesh *m, int h)
{
    int face = m->half[h].face, second = m->half[h].next;
    int third = m->half[second].next;
    if (m->half[second].origin != mesh_target(m, h))
        return status_fail("half-edge %d ends in vertex %d, but half-edge %d "
                           "after it leaves vertex %d", h, mesh_target(m, h),
                           second, m->half[second].origin);
    if (m->half[second].face != face)
        return status_fail("half-edge %d borders face %d, but half-edge %d "
                           "after it borders face %d", h, face, second,
                           m->half[second].face);
    if (face >= 0 && m->half[third].next != h)
        return status_fail("half-edge %d is not back at itself after three "
                           "steps around face %d", h, face);
    return status_ok();
}
//<

//> mesh-validate-faces
// Every face holds one half-edge at least, so it holds three; together they
// must be all that have a face, or some face holds six.
static status validate_faces(const mesh *m)
{
    long long bordered = 0;
    for (int h = 0; h < 2 * m->edges; h++) bordered += m->half[h].face >= 0;

    for (int f = 0; f < m->faces; f++) {
        int h = m->face_half[f];
        if (h < 0 || h >= 2 * m->edges)
            return status_fail("face %d begins with half-edge %d, which does "
                               "not exist", f, h);
        if (m->half[h].face != f)
            return status_fail("face %d begins with half-edge %d, which "
                               "borders face %d", f, h, m->half[h].face);
    }
    if (bordered != 3LL * m->faces)
        return status_fail("%lld half-edges border the %d faces: three times "
                           "as many as faces it must be", bordered, m->faces);
    return status_ok();
}
//<

//> mesh-validate-vertex
static status validate_vertex_half(const mesh *m, int v, int leaving)
{
    int h = m->vertex_half[v];
    if (h == -1 && leaving == 0) return status_ok();
    if (h < 0 || h >= 2 * m->edges)
        return status_fail("vertex %d begins with half-edge %d, which does not "
                           "exist, though %d leave it", v, h, leaving);
    if (m->half[h].origin != v)
        return status_fail("vertex %d begins with half-edge %d, which leaves "
                           "vertex %d", v, h, m->half[h].origin);
    return status_ok();
}

// Turns once around v: all half-edges that leave it, each once, no two to the
// same neighbour, none on the rim but the first.  met_from[w] = v marks the
// neighbours met.  (The last step leads back: of faces the next is one to one,
// and a rim could only lead to another, which is refused.)
static status validate_turn(const mesh *m, int v, int leaving, int *met_from)
{
    int start = m->vertex_half[v], h = start;
    for (int met = 0; met < leaving; met++) {
        if (met > 0 && h == start)
            return status_fail("%d half-edges leave vertex %d, but a turn "
                               "around it does not meet each of them once",
                               leaving, v);
        int to = mesh_target(m, h);
        if (met_from[to] == v)
            return status_fail("two edges join vertex %d and vertex %d", v, to);
        if (met > 0 && m->half[h].face < 0)
            return m->half[start].face < 0
                ? status_fail("two rims pass through vertex %d", v)
                : status_fail("vertex %d is on a rim, but its half-edge %d is "
                              "not the one on it", v, start);
        met_from[to] = v;
        h = mesh_around(m, h);
    }
    return status_ok();
}
//<

//> mesh-validate-vertices
static status validate_vertices(const mesh *m, int *leaving, int *met_from)
{
    for (int v = 0; v < m->vertices; v++) {
        leaving[v] = 0;
        met_from[v] = -1;
    }
    for (int h = 0; h < 2 * m->edges; h++) leaving[m->half[h].origin]++;

    status s = status_ok();
    for (int v = 0; v < m->vertices && s.ok; v++) {
        s = validate_vertex_half(m, v, leaving[v]);
        if (s.ok) s = validate_turn(m, v, leaving[v], met_from);
    }
    return s;
}
//<

//> mesh-validate
status mesh_validate(const mesh *m)
{
    assert(m);
    if (m->vertices < 0 || m->edges < 0 || m->faces < 0
        || m->edges > INT_MAX / 2)
        return status_fail("the mesh counts %d vertices, %d edges and %d faces",
                           m->vertices, m->edges, m->faces);
    if ((m->edges > 0 && !m->half) || (m->vertices > 0 && !m->vertex_half)
        || (m->faces > 0 && !m->face_half))
        return status_fail("the mesh counts elements that it does not hold");

    status s = status_ok();
    for (int h = 0; h < 2 * m->edges && s.ok; h++) s = validate_half(m, h);
    for (int h = 0; h < 2 * m->edges && s.ok; h++) s = validate_next(m, h);
    if (s.ok) s = validate_faces(m);
    if (!s.ok) return s;

    int *leaving = allocate(m->vertices, sizeof *leaving);
    int *met_from = allocate(m->vertices, sizeof *met_from);
    s = leaving && met_from ? validate_vertices(m, leaving, met_from)
                            : status_out_of_memory();
    free(leaving);
    free(met_from);
    return s;
}
//<

//> mesh-volume
// A closed body is the sum of the tetrahedra from one point to each face,
// signed: (a - o) . ((b - o) x (c - o)) / 6.  Where the body bends back, the
// negative ones take away what was counted twice.  The point o is a vertex, so
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

//> mesh-convex-form
// As a share of the size, what counts as nothing.
static const real NOTHING = 1e-9;

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
    if (m->faces == 0) return status_fail("the mesh has no triangle");
    if (mesh_euler(m) != 2)
        return status_fail("the mesh is not one sphere: vertices - edges + "
                           "triangles is %d, not 2", mesh_euler(m));
    return status_ok();
}
//<

//> mesh-convex-size
// The diagonal of the box around the vertices.  Squares of areas appear below:
// the fourth power of the size must be a number, too.
static status measure_size(const mesh *m, const vec3 *at, real *size)
{
    vec3 low = at[0], high = at[0];
    for (int v = 0; v < m->vertices; v++) {
        if (!vec3_is_finite(at[v]))
            return status_fail("vertex %d is not at a finite place", v);
        low  = vec3_make(real_min(low.x, at[v].x), real_min(low.y, at[v].y),
                         real_min(low.z, at[v].z));
        high = vec3_make(real_max(high.x, at[v].x), real_max(high.y, at[v].y),
                         real_max(high.z, at[v].z));
    }
    *size = vec3_distance(high, low);
    if (!(*size > 1e-60 && *size < 1e60))
        return status_fail("the mesh measures %g m: too %s to compute with",
                           *size, *size < 1 ? "small" : "large");
    return status_ok();
}

// Two vertices in one place would let a surface wind twice around its body.
static status check_apart(const mesh *m, const vec3 *at, real size)
{
    real least = NOTHING * size * (NOTHING * size);
    for (int v = 0; v < m->vertices; v++)
        for (int w = v + 1; w < m->vertices; w++)
            if (!(vec3_length_squared(vec3_sub(at[v], at[w])) > least))
                return status_fail("vertex %d and vertex %d stand in the same "
                                   "place", v, w);
    return status_ok();
}
//<

//> mesh-convex-faces
// The outward normal of face f, as long as twice its area, in m^2.
static vec3 face_normal(const vec3 *at, const int v[3])
{
    return vec3_cross(vec3_sub(at[v[1]], at[v[0]]),
                      vec3_sub(at[v[2]], at[v[0]]));
}

// A triangle is flat if its height over its longest side is nothing:
// height = 2 area / longest side.
static status check_not_flat(const mesh *m, const vec3 *at, int f, real size)
{
    int v[3];
    mesh_face(m, f, v);
    real longest = real_max(vec3_distance(at[v[0]], at[v[1]]),
                            real_max(vec3_distance(at[v[1]], at[v[2]]),
                                     vec3_distance(at[v[2]], at[v[0]])));
    real twice_area = vec3_length(face_normal(at, v));
    if (!(twice_area > NOTHING * size * longest))
        return status_fail("triangle %d is flat: vertex %d, vertex %d and "
                           "vertex %d stand in one line", f, v[0], v[1], v[2]);
    return status_ok();
}

// Every vertex lies in the plane of face f or below it, and one well below.
static status check_face_convex(const mesh *m, const vec3 *at, int f, real size)
{
    int v[3];
    mesh_face(m, f, v);
    vec3 normal = vec3_unit(face_normal(at, v));
    real highest = 0, lowest = 0;
    int top = v[0];
    for (int w = 0; w < m->vertices; w++) {
        real height = vec3_dot(normal, vec3_sub(at[w], at[v[0]]));
        if (height > highest) { highest = height; top = w; }
        if (height < lowest) lowest = height;
    }
    if (!(highest <= NOTHING * size))
        return status_fail("vertex %d stands %.2g of the size outside the "
                           "plane of triangle %d: the mesh is not convex", top,
                           highest / size, f);
    if (!(lowest < -NOTHING * size))
        return status_fail("the mesh has no thickness: no vertex stands below "
                           "the plane of triangle %d", f);
    return status_ok();
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
    for (int f = 0; f < m->faces && s.ok; f++)
        s = check_not_flat(m, at, f, size);
    if (!s.ok) return s;

    // All faces turned round: convex, but seen from inside.  (A volume of
    // 1e-12 of the cube of the size is rounding, and says nothing.)
    if (mesh_volume(m, at) < -1e-12 * (size * size * size))
        return status_fail("the triangles look inwards: every one of them must "
                           "be turned round");
    for (int f = 0; f < m->faces && s.ok; f++)
        s = check_face_convex(m, at, f, size);
    return s;
}
//<
