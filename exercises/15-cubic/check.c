// check.c - tests of the exercise 15/cubic.

#include "cubic.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>

static unsigned long long seed = 3;

// scale (t - a) (t - b) (t - d)
static void product(real scale, real a, real b, real d, real c[4])
{
    c[0] = -scale * a * b * d;
    c[1] = scale * (a * b + b * d + d * a);
    c[2] = -scale * (a + b + d);
    c[3] = scale;
}

static void expect(const real c[4], int n, const real *wanted, real error,
                   const char *what)
{
    struct { real root[3], guard; } r = { { -7, -7, -7 }, -7 };
    int got = cubic_roots(c, r.root);
    ck_assert_msg(got == n, "%s: %d roots (%g %g %g), wanted %d", what, got,
                  r.root[0], r.root[1], r.root[2], n);
    ck_assert(r.guard == -7);
    for (int k = 0; k < n; k++) near(r.root[k], wanted[k], error, what);
}

START_TEST(three_roots_are_found_in_order)
{
    // Rising at first, and falling at first.
    const real wanted[3] = { 0.25, 0.5, 0.875 };
    real c[4];
    for (int sign = -1; sign < 2; sign += 2) {
        product(sign * 3, 0.5, 0.875, 0.25, c);
        expect(c, 3, wanted, 1e-12, "1/4, 1/2 and 7/8");
    }
}
END_TEST

START_TEST(roots_outside_are_not_named)
{
    const real half = 0.5;
    real c[4];
    product(1, -2, 0.5, 3, c);
    expect(c, 1, &half, 1e-12, "-2, 1/2 and 3");
    product(1, -1, -2, 1.5, c);
    expect(c, 0, NULL, 0, "all outside");
    product(1, -0.01, 1.01, 0.5, c);
    expect(c, 1, &half, 1e-12, "a little outside, on both sides");
}
END_TEST

START_TEST(ends_belong_to_the_way)
{
    const real wanted[2] = { 0, 1 };
    real c[4];
    product(1, 0, 1, 7, c);
    expect(c, 2, wanted, 1e-12, "0 and 1");
}
END_TEST

START_TEST(touch_without_crossing_is_a_root)
{
    const real half = 0.5, third = 1 / 3.0;
    real c[4];
    product(1, 0.5, 0.5, -2, c);
    expect(c, 1, &half, 1e-7, "twice 1/2, from above");
    product(-5, third, third, 3, c);
    expect(c, 1, &third, 1e-7, "twice 1/3, from above");
    product(1, 0.5, 0.5, 0.5, c);
    expect(c, 1, &half, 1e-4, "three times 1/2");
}
END_TEST

START_TEST(two_roots_close_together_are_two)
{
    const real wanted[2] = { 0.49995, 0.50005 };
    real c[4];
    product(1, 0.49995, 0.50005, -2, c);
    expect(c, 2, wanted, 1e-10, "a ten-thousandth apart");
}
END_TEST

START_TEST(lower_degrees_are_solved)
{
    const real third = 1 / 3.0, two[2] = { 0.25, 0.75 };
    const real line[4] = { 1, -3, 0, 0 }, square[4] = { 3, -16, 16, 0 };
    const real pure[4] = { -1, 0, 0, 27 }, none[4] = { 1, 0, 0, 0 };
    const real still[4] = { -1, 0, 9, 0 };
    expect(line, 1, &third, 1e-12, "1 - 3 t");
    expect(square, 2, two, 1e-12, "3 - 16 t + 16 t^2");
    expect(pure, 1, &third, 1e-12, "27 t^3 - 1");
    expect(still, 1, &third, 1e-12, "9 t^2 - 1");
    expect(none, 0, NULL, 0, "1");
}
END_TEST

START_TEST(size_does_not_matter)
{
    const real wanted[3] = { 0.25, 0.5, 0.875 };
    real c[4];
    for (int power = -400; power <= 400; power += 100) {
        product(ldexp(1, power), 0.5, 0.875, 0.25, c);
        expect(c, 3, wanted, 1e-12, "1/4, 1/2 and 7/8, scaled");
    }
}
END_TEST

