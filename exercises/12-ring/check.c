// check.c - tests of the exercise 12/ring.

#include "closed.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>

// Some hundred roundings, in systems whose pivots are not small.
static const real ROUNDING = 1e-12;

// Memory that ends behind its last number.
static real *numbers(int n)
{
    real *x = malloc((size_t)n * sizeof *x);
    ck_assert_ptr_nonnull(x);
    return x;
}

static unsigned long long seed = 12;

// Solves in memory of just this size.
static int solve(int n, const real *lower, const real *diagonal,
                 const real *upper, real *x)
{
    real *out = numbers(n), *room = numbers(3 * n);
    for (int k = 0; k < n; k++) out[k] = x[k];
    int solved = ring_solve(n, lower, diagonal, upper, out, room);
    for (int k = 0; k < n; k++) x[k] = out[k];
    free(out);
    free(room);
    return solved;
}

START_TEST(three_in_a_ring_are_solved)
{
    // 4x - y - z = 6 and its two brothers: all rows have the sum 2.
    // Rejects: corners left out; a sign; an unscaled v.
    const real side[3] = { -1, -1, -1 }, four[3] = { 4, 4, 4 };
    real x[3] = { 0, 5, 10 };
    ck_assert_msg(solve(3, side, four, side, x), "it is refused");
    near(x[0], 1.5, ROUNDING, "x of 4x - y - z = 0");
    near(x[1], 2.5, ROUNDING, "y of -x + 4y - z = 5");
    near(x[2], 3.5, ROUNDING, "z of -x - y + 4z = 10");
}
END_TEST

START_TEST(ring_without_symmetry_is_solved)
{
    // An answer is made up, and the right side from it.
    real l[40], d[40], u[40], x[40], wanted[40];
    for (int round = 0; round < 300; round++) {
        int n = 3 + round % 38;
        for (int k = 0; k < n; k++) {
            l[k] = random_real(&seed);
            u[k] = random_real(&seed);
            d[k] = (k % 3 ? 1 : -1) * (2.5 + random_real(&seed) / 4);
            wanted[k] = random_real(&seed);
        }
        for (int k = 0; k < n; k++)
            x[k] = l[k] * wanted[(k + n - 1) % n] + d[k] * wanted[k]
                 + u[k] * wanted[(k + 1) % n];
        ck_assert_msg(solve(n, l, d, u, x), "a ring of %d is refused", n);
        for (int k = 0; k < n; k++) near(x[k], wanted[k], ROUNDING, "unknown");
    }
}
END_TEST

START_TEST(large_ring_takes_no_time)
{
    // (-1, 3, -1) all round: a right side of 1 has the answer 1.
    // Rejects: elimination of a full matrix.
    enum { N = 100000 };
    real *l = numbers(N), *d = numbers(N), *x = numbers(N);
    for (int k = 0; k < N; k++) {
        l[k] = -1;
        d[k] = 3;
        x[k] = 1;
    }
    ck_assert(solve(N, l, d, l, x));
    for (int k = 0; k < N; k += 1000) near(x[k], 1, ROUNDING, "unknown");
    free(l);
    free(d);
    free(x);
}
END_TEST

START_TEST(ring_without_an_answer_is_refused)
{
    // All rows of (-1, 2, -1) add up to nothing: a solver finds that
    // all may be raised alike.  And zeros, and a NaN.
    const real side[8] = { -1, -1, -1, -1, -1, -1, -1, -1 };
    const real two[8] = { 2, 2, 2, 2, 2, 2, 2, 2 }, zero[8] = { 0 };
    const real lost[8] = { 2, (real)NAN, 2, 2, 2, 2, 2, 2 };
    for (int n = 3; n <= 8; n++) {
        real x[8] = { 1, 2, 3 };
        ck_assert_msg(!solve(n, side, two, side, x), "(-1, 2, -1) round a ring"
                      " of %d: got %g, ...", n, x[0]);
        ck_assert_msg(!solve(n, zero, zero, zero, x), "nothing but zeros");
        ck_assert_msg(!solve(n, side, lost, side, x), "a NaN");
    }
}
END_TEST

static particle ring[64];

static vec3 link(int n, int k)
{
    return vec3_sub(ring[(k + 1) % n].position, ring[k].position);
}

// n particles on a circle, whose links are so long, turned out of all planes.
static void lay(int n, real length)
{
    real turn = 2 * 3.14159265358979324 / n, r = length / (2 * sin(turn / 2));
    for (int k = 0; k < n; k++) {
        vec3 x = { r * cos(turn * k), 0.6 * r * sin(turn * k),
                   0.8 * r * sin(turn * k) };
        ring[k] = (particle){ x, x, 0.25 };
    }
}

