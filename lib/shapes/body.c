//> body-check
//>   Every number that comes from outside is checked. The comparison asks
//>   whether the number lies between the least and the greatest that are
//>   allowed. A NaN does not, so it is refused, too.
#include "body.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

// Lengths in m and masses in kg.  The fourth power of both ends is still a
// number, so no product of four lengths overflows.
static const real LEAST = 1e-30;
static const real MOST  = 1e30;

// A NaN is not in the range either: no comparison with it holds.
status size_check(const char *name, real value, const char *unit)
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

//> body-begin
//>   A shape is begun with its particles, then its surface is spanned.
status shape_begin(shape *s, shape_kind kind, int particles, int most_sticks,
                   real mass)
{
    assert(s && particles >= 1 && most_sticks >= 0);
    *s = (shape){ .kind = kind, .particles = particles };
    status r = size_check("mass", mass, "kg");
    if (!r.ok) return r;
    s->at    = calloc((size_t)particles, sizeof *s->at);
    s->mass  = calloc((size_t)particles, sizeof *s->mass);
    s->stick = calloc((size_t)most_sticks + 1, sizeof *s->stick);
    if (!s->at || !s->mass || !s->stick) return status_out_of_memory();
    for (int i = 0; i < particles; i++) s->mass[i] = mass / particles;
    return r;
}

status shape_span(shape *s, const int (*triangle)[3], int faces)
{
    status r = mesh_build(&s->mesh, s->particles, triangle, faces);
    if (!r.ok) return r;
    s->face = calloc((size_t)faces + 1, 3 * sizeof *s->face);
    if (!s->face) return status_out_of_memory();
    for (int f = 0; f < faces; f++) mesh_face(&s->mesh, f, &s->face[3 * f]);
    return r;
}
//<

//> body-add
//>   Then come the sticks, one by one or along all edges of the mesh.
static void add_stick(shape *s, int a, int b, real length, real stiffness)
{
    s->stick[s->sticks++] = (stick){ .a = a, .b = b, .rest_length = length,
                                     .stiffness = stiffness,
                                     .kind = STICK_EXACT };
}

void shape_add_stick(shape *s, int a, int b)
{
    assert(a != b && int_min(a, b) >= 0 && int_max(a, b) < s->particles);
    add_stick(s, a, b, vec3_distance(s->at[a], s->at[b]), 1);
}

void shape_add_edges(shape *s)
{
    for (int e = 0; e < s->mesh.edges; e++)
        shape_add_stick(s, s->mesh.half[2 * e].origin,
                        s->mesh.half[2 * e + 1].origin);
}

status shape_add_angle(shape *s, angle c)
{
    size_t room = (size_t)s->angles + 1;
    angle *more = realloc(s->angle, room * sizeof *more);
    if (!more) return status_out_of_memory();
    s->angle = more;
    s->angle[s->angles++] = c;
    return status_ok();
}
//<

//> body-finish
//>   At the end the shape is measured. If anything went wrong on the way, all
//>   of it is freed.
static void measure_shape(shape *s)
{
    s->radius = 0;
    for (int i = 0; i < s->particles; i++)
        s->radius = real_max(s->radius, vec3_length(s->at[i]) + s->round);
    s->spacing = s->sticks > 0 ? s->stick[0].rest_length : 0;
    for (int k = 1; k < s->sticks; k++)
        s->spacing = real_min(s->spacing, s->stick[k].rest_length);
}

// The length of a stick is NaN where one of its ends is.
static status check_sticks(const shape *s)
{
    for (int k = 0; k < s->sticks; k++)
        if (!(s->stick[k].rest_length > 0))
            return status_fail("stick %d joins particles %d and %d, which do "
                               "not stand in two places", k, s->stick[k].a,
                               s->stick[k].b);
    return status_ok();
}

status shape_finish(shape *s, status so_far)
{
    if (so_far.ok) so_far = check_sticks(s);
    if (so_far.ok) {
        measure_shape(s);
        so_far = size_check("radius", s->radius, "m");
    }
    if (!so_far.ok) shape_free(s);
    return so_far;
}

void shape_free(shape *s)
{
    free(s->at);
    free(s->mass);
    free(s->stick);
    free(s->angle);
    free(s->face);
    free(s->skin.at);
    free(s->skin.face);
    mesh_free(&s->mesh);
    *s = (shape){ 0 };
}

