// check_rounding.c - hulls with a radius: weight, size and what is drawn.
// Book: chapter 13.

#include "rounding.h"
#include "capsule.h"
#include "expect.h"
#include "gjk.h"
#include "hull.h"
#include "random.h"
#include "suite.h"

#include <math.h>

static const real PI = 3.14159265358979323846;

static void inertia_of(const shape *s, vec3 *center, real m[3][3])
{
    rigid_solid q = rigid4_solid(s);
    *center = q.center;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) m[i][j] = q.spread[i][j];
}

// Of each part of a rounded box, by its symmetry, the mean of x^2: slabs and
// box, quarters of cylinders, eighths of a ball.
static real mean_square(vec3 h, real r)
{
    real x = h.x, y = h.y, z = h.z;
    real box = 8 * x * y * z, ends = 8 * y * z * r;
    real sides = 8 * x * r * (y + z);
    real rods = 2 * x * PI * r * r, beams = 2 * (y + z) * PI * r * r;
    real ball = 4 * PI * r * r * r / 3;
    real off = 4 * r / (3 * PI);    // centre of a half disc
    real sum = box * x * x / 3 + sides * x * x / 3 + rods * x * x / 3;
    sum += ends * (pow(x + r, 3) - x * x * x) / (3 * r);
    sum += beams * (x * x + 2 * x * off + r * r / 4);
    sum += ball * (x * x + 2 * x * 3 * r / 8 + r * r / 5);
    return sum / (box + ends + sides + rods + beams + ball);
}

// Rejects: the inertia of the core, or of the box around it; slabs whose middle
// is in the face; a part of a cylinder or ball that is taken for a point.
START_TEST(rounded_box_has_the_inertia_of_its_parts)
{
    for (int k = 0; k < 20; k++) {
        vec3 h = { .5, .3, .2 }, c;
        real r = .001 * pow(1.7, k), m[3][3];
        shape box, s;
        expect_ok(shape_box(&box, vec3_scale(2, h), 3));
        expect_ok(shape_round(&s, &box, r));
        inertia_of(&s, &c, m);
        near_relative(m[0][0], mean_square(h, r), 1e-12);
        near_relative(m[1][1], mean_square((vec3){ h.y, h.z, h.x }, r), 1e-12);
        near_relative(m[2][2], mean_square((vec3){ h.z, h.x, h.y }, r), 1e-12);
        near(fabs(m[0][1]) + fabs(m[0][2]) + fabs(m[1][2]), 0, 1e-13);
        near(rigid4_mass(&s), 3, 1e-13);
        near_relative(s.radius, vec3_length(h) + r, 1e-13);
        ck_assert(s.round == r && s.mesh.faces == 12);
        shape_free(&s);
        shape_free(&box);
    }
}
END_TEST

// Rejects: corners whose parts of the sphere are not the whole of it.
START_TEST(large_radius_makes_a_ball)
{
    unsigned long long state = 7;
    for (int k = 0; k < 10; k++) {
        vec3 at[12], c;
        real m[3][3], r = 1e5;
        for (int i = 0; i < 12; i++) at[i] = random_vec3(&state, 1);
        shape core, s;
        expect_ok(shape_hull(&core, at, 12, 1));
        expect_ok(shape_round(&s, &core, r));
        inertia_of(&s, &c, m);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                near(m[i][j] / (r * r), i == j ? .2 : 0, 1e-4);
        shape_free(&s);
        shape_free(&core);
    }
}
END_TEST

// A thin wedge, whose three long edges are round by angles that are not alike,
// is a capsule (check_round has the formula).  Rejects: an arc whose part of
// u u^T is that of a quarter of a circle.
START_TEST(thin_wedge_has_the_inertia_of_a_capsule)
{
    const real thin = 1e-7, length = .8, r = .3;
    vec3 at[6], c;
    real m[3][3], rod = length, balls = 4 * r / 3, half = length / 2;
    for (int k = 0; k < 6; k++)
        at[k] = vec3_make(thin * (k % 3 == 0 ? 3 : k % 3 == 1 ? -1 : -.5),
                          k < 3 ? half : -half, thin * (k % 3 - 1));
    // A wedge so thin is no hull of points (hull.h): its faces are given.
    const int face[8][3] = {
        { 0, 1, 2 }, { 3, 5, 4 }, { 0, 4, 1 }, { 0, 3, 4 },
        { 1, 5, 2 }, { 1, 4, 5 }, { 2, 3, 0 }, { 2, 5, 3 }
    };
    shape core, s;
    expect_ok(shape_convex(&core, 6, at, 8, face, 1));
    expect_ok(shape_round(&s, &core, r));
    inertia_of(&s, &c, m);
    real across = (rod * r * r / 4 + balls * r * r / 5) / (rod + balls);
    real along = (rod * half * half / 3
                  + balls * (half * half + .75 * half * r + r * r / 5))
               / (rod + balls);
    near_relative(m[0][0], across, 1e-5);
    near_relative(m[1][1], along, 1e-5);
    near_relative(m[2][2], across, 1e-5);
    near(m[0][2], 0, 1e-5);
    shape_free(&s);
    shape_free(&core);
}
END_TEST

