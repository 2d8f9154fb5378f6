// check_rounded.c - tests of tumble_shape_rounded: hulls with a radius, in a
// world. Book: chapter 13.

#include "suite.h"
#include "tumble.h"

#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static void near(double got, double wanted, double tolerance)
{
    ck_assert_msg(fabs(got - wanted) <= tolerance, "got %.17g, wanted %.17g",
                  got, wanted);
}

static tumble_world *made(double friction)
{
    tumble_options o = tumble_options_default();
    o.friction = friction;
    o.restitution = 0;
    o.sleep_speed = 0;
    return tumble_world_make(&o);
}

// With sides of 2 h of its core.
static tumble_shape rounded_box(tumble_world *w, tumble_vec3 h, double radius)
{
    tumble_vec3 sides = tumble_v(2 * h.x, 2 * h.y, 2 * h.z);
    return tumble_shape_rounded(w, tumble_shape_box(w, sides, 2), radius);
}

static void is_well(tumble_world *w)
{
    ck_assert_msg(!tumble_world_failure(w), "%s", tumble_world_failure(w));
    tumble_world_free(w);
}

// Rejects: a ray that meets the core, or the box around the body; a normal of
// the core's face at an edge.
START_TEST(ray_meets_faces_edges_and_corners_where_the_formulas_say)
{
    tumble_world *w = made(0.5);
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.kind = TUMBLE_STATIC;
    tumble_body b = tumble_body_add(w, rounded_box(w, tumble_v(.5, .3, .2), .1),
                                    o);
    for (int k = 0; k < 60; k++) {
        double x = -.599 + k * .02, z = .15 + k * .0024;
        double dx = fmax(fabs(x) - .5, 0), dz = fmax(z - .2, 0);
        double up = .01 - dx * dx - dz * dz;
        tumble_hit hit;
        bool hits = tumble_world_ray(w, tumble_v(x, 2, z), tumble_v(x, -2, z),
                                     1, &hit);
        ck_assert_int_eq(hits, up > 0);
        if (!hits) continue;
        near(hit.point.y, .3 + sqrt(up), 1e-9);
        near(hit.normal.y, sqrt(up) / .1, 1e-6);
        near(hit.normal.z, dz / .1, 1e-6);
        ck_assert(hit.body.place == b.place);
    }
    is_well(w);
}
END_TEST

// Rejects: a body that stands on its core; one that rocks on its edges.
START_TEST(rounded_box_rests_on_its_face_and_slides_as_a_box)
{
    double way[2];
    for (int k = 0; k < 2; k++) {
        tumble_world *w = made(0.4);
        tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
        tumble_shape s = k ? rounded_box(w, tumble_v(.4, .15, .4), .1)
                           : tumble_shape_box(w, tumble_v(1, .5, 1), 2);
        tumble_body_options o = tumble_body_at(0, .25, 0);
        o.velocity = tumble_v(3, 0, 0);
        tumble_body b = tumble_body_add(w, s, o);
        for (int i = 0; i < 180; i++) tumble_world_step(w);
        near(tumble_body_position(w, b).y, .25, 1e-3);
        near(tumble_body_velocity(w, b).x, 0, 1e-4);
        way[k] = tumble_body_position(w, b).x;
        is_well(w);
    }
    near(way[0], way[1], 0.01);
    near(way[1], 9 / (2 * 0.4 * 9.81), 0.03);
}
END_TEST

// Almost a ball: a core of 0.4 mm in a radius of half a metre.  (One of 2 cm is
// later by a twentieth: it begins on a face.)  Rejects: rolling about the core.
START_TEST(small_core_with_a_large_radius_rolls_as_a_ball)
{
    const double lean = 0.1, g = 9.81;
    tumble_world *w = made(1);
    tumble_world_set_gravity(w, tumble_v(g * sin(lean), -g * cos(lean), 0));
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_body b =
        tumble_body_add(w, rounded_box(w, tumble_v(2e-4, 2e-4, 2e-4), .5),
                        tumble_body_at(0, .5002, 0));
    for (int i = 0; i < 180; i++) tumble_world_step(w);
    near(tumble_body_velocity(w, b).x, 5.0 / 7 * g * sin(lean) * 3, 0.005);
    is_well(w);
}
END_TEST

