// check.c - tests of the exercise 06/circle.

#include "circle.h"
#include "random.h"
#include "suite.h"

#include <check.h>

// Some dozen roundings of numbers near 1, and the centre of a flat triangle,
// whose radius does not mind a hundred of them.
static const real ROUNDING = 1e-12;
// At 1e6 m a place is rounded to 1e-10 m.
static const real FAR = 1e-9;

static const real PI = 3.14159265358979323846;

enum { MOST = 20000 };

static point some[MOST];

static unsigned long long seed = 6;

static real distance(point a, point b)
{
    return sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

static void expect(const char *what, const point *at, int n, real x, real y,
                   real radius, real slack)
{
    circle c = smallest_circle(at, n);
    ck_assert_msg(distance(c.center, (point){ x, y }) <= slack
                  && fabs(c.radius - radius) <= slack,
                  "%s: got the centre (%.9g, %.9g) and the radius %.12g, "
                  "wanted (%.9g, %.9g) and %.12g", what, c.center.x, c.center.y,
                  c.radius, x, y, radius);
}

START_TEST(few_points_are_known)
{
    // Rejects: a diameter for a radius, the first two points for the farthest.
    point at[3] = { { 1, 2 }, { 5, 5 }, { 3, 3 } };
    expect("one point", at, 1, 1, 2, 0, 0);
    expect("two points", at, 2, 3, 3.5, 2.5, ROUNDING);
    expect("two points, and one between", at, 3, 3, 3.5, 2.5, ROUNDING);
}
END_TEST

START_TEST(acute_triangle_has_all_three_on_it)
{
    // Rejects: the mean of the corners.
    point at[3] = { { -3, -4 }, { 3, -4 }, { 0, 5 } };
    expect("acute", at, 3, 0, 0, 5, ROUNDING);
}
END_TEST

START_TEST(obtuse_triangle_has_two)
{
    // Rejects: the circle through all three, which is too large.
    point at[3] = { { 0, 1 }, { -4, 0 }, { 4, 0 } };
    expect("obtuse", at, 3, 0, 0, 4, ROUNDING);
    point right[3] = { { 0, 0 }, { 6, 0 }, { 0, 8 } };
    expect("right-angled", right, 3, 3, 4, 5, ROUNDING);
}
END_TEST

START_TEST(points_in_a_line_have_two)
{
    // Rejects: a division by no area.
    point at[5] = { { 2, 2 }, { 0, 0 }, { 4, 4 }, { 1, 1 }, { 3, 3 } };
    expect("in a line", at, 5, 2, 2, sqrt(8.0), ROUNDING);
}
END_TEST

START_TEST(points_in_one_place_have_no_radius)
{
    // Rejects: a search that never ends.
    point at[4] = { { 7, 8 }, { 7, 8 }, { 7, 8 }, { 7, 8 } };
    expect("in one place", at, 4, 7, 8, 0, 0);
    point two[4] = { { 7, 8 }, { 9, 8 }, { 7, 8 }, { 9, 8 } };
    expect("in two places", two, 4, 8, 8, 1, ROUNDING);
}
END_TEST

START_TEST(nothing_and_no_number_say_so)
{
    point at[3] = { { 0, 0 }, { 1, 1 }, { 2, (real)NAN } };
    circle c = smallest_circle(at, 0);
    ck_assert_msg(c.radius < 0, "no points: got the radius %g, wanted -1",
                  c.radius);
    c = smallest_circle(at, 3);
    ck_assert_msg(c.radius != c.radius && c.center.x != c.center.x,
                  "a point is no number: got the radius %g, wanted nan",
                  c.radius);
}
END_TEST

// The smallest of all circles on two or three points that hold all of them.
static real slow_radius(const point *at, int n)
{
    real best = (real)INFINITY;
    for (int i = 0; i < n; i++)
        for (int j = i + 1; j < n; j++)
            for (int k = j; k < n; k++) {
                point p = { at[j].x - at[i].x, at[j].y - at[i].y };
                point q = { at[k].x - at[i].x, at[k].y - at[i].y };
                real D = 2 * (p.x * q.y - p.y * q.x), most = 0;
                real pp = p.x * p.x + p.y * p.y, qq = q.x * q.x + q.y * q.y;
                point c = { p.x / 2, p.y / 2 };
                if (k > j && D == 0) continue;
                if (k > j) c = (point){ (pp * q.y - qq * p.y) / D,
                                        (qq * p.x - pp * q.x) / D };
                c = (point){ at[i].x + c.x, at[i].y + c.y };
                for (int m = 0; m < n; m++)
                    most = fmax(most, distance(at[m], c));
                best = fmin(best, most);
            }
    return best;
}

START_TEST(no_smaller_circle_holds_them)
{
    // 2,000 sets of 3 to 8 points; of every second set they lie on a grid, in
    // lines and on circles.  Rejects: an old support dropped too soon, a new
    // one left out, a search that stops early.
    for (int k = 0; k < 2000; k++) {
        point at[8];
        int n = 3 + k % 6;
        for (int i = 0; i < n; i++) {
            at[i] = (point){ random_real(&seed), random_real(&seed) };
            if (k % 2)
                at[i] = (point){ floor(3 * at[i].x), floor(3 * at[i].y) };
        }
        circle c = smallest_circle(at, n);
        real radius = slow_radius(at, n);
        for (int i = 0; i < n; i++)
            ck_assert_msg(distance(at[i], c.center) <= c.radius + ROUNDING,
                          "set %d: point %d of %d is %g from the centre, and "
                          "the radius is %g", k, i, n,
                          distance(at[i], c.center), c.radius);
        ck_assert_msg(fabs(c.radius - radius) <= ROUNDING * fmax(1, radius),
                      "set %d, %d points: the radius is %.12g, and %.12g is "
                      "enough.  Is there a set of supports that was not tried?",
                      k, n, c.radius, radius);
    }
}
END_TEST

START_TEST(points_on_a_circle_are_on_it)
{
    // All alike but for rounding.  Rejects: a search that never ends, or ends
    // with a circle that leaves one out.
    for (int i = 0; i < 1000; i++)
        some[i] = (point){ cos(PI * i / 500), sin(PI * i / 500) };
    expect("on a circle", some, 1000, 0, 0, 1, ROUNDING);
}
END_TEST

START_TEST(far_from_the_origin_it_is_the_same)
{
    // Rejects: squares of the places themselves, 1e12.
    real x = 1e6 + 0.1, y = 1e6 + 0.7;
    point at[3] = { { x - 3, y - 4 }, { x + 3, y - 4 }, { x, y + 5 } };
    expect("acute, far away", at, 3, x, y, 5, FAR);
}
END_TEST

START_TEST(twenty_thousand_take_no_time)
{
    // A disc without its inside knows no shortcut.  Rejects: all triples, which
    // would take a year; a radius that is not measured at the end.
    for (int i = 0; i < MOST; i++) {
        real r = sqrt(fabs(random_real(&seed))), t = PI * random_real(&seed);
        some[i] = (point){ r * cos(t), r * sin(t) };
    }
    some[777] = (point){ 3, 4 };
    some[19999] = (point){ -3, -4 };
    expect("a disc, and two far out", some, MOST, 0, 0, 5, ROUNDING);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        few_points_are_known,
        acute_triangle_has_all_three_on_it,
        obtuse_triangle_has_two,
        points_in_a_line_have_two,
        points_in_one_place_have_no_radius,
        nothing_and_no_number_say_so,
        no_smaller_circle_holds_them,
        points_on_a_circle_are_on_it,
        far_from_the_origin_it_is_the_same,
        twenty_thousand_take_no_time,
        NULL
    };
    return suite_run((suite){ .name = "circle", .tests = tests });
}
