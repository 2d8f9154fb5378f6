// check_body.c - tests of lib/shapes/body.c: shapes, their sticks and their rigidity.

#include "body.h"
#include "scarce.h"

#include <check.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define COUNT(list) ((int)(sizeof (list) / sizeof (list)[0]))

// A few roundings of numbers near 1: sums of up to a thousand terms.
static const real ROUNDING = 1e-13;

static void expect_near(real got, real wanted, real tolerance)
{
    ck_assert_msg(fabs(got - wanted) <= tolerance * fabs(wanted),
                  "got %.17g, wanted %.17g", got, wanted);
}

static void expect_why(status s, const char *why)
{
    ck_assert_msg(!s.ok, "accepted, wanted: %s", why);
    ck_assert_msg(strcmp(s.why, why) == 0, "said: %s\nwanted: %s", s.why, why);
}

static void expect_ok(status s)
{
    ck_assert_msg(s.ok, "refused: %s", s.why);
}

static void expect_empty(const shape *s)
{
    static const shape empty = { 0 };
    ck_assert(s->particles == 0 && s->sticks == 0 && s->mesh.edges == 0);
    ck_assert(!s->at && !s->mass && !s->stick && !s->face && !s->ring_start);
    ck_assert(!s->ring && !s->mesh.half && s->radius == empty.radius);
    ck_assert(s->directions == 0 && s->on_strands == 0);
}

// ------------------------------------------------ what holds for every shape

static void expect_equal_masses(const shape *s, real mass)
{
    real sum = 0;
    vec3 moment = { 0, 0, 0 };
    for (int i = 0; i < s->particles; i++) {
        ck_assert(s->mass[i] == s->mass[0] && s->mass[i] > 0);
        sum += s->mass[i];
        moment = vec3_add_scaled(moment, s->mass[i], s->at[i]);
    }
    expect_near(sum, mass, s->particles * 1e-15);
    ck_assert(vec3_length(moment) <= ROUNDING * mass * s->radius);
}

static void expect_good_sticks(const shape *s)
{
    real shortest = (real)INFINITY;
    for (int k = 0; k < s->sticks; k++) {
        stick t = s->stick[k];
        ck_assert(t.a >= 0 && t.a < s->particles);
        ck_assert(t.b >= 0 && t.b < s->particles && t.a != t.b);
        ck_assert(t.kind == STICK_EXACT && t.rest_length > 0);
        expect_near(vec3_distance(s->at[t.a], s->at[t.b]), t.rest_length,
                    ROUNDING * s->radius / t.rest_length);
        if (t.rest_length < shortest) shortest = t.rest_length;
        for (int j = 0; j < k && s->sticks < 2000; j++) {
            stick u = s->stick[j];
            ck_assert_msg(!(t.a == u.a && t.b == u.b) &&
                          !(t.a == u.b && t.b == u.a),
                          "sticks %d and %d are the same", j, k);
        }
    }
    ck_assert(s->spacing == shortest);
}

static void expect_good_mesh(const shape *s)
{
    expect_ok(mesh_validate(&s->mesh));
    ck_assert_int_eq(s->ring_start[s->particles], 2 * s->mesh.edges);
    for (int f = 0; f < s->mesh.faces; f++) {
        int v[3];
        mesh_face(&s->mesh, f, v);
        ck_assert(memcmp(v, &s->face[3 * f], sizeof v) == 0);
    }
    // Every half-edge v -> w puts w once into the ring of v, and nothing else
    // is there.
    for (int h = 0; h < 2 * s->mesh.edges; h++) {
        int v = s->mesh.half[h].origin, found = 0;
        for (int k = s->ring_start[v]; k < s->ring_start[v + 1]; k++)
            found += s->ring[k] == mesh_target(&s->mesh, h);
        ck_assert_int_eq(found, 1);
    }
}

static int has_stick(const shape *s, int a, int b)
{
    for (int k = 0; k < s->sticks; k++)
        if ((s->stick[k].a == a && s->stick[k].b == b) ||
            (s->stick[k].a == b && s->stick[k].b == a)) return 1;
    return 0;
}

// Every link of the strands is a stick, as long as it says, and no stick is
// counted that is none of theirs.
static void expect_good_strands(const shape *s)
{
    int links = 0, highest = 0;
    for (int d = 0; d < s->directions; d++) {
        strands t = s->strand[d];
        ck_assert(t.lines >= 1 && t.particles >= 2);
        ck_assert_int_eq(t.lines * t.particles, s->particles);
        for (int l = 0; l < t.lines; l++)
            for (int k = 0; k + 1 < t.particles; k++, links++) {
                int a = l * t.across + k * t.along, b = a + t.along;
                if (b > highest) highest = b;
                ck_assert(a >= 0 && b < s->particles);
                expect_near(vec3_distance(s->at[a], s->at[b]), t.rest_length,
                            ROUNDING * s->radius / t.rest_length);
                if (s->sticks < 2000) ck_assert(has_stick(s, a, b));
            }
    }
    ck_assert_int_eq(links, s->on_strands);
    ck_assert_int_eq(highest, s->directions > 0 ? s->particles - 1 : 0);
    ck_assert_int_eq(s->directions, s->kind == SHAPE_ROPE ? 1
                                    : s->kind == SHAPE_CLOTH ? 2 : 0);
}

static void expect_sound(const shape *s, real mass)
{
    real farthest = 0;
    for (int i = 0; i < s->particles; i++) {
        ck_assert(vec3_is_finite(s->at[i]));
        farthest = fmax(farthest, vec3_length(s->at[i]));
    }
    ck_assert(s->radius == farthest);
    expect_equal_masses(s, mass);
    expect_good_sticks(s);
    expect_good_strands(s);
    if (s->kind != SHAPE_ROPE) expect_good_mesh(s);
    if (s->kind == SHAPE_RIGID)
        expect_ok(mesh_check_convex(&s->mesh, s->at));
}