START_TEST(nothing_and_no_numbers)
{
    const real zero[4] = { 0, 0, 0, 0 };
    real root[3], c[4];
    ck_assert_int_eq(cubic_roots(zero, root), -1);
    for (int k = 0; k < 8; k++) {
        product(1, 0.25, 0.5, 0.75, c);
        c[k / 2] = k % 2 ? (real)NAN : HUGE_VAL;
        ck_assert_int_eq(cubic_roots(c, root), 0);
    }
}
END_TEST

START_TEST(random_curves_lose_no_root)
{
    // Every change of sign between 500 places has its root, and no root is
    // where there is none.
    for (int round = 0; round < 2000; round++) {
        real c[4], root[3], before = 0;
        for (int k = 0; k < 4; k++) c[k] = random_real(&seed);
        c[0] *= 0.2;
        int n = cubic_roots(c, root), changes = 0;
        for (int k = 0; k <= 500; k++) {
            real t = k / 500.0;
            real v = c[0] + t * (c[1] + t * (c[2] + t * c[3]));
            changes += k > 0 && v * before < 0;
            before = v;
        }
        ck_assert_msg(n >= changes, "%d changes of sign, and %d roots",
                      changes, n);
        for (int k = 0; k < n; k++) {
            real t = root[k];
            near(c[0] + t * (c[1] + t * (c[2] + t * c[3])), 0, 1e-12,
                 "value at a root");
            ck_assert(k == 0 || root[k] > root[k - 1]);
        }
    }
}
END_TEST

// A triangle in the plane y = 0, and a corner h above it that goes down by 2 h.
static meeting falling(real x, real z)
{
    return (meeting){ { { x, 1, z }, { 0, 0, 0 }, { 4, 0, 0 }, { 0, 0, 4 } },
                      { { 0, -2, 0 } } };
}

static void hits(const meeting *m, real wanted, const char *what)
{
    real time = -7;
    ck_assert_msg(corner_hits(m, &time), "%s: it is not hit", what);
    near(time, wanted, 1e-9, what);
}

static void passes(const meeting *m, const char *what)
{
    real time = -7;
    ck_assert_msg(!corner_hits(m, &time), "%s: hit at %g", what, time);
    ck_assert_msg(time == -7, "%s: something is written", what);
}

START_TEST(corner_falls_on_a_triangle)
{
    meeting m = falling(1, 1);
    real c[4];
    meeting_cubic(&m, c);
    near(c[0] + c[1] / 2 + c[2] / 4 + c[3] / 8, 0, 1e-12, "volume at 1/2");
    near(fabs(c[0]), 16, 1e-12, "volume at the start: 2 x 8 m^2 x 1 m");
    hits(&m, 0.5, "from above");
    m.at[0].y = -1;
    m.way[0].y = 4;
    hits(&m, 0.25, "from below");
    m.way[0].y = 0.5;
    passes(&m, "too slow");
    m = falling(0, 0);
    hits(&m, 0.5, "on a corner");
    m = falling(2, 2);
    hits(&m, 0.5, "on an edge");
}
END_TEST

START_TEST(corner_passes_beside)
{
    meeting m = falling(2.001, 2.001);
    passes(&m, "a little beside the slanting edge");
    m = falling(-0.001, 1);
    passes(&m, "a little beside another");
    m = falling(9, 9);
    passes(&m, "far beside");
}
END_TEST

START_TEST(corner_overtakes_a_triangle)
{
    // Both fall; then both fly aside as well.
    meeting m = falling(1, 1);
    for (int i = 0; i < 4; i++) m.way[i] = vec3_make(50, -7, 3);
    m.way[0].y = -11;
    hits(&m, 0.25, "1 m at 4 m more");
}
END_TEST

