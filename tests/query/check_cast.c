// check_cast.c - tests of lib/query/cast: what does a ray, or a body that goes
// straight, meet first, and where?

#include "cast.h"
#include "axes.h"
#include "expect.h"
#include "suite.h"

#include <check.h>
#include <math.h>

// Of coordinates of a few metres: a hundred times what cast.h promises.
static const real fine = 1e-10;

static const vec3 cube[8] = {
    { -1, -1, -1 }, { 1, -1, -1 }, { -1, 1, -1 }, { 1, 1, -1 },
    { -1, -1,  1 }, { 1, -1,  1 }, { -1, 1,  1 }, { 1, 1,  1 } };
static const rounded block = { { cube, 8 }, 0, 0 };

static const vec3 middle = { 0, 0, 0 };
static const rounded ball = { { &middle, 1 }, 2, 0 };

static const vec3 ends[2] = { { 0, -3, 0 }, { 0, 3, 0 } };
static const rounded capsule = { { ends, 2 }, 1, 0 };

static cast_result ray(vec3 from, vec3 to, rounded b)
{
    vec3 scratch[16];
    return cast_first((rounded){ { &from, 1 }, 0, 0 }, vec3_sub(to, from), b,
                      scratch);
}

START_TEST(a_ray_meets_the_face_in_front)
{
    cast_result r = ray((vec3){ -5, .25, .5 }, (vec3){ 3, .25, .5 }, block);
    ck_assert(r.hits);
    near(r.fraction, 0.5, fine);
    near_vec3(r.point, (vec3){ -1, .25, .5 }, fine);
    near_vec3(r.normal, (vec3){ -1, 0, 0 }, fine);
}
END_TEST

START_TEST(a_ray_that_ends_before_or_passes_beside_meets_nothing)
{
    ck_assert(!ray((vec3){ -5, 0, 0 }, (vec3){ -1.001, 0, 0 }, block).hits);
    ck_assert(!ray((vec3){ -5, 1.001, 0 }, (vec3){ 5, 1.001, 0 }, block).hits);
    ck_assert(!ray((vec3){ 5, 0, 0 }, (vec3){ 9, 0, 0 }, block).hits);
    ck_assert(!ray((vec3){ -5, 2.001, 0 }, (vec3){ 5, 2.001, 0 }, ball).hits);
}
END_TEST

// A ball of radius 2 at the origin, a ray at height 1.2: x = -1.6.
START_TEST(a_ray_meets_a_ball_where_the_quadratic_says)
{
    cast_result r = ray((vec3){ -4, 1.2, 0 }, (vec3){ 4, 1.2, 0 }, ball);
    ck_assert(r.hits);
    near(r.fraction, 0.3, fine);
    near_vec3(r.point, (vec3){ -1.6, 1.2, 0 }, fine);
    near_vec3(r.normal, (vec3){ -.8, .6, 0 }, fine);
}
END_TEST

START_TEST(a_ray_meets_the_side_and_the_cap_of_a_capsule)
{
    cast_result side = ray((vec3){ -4, 2, .6 }, (vec3){ 4, 2, .6 }, capsule);
    ck_assert(side.hits);
    near_vec3(side.point, (vec3){ -.8, 2, .6 }, fine);
    near_vec3(side.normal, (vec3){ -.8, 0, .6 }, fine);
    cast_result cap = ray((vec3){ -4, 3.6, 0 }, (vec3){ 4, 3.6, 0 }, capsule);
    ck_assert(cap.hits);
    near_vec3(cap.point, (vec3){ -.8, 3.6, 0 }, fine);
    near_vec3(cap.normal, (vec3){ -.8, .6, 0 }, fine);
}
END_TEST

START_TEST(a_ray_that_begins_inside_meets_at_once)
{
    cast_result r = ray(middle, (vec3){ 9, 0, 0 }, block);
    ck_assert(r.hits);
    near(r.fraction, 0, fine);
    near_vec3(r.normal, (vec3){ -1, 0, 0 }, fine);
    ck_assert(ray((vec3){ 1.5, 0, 0 }, (vec3){ 9, 0, 0 }, ball).hits);
}
END_TEST

// Where a segment enters the cube: by its slabs.
static real enters_cube(vec3 from, vec3 way)
{
    real first = 0, last = 1, f[] = { from.x, from.y, from.z },
         d[] = { way.x, way.y, way.z };
    for (int i = 0; i < 3; i++) {
        real in = (-1 - f[i]) / d[i], out = (1 - f[i]) / d[i];
        first = fmax(first, fmin(in, out));
        last = fmin(last, fmax(in, out));
    }
    return first <= last ? first : HUGE_VAL;
}

// Where it enters the ball of radius 2: by the quadratic.
static real enters_ball(vec3 from, vec3 way)
{
    real a = vec3_dot(way, way), b = vec3_dot(from, way),
         c = vec3_dot(from, from) - 4, root = b * b - a * c;
    if (root < 0) return HUGE_VAL;
    real t = (-b - sqrt(root)) / a;
    return t >= 0 && t <= 1 ? t : HUGE_VAL;
}

static void agrees(cast_result r, real wanted, vec3 from, vec3 way)
{
    if (wanted > 1) {
        ck_assert(!r.hits);
        return;
    }
    ck_assert(r.hits);
    // A ray that grazes is as long within the tolerance as it is flat.
    near((r.fraction - wanted) * vec3_dot(way, r.normal), 0, fine);
    near_vec3(r.point, vec3_add_scaled(from, r.fraction, way), fine);
    near(vec3_length(r.normal), 1, fine);
    ck_assert(vec3_dot(r.normal, way) < 0);
}

