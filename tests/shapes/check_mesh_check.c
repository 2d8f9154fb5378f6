// check_mesh_check.c - tests of lib/shapes/mesh_check.c: the validator, convexity.

#include "body.h"
#include "mesh_check.h"
#include "meshes.h"
#include "scarce.h"

#include <limits.h>
#include <stdio.h>

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
    expect_why(mesh_validate(&m), "half-edge 0 is followed by half-edge 4, which "
                                  "does not leave where it ends");
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
    m.vertex_half[6] = 0;               // nobody leaves vertex 6
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
    snprintf(why, sizeof why, "vertex 0 begins with half-edge %d, but half-edge "
             "%d runs along a rim", rim_a, rim_b);
    expect_why(mesh_validate(&m), why);
    mesh_free(&m);
}
END_TEST

START_TEST(validator_names_bad_counts)
{
    mesh m = { .vertices = -1 };
    expect_why(mesh_validate(&m),
               "the mesh counts -1 vertices, 0 edges and 0 faces");
    // Rejects: a count of faces or edges that nobody looks at.
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

// Rejects: a rule that a sound mesh breaks: closed, with a rim, with a lone
// vertex, empty, and those of the shapes.
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

START_TEST(refused_memory_leaves_nothing)
{
    mesh m = build(8, CUBE, 12);
    long held = blocks_held;
    mallocs_left = 0;
    status s = mesh_validate(&m);
    mallocs_left = INT_MAX;
    held = blocks_held - held;
    expect_why(s, "out of memory");
    ck_assert_int_eq(held, 0);
    mesh_free(&m);
}
END_TEST

int main(void)
{
    const TTest *tests[] = {
        sound_meshes_pass, convexity_does_not_depend_on_the_place,
        refused_memory_leaves_nothing,
        validator_names_bad_indices, validator_names_bad_edges,
        validator_names_bad_successors, validator_names_a_face_of_six_sides,
        validator_names_bad_faces, validator_names_bad_vertices,
        validator_names_a_pinched_vertex, 
        validator_names_bad_counts, convexity_does_not_depend_on_the_size,
        convexity_ends_at_the_stated_tolerance,
        dent_is_named_with_face_and_vertex, open_mesh_is_not_convex,
        unused_vertex_is_named, two_bodies_are_not_one, flat_triangle_is_named,
        body_without_thickness_is_named, coincident_vertices_are_named,
        places_that_are_no_numbers_are_named,
        turned_mesh_has_negative_volume_and_is_named
    };
    Suite *suite = suite_create("mesh_check");
    TCase *all = tcase_create("all");
    for (int k = 0; k < COUNT(tests); k++) tcase_add_test(all, tests[k]);
    suite_add_tcase(suite, all);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
