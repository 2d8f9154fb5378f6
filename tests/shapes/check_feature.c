// check_feature.c - tests of lib/shapes/feature: a point of a vertex, an edge or
// a face, by weights.

#include "feature.h"
#include "suite.h"

#include <check.h>

#define COUNT(list) ((int)(sizeof (list) / sizeof (list)[0]))

// Rejects: a second entry for the same vertex; the last weight in place of the
// sum.
START_TEST(the_same_vertex_again_gains_weight)
{
    feature_point f = { 0 };
    feature_add(&f, 7, 0.25);
    feature_add(&f, 3, 0.5);
    feature_add(&f, 7, 0.25);
    ck_assert_int_eq(f.count, 2);
    ck_assert_int_eq(f.vertex[0], 7);
    ck_assert_int_eq(f.vertex[1], 3);
    ck_assert(f.weight[0] == 0.5);
    ck_assert(f.weight[1] == 0.5);
}
END_TEST

// Rejects: a comparison of neighbours in the list only.
START_TEST(first_and_last_may_be_the_same_vertex)
{
    feature_point f = { 0 };
    feature_add(&f, 1, 0.5);
    feature_add(&f, 2, 0.25);
    feature_add(&f, 1, 0.25);
    ck_assert_int_eq(f.count, 2);
    ck_assert(f.weight[0] == 0.75);
}
END_TEST

// Rejects: a weight added to what a removed vertex left in the array.
START_TEST(a_new_vertex_has_only_its_own_weight)
{
    feature_point f = { 0, { 9, 9, 9 }, { 5, 5, 5 } };
    feature_add(&f, 4, 1);
    ck_assert_int_eq(f.count, 1);
    ck_assert_int_eq(f.vertex[0], 4);
    ck_assert(f.weight[0] == 1);
}
END_TEST

// Rejects: the mean without weights; a point measured from the first vertex.
START_TEST(a_point_is_the_weighted_mean_of_its_vertices)
{
    const vec3 at[4] = { { 9, 9, 9 }, { 1, 2, 3 }, { 5, 2, 3 }, { 1, 10, 3 } };
    const feature_point vertex = { 1, { 2 }, { 1 } };
    const feature_point edge = { 2, { 1, 2 }, { 0.75, 0.25 } };
    const feature_point face = { 3, { 3, 1, 2 }, { 0.25, 0.25, 0.5 } };
    vec3 p = feature_at(&vertex, at);
    ck_assert(p.x == 5 && p.y == 2 && p.z == 3);
    p = feature_at(&edge, at);
    ck_assert(p.x == 2 && p.y == 2 && p.z == 3);
    p = feature_at(&face, at);
    ck_assert(p.x == 3 && p.y == 4 && p.z == 3);
}
END_TEST

// A weight of a tenth is not a sum of powers of two: 1e15 + 0.1 e is rounded to
// an eighth of a metre.  Rejects: weights times places far away.
START_TEST(far_from_the_origin_equal_vertices_give_their_place)
{
    const real far = 1e15 + 0.375;
    const vec3 at[3] = { { far, far, far }, { far, far, far },
                         { far, far, far } };
    const feature_point f = { 3, { 0, 1, 2 }, { 0.1, 0.2, 0.7 } };
    vec3 p = feature_at(&f, at);
    ck_assert(p.x == far && p.y == far && p.z == far);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        the_same_vertex_again_gains_weight,
        first_and_last_may_be_the_same_vertex,
        a_new_vertex_has_only_its_own_weight,
        a_point_is_the_weighted_mean_of_its_vertices,
        far_from_the_origin_equal_vertices_give_their_place,
        NULL
    };
    return suite_run((suite){ .name = "feature", .tests = tests });
}
