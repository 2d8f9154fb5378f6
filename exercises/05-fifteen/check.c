// check.c - tests of the exercise 05/fifteen.

#include "fifteen.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>

// Some dozen roundings of numbers up to 10.
static const real ROUNDING = 1e-13;

static void expect(const box *a, const box *b, real depth, vec3 normal,
                   int direction, const char *what)
{
    fifteen_result r = boxes_depth(a, b);
    near(r.depth, depth, ROUNDING, what);
    ck_assert_msg(vec3_distance(r.normal, normal) <= ROUNDING,
                  "%s: the normal is (%g, %g, %g), wanted (%g, %g, %g)", what,
                  r.normal.x, r.normal.y, r.normal.z, normal.x, normal.y,
                  normal.z);
    ck_assert_msg(r.direction == direction, "%s: it was direction %d, wanted "
                  "%d", what, r.direction, direction);
}

static box upright(vec3 centre, vec3 half)
{
    return (box){ centre, { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } }, half };
}

// Turned about axis k by an angle with this sine and cosine.
static void turn(box *x, int k, real sine, real cosine)
{
    int i = (k + 1) % 3, j = (k + 2) % 3;
    vec3 u = x->axis[i], v = x->axis[j];
    x->axis[i] = vec3_add_scaled(vec3_scale(cosine, u), sine, v);
    x->axis[j] = vec3_add_scaled(vec3_scale(cosine, v), -sine, u);
}

static unsigned long long seed = 15;

static box random_box(void)
{
    vec3 c = random_vec3(&seed, 1), h = random_vec3(&seed, 1);
    box x = upright(c, (vec3){ 1.2 + h.x, 1.2 + h.y, 1.2 + h.z });
    for (int k = 0; k < 3; k++) {
        real angle = 3 * random_real(&seed);
        turn(&x, k, sin(angle), cos(angle));
    }
    return x;
}

static hull corners(const box *x, vec3 at[8])
{
    for (int i = 0; i < 8; i++) {
        vec3 p = x->centre;
        p = vec3_add_scaled(p, i & 1 ? x->half.x : -x->half.x, x->axis[0]);
        p = vec3_add_scaled(p, i & 2 ? x->half.y : -x->half.y, x->axis[1]);
        at[i] = vec3_add_scaled(p, i & 4 ? x->half.z : -x->half.z, x->axis[2]);
    }
    return (hull){ at, 8 };
}

START_TEST(box_on_a_box)
{
    // All edges are parallel: nine directions that are none.  Rejects: the zero
    // vector as a direction, a sign, the greatest instead of the least.
    box a = upright((vec3){ 0.5, 2.75, 0 }, (vec3){ 1, 1, 1 });
    box b = upright((vec3){ 0, 0, 0 }, (vec3){ 2, 2, 2 });
    expect(&a, &b, 0.25, (vec3){ 0, 1, 0 }, 1, "upper box against lower");
    expect(&b, &a, 0.25, (vec3){ 0, -1, 0 }, 1, "lower box against upper");
    a.centre = (vec3){ -2.5, 0, 0 };
    expect(&a, &b, 0.5, (vec3){ -1, 0, 0 }, 0, "a box at the left");
}
END_TEST

START_TEST(boxes_apart_have_a_negative_depth)
{
    box a = upright((vec3){ 0, 0, 5 }, (vec3){ 1, 1, 1 });
    box b = upright((vec3){ 0, 0, 0 }, (vec3){ 2, 2, 2 });
    expect(&a, &b, -2, (vec3){ 0, 0, 1 }, 2, "2 m apart");
}
END_TEST

START_TEST(small_box_turned_on_a_large_one)
{
    // Turned about z so that its lower corner points down: with 3, 4, 5 it
    // reaches down by 0.6 * 1 + 0.8 * 1 = 1.4.  Rejects: the reach along a
    // single edge; A's faces alone.
    box a = upright((vec3){ 0, 3.25, 0 }, (vec3){ 1, 1, 1 });
    box b = upright((vec3){ 0, 0, 0 }, (vec3){ 5, 2, 5 });
    turn(&a, 2, 0.6, 0.8);
    expect(&a, &b, 0.15, (vec3){ 0, 1, 0 }, 4, "a box on its edge");
    expect(&b, &a, 0.15, (vec3){ 0, -1, 0 }, 1, "the same, exchanged");
}
END_TEST

START_TEST(crossed_beams_touch_edge_on_edge)
{
    // Two square beams, one along x, one along z, each turned about itself by
    // 45 degrees, so that an edge points at the other.  Each reaches sqrt(2).
    // Rejects: six directions and no edges.
    box a = upright((vec3){ 0, 2.75, 0 }, (vec3){ 9, 1, 1 });
    box b = upright((vec3){ 0, 0, 0 }, (vec3){ 1, 1, 9 });
    turn(&a, 0, sqrt(0.5), sqrt(0.5));
    turn(&b, 2, sqrt(0.5), sqrt(0.5));
    fifteen_result r = boxes_depth(&a, &b);
    near(r.depth, 2 * sqrt(2.0) - 2.75, ROUNDING, "depth of crossed beams");
    near(r.normal.y, 1, ROUNDING, "y of the normal");
    ck_assert_msg(r.direction == 6 + 3 * 0 + 2, "edge 0 of A against edge 2 of "
                  "B is direction 8, got %d", r.direction);
}
END_TEST