struct skin shape_skin(const shape *s)
{
    if (s->skin.points > 0) return s->skin;
    return (struct skin){ s->particles, s->mesh.faces, s->at, s->face };
}
//<

//> body-box
// The vertices of a box are the numbers 0 to 7 in binary, and the one opposite
// to k is 7 - k.  Each side is cut along the diagonal between its two vertices
// with an even number of bits: 0, 3, 5 and 6, a tetrahedron.
static const int BOX[12][3] = {
    { 0, 4, 6 }, { 0, 6, 2 }, { 3, 7, 5 }, { 3, 5, 1 },     // -x, +x
    { 0, 1, 5 }, { 0, 5, 4 }, { 3, 2, 6 }, { 3, 6, 7 },     // -y, +y
    { 0, 2, 3 }, { 0, 3, 1 }, { 5, 7, 6 }, { 5, 6, 4 }      // -z, +z
};

static status check_sides(vec3 sides)
{
    status r = size_check("side along x", sides.x, "m");
    if (r.ok) r = size_check("side along y", sides.y, "m");
    return r.ok ? size_check("side along z", sides.z, "m") : r;
}

status shape_box(shape *s, vec3 sides, real mass)
{
    status r = shape_begin(s, SHAPE_RIGID, 8, 18 + 4, mass);
    if (r.ok) r = check_sides(sides);
    if (r.ok) r = shape_span(s, BOX, 12);
    if (!r.ok) return shape_finish(s, r);

    for (int k = 0; k < 8; k++)
        s->at[k] = vec3_make(k & 1 ? sides.x / 2 : -sides.x / 2,
                             k & 2 ? sides.y / 2 : -sides.y / 2,
                             k & 4 ? sides.z / 2 : -sides.z / 2);
    shape_add_edges(s);
    for (int k = 0; k < 4; k++) shape_add_stick(s, k, 7 - k);
    return shape_finish(s, r);
}
//<

//> body-icosahedron
//>   The vertices of an icosahedron are the corners of three golden rectangles
//>   that cross at right angles. So no sine is needed.
// The corners of three golden rectangles, one in each coordinate plane: vertex
// 4 axis + k is (0, +-1, +-g) with its coordinates moved on by axis places.
// Bits 0 and 1 of k are the signs; the vertex opposite flips both.
static const int ICOSAHEDRON[20][3] = {
    { 0, 4, 1 },  { 0, 1, 6 },  { 0, 8, 4 },  { 0, 6, 9 },   { 0, 9, 8 },
    { 1, 4, 10 }, { 1, 11, 6 }, { 1, 10, 11 }, { 2, 3, 5 },  { 2, 7, 3 },
    { 2, 5, 8 },  { 2, 9, 7 },  { 2, 8, 9 },  { 3, 10, 5 },  { 3, 7, 11 },
    { 3, 11, 10 }, { 4, 8, 5 }, { 4, 5, 10 }, { 6, 7, 9 },   { 6, 11, 7 }
};

// The golden ratio g = (1 + sqrt(5)) / 2; a vertex stands sqrt(1 + g^2) from
// the centre.
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
    status r = shape_begin(s, SHAPE_RIGID, 12, 30 + 6, mass);
    if (r.ok) r = size_check("radius", radius, "m");
    if (r.ok) r = shape_span(s, ICOSAHEDRON, 20);
    if (!r.ok) return shape_finish(s, r);

    place_icosahedron(s->at, radius);
    shape_add_edges(s);
    for (int k = 0; k < 12; k++)
        if (k < (k ^ 3)) shape_add_stick(s, k, k ^ 3);
    return shape_finish(s, r);
}
//<

//> body-rope
//>   A rope is a row of sticks. A cloth is a grid with one diagonal in each
//>   cell. The diagonals are sticks like the others, but soft; chapter 09 shows
//>   why.
status shape_rope(shape *s, int n, real length, real mass)
{
    *s = (shape){ .kind = SHAPE_ROPE };
    status r = check_count("links", n, 1, 1000000);
    if (r.ok) r = size_check("length", length, "m");
    if (r.ok) r = shape_begin(s, SHAPE_ROPE, n + 1, n, mass);
    if (!r.ok) return shape_finish(s, r);

    // From -length / 2 to length / 2, each half the mirror of the other.
    for (int k = 0; k <= n; k++)
        s->at[k] = vec3_make(length * (2 * k - n) / (2 * n), 0, 0);
    for (int k = 0; k < n; k++) add_stick(s, k, k + 1, length / n, 1);
    s->columns = n + 1;
    s->rows = 1;
    return shape_finish(s, r);
}
//<

