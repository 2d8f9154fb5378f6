// check.c - tests of the exercise 26/angle.

#include "angle.h"
#include "suite.h"

#include <check.h>

// Of the tangent itself: a few dozen roundings.
static const real ROUNDING = 1e-12;

// 3, 4 and 12 make 13; 4 and -3 are perpendicular to them, and make 5.  Times a
// prime, so that products have more digits than there is room for.
#define PRIME 1048573.0
static const vec3 A = { 3 * PRIME, 4 * PRIME, 12 * PRIME };
static const vec3 ACROSS = { 4 * PRIME, -3 * PRIME, 0 };
static const real RATIO = 5.0 / 13;

static void expect(const char *what, vec3 a, vec3 b, real wanted)
{
    real got = half_tangent(a, b), back = half_tangent(b, a);
    ck_assert_msg(fabs(got - wanted) <= ROUNDING * wanted, "%s: got the "
                  "tangent %.17g, wanted %.17g", what, got, wanted);
    ck_assert_msg(fabs(back - wanted) <= ROUNDING * wanted, "%s, exchanged: "
                  "got the tangent %.17g, wanted %.17g", what, back, wanted);
}

// tan(t/2) from tan t: tan t / (1 + sqrt(1 + tan^2 t)).
static real half(real tangent)
{
    return tangent / (1 + sqrt(1 + tangent * tangent));
}

START_TEST(right_angle_is_one)
{
    expect("x and y", (vec3){ 1, 0, 0 }, (vec3){ 0, 1, 0 }, 1);
    expect("two of 5 and 13 thousand km", A, ACROSS, 1);
}
END_TEST

START_TEST(known_angles_have_their_tangent)
{
    // Rejects: the angle's own tangent; the sine; lengths that are forgotten.
    expect("60 degrees", (vec3){ 1, 1, 0 }, (vec3){ 0, 1, 1 }, 1 / sqrt(3));
    expect("120 degrees", (vec3){ 1, 1, 0 }, (vec3){ 0, -1, -1 }, sqrt(3));
    for (int k = -20; k <= 20; k++) {
        // b = k a / 20 + across: tan t = |across| / (k |a| / 20).
        vec3 b = vec3_add_scaled(ACROSS, k / 20.0, A);
        real far = RATIO, along = k / 20.0;
        real wanted = far / (along + sqrt(along * along + far * far));
        expect("somewhere in between", A, b, wanted);
    }
}
END_TEST

START_TEST(small_angles_keep_their_digits)
{
    // b = a + 2^-m across, exactly.  tan t = 2^-m 5/13.
    // Rejects: the cosine; the cross product of what is nearly in a line.
    for (int m = 0; m <= 28; m += 2) {
        real small = ldexp(1, -m);
        expect("a small angle", A, vec3_add_scaled(A, small, ACROSS),
               half(RATIO * small));
    }
}
END_TEST

START_TEST(nearly_opposite_ones_too)
{
    // pi - t is small, and tan(t/2) = 1 / tan((pi - t)/2) large.
    for (int m = 0; m <= 28; m += 2) {
        real small = ldexp(1, -m);
        vec3 b = vec3_scale(-1, vec3_add_scaled(A, small, ACROSS));
        expect("nearly opposite", A, b, 1 / half(RATIO * small));
    }
}
END_TEST

START_TEST(lengths_do_not_matter)
{
    // Rejects: vectors divided by their length, which rounds them; one taken
    // from the other once, and not 7/3 times.
    for (int m = -200; m <= 200; m += 25) {
        vec3 b = vec3_add_scaled(A, 0x1p-26, ACROSS);
        b = vec3_scale(ldexp(1, m), b);
        expect("a small angle, lengths very different", A, b,
               half(RATIO * 0x1p-26));
    }
    for (int k = 3; k <= 7; k++) {
        vec3 b = vec3_scale(k, vec3_add_scaled(A, 0x1p-26, ACROSS));
        expect("a small angle, lengths as 3 and 3 to 7", vec3_scale(3, A), b,
               half(RATIO * 0x1p-26));
    }
}
END_TEST

START_TEST(alike_is_nothing_and_opposite_is_infinite)
{
    real got = half_tangent(A, A);
    ck_assert_msg(got == 0, "of a vector and itself: got %g", got);
    got = half_tangent(A, vec3_scale(-4, A));
    ck_assert_msg(got == HUGE_VAL, "of opposite vectors: got %g, wanted "
                  "infinity", got);
}
END_TEST

START_TEST(no_direction_is_no_angle)
{
    // Rejects: 0 / 0; a loop that makes nothing as long as something.
    const vec3 zero = { 0, 0, 0 };
    ck_assert_msg(half_tangent(zero, A) == 0, "zero and a: got %g",
                  half_tangent(zero, A));
    ck_assert_msg(half_tangent(A, zero) == 0, "a and zero: got %g",
                  half_tangent(A, zero));
    ck_assert_msg(half_tangent(zero, zero) == 0, "zero and zero: got %g",
                  half_tangent(zero, zero));
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        right_angle_is_one,
        known_angles_have_their_tangent,
        small_angles_keep_their_digits,
        nearly_opposite_ones_too,
        lengths_do_not_matter,
        alike_is_nothing_and_opposite_is_infinite,
        no_direction_is_no_angle,
        NULL
    };
    return suite_run((suite){ .name = "angle", .tests = tests });
}
