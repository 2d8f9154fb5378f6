// check_mesh.c - tests of lib/shapes/mesh.c: half-edges, walks, volume.

#include "meshes.h"
#include "scarce.h"
#include "suite.h"
#include "validate.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>

// Rejects: edges counted twice, a rim where there is none.
START_TEST(tetrahedron_has_six_edges_and_no_rim)
{
    mesh m = build(4, TETRAHEDRON, 4);
    ck_assert_int_eq(m.edges, 6);
    ck_assert_int_eq(m.faces, 4);
    ck_assert(mesh_is_closed(&m));
    ck_assert_int_eq(mesh_euler(&m), 2);
    mesh_free(&m);
    expect_empty_mesh(&m);
}
END_TEST

// Rejects: a face that begins elsewhere or turns the other way.
START_TEST(faces_come_back_as_they_went_in)
{
    mesh m = build(8, CUBE, 12);
    for (int f = 0; f < 12; f++) {
        int v[3];
        mesh_face(&m, f, v);
        for (int k = 0; k < 3; k++) ck_assert_int_eq(v[k], CUBE[f][k]);
    }
    mesh_free(&m);
}
END_TEST

START_TEST(empty_mesh_is_a_mesh)
{
    mesh m = build(0, NULL, 0);
    ck_assert(mesh_is_closed(&m));
    ck_assert_int_eq(mesh_euler(&m), 0);
    ck_assert(mesh_volume(&m, NULL) == 0);
    mesh_free(&m);
    mesh zero = { 0 };
    mesh_free(&zero);
    mesh_free(&zero);
}
END_TEST

// Rejects: a twin search that looks at all pairs (this would take minutes).
START_TEST(large_strip_is_built_in_no_time)
{
    enum { SIDE = 400 };
    int (*triangle)[3] = malloc(2 * SIDE * SIDE * sizeof *triangle);
    int n = 0;
    for (int j = 0; j < SIDE; j++)
        for (int i = 0; i < SIDE; i++) {
            int a = j * (SIDE + 1) + i, b = a + 1;
            int c = a + SIDE + 1, d = c + 1;
            int pair[2][3] = { { a, c, b }, { b, c, d } };
            memcpy(triangle[n], pair, sizeof pair);
            n += 2;
        }
    mesh m;
    expect_ok(mesh_build(&m, (SIDE + 1) * (SIDE + 1),
                         (const int (*)[3])triangle, n));
    ck_assert_int_eq(mesh_euler(&m), 1);
    ck_assert_int_eq(m.edges, 3 * SIDE * SIDE + 2 * SIDE);
    mesh_free(&m);
    free(triangle);
}
END_TEST

// One vertex in every triangle.  Rejects: a twin looked for in the list of one
// end alone, which may hold all edges.
START_TEST(large_cone_is_built_in_no_time)
{
    enum { SIDES = 200000 };
    int (*triangle)[3] = malloc(SIDES * sizeof *triangle);
    for (int i = 0; i < SIDES; i++) {
        triangle[i][0] = 0;
        triangle[i][1] = 1 + i;
        triangle[i][2] = 1 + (i + 1) % SIDES;
    }
    mesh m;
    expect_ok(mesh_build(&m, SIDES + 1, (const int (*)[3])triangle, SIDES));
    ck_assert_int_eq(m.edges, 2 * SIDES);
    ck_assert_int_eq(mesh_euler(&m), 1);
    mesh_free(&m);
    free(triangle);
}
END_TEST

// Rejects: a turn the other way round.  Seen from +z the neighbours of vertex 0
// stand counter-clockwise in the order 1, 2, 3, 4, 5: clockwise is back.
START_TEST(turn_is_clockwise)
{
    mesh m = build(7, FAN, 4);
    int h = m.vertex_half[0];
    ck_assert_int_eq(m.half[h].face, -1);
    static const int expected[5] = { 5, 4, 3, 2, 1 };
    for (int k = 0; k < 5; k++) {
        ck_assert_int_eq(mesh_target(&m, h), expected[k]);
        h = mesh_around(&m, h);
    }
    ck_assert_int_eq(h, m.vertex_half[0]);
    ck_assert_int_eq(m.vertex_half[6], -1);
    mesh_free(&m);
}
END_TEST

