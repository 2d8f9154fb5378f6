// check_ring.c - tests of lib/query/ring.c: neighbours in a row, inner radius.

#include "ring.h"
#include "scarce.h"

#include <check.h>

// Rejects: a neighbour left out or twice, rows that begin elsewhere.
static void expect_rings_of(const mesh *m)
{
    rings r;
    ck_assert(rings_build(&r, m).ok);
    ck_assert_int_eq(r.start[m->vertices], 2 * m->edges);
    for (int h = 0; h < 2 * m->edges; h++) {
        int v = m->half[h].origin, found = 0;
        for (int k = r.start[v]; k < r.start[v + 1]; k++)
            found += r.list[k] == mesh_target(m, h);
        ck_assert_int_eq(found, 1);
    }
    rings_free(&r);
    ck_assert(!r.start && !r.list);
}

START_TEST(rings_hold_every_neighbour_once)
{
    shape s;
    ck_assert(shape_box(&s, vec3_make(1, 2, 3), 1).ok);
    expect_rings_of(&s.mesh);
    shape_free(&s);
    ck_assert(shape_icosahedron(&s, 1, 1).ok);
    expect_rings_of(&s.mesh);
    shape_free(&s);
    ck_assert(shape_cloth(&s, 5, 4, 1, 1, 1, 1).ok);
    expect_rings_of(&s.mesh);
    shape_free(&s);
}
END_TEST

// A box's nearest side; an icosahedron's: r sqrt((5 + 2 sqrt 5) / 15).
// Rejects: the farthest side; an inside where a cloth has none.
START_TEST(inner_radius_is_that_of_the_nearest_side)
{
    shape s;
    ck_assert(shape_box(&s, vec3_make(1, 2, 3), 1).ok);
    ck_assert(shape_inner(&s) == 0.5);
    shape_free(&s);
    ck_assert(shape_icosahedron(&s, 2, 1).ok);
    ck_assert(fabs(shape_inner(&s) - 2 * sqrt((5 + 2 * sqrt(5)) / 15)) < 1e-14);
    shape_free(&s);
    ck_assert(shape_cloth(&s, 5, 4, 1, 1, 1, 1).ok);
    ck_assert(shape_inner(&s) == 0);
    shape_free(&s);
}
END_TEST

START_TEST(refused_memory_leaves_nothing)
{
    shape s;
    ck_assert(shape_box(&s, vec3_make(1, 2, 3), 1).ok);
    for (int n = 0; n < 2; n++) {
        rings r;
        long held = blocks_held;
        mallocs_left = n;
        status done = rings_build(&r, &s.mesh);
        mallocs_left = INT_MAX;
        held = blocks_held - held;
        ck_assert(!done.ok && !r.start && !r.list);
        ck_assert_int_eq(held, 0);
    }
    shape_free(&s);
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("ring");
    TCase *all = tcase_create("all");
    tcase_add_test(all, rings_hold_every_neighbour_once);
    tcase_add_test(all, inner_radius_is_that_of_the_nearest_side);
    tcase_add_test(all, refused_memory_leaves_nothing);
    suite_add_tcase(suite, all);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
