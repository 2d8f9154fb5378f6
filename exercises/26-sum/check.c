// check.c - tests of the exercise 26/sum.

#include "sum.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>

static unsigned long long seed = 5;

// Whole numbers from 0 to 2^bits - 1.
static long long any(int bits)
{
    return (long long)(random_bits(&seed) >> (64 - bits));
}

static void expect_two(real a, real b, real sum, real error)
{
    real e = 7, s = two_sum(a, b, &e);
    ck_assert_msg(s == sum, "%a + %a: got the sum %a, wanted %a", a, b, s, sum);
    ck_assert_msg(e == error, "%a + %a is %a; got the error %a, wanted %a", a,
                  b, s, e, error);
}

START_TEST(error_of_a_sum_is_a_number)
{
    // Rejects: the short form, which is right only if a is the larger one; the
    // sign; what was written back into s.
    expect_two(1, 0x1p-60, 1, 0x1p-60);
    expect_two(0x1p-60, 1, 1, 0x1p-60);
    expect_two(0x1p53, 1, 0x1p53, 1);
    expect_two(1, -0x1p-60, 1, -0x1p-60);
    expect_two(-0x1p-60, 1, 1, -0x1p-60);
    expect_two(3, 4, 7, 0);
    expect_two(0, 5, 5, 0);
    expect_two(0.5, -0.5, 0, 0);
}
END_TEST

START_TEST(sum_and_error_are_the_whole_truth)
{
    // Multiples of 2^-20 that fit in 62 bits: whole numbers know the answer.
    for (int k = 0; k < 20000; k++) {
        long long a = any(20 + k % 33) - any(20), b = any(20 + k / 33 % 33);
        a *= 1LL << k % 9;
        if (k % 2) b = -b;
        real e = 0, s = two_sum((real)a * 0x1p-20, (real)b * 0x1p-20, &e);
        long long left = a + b - (long long)(s * 0x1p20);
        int sound = s == (real)a * 0x1p-20 + (real)b * 0x1p-20;
        if (!sound || (real)left != e * 0x1p20)
            ck_abort_msg("%lld + %lld: the sum is wrong by %lld, got %.17g", a,
                         b, left, e * 0x1p20);
    }
}
END_TEST

START_TEST(equal_numbers_double_without_error)
{
    // 2^20 of them: each sum is twice a number.
    // Rejects: adding one by one, in whatever disguise.
    enum { N = 1 << 20 };
    real *x = malloc(N * sizeof *x);
    ck_assert_ptr_nonnull(x);
    for (int i = 0; i < N; i++) x[i] = 0.1;
    real got = sum_pairs(x, N);
    ck_assert_msg(got == 0x1p20 * 0.1, "got %.17g, wanted %.17g", got,
                  0x1p20 * 0.1);
    free(x);
}
END_TEST

START_TEST(every_number_is_in_it_once)
{
    // Whole numbers: every order is right.
    // Rejects: one left out when n is odd; one past the end.
    for (int n = 0; n < 40; n++) {
        real *x = malloc((size_t)(n > 0 ? n : 1) * sizeof *x);
        ck_assert_ptr_nonnull(x);
        for (int i = 0; i < n; i++) x[i] = i + 1;
        real pairs = sum_pairs(x, n), careful = sum_careful(x, n);
        ck_assert_msg(pairs == n * (n + 1) / 2, "1 + ... + %d: in pairs %g", n,
                      pairs);
        ck_assert_msg(careful == n * (n + 1) / 2, "1 + ... + %d: careful %g", n,
                      careful);
        free(x);
    }
}
END_TEST

START_TEST(million_tenths_are_a_hundred_thousand)
{
    // The double nearest 0.1 is 5.55e-18 more than that; a million times.  It
    // is less than half of the spacing there, 1.5e-11.
    // Rejects: errors that are found and not put back.
    enum { N = 1000000 };
    real *x = malloc(N * sizeof *x), plain = 0;
    ck_assert_ptr_nonnull(x);
    for (int i = 0; i < N; i++) plain += x[i] = 0.1;
    real careful = sum_careful(x, N);
    ck_assert_msg(fabs(plain - 1e5) > 1e-6, "the plain sum is good: how?");
    ck_assert_msg(careful == 1e5, "got %.17g, wanted 100000; the plain sum is "
                  "%.17g", careful, plain);
    free(x);
}
END_TEST

START_TEST(small_ones_survive_large_ones)
{
    // Rejects: Kahan's sum of 1965, which gives up what a number larger than
    // the sum so far takes away.
    const real x[4] = { 1, 1e100, 1, -1e100 };
    real got = sum_careful(x, 4);
    ck_assert_msg(got == 2, "1 + 1e100 + 1 - 1e100: got %g, wanted 2", got);
    // In every order: 2^60, 1, 2^-60 and their opposites, but for one of them.
    real y[6] = { 0x1p60, 1, 0x1p-50, -0x1p60, -1, 3 };
    for (int k = 0; k < 6; k++) {
        real first = y[0];
        for (int i = 0; i < 5; i++) y[i] = y[i + 1];
        y[5] = first;
        got = sum_careful(y, 6);
        ck_assert_msg(got == 3 + 0x1p-50, "turned by %d: got %.17g, wanted "
                      "3 + 2^-50", k + 1, got);
    }
}
END_TEST

START_TEST(too_much_is_infinite)
{
    // Rejects: infinity less infinity.
    const real x[3] = { 1e308, 1e308, 1 }, y[2] = { (real)NAN, 1 };
    real got = sum_careful(x, 3);
    ck_assert_msg(got == HUGE_VAL, "1e308 + 1e308 + 1: got %g, wanted infinity",
                  got);
    got = sum_careful(y, 2);
    ck_assert_msg(got != got, "NaN + 1: got %g, wanted NaN", got);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        error_of_a_sum_is_a_number,
        sum_and_error_are_the_whole_truth,
        equal_numbers_double_without_error,
        every_number_is_in_it_once,
        million_tenths_are_a_hundred_thousand,
        small_ones_survive_large_ones,
        too_much_is_infinite,
        NULL
    };
    return suite_run((suite){ .name = "sum", .tests = tests });
}
