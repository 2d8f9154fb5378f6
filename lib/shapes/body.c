//> body-check
#include "body.h"

#include <assert.h>
#include <limits.h>
#include <stdint.h>
#include <stdlib.h>

// Lengths in metres and masses in kilograms: wider than anything to be built,
// and narrow enough that the fourth power of each is still a number.
static const real LEAST = 1e-30;
static const real MOST  = 1e30;

static status check_quantity(const char *name, real value, const char *unit)
{
    if (value >= LEAST && value <= MOST) return status_ok();
    return status_fail("the %s is %g %s: it must be a number from %g to %g",
                       name, value, unit, LEAST, MOST);
}

static status check_count(const char *name, int value, int least, int most)
{
    if (value >= least && value <= most) return status_ok();
    return status_fail("the number of %s is %d: it must be from %d to %d",
                       name, value, least, most);
}
//<

//> body-reserve
// Room for n elements, zeroed; never NULL for want of size.
static void *allocate(int n, size_t size)
{
    return calloc((size_t)(n > 0 ? n : 1), size);
}

// The particles, equal shares of the mass at the origin, and room for sticks:
// s->sticks counts those that are there, most of them may be added.
static status shape_reserve(shape *s, int particles, int most_sticks, real mass)
{
    s->particles = particles;
    s->at    = allocate(particles, sizeof *s->at);
    s->mass  = allocate(particles, sizeof *s->mass);
    s->stick = allocate(most_sticks, sizeof *s->stick);
    s->ring_start = allocate(particles + 1, sizeof *s->ring_start);
    if (!s->at || !s->mass || !s->stick || !s->ring_start)
        return status_out_of_memory();
    for (int i = 0; i < particles; i++) s->mass[i] = mass / particles;
    return status_ok();
}

static void add_stick(shape *s, int a, int b, real length, real stiffness)
{
    s->stick[s->sticks++] = (stick){ .a = a, .b = b, .rest_length = length,
                                     .stiffness = stiffness,
                                     .kind = STICK_EXACT };
}

// A full stick as long as its ends are apart.
static void add_stick_between(shape *s, int a, int b)
{
    add_stick(s, a, b, vec3_distance(s->at[a], s->at[b]), 1);
}

static void add_edge_sticks(shape *s)
{
    for (int e = 0; e < s->mesh.edges; e++)
        add_stick_between(s, s->mesh.half[2 * e].origin,
                          s->mesh.half[2 * e + 1].origin);
}
//<

//> body-span
// The mesh neighbours of each vertex, in the order of a turn around it.
static void fill_rings(shape *s)
{
    const mesh *m = &s->mesh;
    int filled = 0;
    for (int v = 0; v < m->vertices; v++) {
        int start = m->vertex_half[v], h = start;
        s->ring_start[v] = filled;
        if (start < 0) continue;
        do {
            s->ring[filled++] = mesh_target(m, h);
            h = mesh_around(m, h);
        } while (h != start && filled < 2 * m->edges);
    }
    s->ring_start[m->vertices] = filled;
}

// Spans the mesh over the particles.
static status shape_span(shape *s, const int (*triangle)[3], int faces)
{
    status r = mesh_build(&s->mesh, s->particles, triangle, faces);
    if (!r.ok) return r;
    s->face = allocate(3 * faces, sizeof *s->face);
    s->ring = allocate(2 * s->mesh.edges, sizeof *s->ring);
    if (!s->face || !s->ring) return status_out_of_memory();

    for (int f = 0; f < faces; f++) mesh_face(&s->mesh, f, &s->face[3 * f]);
    fill_rings(s);
    return status_ok();
}
//<

//> body-measure
static void measure_radius(shape *s)
{
    real farthest = 0;
    for (int i = 0; i < s->particles; i++) {
        real squared = vec3_length_squared(s->at[i]);
        if (squared > farthest) farthest = squared;
    }
    s->radius = sqrt(farthest);
}