// m, from x to a hull: 0 inside.
static real distance_to(const shape *s, vec3 x)
{
    gjk_result g = gjk_distance((hull){ &x, 1 }, (hull){ s->at, s->particles },
                                HUGE_VAL, NULL);
    return g.status == GJK_OVERLAP ? 0 : g.distance;
}

// Of points on a fine grid those that are no further from the hull than the
// radius are counted.  Rejects: any part of the sum with a wrong weight.
START_TEST(centre_and_inertia_are_those_of_all_points_near_the_hull)
{
    enum { N = 100 };
    // No face along the grid, whose points it would gain or lose together.
    vec3 at[5] = { { 0, .1, .07 }, { 1, .13, -.1 }, { -.08, .8, 0 },
                   { .2, .1, .7 }, { 1.1, .6, .2 } }, c, sum = { 0, 0, 0 };
    real m[3][3], seen[3][3] = { { 0 } }, r = .3;
    int n = 0;
    shape core, s;
    expect_ok(shape_hull(&core, at, 5, 1));
    expect_ok(shape_round(&s, &core, r));
    inertia_of(&s, &c, m);
    ck_assert(vec3_length(c) == 0);
    for (int i = 0; i < N * N * N; i++) {
        vec3 x = { i % N + .5, i / N % N + .5, i / N / N + .5 };
        x = vec3_scale(s.radius,
                       vec3_sub(vec3_scale(2.0 / N, x), vec3_make(1, 1, 1)));
        if (distance_to(&s, x) > r) continue;
        const real y[3] = { x.x, x.y, x.z };
        for (int j = 0; j < 9; j++) seen[j / 3][j % 3] += y[j / 3] * y[j % 3];
        sum = vec3_add(sum, x);
        n++;
    }
    near_vec3(vec3_scale(1.0 / n, sum), c, 6e-4);
    for (int j = 0; j < 9; j++)
        near(seen[j / 3][j % 3] / n, m[j / 3][j % 3], 6e-4);
    shape_free(&s);
    shape_free(&core);
}
END_TEST

// Rejects: a skin about the hull's own centre; one that leaves out an edge.
START_TEST(skin_lies_on_the_surface_and_spans_it)
{
    vec3 at[4] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, .8, 0 }, { .2, .1, .7 } };
    shape core, s;
    expect_ok(shape_hull(&core, at, 4, 1));
    expect_ok(shape_round(&s, &core, .2));
    struct skin k = shape_skin(&s);
    ck_assert_int_gt(k.points, 4 * 3);
    for (int i = 0; i < k.points; i++)
        near(distance_to(&s, k.at[i]), .2, 1e-9);
    for (int f = 0; f < k.faces; f++) {
        const int *v = &k.face[3 * f];
        vec3 sum = vec3_add(k.at[v[0]], vec3_add(k.at[v[1]], k.at[v[2]]));
        real far = distance_to(&s, vec3_scale(1.0 / 3, sum));
        ck_assert_msg(far > .2 * .9 && far < .2 * 1.000001, "%g", far);
    }
    shape_free(&s);
    shape_free(&core);
}
END_TEST

START_TEST(what_has_no_faces_or_no_radius_is_refused)
{
    shape box, ball, s;
    expect_ok(shape_box(&box, vec3_make(1, 1, 1), 1));
    expect_ok(shape_sphere(&ball, 1, 1));
    expect_why(shape_round(&s, &ball, 1),
               "only a rigid shape with faces can be rounded");
    const real wrong[] = { 0, -1, NAN, HUGE_VAL };
    for (int k = 0; k < COUNT(wrong); k++)
        ck_assert(!shape_round(&s, &box, wrong[k]).ok);
    ck_assert(!s.at && !s.skin.at);
    shape_free(&box);
    shape_free(&ball);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        rounded_box_has_the_inertia_of_its_parts,
        large_radius_makes_a_ball,
        thin_wedge_has_the_inertia_of_a_capsule,
        centre_and_inertia_are_those_of_all_points_near_the_hull,
        skin_lies_on_the_surface_and_spans_it,
        what_has_no_faces_or_no_radius_is_refused,
        NULL
    };
    return suite_run((suite){ .name = "rounding", .tests = tests });
}