// Rejects: a turn that leaves out an edge: together all turns meet each
// half-edge once.
START_TEST(turns_around_all_vertices_meet_every_half_edge_once)
{
    mesh m = build(8, CUBE, 12);
    int met[36] = { 0 };
    for (int v = 0; v < 8; v++) {
        int h = m.vertex_half[v];
        do {
            ck_assert_int_eq(m.half[h].origin, v);
            met[h]++;
            h = mesh_around(&m, h);
        } while (h != m.vertex_half[v]);
    }
    for (int h = 0; h < 36; h++) ck_assert_int_eq(met[h], 1);
    mesh_free(&m);
}
END_TEST

// Rejects: a rim linked to the wrong hole.
START_TEST(rim_walks_once_around_the_hole)
{
    mesh m = build(8, CUBE, 10);        // the cube without its +z side
    ck_assert(!mesh_is_closed(&m));
    ck_assert_int_eq(mesh_euler(&m), 1);
    int h = m.vertex_half[4], start = h, steps = 0;
    ck_assert_int_eq(m.half[h].face, -1);
    do {
        ck_assert_int_ge(m.half[h].origin, 4);
        h = m.half[h].next;
        steps++;
    } while (h != start && steps < 100);
    ck_assert_int_eq(steps, 4);
    mesh_free(&m);
}
END_TEST

// Two rims: a belt.  Rejects: one rim for both.
START_TEST(belt_has_two_rims_and_euler_number_zero)
{
    mesh m = build(8, CUBE, 8);         // without +z and -z
    ck_assert_int_eq(mesh_euler(&m), 0);
    for (int v = 0; v < 8; v++) {
        int h = m.vertex_half[v], start = h, steps = 0;
        do {
            ck_assert_int_eq(m.half[h].origin / 4, v / 4);
            h = m.half[h].next;
            steps++;
        } while (h != start && steps < 100);
        ck_assert_int_eq(steps, 4);
    }
    mesh_free(&m);
}
END_TEST

static void expect_refused(int vertices, const int (*triangle)[3], int faces,
                           const char *why)
{
    mesh m;
    memset(&m, 0x55, sizeof m);
    expect_why(mesh_build(&m, vertices, triangle, faces), why);
    expect_empty_mesh(&m);
}

START_TEST(index_out_of_range_is_named)
{
    static const int high[2][3] = { { 0, 1, 2 }, { 1, 0, 3 } };
    expect_refused(3, high, 2, "triangle 1 uses vertex 3, but there are only 3 "
                               "vertices (0 to 2)");
    static const int low[1][3] = { { 0, -1, 2 } };
    expect_refused(3, low, 1, "triangle 0 uses vertex -1, but there are only 3 "
                              "vertices (0 to 2)");
}
END_TEST

START_TEST(vertex_used_twice_is_named)
{
    for (int k = 0; k < 3; k++) {
        int t[1][3] = { { 0, 1, 2 } };
        t[0][(k + 1) % 3] = t[0][k];
        char why[80];
        snprintf(why, sizeof why, "triangle 0 uses vertex %d twice", t[0][k]);
        expect_refused(3, (const int (*)[3])t, 1, why);
    }
}
END_TEST

START_TEST(edge_with_three_triangles_is_named)
{
    static const int t[3][3] = { { 0, 1, 2 }, { 1, 0, 3 }, { 4, 0, 1 } };
    expect_refused(5, t, 3, "triangle 0 and triangle 2 both run from vertex 0 "
                            "to vertex 1: one of them is turned inside out, or "
                            "the edge has three triangles");
}
END_TEST

START_TEST(neighbours_that_turn_opposite_ways_are_named)
{
    static const int t[2][3] = { { 0, 1, 2 }, { 3, 0, 1 } };
    expect_refused(4, t, 2, "triangle 0 and triangle 1 both run from vertex 0 "
                            "to vertex 1: one of them is turned inside out, or "
                            "the edge has three triangles");
}
END_TEST

