// check_facet.c - triangles and links, beside a convex body.
// Book: chapter 16.

#include <check.h>
#include <stdlib.h>

#include "facet.h"
#include "expect.h"
#include "suite.h"

// A cube of size 1; a query is a few dozen roundings.
#define ROUNDING 1e-13

static shape cube;
static plane walls[12];
static obstacle hit;

static void set_up(void)
{
    ck_assert(shape_box(&cube, vec3_make(1, 1, 1), 1).ok);
    hit = (obstacle){ { cube.at, 8 }, walls,
                      hull_planes(&cube, cube.at, walls), cube.radius,
                      0 };
}

static void tear_down(void)
{
    shape_free(&cube);
}

static void near_weights(const facet_touch *t, real a, real b, real c)
{
    near_vec3(vec3_make(t->weight[0], t->weight[1], t->weight[2]),
              vec3_make(a, b, c), ROUNDING);
}

static plane unknown(void)
{
    return (plane){ { 0, 0, 0 }, 0 };
}

// A triangle across from the cube's corner (1, 1, 1) / 2, so far in front of
// it, whose point with the weights 0.5, 0.3, 0.2 the corner is under.
static vec3 out_of_corner(void)
{
    return vec3_unit(vec3_make(1, 1, 1));
}

static void over_corner(vec3 end[FACET], real gap)
{
    vec3 n = out_of_corner(), x = vec3_unit(vec3_make(1, -1, 0));
    vec3 y = vec3_cross(n, x), here = vec3_scale(gap, n);
    const real at[FACET][2] = { { 0.2, 0.1 }, { -0.3, 0.2 }, { -0.05, -0.55 } };
    here = vec3_add(here, vec3_make(0.5, 0.5, 0.5));
    for (int k = 0; k < FACET; k++)
        end[k] = vec3_add_scaled(vec3_add_scaled(here, at[k][0], x),
                                 at[k][1], y);
}

// Rejects: the nearest particle for the nearest point; a normal into the body;
// a plane that does not touch the body; near what is further than the reach.
START_TEST(corner_under_a_triangle)
{
    vec3 end[FACET], n = out_of_corner();
    const real gap[] = { 1e-3, 0.01, 0.05 };
    for (int k = 0; k < 3; k++) {
        facet_touch t;
        plane between = unknown();
        over_corner(end, gap[k]);
        ck_assert(facet_nearest(&hit, end, &between, 0.06, &t));
        near_weights(&t, 0.5, 0.3, 0.2);
        near_vec3(t.at.at, vec3_make(0.5, 0.5, 0.5), ROUNDING);
        near_vec3(t.at.normal, n, ROUNDING);
        ck_assert(fabs(t.gap - gap[k]) <= ROUNDING);
        near_vec3(between.normal, n, ROUNDING);
        ck_assert(fabs(between.offset - sqrt(0.75)) <= ROUNDING);
        ck_assert(fabs(facet_height(end, between) - gap[k]) <= ROUNDING);
        ck_assert(!facet_nearest(&hit, end, &between, 0.9 * gap[k], &t));
        ck_assert(t.gap >= 0.9 * gap[k]);
    }
}
END_TEST

// The cube's edge along z at x = y = 0.5, and a side that crosses over it: at
// z = 0.1, a quarter of its length from its first end.  As the side of a
// triangle that points away, and as a link.
// Rejects: links whose last corner counts twice; a third corner with a weight.
START_TEST(edge_under_an_edge)
{
    real s = sqrt(0.5), gap = 0.02;
    vec3 n = { s, s, 0 }, along = vec3_unit(vec3_make(1, -1, 1));
    n = vec3_unit(vec3_cross(along, vec3_make(0, 0, 1)));
    if (n.x < 0) n = vec3_scale(-1, n);
    vec3 here = vec3_add_scaled(vec3_make(0.5, 0.5, 0.1), gap, n);
    for (int is_link = 0; is_link < 2; is_link++) {
        facet_touch t;
        plane between = unknown();
        vec3 end[FACET] = { vec3_add_scaled(here, -0.2, along),
                            vec3_add_scaled(here, 0.6, along) };
        end[2] = is_link ? end[1] : vec3_add_scaled(here, 0.5, n);
        ck_assert(facet_nearest(&hit, end, &between, 0.1, &t));
        near_weights(&t, 0.75, 0.25, 0);
        near_vec3(t.at.at, vec3_make(0.5, 0.5, 0.1), ROUNDING);
        near_vec3(t.at.normal, n, ROUNDING);
        ck_assert(fabs(t.gap - gap) <= ROUNDING);
    }
}
END_TEST

