// check_convex.c - rigid bodies from convex meshes.

#include "convex.h"
#include "expect.h"
#include "meshes.h"
#include "rigidity.h"
#include "scarce.h"
#include "shapes.h"
#include "suite.h"
#include "validate.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>

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
    expect_ok(mesh_validate(&s.mesh));
    expect_ok(mesh_check_convex(&s.mesh, s.at));
    ck_assert_int_eq(shape_rank(&s), 3 * vertices - 6);
    shape_free(&s);
}

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
        for (int e = 0; e < s->mesh.edges; e++) {
            int a = s->mesh.half[2 * e].origin;
            int b = s->mesh.half[2 * e + 1].origin;
            edge |= (a == t.a && b == t.b) || (a == t.b && b == t.a);
        }
        if (edge) sticks[fewer.sticks++] = t;
    }
    int rank = shape_rank(&fewer);
    free(sticks);
    return rank;
}

// Equal masses at the corners, against the uniform solid: 3 for a box whatever
// its sides, sqrt(5) 5 / (3 g) = 2.3033 for an icosahedron, 5 for a
// tetrahedron.
// Rejects: masses that differ from particle to particle.
START_TEST(equal_masses_exaggerate_inertia_by_3_and_2_3_and_5)
{
    shape s;
    expect_ok(shape_box(&s, vec3_make(1, 2, 3), 4));
    vec3 p = particle_moments(&s), q = solid_moments(&s, 4);
    near_relative(p.x / q.x, 3, ROUNDING);
    near_relative(p.y / q.y, 3, ROUNDING);
    near_relative(p.z / q.z, 3, ROUNDING);
    printf("inertia: box %.4f", p.x / q.x);
    shape_free(&s);

    expect_ok(shape_icosahedron(&s, 2, 1));
    real golden = (1 + sqrt(5)) / 2, ratio = 5 * sqrt(5) / (3 * golden);
    p = particle_moments(&s), q = solid_moments(&s, 1);
    near_relative(p.x / q.x, ratio, ROUNDING);
    near_relative(p.y / q.y, ratio, ROUNDING);
    near_relative(p.z / q.z, ratio, ROUNDING);
    printf(", icosahedron %.4f", p.x / q.x);
    shape_free(&s);

    static const vec3 at[4] =
        { { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } };
    static const int t[4][3] =
        { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 } };
    expect_ok(shape_convex(&s, 4, at, 4, t, 1));
    p = particle_moments(&s), q = solid_moments(&s, 1);
    near_relative(p.x / q.x, 5, ROUNDING);
    printf(", tetrahedron %.4f times the solid's\n", p.x / q.x);
    shape_free(&s);
}
END_TEST

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
    near_relative(s.at[0].x, -0.25, ROUNDING);    // the mean of 10, 11, 10, 10
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

// Rejects: a rule that a shape of body.c breaks.
START_TEST(shapes_are_sound_and_convex)
{
    shape s;
    expect_ok(shape_box(&s, vec3_make(1, 2, 3), 1));
    expect_ok(mesh_validate(&s.mesh));
    expect_ok(mesh_check_convex(&s.mesh, s.at));
    shape_free(&s);
    expect_ok(shape_icosahedron(&s, 1, 1));
    expect_ok(mesh_validate(&s.mesh));
    expect_ok(mesh_check_convex(&s.mesh, s.at));
    shape_free(&s);
    expect_ok(shape_cloth(&s, 6, 5, 1, 1, 1, 1));
    expect_ok(mesh_validate(&s.mesh));
    shape_free(&s);
}
END_TEST

// Rejects: an absolute tolerance, which fails at one end or the other.
START_TEST(convexity_does_not_depend_on_the_size)
{
    mesh m = build(8, CUBE, 12);
    for (real size = 1e-40; size < 1e41; size *= 1e10) {
        vec3 at[8];
        cube_at(at);
        for (int k = 0; k < 8; k++) at[k] = vec3_scale(size, at[k]);
        expect_ok(mesh_check_convex(&m, at));
        // Corner 3 pulled in by 1e-6 of the side: its sides now bend inwards
        // along the diagonals that end in it.
        at[3] = vec3_scale(1 - 1e-6, at[3]);
        ck_assert(!mesh_check_convex(&m, at).ok);
    }
    mesh_free(&m);
}
END_TEST

