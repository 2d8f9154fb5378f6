// check_nearest.c - tests of lib/nearest: a simplex, its point nearest the
// origin, and the weights of a point.

#include "bodies.h"
#include "nearest.h"

#include <check.h>

// A dozen roundings of coordinates up to 4, 4.4e-16 each at most.
static const real rounding = 5e-15;

static void near(real got, real wanted, real tolerance)
{
    ck_assert_msg(fabs(got - wanted) <= tolerance, "got %.17g, wanted %.17g",
                  got, wanted);
}

static void near_vec3(vec3 got, vec3 wanted, real tolerance)
{
    near(got.x, wanted.x, tolerance);
    near(got.y, wanted.y, tolerance);
    near(got.z, wanted.z, tolerance);
}

// That no corner lies nearer along v: v . p >= v . v.
static void is_nearest(vec3 v, const vec3 *p, int count)
{
    for (int c = 0; c < count; c++)
        ck_assert(vec3_dot(v, p[c]) >= vec3_length_squared(v) - rounding);
}

// The nearest point of these corners; that it is nearest, and that the weights
// make it.
static vec3 nearest(const vec3 *p, int count)
{
    real w[4], sum = 0;
    int bear = 0;
    vec3 v = nearest_of_simplex(p, count, w), made = { 0, 0, 0 };
    is_nearest(v, p, count);
    for (int c = count; c < 4; c++) ck_assert(w[c] == 0);
    for (int c = 0; c < count; c++) {
        ck_assert(w[c] >= 0);
        bear += w[c] > 0;
        made = vec3_add_scaled(made, w[c], p[c]);
        sum += w[c];
    }
    near_vec3(vec3_scale(1 / sum, made), v, 1e3 * rounding);
    if (bear != 3) near(sum, 1, 1e-15);
    return v;
}

// ---- answers that can be had by hand

START_TEST(segment_has_a_foot_or_an_end)
{
    const vec3 p[] = { { 1, -1, 0 }, { 1, 3, 0 }, { 2, 5, 0 } };
    near_vec3(nearest(p, 2), (vec3){ 1, 0, 0 }, 0);
    near_vec3(nearest(p + 1, 2), p[1], 0);
    near_vec3(nearest(p, 1), p[0], 0);
    real wp, wq;
    near_vec3(nearest_of_segment(p[0], p[1], &wp, &wq), (vec3){ 1, 0, 0 }, 0);
    near(wp, 0.75, 0);
    near(wq, 0.25, 0);
    near_vec3(nearest_of_segment(p[1], p[1], &wp, &wq), p[1], 0);
    near(wp + wq, 1, 0);
}
END_TEST

// Rejects: a foot beyond an edge that is taken for the answer.
START_TEST(triangle_has_a_face_three_edges_and_three_corners)
{
    const vec3 p[3] = { { -1, -1, 0 }, { 2, -1, 0 }, { -1, 2, 0 } };
    const vec3 seen[7][2] = {
        { { 0, 0, 3 }, { 0, 0, 3 } },           // move by, and the answer
        { { 0, 2, 1 }, { 0, 1, 1 } }, { { 2, 0, 1 }, { 1, 0, 1 } },
        { { -1, -1, 1 }, { -0.5, -0.5, 1 } },
        { { 3, 4, 1 }, { 2, 3, 1 } }, { { -5, 0, 1 }, { -3, -1, 1 } },
        { { 0, -5, 1 }, { -1, -3, 1 } } };
    for (int n = 0; n < 7; n++)
        for (int turn = 0; turn < 3; turn++) {
            vec3 q[3];
            for (int c = 0; c < 3; c++)
                q[c] = vec3_add(p[(c + turn) % 3], seen[n][0]);
            near_vec3(nearest(q, 3), seen[n][1], rounding);
        }
}
END_TEST

// Rejects: volumes of a flat one, all positive by rounding, that are believed.
START_TEST(tetrahedron_holds_the_origin_unless_it_is_flat)
{
    const vec3 round[4] = { { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 },
                            { -1, -1, 1 } };
    near_vec3(nearest(round, 4), (vec3){ 0, 0, 0 }, 0);
    unsigned long long seed = 53;
    for (int n = 0; n < 1000; n++) {
        // A parallelogram across a direction, and up to that the origin.
        vec3 u = random_direction(&seed), up = random_direction(&seed);
        vec3 across = vec3_cross(up, u), along = vec3_cross(across, up);
        const real height[] = { 1, 0x1p-20, 0x1p-60 };
        vec3 foot = vec3_scale(height[n % 3], up);
        const vec3 p[4] = { vec3_add(foot, across), vec3_add(foot, along),
                            vec3_sub(foot, across), vec3_sub(foot, along) };
        real w[4];
        near_vec3(nearest(p, 4), foot, 8 * rounding);
        nearest_of_simplex(p, 4, w);
        ck_assert(w[0] == 0 || w[1] == 0 || w[2] == 0 || w[3] == 0);
    }
}
END_TEST

