// check.c - tests of the exercise 26/side.

#include "side.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdio.h>

static vec3 at(real x, real y)
{
    return (vec3){ x, y, 0.3 };
}

// Check keeps a note of each ck_assert: among so many questions, it is only
// called for a wrong answer.
static void expect(const char *what, vec3 a, vec3 b, vec3 c, int wanted)
{
    int got = side(a, b, c);
    if (got != wanted)
        ck_abort_msg("%s: of the line from (%a, %a) to (%a, %a), (%a, %a) is on "
                     "side %d, wanted %d", what, a.x, a.y, b.x, b.y, c.x, c.y,
                     got, wanted);
}

static int plainly(vec3 a, vec3 b, vec3 c)
{
    real s = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    return (s > 0) - (s < 0);
}

static unsigned long long seed = 3;

// Whole numbers from -2^bits to 2^bits - 1.
static long long any(int bits)
{
    return (long long)(random_bits(&seed) >> (63 - bits)) - (1LL << bits);
}

START_TEST(left_is_1_and_right_is_minus_1)
{
    // Rejects: the other side; z in the place of y.
    expect("left", at(0, 0), at(2, 1), at(1, 1), 1);
    expect("right", at(0, 0), at(2, 1), at(1, 0), -1);
    expect("in line", at(0, 0), at(2, 1), at(4, 2), 0);
    expect("behind", at(1, 1), at(2, 3), at(0, -1), 0);
    expect("from a to a", at(1, 2), at(1, 2), at(5, -7), 0);
}
END_TEST

START_TEST(one_bit_beside_the_diagonal_is_seen)
{
    // From (12, 12) to (24, 24); around (1/2, 1/2), a last bit at a time.  The
    // side is that of y - x.
    // Rejects: the plain formula, whatever its tolerance.
    int wrong = 0;
    for (int i = 0; i < 256; i++)
        for (int j = 0; j < 256; j++) {
            vec3 c = at(0.5 + i * 0x1p-53, 0.5 + j * 0x1p-53);
            int wanted = (c.y > c.x) - (c.y < c.x);
            expect("near the diagonal", at(12, 12), at(24, 24), c, wanted);
            wrong += plainly(at(12, 12), at(24, 24), c) != wanted;
        }
    printf("the plain formula errs %d times of %d\n", wrong, 256 * 256);
    ck_assert_int_gt(wrong, 5000);
}
END_TEST

START_TEST(whole_numbers_know_the_answer)
{
    // Up to 2^29, so that their products fit; c is about on the line.
    for (int k = 0; k < 100000; k++) {
        long long ax = any(28), ay = any(28), ux = any(14), uy = any(14);
        long long t = any(13), cx = ax + t * ux / 3, cy = ay + t * uy / 3;
        long long d = ux * (cy - ay) - uy * (cx - ax);
        real s = k % 2 ? 0x1p-100 : 0x1p90;
        expect("whole numbers", at(s * (real)ax, s * (real)ay),
               at(s * (real)(ax + ux), s * (real)(ay + uy)),
               at(s * (real)cx, s * (real)cy), (d > 0) - (d < 0));
    }
}
END_TEST

START_TEST(last_bits_of_all_six_products_count)
{
    // Long numbers: a + t (b - a), with t a power of 2, is exactly in line;
    // then one bit to either side.
    for (int k = 0; k < 20000; k++) {
        real ax = (real)any(50), ay = (real)any(50);
        real ux = (real)any(40) * 4, uy = (real)any(40) * 4;
        real t = k % 3 == 0 ? 0.5 : k % 3 == 1 ? 2 : -0.25;
        vec3 a = at(ax, ay), b = at(ax + ux, ay + uy);
        vec3 c = at(ax + t * ux, ay + t * uy);
        if (b.x - ax != ux || b.y - ay != uy) continue;
        expect("exactly in line", a, b, c, 0);
        c.y += 0.25;
        expect("a quarter above", a, b, c, (ux > 0) - (ux < 0));
        c.y -= 0.5;
        expect("a quarter below", a, b, c, (ux < 0) - (ux > 0));
    }
}
END_TEST

START_TEST(exchanged_points_change_the_sign)
{
    // And a turn of all three does not.
    for (int k = 0; k < 20000; k++) {
        vec3 p[3];
        for (int i = 0; i < 3; i++)
            p[i] = at(0.1 * (real)any(3), 0.1 * (real)any(k % 50 + 3));
        int s = side(p[0], p[1], p[2]);
        expect("turned", p[1], p[2], p[0], s);
        expect("turned twice", p[2], p[0], p[1], s);
        expect("exchanged", p[1], p[0], p[2], -s);
    }
}
END_TEST

START_TEST(very_large_and_very_small_in_one)
{
    // Rejects: the first number of the list in the place of the largest.
    expect("small steps far out", at(0x1p150, 0), at(0x1p150, 0x1p-150),
           at(0, 0x1p-150), 1);
    expect("small steps far out", at(0x1p150, 0), at(0x1p150, 0x1p-150),
           at(0x1.0000000000001p150, 0), -1);
}
END_TEST

START_TEST(no_number_is_on_no_side)
{
    expect("NaN", at((real)NAN, 0), at(1, 1), at(0, 1), 0);
    expect("NaN", at(0, 0), at(1, 1), at(0, (real)NAN), 0);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        left_is_1_and_right_is_minus_1,
        one_bit_beside_the_diagonal_is_seen,
        whole_numbers_know_the_answer,
        last_bits_of_all_six_products_count,
        exchanged_points_change_the_sign,
        very_large_and_very_small_in_one,
        no_number_is_on_no_side,
        NULL
    };
    return suite_run((suite){ .name = "side", .tests = tests });
}
