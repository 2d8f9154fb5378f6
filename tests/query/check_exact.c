// check_exact.c - tests of lib/exact, against whole numbers.

#include "bodies.h"
#include "exact.h"

#include <check.h>
#include <stdint.h>

// A whole number of up to so many bits, of either sign.
static int64_t whole(int bits, unsigned long long *seed)
{
    int64_t n = (int64_t)(random_unit(seed) * ldexp(1, bits));
    return random_unit(seed) < 0.5 ? n : -n;
}

// A double, whole, as a number modulo 2^64.
static uint64_t modulo(real whole_number)
{
    real rest = fmod(whole_number, 0x1p64);
    return rest < 0 ? 0 - (uint64_t)-rest : (uint64_t)rest;
}

// What was dropped is less than what high can tell.
static void is_tight(rounded r)
{
    ck_assert_msg(r.high + r.low == r.high, "got %a and %a", r.high, r.low);
}

// Rejects: low for numbers of which the first is the larger, only.
START_TEST(sum_and_what_it_dropped_are_exact)
{
    unsigned long long seed = 3;
    rounded r = exact_sum(0x1p-60, 1);
    ck_assert(r.high == 1 && r.low == 0x1p-60);
    for (int n = 0; n < 20000; n++) {
        int64_t a = whole(52, &seed) * (n % 2 ? 1024 : 1);
        int64_t b = whole(52, &seed) * (n % 2 ? 1 : 1024);
        r = exact_sum((real)a, (real)b);
        is_tight(r);
        ck_assert(modulo(r.high) + modulo(r.low) == (uint64_t)(a + b));
    }
}
END_TEST

// Rejects: halves of which one has a bit too many.
START_TEST(product_and_what_it_dropped_are_exact)
{
    unsigned long long seed = 5;
    for (int n = 0; n < 20000; n++) {
        int64_t a = whole(53, &seed), b = whole(53, &seed);
        rounded r = exact_product((real)a, (real)b);
        is_tight(r);
        ck_assert(modulo(r.high) + modulo(r.low)
                  == (uint64_t)a * (uint64_t)b);
    }
}
END_TEST

// Products of 60 bits that agree in half of them.  Rejects: a b - c d as it
// stands, which has lost them.
START_TEST(minor_of_products_that_cancel_is_exact)
{
    unsigned long long seed = 7;
    for (int n = 0; n < 20000; n++) {
        int64_t a = whole(30, &seed), b = whole(30, &seed);
        int64_t c = a + whole(n % 30, &seed), d = b + whole(n % 30, &seed);
        rounded r = exact_minor((real)a, (real)b, (real)c, (real)d);
        is_tight(r);
        ck_assert(modulo(r.high) + modulo(r.low) == (uint64_t)(a * b - c * d));
    }
}
END_TEST

// e and f, whole, at an angle of down to 1e-9.  Rejects: vec3_cross.
START_TEST(cross_of_parallels_is_rounded_once)
{
    unsigned long long seed = 11;
    for (int n = 0; n < 20000; n++) {
        int64_t e[3], f[3];
        for (int k = 0; k < 3; k++) {
            e[k] = whole(29, &seed);
            f[k] = e[k] + whole(n % 20, &seed);
        }
        vec3 c = cross_of_parallels(
            (vec3){ (real)e[0], (real)e[1], (real)e[2] },
            (vec3){ (real)f[0], (real)f[1], (real)f[2] });
        ck_assert(c.x == (real)(e[1] * f[2] - e[2] * f[1]));
        ck_assert(c.y == (real)(e[2] * f[0] - e[0] * f[2]));
        ck_assert(c.z == (real)(e[0] * f[1] - e[1] * f[0]));
    }
}
END_TEST

int main(void)
{
    Suite *suite = suite_create("exact");
    TCase *t = tcase_create("exact");
    tcase_set_timeout(t, 60);
    tcase_add_test(t, sum_and_what_it_dropped_are_exact);
    tcase_add_test(t, product_and_what_it_dropped_are_exact);
    tcase_add_test(t, minor_of_products_that_cancel_is_exact);
    tcase_add_test(t, cross_of_parallels_is_rounded_once);
    suite_add_tcase(suite, t);
    SRunner *runner = srunner_create(suite);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