static int step(int n, real rest)
{
    particle *p = malloc((size_t)n * sizeof *p);
    real *room = numbers(7 * n);
    ck_assert_ptr_nonnull(p);
    for (int k = 0; k < n; k++) p[k] = ring[k];
    int solved = ring_step(p, n, rest, room);
    for (int k = 0; k < n; k++) ring[k] = p[k];
    free(p);
    free(room);
    return solved;
}

START_TEST(regular_ring_takes_herons_step)
{
    // By symmetry it stays regular, and each link goes from d to
    // (d^2 + L^2) / (2 d).
    for (int n = 3; n < 64; n += 5) {
        lay(n, 1.25);
        ck_assert_msg(step(n, 1), "a ring of %d is refused", n);
        for (int k = 0; k < n; k++)
            near(vec3_length(link(n, k)), (1.25 * 1.25 + 1) / 2.5, ROUNDING,
                 "length of a link");
    }
}
END_TEST

static real worst(int n, real rest)
{
    real most = 0;
    for (int k = 0; k < n; k++)
        most = fmax(most, fabs(vec3_length(link(n, k)) / rest - 1));
    return most;
}

START_TEST(error_is_squared_and_the_centre_stays)
{
    enum { N = 30 };
    for (int round = 0; round < 50; round++) {
        vec3 moved = { 0, 0, 0 };
        lay(N, 1);
        for (int k = 0; k < N; k++) {
            vec3 aside = random_vec3(&seed, 1);
            ring[k].inverse_mass = 1.5 + random_real(&seed);
            ring[k].position = vec3_add_scaled(ring[k].position, 1e-3, aside);
            ring[k].previous = ring[k].position;
        }
        real e = worst(N, 1);
        ck_assert(step(N, 1));
        ck_assert_msg(worst(N, 1) <= 100 * e * e, "a strain of %g becomes %g",
                      e, worst(N, 1));
        for (int k = 0; k < N; k++)
            moved = vec3_add_scaled(moved, 1 / ring[k].inverse_mass,
                        vec3_sub(ring[k].position, ring[k].previous));
        near(vec3_length(moved), 0, ROUNDING, "momentum");
    }
}
END_TEST

START_TEST(necklace_bears_its_jewel)
{
    // 24 beads, two of them nailed 0.4 m apart; one in the middle between them
    // is 1000 times as heavy.  Both halves hang down like a V.
    enum { N = 24 };
    lay(N, 0.05);
    for (int k = 0; k < N; k++) {
        int down = k % 12 < 6 ? k % 12 : 12 - k % 12;
        real along = (k < 12 ? k : N - k) / 12.0, low = 0.05 * sqrt(5 / 9.0);
        ring[k].position = vec3_make(0.4 * along, -low * down, 0);
        ring[k].previous = ring[k].position;
    }
    ring[0].inverse_mass = ring[12].inverse_mass = 0;
    ring[18].inverse_mass = 0.25e-3;
    for (int k = 0; k < 1200; k++) {
        verlet_step(ring, N, vec3_make(0, -9.81, 0), NULL, 1.0 / 1200);
        for (int i = 0; i < 3; i++) ck_assert(step(N, 0.05));
        ck_assert_msg(worst(N, 0.05) < 1e-6, "step %d: a strain of %g", k,
                      worst(N, 0.05));
    }
    near(vec3_distance(ring[0].previous, ring[0].position), 0, 0,
         "way of the nail");
}
END_TEST

START_TEST(ring_in_one_point_moves_nothing)
{
    for (int k = 0; k < 5; k++)
        ring[k] = (particle){ { 1, 2, 3 }, { 1, 2, 3 }, 1 };
    ck_assert_int_eq(step(5, 1), 0);
    for (int k = 0; k < 5; k++)
        near(vec3_distance(ring[k].position, ring[k].previous), 0, 0, "a way");
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        three_in_a_ring_are_solved,
        ring_without_symmetry_is_solved,
        large_ring_takes_no_time,
        ring_without_an_answer_is_refused,
        regular_ring_takes_herons_step,
        error_is_squared_and_the_centre_stays,
        necklace_bears_its_jewel,
        ring_in_one_point_moves_nothing,
        NULL
    };
    return suite_run((suite){ .name = "ring", .tests = tests });
}