// Two open fans; two closed ones (tetrahedra that touch); one of each.
START_TEST(pinched_vertex_is_named)
{
    static const int open[2][3] = { { 2, 0, 1 }, { 2, 3, 4 } };
    expect_refused(5, open, 2, "two fans of triangles meet in vertex 2 and "
                               "nowhere else: the surface is pinched there");

    int closed[8][3];
    for (int t = 0; t < 8; t++)
        for (int k = 0; k < 3; k++) {
            int v = TETRAHEDRON[t % 4][k];
            closed[t][k] = t < 4 || v == 0 ? v : v + 3;
        }
    const char *why = "two fans of triangles meet in vertex 0 and nowhere "
                      "else: the surface is pinched there";
    expect_refused(7, (const int (*)[3])closed, 8, why);
    expect_refused(7, (const int (*)[3])closed, 7, why);
}
END_TEST

START_TEST(sizes_are_checked_before_they_overflow)
{
    mesh m;
    expect_why(mesh_build(&m, -1, NULL, 0),
               "a mesh cannot have -1 vertices and 0 triangles");
    expect_why(mesh_build(&m, 3, NULL, -4),
               "a mesh cannot have 3 vertices and -4 triangles");
    // The triangles are not looked at: their number alone is refused.
    status s = mesh_build(&m, 4, TETRAHEDRON, INT_MAX / 3);
    ck_assert(!s.ok && strstr(s.why, "a mesh cannot have"));
    s = mesh_build(&m, INT_MAX, TETRAHEDRON, 4);
    ck_assert(!s.ok && strstr(s.why, "a mesh cannot have"));
    expect_empty_mesh(&m);
}
END_TEST

// Rejects: a leak, or a half-built mesh, when any one allocation is refused.
START_TEST(refused_memory_leaves_nothing)
{
    int refused = 0;
    for (int n = 0; n < 20; n++) {
        mesh m;
        mallocs_left = n;
        status s = mesh_build(&m, 8, CUBE, 12);
        mallocs_left = INT_MAX;
        if (s.ok) { mesh_free(&m); break; }
        expect_why(s, "out of memory");
        expect_empty_mesh(&m);
        refused++;
    }
    ck_assert_int_ge(refused, 3);       // three arrays are the mesh's own
}
END_TEST

static void expect_volume(const mesh *m, const vec3 *at, real volume)
{
    real got = mesh_volume(m, at);
    ck_assert_msg(fabs(got - volume) <= 1e-12, "got %.17g, wanted %.17g", got,
                  volume);
}

START_TEST(volume_of_the_corner_tetrahedron_is_a_sixth)
{
    mesh m = build(4, TETRAHEDRON, 4);
    expect_volume(&m, TETRAHEDRON_AT, 1.0 / 6);
    mesh_free(&m);
}
END_TEST

// The same tetrahedron, its triangles turned round.
START_TEST(volume_of_a_turned_mesh_is_negative)
{
    int turned[4][3];
    for (int f = 0; f < 4; f++)
        for (int k = 0; k < 3; k++) turned[f][k] = TETRAHEDRON[f][2 - k];
    mesh m = build(4, (const int (*)[3])turned, 4);
    expect_volume(&m, TETRAHEDRON_AT, -1.0 / 6);
    mesh_free(&m);
}
END_TEST

// Rejects: volume summed from the world's origin, which a million kilometres
// away loses every digit.
START_TEST(volume_does_not_depend_on_the_place)
{
    vec3 at[8];
    cube_at(at);
    mesh m = build(8, CUBE, 12);
    expect_volume(&m, at, 1);
    for (int k = 0; k < 8; k++) at[k] = vec3_add(at[k], vec3_make(1e9, 1e9, 0));
    expect_volume(&m, at, 1);
    mesh_free(&m);
}
END_TEST

// Rejects: a rule that a sound mesh breaks: closed, with a rim, with a lone
// vertex, empty.
START_TEST(sound_meshes_pass)
{
    mesh m = build(4, TETRAHEDRON, 4);
    expect_ok(mesh_validate(&m));
    mesh_free(&m);
    m = build(7, FAN, 4);
    expect_ok(mesh_validate(&m));
    mesh_free(&m);
    expect_ok(mesh_validate(&m));
    for (int faces = 8; faces <= 12; faces++) {
        m = build(8, CUBE, faces);
        expect_ok(mesh_validate(&m));
        mesh_free(&m);
    }
}
END_TEST

