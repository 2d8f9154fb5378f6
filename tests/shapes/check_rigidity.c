// check_rigidity.c - the rank of the rigidity matrix.

#include "rigidity.h"
#include "scarce.h"
#include "shapes.h"
#include "suite.h"

#include <stdio.h>

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
    static const int first[3][2] = { { 0, 1 }, { 0, 1 }, { 1, 3 } };
    ck_assert_int_eq(rank_of_cube(first, 3), 2);
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
    vec3 at[4] = { { 0, 0, 0 }, { 1e12, 0, 0 }, { 0, 0, 0 }, { 0, 1e-12, 0 } };
    stick sticks[2] = { { 0, 1, 1e12, 1, STICK_EXACT },
                        { 2, 3, 1e-12, 1, STICK_EXACT } };
    shape s = { .particles = 4, .at = at, .sticks = 2, .stick = sticks };
    ck_assert_int_eq(shape_rank(&s), 2);
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

// A free line of n links has rank n: nothing holds it straight.
START_TEST(rope_has_the_rank_of_its_links)
{
    shape s;
    expect_ok(shape_rope(&s, 10, 3, 2));
    ck_assert_int_eq(shape_rank(&s), 10);
    shape_free(&s);
}
END_TEST

// Rejects: a number of bytes that overflows.
START_TEST(refused_memory_is_said)
{
    shape s;
    expect_ok(shape_box(&s, vec3_make(1, 1, 1), 1));
    mallocs_left = 0;
    int rank = shape_rank(&s);
    mallocs_left = INT_MAX;
    ck_assert_int_eq(rank, -1);
    shape_free(&s);
    s = (shape){ .particles = INT_MAX, .sticks = INT_MAX };
    ck_assert_int_eq(shape_rank(&s), -1);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        edges_and_main_diagonals_of_a_cube_have_rank_15,
        every_choice_of_side_diagonals_has_rank_18,
        box_and_icosahedron_are_rigid,
        rank_does_not_depend_on_the_size,
        rank_counts_what_is_independent,
        short_stick_counts_as_much_as_a_long_one,
        flat_cloth_is_rigid_in_its_plane_only,
        rope_has_the_rank_of_its_links,
        refused_memory_is_said,
        NULL
    };
    return suite_run((suite){ .name = "rigidity", .tests = tests });
}