// Moments of x^2, y^2 and z^2 over particles: sum m x^2.
static vec3 particle_moments(const shape *s)
{
    vec3 sum = { 0, 0, 0 };
    for (int i = 0; i < s->particles; i++) {
        vec3 a = s->at[i];
        sum = vec3_add_scaled(sum, s->mass[i],
                              vec3_make(a.x * a.x, a.y * a.y, a.z * a.z));
    }
    return sum;
}

// The same over the solid of that mass: over a tetrahedron (0, a, b, c) of
// volume V the integral of x^2 is V (aa + bb + cc + ab + bc + ca) / 10.
static real over_tetrahedron(real a, real b, real c)
{
    return (a * a + b * b + c * c + a * b + b * c + c * a) / 10;
}

static vec3 solid_moments(const shape *s, real mass)
{
    vec3 sum = { 0, 0, 0 };
    real volume = 0;
    for (int f = 0; f < s->mesh.faces; f++) {
        vec3 a = s->at[s->face[3 * f]], b = s->at[s->face[3 * f + 1]];
        vec3 c = s->at[s->face[3 * f + 2]];
        real v = vec3_dot(a, vec3_cross(b, c)) / 6;
        volume += v;
        sum = vec3_add_scaled(sum, v,
                              vec3_make(over_tetrahedron(a.x, b.x, c.x),
                                        over_tetrahedron(a.y, b.y, c.y),
                                        over_tetrahedron(a.z, b.z, c.z)));
    }
    return vec3_scale(mass / volume, sum);
}

// ---------------------------------------------------------------- box

START_TEST(box_has_8_particles_12_faces_and_22_sticks)
{
    shape s;
    expect_ok(shape_box(&s, vec3_make(1, 2, 3), 4));
    expect_sound(&s, 4);
    ck_assert_int_eq(s.kind, SHAPE_RIGID);
    ck_assert_int_eq(s.particles, 8);
    ck_assert_int_eq(s.mesh.faces, 12);
    ck_assert_int_eq(s.mesh.edges, 18);
    ck_assert_int_eq(s.sticks, 22);
    ck_assert_int_eq(mesh_euler(&s.mesh), 2);
    for (int k = 0; k < 4; k++) ck_assert(has_stick(&s, k, 7 - k));
    // The sides are cut between the even corners, a tetrahedron.
    static const int even[4] = { 0, 3, 5, 6 };
    for (int a = 0; a < 4; a++)
        for (int b = 0; b < a; b++)
            ck_assert(has_stick(&s, even[a], even[b]));
    for (int e = 0; e < 18; e++)
        ck_assert(has_stick(&s, s.mesh.half[2 * e].origin,
                            s.mesh.half[2 * e + 1].origin));
    shape_free(&s);
    expect_empty(&s);
}
END_TEST

// Rejects: half sides taken for full ones, sides exchanged.
START_TEST(box_has_its_sides_volume_and_radius)
{
    shape s;
    expect_ok(shape_box(&s, vec3_make(1, 2, 3), 4));
    ck_assert(s.at[0].x == -0.5 && s.at[0].y == -1 && s.at[0].z == -1.5);
    ck_assert(s.at[6].x == -0.5 && s.at[6].y == 1 && s.at[6].z == 1.5);
    expect_near(mesh_volume(&s.mesh, s.at), 6, ROUNDING);
    expect_near(s.radius, sqrt(14) / 2, ROUNDING);
    ck_assert(s.spacing == 1);
    shape_free(&s);
}
END_TEST

// ------------------------------------------------------------- icosahedron

START_TEST(icosahedron_has_12_particles_20_faces_and_36_sticks)
{
    shape s;
    expect_ok(shape_icosahedron(&s, 0.5, 1));
    expect_sound(&s, 1);
    ck_assert_int_eq(s.particles, 12);
    ck_assert_int_eq(s.mesh.faces, 20);
    ck_assert_int_eq(s.mesh.edges, 30);
    ck_assert_int_eq(s.sticks, 36);
    ck_assert_int_eq(mesh_euler(&s.mesh), 2);
    for (int v = 0; v < 12; v++) {
        ck_assert(has_stick(&s, v, v ^ 3));
        ck_assert_int_eq(s.ring_start[v + 1] - s.ring_start[v], 5);
    }
    shape_free(&s);
}
END_TEST

// Regular: edge a = 4 r / sqrt(10 + 2 sqrt 5), volume 5 (3 + sqrt 5) a^3 / 12.
// Rejects: one wrong sign in the table of corners.
START_TEST(icosahedron_is_regular)
{
    shape s;
    real r = 2.5, a = 4 * r / sqrt(10 + 2 * sqrt(5));
    expect_ok(shape_icosahedron(&s, r, 1));
    for (int i = 0; i < 12; i++)
        expect_near(vec3_length(s.at[i]), r, ROUNDING);
    for (int e = 0; e < 30; e++)
        expect_near(vec3_distance(s.at[s.mesh.half[2 * e].origin],
                                  s.at[s.mesh.half[2 * e + 1].origin]),
                    a, ROUNDING);
    expect_near(s.spacing, a, ROUNDING);
    expect_near(mesh_volume(&s.mesh, s.at),
                5 * (3 + sqrt(5)) * a * a * a / 12, ROUNDING);
    shape_free(&s);
}
END_TEST

// ------------------------------------------------------------------- inertia