// The corner comes up through the triangle, which then lies in the cube.
// Rejects: a side that is forgotten; the nearest way out instead of the way back;
// an overlap that is measured along another normal.
START_TEST(what_cuts_the_body_leaves_by_the_side_it_came_from)
{
    vec3 end[FACET], n = out_of_corner();
    for (int k = 1; k < 20; k++) {
        facet_touch t;
        plane between = unknown();
        over_corner(end, 0.01);
        facet_nearest(&hit, end, &between, 0.02, &t);
        over_corner(end, -0.01 * k);
        ck_assert(facet_nearest(&hit, end, &between, 0.02, &t));
        near_weights(&t, 0.5, 0.3, 0.2);
        near_vec3(t.at.normal, n, ROUNDING);
        ck_assert(fabs(t.gap + 0.01 * k) <= ROUNDING);
    }
}
END_TEST

// Of one that cuts the cube, and was never seen before, most lies over the
// corner.
// Rejects: no answer; a normal of length 0.
START_TEST(what_was_never_seen_leaves_by_the_side_that_most_of_it_is_on)
{
    facet_touch t;
    plane between = unknown();
    vec3 end[FACET];
    over_corner(end, -0.01);
    ck_assert(facet_nearest(&hit, end, &between, 0.02, &t));
    ck_assert(t.gap < 0);
    ck_assert(vec3_dot(t.at.normal, out_of_corner()) > 0.5);
    // Its middle in the middle of the cube.
    vec3 mean = vec3_scale(1.0 / 3, vec3_add(end[0], vec3_add(end[1], end[2])));
    for (int k = 0; k < FACET; k++) end[k] = vec3_sub(end[k], mean);
    between = unknown();
    ck_assert(facet_nearest(&hit, end, &between, 0.02, &t));
    ck_assert(fabs(vec3_length(t.at.normal) - 1) <= ROUNDING);
}
END_TEST

// Exactly in the middle there is no such side.
// Rejects: a plane without a direction, that parts nothing from nothing.
START_TEST(what_is_in_the_middle_leaves_by_some_face)
{
    const vec3 end[FACET] = { { 0.25, 0, 0 }, { -0.125, 0.25, 0 },
                              { -0.125, -0.25, 0 } };
    facet_touch t;
    plane between = unknown();
    ck_assert(facet_nearest(&hit, end, &between, 0.06, &t));
    ck_assert(fabs(vec3_length(t.at.normal) - 1) <= ROUNDING);
    ck_assert(vec3_distance(t.at.normal, between.normal) == 0);
    ck_assert(fabs(facet_height(end, between) - t.gap) <= ROUNDING);
    ck_assert(fabs(vec3_dot(t.at.normal, t.at.at) - 0.5) <= ROUNDING);
}
END_TEST

// Rejects: NaN that is near, or that becomes the plane.
START_TEST(what_is_not_finite_is_near_nothing)
{
    for (int k = 0; k < FACET; k++) {
        facet_touch t;
        plane between = { { 0, 1, 0 }, 0.5 };
        vec3 end[FACET];
        over_corner(end, -0.01);
        end[k].y = (real)NAN;
        ck_assert(!facet_nearest(&hit, end, &between, 0.02, &t));
        near_vec3(between.normal, vec3_make(0, 1, 0), ROUNDING);
        real up = facet_height(end, between);
        ck_assert(up != up);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        corner_under_a_triangle,
        edge_under_an_edge,
        what_cuts_the_body_leaves_by_the_side_it_came_from,
        what_was_never_seen_leaves_by_the_side_that_most_of_it_is_on,
        what_is_in_the_middle_leaves_by_some_face,
        what_is_not_finite_is_near_nothing,
        NULL
    };
    return suite_run((suite){
        .name = "facet", .tests = tests, .set_up = set_up,
        .tear_down = tear_down
    });
}
