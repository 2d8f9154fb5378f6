// check.c - tests of the exercise 12/rod.

#include "rod.h"

#include <check.h>
#include <stdlib.h>
#include <string.h>

static const real ROUNDING = 1e-12;

static const real h = 1.0 / 64;                 // s

enum { MOST = 24 };

static particle p[MOST];

static void near(real got, real wanted, real error, const char *what)
{
    ck_assert_msg(fabs(got - wanted) <= error, "%s: got %.15g, wanted %.15g",
                  what, got, wanted);
}

// Uniform in [-1, 1), the same on every machine.
static real random_real(void)
{
    static unsigned long long state = 7;
    state = state * 6364136223846793005ULL + 1442695040888963407ULL;
    return (real)(state >> 11) / 4503599627370496.0 - 1;
}

static vec3 random_vec3(real most)
{
    real x = random_real(), y = random_real();
    return vec3_scale(most, vec3_make(x, y, random_real()));
}

// In memory of just this size.
static band band_of(int n)
{
    band m = { n, malloc((size_t)n * sizeof(real)),
               malloc((size_t)n * sizeof(real)),
               malloc((size_t)n * sizeof(real)) };
    ck_assert(m.diagonal && m.next && m.far);
    return m;
}

static void band_free(band *m)
{
    free(m->diagonal);
    free(m->next);
    free(m->far);
}

static int step(int n, real stiffness)
{
    band m = band_of(n);
    vec3 *move = malloc((size_t)n * sizeof *move);
    particle *mine = malloc((size_t)n * sizeof *mine);
    ck_assert(move && mine);
    memcpy(mine, p, (size_t)n * sizeof *mine);
    int solved = rod_step(mine, n, stiffness, h, &m, move);
    memcpy(p, mine, (size_t)n * sizeof *mine);
    band_free(&m);
    free(move);
    free(mine);
    return solved;
}

START_TEST(band_is_solved)
{
    // An answer is made up, and the right side from it.
    for (int round = 0; round < 200; round++) {
        int n = 1 + round % MOST;
        band m = band_of(n);
        vec3 *x = malloc((size_t)n * sizeof *x), wanted[MOST];
        ck_assert_ptr_nonnull(x);
        for (int k = 0; k < n; k++) {
            m.diagonal[k] = 5 + random_real();
            m.next[k] = k + 1 < n ? random_real() : (real)NAN;
            m.far[k] = k + 2 < n ? random_real() : (real)NAN;
            wanted[k] = random_vec3(1);
        }
        for (int k = 0; k < n; k++) {
            x[k] = vec3_scale(m.diagonal[k], wanted[k]);
            for (int j = k - 2; j <= k + 2; j++) {
                if (j < 0 || j >= n || j == k) continue;
                int low = j < k ? j : k, by = abs(j - k);
                real entry = by == 1 ? m.next[low] : m.far[low];
                x[k] = vec3_add_scaled(x[k], entry, wanted[j]);
            }
        }
        ck_assert_msg(band_solve(&m, x), "%d rows are refused", n);
        for (int k = 0; k < n; k++)
            near(vec3_distance(x[k], wanted[k]), 0, ROUNDING, "an unknown");
        band_free(&m);
        free(x);
    }
}
END_TEST

START_TEST(band_without_an_answer_is_refused)
{
    // 1 1, 1 1; a 0; a NaN.
    for (int round = 0; round < 3; round++) {
        band m = band_of(2);
        vec3 x[2] = { { 1, 2, 3 }, { 1, 2, 3 } };
        m.diagonal[0] = round == 1 ? 0 : 1;
        m.diagonal[1] = round == 2 ? (real)NAN : 1;
        m.next[0] = 1;
        m.next[1] = m.far[0] = m.far[1] = 0;
        ck_assert_int_eq(band_solve(&m, x), 0);
        band_free(&m);
    }
}
END_TEST

START_TEST(rows_are_those_of_the_bends)
{
    // Six particles of 2 kg: 1 5 6 6 5 1 on the diagonal, -2 -4 -4 -4 -2
    // beside it, 1 next to that; times h^2 stiffness.
    const real diagonal[6] = { 1, 5, 6, 6, 5, 1 };
    const real next[5] = { -2, -4, -4, -4, -2 };
    band m = band_of(6);
    for (int k = 0; k < 6; k++) p[k] = (particle){ .inverse_mass = 0.5 };
    rod_band(&m, p, 64 * 64 * 3.0, h);
    for (int k = 0; k < 6; k++) {
        near(m.diagonal[k], 2 + 3 * diagonal[k], ROUNDING, "on the diagonal");
        if (k < 5) near(m.next[k], 3 * next[k], ROUNDING, "beside it");
        if (k < 4) near(m.far[k], 3, ROUNDING, "two beside it");
    }
    p[2].inverse_mass = 0;
    rod_band(&m, p, 64 * 64 * 3.0, h);
    near(m.diagonal[2], 1, 0, "on the diagonal of a nail");
    near(fabs(m.next[1]) + fabs(m.next[2]) + fabs(m.far[0]) + fabs(m.far[2]), 0,
         0, "beside a nail");
    near(m.diagonal[1], 2 + 3 * 5, ROUNDING, "its neighbour");
    band_free(&m);
}
END_TEST