// The origin of a convex body lies behind all of its faces, and so far behind
// the nearest.
static void measure_inner(shape *s)
{
    s->inner = s->kind == SHAPE_RIGID ? s->radius : 0;
    for (int f = 0; f < s->mesh.faces && s->kind == SHAPE_RIGID; f++) {
        const int *v = &s->face[3 * f];
        vec3 m = vec3_unit(vec3_cross(vec3_sub(s->at[v[1]], s->at[v[0]]),
                                      vec3_sub(s->at[v[2]], s->at[v[0]])));
        s->inner = fmax(fmin(s->inner, vec3_dot(m, s->at[v[0]])), 0);
    }
}

static void measure_spacing(shape *s)
{
    s->spacing = s->stick[0].rest_length;
    for (int k = 1; k < s->sticks; k++)
        if (s->stick[k].rest_length < s->spacing)
            s->spacing = s->stick[k].rest_length;
}
//<

//> body-finish
// The last thing that every builder does: a shape is measured, or emptied.
static status shape_finish(shape *s, status so_far)
{
    if (!so_far.ok) {
        shape_free(s);
        return so_far;
    }
    measure_radius(s);
    measure_inner(s);
    measure_spacing(s);
    return so_far;
}

// The same for a body that has its sticks, in no good order yet.
static status shape_finish_interleaved(shape *s)
{
    return shape_finish(s, sticks_interleave(s->stick, s->sticks,
                                             s->particles));
}

void shape_free(shape *s)
{
    free(s->at);
    free(s->mass);
    free(s->stick);
    free(s->face);
    free(s->ring_start);
    free(s->ring);
    mesh_free(&s->mesh);
    *s = (shape){ 0 };
}
//<

//> body-box
// Corner k stands at +x if bit 0 of k is set, at +y for bit 1, at +z for bit 2;
// the corner opposite is 7 - k.  Each side is cut along the diagonal between
// its two corners with an even number of bits: 0, 3, 5, 6, a tetrahedron.
static const int BOX[12][3] = {
    { 0, 4, 6 }, { 0, 6, 2 }, { 3, 7, 5 }, { 3, 5, 1 },     // -x, +x
    { 0, 1, 5 }, { 0, 5, 4 }, { 3, 2, 6 }, { 3, 6, 7 },     // -y, +y
    { 0, 2, 3 }, { 0, 3, 1 }, { 5, 7, 6 }, { 5, 6, 4 }      // -z, +z
};

status shape_box(shape *s, vec3 sides, real mass)
{
    assert(s);
    *s = (shape){ .kind = SHAPE_RIGID };
    status r = check_quantity("side along x", sides.x, "m");
    if (r.ok) r = check_quantity("side along y", sides.y, "m");
    if (r.ok) r = check_quantity("side along z", sides.z, "m");
    if (r.ok) r = check_quantity("mass", mass, "kg");
    if (r.ok) r = shape_reserve(s, 8, 18 + 4, mass);
    if (!r.ok) return shape_finish(s, r);

    for (int k = 0; k < 8; k++)
        s->at[k] = vec3_make(k & 1 ? sides.x / 2 : -sides.x / 2,
                             k & 2 ? sides.y / 2 : -sides.y / 2,
                             k & 4 ? sides.z / 2 : -sides.z / 2);
    r = shape_span(s, BOX, 12);
    if (r.ok) r = mesh_check_convex(&s->mesh, s->at);
    if (!r.ok) return shape_finish(s, r);

    add_edge_sticks(s);
    for (int k = 0; k < 4; k++) add_stick_between(s, k, 7 - k);
    return shape_finish_interleaved(s);
}
//<

//> body-icosahedron
// Three golden rectangles, one in each coordinate plane: corner 4 axis + k is
// (0, +-1, +-g) with its coordinates moved on by axis places, g the golden
// ratio, and bits 0 and 1 of k the signs.  The corner opposite flips both.
static const int ICOSAHEDRON[20][3] = {
    { 0, 4, 1 },  { 0, 1, 6 },  { 0, 8, 4 },  { 0, 6, 9 },   { 0, 9, 8 },
    { 1, 4, 10 }, { 1, 11, 6 }, { 1, 10, 11 }, { 2, 3, 5 },  { 2, 7, 3 },
    { 2, 5, 8 },  { 2, 9, 7 },  { 2, 8, 9 },  { 3, 10, 5 },  { 3, 7, 11 },
    { 3, 11, 10 }, { 4, 8, 5 }, { 4, 5, 10 }, { 6, 7, 9 },   { 6, 11, 7 }
};