// Equal masses at the corners, against the uniform solid: 3 for a box whatever
// its sides, sqrt(5) 5 / (3 g) = 2.3033 for an icosahedron, 5 for a
// tetrahedron.
// Rejects: masses that differ from particle to particle.
START_TEST(equal_masses_exaggerate_inertia_by_3_and_2_3_and_5)
{
    shape s;
    expect_ok(shape_box(&s, vec3_make(1, 2, 3), 4));
    vec3 p = particle_moments(&s), q = solid_moments(&s, 4);
    expect_near(p.x / q.x, 3, ROUNDING);
    expect_near(p.y / q.y, 3, ROUNDING);
    expect_near(p.z / q.z, 3, ROUNDING);
    printf("inertia: box %.4f", p.x / q.x);
    shape_free(&s);

    expect_ok(shape_icosahedron(&s, 2, 1));
    real golden = (1 + sqrt(5)) / 2, ratio = 5 * sqrt(5) / (3 * golden);
    p = particle_moments(&s), q = solid_moments(&s, 1);
    expect_near(p.x / q.x, ratio, ROUNDING);
    expect_near(p.y / q.y, ratio, ROUNDING);
    expect_near(p.z / q.z, ratio, ROUNDING);
    printf(", icosahedron %.4f", p.x / q.x);
    shape_free(&s);

    static const vec3 at[4] =
        { { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } };
    static const int t[4][3] =
        { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } };
    expect_ok(shape_convex(&s, 4, at, 4, t, 1));
    p = particle_moments(&s), q = solid_moments(&s, 1);
    expect_near(p.x / q.x, 5, ROUNDING);
    printf(", tetrahedron %.4f times the solid's\n", p.x / q.x);
    shape_free(&s);
}
END_TEST

// ---------------------------------------------------------------------- rank

// The first n of these sticks on the corners of a cube: 12 edges, 6 diagonals
// of sides, 4 main diagonals.
static int rank_of_cube(const int (*pair)[2], int n)
{
    vec3 at[8];
    stick sticks[32];
    for (int k = 0; k < 8; k++)
        at[k] = vec3_make(k & 1, (k >> 1) & 1, k >> 2);
    for (int k = 0; k < n; k++)
        sticks[k] = (stick){ .a = pair[k][0], .b = pair[k][1],
                             .rest_length = 1, .stiffness = 1 };
    shape s = { .particles = 8, .at = at, .sticks = n, .stick = sticks };
    return shape_rank(&s);
}

static int cube_edges(int (*pair)[2])
{
    int n = 0;
    for (int a = 0; a < 8; a++)
        for (int bit = 1; bit < 8; bit *= 2)
            if (!(a & bit)) {
                pair[n][0] = a;
                pair[n++][1] = a | bit;
            }
    return n;
}

// Rejects: a count taken for a rank: 16 sticks, rank 15.
START_TEST(edges_and_main_diagonals_of_a_cube_have_rank_15)
{
    int pair[32][2], n = cube_edges(pair);
    ck_assert_int_eq(n, 12);
    int edges = rank_of_cube((const int (*)[2])pair, n);
    for (int k = 0; k < 4; k++) {
        pair[n][0] = k;
        pair[n++][1] = 7 - k;
    }
    int all = rank_of_cube((const int (*)[2])pair, n);
    printf("rank: cube of 12 edges %d, with 4 main diagonals %d of 18\n",
           edges, all);
    ck_assert_int_eq(edges, 12);
    ck_assert_int_eq(all, 15);
}
END_TEST

// One diagonal in each side, either of the two: 64 cubes, all rigid.
START_TEST(every_choice_of_side_diagonals_has_rank_18)
{
    for (int choice = 0; choice < 64; choice++) {
        int pair[32][2], n = cube_edges(pair);
        for (int side = 0; side < 6; side++) {
            int normal = 1 << side % 3, base = side < 3 ? 0 : normal;
            int u = normal == 1 ? 2 : 1, v = 7 - normal - u;
            int crossed = (choice >> side) & 1;
            pair[n][0] = base + (crossed ? u : 0);
            pair[n++][1] = base + (crossed ? v : u + v);
        }
        ck_assert_int_eq(n, 18);
        ck_assert_int_eq(rank_of_cube((const int (*)[2])pair, n), 18);
        if (choice > 0) continue;
        // One fewer and it moves.
        ck_assert_int_eq(rank_of_cube((const int (*)[2])pair, 17), 17);
    }
}
END_TEST

START_TEST(box_and_icosahedron_are_rigid)
{
    shape s;
    expect_ok(shape_box(&s, vec3_make(1, 1, 1), 1));
    int box = shape_rank(&s);
    shape_free(&s);
    expect_ok(shape_icosahedron(&s, 1, 1));
    int icosahedron = shape_rank(&s);
    shape_free(&s);
    printf("rank: box of 22 sticks %d, icosahedron of 36 %d\n", box,
           icosahedron);
    ck_assert_int_eq(box, 18);
    ck_assert_int_eq(icosahedron, 30);
}
END_TEST

// Rejects: an absolute threshold for the pivots, or rows that are not scaled.
START_TEST(rank_does_not_depend_on_the_size)
{
    for (real size = 1e-20; size < 1e21; size *= 1e5) {
        shape s;
        expect_ok(shape_box(&s, vec3_make(size, 3 * size, 1e-3 * size), 1));
        ck_assert_int_eq(shape_rank(&s), 18);
        shape_free(&s);
    }
}
END_TEST

// A stick twice, a flat square, nothing.
// Rejects: the same sign at both ends of a row, a row counted that depends on
// others, one stick too few.
START_TEST(rank_counts_what_is_independent)
{
    static const int twice[3][2] = { { 0, 1 }, { 0, 1 }, { 1, 0 } };
    ck_assert_int_eq(rank_of_cube(twice, 3), 1);
    // Four corners in a plane with all 6 sticks: the flat figure has rank
    // 2 n - 3 = 5, for no stick resists a move out of the plane.
    static const int square[6][2] =
        { { 0, 1 }, { 1, 3 }, { 3, 2 }, { 2, 0 }, { 0, 3 }, { 1, 2 } };
    ck_assert_int_eq(rank_of_cube(square, 6), 5);
    ck_assert_int_eq(rank_of_cube(NULL, 0), 0);
}
END_TEST

