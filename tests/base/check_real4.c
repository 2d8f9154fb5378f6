// check_real4.c - do all forms of four numbers give the bits of one at a time?
// Book: chapter 13.

#include <check.h>
#include <string.h>

#define NAME real4_run_vectors
#include "real4_forms.h"
#include "random.h"
#include "suite.h"

static unsigned long long seed = 5;

// Any bits at all: numbers of every size, subnormal, infinite, NaN.
static real any_bits(void)
{
    real x;
    unsigned long long bits = random_bits(&seed);
    bits ^= bits >> 31;
    memcpy(&x, &bits, sizeof x);
    return x;
}

static real any_number(int n)
{
    const real odd[] = { 0.0, -0.0, 1, -1, HUGE_VAL, -HUGE_VAL, (real)NAN,
                         5e-324, -5e-324, 1.7e308 };
    real x = any_bits();
    if (n % 3 == 0) return odd[seed >> 40 & 7];
    if (n % 3 == 1) return random_real(&seed);
    return x;
}

// The same bits, or both NaN: of two NaN either may come out.
static bool same(real a, real b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (a != a && b != b);
}

static real alone(int operation, const real_lanes *in, int l)
{
    real a = in->a[l], b = in->b[l], c = in->c[l], t[3] = { c, a, b };
    const real x[3] = { a, b, c }, y[3] = { b, c, a };
    for (int i = 0; i < 3; i++) {
        t[i] = x[i] * b + t[i];
        t[i] = t[i] - y[i] * a;
    }
    switch (operation) {
    case ADD:    return a + b;
    case SUB:    return a - b;
    case MUL:    return a * b;
    case DIV:    return a / b;
    case MAX:    return real_max(a, b);
    case MIN:    return real_min(a, b);
    case CHOOSE: return c > 0 ? a : b;
    case SQRT:   return sqrt(a);
    case MAD:    return a * b + c;
    case SUMS:   return t[0] * x[0] + (t[1] * x[1] + t[2] * x[2]);
    case CROSS_X: return b * a - c * c;
    case CROSS_Y: return c * b - a * a;
    case CROSS_Z: return a * c - b * b;
    case MAKE:   return l == 0 ? in->a[3] : l == 1 ? in->b[2]
                      : l == 2 ? in->c[1] : in->a[0];
    case ALL:    return in->a[1];
    case ANY:    return a != 0 ? 1 : 0;
    default:     return a + b;
    }
}

// Rejects: a minimum that keeps NaN, a maximum of -0 and 0 that depends on the
// form; lanes in another order; a sum of products in another order.
START_TEST(four_at_once_are_the_bits_of_each_alone_in_every_form)
{
    bool has_wide = real4_has_wide();
    for (int n = 0; n < 10000; n++) {
        real_lanes in;
        for (int l = 0; l < REAL4; l++) {
            in.a[l] = any_number(n + l);
            in.b[l] = any_number(n + 2 * l);
            in.c[l] = any_number(n / 3 + l);
        }
        for (int k = 0; k < OPERATIONS; k++) {
            real plain[2 * REAL4], vectors[2 * REAL4], wide[2 * REAL4];
            real4_run_plain(k, &in, plain);
            real4_run_vectors(k, &in, vectors);
            if (has_wide) real4_run_wide(k, &in, wide);
            else memcpy(wide, plain, sizeof wide);
            bool alike = true;
            for (int l = 0; l < REAL4; l++) {
                alike &= same(plain[l], alone(k, &in, l));
                alike &= same(vectors[l], alone(k, &in, l));
                alike &= same(wide[l], alone(k, &in, l));
                if (k != GATHER) continue;
                alike &= same(plain[REAL4 + l], in.b[l]);
                alike &= same(vectors[REAL4 + l], in.b[l]);
                alike &= same(wide[REAL4 + l], in.b[l]);
            }
            ck_assert_msg(alike, "operation %d: %g and %g", k, plain[0],
                          vectors[0]);
        }
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        four_at_once_are_the_bits_of_each_alone_in_every_form,
        NULL
    };
    return suite_run((suite){ .name = "real4", .tests = tests });
}