START_TEST(triangle_comes_from_aside)
{
    // It is under the corner when that arrives, and only then.
    meeting m = falling(1, 1);
    for (int i = 1; i < 4; i++) {
        m.at[i].x -= 100;
        m.way[i].x = 200;
    }
    hits(&m, 0.5, "a triangle that flies by");
    m.way[1].x = m.way[2].x = m.way[3].x = 180;
    passes(&m, "a triangle that comes too late");
}
END_TEST

START_TEST(second_crossing_may_be_the_one)
{
    // A plank flies along x, and tips over on its way.  When it lies flat, at
    // 1/4, it is still far away, but its plane goes through the corner; at 3/4
    // it is there.
    meeting m = { { { 1, 0, 1 }, { -10, -1, 0 }, { -6, 3, 0 }, { -10, -1, 4 } },
                  { { 0, 0, 0 }, { 40 / 3.0, 4, 0 }, { 40 / 3.0, -12, 0 },
                    { 40 / 3.0, 4, 0 } } };
    real c[4];
    meeting_cubic(&m, c);
    near((c[0] + c[1] / 4 + c[2] / 16 + c[3] / 64) / c[0], 0, 1e-12,
         "volume at 1/4");
    hits(&m, 0.75, "a plank that tips over");
}
END_TEST

START_TEST(what_lies_in_one_plane_is_not_told)
{
    meeting m = falling(1, 1);
    m.at[0].y = m.way[0].y = 0;
    passes(&m, "all in one plane, all the time");
    m = falling(1, 1);
    m.at[3] = vec3_make(2, 0, 0);
    passes(&m, "a triangle that is a line");
    m = falling(1, 1);
    m.way[2].z = (real)NAN;
    passes(&m, "a NaN");
}
END_TEST

START_TEST(random_meetings_are_not_missed)
{
    // Wherever the volume changes its sign with the corner well inside.
    int seen = 0;
    for (int round = 0; round < 1500; round++) {
        meeting m;
        real before = 0, time = 2;
        for (int i = 0; i < 4; i++) {
            m.at[i] = random_vec3(&seed, 1);
            m.way[i] = random_vec3(&seed, 2);
        }
        int hit = corner_hits(&m, &time);
        for (int k = 0; k <= 100 && k / 100.0 < time - 0.02; k++) {
            vec3 x[4];
            for (int i = 0; i < 4; i++)
                x[i] = vec3_add_scaled(m.at[i], k / 100.0, m.way[i]);
            for (int i = 1; i < 4; i++) x[i] = vec3_sub(x[i], x[0]);
            vec3 n = vec3_cross(vec3_sub(x[2], x[1]), vec3_sub(x[3], x[1]));
            real volume = vec3_dot(x[1], vec3_cross(x[2], x[3])), least = 1;
            for (int i = 1; i < 4; i++)
                least = fmin(least, vec3_dot(n, vec3_cross(x[i],
                                    x[i % 3 + 1])) / vec3_dot(n, n));
            int crossed = k > 0 && volume * before < 0 && least > 0.2;
            ck_assert_msg(!crossed, "at %g it is inside, and is said to hit "
                          "%s %g", k / 100.0, hit ? "at" : "never", time);
            before = volume;
        }
        seen += hit;
    }
    ck_assert_msg(seen > 50, "%d hits: both kinds are to be tried", seen);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        three_roots_are_found_in_order,
        roots_outside_are_not_named,
        ends_belong_to_the_way,
        touch_without_crossing_is_a_root,
        two_roots_close_together_are_two,
        lower_degrees_are_solved,
        size_does_not_matter,
        nothing_and_no_numbers,
        random_curves_lose_no_root,
        corner_falls_on_a_triangle,
        corner_passes_beside,
        corner_overtakes_a_triangle,
        triangle_comes_from_aside,
        second_crossing_may_be_the_one,
        what_lies_in_one_plane_is_not_told,
        random_meetings_are_not_missed,
        NULL
    };
    return suite_run((suite){ .name = "cubic", .tests = tests });
}