// Rejects: pairs that meet at their cores.
START_TEST(rounded_boxes_stand_on_each_other)
{
    tumble_world *w = made(0.5);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_shape s = rounded_box(w, tumble_v(.3, .2, .3), .1);
    tumble_body b[5];
    for (int k = 0; k < 5; k++)
        b[k] = tumble_body_add(w, s, tumble_body_at(0, .3 + .6 * k, 0));
    for (int i = 0; i < 300; i++) tumble_world_step(w);
    for (int k = 0; k < 5; k++) {
        near(tumble_body_position(w, b[k]).y, .3 + .6 * k, 2e-3 * (k + 1));
        near(tumble_body_position(w, b[k]).x, 0, 1e-3);
    }
    is_well(w);
}
END_TEST

// Rejects: a cloth that stops at the planes of the faces, or sinks to the core.
START_TEST(cloth_lies_on_the_round_of_it)
{
    tumble_world *w = made(0.5);
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.kind = TUMBLE_STATIC;
    tumble_body b = tumble_body_add(w, rounded_box(w, tumble_v(.3, .3, .3), .2),
                                    o);
    tumble_body c = tumble_body_add(w,
                                    tumble_shape_cloth(w, 21, 21, 1.6, 1.6, .5),
                                    tumble_body_at(0, .6, 0));
    for (int i = 0; i < 150; i++) tumble_world_step(w);
    double least = 1, round = 0, thick = .55 * .08;
    tumble_vec3 at[441];
    ck_assert_int_eq(tumble_body_vertices(w, c, at, 441), 441);
    for (int k = 0; k < 441; k++) {
        double x = fmax(fabs(at[k].x) - .3, 0), z = fmax(fabs(at[k].z) - .3, 0);
        double y = fmax(fabs(at[k].y) - .3, 0);
        double away = sqrt(x * x + y * y + z * z) - .2;
        least = fmin(least, away);
        round += x > .05 && y > .05 && z < .01 && away < 1.4 * thick;
    }
    near(least, thick, .4 * thick);
    ck_assert_msg(round >= 4, "only %g of it lie over an edge", round);
    tumble_body_remove(w, b);
    is_well(w);
}
END_TEST

// Rejects: a centre that must be in the core; one that may be in the box around.
START_TEST(centre_of_mass_that_is_given_lies_within_the_round)
{
    const double i[6] = { 1, 1, 1, 0, 0, 0 };
    tumble_world *w = made(0.5);
    tumble_shape s = rounded_box(w, tumble_v(.5, .3, .2), .1);
    tumble_shape_weighed(w, s, 1, tumble_v(.55, .35, .25), i);
    ck_assert_ptr_null(tumble_world_failure(w));
    tumble_shape_weighed(w, s, 1, tumble_v(.56, .36, .26), i);
    ck_assert(strstr(tumble_world_failure(w), "not inside") != NULL);
    tumble_world_free(w);
}
END_TEST

START_TEST(what_cannot_be_round_is_refused)
{
    tumble_world *w = made(0.5);
    tumble_shape_rounded(w, tumble_shape_sphere(w, 1, 1), 1);
    ck_assert(strstr(tumble_world_failure(w), "with faces") != NULL);
    tumble_world_free(w);
    w = made(0.5);
    tumble_shape_rounded(w, tumble_shape_box(w, tumble_v(1, 1, 1), 1), -1);
    ck_assert(strstr(tumble_world_failure(w), "the radius is -1 m") != NULL);
    tumble_world_free(w);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        ray_meets_faces_edges_and_corners_where_the_formulas_say,
        rounded_box_rests_on_its_face_and_slides_as_a_box,
        small_core_with_a_large_radius_rolls_as_a_ball,
        rounded_boxes_stand_on_each_other,
        cloth_lies_on_the_round_of_it,
        centre_of_mass_that_is_given_lies_within_the_round,
        what_cannot_be_round_is_refused,
        NULL
    };
    return suite_run((suite){ .name = "rounded", .tests = tests,
                              .seconds = 60 });
}