// Golden: g^2 = g + 1, so g = (1 + sqrt(5)) / 2, and a corner is
// sqrt(1 + g^2) from the centre.
static void place_icosahedron(vec3 *at, real radius)
{
    real golden = (1 + sqrt(5.0)) / 2;
    real unit = radius / sqrt(1 + golden * golden);
    for (int k = 0; k < 4; k++) {
        real one = k & 1 ? unit : -unit;
        real g   = k & 2 ? golden * unit : -(golden * unit);
        at[k]     = vec3_make(0, one, g);
        at[4 + k] = vec3_make(g, 0, one);
        at[8 + k] = vec3_make(one, g, 0);
    }
}

status shape_icosahedron(shape *s, real radius, real mass)
{
    assert(s);
    *s = (shape){ .kind = SHAPE_RIGID };
    status r = check_quantity("radius", radius, "m");
    if (r.ok) r = check_quantity("mass", mass, "kg");
    if (r.ok) r = shape_reserve(s, 12, 30 + 6, mass);
    if (!r.ok) return shape_finish(s, r);

    place_icosahedron(s->at, radius);
    r = shape_span(s, ICOSAHEDRON, 20);
    if (!r.ok) return shape_finish(s, r);

    add_edge_sticks(s);
    for (int k = 0; k < 12; k++)
        if (k < (k ^ 3)) add_stick_between(s, k, k ^ 3);
    return shape_finish_interleaved(s);
}
//<

//> body-centre
// Moves the particles so that their mean, the centre of equal masses, is the
// origin.  Measured from particle 0: a body far away loses no digits twice.
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

static int are_neighbours(const shape *s, int v, int w)
{
    for (int k = s->ring_start[v]; k < s->ring_start[v + 1]; k++)
        if (s->ring[k] == w) return 1;
    return 0;
}
//<

//> body-flat
// As a share of the radius: a tetrahedron that is lower holds nothing up.
static const real FLAT = 1e-3;

// The normal of length 1 of face f.
static vec3 face_direction(const shape *s, int f)
{
    const int *v = &s->face[3 * f];
    return vec3_unit(vec3_cross(vec3_sub(s->at[v[1]], s->at[v[0]]),
                                vec3_sub(s->at[v[2]], s->at[v[0]])));
}

// Does the apex, vertex 0, lie in the plane of every face around v?  Then all
// tetrahedra at v are flat, and nothing but the plane holds v.
static int has_flat_tetrahedra(const shape *s, int v)
{
    int start = s->mesh.vertex_half[v], h = start;
    vec3 to_apex = vec3_sub(s->at[0], s->at[v]);
    for (int k = s->ring_start[v]; k < s->ring_start[v + 1]; k++) {
        int f = s->mesh.half[h].face;
        if (vec3_dot(face_direction(s, f), to_apex) < -FLAT * s->radius)
            return 0;
        h = mesh_around(&s->mesh, h);
    }
    return 1;
}

// The vertex farthest below the plane of v's first face, of which there is one
// in every convex body; the lowest index wins.
static int farthest_below(const shape *s, int v)
{
    vec3 normal = face_direction(s, s->mesh.half[s->mesh.vertex_half[v]].face);
    real lowest = 0;
    int bottom = v;
    for (int w = 0; w < s->particles; w++) {
        real height = vec3_dot(normal, vec3_sub(s->at[w], s->at[v]));
        if (height < lowest) { lowest = height; bottom = w; }
    }
    return bottom;
}
//<

//> body-tetrahedra
static void add_fan_sticks(shape *s)
{
    for (int v = 1; v < s->particles; v++)
        if (!are_neighbours(s, 0, v)) add_stick_between(s, 0, v);
}