START_TEST(validator_names_bad_indices)
{
    mesh m = build(4, TETRAHEDRON, 4);
    half_edge kept = m.half[5];
    m.half[5].origin = 4;
    expect_why(mesh_validate(&m),
               "half-edge 5 leaves vertex 4, which does not exist");
    m.half[5].origin = -1;
    expect_why(mesh_validate(&m),
               "half-edge 5 leaves vertex -1, which does not exist");
    m.half[5] = kept;
    m.half[5].next = 12;
    expect_why(mesh_validate(&m),
               "half-edge 5 is followed by half-edge 12, which does not exist");
    m.half[5].next = -1;
    expect_why(mesh_validate(&m),
               "half-edge 5 is followed by half-edge -1, which does not exist");
    m.half[5] = kept;
    m.half[5].face = 4;
    expect_why(mesh_validate(&m),
               "half-edge 5 borders face 4, which does not exist");
    m.half[5].face = -2;
    expect_why(mesh_validate(&m),
               "half-edge 5 borders face -2, which does not exist");
    m.half[5] = kept;
    expect_ok(mesh_validate(&m));
    mesh_free(&m);
}
END_TEST

START_TEST(validator_names_bad_edges)
{
    mesh m = build(4, TETRAHEDRON, 4);
    m.half[4].face = m.half[5].face = -1;
    expect_why(mesh_validate(&m), "edge 2 has no face on either side");
    mesh_free(&m);

    m = build(4, TETRAHEDRON, 4);
    m.half[5].origin = m.half[4].origin;
    expect_why(mesh_validate(&m), "edge 2 begins and ends in vertex 1");
    mesh_free(&m);
}
END_TEST

START_TEST(validator_names_bad_successors)
{
    mesh m = build(4, TETRAHEDRON, 4);
    m.half[0].next = m.half[m.half[0].next].next;
    expect_why(mesh_validate(&m), "half-edge 0 is followed by half-edge 4, "
                                  "which does not leave where it ends");
    mesh_free(&m);

    m = build(4, TETRAHEDRON, 4);
    m.half[m.half[0].next].face = 3;
    expect_why(mesh_validate(&m), "half-edge 0 borders face 0, but half-edge 2 "
                                  "after it borders face 3");
    mesh_free(&m);
}
END_TEST

// Two faces that meet in a vertex, made into one of six sides.
START_TEST(validator_names_a_face_of_six_sides)
{
    mesh m = build(8, CUBE, 12);
    // Faces 0 (0 4 6) and 2 (3 7 5) share nothing; 0 and 4 (0 1 5) share 0.
    int into_a = m.half[m.half[m.face_half[0]].next].next;
    int into_b = m.half[m.half[m.face_half[4]].next].next;
    int kept = m.half[into_a].next;
    m.half[into_a].next = m.half[into_b].next;
    m.half[into_b].next = kept;
    for (int h = 0; h < 36; h++)
        if (m.half[h].face == 4) m.half[h].face = 0;
    char why[120];
    snprintf(why, sizeof why, "half-edge %d is not back at itself after three "
             "steps around face 0", 0);
    expect_why(mesh_validate(&m), why);
    mesh_free(&m);
}
END_TEST

START_TEST(validator_names_bad_faces)
{
    mesh m = build(4, TETRAHEDRON, 4);
    int kept = m.face_half[2];
    m.face_half[2] = 12;
    expect_why(mesh_validate(&m),
               "face 2 begins with half-edge 12, which does not border it");
    m.face_half[2] = -1;
    expect_why(mesh_validate(&m),
               "face 2 begins with half-edge -1, which does not border it");
    m.face_half[2] = m.face_half[1];
    char why[120];
    snprintf(why, sizeof why, "face 2 begins with half-edge %d, which does not "
             "border it", m.face_half[1]);
    expect_why(mesh_validate(&m), why);
    m.face_half[2] = kept;

    // Two loops of three that bear one number.
    for (int h = 0; h < 12; h++)
        if (m.half[h].face == 3) m.half[h].face = 0;
    m.faces = 3;
    expect_why(mesh_validate(&m), "12 half-edges border the 3 faces: three "
                                  "times as many as faces it must be");
    m.faces = 4;
    mesh_free(&m);
}
END_TEST