// Rejects: rows as long as their sticks, beside which a short one is nothing.
START_TEST(short_stick_counts_as_much_as_a_long_one)
{
    vec3 at[4] = { { 0, 0, 0 }, { 1e6, 0, 0 }, { 0, 0, 0 }, { 0, 1e-6, 0 } };
    stick sticks[2] = { { 0, 1, 1e6, 1, STICK_EXACT },
                        { 2, 3, 1e-6, 1, STICK_EXACT } };
    shape s = { .particles = 4, .at = at, .sticks = 2, .stick = sticks };
    ck_assert_int_eq(shape_rank(&s), 2);
}
END_TEST

// ------------------------------------------------------------------- convex

// A cube whose sides are grids of n x n cells.  Returns the vertex count.
// The vertex at (first) becomes vertex 0.
static int grid_cube(int n, vec3 *at, int (*triangle)[3], const int first[3])
{
    int index[9][9][9], vertices = 1, faces = 0;
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= n; j++)
            for (int k = 0; k <= n; k++) {
                int ijk[3] = { i, j, k };
                int here = memcmp(ijk, first, sizeof ijk) == 0;
                if (i % n && j % n && k % n) continue;
                index[i][j][k] = here ? 0 : vertices++;
                at[index[i][j][k]] = vec3_make(i, j, k);
            }
    for (int side = 0; side < 6; side++)
        for (int p = 0; p < n; p++)
            for (int q = 0; q < n; q++) {
                int v[4];
                for (int c = 0; c < 4; c++) {
                    int at3[3], axis = side % 3;
                    at3[axis] = side < 3 ? 0 : n;
                    at3[(axis + 1) % 3] = p + (c == 1 || c == 2);
                    at3[(axis + 2) % 3] = q + (c >= 2);
                    v[c] = index[at3[0]][at3[1]][at3[2]];
                }
                for (int half = 0; half < 2; half++) {
                    int *t = triangle[faces++];
                    t[0] = v[0];
                    t[1] = v[half + 1];
                    t[2] = v[half + 2];
                    if (side < 3) { t[1] = v[half + 2]; t[2] = v[half + 1]; }
                }
            }
    return vertices;
}

static void expect_rigid(int vertices, const vec3 *at, int faces,
                         int (*triangle)[3])
{
    shape s;
    expect_ok(shape_convex(&s, vertices, at, faces,
                           (const int (*)[3])triangle, 2));
    expect_sound(&s, 2);
    ck_assert_int_eq(shape_rank(&s), 3 * vertices - 6);
    shape_free(&s);
}

