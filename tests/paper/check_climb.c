// check_climb.c - tests of lib/paper/climb.

#include "bodies.h"
#include "climb.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stddef.h>

// Rejects: a climb that goes to any higher neighbour once, or stops at the first
// that is no higher.
START_TEST(a_climb_over_a_dome_ends_as_high_as_a_look_at_all)
{
    unsigned long long seed = 3;
    struct mesh m;
    body dome;
    ck_assert(table_mesh(&m, TABLE_FOOT).ok);
    body_table(&dome, TABLE_FOOT, -1, &seed);
    hull_mesh b = { body_hull(&dome), &m, 20 };
    ck_assert(hull_climbs(&b));
    for (int n = 0; n < 2000; n++) {
        vec3 d = random_direction(&seed);
        int v = hull_climb(&b, d, random_below(&seed, dome.count));
        int best = hull_scan(b.hull, d);
        ck_assert(vec3_dot(d, dome.at[v]) == vec3_dot(d, dome.at[best]));
    }
    mesh_free(&m);
}
END_TEST

// Why nobody may believe a climb: from the middle of a flat top no edge leads to
// the vertex below it.
START_TEST(a_climb_may_end_on_a_plain)
{
    unsigned long long seed = 4;
    struct mesh m;
    body flat;
    ck_assert(table_mesh(&m, TABLE_FOOT).ok);
    body_table(&flat, TABLE_FOOT, 0, &seed);
    hull_mesh b = { body_hull(&flat), &m, 20 };
    vec3 down = { 0, 0, -1 };
    ck_assert_int_eq(hull_climb(&b, down, 27), 27);
    ck_assert_int_eq(hull_climb(&b, down, 0), flat.count - 1);
    ck_assert_int_eq(hull_scan(b.hull, down), flat.count - 1);
    mesh_free(&m);
}
END_TEST

// Rejects: a climb along a mesh that is not there, or is another body's.
START_TEST(without_a_mesh_of_its_own_all_of_a_body_is_looked_at)
{
    unsigned long long seed = 5;
    struct mesh m;
    body flat;
    ck_assert(table_mesh(&m, TABLE_FOOT).ok);
    body_table(&flat, TABLE_FOOT, 0, &seed);
    vec3 down = { 0, 0, -1 };
    hull_mesh none = { body_hull(&flat), NULL, 20 }, other = none;
    flat.at[flat.count++] = vec3_make(0, 0, -6);
    other.mesh = &m, other.hull.count++;
    ck_assert_int_eq(hull_climb(&none, down, 27), flat.count - 2);
    ck_assert_int_eq(hull_climb(&other, down, 27), flat.count - 1);
    mesh_free(&m);
}
END_TEST

// Rejects: the last of equals.
START_TEST(of_equals_a_look_at_all_finds_the_first)
{
    const vec3 at[4] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
    const hull square = { at, 4 };
    ck_assert_int_eq(hull_scan(square, (vec3){ 0, 0, 1 }), 0);
    ck_assert_int_eq(hull_scan(square, (vec3){ 2, 0, 0 }), 1);
    ck_assert_int_eq(hull_scan(square, (vec3){ 0, 1e-9, 0 }), 2);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        a_climb_over_a_dome_ends_as_high_as_a_look_at_all,
        a_climb_may_end_on_a_plain,
        without_a_mesh_of_its_own_all_of_a_body_is_looked_at,
        of_equals_a_look_at_all_finds_the_first,
        NULL
    };
    return suite_run((suite){ .name = "climb", .tests = tests });
}