START_TEST(validator_names_bad_vertices)
{
    mesh m = build(7, FAN, 4);
    int kept = m.vertex_half[0];
    m.vertex_half[0] = -1;
    expect_why(mesh_validate(&m), "vertex 0 begins with half-edge -1, which "
                                  "does not leave it");
    m.vertex_half[0] = 99;
    expect_why(mesh_validate(&m), "vertex 0 begins with half-edge 99, which "
                                  "does not leave it");
    m.vertex_half[0] = 2;
    expect_why(mesh_validate(&m),
               "vertex 0 begins with half-edge 2, which does not leave it");
    m.vertex_half[0] = 0;
    char why[120];
    snprintf(why, sizeof why, "vertex 0 begins with half-edge 0, but half-edge "
             "%d runs along a rim", kept);
    expect_why(mesh_validate(&m), why);
    m.vertex_half[0] = kept;
    m.vertex_half[6] = 0;               // no edge leaves vertex 6
    expect_why(mesh_validate(&m),
               "vertex 6 begins with half-edge 0, which does not leave it");
    mesh_free(&m);
}
END_TEST

// Vertex 3 of a second triangle is glued onto vertex 0 of the first.
START_TEST(validator_names_a_pinched_vertex)
{
    static const int t[2][3] = { { 0, 1, 2 }, { 3, 4, 5 } };
    mesh m = build(6, t, 2);
    int rim_a = m.vertex_half[0], rim_b = m.vertex_half[3];
    for (int h = 0; h < 12; h++)
        if (m.half[h].origin == 3) m.half[h].origin = 0;
    m.vertex_half[3] = -1;
    expect_why(mesh_validate(&m), "4 half-edges leave vertex 0, but a turn "
                                  "around it does not meet each of them once");

    // The two rims made one: now the turn meets all, and the rim twice.
    for (int h = 0; h < 12; h++) {
        if (m.half[h].next == rim_a) m.half[h].next = rim_b;
        else if (m.half[h].next == rim_b) m.half[h].next = rim_a;
    }
    char why[120];
    snprintf(why, sizeof why, "vertex 0 begins with half-edge %d, but "
             "half-edge %d runs along a rim", rim_a, rim_b);
    expect_why(mesh_validate(&m), why);
    mesh_free(&m);
}
END_TEST

START_TEST(validator_names_bad_counts)
{
    mesh m = { .vertices = -1 };
    expect_why(mesh_validate(&m),
               "the mesh counts -1 vertices, 0 edges and 0 faces");
    // Rejects: a count of faces or edges that is not looked at.
    m = (mesh){ .edges = -1 };
    expect_why(mesh_validate(&m),
               "the mesh counts 0 vertices, -1 edges and 0 faces");
    m = (mesh){ .faces = -1 };
    expect_why(mesh_validate(&m),
               "the mesh counts 0 vertices, 0 edges and -1 faces");
    m = (mesh){ .edges = INT_MAX };
    ck_assert(!mesh_validate(&m).ok);
    const char *hollow = "the mesh counts elements that it does not hold";
    m = (mesh){ .vertices = 3 };
    expect_why(mesh_validate(&m), hollow);
    m = (mesh){ .edges = 3 };
    expect_why(mesh_validate(&m), hollow);
    m = (mesh){ .faces = 3 };
    expect_why(mesh_validate(&m), hollow);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        tetrahedron_has_six_edges_and_no_rim,
        faces_come_back_as_they_went_in,
        empty_mesh_is_a_mesh,
        large_strip_is_built_in_no_time,
        large_cone_is_built_in_no_time,
        turn_is_clockwise,
        turns_around_all_vertices_meet_every_half_edge_once,
        rim_walks_once_around_the_hole,
        belt_has_two_rims_and_euler_number_zero,
        index_out_of_range_is_named,
        vertex_used_twice_is_named,
        edge_with_three_triangles_is_named,
        neighbours_that_turn_opposite_ways_are_named,
        pinched_vertex_is_named,
        sizes_are_checked_before_they_overflow,
        refused_memory_leaves_nothing,
        volume_of_the_corner_tetrahedron_is_a_sixth,
        volume_does_not_depend_on_the_place,
        volume_of_a_turned_mesh_is_negative,
        sound_meshes_pass,
        validator_names_bad_indices,
        validator_names_bad_edges,
        validator_names_bad_successors,
        validator_names_a_face_of_six_sides,
        validator_names_bad_faces,
        validator_names_bad_vertices,
        validator_names_a_pinched_vertex,
        validator_names_bad_counts,
        NULL
    };
    return suite_run((suite){ .name = "mesh", .tests = tests });
}