// Rejects: a march that stops short where it grazes, a normal that looks in.
START_TEST(random_rays_agree_with_slabs_and_quadratic)
{
    seed = 1;
    int hits = 0;
    for (int k = 0; k < 20000; k++) {
        vec3 from = random_vec3(&seed, 6);
        vec3 to = random_vec3(&seed, 6);
        vec3 way = vec3_sub(to, from);
        if (enters_cube(from, way) > 0)
            agrees(ray(from, to, block), enters_cube(from, way), from, way);
        if (vec3_length(from) > 2)
            agrees(ray(from, to, ball), enters_ball(from, way), from, way);
        hits += enters_cube(from, way) <= 1;
    }
    ck_assert_int_gt(hits, 1000);
}
END_TEST

START_TEST(a_body_that_goes_meets_with_its_own_extent)
{
    vec3 at[8], scratch[16];
    for (int k = 0; k < 8; k++) at[k] = vec3_add(cube[k], (vec3){ 9, 9, 0 });
    rounded a = { { at, 8 }, .5, 0 };
    vec3 down = { 0, -10, 0 }, left = { -10, 0, 0 };
    cast_result r = cast_first_plane(a, down, (plane){ { 0, 1, 0 }, 2 });
    ck_assert(r.hits);
    near(r.fraction, .55, fine);
    near(r.point.y, 2, fine);
    ck_assert(!cast_first(a, left, block, scratch).hits);
    for (int k = 0; k < 8; k++) at[k].y -= 8.5;
    r = cast_first(a, left, block, scratch);
    ck_assert(r.hits);
    near(r.fraction, .65, fine);
    near_vec3(r.normal, (vec3){ 1, 0, 0 }, fine);
}
END_TEST

START_TEST(a_plane_is_met_from_its_free_side_only)
{
    vec3 above = { 1, 3, 2 };
    rounded tip = { { &above, 1 }, 0, 0 };
    plane floor = { { 0, 1, 0 }, 1 };
    ck_assert(!cast_first_plane(tip, (vec3){ 0, 5, 0 }, floor).hits);
    ck_assert(!cast_first_plane(tip, (vec3){ 0, -1.9, 0 }, floor).hits);
    cast_result r = cast_first_plane(tip, (vec3){ 4, -4, 0 }, floor);
    ck_assert(r.hits);
    near(r.fraction, .5, fine);
    near_vec3(r.point, (vec3){ 3, 1, 2 }, fine);
    near_vec3(r.normal, (vec3){ 0, 1, 0 }, fine);
}
END_TEST

START_TEST(the_nearest_point_lies_on_the_surface)
{
    cast_result r = cast_nearest((vec3){ 3, .5, 0 }, block, 5);
    ck_assert(r.hits);
    near(r.fraction, 2, fine);
    near_vec3(r.point, (vec3){ 1, .5, 0 }, fine);
    near_vec3(r.normal, (vec3){ 1, 0, 0 }, fine);
    r = cast_nearest((vec3){ 0, 6, 8 }, ball, 9);
    near(r.fraction, 8, fine);
    near_vec3(r.point, (vec3){ 0, 1.2, 1.6 }, fine);
    ck_assert(!cast_nearest((vec3){ 0, 6, 8 }, ball, 7.9).hits);
    r = cast_nearest((vec3){ .2, .3, 0 }, block, 1);
    ck_assert(r.hits);
    near(r.fraction, 0, fine);
    near_vec3(r.point, (vec3){ .2, .3, 0 }, fine);
}
END_TEST

START_TEST(bodies_overlap_when_their_radii_reach)
{
    vec3 there = { 3.5, 0, 0 };
    ck_assert(cast_overlaps(ball, (rounded){ { &there, 1 }, 1.51, 0 }));
    ck_assert(!cast_overlaps(ball, (rounded){ { &there, 1 }, 1.49, 0 }));
    ck_assert(cast_overlaps(ball, block));
}
END_TEST

START_TEST(what_is_not_finite_meets_nothing)
{
    vec3 lost = { (real)NAN, 0, 0 }, far = { HUGE_VAL, 0, 0 };
    ck_assert(!ray(lost, middle, block).hits);
    ck_assert(!ray((vec3){ -5, 0, 0 }, far, block).hits);
    ck_assert(!cast_nearest(lost, block, 1).hits);
    ck_assert(!cast_overlaps((rounded){ { &lost, 1 }, 1, 0 }, block));
    ck_assert(!cast_nearest_plane(lost, (plane){ { 0, 1, 0 }, 0 }, 1).hits);
    rounded tip = { { &lost, 1 }, 0, 0 };
    plane floor = { { 0, 1, 0 }, 0 };
    ck_assert(!cast_first_plane(tip, (vec3){ 0, -9, 0 }, floor).hits);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        a_ray_meets_the_face_in_front,
        a_ray_that_ends_before_or_passes_beside_meets_nothing,
        a_ray_meets_a_ball_where_the_quadratic_says,
        a_ray_meets_the_side_and_the_cap_of_a_capsule,
        a_ray_that_begins_inside_meets_at_once,
        random_rays_agree_with_slabs_and_quadratic,
        a_body_that_goes_meets_with_its_own_extent,
        a_plane_is_met_from_its_free_side_only,
        the_nearest_point_lies_on_the_surface,
        bodies_overlap_when_their_radii_reach,
        what_is_not_finite_meets_nothing,
        NULL
    };
    return suite_run((suite){ .name = "cast", .tests = tests });
}
