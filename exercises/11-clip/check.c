// check.c - tests of the exercise 11/clip.

#include "clip.h"
#include "random.h"
#include "suite.h"

#include <check.h>

// Some dozen roundings of numbers up to 10.
static const real ROUNDING = 1e-13;

// m^2, from corner 0: far away nothing is lost.
static real area(const polygon *p)
{
    real sum = 0;
    for (int k = 1; k + 1 < p->count; k++)
        sum += vec3_cross(vec3_sub(p->at[k], p->at[0]),
                          vec3_sub(p->at[k + 1], p->at[0])).z;
    return sum / 2;
}

static polygon box(real x, real y, real width, real height)
{
    real right = x + width, top = y + height;
    return (polygon){ 4, { { x, y, 0 }, { right, y, 0 }, { right, top, 0 },
                           { x, top, 0 } } };
}

static void expect(const char *what, const polygon *p, int count, real wanted)
{
    ck_assert_msg(p->count == count, "%s: got %d corners, wanted %d", what,
                  p->count, count);
    ck_assert_msg(fabs(area(p) - wanted) <= ROUNDING, "%s: got an area of "
                  "%.15g m^2, wanted %.15g", what, area(p), wanted);
    for (int k = 0; k < p->count; k++)
        ck_assert_msg(vec3_distance(p->at[k], p->at[(k + 1) % p->count]) > 0,
                      "%s: corners %d and the next are at one place", what, k);
}

// A triangle anyhow, counter-clockwise; the same on every machine.
static polygon any_triangle(void)
{
    static unsigned long long seed = 23;
    polygon p = { 3, { { 0, 0, 0 } } };
    for (int k = 0; k < 3; k++) {
        real *c[2] = { &p.at[k].x, &p.at[k].y };
        for (int i = 0; i < 2; i++) {
            *c[i] = random_real(&seed);
        }
    }
    if (area(&p) < 0) {
        vec3 first = p.at[0];
        p.at[0] = p.at[1];
        p.at[1] = first;
    }
    return p;
}

START_TEST(half_of_a_square_is_left)
{
    // Rejects: the other half; a crossing measured from the wrong end; a last
    // edge that nobody looks at.
    polygon p = box(0, 0, 4, 2), r;
    r = clip_line(&p, (vec3){ 1, 0, 0 }, (vec3){ 1, 7, 0 });
    expect("left of x = 1", &r, 4, 2);
    r = clip_line(&p, (vec3){ 1, 7, 0 }, (vec3){ 1, 0, 0 });
    expect("right of x = 1", &r, 4, 6);
    r = clip_line(&p, (vec3){ 0, 0.5, 0 }, (vec3){ 1, 0.5, 0 });
    expect("above y = 1/2", &r, 4, 6);
    r = clip_line(&p, (vec3){ 5, 1, 0 }, (vec3){ 5, 3, 0 });
    expect("left of all", &r, 4, 8);
    r = clip_line(&p, (vec3){ 5, 3, 0 }, (vec3){ 5, 1, 0 });
    expect("right of all", &r, 0, 0);
}
END_TEST

START_TEST(line_through_corners_finds_them_once)
{
    // Rejects: a corner on the line that is lost, or kept and crossed as well.
    polygon p = box(0, 0, 2, 2), r;
    r = clip_line(&p, (vec3){ 0, 0, 0 }, (vec3){ 2, 2, 0 });
    expect("above the diagonal", &r, 3, 2);
    r = clip_line(&p, (vec3){ 0, 0, 0 }, (vec3){ 1, 2, 0 });
    expect("left of a line from a corner", &r, 3, 1);
    r = clip_line(&p, (vec3){ 0, 0, 0 }, (vec3){ 1, 0, 0 });
    expect("above its own lower side", &r, 4, 4);
    r = clip_line(&p, (vec3){ 1, 0, 0 }, (vec3){ 0, 0, 0 });
    expect("below its own lower side", &r, 0, 0);
}
END_TEST

START_TEST(what_overlaps_is_left)
{
    // Rejects: one side of q left out, or only one asked.
    polygon p = box(0, 0, 2, 2), q = box(1, 0.5, 3, 1), r;
    r = clip_polygon(&p, &q);
    expect("two boxes", &r, 4, 1);
    q = box(0.5, 0.5, 1, 1);
    r = clip_polygon(&p, &q);
    expect("one inside the other", &r, 4, 1);
    r = clip_polygon(&q, &p);
    expect("and the other around it", &r, 4, 1);
    q = box(-3, 0.5, 9, 1);
    r = clip_polygon(&p, &q);
    expect("a cross", &r, 4, 2);
    r = clip_polygon(&p, &p);
    expect("with itself", &r, 4, 4);
    q = box(5, 5, 1, 1);
    r = clip_polygon(&p, &q);
    expect("apart", &r, 0, 0);
}
END_TEST

START_TEST(square_on_a_turned_square_shares_an_octagon)
{
    // Of side 2: eight triangles of height 1 and base 2 (sqrt 2 - 1).
    real d = sqrt(2);
    polygon p = box(-1, -1, 2, 2), r;
    polygon q = { 4, { { d, 0, 0 }, { 0, d, 0 }, { -d, 0, 0 }, { 0, -d, 0 } } };
    r = clip_polygon(&p, &q);
    expect("an octagon", &r, 8, 8 * (d - 1));
    r = clip_polygon(&q, &p);
    expect("the same", &r, 8, 8 * (d - 1));
}
END_TEST