// The rule is 1e-9 of the size, here sqrt(3): half of it passes, twice not.
START_TEST(convexity_ends_at_the_stated_tolerance)
{
    mesh m = build(8, CUBE, 12);
    vec3 at[8];
    cube_at(at);
    at[0].z = 0.5e-9;                   // pulled in along z only
    expect_ok(mesh_check_convex(&m, at));
    at[0].z = 4e-9;
    ck_assert(!mesh_check_convex(&m, at).ok);
    mesh_free(&m);
}
END_TEST

START_TEST(dent_is_named_with_face_and_vertex)
{
    vec3 at[8];
    cube_at(at);
    at[7] = vec3_make(0.25, 0.25, 0.25);
    mesh m = build(8, CUBE, 12);
    status s = mesh_check_convex(&m, at);
    ck_assert(!s.ok);
    ck_assert_msg(strstr(s.why, "outside the plane of triangle"), "%s", s.why);
    ck_assert_msg(strstr(s.why, "vertex "), "%s", s.why);
    mesh_free(&m);
}
END_TEST

START_TEST(open_mesh_is_not_convex)
{
    vec3 at[8];
    cube_at(at);
    mesh m = build(8, CUBE, 11);
    expect_why(mesh_check_convex(&m, at), "the edge from vertex 6 to vertex 4 "
               "has a triangle on one side only: the mesh is open");
    mesh_free(&m);
}
END_TEST

START_TEST(unused_vertex_is_named)
{
    vec3 at[5] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
                   { .1, .1, .1 } };
    mesh m = build(5, TETRAHEDRON, 4);
    expect_why(mesh_check_convex(&m, at), "vertex 4 belongs to no triangle");
    mesh_free(&m);
}
END_TEST

// Two tetrahedra far apart: every face is fine, the whole is not one body.
START_TEST(two_bodies_are_not_one)
{
    int two[8][3];
    vec3 at[8];
    for (int t = 0; t < 8; t++) {
        at[t] = vec3_add_scaled(TETRAHEDRON_AT[t % 4], t < 4 ? 0 : 3,
                                vec3_make(1, 1, 1));
        for (int k = 0; k < 3; k++)
            two[t][k] = TETRAHEDRON[t % 4][k] + (t < 4 ? 0 : 4);
    }
    mesh m = build(8, (const int (*)[3])two, 8);
    expect_why(mesh_check_convex(&m, at), "the mesh is not one sphere: "
               "vertices - edges + triangles is 4, not 2");
    mesh_free(&m);
    m = build(0, NULL, 0);
    expect_why(mesh_check_convex(&m, at), "the mesh is not one sphere: "
               "vertices - edges + triangles is 0, not 2");
    mesh_free(&m);
}
END_TEST

START_TEST(flat_triangle_is_named)
{
    vec3 at[5];
    memcpy(at, TETRAHEDRON_AT, sizeof TETRAHEDRON_AT);
    at[4] = vec3_make(.5, 0, 0);        // on the line from 0 to 1
    static const int t[6][3] = { { 0, 2, 1 }, { 0, 4, 3 }, { 4, 1, 3 },
                                 { 0, 3, 2 }, { 1, 2, 3 }, { 0, 1, 4 } };
    mesh m = build(5, t, 6);
    expect_why(mesh_check_convex(&m, at), "triangle 5 is flat: vertex 0, "
               "vertex 1 and vertex 4 stand in one line");
    mesh_free(&m);
}
END_TEST

// Four corners of a square, as a closed mesh: no inside.
START_TEST(body_without_thickness_is_named)
{
    vec3 at[4] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, 0 } };
    static const int t[4][3] =
        { { 0, 1, 3 }, { 0, 3, 2 }, { 0, 3, 1 }, { 0, 2, 3 } };
    mesh m;
    ck_assert(!mesh_build(&m, 4, t, 4).ok);     // its diagonal has four sides
    static const int pillow[2][3] = { { 0, 1, 2 }, { 0, 2, 1 } };
    m = build(3, pillow, 2);
    expect_why(mesh_check_convex(&m, at), "the mesh has no thickness: no "
               "vertex stands below the plane of triangle 0");
    mesh_free(&m);
}
END_TEST

