// check_sphere.c - is it the smallest, and does it hold everything?
#include "families.h"
#include "sphere.h"
#include "suite.h"

#include <check.h>
#include <string.h>

// A radius is a square root of sums of a few products: a relative error of
// some 1e-16, times what the equations of four almost flat points lose.
static const real BALL = 1e-12;
// A weighted mean of the world's positions is as good as these, which at 1e7 m
// are 2e-9 m apart, and adds four of them up.
static const real FAR_OFF = 1e7, FAR_GRAIN = 1e-8;

// ---- shapes ----------------------------------------------------------------

static void count_up(int *index, int n)
{
    for (int i = 0; i < n; i++) index[i] = i;
}

static real largest_distance(const vec3 *at, int n, vec3 center)
{
    real far = 0;
    for (int i = 0; i < n; i++) far = fmax(far, vec3_distance(at[i], center));
    return far;
}

// ---- the slow oracle: the centre is that of one to four of the points -------

// The centre through k points by elimination with pivots in long double.
static int center_through(const vec3 *q, int k, vec3 *center)
{
    long double m[3][4], w[3] = { 0 };
    int n = k - 1;
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            vec3 a = vec3_sub(q[i + 1], q[0]), b = vec3_sub(q[j + 1], q[0]);
            long double x = (long double)a.x, y = (long double)a.y;
            long double z = (long double)a.z;
            m[i][j] = x * (long double)b.x + y * (long double)b.y
                    + z * (long double)b.z;
        }
        m[i][3] = m[i][i] / 2;
    }
    for (int c = 0; c < n; c++) {
        int p = c;
        for (int i = c; i < n; i++) if (fabsl(m[i][c]) > fabsl(m[p][c])) p = i;
        if (m[p][c] == 0) return 0;
        for (int j = 0; j < 4; j++) {
            long double keep = m[c][j];
            m[c][j] = m[p][j];
            m[p][j] = keep;
        }
        for (int i = 0; i < n; i++) {
            if (i == c) continue;
            long double f = m[i][c] / m[c][c];
            for (int j = 0; j < 4; j++) m[i][j] -= f * m[c][j];
        }
    }
    *center = q[0];
    for (int i = 0; i < n; i++) {
        w[i] = m[i][3] / m[i][i];
        *center = vec3_add_scaled(*center, (real)w[i],
                                  vec3_sub(q[i + 1], q[0]));
    }
    return 1;
}

// No centre encloses with less than the smallest ball's radius, and its centre
// is among those tried: the least reach is the answer, with no tolerance.
static real slow_radius(const vec3 *at, int n)
{
    real best = HUGE_VAL;
    for (int bits = 1; bits < 1 << n; bits++) {
        vec3 q[4], center;
        int k = 0;
        for (int i = 0; i < n && k < 5; i++)
            if (bits >> i & 1) { if (k < 4) q[k] = at[i]; k++; }
        if (k <= 4 && center_through(q, k, &center))
            best = fmin(best, largest_distance(at, n, center));
    }
    return best;
}

// ---- balls of points --------------------------------------------------------

// Rejects: stopping before the farthest point is inside.
START_TEST(ball_encloses_every_point)
{
    int sizes[] = { 1, 2, 3, 5, 12, 100, 3000 };
    static vec3 at[3000];
    static int index[3000];
    seed = 1;
    for (int kind = 0; kind < FAMILIES; kind++)
        for (int s = 0; s < 7; s++) {
            int n = sizes[s], support[4], supports;
            real weight[4];
            family(kind, at, n);
            count_up(index, n);
            sphere b = sphere_of_points(at, index, n, support, weight,
                                        &supports);
            ck_assert_msg(largest_distance(at, n, b.center)
                          <= b.radius * (1 + BALL), "kind %d n %d", kind, n);
        }
}
END_TEST

// Rejects: dropping the wrong support; an obtuse triangle's circumscribed
// circle; a sliver's far centre.
START_TEST(ball_is_the_smallest)
{
    seed = 2;
    for (int kind = 0; kind < FAMILIES; kind++)
        for (int run = 0; run < 40; run++) {
            vec3 at[N];
            int index[N], support[4], supports, n = 1 + run % 9;
            real weight[4];
            family(kind, at, n);
            count_up(index, n);
            sphere b = sphere_of_points(at, index, n, support, weight,
                                        &supports);
            real want = slow_radius(at, n);
            ck_assert_msg(b.radius <= want * (1 + BALL)
                          && b.radius >= want * (1 - BALL),
                          "kind %d n %d: got %.17g, wanted %.17g", kind, n,
                          b.radius, want);
        }
}
END_TEST

