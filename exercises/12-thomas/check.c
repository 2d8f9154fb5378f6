// check.c - tests of the exercise 12/thomas.

#include "thomas.h"

#include <check.h>
#include <stdlib.h>
#include <string.h>

#include "expect.h"
#include "line.h"
#include "random.h"
#include "suite.h"

// Some hundred roundings, in systems whose pivots are not small.
static const real ROUNDING = 1e-12;

// Memory that ends behind its last number.
static real *numbers(int n)
{
    real *x = malloc((size_t)n * sizeof *x);
    ck_assert_ptr_nonnull(x);
    return x;
}

static unsigned long long seed = 11;

// Solves in memory of just this size, x apart from right.
static int solve(int n, const real *lower, const real *diagonal,
                 const real *upper, const real *right, real *x)
{
    real *room = numbers(n), *rows[4];
    const real *given[4] = { lower, diagonal, upper, right };
    for (int i = 0; i < 4; i++) {
        rows[i] = numbers(n);
        for (int k = 0; k < n; k++) rows[i][k] = given[i][k];
    }
    real *out = numbers(n);
    int solved = thomas_solve(n, rows[0], rows[1], rows[2], rows[3], out, room);
    for (int k = 0; k < n; k++) x[k] = out[k];
    for (int i = 0; i < 4; i++) free(rows[i]);
    free(out);
    free(room);
    return solved;
}

START_TEST(three_equations_are_solved)
{
    // 2x - y = 1, -x + 2y - z = 2, -y + 2z = 3: x = 5/2, y = 4, z = 7/2.
    // Rejects: a sign; a first or last unknown that is left out.
    const real side[3] = { -1, -1, -1 }, two[3] = { 2, 2, 2 };
    const real right[3] = { 1, 2, 3 }, wanted[3] = { 2.5, 4, 3.5 };
    real x[3];
    ck_assert_msg(solve(3, side, two, side, right, x), "it is refused");
    for (int k = 0; k < 3; k++) near(x[k], wanted[k], ROUNDING, "unknown");
}
END_TEST

START_TEST(system_without_symmetry_is_solved)
{
    // An answer is made up, and the right side from it.
    enum { N = 40 };
    real l[N], d[N], u[N], right[N], x[N], wanted[N];
    for (int round = 0; round < 200; round++) {
        for (int k = 0; k < N; k++) {
            l[k] = random_real(&seed);
            u[k] = random_real(&seed);
            d[k] = (k % 2 ? 1 : -1) * (2.5 + random_real(&seed) / 4);
            wanted[k] = random_real(&seed);
        }
        for (int k = 0; k < N; k++)
            right[k] = (k > 0 ? l[k] * wanted[k - 1] : 0) + d[k] * wanted[k]
                     + (k + 1 < N ? u[k] * wanted[k + 1] : 0);
        ck_assert_msg(solve(N, l, d, u, right, x), "it is refused");
        for (int k = 0; k < N; k++) near(x[k], wanted[k], ROUNDING, "unknown");
    }
}
END_TEST

START_TEST(corners_are_not_looked_at)
{
    // One equation, and three with a NaN where nothing stands.  And none.
    const real none = (real)NAN, l[3] = { none, -1, -1 }, d[3] = { 2, 2, 2 };
    const real u[3] = { -1, -1, none }, right[3] = { 1, 2, 3 };
    real x[3];
    ck_assert_msg(solve(3, l, d, u, right, x), "it is refused");
    near(x[1], 4, ROUNDING, "the middle one of three");
    ck_assert(solve(1, &none, d, &none, right, x));
    near(x[0], 0.5, 0, "one equation");
    ck_assert_int_eq(thomas_solve(0, NULL, NULL, NULL, NULL, NULL, NULL), 1);
}
END_TEST

START_TEST(answer_may_take_the_place_of_the_right_side)
{
    real l[2] = { 0, 1 }, d[2] = { 2, 4 }, u[2] = { 1, 0 }, x[2] = { 4, 9 };
    real room[2];
    ck_assert_int_eq(thomas_solve(2, l, d, u, x, x, room), 1);
    near(x[0], 1, ROUNDING, "x");
    near(x[1], 2, ROUNDING, "y");
}
END_TEST

START_TEST(hundred_thousand_rows_take_no_time)
{
    // A string under its own weight: -x[k-1] + 2 x[k] - x[k+1] = 1 has the
    // answer (k + 1)(n - k) / 2.  Its condition is n^2.
    // Rejects: elimination of a full matrix.
    enum { N = 100000 };
    real *l = numbers(N), *d = numbers(N), *x = numbers(N), *room = numbers(N);
    for (int k = 0; k < N; k++) {
        l[k] = -1;
        d[k] = 2;
        x[k] = 1;
    }
    ck_assert_int_eq(thomas_solve(N, l, d, l, x, x, room), 1);
    real middle = (N / 2 + 1.0) * (N - N / 2) / 2;
    near(x[N / 2] / middle, 1, 1e-6, "how low it hangs");
    free(l);
    free(d);
    free(x);
    free(room);
}
END_TEST