START_TEST(box_in_its_own_place)
{
    box a = upright((vec3){ 3, 3, 3 }, (vec3){ 2, 1, 3 });
    fifteen_result r = boxes_depth(&a, &a);
    near(r.depth, 2, ROUNDING, "depth of a box in itself");
    near(fabs(r.normal.y), 1, ROUNDING, "y of the normal, either way");
}
END_TEST

START_TEST(edges_that_are_nearly_parallel_do_no_harm)
{
    // Turned by 1e-3, 1e-4, ... 1e-17: the cross products of nearly parallel
    // edges are short, and in the end only rounding.
    real angle = 1e-3;
    for (int k = 3; k <= 17; k++) {
        box a = upright((vec3){ 0.5, 2.75, 0.25 }, (vec3){ 1, 1, 1 });
        box b = upright((vec3){ 0, 0, 0 }, (vec3){ 2, 2, 2 });
        turn(&a, 0, sin(angle), cos(angle));
        turn(&a, 2, sin(angle), cos(angle));
        fifteen_result r = boxes_depth(&a, &b);
        ck_assert_msg(fabs(r.depth - 0.25) < 3 * angle + ROUNDING, "turned by "
                      "%g: depth %.12g, wanted nearly 0.25", angle, r.depth);
        near(vec3_length(r.normal), 1, ROUNDING, "length of the normal");
        angle /= 10;
    }
}
END_TEST

START_TEST(long_beams_cross_at_a_small_angle)
{
    // Edge on edge, as above, but nearly side by side, and the longer the
    // smaller the angle.  Rejects: crossings left out because their edges are
    // parallel to a few degrees.
    for (real angle = 0.1; angle > 5e-4; angle /= 10) {
        box a = upright((vec3){ 0, 2.75, 0 }, (vec3){ 0.9 / angle, 1, 1 });
        box b = upright((vec3){ 0, 0, 0 }, (vec3){ 0.9 / angle, 1, 1 });
        turn(&a, 1, sin(angle), cos(angle));
        turn(&a, 0, sqrt(0.5), sqrt(0.5));
        turn(&b, 0, sqrt(0.5), sqrt(0.5));
        fifteen_result r = boxes_depth(&a, &b);
        ck_assert_msg(fabs(r.depth - (2 * sqrt(2.0) - 2.75)) < 1e-9, "beams "
                      "that cross at %g rad: depth %.12g, wanted %.12g", angle,
                      r.depth, 2 * sqrt(2.0) - 2.75);
        ck_assert_msg(r.direction == 6, "edge 0 of A against edge 0 of B is "
                      "direction 6, got %d", r.direction);
    }
}
END_TEST

START_TEST(random_boxes_agree_with_the_hit_face)
{
    // Rejects: cross products that are not normalised.
    int edges = 0, apart = 0;
    for (int k = 0; k < 1000; k++) {
        box a = random_box(), b = random_box();
        vec3 p[8], q[8];
        hull pa = corners(&a, p), pb = corners(&b, q);
        gjk_result g = gjk_distance(pa, pb, HUGE_VAL, NULL);
        fifteen_result r = boxes_depth(&a, &b);
        near(vec3_length(r.normal), 1, ROUNDING, "length of the normal");
        if (g.status == GJK_APART) {
            apart++;
            ck_assert_msg(r.depth < 0 && -r.depth <= g.distance + ROUNDING,
                          "%g m apart, and the depth is %g", g.distance,
                          r.depth);
            continue;
        }
        edges += r.direction >= 6;
        hit_result h = hit_face_find(pa, pb, &g.last);
        near(r.depth, h.depth, ROUNDING, "depth, as the hit face has it");
        a.centre = vec3_add_scaled(a.centre, r.depth, r.normal);
        near(boxes_depth(&a, &b).depth, 0, ROUNDING,
             "depth after moving A out by it");
    }
    ck_assert_msg(edges > 100 && apart > 20, "%d by edges, %d apart: every "
                  "kind is to be tried", edges, apart);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        box_on_a_box,
        boxes_apart_have_a_negative_depth,
        small_box_turned_on_a_large_one,
        crossed_beams_touch_edge_on_edge,
        box_in_its_own_place,
        edges_that_are_nearly_parallel_do_no_harm,
        long_beams_cross_at_a_small_angle,
        random_boxes_agree_with_the_hit_face,
        NULL
    };
    return suite_run((suite){ .name = "fifteen", .tests = tests });
}
