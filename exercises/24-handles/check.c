// check.c - tests of the exercise 24/handles.

#include "handles.h"
#include "scarce.h"
#include "suite.h"

#include <check.h>

enum { STRIP = 200000, MOST = STRIP };

static int triangle[MOST][3];
static int triangles;

static void add(int a, int b, int c)
{
    triangle[triangles][0] = a;
    triangle[triangles][1] = b;
    triangle[triangles++][2] = c;
}

// Two triangles for the cell (i, j) of a grid of columns x rows vertices that
// closes on itself in both directions; its vertices begin at number `first`.
static void add_cell(int first, int columns, int rows, int i, int j)
{
    int a = first + j * columns + i;
    int b = first + j * columns + (i + 1) % columns;
    int up = first + (j + 1) % rows * columns;
    add(a, b, up + (i + 1) % columns);
    add(a, up + (i + 1) % columns, up + i);
}

// A torus of 5 x 4 vertices, without its first `missing` cells.
static void add_torus(int first, int missing)
{
    for (int j = 0; j < 4; j++)
        for (int i = 0; i < 5; i++)
            if (j * 5 + i >= missing) add_cell(first, 5, 4, i, j);
}

static void add_tetrahedron(int first)
{
    add(first, first + 2, first + 1);
    add(first, first + 1, first + 3);
    add(first, first + 3, first + 2);
    add(first + 1, first + 2, first + 3);
}

static mesh built(int vertices)
{
    mesh m;
    status s = mesh_build(&m, vertices, (const int (*)[3])triangle, triangles);
    ck_assert_msg(s.ok, "the test's own mesh: %s", s.why);
    triangles = 0;
    return m;
}

// The three counts of the mesh of what was added.
static void expect(const char *what, int vertices, int pieces, int rims,
                   int handles)
{
    mesh m = built(vertices);
    int got = count_pieces(&m);
    ck_assert_msg(got == pieces, "%s: got %d pieces, wanted %d", what, got,
                  pieces);
    got = count_rims(&m);
    ck_assert_msg(got == rims, "%s: got %d rims, wanted %d", what, got, rims);
    got = count_handles(&m);
    ck_assert_msg(got == handles, "%s: got %d handles, wanted %d.  V - E + F "
                  "is %d, and 2 pieces - 2 handles - rims", what, got, handles,
                  mesh_euler(&m));
    mesh_free(&m);
}

START_TEST(tetrahedron_is_a_ball)
{
    // Rejects: the wrong sign of Euler's formula, faces that count as rims.
    add_tetrahedron(0);
    expect("a tetrahedron", 4, 1, 0, 0);
}
END_TEST

START_TEST(torus_has_a_handle)
{
    // Rejects: 2 - g in the place of 2 - 2 g.
    add_torus(0, 0);
    expect("a torus", 20, 1, 0, 1);
}
END_TEST

START_TEST(triangle_has_a_rim)
{
    // Rejects: a rim for each of its half-edges, a ring on the inner side.
    add(0, 1, 2);
    expect("a triangle", 3, 1, 1, 0);
}
END_TEST

START_TEST(tube_has_two_rims)
{
    // Rejects: one rim for all half-edges without a face; rims forgotten.
    for (int j = 0; j < 3; j++)
        for (int i = 0; i < 5; i++) add_cell(0, 5, 4, i, j);
    expect("a tube", 20, 1, 2, 0);
}
END_TEST

START_TEST(cup_has_a_handle_and_an_open_top)
{
    // A torus with a hole cut into it.  Rejects: a rim that hides a handle.
    add_torus(0, 2);
    expect("a cup", 20, 1, 1, 1);
}
END_TEST

START_TEST(three_links_are_three_pieces)
{
    // Their vertices do not know that they are linked.  Rejects: one piece
    // whatever comes; handles of the last piece only.
    for (int k = 0; k < 3; k++) add_torus(20 * k, 0);
    expect("a chain of three", 60, 3, 0, 3);
    add_torus(0, 0);
    add_tetrahedron(20);
    add(24, 25, 26);
    expect("a torus, a tetrahedron and a triangle", 27, 3, 1, 1);
}
END_TEST

START_TEST(vertices_alone_do_not_count)
{
    // vertex_half is -1 there.  Rejects: half[-1]; a piece for each; a handle
    // fewer for every two.
    add_tetrahedron(3);
    expect("a tetrahedron among six lone vertices", 10, 1, 0, 0);
}
END_TEST

START_TEST(nothing_is_nothing)
{
    expect("no triangle", 0, 0, 0, 0);
    expect("seven lone vertices", 7, 0, 0, 0);
}
END_TEST

START_TEST(long_strip_is_one_piece)
{
    // 200,000 triangles in a row, numbered from both ends inwards.  Rejects: a
    // look at direct neighbours only; a list that overflows; a time that grows
    // as the square of the mesh, which would be minutes.
    int n = STRIP;
    for (int k = 0; k < n; k++) {
        int v[3];
        for (int i = 0; i < 3; i++) {
            int place = k + i;
            v[i] = place % 2 ? n + 1 - place / 2 : place / 2;
        }
        if (k % 2) add(v[1], v[0], v[2]);
        else add(v[0], v[1], v[2]);
    }
    expect("a strip", n + 2, 1, 1, 0);
}
END_TEST

START_TEST(refused_memory_is_answered)
{
    // Rejects: memory that is written to before it is there; some that is
    // taken, but not given back.
    add_torus(0, 1);
    mesh m = built(20);
    for (int grants = 0; grants < 8; grants++) {
        long before = blocks_held;
        mallocs_left = grants;
        int pieces = count_pieces(&m), rims = count_rims(&m);
        int handles = count_handles(&m);
        mallocs_left = INT_MAX;
        long kept = blocks_held - before;
        ck_assert_msg((pieces == 1 || pieces == -1) && (rims == 1 || rims == -1)
                      && (handles == 1 || handles == -1), "memory given %d "
                      "times: %d pieces, %d rims, %d handles, wanted 1 or -1",
                      grants, pieces, rims, handles);
        ck_assert_msg(kept == 0, "%ld blocks of memory are not given back",
                      kept);
    }
    mesh_free(&m);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        tetrahedron_is_a_ball,
        torus_has_a_handle,
        triangle_has_a_rim,
        tube_has_two_rims,
        cup_has_a_handle_and_an_open_top,
        three_links_are_three_pieces,
        vertices_alone_do_not_count,
        nothing_is_nothing,
        long_strip_is_one_piece,
        refused_memory_is_answered,
        NULL
    };
    return suite_run((suite){ .name = "handles", .tests = tests });
}