START_TEST(what_only_touches_shares_nothing)
{
    // Rejects: polygons of one corner or two.
    polygon p = box(0, 0, 2, 2), q = box(2, 0, 2, 2), r = clip_polygon(&p, &q);
    expect("side by side", &r, 0, 0);
    q = box(2, 2, 1, 1);
    r = clip_polygon(&p, &q);
    expect("corner on corner", &r, 0, 0);
    q = (polygon){ 3, { { 1, 2, 0 }, { 2, 3, 0 }, { 0, 3, 0 } } };
    r = clip_polygon(&p, &q);
    expect("a corner on a side", &r, 0, 0);
}
END_TEST

START_TEST(no_line_and_no_polygon)
{
    // Rejects: 0 / 0; what is cut with nothing and stays.
    polygon p = box(0, 0, 2, 2), none = { .count = 0 }, r;
    r = clip_line(&p, (vec3){ 1, 1, 0 }, (vec3){ 1, 1, 0 });
    expect("no line", &r, 4, 4);
    r = clip_polygon(&p, &none);
    expect("with nothing", &r, 0, 0);
    r = clip_polygon(&none, &p);
    expect("nothing", &r, 0, 0);
}
END_TEST

START_TEST(two_halves_make_the_whole)
{
    // And what is cut from p and from q alike does not depend on which is cut.
    for (int k = 0; k < 1000; k++) {
        polygon p = any_triangle(), q = any_triangle();
        polygon left = clip_line(&p, q.at[0], q.at[1]);
        polygon right = clip_line(&p, q.at[1], q.at[0]);
        ck_assert_msg(fabs(area(&left) + area(&right) - area(&p)) < ROUNDING,
                      "triangle %d: its halves are %g and %g, the whole %g", k,
                      area(&left), area(&right), area(&p));
        polygon pq = clip_polygon(&p, &q), qp = clip_polygon(&q, &p);
        ck_assert_msg(fabs(area(&pq) - area(&qp)) < 1e-9, "pair %d: p cut with "
                      "q leaves %g, q cut with p %g", k, area(&pq), area(&qp));
        ck_assert(area(&pq) <= area(&p) + ROUNDING);
        ck_assert(area(&pq) >= -ROUNDING);
    }
}
END_TEST

START_TEST(dents_are_cut_rightly)
{
    // A U of 3 by 3, with a slot of 1 by 2 from above: 7.  Below y = 2 it is 5,
    // above y = 2 two towers of 1.
    polygon u = { 8, { { 0, 0, 0 }, { 3, 0, 0 }, { 3, 3, 0 }, { 2, 3, 0 },
                       { 2, 1, 0 }, { 1, 1, 0 }, { 1, 3, 0 }, { 0, 3, 0 } } };
    polygon r = clip_line(&u, (vec3){ 3, 2, 0 }, (vec3){ 0, 2, 0 });
    expect("the lower part", &r, 8, 5);
    r = clip_line(&u, (vec3){ 0, 2, 0 }, (vec3){ 3, 2, 0 });
    ck_assert_msg(fabs(area(&r) - 2) < ROUNDING, "two towers: got %g, wanted 2",
                  area(&r));
    polygon b = box(0.5, 1.5, 2, 1);
    r = clip_polygon(&u, &b);
    ck_assert_msg(fabs(area(&r) - 1) < ROUNDING, "two pieces: got %g, wanted 1",
                  area(&r));
}
END_TEST

START_TEST(nothing_is_lost_far_away)
{
    // Rejects: cross products of the places themselves.
    real far = 0x1p40;
    polygon p = box(far, far, 2, 2), q = box(far + 1, far - 1, 4, 2.5), r;
    r = clip_polygon(&p, &q);
    expect("far away", &r, 4, 1.5);
}
END_TEST

START_TEST(room_is_not_exceeded)
{
    // A saw of as many corners as there is room for; a cut through its teeth
    // makes more.
    struct { polygon p; real guard[8]; } m = { .guard = { 7 } };
    polygon saw = { .count = CLIP_MOST };
    for (int k = 0; k < CLIP_MOST; k++)
        saw.at[k] = (vec3){ CLIP_MOST - k, k % 2 ? 2 : 0, 0 };
    saw.at[0] = (vec3){ 0, -5, 0 };
    saw.at[1] = (vec3){ CLIP_MOST, -5, 0 };
    m.p = clip_line(&saw, (vec3){ 9, 1, 0 }, (vec3){ 0, 1, 0 });
    ck_assert_msg(m.p.count <= CLIP_MOST, "%d corners, and room for %d",
                  m.p.count, CLIP_MOST);
    ck_assert(m.guard[0] == 7);
}
END_TEST

START_TEST(corner_that_is_no_number_is_left_out)
{
    polygon p = { 5, { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 },
                       { (real)NAN, 1, 0 }, { 0, 2, 0 } } };
    polygon q = box(-1, -1, 2, 9), r = clip_polygon(&p, &q);
    for (int k = 0; k < r.count; k++)
        ck_assert_msg(vec3_is_finite(r.at[k]), "corner %d is (%g, %g)", k,
                      r.at[k].x, r.at[k].y);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        half_of_a_square_is_left,
        line_through_corners_finds_them_once,
        what_overlaps_is_left,
        square_on_a_turned_square_shares_an_octagon,
        what_only_touches_shares_nothing,
        no_line_and_no_polygon,
        two_halves_make_the_whole,
        dents_are_cut_rightly,
        nothing_is_lost_far_away,
        room_is_not_exceeded,
        corner_that_is_no_number_is_left_out,
        NULL
    };
    return suite_run((suite){ .name = "clip", .tests = tests });
}
