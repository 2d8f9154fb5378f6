// check_oracle.c - who checks the slow oracle?  Answers that can be had by
// hand, and those that were found elsewhere in exact integers.

#include "bodies.h"
#include "expect.h"
#include "oracle.h"
#include "suite.h"

#include <check.h>
#include <stdio.h>

#ifndef PAIRS
#define PAIRS "tests/data/pairs.txt"
#endif

// A dozen roundings of a coordinate of 4, where long double is only double.
static const real rounding = 5e-15;
// Beyond so many pairs of points an answer takes more than some milliseconds.
static const int patience = 200;

static real distance(const body *a, const body *b)
{
    return (real)oracle_distance(body_hull(a), body_hull(b));
}

static real depth(const body *a, const body *b)
{
    return (real)oracle_depth(body_hull(a), body_hull(b));
}

START_TEST(cubes_apart_by_face_edge_and_vertex)
{
    body a = body_cube(0, 0, 0), f = body_cube(2, 0.25, 0.125),
         e = body_cube(2, 2, 0.25);
    body v = body_cube(2, -2, 2);
    near(distance(&a, &f), 1, rounding);
    near(distance(&a, &e), sqrt(2.0), rounding);
    near(distance(&a, &v), sqrt(3.0), rounding);
}
END_TEST

// Rejects: segments without their ends, points that are no segments.
START_TEST(points_and_segments_have_distances)
{
    body p = { .count = 1, .at = { { 1, 2, 3 } } };
    body q = { .count = 1, .at = { { 4, 6, 3 } } };
    body s = { .count = 2, .at = { { 0, 0, 3 }, { 2, 0, 3 } } };
    body t = { .count = 2, .at = { { 0.5, -1, 3.25 }, { 0.5, 1, 3.25 } } };
    near(distance(&p, &q), 5, rounding);
    near(distance(&p, &s), 2, rounding);
    near(distance(&s, &t), 0.25, rounding);
}
END_TEST

// The vertex of one over the middle of a face of the other.
START_TEST(a_vertex_over_a_face)
{
    body c = body_cube(0, 0, 0), p = { .count = 1, .at = { { 0.3, 0.2, 2 } } };
    near(distance(&c, &p), 1.5, rounding);
    near(distance(&p, &c), 1.5, rounding);      // rejects: A's faces only
}
END_TEST

// Two bars, ridge on ridge, one across the other, and none of their sides
// level: only the crossing of the ridges tells the depth.  Rejects: no
// crossings.
START_TEST(edges_that_cross_have_a_depth)
{
    body a = { .count = 6 }, b = { .count = 6 };
    for (int i = 0; i < 6; i++) {
        static const real y[3] = { 1, -1, 0 }, z[3] = { -1, -2, 0 };
        real along = i < 3 ? -4 : 4;
        a.at[i] = (vec3){ along, y[i % 3], z[i % 3] };
        b.at[i] = (vec3){ y[i % 3], along, -0.125 - z[i % 3] };
    }
    near(depth(&a, &b), 0.125, rounding);
}
END_TEST

START_TEST(depth_is_the_shortest_way_out)
{
    body a = body_cube(0, 0, 0), b = body_cube(0.75, 0.125, -0.25);
    near(depth(&a, &b), 0.25, rounding);
    near(depth(&a, &a), 1, rounding);
    near((real)oracle_width(body_hull(&a), body_hull(&b),
                            (vec3){ 0, 5, 0 }), 0.875, rounding);
    // Apart: minus a bound that the distance keeps to.
    body c = body_cube(2, 0.25, 0.125);
    near(depth(&a, &c), -1, rounding);
}
END_TEST

START_TEST(without_a_volume_there_is_no_depth)
{
    body s, t;
    body_square(&s);
    t = s;
    body_move(&t, (vec3){ 0.5, 0.25, 0 });
    near(depth(&s, &t), 0, 0);
    body p = { .count = 1, .at = { { 1, 2, 3 } } };
    ck_assert(depth(&p, &p) > 1e300);
}
END_TEST

static real size_of(const pair_known *p)
{
    real size = 0;
    for (int i = 0; i < p->a.count; i++)
        size = fmax(size, vec3_distance(p->a.at[0], p->a.at[i]));
    for (int i = 0; i < p->b.count; i++)
        size = fmax(size, vec3_distance(p->b.at[0], p->b.at[i]));
    return size;
}

// To 1e-6, or to 1e-14 of the size: the criterion of the set that they are of.
START_TEST(stored_pairs_have_their_exact_answers)
{
    FILE *file = fopen(PAIRS, "r");
    ck_assert_msg(file != NULL, "cannot open %s", PAIRS);
    static pair_known p;
    int read, apart = 0, deep = 0;
    while ((read = pair_read(file, &p)) == 1) {
        if (p.a.count * p.b.count > patience) continue;
        real size = size_of(&p), got = 0;
        if (p.kind == 'S') got = distance(&p.a, &p.b);
        // Flat on flat, 0, has none.
        else if ((got = depth(&p.a, &p.b)) > 1e300) got = 0;
        real error = fabs(got - p.value);
        ck_assert_msg(error <= 1e-6 * p.value || error <= 1e-14 * size,
                      "%s: got %.17g, wanted %.17g", p.family, got, p.value);
        apart += p.kind == 'S';
        deep += p.kind == 'P';
    }
    fclose(file);
    ck_assert_int_eq(read, 0);
    ck_assert_int_ge(apart, 30);
    ck_assert_int_ge(deep, 30);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        cubes_apart_by_face_edge_and_vertex,
        points_and_segments_have_distances,
        a_vertex_over_a_face,
        edges_that_cross_have_a_depth,
        depth_is_the_shortest_way_out,
        without_a_volume_there_is_no_depth,
        stored_pairs_have_their_exact_answers,
        NULL
    };
    return suite_run((suite){
        .name = "oracle", .tests = tests, .seconds = 60
    });
}
