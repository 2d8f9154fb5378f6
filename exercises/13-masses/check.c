// check.c - tests of the exercise 13/masses.

#include "masses.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>

// Sums of four terms near 1, or as large as they may get: relative to them.
static const real ROUNDING = 1e-14;

static unsigned long long seed = 12;

static real coordinate(vec3 a, int i)
{
    return i == 0 ? a.x : i == 1 ? a.y : a.z;
}

// Both conditions; `slack` allows for more rounding than usual.
static void fulfils(const real share[4], const vec3 t[4], real slack)
{
    for (int i = 0; i < 3; i++) {
        real sum = 0, size = 0;
        for (int k = 0; k < 4; k++) {
            sum += share[k] * coordinate(t[k], i);
            size += share[k] * fabs(coordinate(t[k], i));
        }
        near(sum, 0, slack * ROUNDING * (1 + size), "sum of share t");
        for (int j = 0; j < 3; j++) {
            real spread = 0;
            for (int k = 0; k < 4; k++)
                spread += share[k] * coordinate(t[k], i) * coordinate(t[k], j);
            near(spread, i == j, slack * ROUNDING, i == j
                 ? "spread along an axis" : "spread across two axes");
        }
    }
}

START_TEST(equal_shares_stand_on_the_corners_of_a_tetrahedron)
{
    // All as far from the middle as sqrt(3), with equal angles between them.
    // Rejects: roots that are not taken; a sign; rows that are not divided.
    struct { real share[4]; vec3 t[4]; } four = { { 0.25, 0.25, 0.25, 0.25 },
                                                  { { 0, 0, 0 } } };
    ck_assert_msg(masses_directions(four.share, four.t), "it is refused");
    for (int a = 0; a < 4; a++)
        for (int b = 0; b < 4; b++)
            near(vec3_dot(four.t[a], four.t[b]), a == b ? 3 : -1, ROUNDING * 10,
                 a == b ? "square of a length" : "dot product of two");
    fulfils(four.share, four.t, 1);
}
END_TEST

static void random_shares(real share[4])
{
    real sum = 0;
    for (int k = 0; k < 4; k++) sum += share[k] = 0.02 + random_fraction(&seed);
    for (int k = 0; k < 4; k++) share[k] /= sum;
}

START_TEST(random_shares_do_what_is_asked)
{
    // Rejects: places that do not know the masses.
    for (int round = 0; round < 1000; round++) {
        real share[4];
        vec3 t[4] = { { 0, 0, 0 } };
        random_shares(share);
        ck_assert_msg(masses_directions(share, t), "it is refused");
        fulfils(share, t, 10);
        for (int k = 0; k < 4; k++)
            near(vec3_dot(t[k], t[k]) * share[k], 1 - share[k], 10 * ROUNDING,
                 "share times square of the length");
    }
}
END_TEST

START_TEST(one_may_have_nearly_all)
{
    // All but a billionth, whichever it is; and the others far out.
    // Rejects: 1 - sqrt(share), where nothing is left of the digits.
    for (int heavy = 0; heavy < 4; heavy++)
        for (real little = 1e-3; little > 1e-10; little /= 10) {
            real share[4];
            vec3 t[4] = { { 0, 0, 0 } };
            for (int k = 0; k < 4; k++)
                share[k] = k == heavy ? 1 - 6 * little
                         : little * ((k + 4 - heavy) % 4);
            ck_assert_msg(masses_directions(share, t), "it is refused");
            fulfils(share, t, 100);
        }
}
END_TEST

START_TEST(points_ride_by_their_weights)
{
    for (int round = 0; round < 1000; round++) {
        real share[4], weight[4] = { 0 }, sum = 0;
        vec3 t[4] = { { 0, 0, 0 } }, at = { 0, 0, 0 };
        vec3 y = { random_fraction(&seed), 5 * random_fraction(&seed),
                   -random_fraction(&seed) };
        random_shares(share);
        ck_assert(masses_directions(share, t));
        masses_weigh(share, t, y, weight);
        for (int k = 0; k < 4; k++) {
            sum += weight[k];
            at = vec3_add_scaled(at, weight[k], t[k]);
        }
        near(sum, 1, 100 * ROUNDING, "sum of the weights");
        near(vec3_distance(at, y), 0, 1000 * ROUNDING, "how far off it rides");
    }
}
END_TEST

START_TEST(box_with_a_heavy_handle_has_its_inertia)
{
    // 1 x 2 x 3 m and 12 kg: about x it is (4 + 9) 12 / 12 = 13 kg m^2, about y
    // 10, about z 5.  L is diagonal, a side / sqrt(12) each.
    const real share[4] = { 0.7, 0.1, 0.15, 0.05 };
    real side[3] = { 1, 2, 3 }, inertia[3] = { 0 };
    vec3 t[4] = { { 0, 0, 0 } };
    ck_assert(masses_directions(share, t));
    for (int k = 0; k < 4; k++) {
        real m = 12 * share[k], r2[3];
        for (int i = 0; i < 3; i++) {
            real r = side[i] / sqrt(12) * coordinate(t[k], i);
            r2[i] = r * r;
        }
        for (int i = 0; i < 3; i++)
            inertia[i] += m * (r2[(i + 1) % 3] + r2[(i + 2) % 3]);
    }
    near(inertia[0], 13, 1e-12, "inertia about x");
    near(inertia[1], 10, 1e-12, "inertia about y");
    near(inertia[2], 5, 1e-12, "inertia about z");
}
END_TEST

START_TEST(shares_that_are_none_are_refused)
{
    const real bad[6][4] = {
        { 0.5, 0.5, 0, 0 }, { 0.6, 0.6, -0.1, -0.1 }, { 0.3, 0.3, 0.3, 0.3 },
        { 0.25, (real)NAN, 0.25, 0.25 }, { 0, 0, 0, 0 },
        { HUGE_VAL, 0.1, 0.1, 0.1 },
    };
    for (int i = 0; i < 6; i++) {
        vec3 t[4] = { { 7, 7, 7 }, { 7, 7, 7 }, { 7, 7, 7 }, { 7, 7, 7 } };
        ck_assert_msg(!masses_directions(bad[i], t), "(%g, %g, %g, %g) is "
                      "taken", bad[i][0], bad[i][1], bad[i][2], bad[i][3]);
        for (int k = 0; k < 4; k++) near(t[k].x, 7, 0, "t was 7 before");
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        equal_shares_stand_on_the_corners_of_a_tetrahedron,
        random_shares_do_what_is_asked,
        one_may_have_nearly_all,
        points_ride_by_their_weights,
        box_with_a_heavy_handle_has_its_inertia,
        shares_that_are_none_are_refused,
        NULL
    };
    return suite_run((suite){ .name = "masses", .tests = tests });
}