// ---- all simplices

// Near the origin and round it, so that every corner, edge and face has its
// turn.  Rejects: any feature that is never asked.
START_TEST(no_corner_lies_nearer_along_the_nearest_point)
{
    unsigned long long seed = 59;
    int held = 0;
    for (int n = 0; n < 40000; n++) {
        vec3 p[4], off = random_vector(&seed, 0, 1);
        for (int c = 0; c < 4; c++)
            p[c] = vec3_add(off, random_vector(&seed, 0.2, 1));
        vec3 v = nearest(p, 1 + n % 4);
        held += n % 4 == 3 && vec3_length(v) == 0;
    }
    ck_assert_int_gt(held, 300);
}
END_TEST

// The origin over the middle of a triangle 2^19 times as long as it is high; of
// the thinnest the areas are rounding.  Rejects: the normal of a thin one as
// products that cancel have it.
START_TEST(thin_triangle_is_as_near_as_another)
{
    unsigned long long seed = 61;
    for (int n = 0; n < 20000; n++) {
        vec3 e = random_direction(&seed), f = random_direction(&seed);
        vec3 across = vec3_scale(ldexp(1, -(n % 20)), f), up = vec3_cross(e, f);
        vec3 middle = vec3_add_scaled(vec3_scale(0.5, e), 1.0 / 3, across);
        vec3 p[3] = { vec3_sub(up, middle) };
        p[1] = vec3_add(p[0], e);
        p[2] = vec3_add_scaled(vec3_add(p[0], across), 0.5, e);
        real w[4];
        is_nearest(nearest_of_simplex(p, 3, w), p, 3);
    }
}
END_TEST

// ---- weights

// The point that these weights make of the corners is x, or as near to it as
// the triangle's longest side has it, and they are weights.
static void check_weights(const vec3 p[3], vec3 x, real tolerance)
{
    real w[3];
    triangle_weights(p[0], p[1], p[2], x, w);
    ck_assert(w[0] >= 0 && w[1] >= 0 && w[2] >= 0);
    near(w[0] + w[1] + w[2], 1, 1e-15);
    vec3 made = vec3_add_scaled(vec3_scale(w[0], p[0]), w[1], p[1]);
    near(vec3_distance(vec3_add_scaled(made, w[2], p[2]), x), 0, tolerance);
}

// Triangles of every thinness down to none.  Rejects: a plane that rounding
// made, and weights cut off at 0 that were both wrong and large.
START_TEST(weights_make_the_point_however_thin_the_triangle)
{
    unsigned long long seed = 71;
    // Just not thin enough for its side, a triangle loses 2^10 roundings, of
    // coordinates up to 5.
    for (int n = 0; n < 6000; n++) {
        vec3 u = random_direction(&seed), side = random_direction(&seed);
        real thin = n % 60 < 50 ? ldexp(1, -(n % 60)) : 0;
        vec3 p[3], far = random_vector(&seed, 0, 4);
        int first = n / 60 % 3;
        p[first] = far;                                     // a needle ...
        p[(first + 1) % 3] = vec3_add_scaled(far, thin, side);
        p[(first + 2) % 3] = vec3_add(far, u);
        if (n / 180 % 2)                                    // or a sliver
            p[(first + 1) % 3] = vec3_add_scaled(
                vec3_add_scaled(far, 0.4, u), thin, side);
        real v = random_unit(&seed), w = random_unit(&seed);
        if (v + w > 1) { v = 1 - v; w = 1 - w; }
        if (n % 7 == 0) w = 0;                              // on a side
        vec3 x = vec3_add_scaled(p[0], v, vec3_sub(p[1], p[0]));
        x = vec3_add_scaled(x, w, vec3_sub(p[2], p[0]));
        check_weights(p, x, 0x1p12 * rounding);
    }
    // One point, three times; and edges whose fourth powers are 0.
    vec3 p[3] = { { 1, 2, 3 }, { 1, 2, 3 }, { 1, 2, 3 } };
    check_weights(p, p[0], 0);
    for (real size = 1e-70; size > 1e-110; size /= 10) {
        vec3 tiny[3] = { { 0, 0, 0 }, { size, 0, 0 }, { 0, 2 * size, 0 } };
        check_weights(tiny, (vec3){ 0, size, 0 }, size);
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("nearest");
    TCase *t = tcase_create("nearest");
    tcase_set_timeout(t, 60);
    tcase_add_test(t, segment_has_a_foot_or_an_end);
    tcase_add_test(t, triangle_has_a_face_three_edges_and_three_corners);
    tcase_add_test(t, tetrahedron_holds_the_origin_unless_it_is_flat);
    tcase_add_test(t, no_corner_lies_nearer_along_the_nearest_point);
    tcase_add_test(t, thin_triangle_is_as_near_as_another);
    tcase_add_test(t, weights_make_the_point_however_thin_the_triangle);
    suite_add_tcase(suite, t);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