// Rejects: sticks left out or doubled between vertex 0 and its neighbours.
START_TEST(tetrahedron_needs_its_six_edges_only)
{
    static const vec3 at[4] =
        { { 10, 0, 0 }, { 11, 0, 0 }, { 10, 1, 0 }, { 10, 0, 1 } };
    static const int t[4][3] =
        { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
    shape s;
    expect_ok(shape_convex(&s, 4, at, 4, t, 2));
    expect_sound(&s, 2);
    ck_assert_int_eq(s.sticks, 6);
    ck_assert_int_eq(shape_rank(&s), 6);
    expect_near(s.at[0].x, -0.25, ROUNDING);    // the mean of 10, 11, 10, 10
    shape_free(&s);
}
END_TEST

// The fan from vertex 0: all edges, and vertex 0 to everybody: 12 + 1 sticks
// for an octahedron, 30 + 6 for an icosahedron.
START_TEST(fan_joins_vertex_0_to_every_other)
{
    static const vec3 at[6] = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 },
                                { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
    int t[8][3];
    for (int f = 0; f < 8; f++) {
        int x = f & 1, y = (f >> 1) & 1, z = f >> 2, odd = (x + y + z) & 1;
        t[f][0] = x;
        t[f][1] = odd ? 4 + z : 2 + y;
        t[f][2] = odd ? 2 + y : 4 + z;
    }
    shape s, ball;
    expect_ok(shape_convex(&s, 6, at, 8, (const int (*)[3])t, 1));
    expect_sound(&s, 1);
    ck_assert_int_eq(s.sticks, 13);
    ck_assert_int_eq(shape_rank(&s), 12);
    shape_free(&s);

    expect_ok(shape_icosahedron(&ball, 1, 1));
    expect_ok(shape_convex(&s, 12, ball.at, 20,
                           (const int (*)[3])(void *)ball.face, 1));
    expect_sound(&s, 1);
    ck_assert_int_eq(s.sticks, 36);
    for (int v = 1; v < 12; v++) ck_assert(has_stick(&s, 0, v));
    ck_assert_int_eq(shape_rank(&s), 30);
    shape_free(&s);
    shape_free(&ball);
}
END_TEST

// The rank of the edges and the fan alone.
static int rank_without_cross_sticks(const shape *s)
{
    stick *sticks = malloc((size_t)s->sticks * sizeof *sticks);
    shape fewer = *s;
    fewer.stick = sticks;
    fewer.sticks = 0;
    for (int k = 0; k < s->sticks; k++) {
        stick t = s->stick[k];
        int edge = t.a == 0 || t.b == 0;
        for (int j = s->ring_start[t.a]; j < s->ring_start[t.a + 1]; j++)
            edge |= s->ring[j] == t.b;
        if (edge) sticks[fewer.sticks++] = t;
    }
    int rank = shape_rank(&fewer);
    free(sticks);
    return rank;
}

START_TEST(fan_alone_leaves_flat_vertices_free)
{
    vec3 at[600];
    int triangle[1000][3];
    static const int corner[3] = { 0, 0, 0 };
    int vertices = grid_cube(3, at, triangle, corner);
    shape s;
    expect_ok(shape_convex(&s, vertices, at, 12 * 9,
                           (const int (*)[3])triangle, 1));
    int fan = rank_without_cross_sticks(&s), all = shape_rank(&s);
    printf("rank: cube of 3 x 3 cells a side, edges and fan %d, with sticks "
           "across %d of %d\n", fan, all, 3 * vertices - 6);
    ck_assert_int_eq(fan, 150);
    ck_assert_int_eq(all, 162);
    shape_free(&s);
}
END_TEST

// Vertices inside flat sides that hold vertex 0, too: their tetrahedra are
// flat, and edges and fan alone leave them free to bulge.  Vertex 0 in a
// corner, in the middle of a side, on an edge.
START_TEST(vertices_inside_flat_sides_are_held)
{
    static const int first[3][3] = { { 0, 0, 0 }, { 2, 1, 0 }, { 2, 0, 0 } };
    vec3 at[600];
    int triangle[1000][3];
    for (int n = 2; n <= 3; n++)
        for (int k = 0; k < 3; k++) {
            int from[3] = { first[k][0] < n ? first[k][0] : n / 2,
                            first[k][1], first[k][2] };
            int vertices = grid_cube(n, at, triangle, from);
            ck_assert_int_eq(vertices, 6 * n * n + 2);
            expect_rigid(vertices, at, 12 * n * n, triangle);
        }
}
END_TEST

// In a plate thinner than what counts as flat, every vertex gets a stick
// across, and vertices opposite to each other would both draw it.
START_TEST(thin_plate_has_no_stick_twice)
{
    vec3 at[600];
    int triangle[1000][3];
    static const int first[3] = { 0, 0, 0 };
    int vertices = grid_cube(2, at, triangle, first);
    for (int v = 0; v < vertices; v++) at[v].z *= 1e-4;
    expect_rigid(vertices, at, 12 * 4, triangle);
}
END_TEST

// An icosahedron with every edge halved and its middle pushed out: 42 vertices.
START_TEST(rounder_ball_is_rigid)
{
    shape ball;
    vec3 at[42];
    int triangle[80][3], middle[12][12] = { { 0 } }, n = 12;
    expect_ok(shape_icosahedron(&ball, 1, 1));
    for (int v = 0; v < 12; v++) at[v] = ball.at[v];
    for (int e = 0; e < 30; e++) {
        int a = ball.mesh.half[2 * e].origin;
        int b = ball.mesh.half[2 * e + 1].origin;
        middle[a][b] = middle[b][a] = n;
        at[n++] = vec3_unit(vec3_add(at[a], at[b]));
    }
    for (int f = 0; f < 20; f++) {
        const int *v = &ball.face[3 * f];
        for (int k = 0; k < 3; k++) {
            triangle[4 * f + k][0] = v[k];
            triangle[4 * f + k][1] = middle[v[k]][v[(k + 1) % 3]];
            triangle[4 * f + k][2] = middle[v[k]][v[(k + 2) % 3]];
            triangle[4 * f + 3][k] = middle[v[k]][v[(k + 1) % 3]];
        }
    }
    expect_rigid(42, at, 80, triangle);
    shape_free(&ball);
}
END_TEST

START_TEST(bad_meshes_are_refused_with_the_mesh_own_sentence)
{
    static const vec3 at[4] =
        { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    static const int inwards[4][3] =
        { { 0, 1, 2 }, { 0, 3, 1 }, { 0, 2, 3 }, { 1, 3, 2 } };
    static const int index[4][3] =
        { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 4 } };
    shape s;
    expect_why(shape_convex(&s, 4, at, 4, inwards, 1),
               "the triangles look inwards: every one of them must be turned "
               "round");
    expect_empty(&s);
    expect_why(shape_convex(&s, 4, at, 4, index, 1), "triangle 3 uses vertex "
               "4, but there are only 4 vertices (0 to 3)");
    expect_empty(&s);
    expect_why(shape_convex(&s, 4, at, 3, inwards, 1), "the edge from vertex 2 "
               "to vertex 1 has a triangle on one side only: the mesh is open");
    expect_empty(&s);
    expect_why(shape_convex(&s, 3, at, 4, inwards, 1),
               "the number of vertices is 3: it must be from 4 to 16384");
    expect_empty(&s);
    expect_why(shape_convex(&s, 4, at, 0, NULL, 1),
               "vertex 0 belongs to no triangle");
    expect_empty(&s);
}
END_TEST

// ------------------------------------------------------------- rope and cloth

START_TEST(rope_is_a_line_of_equal_links)
{
    shape s;
    expect_ok(shape_rope(&s, 10, 3, 2));
    expect_sound(&s, 2);
    ck_assert_int_eq(s.kind, SHAPE_ROPE);
    ck_assert_int_eq(s.particles, 11);
    ck_assert_int_eq(s.sticks, 10);
    ck_assert(s.at[0].x == -1.5 && s.at[10].x == 1.5 && s.at[5].x == 0);
    for (int k = 0; k < 10; k++) {
        ck_assert(has_stick(&s, k, k + 1));
        ck_assert(s.stick[k].rest_length == 3.0 / 10);
        ck_assert(s.at[k].x == -s.at[10 - k].x && s.at[k].y == 0);
    }
    ck_assert(s.radius == 1.5 && s.spacing == 3.0 / 10);
    ck_assert(s.mesh.vertices == 0 && s.mesh.edges == 0 && s.mesh.faces == 0);
    for (int k = 0; k <= 11; k++) ck_assert_int_eq(s.ring_start[k], 0);
    ck_assert_int_eq(shape_rank(&s), 10);
    shape_free(&s);

    expect_ok(shape_rope(&s, 1, 1, 1));
    expect_sound(&s, 1);
    shape_free(&s);
}
END_TEST

START_TEST(rope_of_a_million_links_is_built)
{
    shape s;
    expect_ok(shape_rope(&s, 1000000, 1, 1));
    ck_assert_int_eq(s.particles, 1000001);
    ck_assert(s.at[1000000].x == 0.5 && s.at[500000].x == 0);
    shape_free(&s);
}
END_TEST

// Euler's number of a disc is 1; sticks: rows, columns and a diagonal a cell.
START_TEST(cloth_has_its_counts)
{
    static const int size[4][2] = { { 2, 2 }, { 3, 5 }, { 8, 7 }, { 20, 20 } };
    for (int k = 0; k < COUNT(size); k++) {
        int c = size[k][0], r = size[k][1], cells = (c - 1) * (r - 1);
        shape s;
        expect_ok(shape_cloth(&s, c, r, 2, 3, 1, 0.2));
        expect_sound(&s, 1);
        ck_assert_int_eq(s.kind, SHAPE_CLOTH);
        ck_assert_int_eq(s.particles, c * r);
        ck_assert_int_eq(s.strand[0].lines, c);     // columns, then rows
        ck_assert_int_eq(s.strand[1].lines, r);
        ck_assert_int_eq(s.mesh.faces, 2 * cells);
        ck_assert_int_eq(s.sticks, c * (r - 1) + r * (c - 1) + cells);
        ck_assert_int_eq(s.sticks, s.mesh.edges);
        ck_assert_int_eq(mesh_euler(&s.mesh), 1);
        ck_assert(!mesh_is_closed(&s.mesh));
        for (int e = 0; e < s.mesh.edges; e++)
            ck_assert(has_stick(&s, s.mesh.half[2 * e].origin,
                                s.mesh.half[2 * e + 1].origin));
        shape_free(&s);
    }
}
END_TEST

// Rejects: faces that look down, i and j exchanged, a cloth off its centre.
START_TEST(cloth_lies_flat_and_looks_up)
{
    shape s;
    expect_ok(shape_cloth(&s, 5, 4, 2, 3, 1, 0.2));
    for (int j = 0; j < 4; j++)
        for (int i = 0; i < 5; i++) {
            vec3 a = s.at[j * 5 + i], b = s.at[(3 - j) * 5 + 4 - i];
            expect_near(a.x + 1, 2 * i / 4.0, ROUNDING);
            expect_near(a.z + 1.5, 3 * j / 3.0, ROUNDING);
            ck_assert(a.y == 0 && a.x == -b.x && a.z == -b.z);
        }
    for (int f = 0; f < s.mesh.faces; f++) {
        const int *v = &s.face[3 * f];
        vec3 n = vec3_cross(vec3_sub(s.at[v[1]], s.at[v[0]]),
                            vec3_sub(s.at[v[2]], s.at[v[0]]));
        expect_near(n.y, 0.5, ROUNDING);            // twice half a cell
        ck_assert(n.x == 0 && n.z == 0);
    }
    shape_free(&s);
}
END_TEST

// Cell (i, j): from (i, j) if i + j is even, else from (i + 1, j).
START_TEST(cloth_diagonals_alternate_and_come_last)
{
    enum { C = 6, R = 5 };
    shape s;
    expect_ok(shape_cloth(&s, C, R, 5, 4, 1, 0.25));
    for (int j = 0; j + 1 < R; j++)
        for (int i = 0; i + 1 < C; i++) {
            int a = j * C + i, even = (i + j) % 2 == 0;
            ck_assert_int_eq(has_stick(&s, a, a + C + 1), even);
            ck_assert_int_eq(has_stick(&s, a + 1, a + C), !even);
        }
    int structural = C * (R - 1) + R * (C - 1);
    for (int k = 0; k < s.sticks; k++) {
        int apart = abs(s.stick[k].a - s.stick[k].b);
        int straight = apart == 1 || apart == C;
        ck_assert_int_eq(straight, k < structural);
        ck_assert_int_eq(straight, k < s.on_strands);
        ck_assert(s.stick[k].stiffness == (straight ? 1 : 0.25));
    }
    shape_free(&s);
}
END_TEST

// Rejects: rows in their order, where every stick waits for the one before.
// Only where one of the eight runs ends may neighbours share a particle.
START_TEST(neighbouring_sticks_of_a_cloth_share_no_particle)
{
    shape s;
    expect_ok(shape_cloth(&s, 20, 20, 1, 1, 1, 0.2));
    int shared = 0;
    for (int k = 1; k < s.sticks; k++) {
        stick t = s.stick[k - 1], u = s.stick[k];
        shared += t.a == u.a || t.a == u.b || t.b == u.a || t.b == u.b;
    }
    ck_assert_int_le(shared, 7);

    // And each run by itself: no particle twice.
    static const int run[8] = { 200, 180, 200, 180, 100, 81, 90, 90 };
    int k = 0;
    for (int n = 0; n < 8; n++) {
        int met[400] = { 0 };
        for (int end = k + run[n]; k < end; k++) {
            ck_assert_int_eq(met[s.stick[k].a]++, 0);
            ck_assert_int_eq(met[s.stick[k].b]++, 0);
        }
    }
    ck_assert_int_eq(k, s.sticks);
    shape_free(&s);
}
END_TEST

// A flat triangulated disc has rank 2 n - 3, each of its n particles free to
// leave the plane.
START_TEST(flat_cloth_is_rigid_in_its_plane_only)
{
    shape s;
    expect_ok(shape_cloth(&s, 5, 5, 1, 1, 1, 1));
    ck_assert_int_eq(shape_rank(&s), 2 * 25 - 3);
    shape_free(&s);
}
END_TEST

// ----------------------------------------------------------------- hard cases

// What sticks cannot do: the mirror image of a body satisfies all of them.
START_TEST(mirror_image_satisfies_every_stick)
{
    shape s;
    particle p[12];
    vec3 mirrored[12];
    expect_ok(shape_icosahedron(&s, 1, 1));
    for (int i = 0; i < 12; i++) {
        mirrored[i] = vec3_make(s.at[i].x, s.at[i].y, -s.at[i].z);
        p[i] = (particle){ mirrored[i], mirrored[i], 1 };
    }
    for (int k = 0; k < s.sticks; k++)
        ck_assert(stick_strain(s.stick[k], p) == 0);
    ck_assert(mesh_volume(&s.mesh, mirrored) == -mesh_volume(&s.mesh, s.at));
    shape_free(&s);
}
END_TEST

// Schoenhardt: a triangular prism, its top turned by 30 degrees, its three
// sides broken along the diagonals that bend inwards.  It has no
// tetrahedralisation, and though it has 3 n - 6 = 12 edges it is not rigid.
// Broken the other way it is convex, and rigid.
START_TEST(schoenhardt_polyhedron_is_refused_and_shaky)
{
    real r = sqrt(3) / 2;
    static const int next[3] = { 1, 2, 0 };
    vec3 at[6] = { { 1, 0, 0 }, { -.5, r, 0 }, { -.5, -r, 0 },
                   { r, .5, 1 }, { -r, .5, 1 }, { 0, -1, 1 } };
    for (int inwards = 0; inwards < 2; inwards++) {
        int t[8][3] = { { 0, 2, 1 }, { 3, 4, 5 } };
        for (int k = 0; k < 3; k++) {
            int a = k, b = next[k], c = 3 + k, d = 3 + next[k];
            int first[3] = { a, b, inwards ? d : c };
            int second[3] = { inwards ? a : b, d, c };
            memcpy(t[2 + 2 * k], first, sizeof first);
            memcpy(t[3 + 2 * k], second, sizeof second);
        }
        mesh m;
        stick sticks[12];
        expect_ok(mesh_build(&m, 6, (const int (*)[3])t, 8));
        for (int e = 0; e < 12; e++)
            sticks[e] = (stick){ m.half[2 * e].origin,
                                 m.half[2 * e + 1].origin, 1, 1, STICK_EXACT };
        mesh_free(&m);
        shape edges = { .particles = 6, .at = at, .sticks = 12,
                        .stick = sticks };
        int rank = shape_rank(&edges);
        printf("rank: twisted prism of 12 edges, %s: %d of 12\n",
               inwards ? "Schoenhardt's" : "convex", rank);
        ck_assert_int_eq(rank, inwards ? 11 : 12);

        shape s;
        status made = shape_convex(&s, 6, at, 8, (const int (*)[3])t, 1);
        ck_assert_msg(made.ok == !inwards, "%s", made.why);
        if (inwards) ck_assert(strstr(made.why, "not convex") != NULL);
        shape_free(&s);
    }
}
END_TEST

// ------------------------------------------------------------------ bad input

START_TEST(numbers_that_are_none_are_refused)
{
    real bad[6] = { 0, -1, (real)NAN, (real)INFINITY, 1e31, 1e-31 };
    shape s;
    for (int k = 0; k < 6; k++) {
        real x = bad[k];
        vec3 sides[3] = { { x, 1, 1 }, { 1, x, 1 }, { 1, 1, x } };
        for (int c = 0; c < 3; c++) {
            ck_assert(!shape_box(&s, sides[c], 1).ok);
            expect_empty(&s);
        }
        ck_assert(!shape_box(&s, vec3_make(1, 1, 1), x).ok);
        ck_assert(!shape_icosahedron(&s, x, 1).ok);
        ck_assert(!shape_icosahedron(&s, 1, x).ok);
        expect_empty(&s);
        ck_assert(!shape_rope(&s, 3, x, 1).ok);
        ck_assert(!shape_rope(&s, 3, 1, x).ok);
        expect_empty(&s);
        ck_assert(!shape_cloth(&s, 3, 3, x, 1, 1, 1).ok);
        ck_assert(!shape_cloth(&s, 3, 3, 1, x, 1, 1).ok);
        ck_assert(!shape_cloth(&s, 3, 3, 1, 1, x, 1).ok);
        expect_empty(&s);
    }
    expect_why(shape_rope(&s, 3, -2, 1),
               "the length is -2 m: it must be a number from 1e-30 to 1e+30");
    expect_why(shape_box(&s, vec3_make(1, 1, 0), 1), "the side along z is 0 m: "
               "it must be a number from 1e-30 to 1e+30");
    expect_why(shape_icosahedron(&s, 1, (real)INFINITY),
               "the mass is inf kg: it must be a number from 1e-30 to 1e+30");
}
END_TEST

START_TEST(counts_out_of_range_are_refused)
{
    shape s;
    expect_why(shape_rope(&s, 0, 1, 1),
               "the number of links is 0: it must be from 1 to 1000000");
    expect_why(shape_rope(&s, 1000001, 1, 1),
               "the number of links is 1000001: it must be from 1 to 1000000");
    expect_why(shape_cloth(&s, 1, 5, 1, 1, 1, 1),
               "the number of columns is 1: it must be from 2 to 2048");
    expect_why(shape_cloth(&s, 5, 2049, 1, 1, 1, 1),
               "the number of rows is 2049: it must be from 2 to 2048");
    expect_why(shape_cloth(&s, INT_MAX, INT_MAX, 1, 1, 1, 1),
               "the number of columns is 2147483647: it must be from 2 to "
               "2048");
    expect_empty(&s);
}
END_TEST

START_TEST(stiffness_of_diagonals_lies_above_0_and_at_most_1)
{
    real bad[4] = { 0, -0.5, 1.001, (real)NAN };
    shape s;
    for (int k = 0; k < 4; k++) {
        status r = shape_cloth(&s, 3, 3, 1, 1, 1, bad[k]);
        ck_assert(!r.ok && strstr(r.why, "stiffness of the diagonals"));
        expect_empty(&s);
    }
}
END_TEST

// Thinner than a millionth of a millionth of its length, a plate is no solid.
START_TEST(box_without_thickness_is_refused)
{
    shape s;
    ck_assert(!shape_box(&s, vec3_make(1, 1, 1e-12), 1).ok);
    expect_empty(&s);
    expect_ok(shape_box(&s, vec3_make(1, 1, 1e-6), 1));
    shape_free(&s);
}
END_TEST

START_TEST(freeing_nothing_is_harmless)
{
    shape s = { 0 };
    shape_free(&s);
    shape_free(&s);
    expect_empty(&s);
}
END_TEST

static status build_nth(int which, shape *s)
{
    static const vec3 at[4] =
        { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    static const int t[4][3] =
        { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
    if (which == 0) return shape_box(s, vec3_make(1, 1, 1), 1);
    if (which == 1) return shape_icosahedron(s, 1, 1);
    if (which == 2) return shape_rope(s, 4, 1, 1);
    if (which == 3) return shape_cloth(s, 4, 4, 1, 1, 1, 1);
    return shape_convex(s, 4, at, 4, t, 1);
}

// Rejects: a leak, or a half-built shape, when any one allocation is refused.
START_TEST(refused_memory_leaves_nothing)
{
    for (int which = 0; which < 5; which++) {
        int n = 0;
        for (; n < 40; n++) {
            shape s;
            memset(&s, 0x55, sizeof s);
            mallocs_left = n;
            status r = build_nth(which, &s);
            mallocs_left = INT_MAX;
            if (r.ok) { shape_free(&s); break; }
            expect_why(r, "out of memory");
            expect_empty(&s);
        }
        ck_assert_int_gt(n, 5);
        ck_assert_int_lt(n, 40);
    }
    shape s;
    expect_ok(shape_box(&s, vec3_make(1, 1, 1), 1));
    mallocs_left = 0;
    int rank = shape_rank(&s);
    mallocs_left = INT_MAX;
    ck_assert_int_eq(rank, -1);
    shape_free(&s);
    // Rejects: a number of bytes that overflows.
    s = (shape){ .particles = INT_MAX, .sticks = INT_MAX };
    ck_assert_int_eq(shape_rank(&s), -1);
}
END_TEST

// Rejects: a body that passes for convex and is of no size to compute with.
START_TEST(radius_out_of_range_is_refused)
{
    static const int t[4][3] =
        { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
    const real size[2] = { 1e-40, 1e40 };
    for (int k = 0; k < 2; k++) {
        shape s;
        vec3 at[4] = { { 0, 0, 0 }, { size[k], 0, 0 }, { 0, size[k], 0 },
                       { 0, 0, size[k] } };
        status r = shape_convex(&s, 4, at, 4, t, 1);
        ck_assert_msg(!r.ok && strstr(r.why, "the radius is "), "%s", r.why);
        expect_empty(&s);
    }
}
END_TEST

// Rejects: an index or a count that is trusted.
START_TEST(convex_bodies_take_no_index_on_trust)
{
    static const vec3 at[4] =
        { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
    int t[4][3] = { { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
    const int (*triangle)[3] = (const int (*)[3])t;
    const int wrong[4] = { -1, 4, INT_MAX, INT_MIN };
    shape s;
    for (int k = 0; k < 4; k++) {
        t[2][1] = wrong[k];
        status r = shape_convex(&s, 4, at, 4, triangle, 1);
        ck_assert_msg(!r.ok && strstr(r.why, "triangle 2 uses vertex"), "%s",
                      r.why);
        expect_empty(&s);
    }
    t[2][1] = 3;
    ck_assert(!shape_convex(&s, 4, at, INT_MAX, triangle, 1).ok);
    ck_assert(!shape_convex(&s, 4, at, -1, triangle, 1).ok);
    ck_assert(!shape_convex(&s, INT_MAX, at, 4, triangle, 1).ok);
    ck_assert(!shape_convex(&s, 3, at, 4, triangle, 1).ok);
    expect_empty(&s);
}
END_TEST

int main(void)
{
    const TTest *tests[] = {
        box_has_8_particles_12_faces_and_22_sticks,
        box_has_its_sides_volume_and_radius,
        icosahedron_has_12_particles_20_faces_and_36_sticks,
        icosahedron_is_regular,
        equal_masses_exaggerate_inertia_by_3_and_2_3_and_5,
        edges_and_main_diagonals_of_a_cube_have_rank_15,
        every_choice_of_side_diagonals_has_rank_18,
        box_and_icosahedron_are_rigid, rank_does_not_depend_on_the_size,
        rank_counts_what_is_independent,
        short_stick_counts_as_much_as_a_long_one,
        tetrahedron_needs_its_six_edges_only,
        fan_joins_vertex_0_to_every_other, fan_alone_leaves_flat_vertices_free,
        vertices_inside_flat_sides_are_held, thin_plate_has_no_stick_twice,
        rounder_ball_is_rigid,
        bad_meshes_are_refused_with_the_mesh_own_sentence,
        rope_is_a_line_of_equal_links, rope_of_a_million_links_is_built,
        cloth_has_its_counts, cloth_lies_flat_and_looks_up,
        cloth_diagonals_alternate_and_come_last,
        neighbouring_sticks_of_a_cloth_share_no_particle,
        flat_cloth_is_rigid_in_its_plane_only,
        mirror_image_satisfies_every_stick,
        schoenhardt_polyhedron_is_refused_and_shaky,
        numbers_that_are_none_are_refused, counts_out_of_range_are_refused,
        stiffness_of_diagonals_lies_above_0_and_at_most_1,
        box_without_thickness_is_refused, freeing_nothing_is_harmless,
        refused_memory_leaves_nothing, radius_out_of_range_is_refused,
        convex_bodies_take_no_index_on_trust
    };
    Suite *suite = suite_create("body");
    TCase *all = tcase_create("all");
    for (int k = 0; k < COUNT(tests); k++) tcase_add_test(all, tests[k]);
    suite_add_tcase(suite, all);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