// One stick across the body for every vertex where the fan is flat.  Two such
// vertices may choose each other: `first` is where these sticks begin.
static void add_cross_sticks(shape *s)
{
    int first = s->sticks;
    for (int v = 1; v < s->particles; v++) {
        if (!has_flat_tetrahedra(s, v)) continue;
        int far = farthest_below(s, v);
        int joined = far == 0 || are_neighbours(s, v, far);
        for (int k = first; k < s->sticks; k++)
            if (s->stick[k].a == far && s->stick[k].b == v) joined = 1;
        if (!joined) add_stick_between(s, v, far);
    }
}
//<

//> body-convex
// A mesh of sphere type over n vertices has 3 n - 6 edges: with a stick to
// vertex 0 and one across for each vertex, 5 n are enough.
enum { MOST_CONVEX = 16384 };

// Paper: "a restricted 3D triangulation", which a general polyhedron need not
// have; here: a fan from one vertex, because a convex body always has that.
status shape_convex(shape *s, int vertices, const vec3 *at,
                    int faces, const int (*triangle)[3], real mass)
{
    assert(s && (at || vertices <= 0) && (triangle || faces <= 0));
    *s = (shape){ .kind = SHAPE_RIGID };
    status r = check_quantity("mass", mass, "kg");
    if (r.ok) r = check_count("vertices", vertices, 4, MOST_CONVEX);
    if (r.ok) r = shape_reserve(s, vertices, 5 * vertices, mass);
    if (r.ok) r = shape_span(s, triangle, faces);
    if (r.ok) r = mesh_check_convex(&s->mesh, at);
    if (!r.ok) return shape_finish(s, r);

    for (int i = 0; i < vertices; i++) s->at[i] = at[i];
    move_to_centre(s);
    measure_radius(s);
    r = check_quantity("radius", s->radius, "m");
    if (!r.ok) return shape_finish(s, r);

    add_edge_sticks(s);
    add_fan_sticks(s);
    add_cross_sticks(s);
    return shape_finish_interleaved(s);
}
//<

//> body-rope
status shape_rope(shape *s, int n, real length, real mass)
{
    assert(s);
    *s = (shape){ .kind = SHAPE_ROPE };
    status r = check_count("links", n, 1, 1000000);
    if (r.ok) r = check_quantity("length", length, "m");
    if (r.ok) r = check_quantity("mass", mass, "kg");
    if (r.ok) r = shape_reserve(s, n + 1, n, mass);
    if (!r.ok) return shape_finish(s, r);

    // From -length / 2 to length / 2, each half the mirror of the other.
    for (int k = 0; k <= n; k++)
        s->at[k] = vec3_make(length * (2 * k - n) / (2 * n), 0, 0);
    for (int k = 0; k < n; k++) add_stick(s, k, k + 1, length / n, 1);
    s->strand[0] = (strands){ .lines = 1, .particles = n + 1, .across = n + 1,
                              .along = 1, .rest_length = length / n };
    s->directions = 1;
    s->on_strands = n;
    return shape_finish_interleaved(s);
}
//<

//> body-cloth-sticks
// The sticks of one direction: from (i, j) to (i + di, j + dj) for i = i0,
// i0 + step_i ..., j = j0, j0 + step_j ..., as long as both ends exist.
typedef struct {
    int columns, rows;
    int i0, j0, step_i, step_j;
    int di, dj;
    real length, stiffness;
} cloth_run;

static void add_run(shape *s, cloth_run r)
{
    for (int j = r.j0; j + r.dj < r.rows; j += r.step_j)
        for (int i = r.i0; i < r.columns; i += r.step_i)
            if (i + r.di >= 0 && i + r.di < r.columns)
                add_stick(s, j * r.columns + i,
                          (j + r.dj) * r.columns + i + r.di,
                          r.length, r.stiffness);
}