// Two points 2 apart and one that stands out of their ball by 1e-8: the radius
// is 1 + 5e-17.  Rejects: a coarse test for "outside", which would answer with
// 1 + 1e-8; a search for the largest ball, which cannot see a gain of 1e-16.
START_TEST(a_point_just_outside_is_let_in)
{
    for (real out = 1e-6; out > 1e-11; out /= 10) {
        vec3 at[3] = { { -1, 0, 0 }, { 1, 0, 0 }, { 0, 1 + out, 0 } };
        int index[3] = { 0, 1, 2 }, support[4], supports;
        real weight[4];
        sphere b = sphere_of_points(at, index, 3, support, weight, &supports);
        ck_assert_msg(fabs(b.radius - 1) < BALL, "got %.17g", b.radius);
    }
}
END_TEST

// Rejects: weights that make another centre; a support inside the ball.
START_TEST(centre_is_the_mean_of_its_supports)
{
    seed = 3;
    for (int kind = 0; kind < FAMILIES; kind++)
        for (int run = 0; run < 400; run++) {
            vec3 at[N], mean = { 0 };
            int index[N], support[4], supports;
            real weight[4], sum = 0;
            family(kind, at, N);
            count_up(index, N);
            sphere b = sphere_of_points(at, index, N, support, weight,
                                        &supports);
            ck_assert(supports >= 1 && supports <= 4);
            for (int i = 0; i < supports; i++) {
                ck_assert(weight[i] >= 0);
                sum += weight[i];
                mean = vec3_add_scaled(mean, weight[i], at[support[i]]);
                ck_assert(fabs(vec3_distance(at[support[i]], b.center)
                               - b.radius) <= BALL * b.radius);
                for (int j = 0; j < i; j++) ck_assert(support[i] != support[j]);
            }
            ck_assert(fabs(sum - 1) < BALL);
            ck_assert(vec3_distance(mean, b.center) <= BALL * 4);
        }
}
END_TEST

// Rejects: squares of world coordinates, which at 1e7 m leave no digit of a
// body of 1 m.
START_TEST(ball_far_from_the_origin_is_the_same)
{
    seed = 4;
    for (int kind = 0; kind < FAMILIES; kind++) {
        vec3 at[N], off = vec3_make(FAR_OFF, -FAR_OFF, FAR_OFF / 3);
        int index[N], support[4], supports;
        real weight[4];
        family(kind, at, N);
        count_up(index, N);
        for (int i = 0; i < N; i++) at[i] = vec3_add(at[i], off);
        sphere b = sphere_of_points(at, index, N, support, weight, &supports);
        ck_assert(largest_distance(at, N, b.center) <= b.radius * (1 + BALL));
        for (int i = 0; i < N; i++) at[i] = vec3_sub(at[i], off);
        sphere c = sphere_of_points(at, index, N, support, weight, &supports);
        ck_assert(fabs(b.radius - c.radius) <= FAR_GRAIN);
        ck_assert(vec3_distance(vec3_sub(b.center, off), c.center)
                  <= FAR_GRAIN);
    }
}
END_TEST

// Rejects: a tolerance in metres.  Powers of two change no digit at all.
START_TEST(ball_of_a_smaller_body_is_smaller_by_as_much)
{
    seed = 5;
    for (int kind = 0; kind < FAMILIES; kind++) {
        vec3 at[N], tiny[N];
        int index[N], support[4], supports;
        real weight[4], scale = 1.0 / (1ll << 60);
        family(kind, at, N);
        count_up(index, N);
        for (int i = 0; i < N; i++) tiny[i] = vec3_scale(scale, at[i]);
        sphere b = sphere_of_points(at, index, N, support, weight, &supports);
        sphere c = sphere_of_points(tiny, index, N, support, weight, &supports);
        ck_assert_msg(fabs(c.radius / scale - b.radius) <= BALL * b.radius,
                      "kind %d", kind);
    }
}
END_TEST