START_TEST(system_without_an_answer_is_refused)
{
    // x - y = 1, -x + y = 1; a diagonal of 0; a NaN.
    // Rejects: division by 0; a comparison that a NaN passes.
    const real l[2] = { 0, -1 }, d[2] = { 1, 1 }, u[2] = { -1, 0 };
    const real zero[2] = { 0, 1 }, lost[2] = { 1, (real)NAN };
    const real right[2] = { 1, 1 };
    real x[2];
    ck_assert_msg(!solve(2, l, d, u, right, x), "two rows of one line have no "
                  "answer: got (%g, %g)", x[0], x[1]);
    ck_assert_msg(!solve(2, l, zero, u, right, x), "the first pivot is 0");
    ck_assert_msg(!solve(2, l, lost, u, right, x), "a diagonal is no number");
}
END_TEST

static particle rope[64];
static real room[5 * 63];

static void lay(int links, real length)
{
    for (int k = 0; k <= links; k++) {
        vec3 x = { k * length, 0, 0 };
        rope[k] = (particle){ x, x, 1 };
    }
}

static real strain(int links, real rest)
{
    real worst = 0;
    for (int k = 0; k < links; k++)
        worst = fmax(worst, fabs(vec3_distance(rope[k + 1].position,
                                               rope[k].position) / rest - 1));
    return worst;
}

START_TEST(one_link_takes_herons_step)
{
    // From d to (d^2 + L^2) / (2 d), shared by inverse mass.
    // Rejects: d - L for (d^2 - L^2) / 2; a sign; equal shares.
    lay(1, 1.5);
    rope[0].inverse_mass = 3;
    ck_assert_int_eq(rope_step(rope, 1, 1, room), 1);
    near(vec3_distance(rope[0].position, rope[1].position),
         (1.5 * 1.5 + 1) / (2 * 1.5), ROUNDING, "length");
    near(rope[0].position.x / (1.5 - rope[1].position.x), 3, ROUNDING,
         "shares of 3 and 1");
}
END_TEST

START_TEST(step_is_the_librarys)
{
    // Rejects: a neighbour's weight; one of two pulls; links that have moved.
    enum { LINKS = 20 };
    shape plan;
    particle told[LINKS + 1];
    relax_options o = relax_options_pbd();
    o.tolerance = 0;
    ck_assert(shape_rope(&plan, LINKS, LINKS, 1).ok);
    line_scratch *scratch = line_scratch_new(&plan);
    ck_assert_ptr_nonnull(scratch);
    for (int round = 0; round < 100; round++) {
        lay(LINKS, 1);
        for (int k = 0; k <= LINKS; k++) {
            rope[k].inverse_mass = 1.5 + random_real(&seed);
            rope[k].position.y = 0.6 * (k % 3);
            rope[k].position.z = 0.05 * random_real(&seed);
        }
        if (round % 3) rope[round % LINKS].inverse_mass = 0;
        strands s = shape_strands(&plan, 0);
        s.rest_length = 1.25;
        memcpy(told, rope, sizeof told);
        line_solve(s, told, 1, o, scratch);
        ck_assert_int_eq(rope_step(rope, LINKS, 1.25, room), 1);
        for (int k = 0; k <= LINKS; k++)
            near(vec3_distance(rope[k].position, told[k].position), 0, 1e-11,
                 "how far a particle is from where line_solve puts it");
    }
    line_scratch_free(scratch);
    shape_free(&plan);
}
END_TEST

START_TEST(rope_holds_ten_thousand_times_its_particle)
{
    enum { LINKS = 50 };
    lay(LINKS, 0.02);
    rope[0].inverse_mass = 0;
    rope[LINKS].inverse_mass = 1e-4;
    for (int k = 0; k <= LINKS; k++) {
        rope[k].position = vec3_make(0, -0.02 * k, 0);
        rope[k].previous = rope[k].position;
    }
    for (int frame = 0; frame < 300; frame++) {
        verlet_step(rope, LINKS + 1, vec3_make(0, -9.81, 0), NULL, 1.0 / 60);
        for (int step = 0; step < 3; step++)
            ck_assert_int_eq(rope_step(rope, LINKS, 0.02, room), 1);
    }
    near(strain(LINKS, 0.02), 0, 1e-8, "strain after five seconds");
}
END_TEST

START_TEST(links_without_an_answer_move_nothing)
{
    // All particles in one place; a link between two nails.
    particle kept[4];
    for (int round = 0; round < 2; round++) {
        lay(3, 1.25);
        for (int k = 0; k < 4 && round == 0; k++)
            rope[k].position = vec3_make(1, 2, 3);
        if (round == 1) rope[1].inverse_mass = rope[2].inverse_mass = 0;
        memcpy(kept, rope, sizeof kept);
        ck_assert_int_eq(rope_step(rope, 3, 1, room), 0);
        for (int k = 0; k < 4; k++)
            near(vec3_distance(rope[k].position, kept[k].position), 0, 0,
                 "how far a particle has gone");
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        three_equations_are_solved,
        system_without_symmetry_is_solved,
        corners_are_not_looked_at,
        answer_may_take_the_place_of_the_right_side,
        hundred_thousand_rows_take_no_time,
        system_without_an_answer_is_refused,
        one_link_takes_herons_step,
        step_is_the_librarys,
        rope_holds_ten_thousand_times_its_particle,
        links_without_an_answer_move_nothing,
        NULL
    };
    return suite_run((suite){ .name = "thomas", .tests = tests });
}