START_TEST(straight_rod_has_nothing_to_do)
{
    // Wherever it lies, if it is evenly spaced; and one of one or two
    // particles, which has no bend.
    for (int n = 1; n <= MOST; n++) {
        vec3 from = random_vec3(4), way = random_vec3(1), kept[MOST];
        for (int k = 0; k < n; k++) {
            kept[k] = vec3_add_scaled(from, k, way);
            p[k] = (particle){ kept[k], kept[k], 1 + k % 3 };
        }
        if (n == 2) kept[1] = p[1].position = random_vec3(9);
        ck_assert_int_eq(step(n, 1e4), 1);
        for (int k = 0; k < n; k++)
            near(vec3_distance(p[k].position, kept[k]), 0, 1e-12, "a way");
    }
}
END_TEST

START_TEST(momenta_stay_and_it_straightens)
{
    // The force at the end acts along the places of the end: position by
    // position, sum m d = 0 and sum m (x + d) x d = 0.
    for (int round = 0; round < 200; round++) {
        vec3 sum = { 0, 0, 0 }, turn = sum, was[MOST];
        real before = 0, after = 0;
        for (int k = 0; k < MOST; k++) {
            vec3 x = vec3_add(vec3_make(k, 0, 0), random_vec3(0.3));
            was[k] = x;
            p[k] = (particle){ x, x, 1.5 + random_real() };
        }
        for (int k = 1; k + 1 < MOST; k++)
            before += vec3_length_squared(vec3_add_scaled(vec3_add(
                p[k - 1].position, p[k + 1].position), -2, p[k].position));
        ck_assert_int_eq(step(MOST, 1e4), 1);
        for (int k = 0; k < MOST; k++) {
            vec3 d = vec3_scale(1 / p[k].inverse_mass,
                                vec3_sub(p[k].position, was[k]));
            sum = vec3_add(sum, d);
            turn = vec3_add(turn, vec3_cross(p[k].position, d));
            ck_assert(vec3_distance(p[k].previous, was[k]) == 0);
        }
        for (int k = 1; k + 1 < MOST; k++)
            after += vec3_length_squared(vec3_add_scaled(vec3_add(
                p[k - 1].position, p[k + 1].position), -2, p[k].position));
        near(vec3_length(sum), 0, 1e-11, "momentum");
        near(vec3_length(turn), 0, 1e-10, "angular momentum");
        ck_assert_msg(after < 0.5 * before, "bends of %g become %g", before,
                      after);
    }
}
END_TEST

START_TEST(nailed_rod_bends_under_its_weight)
{
    // Two nails hold one end level; 8 more particles of 1 kg.  At rest bend k
    // bears the moments of all weights beyond it: -sum_(j>k) (j - k) g /
    // stiffness is x_(k-1) - 2 x_k + x_(k+1), for k from 1 on.
    enum { N = 10 };
    const real stiffness = 1e5, g = 9.81;
    real y[N] = { 0 };
    for (int k = 0; k < N; k++) {
        vec3 x = { k, 0, 0 };
        p[k] = (particle){ x, x, k > 1 };
    }
    for (int k = 1; k + 1 < N; k++) {
        real moment = 0;
        for (int j = k + 1; j < N; j++) moment += j - k;
        y[k + 1] = 2 * y[k] - y[k - 1] - moment * g / stiffness;
    }
    // Slowed down, as in honey, until it rests.
    for (int i = 0; i < 4000; i++) {
        for (int k = 0; k < N; k++)
            p[k].previous = vec3_add_scaled(p[k].position, -0.9,
                            vec3_sub(p[k].position, p[k].previous));
        verlet_step(p, N, vec3_make(0, -g, 0), NULL, h);
        ck_assert_int_eq(step(N, stiffness), 1);
    }
    for (int k = 0; k < N; k++) {
        near(p[k].position.y, y[k], 1e-6, "how deep a particle hangs");
        near(p[k].position.x, k, 1e-9, "how far out it is");
    }
}
END_TEST

START_TEST(no_stiffness_explodes)
{
    for (real stiffness = 1; stiffness < 1e13; stiffness *= 100) {
        for (int k = 0; k < MOST; k++) {
            vec3 x = { 0.1 * k, 0.02 * random_real(), 0 };
            p[k] = (particle){ x, x, k > 1 };
        }
        for (int i = 0; i < 200; i++) {
            verlet_step(p, MOST, vec3_make(0, 0, 0), NULL, h);
            ck_assert_int_eq(step(MOST, stiffness), 1);
            for (int k = 0; k < MOST; k++)
                ck_assert_msg(fabs(p[k].position.y) < 1, "at %g N/m particle "
                              "%d is %g m aside", stiffness, k,
                              p[k].position.y);
        }
    }
}
END_TEST

int main(void)
{
    Suite *s = suite_create("rod");
    TCase *t = tcase_create("rod");
    tcase_add_test(t, band_is_solved);
    tcase_add_test(t, band_without_an_answer_is_refused);
    tcase_add_test(t, rows_are_those_of_the_bends);
    tcase_add_test(t, straight_rod_has_nothing_to_do);
    tcase_add_test(t, momenta_stay_and_it_straightens);
    tcase_add_test(t, nailed_rod_bends_under_its_weight);
    tcase_add_test(t, no_stiffness_explodes);
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed != 0;
}