START_TEST(ball_of_few_points_is_known)
{
    vec3 at[4] = { { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } };
    int index[4] = { 0, 1, 2, 3 }, support[4], supports;
    real weight[4];
    ck_assert(sphere_of_points(at, index, 0, support, weight,
                               &supports).radius < 0);
    ck_assert_int_eq(supports, 0);
    ck_assert(sphere_of_points(at, index, 1, support, weight,
                               &supports).radius == 0);
    ck_assert_int_eq(supports, 1);
    ck_assert(fabs(sphere_of_points(at, index, 2, support, weight,
                                    &supports).radius - sqrt(2)) < BALL);
    ck_assert_int_eq(supports, 2);
    ck_assert(fabs(sphere_of_points(at, index, 4, support, weight,
                                    &supports).radius - sqrt(3)) < BALL);
    ck_assert_int_eq(supports, 4);
}
END_TEST

// Rejects: comparisons that step over a NaN and answer as if it were not there.
START_TEST(ball_of_a_bad_point_says_so)
{
    int index[N], support[4], supports;
    real weight[4];
    count_up(index, N);
    for (int bad = 0; bad < N; bad++)
        for (int kind = 0; kind < 2; kind++) {
            vec3 at[N];
            family(0, at, N);
            at[bad].y = kind ? (real)NAN : (real)INFINITY;
            sphere b = sphere_of_points(at, index, N, support, weight,
                                        &supports);
            ck_assert(b.radius != b.radius && b.center.x != b.center.x);
            ck_assert_int_eq(supports, 0);
        }
}
END_TEST

// Rejects: the square of the distance for the distance: a ball of two points,
// of radius 0, because no centre was found.
START_TEST(ball_of_points_beyond_all_numbers_is_infinite)
{
    vec3 at[3] = { { -1e200, 0, 0 }, { 1e200, 0, 0 }, { 0, 1e200, 1 } };
    int index[3], support[4], supports;
    real weight[4];
    count_up(index, 3);
    sphere b = sphere_of_points(at, index, 3, support, weight, &supports);
    ck_assert(vec3_is_finite(b.center) && b.radius == HUGE_VAL);
}
END_TEST

// ---- balls of balls ---------------------------------------------------------

START_TEST(ball_of_two_balls_spans_both)
{
    sphere a = { { 0, 0, 0 }, 1 }, b = { { 6, 0, 0 }, 2 };
    sphere c = sphere_of_spheres(a, b);         // from -1 to 8
    ck_assert(fabs(c.radius - 4.5) < BALL && fabs(c.center.x - 3.5) < BALL);
    c = sphere_of_spheres(b, a);
    ck_assert(fabs(c.radius - 4.5) < BALL && fabs(c.center.x - 3.5) < BALL);
}
END_TEST

// Rejects: 0/0 at equal centres; the formula's smaller ball when one is inside.
START_TEST(a_ball_inside_another_changes_nothing)
{
    sphere a = { { 1, 2, 3 }, 5 }, in = { { 2, 2, 3 }, 1 }, same = a;
    sphere touch = { { 4, 2, 3 }, 2 }, none = { { 9, 9, 9 }, -1 };
    sphere others[] = { in, same, touch, none, { { 1, 2, 3 }, 0 } };
    for (int i = 0; i < 5; i++) {
        sphere c = sphere_of_spheres(a, others[i]);
        sphere d = sphere_of_spheres(others[i], a);
        ck_assert(memcmp(&c, &a, sizeof c) == 0);
        ck_assert(memcmp(&d, &a, sizeof d) == 0);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        ball_encloses_every_point,
        ball_is_the_smallest,
        a_point_just_outside_is_let_in,
        centre_is_the_mean_of_its_supports,
        ball_far_from_the_origin_is_the_same,
        ball_of_a_smaller_body_is_smaller_by_as_much,
        ball_of_few_points_is_known,
        ball_of_a_bad_point_says_so,
        ball_of_points_beyond_all_numbers_is_infinite,
        ball_of_two_balls_spans_both,
        a_ball_inside_another_changes_nothing,
        NULL
    };
    return suite_run((suite){ .name = "sphere", .tests = tests });
}
