// check_body.c - tests of lib/shapes/body.c: shapes and their sticks.

#include "scarce.h"
#include "expect.h"
#include "shapes.h"
#include "suite.h"

#include <limits.h>
#include <stdlib.h>

static status build_nth(int which, shape *s)
{
    if (which == 0) return shape_box(s, vec3_make(1, 1, 1), 1);
    if (which == 1) return shape_icosahedron(s, 1, 1);
    if (which == 2) return shape_rope(s, 4, 1, 1);
    return shape_cloth(s, 4, 4, 1, 1, 1, 1);
}

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
    near_relative(mesh_volume(&s.mesh, s.at), 6, ROUNDING);
    near_relative(s.radius, sqrt(14) / 2, ROUNDING);
    ck_assert(s.spacing == 1);
    shape_free(&s);
}
END_TEST

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
    for (int v = 0; v < 12; v++) ck_assert(has_stick(&s, v, v ^ 3));
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
        near_relative(vec3_length(s.at[i]), r, ROUNDING);
    for (int e = 0; e < 30; e++)
        near_relative(vec3_distance(s.at[s.mesh.half[2 * e].origin],
                                  s.at[s.mesh.half[2 * e + 1].origin]),
                    a, ROUNDING);
    near_relative(s.spacing, a, ROUNDING);
    near_relative(mesh_volume(&s.mesh, s.at),
                5 * (3 + sqrt(5)) * a * a * a / 12, ROUNDING);
    shape_free(&s);
}
END_TEST

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
    ck_assert(s.columns == 11 && s.rows == 1);
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
        ck_assert(s.columns == c && s.rows == r);
        ck_assert_int_eq(s.mesh.faces, 2 * cells);
        ck_assert_int_eq(s.sticks, c * (r - 1) + r * (c - 1) + cells);
        ck_assert_int_eq(s.sticks, s.mesh.edges);
        ck_assert_int_eq(mesh_euler(&s.mesh), 1);
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
            near_relative(a.x + 1, 2 * i / 4.0, ROUNDING);
            near_relative(a.z + 1.5, 3 * j / 3.0, ROUNDING);
            ck_assert(a.y == 0 && a.x == -b.x && a.z == -b.z);
        }
    for (int f = 0; f < s.mesh.faces; f++) {
        const int *v = &s.face[3 * f];
        vec3 n = vec3_cross(vec3_sub(s.at[v[1]], s.at[v[0]]),
                            vec3_sub(s.at[v[2]], s.at[v[0]]));
        near_relative(n.y, 0.5, ROUNDING);            // twice half a cell
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
        ck_assert(s.stick[k].stiffness == (straight ? 1 : 0.25));
    }
    shape_free(&s);
}
END_TEST

// Rejects: links along x listed row by row, where every stick waits for the one
// before.
START_TEST(neighbouring_sticks_of_a_cloth_share_no_particle)
{
    shape s;
    expect_ok(shape_cloth(&s, 20, 20, 1, 1, 1, 0.2));
    int shared = 0;
    for (int k = 1; k < s.sticks; k++) {
        stick t = s.stick[k - 1], u = s.stick[k];
        shared += t.a == u.a || t.a == u.b || t.b == u.a || t.b == u.b;
    }
    ck_assert_int_le(shared, 20);
    shape_free(&s);
}
END_TEST

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

// Rejects: a stick of length 0, by which a relaxation would divide; a NaN that
// the largest of many distances overlooks.
START_TEST(stick_without_a_length_is_refused)
{
    const real x[2] = { 0, (real)NAN };
    for (int k = 0; k < 2; k++) {
        shape s;
        expect_ok(shape_begin(&s, SHAPE_RIGID, 3, 2, 1));
        s.at[1].x = x[k];
        s.at[2].x = 1;
        shape_add_stick(&s, 0, 1);
        shape_add_stick(&s, 0, 2);
        status r = shape_finish(&s, status_ok());
        ck_assert(!r.ok && strstr(r.why, "stick 0 joins particles 0 and 1"));
        expect_empty(&s);
    }
}
END_TEST

// An angle between two edges of a box, and a second one.
START_TEST(angles_are_kept_in_their_order)
{
    shape s;
    expect_ok(shape_box(&s, vec3_make(1, 1, 1), 1));
    ck_assert_int_eq(s.angles, 0);
    expect_ok(shape_add_angle(&s, (angle){ 1, 0, 2, 0, 1 }));
    expect_ok(shape_add_angle(&s, (angle){ 4, 0, 1, 0.5, 0.25 }));
    ck_assert_int_eq(s.angles, 2);
    ck_assert(s.angle[0].b == 2 && s.angle[1].a == 4);
    ck_assert(s.angle[1].cosine == 0.5);
    mallocs_left = 0;
    status r = shape_add_angle(&s, (angle){ 1, 0, 2, 0, 1 });
    mallocs_left = INT_MAX;
    expect_why(r, "out of memory");
    ck_assert_int_eq(s.angles, 2);
    shape_free(&s);
    expect_empty(&s);
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

// Rejects: a leak, or a half-built shape, when any one allocation is refused.
START_TEST(refused_memory_leaves_nothing)
{
    for (int which = 0; which < 4; which++) {
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
        ck_assert_int_ge(n, 3);    // places, masses, sticks
        ck_assert_int_lt(n, 40);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        box_has_8_particles_12_faces_and_22_sticks,
        box_has_its_sides_volume_and_radius,
        icosahedron_has_12_particles_20_faces_and_36_sticks,
        icosahedron_is_regular,
        rope_is_a_line_of_equal_links,
        rope_of_a_million_links_is_built,
        cloth_has_its_counts,
        cloth_lies_flat_and_looks_up,
        cloth_diagonals_alternate_and_come_last,
        neighbouring_sticks_of_a_cloth_share_no_particle,
        mirror_image_satisfies_every_stick,
        numbers_that_are_none_are_refused,
        counts_out_of_range_are_refused,
        stiffness_of_diagonals_lies_above_0_and_at_most_1,
        freeing_nothing_is_harmless,
        stick_without_a_length_is_refused,
        angles_are_kept_in_their_order,
        refused_memory_leaves_nothing,
        NULL
    };
    return suite_run((suite){ .name = "body", .tests = tests });
}