START_TEST(coincident_vertices_are_named)
{
    vec3 at[8];
    cube_at(at);
    at[5] = at[2];
    mesh m = build(8, CUBE, 12);
    expect_why(mesh_check_convex(&m, at),
               "vertex 2 and vertex 5 stand in the same place");
    mesh_free(&m);
}
END_TEST

// Rejects: NaN, which every comparison lets through that is not turned round.
START_TEST(places_that_are_no_numbers_are_named)
{
    vec3 at[4];
    mesh m = build(4, TETRAHEDRON, 4);
    real bad[3] = { (real)NAN, (real)INFINITY, -(real)INFINITY };
    for (int k = 0; k < 3; k++) {
        memcpy(at, TETRAHEDRON_AT, sizeof at);
        at[2].y = bad[k];
        expect_why(mesh_check_convex(&m, at),
                   "vertex 2 is not at a finite place");
    }
    for (int k = 0; k < 4; k++) at[k] = vec3_scale(1e200, TETRAHEDRON_AT[k]);
    status s = mesh_check_convex(&m, at);
    ck_assert(!s.ok && strstr(s.why, "too large to compute with"));
    for (int k = 0; k < 4; k++) at[k] = vec3_scale(1e-200, TETRAHEDRON_AT[k]);
    s = mesh_check_convex(&m, at);
    ck_assert(!s.ok && strstr(s.why, "too small to compute with"));
    mesh_free(&m);
}
END_TEST

START_TEST(turned_mesh_has_negative_volume_and_is_named)
{
    int turned[4][3];
    for (int f = 0; f < 4; f++)
        for (int k = 0; k < 3; k++) turned[f][k] = TETRAHEDRON[f][2 - k];
    mesh m = build(4, (const int (*)[3])turned, 4);
    ck_assert(mesh_volume(&m, TETRAHEDRON_AT) == -1.0 / 6);
    expect_why(mesh_check_convex(&m, TETRAHEDRON_AT),
               "the triangles look inwards: every one of them must be turned "
               "round");
    mesh_free(&m);
}
END_TEST

// Far from the origin as near it.
START_TEST(convexity_does_not_depend_on_the_place)
{
    vec3 at[8];
    cube_at(at);
    mesh m = build(8, CUBE, 12);
    for (int k = 0; k < 8; k++) at[k] = vec3_add(at[k], vec3_make(1e9, 1e9, 0));
    expect_ok(mesh_check_convex(&m, at));
    mesh_free(&m);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        equal_masses_exaggerate_inertia_by_3_and_2_3_and_5,
        tetrahedron_needs_its_six_edges_only,
        fan_joins_vertex_0_to_every_other,
        fan_alone_leaves_flat_vertices_free,
        vertices_inside_flat_sides_are_held,
        thin_plate_has_no_stick_twice,
        rounder_ball_is_rigid,
        bad_meshes_are_refused_with_the_mesh_own_sentence,
        schoenhardt_polyhedron_is_refused_and_shaky,
        radius_out_of_range_is_refused,
        convex_bodies_take_no_index_on_trust,
        shapes_are_sound_and_convex,
        convexity_does_not_depend_on_the_size,
        convexity_ends_at_the_stated_tolerance,
        dent_is_named_with_face_and_vertex,
        open_mesh_is_not_convex,
        unused_vertex_is_named,
        two_bodies_are_not_one,
        flat_triangle_is_named,
        body_without_thickness_is_named,
        coincident_vertices_are_named,
        places_that_are_no_numbers_are_named,
        turned_mesh_has_negative_volume_and_is_named,
        convexity_does_not_depend_on_the_place,
        NULL
    };
    return suite_run((suite){ .name = "convex", .tests = tests });
}
