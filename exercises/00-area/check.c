// check.c - tests of the exercise 00/area.

#include "area.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>
#include <string.h>

// Some dozen roundings of numbers up to 10.
static const real ROUNDING = 1e-14;

// Calls with memory that ends behind the last corner.
static vec3 area_of(const vec3 *at, int n)
{
    vec3 *own = malloc((size_t)(n > 0 ? n : 1) * sizeof *own);
    ck_assert_ptr_nonnull(own);
    if (n > 0) memcpy(own, at, (size_t)n * sizeof *own);
    vec3 area = polygon_area(own, n);
    free(own);
    return area;
}

static vec3 center_of(const vec3 *at, int n)
{
    vec3 *own = malloc((size_t)(n > 0 ? n : 1) * sizeof *own);
    ck_assert_ptr_nonnull(own);
    if (n > 0) memcpy(own, at, (size_t)n * sizeof *own);
    vec3 center = polygon_center(own, n);
    free(own);
    return center;
}

static void expect(const char *what, vec3 got, vec3 wanted, real error)
{
    ck_assert_msg(vec3_distance(got, wanted) <= error,
                  "%s: got (%.15g, %.15g, %.15g), wanted (%.15g, %.15g, %.15g)",
                  what, got.x, got.y, got.z, wanted.x, wanted.y, wanted.z);
}

// Three unit squares: area 3, and by Archimedes' levers the middle is at
// ((2 . 1 + 1 . 1/2) / 3, the same).
static const vec3 ELL[6] = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 },
                             { 1, 2, 0 }, { 0, 2, 0 } };

START_TEST(square_has_its_area_and_its_side)
{
    // Rejects: the parallelogram instead of the triangle; the wrong side.
    const vec3 floor[4] = { { 0, 0, 0 }, { 0, 0, 2 }, { 2, 0, 2 },
                            { 2, 0, 0 } };
    expect("a square of 2 m, seen from above, area", area_of(floor, 4),
           (vec3){ 0, 4, 0 }, ROUNDING);
    expect("its middle", center_of(floor, 4), (vec3){ 1, 0, 1 }, ROUNDING);
}
END_TEST

START_TEST(triangle_of_3_and_4_has_6)
{
    const vec3 t[3] = { { 1, 1, 1 }, { 4, 1, 1 }, { 1, 1, 5 } };
    expect("area", area_of(t, 3), (vec3){ 0, -6, 0 }, ROUNDING);
    expect("middle", center_of(t, 3), (vec3){ 2, 1, 7.0 / 3 }, ROUNDING);
}
END_TEST

START_TEST(dent_counts_against)
{
    // From each corner on, and the other way round.
    // Rejects: areas that are added up without their sign; the mean of the
    // corners for a middle; a triangle left out.
    for (int from = 0; from < 6; from++) {
        vec3 there[6], back[6];
        for (int k = 0; k < 6; k++) {
            there[k] = ELL[(from + k) % 6];
            back[k] = ELL[(from + 6 - k) % 6];
        }
        expect("an L of three squares, area", area_of(there, 6),
               (vec3){ 0, 0, 3 }, ROUNDING);
        expect("the other way round", area_of(back, 6), (vec3){ 0, 0, -3 },
               ROUNDING);
        expect("its middle", center_of(there, 6),
               (vec3){ 5.0 / 6, 5.0 / 6, 0 }, ROUNDING);
        expect("the other way round, its middle", center_of(back, 6),
               (vec3){ 5.0 / 6, 5.0 / 6, 0 }, ROUNDING);
    }
}
END_TEST

START_TEST(corner_in_a_line_changes_nothing)
{
    // From each corner on.  Rejects: the side of the whole taken from the first
    // triangle, which is flat here; then the mean of the corners, (1, 0.8).
    const vec3 square[5] = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 },
                             { 0, 2, 0 } };
    for (int from = 0; from < 5; from++) {
        vec3 there[5];
        for (int k = 0; k < 5; k++) there[k] = square[(from + k) % 5];
        expect("a square of 2 m with a fifth corner in a side, area",
               area_of(there, 5), (vec3){ 0, 0, 4 }, ROUNDING);
        expect("its middle", center_of(there, 5), (vec3){ 1, 1, 0 },
               ROUNDING);
    }
}
END_TEST

