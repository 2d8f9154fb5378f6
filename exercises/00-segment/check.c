// check.c - tests of the exercise 00/segment.

#include "segment.h"
#include "random.h"
#include "suite.h"

#include <check.h>

// Some dozen roundings of numbers up to 10.
static const real ROUNDING = 1e-13;

static void expect(const char *what, vec3 got, vec3 wanted, real error)
{
    ck_assert_msg(vec3_distance(got, wanted) <= error,
                  "%s: got (%.15g, %.15g, %.15g), wanted (%.15g, %.15g, %.15g)",
                  what, got.x, got.y, got.z, wanted.x, wanted.y, wanted.z);
}

static unsigned long long seed = 1;

START_TEST(beside_a_segment_the_projection_counts)
{
    // Rejects: a t that is not divided by d . d; a projection counted
    // from the origin.
    expect("beside (1,1,0)-(5,1,0), the point nearest to (2,4,0)",
           segment_nearest(vec3_make(1, 1, 0), vec3_make(5, 1, 0),
                           vec3_make(2, 4, 0)), vec3_make(2, 1, 0), ROUNDING);
    for (int i = 0; i < 200; i++) {
        vec3 a = random_vec3(&seed, 1), d = random_vec3(&seed, 1),
             c = random_vec3(&seed, 1);
        real t = random_fraction(&seed);
        vec3 nearest = vec3_add_scaled(a, t, d);
        vec3 p = vec3_add(nearest, vec3_cross(c, d));
        expect("a random segment, and a point straight above its inside",
               segment_nearest(a, vec3_add(a, d), p), nearest,
               ROUNDING);
    }
}
END_TEST

START_TEST(beyond_its_ends_a_segment_has_no_more_points)
{
    // Rejects: the endless line.
    vec3 a = { 1, 2, 3 }, b = { 3, 2, 3 };
    expect("before a", segment_nearest(a, b, vec3_make(-7, 5, 3)), a, 0);
    expect("behind b", segment_nearest(a, b, vec3_make(9, 5, 3)), b, 0);
    expect("at b itself", segment_nearest(a, b, b), b, 0);
}
END_TEST

START_TEST(segment_without_length_is_a_point)
{
    // Rejects: 0 / 0.
    vec3 a = { 1, 2, 3 };
    expect("from a to a", segment_nearest(a, a, vec3_make(4, 4, 4)), a, 0);
}
END_TEST

START_TEST(size_does_not_matter)
{
    // Rejects: a segment that is taken for a point because it is short.
    for (real size = 1e-12; size < 1e13; size *= 1e3) {
        vec3 got = segment_nearest(vec3_make(0, 0, 0), vec3_make(4 * size, 0, 0),
                                   vec3_make(size, 7 * size, 0));
        expect("size times (1,0,0)", vec3_scale(1 / size, got),
               vec3_make(1, 0, 0), ROUNDING);
    }
}
END_TEST

START_TEST(height_is_counted_along_the_normal)
{
    // Rejects: a normal that must have length 1; a height without its sign; a
    // plane that goes through the origin.
    vec3 at = { 1, 1, 1 };
    for (real length = 0.25; length < 100; length *= 8) {
        vec3 up = vec3_scale(length / 5, vec3_make(0, 3, 4));
        real above = plane_height(at, up, vec3_make(7, 4, 5));
        real below = plane_height(at, up, vec3_make(7, -2, -3));
        ck_assert_msg(fabs(above - 5) <= ROUNDING,
                      "above the plane: got %.15g, wanted 5", above);
        ck_assert_msg(fabs(below + 5) <= ROUNDING,
                      "below the plane: got %.15g, wanted -5", below);
    }
}
END_TEST

START_TEST(mirror_image_is_as_far_behind)
{
    // Rejects: the projection, not the image; a normal that must have
    // length 1.
    for (int i = 0; i < 200; i++) {
        vec3 at = random_vec3(&seed, 1), up = random_vec3(&seed, 3);
        vec3 p = random_vec3(&seed, 1), q = plane_mirror(at, up, p);
        vec3 middle = vec3_scale(0.5, vec3_add(p, q));
        real off = vec3_dot(vec3_sub(middle, at), vec3_unit(up));
        ck_assert_msg(fabs(off) <= ROUNDING,
                      "the middle between a point and its image is %g m off "
                      "the plane", off);
        expect("the way to the image, across the normal",
               vec3_cross(vec3_sub(q, p), vec3_unit(up)), vec3_make(0, 0, 0),
               ROUNDING);
        expect("the image of the image", plane_mirror(at, up, q), p, ROUNDING);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        beside_a_segment_the_projection_counts,
        beyond_its_ends_a_segment_has_no_more_points,
        segment_without_length_is_a_point,
        size_does_not_matter,
        height_is_counted_along_the_normal,
        mirror_image_is_as_far_behind,
        NULL
    };
    return suite_run((suite){ .name = "segment", .tests = tests });
}