// Eight runs, and no two sticks of a run share a particle: along the columns
// from even rows, from odd rows; along the rows from even and odd columns; and
// the same with the diagonals.  A processor need not wait for one stick to
// begin the next.  Soft diagonals come last, after the sticks that must hold.
// Cell (i, j) is cut from (i, j) if i + j is even, else from (i + 1, j): every
// diagonal ends in particles with an even i + j.
static void add_cloth_sticks(shape *s, int columns, int rows,
                             real dx, real dz, real diagonal)
{
    real across = sqrt(dx * dx + dz * dz);
    for (int odd = 0; odd < 2; odd++)
        add_run(s, (cloth_run){ columns, rows, 0, odd, 1, 2, 0, 1, dz, 1 });
    for (int odd = 0; odd < 2; odd++)
        add_run(s, (cloth_run){ columns, rows, odd, 0, 2, 1, 1, 0, dx, 1 });
    for (int odd = 0; odd < 2; odd++)
        add_run(s, (cloth_run){ columns, rows, odd, odd, 2, 2, 1, 1,
                                across, diagonal });
    for (int odd = 0; odd < 2; odd++)
        add_run(s, (cloth_run){ columns, rows, odd, odd, 2, 2, -1, 1,
                                across, diagonal });
}
//<

//> body-cloth-strands
// The columns, along z, and the rows, along x: what the first four runs hold.
static void add_cloth_strands(shape *s, int columns, int rows,
                              real dx, real dz)
{
    s->strand[0] = (strands){ .lines = columns, .particles = rows, .across = 1,
                              .along = columns, .rest_length = dz };
    s->strand[1] = (strands){ .lines = rows, .particles = columns,
                              .across = columns, .along = 1,
                              .rest_length = dx };
    s->directions = 2;
    s->on_strands = columns * (rows - 1) + rows * (columns - 1);
}
//<

//> body-cloth-faces
// Two triangles a cell, turned so that they look up: z x x = y.
static void fill_cloth_faces(int (*triangle)[3], int columns, int rows)
{
    int f = 0;
    for (int j = 0; j + 1 < rows; j++)
        for (int i = 0; i + 1 < columns; i++) {
            int a = j * columns + i, b = a + 1;
            int c = a + columns, d = c + 1;
            int even = (i + j) % 2 == 0;
            int first[3]  = { a, c, even ? d : b };
            int second[3] = { even ? a : b, even ? d : c, even ? b : d };
            for (int k = 0; k < 3; k++) {
                triangle[f][k] = first[k];
                triangle[f + 1][k] = second[k];
            }
            f += 2;
        }
}

static status span_cloth(shape *s, int columns, int rows)
{
    int faces = 2 * (columns - 1) * (rows - 1);
    int (*triangle)[3] = allocate(faces, sizeof *triangle);
    if (!triangle) return status_out_of_memory();
    fill_cloth_faces(triangle, columns, rows);
    status r = shape_span(s, (const int (*)[3])triangle, faces);
    free(triangle);
    return r;
}
//<

//> body-cloth
static status check_cloth(int columns, int rows, real width, real depth,
                          real mass, real diagonal)
{
    status r = check_count("columns", columns, 2, 2048);
    if (r.ok) r = check_count("rows", rows, 2, 2048);
    if (r.ok) r = check_quantity("width", width, "m");
    if (r.ok) r = check_quantity("depth", depth, "m");
    if (r.ok) r = check_quantity("mass", mass, "kg");
    if (r.ok && !(diagonal > 0 && diagonal <= 1))
        r = status_fail("the stiffness of the diagonals is %g: it must be "
                        "above 0 and at most 1", diagonal);
    return r;
}

status shape_cloth(shape *s, int columns, int rows, real width, real depth,
                   real mass, real diagonal)
{
    assert(s);
    *s = (shape){ .kind = SHAPE_CLOTH };
    status r = check_cloth(columns, rows, width, depth, mass, diagonal);
    if (!r.ok) return shape_finish(s, r);

    int across = columns - 1, along = rows - 1;     // cells
    int sticks = columns * along + rows * across + across * along;
    r = shape_reserve(s, columns * rows, sticks, mass);
    if (r.ok) r = span_cloth(s, columns, rows);
    if (!r.ok) return shape_finish(s, r);

    for (int j = 0; j < rows; j++)
        for (int i = 0; i < columns; i++)
            s->at[j * columns + i] =
                vec3_make(width * (2 * i - across) / (2 * across), 0,
                          depth * (2 * j - along) / (2 * along));
    add_cloth_sticks(s, columns, rows, width / across, depth / along, diagonal);
    add_cloth_strands(s, columns, rows, width / across, depth / along);
    return shape_finish(s, r);
}
//<