//> body-cloth-sticks
// The diagonals of the cells (i, j) in every second row from row `first` on.
// Cells where i + j is even are cut from (i, j), odd ones from (i + 1, j).
static void add_diagonals(shape *s, int first, bool odd, real length,
                          real stiffness)
{
    int across = s->columns;
    for (int j = first; j + 1 < s->rows; j += 2)
        for (int i = (j + odd) % 2; i + 1 < across; i += 2) {
            int a = j * across + i;
            if (odd) add_stick(s, a + 1, a + across, length, stiffness);
            else     add_stick(s, a, a + across + 1, length, stiffness);
        }
}

// Neighbours in this list share no particle, except where a row ends: so a
// processor does not wait for one stick before it begins the next.
static void add_cloth_sticks(shape *s, real dx, real dz, real diagonal)
{
    int across = s->columns;
    for (int j = 0; j + 1 < s->rows; j++)
        for (int i = 0; i < across; i++)
            add_stick(s, j * across + i, (j + 1) * across + i, dz, 1);
    for (int i = 0; i + 1 < across; i++)
        for (int j = 0; j < s->rows; j++)
            add_stick(s, j * across + i, j * across + i + 1, dx, 1);
    real length = sqrt(dx * dx + dz * dz);
    for (int k = 0; k < 4; k++)
        add_diagonals(s, k % 2, k > 1, length, diagonal);
}
//<

//> body-cloth-faces
//>   A cell is two triangles. So is one of a terrain (chapter 19).
void shape_cut_cells(int (*triangle)[3], int columns, int rows)
{
    int f = 0;
    for (int j = 0; j + 1 < rows; j++)
        for (int i = 0; i + 1 < columns; i++, f += 2) {
            int a = j * columns + i, b = a + 1;
            int c = a + columns, d = c + 1;
            int even[2][3] = { { a, c, d }, { a, d, b } };
            int odd[2][3]  = { { a, c, b }, { b, c, d } };
            memcpy(triangle[f], (i + j) % 2 ? odd : even, sizeof even);
        }
}

static status span_cloth(shape *s, int columns, int rows)
{
    int faces = 2 * (columns - 1) * (rows - 1);
    int (*triangle)[3] = calloc((size_t)faces, sizeof *triangle);
    if (!triangle) return status_out_of_memory();
    shape_cut_cells(triangle, columns, rows);
    status r = shape_span(s, (const int (*)[3])triangle, faces);
    free(triangle);
    return r;
}
//<

//> body-cloth
//>   A cloth: particles in rows, sticks between neighbours, two triangles a
//>   cell.
static status check_cloth(int columns, int rows, real width, real depth,
                          real diagonal)
{
    status r = check_count("columns", columns, 2, 2048);
    if (r.ok) r = check_count("rows", rows, 2, 2048);
    if (r.ok) r = size_check("width", width, "m");
    if (r.ok) r = size_check("depth", depth, "m");
    if (r.ok && !(diagonal > 0 && diagonal <= 1))
        r = status_fail("the stiffness of the diagonals is %g: it must be "
                        "above 0 and at most 1", diagonal);
    return r;
}

status shape_cloth(shape *s, int columns, int rows, real width, real depth,
                   real mass, real diagonal)
{
    int across = columns - 1, along = rows - 1;     // cells
    *s = (shape){ .kind = SHAPE_CLOTH };
    status r = check_cloth(columns, rows, width, depth, diagonal);
    if (!r.ok) return r;
    r = shape_begin(s, SHAPE_CLOTH, columns * rows,
                    columns * along + rows * across + across * along, mass);
    if (r.ok) r = span_cloth(s, columns, rows);
    if (!r.ok) return shape_finish(s, r);

    for (int j = 0; j < rows; j++)
        for (int i = 0; i < columns; i++)
            s->at[j * columns + i] =
                vec3_make(width * (2 * i - across) / (2 * across), 0,
                          depth * (2 * j - along) / (2 * along));
    s->columns = columns;
    s->rows = rows;
    add_cloth_sticks(s, width / across, depth / along, diagonal);
    return shape_finish(s, r);
}
//<
