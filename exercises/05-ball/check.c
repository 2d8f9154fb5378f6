// check.c - tests of the exercise 05/ball.

#include "ball.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdio.h>

// A dozen roundings of numbers up to 10.
static const real ROUNDING = 1e-14;

static const vec3 HALF = { 1, 2, 3 };           // m

static void expect(vec3 centre, real radius, real gap, vec3 normal, vec3 on_box)
{
    ball_contact c = ball_meets_box(HALF, centre, radius);
    char where[80];
    snprintf(where, sizeof where, "ball of %g m at (%g, %g, %g), its ", radius,
             centre.x, centre.y, centre.z);
    char what[120];
    snprintf(what, sizeof what, "%sgap", where);
    near(c.gap, gap, ROUNDING, what);
    snprintf(what, sizeof what, "%snormal", where);
    near_vec3(c.normal, normal, ROUNDING, what);
    snprintf(what, sizeof what, "%snearest point of the box", where);
    near_vec3(c.on_box, on_box, ROUNDING, what);
}

static unsigned long long seed = 5;

START_TEST(ball_above_a_face)
{
    // Apart, touching, and overlapping with the centre still outside.
    // Rejects: a normal that is not normalised, or looks at the box.
    vec3 up = { 0, 1, 0 }, on = { 0.5, 2, -1 };
    expect((vec3){ 0.5, 4, -1 }, 0.5, 1.5, up, on);
    expect((vec3){ 0.5, 2.5, -1 }, 0.5, 0, up, on);
    expect((vec3){ 0.5, 2.25, -1 }, 0.5, -0.25, up, on);
    expect((vec3){ -4, 0, 0 }, 1, 2, (vec3){ -1, 0, 0 }, (vec3){ -1, 0, 0 });
}
END_TEST

START_TEST(ball_beside_an_edge_and_a_corner)
{
    // Rejects: a box with six normals and no others.
    expect((vec3){ 4, 6, 1 }, 1, 4, (vec3){ 0.6, 0.8, 0 }, (vec3){ 1, 2, 1 });
    expect((vec3){ -2, -4, -5 }, 0.5, 2.5,
           (vec3){ -1.0 / 3, -2.0 / 3, -2.0 / 3 }, (vec3){ -1, -2, -3 });
}
END_TEST

START_TEST(centre_inside_leaves_by_the_nearest_face)
{
    // Half edges 1, 2, 3.  Rejects: the way inwards, the far side, the axis of
    // the largest coordinate, a gap that grows as the centre sinks in.
    expect((vec3){ 0.75, 1, -1 }, 0.5, -0.75, (vec3){ 1, 0, 0 },
           (vec3){ 1, 1, -1 });
    expect((vec3){ -0.75, 1, -1 }, 0, -0.25, (vec3){ -1, 0, 0 },
           (vec3){ -1, 1, -1 });
    expect((vec3){ 0.5, -1.75, 2 }, 0.25, -0.5, (vec3){ 0, -1, 0 },
           (vec3){ 0.5, -2, 2 });
    expect((vec3){ 0.5, 1.25, -2.625 }, 1, -1.375, (vec3){ 0, 0, -1 },
           (vec3){ 0.5, 1.25, -3 });
    expect((vec3){ 0.5, 1.25, 0 }, 1, -1.5, (vec3){ 1, 0, 0 },
           (vec3){ 1, 1.25, 0 });
}
END_TEST

START_TEST(middle_of_the_box_has_a_way_out)
{
    // The shortest half edge, positive side; in a cube all three are equal.
    // Rejects: a normal without length.
    expect((vec3){ 0, 0, 0 }, 0.5, -1.5, (vec3){ 1, 0, 0 }, (vec3){ 1, 0, 0 });
    ball_contact c = ball_meets_box((vec3){ 1, 1, 1 }, (vec3){ 0, 0, 0 }, 0);
    near_vec3(c.normal, (vec3){ 1, 0, 0 }, ROUNDING,
              "middle of a cube, normal");
}
END_TEST

START_TEST(centre_on_the_surface_has_a_normal)
{
    // Rejects: 0 / 0 where outside and inside meet.
    expect((vec3){ 0.25, -2, 1 }, 0.5, -0.5, (vec3){ 0, -1, 0 },
           (vec3){ 0.25, -2, 1 });
    ball_contact c = ball_meets_box(HALF, HALF, 0.5);
    near(c.gap, -0.5, ROUNDING, "centre on a corner, gap");
    near(vec3_length(c.normal), 1, ROUNDING,
         "centre on a corner, length of the normal");
}
END_TEST

START_TEST(nothing_jumps_when_the_centre_goes_in)
{
    // The ball goes down through the upper face, a centimetre at a time: so the
    // gap shrinks by a centimetre at a time.
    for (int k = 0; k <= 100; k++) {
        real y = 2.5 - 0.01 * k;
        ball_contact c = ball_meets_box(HALF, (vec3){ 0, y, 0 }, 0.75);
        char what[60];
        snprintf(what, sizeof what, "centre at y = %g, gap", y);
        near(c.gap, y - 2 - 0.75, ROUNDING, what);
    }
}
END_TEST

START_TEST(gjk_and_the_hit_face_agree)
{
    // Their ball is a point: a radius changes nothing but the gap.
    vec3 at[8];
    for (int i = 0; i < 8; i++)
        at[i] = (vec3){ i & 1 ? HALF.x : -HALF.x, i & 2 ? HALF.y : -HALF.y,
                        i & 4 ? HALF.z : -HALF.z };
    hull box = { at, 8 };
    for (int k = 0; k < 1000; k++) {
        real x = 1.5 * random_real(&seed), y = 3 * random_real(&seed);
        vec3 c = { x, y, 4 * random_real(&seed) };
        hull point = { &c, 1 };
        gjk_result g = gjk_distance(point, box, HUGE_VAL, NULL);
        real gap = g.distance;
        vec3 normal = vec3_unit(g.axis), on = g.on_b;
        if (g.status == GJK_OVERLAP) {
            hit_result h = hit_face_find(point, box, &g.last);
            gap = -h.depth;
            normal = h.normal;
            on = h.on_b;
        }
        expect(c, 0, gap, normal, on);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        ball_above_a_face,
        ball_beside_an_edge_and_a_corner,
        centre_inside_leaves_by_the_nearest_face,
        middle_of_the_box_has_a_way_out,
        centre_on_the_surface_has_a_normal,
        nothing_jumps_when_the_centre_goes_in,
        gjk_and_the_hit_face_agree,
        NULL
    };
    return suite_run((suite){ .name = "ball", .tests = tests });
}