//> body-rigidity-matrix
// One row a stick, three columns a particle.  A stick from a to b along the
// unit vector u keeps its length under velocities v if u . (v_b - v_a) = 0:
// its row holds -u at a and u at b.  NULL if memory is refused, or the size of
// the matrix is no number.
static real *rigidity_matrix(const shape *s)
{
    size_t columns = 3 * (size_t)s->particles;
    if (columns > SIZE_MAX / sizeof(real) / (size_t)s->sticks) return NULL;
    real *matrix = calloc((size_t)s->sticks * columns, sizeof *matrix);
    if (!matrix) return NULL;

    for (int k = 0; k < s->sticks; k++) {
        int a = s->stick[k].a, b = s->stick[k].b;
        vec3 u = vec3_unit(vec3_sub(s->at[b], s->at[a]));
        real *row = matrix + (size_t)k * columns;
        real *at_a = row + 3 * (size_t)a, *at_b = row + 3 * (size_t)b;
        at_a[0] = -u.x; at_a[1] = -u.y; at_a[2] = -u.z;
        at_b[0] =  u.x; at_b[1] =  u.y; at_b[2] =  u.z;
    }
    return matrix;
}
//<

//> body-eliminate
// Brings the largest entry that is left, at or below row k and at or right of
// column k, to place (k, k), and returns its size.  The first of equals wins.
static real bring_pivot(real *matrix, size_t rows, size_t columns, size_t k)
{
    size_t best_row = k, best_column = k;
    real best = 0;
    for (size_t i = k; i < rows; i++)
        for (size_t j = k; j < columns; j++)
            if (fabs(matrix[i * columns + j]) > best) {
                best = fabs(matrix[i * columns + j]);
                best_row = i;
                best_column = j;
            }
    for (size_t j = 0; j < columns; j++) {
        real kept = matrix[k * columns + j];
        matrix[k * columns + j] = matrix[best_row * columns + j];
        matrix[best_row * columns + j] = kept;
    }
    for (size_t i = 0; i < rows; i++) {
        real kept = matrix[i * columns + k];
        matrix[i * columns + k] = matrix[i * columns + best_column];
        matrix[i * columns + best_column] = kept;
    }
    return best;
}

// Clears column k below row k.
static void clear_below(real *matrix, size_t rows, size_t columns, size_t k)
{
    const real *pivot = matrix + k * columns;
    for (size_t i = k + 1; i < rows; i++) {
        real *row = matrix + i * columns;
        real share = row[k] / pivot[k];
        if (share == 0) continue;
        for (size_t j = k; j < columns; j++) row[j] -= share * pivot[j];
    }
}
//<

//> body-rank
// What elimination leaves of a row that depends on others is rounding, 1e-16
// of the first pivot and its growth; below this share a pivot is nothing.
static const real RANK_NOTHING = 1e-9;

int shape_rank(const shape *s)
{
    assert(s);
    if (s->sticks == 0) return 0;
    real *matrix = rigidity_matrix(s);
    if (!matrix) return -1;

    size_t rows = (size_t)s->sticks, columns = 3 * (size_t)s->particles;
    size_t most = rows < columns ? rows : columns, rank = 0;
    real first = 0;
    for (; rank < most; rank++) {
        real pivot = bring_pivot(matrix, rows, columns, rank);
        if (rank == 0) first = pivot;
        if (!(pivot > RANK_NOTHING * first)) break;
        clear_below(matrix, rows, columns, rank);
    }
    free(matrix);
    return (int)rank;
}
//<