START_TEST(nothing_is_lost_far_away)
{
    // Places that a double knows exactly, so differences are exact, too.
    // Rejects: cross products of the corners themselves.
    vec3 far = { 0x1.00000021p23, -0x1.00000013p23, 0x1.0000007p22 }, at[6];
    for (int k = 0; k < 6; k++)
        at[k] = vec3_add(far, (vec3){ ELL[k].x, ELL[k].y, ELL[k].x });
    expect("a leaning L, 12,000 km away, area", area_of(at, 6),
           (vec3){ -3, 0, 3 }, ROUNDING);
    // The place itself is rounded to 2^-29 m.
    expect("its middle", center_of(at, 6),
           vec3_add(far, (vec3){ 5.0 / 6, 5.0 / 6, 5.0 / 6 }), 0x1p-28);
}
END_TEST

START_TEST(closed_body_has_no_area_in_all)
{
    // A tetrahedron: what blows from everywhere does not move it.
    const vec3 at[4] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, 2, 0 }, { 0, 1, 3 } };
    const int face[4][3] = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 },
                             { 0, 3, 2 } };
    vec3 sum = { 0, 0, 0 };
    for (int f = 0; f < 4; f++) {
        vec3 t[3] = { at[face[f][0]], at[face[f][1]], at[face[f][2]] };
        vec3 area = area_of(t, 3);
        ck_assert_msg(vec3_length(area) > 0.4, "face %d has an area of %g", f,
                      vec3_length(area));
        sum = vec3_add(sum, area);
    }
    expect("the four faces together", sum, (vec3){ 0, 0, 0 }, ROUNDING);
}
END_TEST

START_TEST(bent_quadrilateral_has_half_the_product_of_its_diagonals)
{
    const vec3 q[4] = { { 0, 0, 0 }, { 2, 0, 1 }, { 3, 3, 0 }, { 0, 1, 2 } };
    vec3 wanted = vec3_scale(0.5, vec3_cross(vec3_sub(q[2], q[0]),
                                             vec3_sub(q[3], q[1])));
    expect("area", area_of(q, 4), wanted, ROUNDING);
}
END_TEST

START_TEST(corner_that_comes_twice_adds_nothing)
{
    vec3 at[8];
    memcpy(at, ELL, sizeof ELL);
    at[6] = at[7] = ELL[0];
    expect("an L that ends where it begins, area", area_of(at, 8),
           (vec3){ 0, 0, 3 }, ROUNDING);
    expect("its middle", center_of(at, 8), (vec3){ 5.0 / 6, 5.0 / 6, 0 },
           ROUNDING);
}
END_TEST

START_TEST(what_has_no_area_has_the_mean_of_its_corners)
{
    // Rejects: 0 / 0.
    const vec3 line[3] = { { 0, 0, 0 }, { 1, 2, 3 }, { 2, 4, 6 } };
    const vec3 zero = { 0, 0, 0 };
    expect("three in a line, area", area_of(line, 3), zero, ROUNDING);
    expect("three in a line, middle", center_of(line, 3), line[1], ROUNDING);
    expect("two, area", area_of(line + 1, 2), zero, 0);
    expect("two, middle", center_of(line + 1, 2), (vec3){ 1.5, 3, 4.5 },
           ROUNDING);
    expect("one, area", area_of(line + 2, 1), zero, 0);
    expect("one, middle", center_of(line + 2, 1), line[2], ROUNDING);
}
END_TEST

START_TEST(no_corner_is_no_trouble)
{
    // Rejects: a look at a corner that is not there.
    const vec3 zero = { 0, 0, 0 };
    expect("none, area", area_of(NULL, 0), zero, 0);
    expect("none, middle", center_of(NULL, 0), zero, 0);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        square_has_its_area_and_its_side,
        triangle_of_3_and_4_has_6,
        dent_counts_against,
        corner_in_a_line_changes_nothing,
        nothing_is_lost_far_away,
        closed_body_has_no_area_in_all,
        bent_quadrilateral_has_half_the_product_of_its_diagonals,
        corner_that_comes_twice_adds_nothing,
        what_has_no_area_has_the_mean_of_its_corners,
        no_corner_is_no_trouble,
        NULL
    };
    return suite_run((suite){ .name = "area", .tests = tests });
}
