// check_program.c - tests of lib/tumble.h: is it what a program expects?

#include "tumble.h"
#include "suite.h"

#include <check.h>
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void near(double got, double wanted, double tolerance)
{
    ck_assert_msg(fabs(got - wanted) <= tolerance, "got %.17g, wanted %.17g",
                  got, wanted);
}

static void near_vec3(tumble_vec3 got, double x, double y, double z,
                      double tolerance)
{
    near(got.x, x, tolerance);
    near(got.y, y, tolerance);
    near(got.z, z, tolerance);
}

static void expect_failure(tumble_world *w, const char *part)
{
    const char *why = tumble_world_failure(w);
    ck_assert_ptr_nonnull(why);
    ck_assert_msg(strstr(why, part) != NULL, "said: %s\nwanted: %s", why, part);
    tumble_world_forget_failure(w);
    ck_assert_ptr_null(tumble_world_failure(w));
}

static void expect_fine(const tumble_world *w)
{
    const char *why = tumble_world_failure(w);
    ck_assert_msg(why == NULL, "failed: %s", why);
}

static tumble_world *weightless(void)
{
    tumble_options o = tumble_options_default();
    o.gravity = tumble_v(0, 0, 0);
    tumble_world *w = tumble_world_make(&o);
    ck_assert_ptr_nonnull(w);
    return w;
}

static tumble_world *with_floor(void)
{
    tumble_world *w = tumble_world_make(NULL);
    ck_assert_ptr_nonnull(w);
    ck_assert(tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1).generation > 0);
    return w;
}

static void run(tumble_world *w, double seconds)
{
    int steps = (int)(seconds * 60 + 0.5);
    for (int k = 0; k < steps; k++) tumble_world_step(w);
}

static tumble_body add_box(tumble_world *w, double x, double y, double z)
{
    return tumble_body_add(w, tumble_shape_box(w, tumble_v(1, 1, 1), 2),
                           tumble_body_at(x, y, z));
}

START_TEST(a_world_that_cannot_be_says_which_option)
{
    tumble_options o = tumble_options_default();
    o.dt = 2;
    ck_assert_ptr_null(tumble_world_make(&o));
    expect_failure(NULL, "dt is 2");
    tumble_world_free(NULL);
}
END_TEST

START_TEST(a_body_falls_as_galileo_says_and_lies)
{
    tumble_world *w = with_floor();
    tumble_body b = add_box(w, 0, 5, 0);
    run(w, 0.5);
    near(tumble_body_position(w, b).y, 5 - 9.81 / 8, 1e-9);
    near(tumble_world_time(w), 0.5, 1e-12);
    run(w, 5);
    near(tumble_body_position(w, b).y, 0.5, 1e-3);
    ck_assert(!tumble_body_is_awake(w, b));
    ck_assert_int_eq(tumble_world_last_step(w).asleep, 1);
    expect_fine(w);
    tumble_world_free(w);
}
END_TEST

// Rejects: an id that is a place and nothing else.
START_TEST(the_id_of_a_body_that_is_gone_is_refused)
{
    tumble_world *w = with_floor();
    tumble_shape s = tumble_shape_box(w, tumble_v(1, 1, 1), 2);
    tumble_body car = tumble_body_add(w, s, tumble_body_at(0, 2, 0));
    ck_assert(tumble_body_remove(w, car));
    tumble_body crate = tumble_body_add(w, s, tumble_body_at(0, 2, 0));
    ck_assert_uint_eq(car.place, crate.place);
    ck_assert(!tumble_body_exists(w, car));
    ck_assert(tumble_body_exists(w, crate));
    ck_assert(!tumble_body_push(w, car, tumble_v(1, 0, 0), tumble_v(0, 2, 0)));
    expect_failure(w, "body 0 is gone");
    near_vec3(tumble_body_velocity(w, crate), 0, 0, 0, 1e-12);
    ck_assert(!tumble_body_remove(w, car));
    ck_assert_int_eq(tumble_world_bodies(w, NULL, 0), 1);
    tumble_world_free(w);
}
END_TEST

START_TEST(the_first_failure_is_the_one_that_is_kept)
{
    tumble_world *w = with_floor();
    tumble_shape s = tumble_shape_box(w, tumble_v(1, -1, 1), 2);
    ck_assert_uint_eq(s.generation, 0);
    tumble_body b = tumble_body_add(w, s, tumble_body_at(0, 0, 0));
    ck_assert_uint_eq(b.generation, 0);
    ck_assert(!tumble_body_wake(w, b));
    tumble_world_step(w);
    expect_failure(w, "side");
    tumble_body_wake(w, b);
    expect_failure(w, "the id of a body is zero");
    tumble_world_free(w);
}
END_TEST

START_TEST(a_shape_stays_as_long_as_a_body_is_made_of_it)
{
    tumble_world *w = with_floor();
    tumble_shape s = tumble_shape_box(w, tumble_v(1, 1, 1), 2);
    tumble_body b = tumble_body_add(w, s, tumble_body_at(0, 2, 0));
    ck_assert(!tumble_shape_remove(w, s));
    expect_failure(w, "1 bodies");
    tumble_world_step(w);
    tumble_body_remove(w, b);
    ck_assert(tumble_shape_remove(w, s));
    ck_assert(!tumble_shape_remove(w, s));
    expect_failure(w, "shape 0 is gone");
    tumble_world_step(w);
    tumble_world_free(w);
}
END_TEST

// A cube of 2 kg and side 1: I = m / 6.  An impulse of (0, 0, 3) at an arm of
// (.5, 0, 0) gives 1.5 m/s, and an angular impulse of (0, -1.5, 0).
START_TEST(a_push_gives_velocity_and_spin)
{
    tumble_world *w = weightless();
    tumble_body b = add_box(w, 1, 2, 3);
    ck_assert(tumble_body_push(w, b, tumble_v(0, 0, 3), tumble_v(1.5, 2, 3)));
    near_vec3(tumble_body_velocity(w, b), 0, 0, 1.5, 1e-12);
    near_vec3(tumble_body_spin(w, b), 0, -4.5, 0, 1e-12);
    run(w, 1);
    near_vec3(tumble_body_position(w, b), 1, 2, 4.5, 1e-9);
    near_vec3(tumble_body_spin(w, b), 0, -4.5, 0, 1e-6);
    expect_fine(w);
    tumble_world_free(w);
}
END_TEST

START_TEST(a_force_acts_for_one_step)
{
    tumble_world *w = weightless();
    tumble_body b = add_box(w, 0, 0, 0);
    for (int k = 0; k < 60; k++) {
        ck_assert(tumble_body_force(w, b, tumble_v(4, 0, 0),
                                    tumble_v(0, 0, 0)));
        tumble_world_step(w);
    }
    near_vec3(tumble_body_velocity(w, b), 2, 0, 0, 1e-9);
    run(w, 1);
    near_vec3(tumble_body_velocity(w, b), 2, 0, 0, 1e-9);
    tumble_world_free(w);
}
END_TEST

START_TEST(a_torque_spins_by_the_inertia)
{
    tumble_world *w = weightless();
    tumble_body b = add_box(w, 0, 0, 0);
    for (int k = 0; k < 60; k++) {
        tumble_body_force(w, b, tumble_v(0, 0, 0), tumble_v(0, 0, 1));
        tumble_world_step(w);
    }
    near_vec3(tumble_body_spin(w, b), 0, 0, 3, 1e-3);
    tumble_world_free(w);
}
END_TEST

START_TEST(a_sleeper_that_is_pushed_wakes_and_goes)
{
    tumble_world *w = with_floor();
    tumble_body b = add_box(w, 0, 0.5, 0);
    run(w, 3);
    ck_assert(!tumble_body_is_awake(w, b));
    tumble_body_push(w, b, tumble_v(8, 0, 0), tumble_body_position(w, b));
    ck_assert(tumble_body_is_awake(w, b));
    run(w, 3);
    // Friction of 0.5 stops 4 m/s after v^2 / (2 mu g).
    near(tumble_body_position(w, b).x, 16 / (2 * 0.5 * 9.81), 0.1);
    ck_assert(!tumble_body_is_awake(w, b));
    ck_assert(tumble_body_wake(w, b));
    ck_assert(tumble_body_is_awake(w, b));
    ck_assert(tumble_body_sleep(w, b));
    ck_assert(!tumble_body_is_awake(w, b));
    tumble_world_free(w);
}
END_TEST

START_TEST(a_pose_comes_back_as_it_was_set)
{
    tumble_world *w = weightless();
    tumble_body b = add_box(w, 0, 0, 0);
    tumble_pose p = { { 3, -2, 7 }, tumble_quat_turn(tumble_v(1, 2, -1), 2.5) };
    ck_assert(tumble_body_set_pose(w, b, p));
    ck_assert(tumble_body_set_velocity(w, b, tumble_v(1, 2, 3),
                                       tumble_v(0, 1, 0)));
    tumble_pose q = tumble_body_pose(w, b);
    near_vec3(q.position, 3, -2, 7, 1e-12);
    double same = p.rotation.x * q.rotation.x + p.rotation.y * q.rotation.y
                + p.rotation.z * q.rotation.z + p.rotation.w * q.rotation.w;
    near(fabs(same), 1, 1e-12);
    near_vec3(tumble_body_velocity(w, b), 1, 2, 3, 1e-9);
    near_vec3(tumble_body_spin(w, b), 0, 1, 0, 1e-9);
    p.position.x = (double)NAN;
    ck_assert(!tumble_body_set_pose(w, b, p));
    expect_failure(w, "finite");
    near_vec3(tumble_body_position(w, b), 3, -2, 7, 1e-12);
    tumble_world_free(w);
}
END_TEST

// Rejects: a matrix taken by its columns; a small divisor.
START_TEST(a_matrix_is_the_rotation_that_made_it)
{
    for (int k = 0; k < 64; k++) {
        tumble_vec3 axis = tumble_v(k % 4 - 1.5, k / 4 % 4 - 1.5, k / 16 - 1);
        tumble_quat q = tumble_quat_turn(axis, 0.1 * k - 3.1);
        double m[9], back[9];
        tumble_quat_matrix(q, m);
        tumble_quat_matrix(tumble_quat_from_matrix(m), back);
        for (int i = 0; i < 9; i++) near(back[i], m[i], 1e-15);
    }
    const double quarter[9] = { 0, -1, 0, 1, 0, 0, 0, 0, 1 };   // about z
    near(tumble_quat_from_matrix(quarter).z, sqrt(0.5), 1e-15);
}
END_TEST

START_TEST(a_kinematic_body_carries_what_lies_on_it)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.kind = TUMBLE_KINEMATIC;
    o.velocity = tumble_v(1, 0, 0);
    tumble_body lift =
        tumble_body_add(w, tumble_shape_box(w, tumble_v(4, 1, 4), 1), o);
    tumble_body load = add_box(w, 0, 1, 0);
    run(w, 3);
    near_vec3(tumble_body_position(w, lift), 3, 0, 0, 1e-9);
    near(tumble_body_velocity(w, load).x, 1, 1e-3);
    near(tumble_body_position(w, load).y, 1, 2e-3);
    ck_assert(!tumble_body_push(w, lift, tumble_v(1, 0, 0), tumble_v(0, 0, 0)));
    expect_failure(w, "kinematic");
    tumble_world_free(w);
}
END_TEST

START_TEST(bodies_whose_masks_do_not_meet_pass)
{
    tumble_world *w = weightless();
    tumble_shape s = tumble_shape_box(w, tumble_v(1, 1, 1), 1);
    tumble_body_options o = tumble_body_at(-3, 0, 0);
    o.velocity = tumble_v(3, 0, 0);
    o.group = 2;
    tumble_body ghost = tumble_body_add(w, s, o);
    o = tumble_body_at(0, 0, 0);
    o.mask = ~2u;
    tumble_body box = tumble_body_add(w, s, o);
    run(w, 2);
    near_vec3(tumble_body_position(w, ghost), 3, 0, 0, 1e-9);
    near_vec3(tumble_body_position(w, box), 0, 0, 0, 1e-12);
    tumble_world_free(w);
}
END_TEST

START_TEST(user_data_is_the_programs_own)
{
    int mine = 7;
    tumble_world *w = weightless();
    tumble_body b = add_box(w, 0, 0, 0);
    ck_assert_ptr_null(tumble_body_user(w, b));
    tumble_body_set_user(w, b, &mine);
    ck_assert_ptr_eq(tumble_body_user(w, b), &mine);
    near(tumble_body_mass(w, b), 2, 1e-12);
    tumble_world_free(w);
}
END_TEST

START_TEST(a_box_on_a_hinge_swings_as_long_as_its_inertia_says)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_body b = add_box(w, 0.05, -1, 0);
    tumble_joint j = tumble_joint_hinge(w, tumble_body_ground(), b,
                                        tumble_v(0, 0, 0), tumble_v(0, 0, 1));
    double length = sqrt(1 + 0.05 * 0.05), inertia = 2.0 / 6 + 2 * length * length;
    double period = 2 * acos(-1) * sqrt(inertia / (2 * 9.81 * length));
    double angle = atan2(0.05, 1);
    period *= 1 + angle * angle / 16;
    double last = 1, before = tumble_body_position(w, b).x;
    int crossings = 0;
    double first = 0, at = 0;
    for (int k = 1; k < 1200 && crossings < 9; k++) {
        tumble_world_step(w);
        double x = tumble_body_position(w, b).x;
        if (before > 0 && x <= 0) {
            at = (k - 1 + before / (before - x)) / 60;
            if (crossings++ == 0) first = at;
        }
        before = x;
    }
    (void)last;
    near((at - first) / 8, period, 1e-3 * period);
    ck_assert_double_lt(tumble_joint_gap(w, j), 1e-4);
    ck_assert(tumble_joint_exists(w, j));
    expect_fine(w);
    tumble_world_free(w);
}
END_TEST

START_TEST(a_joint_goes_with_its_body_and_breaks_under_its_load)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_body b = add_box(w, 0, 0, 0), c = add_box(w, 3, 0, 0);
    tumble_joint j = tumble_joint_ball(w, tumble_body_ground(), b,
                                       tumble_v(0, 0.5, 0));
    tumble_joint k = tumble_joint_ball(w, tumble_body_ground(), c,
                                       tumble_v(3, 0.5, 0));
    run(w, 2);
    near(tumble_joint_force(w, j), 2 * 9.81, 0.01);
    tumble_body_remove(w, b);
    ck_assert(!tumble_joint_exists(w, j));
    ck_assert(!tumble_joint_remove(w, j));
    expect_failure(w, "joint 0 is gone");
    ck_assert(tumble_joint_set_strength(w, k, 19));
    run(w, 1);
    ck_assert(!tumble_joint_exists(w, k));
    ck_assert_double_lt(tumble_body_position(w, c).y, -1);
    tumble_world_free(w);
}
END_TEST

// Of two boxes on one plane one stands on a static box, too.
// Rejects: what lies on a plane that goes and sleeps on; a plane in the place of
// another one that has its contacts, its id or its friction; a ray or a nearest
// point that meets what is gone.
START_TEST(what_lies_on_a_plane_that_goes_falls)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_vec3 up = tumble_v(0, 1, 0);
    tumble_hit h;
    tumble_plane floor = tumble_plane_add(w, up, 0, 0);
    tumble_plane wall = tumble_plane_add(w, tumble_v(1, 0, 0), -9, -1);
    tumble_body b = add_box(w, 0, 0.5, 0);
    run(w, 2);
    ck_assert(!tumble_body_is_awake(w, b));
    ck_assert(tumble_plane_remove(w, floor));
    ck_assert(tumble_body_is_awake(w, b));
    ck_assert(!tumble_plane_remove(w, floor));
    expect_failure(w, "plane 0 is gone");
    ck_assert(!tumble_world_ray(w, tumble_v(3, 1, 0), tumble_v(3, -9, 0), ~0u,
                                &h));
    ck_assert(tumble_world_nearest(w, tumble_v(9, 0, 0), HUGE_VAL, ~0u, &h));
    near(h.fraction, 8.5, 1e-9);
    run(w, 0.5);
    near(tumble_body_position(w, b).y, 0.5 - 9.81 / 8, 0.03);
    // In its place comes another, at once, under a box that slides.
    tumble_plane lower = tumble_plane_add(w, up, -4, -1);
    ck_assert_uint_eq(lower.place, floor.place);
    ck_assert_uint_ne(lower.generation, floor.generation);
    run(w, 2);
    near(tumble_body_position(w, b).y, -3.5, 0.005);
    tumble_body_push(w, b, tumble_v(4, 0, 0), tumble_body_position(w, b));
    ck_assert(tumble_plane_remove(w, lower));
    lower = tumble_plane_add(w, up, -4, 0);
    run(w, 1);
    near(tumble_body_velocity(w, b).x, 2, 1e-3);
    ck_assert(tumble_plane_remove(w, lower) && tumble_plane_remove(w, wall));
    ck_assert(!tumble_world_nearest(w, tumble_v(9, 9, 9), 1, ~0u, &h));
    expect_fine(w);
    tumble_world_free(w);
}
END_TEST

// A box sleeps on a floor, which becomes a slope without friction through the
// same point.  Rejects: contacts of the plane that has gone.
START_TEST(a_plane_in_the_place_of_another_has_contacts_of_its_own)
{
    for (int k = 0; k < 2; k++) {
        tumble_world *w = tumble_world_make(NULL);
        tumble_vec3 slope = tumble_v(0.1, 1, 0);
        tumble_plane p = { 0, 0 };
        if (k == 1) p = tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
        tumble_body b = add_box(w, 0, 0.5, 0);
        if (k == 1) run(w, 2);
        if (k == 1) ck_assert(tumble_plane_remove(w, p));
        tumble_plane_add(w, slope, 0, 0);
        run(w, 1);
        near(tumble_body_velocity(w, b).x, 9.81 * 0.1 / 1.01, 0.2);
        tumble_world_free(w);
    }
}
END_TEST

START_TEST(a_joint_that_joins_nothing_is_refused)
{
    tumble_world *w = with_floor();
    tumble_body b = add_box(w, 0, 1, 0), ground = tumble_body_ground();
    tumble_vec3 at = tumble_v(0, 1, 0);
    ck_assert_uint_eq(tumble_joint_ball(w, b, b, at).generation, 0);
    expect_failure(w, "two bodies");
    ck_assert_uint_eq(tumble_joint_ball(w, ground, ground, at).generation, 0);
    expect_failure(w, "two bodies");
    tumble_joint_hinge(w, ground, b, at, tumble_v(0, 0, 0));
    expect_failure(w, "axis");
    tumble_joint_distance(w, ground, at, b, at, 2, 1);
    expect_failure(w, "2");
    ck_assert(!tumble_joint_set_strength(w, tumble_joint_ball(w, ground, b, at),
                                         -1));
    expect_failure(w, "-1 N");
    tumble_world_free(w);
}
END_TEST

START_TEST(a_ray_meets_the_nearest_and_a_sweep_the_first)
{
    tumble_world *w = with_floor();
    tumble_body_options o = tumble_body_at(0, 2, 0);
    o.kind = TUMBLE_STATIC;
    o.group = 4;
    tumble_shape s = tumble_shape_box(w, tumble_v(1, 1, 1), 1);
    tumble_body b = tumble_body_add(w, s, o);
    tumble_hit h;
    ck_assert(tumble_world_ray(w, tumble_v(0, 5, 0), tumble_v(0, -5, 0), ~0u,
                               &h));
    ck_assert_uint_eq(h.body.place, b.place);
    near(h.fraction, 0.25, 1e-9);
    near_vec3(h.normal, 0, 1, 0, 1e-9);
    ck_assert(tumble_world_ray(w, tumble_v(0, 5, 0), tumble_v(0, -5, 0), ~4u,
                               &h));
    ck_assert_uint_eq(h.body.place, tumble_body_ground().place);
    near(h.fraction, 0.5, 1e-9);
    tumble_pose at = { { 0.9, 5, 0 }, { 0, 0, 0, 0 } };
    ck_assert(tumble_world_sweep(w, s, at, tumble_v(0, -4, 0), ~0u, &h));
    near(h.fraction, 0.5, 1e-9);
    at.position.y = 2.9;
    tumble_body met[2];
    ck_assert_int_eq(tumble_world_overlap(w, s, at, ~0u, met, 2), 1);
    ck_assert_uint_eq(met[0].place, b.place);
    ck_assert(tumble_world_nearest(w, tumble_v(3, 2, 0), 5, ~0u, &h));
    near(h.fraction, 2, 1e-9);
    expect_fine(w);
    tumble_world_free(w);
}
END_TEST

START_TEST(contacts_carry_the_weight_and_events_come_once)
{
    tumble_world *w = with_floor();
    tumble_body b = add_box(w, 0, 0.6, 0);
    tumble_event e[4];
    tumble_contact c[2];
    ck_assert_int_eq(tumble_world_events(w, e, 4), 0);
    run(w, 1);
    ck_assert_int_eq(tumble_world_events(w, e, 4), 1);
    ck_assert(e[0].begins);
    ck_assert_int_eq(tumble_world_events(w, e, 4), 0);
    ck_assert_int_eq(tumble_world_contacts(w, c, 2), 1);
    ck_assert_uint_eq(c[0].a.place, b.place);
    ck_assert_uint_eq(c[0].b.place, tumble_body_ground().place);
    near_vec3(c[0].normal, 0, 1, 0, 1e-9);
    double sum = 0;
    for (int k = 0; k < c[0].points; k++) sum += c[0].force[k];
    near(sum, 2 * 9.81, 0.02);
    run(w, 3);
    ck_assert(!tumble_body_is_awake(w, b));
    ck_assert_int_eq(tumble_world_events(w, e, 4), 0);
    ck_assert_int_eq(tumble_world_contacts(w, c, 2), 1);
    tumble_body_remove(w, b);
    tumble_world_step(w);
    ck_assert_int_eq(tumble_world_events(w, e, 4), 1);
    ck_assert(!e[0].begins);
    tumble_world_free(w);
}
END_TEST

// Rejects: contacts of this step alone, of which a sleeper has none.
START_TEST(what_sleeps_beside_what_moves_still_touches)
{
    tumble_world *w = with_floor();
    tumble_event e[4];
    tumble_body sleeper = add_box(w, 0, 0.5, 0), other = add_box(w, 9, 9, 0);
    for (int k = 0; k < 180; k++) {
        tumble_body_push(w, other, tumble_v(0, 2 * 9.81 / 60, 0),
                         tumble_body_position(w, other));
        tumble_world_step(w);
        int n = tumble_world_events(w, e, 4);
        ck_assert_int_eq(n, k == 0);
    }
    ck_assert(!tumble_body_is_awake(w, sleeper));
    ck_assert(tumble_body_is_awake(w, other));
    ck_assert_int_eq(tumble_world_contacts(w, NULL, 0), 1);
    tumble_world_free(w);
}
END_TEST

START_TEST(pieces_are_one_body)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_shape s = tumble_shape_box(w, tumble_v(1, 1, 1), 1);
    tumble_shape piece[2] = { s, s };
    tumble_pose pose[2] = { { { -1, 0, 0 }, { 0, 0, 0, 1 } },
                            { { 1, 0, 0 }, { 0, 0, 0, 1 } } };
    tumble_body stage = tumble_body_add_pieces(w, piece, pose, 2,
                                               tumble_body_at(0, 0, 0));
    add_box(w, 1, 1.1, 0);
    add_box(w, -1, 1.1, 0);
    run(w, 1);
    tumble_event e[4];
    ck_assert_int_eq(tumble_world_events(w, e, 4), 2);
    ck_assert_int_eq(tumble_world_bodies(w, NULL, 0), 3);
    ck_assert_int_eq(tumble_body_vertices(w, stage, NULL, 0), 16);
    ck_assert(tumble_body_remove(w, stage));
    run(w, 0.5);
    ck_assert_int_eq(tumble_world_contacts(w, NULL, 0), 0);
    piece[1].generation = 99;
    tumble_body none = tumble_body_add_pieces(w, piece, pose, 2,
                                              tumble_body_at(0, 0, 0));
    ck_assert_uint_eq(none.generation, 0);
    expect_failure(w, "shape");
    ck_assert_int_eq(tumble_world_bodies(w, NULL, 0), 2);
    tumble_world_free(w);
}
END_TEST

START_TEST(a_rope_hangs_from_its_pin_and_carries)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_body rope = tumble_body_add(w, tumble_shape_rope(w, 10, 2, 0.2),
                                       tumble_body_at(0, 0, 0));
    tumble_vec3 nail = tumble_body_vertex(w, rope, 0);
    ck_assert(tumble_body_pin(w, rope, 0));
    ck_assert(tumble_body_set_damping(w, rope, 2, 0));
    run(w, 10);
    near_vec3(tumble_body_vertex(w, rope, 0), nail.x, nail.y, nail.z, 0);
    near(tumble_body_vertex(w, rope, 10).y, nail.y - 2, 0.02);
    ck_assert(tumble_body_unpin(w, rope, 0));
    ck_assert(tumble_body_set_damping(w, rope, 0, 0));
    run(w, 1);
    ck_assert_double_lt(tumble_body_vertex(w, rope, 0).y, nail.y - 4);
    ck_assert(!tumble_body_pin(w, rope, 11));
    expect_failure(w, "vertex 11");
    tumble_world_free(w);
}
END_TEST

// A curtain whose two upper corners come 5 cm towards each other in a quarter of a
// second, and stay.  Of what swings exp(-2.5 t) is left after t seconds.
// Rejects: as many iterations as each substep needs: their number goes up and down,
// and the curtain with it, by a centimetre a second for ever.
START_TEST(a_loose_curtain_comes_to_rest)
{
    enum { SIDE = 20 };
    tumble_options o = tumble_options_default();
    o.sleep_speed = 0;
    tumble_world *w = tumble_world_make(&o);
    tumble_body_options at = tumble_body_at(0, 2, 0), held;
    at.damping = 5;
    at.pose.rotation = tumble_quat_turn(tumble_v(1, 0, 0), acos(0));
    tumble_body c = tumble_body_add(
        w, tumble_shape_cloth(w, SIDE, SIDE, 1, 1, 0.2), at), post[2];
    tumble_vec3 last[SIDE * SIDE], now[SIDE * SIDE], still = { 0, 0, 0 };
    tumble_body_vertices(w, c, now, SIDE * SIDE);
    for (int k = 0; k < 2; k++) {
        int i = (SIDE - 1) * (k + (now[0].y < now[SIDE].y ? SIDE : 0));
        held = tumble_body_at(now[i].x, now[i].y, now[i].z);
        held.kind = TUMBLE_KINEMATIC;
        held.velocity.x = now[i].x > 0 ? -0.1 : 0.1;
        held.mask = 0;
        post[k] = tumble_body_add(w, tumble_shape_sphere(w, 0.05, 1), held);
        tumble_joint_hang(w, c, i, post[k]);
    }
    run(w, 0.25);
    for (int k = 0; k < 2; k++)
        tumble_body_set_velocity(w, post[k], still, still);
    run(w, 4);
    tumble_body_vertices(w, c, last, SIDE * SIDE);
    tumble_world_step(w);
    tumble_body_vertices(w, c, now, SIDE * SIDE);
    double most = 0;
    for (int i = 0; i < SIDE * SIDE; i++)
        most = fmax(most, hypot(now[i].x - last[i].x,
                                hypot(now[i].y - last[i].y,
                                      now[i].z - last[i].z)));
    printf("a curtain moves by %g m/s\n", 60 * most);
    ck_assert_double_lt(60 * most, 1e-3);
    expect_fine(w);
    tumble_world_free(w);
}
END_TEST

typedef struct { int triangles, lines, points; } count;
static void on_triangle(void *c, tumble_body b, const tumble_vec3 at[3])
{
    (void)b, (void)at;
    ((count *)c)->triangles++;
}
static void on_line(void *c, tumble_body b, const tumble_vec3 at[2])
{
    (void)b, (void)at;
    ((count *)c)->lines++;
}
static void on_point(void *c, tumble_body b, tumble_vec3 at)
{
    (void)b, (void)at;
    ((count *)c)->points++;
}

START_TEST(everything_is_drawn)
{
    tumble_world *w = with_floor();
    count c = { 0, 0, 0 };
    tumble_pen pen = { on_triangle, on_line, on_point, &c };
    add_box(w, 0, 0.5, 0);
    tumble_body_add(w, tumble_shape_rope(w, 5, 1, 1), tumble_body_at(5, 5, 5));
    tumble_body_add(w, tumble_shape_cloth(w, 3, 3, 1, 1, 1),
                    tumble_body_at(-5, 5, 5));
    run(w, 0.5);
    tumble_world_draw(w, &pen);
    ck_assert_int_eq(c.triangles, 12 + 8);
    ck_assert_int_eq(c.lines, 5);
    ck_assert_int_eq(c.points, 4);
    tumble_world_free(w);
}
END_TEST

START_TEST(every_shape_falls_and_lies_as_high_as_it_is)
{
    tumble_world *w = with_floor();
    tumble_vec3 point[8];
    for (int k = 0; k < 8; k++)
        point[k] = tumble_v(k & 1 ? 0.2 : -0.2, k & 2 ? 0.1 : -0.1,
                            k & 4 ? 0.3 : -0.3);
    tumble_shape s[] = { tumble_shape_sphere(w, 0.3, 1),
                         tumble_shape_hull(w, point, 8, 1),
                         tumble_shape_capsule(w, 1, 0.2, 1),
                         tumble_shape_obj(w, "tests/data/cube.obj", 0.5, 1) };
    const double height[] = { 0.3, 0.1, 0.2, 0.5 / sqrt(3) };
    tumble_body b[4];
    for (int k = 0; k < 4; k++) {
        tumble_body_options o = tumble_body_at(3 * k, 0.8, 0);
        if (k == 2)
            o.pose.rotation = tumble_quat_turn(tumble_v(0, 0, 1), acos(0));
        b[k] = tumble_body_add(w, s[k], o);
    }
    run(w, 6);
    for (int k = 0; k < 4; k++) {
        near(tumble_body_position(w, b[k]).y, height[k], 2e-3);
        near(tumble_body_mass(w, b[k]), 1, 1e-12);
        int n;
        ck_assert_ptr_nonnull(tumble_body_triangles(w, b[k], &n));
        ck_assert_int_ge(n, 12);
    }
    expect_fine(w);
    near(tumble_world_measure(w).penetration, 0, 2e-3);
    ck_assert(tumble_world_set_gravity(w, tumble_v(0, 9.81, 0)));
    run(w, 1);
    near(tumble_body_position(w, b[0]).y, 0.3 + 9.81 / 2, 0.1);
    ck_assert(tumble_world_hash(w) != 0);
    tumble_world_free(w);
}
END_TEST

START_TEST(joints_hold_what_they_say)
{
    tumble_world *w = weightless();
    tumble_body a = add_box(w, 0, 0, 0), b = add_box(w, 1.2, 0, 0),
                c = add_box(w, 5, 0, 0);
    tumble_joint fixed = tumble_joint_fixed(w, a, b, tumble_v(0.6, 0, 0));
    tumble_joint apart = tumble_joint_distance(w, b, tumble_v(1.7, 0, 0), c,
                                               tumble_v(4.5, 0, 0), 1, 3);
    tumble_body_set_velocity(w, c, tumble_v(4, 0, 0), tumble_v(0, 0, 0));
    run(w, 2);
    near(tumble_body_position(w, b).x - tumble_body_position(w, a).x, 1.2,
         1e-4);
    ck_assert_double_lt(tumble_joint_gap(w, fixed), 1e-4);
    ck_assert_double_lt(tumble_body_position(w, c).x
                        - tumble_body_position(w, b).x, 4.01);
    // 2 kg at 4 m/s are shared by three bodies in the end.
    near(tumble_world_measure(w).momentum.x, 8, 1e-9);
    ck_assert(tumble_joint_remove(w, apart));
    ck_assert(!tumble_joint_exists(w, apart));
    ck_assert(!tumble_joint_set_limits(w, fixed, -1, 1));
    expect_failure(w, "no hinge");
    tumble_body d = add_box(w, 0, 5, 0);
    tumble_joint hinge = tumble_joint_hinge(w, tumble_body_ground(), d,
                                            tumble_v(0, 5.5, 0),
                                            tumble_v(0, 0, 1));
    ck_assert(tumble_joint_set_limits(w, hinge, -0.2, 0.3));
    tumble_body_set_velocity(w, d, tumble_v(1, 0, 0), tumble_v(0, 0, 2));
    run(w, 1);
    near(tumble_joint_angle(w, hinge), 0.3, 0.02);
    // Let go, it turns on past where it was stopped.
    ck_assert(tumble_joint_set_limits(w, hinge, -HUGE_VAL, 3.1416));
    tumble_body_set_velocity(w, d, tumble_v(1, 0, 0), tumble_v(0, 0, 2));
    run(w, 0.5);
    near(tumble_joint_angle(w, hinge), 1.3, 0.05);
    ck_assert(!tumble_joint_set_limits(w, hinge, 4, HUGE_VAL));
    expect_failure(w, "no limits");
    expect_fine(w);
    tumble_world_free(w);
}
END_TEST

START_TEST(a_box_hangs_on_a_rope)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_body rope = tumble_body_add(w, tumble_shape_rope(w, 20, 2, 0.2),
                                       tumble_body_at(0, 0, 0));
    tumble_body_options o = tumble_body_at(1.6, 0, 0);
    o.damping = 1;
    tumble_body box =
        tumble_body_add(w, tumble_shape_box(w, tumble_v(1, 1, 1), 5), o);
    tumble_body_pin(w, rope, 0);
    tumble_joint j = tumble_joint_hang(w, rope, 20, box);
    ck_assert_uint_ne(j.generation, 0);
    ck_assert(tumble_body_set_damping(w, rope, 1, 0));
    run(w, 20);
    near(tumble_joint_force(w, j), 5 * 9.81, 1);
    ck_assert_double_lt(tumble_joint_gap(w, j), 1e-3);
    ck_assert(tumble_body_vertex(w, rope, 20).y < -1.9);
    ck_assert_uint_eq(tumble_joint_ball(w, rope, box,
                                        tumble_v(0, 0, 0)).generation,
                      0);
    expect_failure(w, "joints hold rigid bodies");
    tumble_world_free(w);
}
END_TEST

// A body of two pieces; the cloth hangs a finger's breadth beside the second one.
START_TEST(cloth_meets_no_piece_of_what_it_hangs_on)
{
    enum { SIDE = 6 };
    tumble_options o = tumble_options_default();
    o.gravity = tumble_v(0, 0, 0);
    tumble_world *w = tumble_world_make(&o);
    tumble_shape piece[2] = {
        tumble_shape_box(w, tumble_v(0.4, 0.4, 0.4), 4),
        tumble_shape_box(w, tumble_v(2, 0.06, 0.06), 4) };
    tumble_pose at[2] = { { .position = { -1.2, 0, 0 } } };
    tumble_body mast = tumble_body_add_compound(w, piece, at, 2,
                                                tumble_body_at(0, 0, 0));
    tumble_body sail =
        tumble_body_add(w, tumble_shape_cloth(w, SIDE, SIDE, 1.4, 0.6, 0.4),
                        tumble_body_at(0.2, 0, 0.35));
    for (int i = 0; i < SIDE; i++) tumble_joint_hang(w, sail, i, mast);
    run(w, 0.5);
    tumble_measures m = tumble_world_measure(w);
    ck_assert_double_lt(m.kinetic, 1e-20);      // J
    ck_assert_double_lt(m.strain, 1e-12);
    expect_fine(w);
    tumble_world_free(w);
}
END_TEST

START_TEST(materials_cloth_and_filters_are_taken)
{
    tumble_world *w = with_floor();
    tumble_body ice = add_box(w, 0, 0.5, 0), wood = add_box(w, 0, 0.5, 5);
    ck_assert(tumble_body_set_material(w, ice, 0, 0));
    tumble_body_push(w, ice, tumble_v(4, 0, 0), tumble_body_position(w, ice));
    tumble_body_push(w, wood, tumble_v(4, 0, 0), tumble_body_position(w, wood));
    run(w, 1);
    near(tumble_body_position(w, ice).x, 2, 0.02);
    near(tumble_body_position(w, wood).x, 4 / (2 * 0.5 * 9.81), 0.05);
    ck_assert(tumble_body_set_damping(w, ice, 5, 5));
    run(w, 4);
    ck_assert_double_lt(tumble_body_position(w, ice).x, 2.6);
    ck_assert(!tumble_body_set_material(w, ice, 0.5, 2));
    ck_assert_ptr_nonnull(tumble_world_failure(w));
    tumble_world_forget_failure(w);
    tumble_body cloth = tumble_body_add(w,
                                        tumble_shape_cloth(w, 5, 5, 1, 1, 0.1),
                                        tumble_body_at(9, 3, 0));
    ck_assert(tumble_body_set_bending(w, cloth, 1e-3));
    ck_assert(tumble_body_set_stretch(w, cloth, 1e-4));
    ck_assert(!tumble_body_set_stretch(w, cloth, -1));
    tumble_world_forget_failure(w);
    ck_assert(tumble_body_push_vertex(w, cloth, 12, tumble_v(0, 0.01, 0)));
    ck_assert_double_gt(tumble_body_velocity(w, cloth).y, 0);
    ck_assert(!tumble_body_push(w, cloth, tumble_v(1, 0, 0),
                                tumble_v(9, 3, 0)));
    expect_failure(w, "vertices");
    ck_assert(tumble_body_set_filter(w, ice, 2, 0));
    tumble_world_free(w);
}
END_TEST

START_TEST(nonsense_is_refused_in_a_sentence)
{
    tumble_world *w = with_floor();
    tumble_body b = add_box(w, 0, 1, 0);
    tumble_hit h;
    tumble_body_options o = tumble_body_at(0, 0, 0);
    tumble_shape s = tumble_shape_box(w, tumble_v(1, 1, 1), 1);
    o.kind = (tumble_kind)9;
    ck_assert_uint_eq(tumble_body_add(w, s, o).generation, 0);
    expect_failure(w, "9 is no kind");
    o = tumble_body_at(0, 0, 0);
    o.velocity.y = 1e300;
    ck_assert_uint_eq(tumble_body_add(w, s, o).generation, 0);
    expect_failure(w, "too much");
    ck_assert(!tumble_body_push(w, b, tumble_v(1e30, 0, 0), tumble_v(0, 1, 0)));
    expect_failure(w, "too much");
    ck_assert(!tumble_world_ray(w, tumble_v(0, 5, 0), tumble_v(0, -HUGE_VAL, 0),
                                ~0u, &h));
    tumble_plane p = tumble_plane_add(w, tumble_v(0, 0, 0), 0, -1);
    ck_assert(!tumble_plane_remove(w, p));
    expect_failure(w, "plane");
    ck_assert_uint_eq(tumble_shape_hull(w, NULL, 4, 1).generation, 0);
    expect_failure(w, "points");
    ck_assert_uint_eq(tumble_shape_obj(w, "no/such.obj", 1, 1).generation, 0);
    expect_failure(w, "no/such.obj");
    ck_assert_uint_eq(tumble_body_add_pieces(w, NULL, NULL, 0, o).generation,
                      0);
    expect_failure(w, "pieces");
    ck_assert(!tumble_world_set_gravity(w, tumble_v((double)NAN, 0, 0)));
    expect_failure(w, "gravity");
    o = tumble_body_at(0, 9, 0);
    o.kind = TUMBLE_STATIC;
    tumble_body still = tumble_body_add(w, s, o);
    ck_assert(!tumble_body_set_velocity(w, still, tumble_v(1, 0, 0),
                                        tumble_v(0, 0, 0)));
    expect_failure(w, "static");
    tumble_body gone = { 7, 7 };
    ck_assert(tumble_body_pose(w, gone).rotation.w == 0);
    ck_assert(!tumble_body_is_awake(w, gone));
    ck_assert(tumble_body_mass(w, still) == 0);
    // What is written to may be NULL, and a list that is none has no bodies.
    tumble_body_poses(w, &b, 1, NULL);
    tumble_body_poses(w, NULL, 1, &o.pose);
    tumble_body_velocities(w, NULL, 1, NULL, NULL);
    tumble_world_free(w);
}
END_TEST

// A ball of 100 kg falls by 10 m into the middle of a bridge of ten links of 1 kg, as
// far off it as rounding may be, and bounces there.  Of such falls one in seven ended
// with the ball beyond a link.
// Rejects: a link that is put back from the ball, and leaves its joints.
static double torn_by_a_fall(double off)
{
    enum { LINKS = 10 };
    const double link = 0.2;
    tumble_world *w = tumble_world_make(NULL);
    tumble_shape s = tumble_shape_box(w, tumble_v(link, 0.04, 0.08), 1);
    tumble_body last = tumble_body_ground();
    tumble_joint joint[LINKS + 1];
    double x = 0, y = 0, most = 0;
    for (int i = 0; i < LINKS; i++) {
        double dx = 0.8 * link, dy = (i < LINKS / 2 ? -0.6 : 0.6) * link;
        tumble_body_options o = tumble_body_at(x + dx / 2, y + dy / 2, 0);
        o.pose.rotation = tumble_quat_turn(tumble_v(0, 0, dy), acos(0.8));
        tumble_body b = tumble_body_add(w, s, o);
        joint[i] = tumble_joint_ball(w, last, b, tumble_v(x, y, 0));
        last = b;
        x += dx;
        y += dy;
    }
    joint[LINKS] = tumble_joint_ball(w, last, tumble_body_ground(),
                                     tumble_v(x, y, 0));
    tumble_body_add(w, tumble_shape_sphere(w, 0.1, 100),
                    tumble_body_at(4 * link + off, 10 - 2.3 * link, off));
    for (int f = 0; f < 180; f++) {
        tumble_world_step(w);
        for (int i = 0; i <= LINKS; i++)
            most = fmax(most, tumble_joint_gap(w, joint[i]) / link);
    }
    expect_fine(w);
    tumble_world_free(w);
    return most;
}

START_TEST(heavy_ball_tears_no_bridge)
{
    for (int k = 0; k < 20; k++) {
        double off = k % 2 ? 5e-9 * k : 9.35e-8 + 1.7e-9 * k;
        ck_assert_double_lt(torn_by_a_fall(off), 1e-3);
    }
}
END_TEST

// A motor is switched off where it would take more than it may, and on where it
// need not: the switch itself moves what is far from its axis.
// Rejects: a motor that is asked again before the rest of its tree has answered.
START_TEST(a_strong_motor_in_a_tree_of_joints_loses_no_numbers)
{
    static const tumble_vec3 hull[13] = {
        { -0.027, -0.038, 0.017 }, { -0.134, -0.015, 0.013 },
        { 0.106, 0.009, -0.027 },  { 0.150, 0.024, -0.015 },
        { -0.026, -0.005, -0.030 }, { -0.077, -0.002, -0.025 },
        { -0.115, 0.012, 0.024 },  { -0.017, -0.041, -0.005 },
        { 0.092, 0.021, -0.025 },  { -0.108, -0.028, -0.002 },
        { -0.126, -0.010, -0.013 }, { 0.166, 0.003, 0.025 },
        { -0.068, 0.039, -0.004 } };
    tumble_options o = tumble_options_default();
    o.dt = 1.0 / 120;
    tumble_world *w = tumble_world_make(&o);
    tumble_shape ball = tumble_shape_icosahedron(w, 0.4, 47);
    tumble_shape plate = tumble_shape_box(w, tumble_v(0.7, 0.03, 0.7), 47);
    tumble_shape chip = tumble_shape_hull(w, hull, 13, 98);
    tumble_body a = tumble_body_add(w, ball, tumble_body_at(-1.75, 0, 1.75));
    tumble_body b = tumble_body_add(w, plate, tumble_body_at(1.75, 0, 1.75));
    tumble_body c =
        tumble_body_add(w, chip, tumble_body_at(-1.75, 3.5, -1.75));
    tumble_joint_fixed(w, a, b, tumble_v(0, 0, 1.75));
    tumble_joint hinge = tumble_joint_hinge(w, b, c, tumble_v(0, 1.75, 0),
                                            tumble_v(0.815, -0.121, -0.567));
    tumble_joint_set_motor(w, hinge, 0.542, 4503);
    for (int f = 0; f < 10; f++) {
        tumble_world_step(w);
        ck_assert_ptr_null(tumble_world_failure(w));
        ck_assert_double_lt(tumble_joint_gap(w, hinge), 1e-6);
    }
    ck_assert_double_eq_tol(tumble_joint_speed(w, hinge), 0.542, 1e-6);
    tumble_world_free(w);
}
END_TEST

// Rejects: what stands in a sensor, and a sensor below a plane, as overlaps.
START_TEST(a_sensor_overlaps_nothing)
{
    tumble_world *w = with_floor();
    tumble_shape box = tumble_shape_box(w, tumble_v(1, 1, 1), 1);
    tumble_body_options o = tumble_body_at(0, 0.5, 0);
    tumble_body_add(w, box, o);
    tumble_body falls = tumble_body_add(w, box, tumble_body_at(5, 0.5, 0));
    tumble_body_set_sensor(w, falls, true);
    o.kind = TUMBLE_STATIC;
    tumble_body around =
        tumble_body_add(w, tumble_shape_box(w, tumble_v(3, 3, 3), 1), o);
    tumble_body_set_sensor(w, around, true);
    for (int f = 0; f < 60; f++) tumble_world_step(w);
    ck_assert_double_lt(tumble_body_position(w, falls).y, -1);
    ck_assert_double_lt(tumble_world_measure(w).penetration, 1e-3);
    tumble_world_free(w);
}
END_TEST

// --- No world ----------------------------------------------------------------
// Each returns what says that nothing was done, and the first sentence stays.
static void expect_no_world(const char *what, bool is_nothing)
{
    ck_assert_msg(is_nothing, "%s", what);
    expect_failure(NULL, "there is no world");
    tumble_world_forget_failure(NULL);
}

#define REFUSED(call) expect_no_world(#call, !(call))
#define NO_ID(call) expect_no_world(#call, (call).generation == 0)
#define NOTHING(call)                                  \
    do {                                               \
        ck_assert_msg(!(call), "%s", #call);           \
        ck_assert_ptr_null(tumble_world_failure(NULL));      \
    } while (0)
#define DONE(call) expect_no_world(#call, ((call), true))

static tumble_world *const NONE;
static const tumble_vec3 ZERO, UP = { 0, 1, 0 };
static const tumble_pose POSE;

// Rejects: any function that looks into the world before it asks whether there
// is one, or refuses without a sentence.
START_TEST(what_makes_makes_nothing_in_no_world)
{
    const tumble_shape s = { 0, 0 };
    const tumble_body b = { 0, 1 }, ground = tumble_body_ground();
    const tumble_vec3 corner[4] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 },
                                    { 0, 0, 1 } };
    tumble_world_forget_failure(NONE);
    NO_ID(tumble_shape_box(NONE, tumble_v(1, 1, 1), 1));
    NO_ID(tumble_shape_icosahedron(NONE, 1, 1));
    NO_ID(tumble_shape_sphere(NONE, 1, 1));
    NO_ID(tumble_shape_capsule(NONE, 1, 1, 1));
    NO_ID(tumble_shape_hull(NONE, corner, 4, 1));
    NO_ID(tumble_shape_obj(NONE, "tests/data/cube.obj", 1, 1));
    NO_ID(tumble_shape_rope(NONE, 3, 1, 1));
    NO_ID(tumble_shape_cloth(NONE, 3, 3, 1, 1, 1));
    NO_ID(tumble_plane_add(NONE, UP, 0, -1));
    NO_ID(tumble_body_add(NONE, s, tumble_body_at(0, 0, 0)));
    NO_ID(tumble_body_add_pieces(NONE, &s, &POSE, 1, tumble_body_at(0, 0, 0)));
    NO_ID(tumble_body_add_mesh(NONE, corner, 4, (int[]){ 0, 1, 2 }, 1, 0,
                               tumble_body_at(0, 0, 0)));
    NO_ID(tumble_body_add_heights(NONE, (double[]){ 0, 0, 0, 0 }, 2, 2, 1, 1, 0,
                                  tumble_body_at(0, 0, 0)));
    NO_ID(tumble_joint_ball(NONE, b, ground, ZERO));
    NO_ID(tumble_joint_hinge(NONE, b, ground, ZERO, UP));
    NO_ID(tumble_joint_fixed(NONE, b, ground, ZERO));
    NO_ID(tumble_joint_distance(NONE, ground, ZERO, b, UP, 0, 1));
    NO_ID(tumble_joint_hang(NONE, b, 0, ground));
}
END_TEST

START_TEST(what_changes_changes_nothing_in_no_world)
{
    const tumble_body b = { 0, 1 };
    const tumble_joint j = { 0, 1 };
    tumble_world_forget_failure(NONE);
    DONE(tumble_world_step(NONE));
    DONE(tumble_world_run_on(NONE, NULL, NULL));
    REFUSED(tumble_world_set_gravity(NONE, UP));
    REFUSED(tumble_plane_remove(NONE, (tumble_plane){ 0, 1 }));
    REFUSED(tumble_shape_remove(NONE, (tumble_shape){ 0, 1 }));
    REFUSED(tumble_body_remove(NONE, b));
    REFUSED(tumble_body_set_pose(NONE, b, POSE));
    REFUSED(tumble_body_set_velocity(NONE, b, ZERO, ZERO));
    REFUSED(tumble_body_push(NONE, b, UP, ZERO));
    REFUSED(tumble_body_force(NONE, b, UP, ZERO));
    REFUSED(tumble_body_wake(NONE, b));
    REFUSED(tumble_body_sleep(NONE, b));
    REFUSED(tumble_body_set_material(NONE, b, 0, 0));
    REFUSED(tumble_body_set_damping(NONE, b, 0, 0));
    REFUSED(tumble_body_set_filter(NONE, b, 1, 1));
    REFUSED(tumble_body_set_user(NONE, b, NULL));
    REFUSED(tumble_body_force_at(NONE, b, UP, ZERO));
    REFUSED(tumble_body_set_kind(NONE, b, TUMBLE_STATIC));
    REFUSED(tumble_body_set_gravity_scale(NONE, b, 1));
    REFUSED(tumble_body_set_locked(NONE, b, 1));
    REFUSED(tumble_body_set_sensor(NONE, b, true));
    REFUSED(tumble_world_listen(NONE, true));
    REFUSED(tumble_world_choose_contacts(NONE, NULL, NULL));
    REFUSED(tumble_world_sensor_events(NONE, NULL, 0));
    REFUSED(tumble_joint_set_touching(NONE, j, true));
    REFUSED(tumble_body_pin(NONE, b, 0));
    REFUSED(tumble_body_unpin(NONE, b, 0));
    REFUSED(tumble_body_push_vertex(NONE, b, 0, UP));
    REFUSED(tumble_body_set_vertex_velocity(NONE, b, 0, UP));
    REFUSED(tumble_body_set_bending(NONE, b, 0));
    REFUSED(tumble_body_set_stretch(NONE, b, 0));
    REFUSED(tumble_joint_set_limits(NONE, j, 0, 1));
    REFUSED(tumble_joint_set_strength(NONE, j, 1));
    REFUSED(tumble_joint_remove(NONE, j));
    REFUSED(tumble_world_events(NONE, NULL, 0));
}
END_TEST

static bool is_zero(tumble_vec3 v)
{
    return v.x == 0 && v.y == 0 && v.z == 0;
}

START_TEST(a_question_about_no_world_has_the_answer_zero)
{
    const tumble_body b = { 0, 1 };
    const tumble_joint j = { 0, 1 };
    const tumble_shape s = { 0, 1 };
    const tumble_pen pen = { NULL, NULL, NULL, NULL };
    int triangles = 7;
    tumble_world_forget_failure(NONE);
    NOTHING(tumble_world_time(NONE) != 0);
    NOTHING(tumble_world_last_step(NONE).bodies);
    NOTHING(tumble_world_measure(NONE).kinetic != 0);
    NOTHING(tumble_world_hash(NONE));
    NOTHING(tumble_world_save(NONE, NULL, 0));
    ck_assert_ptr_null(tumble_world_load(NULL, 0));
    tumble_world_forget_failure(NULL);
    NOTHING(tumble_body_exists(NONE, b));
    NOTHING(tumble_world_moved(NONE, NULL, 0));
    NOTHING(tumble_body_get_options(NONE, b).group);
    NOTHING(tumble_body_shape(NONE, b).generation);
    NOTHING(tumble_body_gravity_scale(NONE, b) != 0);
    NOTHING(tumble_body_locked(NONE, b));
    NOTHING(tumble_body_is_sensor(NONE, b));
    NOTHING(tumble_world_impulses(NONE, NULL, 0));
    NOTHING(tumble_body_sensed(NONE, b, NULL, 0));
    NOTHING(tumble_world_joints(NONE, NULL, 0));
    NOTHING(tumble_joint_body(NONE, j, 0).generation);
    NOTHING(tumble_joint_may_touch(NONE, j));
    NOTHING(tumble_world_bodies(NONE, NULL, 0));
    NOTHING(tumble_body_pose(NONE, b).rotation.w != 0);
    NOTHING(!is_zero(tumble_body_position(NONE, b)));
    NOTHING(!is_zero(tumble_body_velocity(NONE, b)));
    NOTHING(!is_zero(tumble_body_spin(NONE, b)));
    NOTHING(tumble_body_mass(NONE, b) != 0);
    NOTHING(tumble_body_user(NONE, b));
    NOTHING(tumble_body_is_awake(NONE, b));
    NOTHING(tumble_body_vertices(NONE, b, NULL, 0));
    NOTHING(tumble_body_triangles(NONE, b, &triangles) || triangles);
    NOTHING(!is_zero(tumble_body_vertex(NONE, b, 0)));
    NOTHING(tumble_joint_exists(NONE, j));
    NOTHING(tumble_joint_gap(NONE, j) != 0);
    NOTHING(tumble_joint_force(NONE, j) != 0);
    NOTHING(tumble_joint_torque(NONE, j) != 0);
    REFUSED(tumble_joint_set_friction(NONE, j, 1));
    NO_ID(tumble_shape_cone(NONE, 1, 1, 1));
    NOTHING(tumble_joint_angle(NONE, j) != 0);
    NOTHING(tumble_world_ray(NONE, ZERO, UP, ~0u, NULL));
    NOTHING(tumble_world_nearest(NONE, ZERO, 1, ~0u, NULL));
    NOTHING(tumble_world_overlap(NONE, s, POSE, ~0u, NULL, 0));
    NOTHING(tumble_world_sweep(NONE, s, POSE, UP, ~0u, NULL));
    NOTHING(tumble_world_ray_all(NONE, ZERO, UP, ~0u, NULL, 0));
    NOTHING(tumble_world_ray_soft(NONE, ZERO, UP, ~0u, NULL));
    NOTHING(tumble_world_nearest_soft(NONE, ZERO, 1, ~0u, NULL));
    NOTHING(tumble_world_walk(NONE, tumble_walker_capsule(1, 1),
                              (tumble_walk){ .stands = false }, UP, NULL));
    NOTHING(tumble_world_sweep_turning(NONE, s, POSE, UP, UP, ~0u, NULL));
    NOTHING(tumble_world_contacts(NONE, NULL, 0));
    NOTHING((tumble_world_draw(NONE, &pen), false));
}
END_TEST

// The first sentence says more than the later ones.
START_TEST(a_world_that_was_not_made_says_why_to_the_end)
{
    tumble_options o = tumble_options_default();
    o.dt = 2;
    tumble_world *w = tumble_world_make(&o);
    tumble_body_add(w, tumble_shape_box(w, tumble_v(1, 1, 1), 1),
                    tumble_body_at(0, 0, 0));
    tumble_world_step(w);
    expect_failure(NULL, "dt is 2");
}
END_TEST

// Rejects: options that are all zeros make a body without friction that meets
// nothing.
START_TEST(options_that_were_not_begun_are_refused)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_shape box = tumble_shape_box(w, tumble_v(1, 1, 1), 1);
    tumble_pose at = { { 0, 5, 0 }, { 0, 0, 0, 1 } };
    tumble_body_options zero = { 0 };
    ck_assert_int_eq((int)tumble_body_add(w, box, zero).generation, 0);
    expect_failure(w, "options begin with tumble_body_at");
    tumble_world_forget_failure(w);
    ck_assert_int_eq((int)tumble_body_add_pieces(w, &box, &at, 1,
                                                 zero).generation,
                     0);
    expect_failure(w, "options begin with tumble_body_at");
    tumble_world_forget_failure(w);
    tumble_body b = tumble_body_add(w, box, tumble_body_at(0, 1, 0));
    ck_assert(!tumble_body_set_filter(w, b, 0, 0));
    expect_failure(w, "group 0");
    tumble_world_forget_failure(w);
    ck_assert(tumble_body_set_filter(w, b, 1, 0));
    tumble_options none = { 0 };
    ck_assert_ptr_null(tumble_world_make(&none));
    expect_failure(NULL, "dt is 0");
    tumble_world_free(w);
}
END_TEST

// A chain of 20 links, held at one end, with a load at the other; level.
enum { LINKS = 20 };
static tumble_world *loaded_chain(int substeps, double mass,
                                  tumble_joint joint[LINKS + 1])
{
    tumble_options o = tumble_options_default();
    o.substeps = o.most_substeps = substeps;
    tumble_world *w = tumble_world_make(&o);
    tumble_shape link = tumble_shape_box(w, tumble_v(0.3, 0.1, 0.1), 1);
    tumble_shape load = tumble_shape_sphere(w, 0.3, mass);
    tumble_body last = tumble_body_ground();
    for (int k = 0; k <= LINKS; k++) {
        bool is_load = k == LINKS;
        double x = 0.3 * k + (is_load ? 0.3 : 0.15);
        tumble_body b = tumble_body_add(w, is_load ? load : link,
                                        tumble_body_at(x, 20, 0));
        joint[k] = tumble_joint_ball(w, last, b, tumble_v(0.3 * k, 20, 0));
        last = b;
    }
    return w;
}

// It bears far more than so few substeps follow.  Rejects: bodies that were stopped in
// mid-air, or are apart, with no word about it; impulses that are no numbers, and are
// kept; joints that are followed all the same (its numbers are lost).
START_TEST(what_few_substeps_cannot_follow_is_never_apart_in_silence)
{
    tumble_joint joint[LINKS + 1];
    tumble_world *w = loaded_chain(_i, _i == 1 ? 100 : 1e6, joint);
    tumble_body last = tumble_joint_body(w, joint[LINKS], 1);
    for (int k = 0; k < 100; k++) {
        tumble_world_step(w);
        int unconverged = tumble_world_last_step(w).unconverged;
        tumble_vec3 p = tumble_body_position(w, last),
                    v = tumble_body_velocity(w, last);
        ck_assert(isfinite(p.x + p.y + p.z + v.x + v.y + v.z));
        for (int i = 0; i <= LINKS; i++) {
            double gap = tumble_joint_gap(w, joint[i]);
            ck_assert_msg(gap < 3e-3 || unconverged > 0,
                          "step %d, joint %d: %g m", k, i, gap);
        }
    }
    ck_assert_ptr_null(tumble_world_failure(w));
    tumble_world_free(w);
}
END_TEST

// Two thin rods, of which one spins about its length, are joined where both have an
// arm of 250 times their thickness: no step follows that.  Rejects: energy from
// nowhere, 3e10 J in the first step, and bodies far apart, with no word about it.
START_TEST(what_is_joined_gains_nothing_from_its_first_step)
{
    for (double spin = 10; spin < 2e5; spin *= 10) {
        tumble_world *w = weightless();
        tumble_vec3 sides = tumble_v(0.002, 0.1, 0.002);
        tumble_shape rod = tumble_shape_box(w, sides, 1);
        tumble_body_options spun = tumble_body_at(0, 0, 0);
        spun.spin = tumble_v(0, spin, 0);
        tumble_body a = tumble_body_add(w, rod, spun);
        tumble_body b = tumble_body_add(w, rod, tumble_body_at(1, 0, 0));
        tumble_joint j = tumble_joint_ball(w, a, b, tumble_v(0.5, 0, 0));
        double had = tumble_world_measure(w).kinetic;
        for (int k = 0; k < 10; k++) {
            tumble_world_step(w);
            double has = tumble_world_measure(w).kinetic;
            double gap = tumble_joint_gap(w, j);
            bool is_said = tumble_world_last_step(w).unconverged > 0;
            ck_assert_msg(has <= had && (gap < 1e-6 || is_said),
                          "%g rad/s, step %d: %g J of %g, gap %g m", spin, k,
                          has, had, gap);
        }
        tumble_world_free(w);
    }
}
END_TEST

// A rope between a wheel and a block, all of it wild, as options accept it.
// Rejects: a pin that feeds a rope until it has no numbers.
static void spin_a_rope(double spin)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_body_options spun = tumble_body_at(0, 0, 0);
    spun.spin = tumble_v(0, spin, spin / 3);
    tumble_shape cube = tumble_shape_box(w, tumble_v(1, 1, 1), 1);
    tumble_shape light = tumble_shape_box(w, tumble_v(1, 1, 1), 0.006);
    tumble_body wheel = tumble_body_add(w, cube, spun);
    spun.spin = tumble_v(0, 1e8, 0);
    tumble_body rope = tumble_body_add(w, tumble_shape_rope(w, 10, 3, 1), spun);
    tumble_body block = tumble_body_add(w, light, tumble_body_at(0, 2, 0));
    tumble_joint pin = tumble_joint_hang(w, rope, 0, wheel);
    tumble_joint_hang(w, rope, 10, block);
    for (int k = 0; k < 40; k++) {
        tumble_world_step(w);
        tumble_vec3 p = tumble_body_position(w, rope),
                    v = tumble_body_velocity(w, rope);
        ck_assert(isfinite(p.x + p.y + p.z + v.x + v.y + v.z));
        ck_assert(isfinite(tumble_joint_force(w, pin)));
    }
    expect_fine(w);
    tumble_world_free(w);
}

START_TEST(a_pinned_rope_keeps_its_numbers)
{
    spin_a_rope(1e7);
    spin_a_rope(1e6 * pow(1.5, 8));
}
END_TEST

// A ton hits a cube on a joint at 10 km/s, spins wildly, and begins inside of it.
static bool loses_numbers(double light)
{
    tumble_world *w = weightless();
    tumble_body_options fast = tumble_body_at(0, 0, 0);
    fast.velocity = tumble_v(1e4, 5e3, 3e3);
    fast.spin = tumble_v(0, 1e9, 3e8);
    tumble_shape cube = tumble_shape_box(w, tumble_v(1, 1, 1), light);
    tumble_body_add(w, tumble_shape_box(w, tumble_v(1, 1, 1), 1000), fast);
    tumble_body b = tumble_body_add(w, cube, tumble_body_at(0.6, 0.3, 0.2));
    tumble_joint j = tumble_joint_ball(w, b, tumble_body_ground(),
                                       tumble_v(2, 1, 3));
    bool was_lost = false;
    for (int k = 0; k < 60; k++) {
        tumble_world_step(w);
        was_lost |= tumble_world_failure(w) != NULL;
        if (k < 30) tumble_world_forget_failure(w);
        ck_assert(isfinite(tumble_joint_force(w, j)));
    }
    expect_fine(w);
    tumble_world_free(w);
    return was_lost;
}

// Rejects: contacts that hand impulses which are no numbers to the next step,
// and with them the loss, for ever; a joint whose force is no number.
START_TEST(what_was_lost_is_not_lost_again)
{
    int lost = 0;
    for (double light = 1; light > 1e-30; light /= 1000)
        lost += loses_numbers(light);
    ck_assert_int_gt(lost, 0);
}
END_TEST

// Rejects: a joint that pushes what does not yield, ever harder: 1e16 N.
START_TEST(a_joint_of_what_does_not_yield_bears_nothing)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_body_options driven = tumble_body_at(0, 0, 0);
    driven.kind = TUMBLE_KINEMATIC;
    driven.velocity = tumble_v(1, 0, 0);
    tumble_shape cube = tumble_shape_box(w, tumble_v(1, 1, 1), 1);
    tumble_body b = tumble_body_add(w, cube, driven);
    tumble_joint j = tumble_joint_ball(w, b, tumble_body_ground(),
                                       tumble_v(0, 0, 0));
    run(w, 1);
    near(tumble_joint_force(w, j), 0, 0);
    near(tumble_body_position(w, b).x, 1, 1e-9);
    near(tumble_joint_gap(w, j), 1, 1e-9);
    tumble_world_free(w);
}
END_TEST

// A bullet comes: the step is divided into four parts.
// Rejects: 10000 substeps in each of them; fewer than were asked for, without a
// word.
START_TEST(a_step_has_no_more_substeps_than_the_most)
{
    tumble_options o = tumble_options_default();
    o.substeps = 10000;
    tumble_world *w = tumble_world_make(&o);
    tumble_body_options fast = tumble_body_at(-3, 0, 0);
    fast.velocity = tumble_v(300, 0, 0);
    tumble_body_add(w, tumble_shape_box(w, tumble_v(0.1, 0.1, 0.1), 1), fast);
    tumble_body_add(w, tumble_shape_box(w, tumble_v(1, 1, 1), 1),
                    tumble_body_at(0, 0, 0));
    for (int k = 0; k < 3; k++) {
        tumble_world_step(w);
        ck_assert_int_le(tumble_world_last_step(w).substeps, 10000);
    }
    expect_failure(w, "10000 substeps in all");
    tumble_world_free(w);
}
END_TEST

// A paddle of 6 m turns among cubes of 1 m, by up to 0.6 rad in a step.
// Rejects: a cube that is asked about the side that the paddle showed when the
// step began: 0.6 m deep.
START_TEST(a_paddle_does_not_go_through_what_it_hits)
{
    for (double spin = 12; spin < 40; spin *= 1.3) {
        tumble_world *w = with_floor();
        tumble_body_options o = tumble_body_at(0, 1, 0);
        o.kind = TUMBLE_KINEMATIC;
        o.spin = tumble_v(0, spin, 0);
        tumble_body_add(w, tumble_shape_box(w, tumble_v(6, 2, 0.5), 1), o);
        tumble_shape cube = tumble_shape_box(w, tumble_v(1, 1, 1), 1);
        for (int i = 0; i < 8; i++) {
            double a = 0.3 + i * 0.785;
            tumble_body_add(w, cube,
                            tumble_body_at(2.4 * cos(a), 0.5, 2.4 * sin(a)));
        }
        for (int k = 0; k < 30; k++) {
            tumble_world_step(w);
            ck_assert_msg(tumble_world_measure(w).penetration < 0.05,
                          "spin %g step %d: %g", spin, k,
                          tumble_world_measure(w).penetration);
        }
        tumble_world_free(w);
    }
}
END_TEST

// A plate of a slope that friction holds goes up, a fifteenth of a box's height
// in each frame: to the box it is as if the plate stood.
// Rejects: contacts of a body that will leave its place in this frame that are
// looked for as if it were still where it was placed, so that every other frame
// has none.
START_TEST(a_box_rides_on_a_plate_that_goes_up)
{
    tumble_options o = tumble_options_default();
    o.dt = 1.0 / 30;
    tumble_world *w = tumble_world_make(&o);
    double c = cos(0.4), s = sin(0.4);
    tumble_body_options at = tumble_body_at(0, 0, 0);
    at.kind = TUMBLE_KINEMATIC;
    at.pose.rotation = tumble_quat_turn(tumble_v(0, 0, 1), 0.4);
    at.velocity = tumble_v(0, 1, 0);
    tumble_body plate =
        tumble_body_add(w, tumble_shape_box(w, tumble_v(2, 0.2, 2), 1), at);
    at = tumble_body_at(-0.2 * s, 0.2 * c, 0);
    at.pose.rotation = tumble_quat_turn(tumble_v(0, 0, 1), 0.4);
    at.velocity = tumble_v(0, 1, 0);
    tumble_body box =
        tumble_body_add(w, tumble_shape_box(w, tumble_v(0.2, 0.2, 0.2), 1),
                        at);
    for (int k = 0; k < 60; k++) {
        tumble_world_step(w);
        tumble_vec3 a = tumble_body_position(w, plate),
                    b = tumble_body_position(w, box);
        near(hypot(b.x - a.x, b.y - a.y), 0.2, 1e-3);
        ck_assert_double_lt(tumble_world_measure(w).penetration, 1e-3);
    }
    expect_fine(w);
    tumble_world_free(w);
}
END_TEST

// Rejects: gravity's part of half a substep, which the joint takes back; a velocity
// that is another one than was set.
START_TEST(a_box_that_hangs_still_has_no_velocity)
{
    tumble_options o = tumble_options_default();
    o.sleep_speed = 0;
    tumble_world *w = tumble_world_make(&o);
    tumble_body box = add_box(w, 0, -1, 0);
    tumble_joint_ball(w, tumble_body_ground(), box, tumble_v(0, 0, 0));
    run(w, 0.5);
    near_vec3(tumble_body_velocity(w, box), 0, 0, 0, 1e-9);
    tumble_vec3 slow = { 1e-3, 0, 0 }, none = { 0, 0, 0 };
    ck_assert(tumble_body_set_velocity(w, box, slow, none));
    near_vec3(tumble_body_velocity(w, box), 1e-3, 0, 0, 1e-12);
    tumble_world_free(w);
}
END_TEST

// A rope of 3 m hangs over a smooth drum, with 1 and 1.5 kg at its ends: they go
// with g (b - a) / (a + b), a fifth of g, less what the rope's 50 g change.
// Rejects: substeps that joints ask for in one frame and not in the next: each
// change pulls at the rope, until it holds the weights up.
START_TEST(weights_over_a_drum_go_as_atwood_says)
{
    enum { DRUM_LINKS = 60 };
    tumble_world *w = tumble_world_make(NULL);
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.kind = TUMBLE_STATIC;
    o.friction = 0;
    o.pose.rotation = tumble_quat_turn(tumble_v(1, 0, 0), acos(0));
    tumble_body_add(w, tumble_shape_capsule(w, 1, 0.2, 1), o);
    o = tumble_body_at(0, 0.24, 0);
    o.damping = 4;
    o.friction = 0;
    tumble_body rope = tumble_body_add(w, tumble_shape_rope(w, DRUM_LINKS, 3, 0.05),
                                       o);
    tumble_body weight[2];
    tumble_body_pin(w, rope, DRUM_LINKS / 2);
    for (int i = 0; i < 2; i++) {
        tumble_vec3 end = tumble_body_vertex(w, rope, i * DRUM_LINKS);
        o = tumble_body_at(end.x, end.y, end.z);
        o.damping = 4;
        o.mask = 0;
        tumble_shape ball = tumble_shape_sphere(w, 0.05, i ? 1.5 : 1);
        weight[i] = tumble_body_add(w, ball, o);
        tumble_joint_hang(w, rope, i * DRUM_LINKS, weight[i]);
    }
    run(w, 6);
    tumble_body_unpin(w, rope, DRUM_LINKS / 2);
    tumble_body_set_damping(w, rope, 0, 0);
    for (int i = 0; i < 2; i++) tumble_body_set_damping(w, weight[i], 0, 0);
    double from = tumble_body_position(w, weight[1]).y, t = 0.4;
    run(w, t);
    near(from - tumble_body_position(w, weight[1]).y, 9.81 * t * t / 10, 0.03);
    expect_fine(w);
    tumble_world_free(w);
}
END_TEST

// What 200 balls that rain between four walls have, of what they fell with.
static double rain(unsigned seed)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    for (int k = -1; k < 2; k += 2) {
        tumble_plane_add(w, tumble_v(k, 0, 0), -2, -1);
        tumble_plane_add(w, tumble_v(0, 0, k), -2, -1);
    }
    tumble_shape ball = tumble_shape_sphere(w, 0.15, 0.1);
    for (int i = 0; i < 200; i++) {
        double aside[2];
        for (int k = 0; k < 2; k++) {
            seed = seed * 1664525u + 1013904223u;
            aside[k] = seed / 4294967296.0 - 0.5;
        }
        double x = 0.35 * (i % 10 - 4.5) + 0.04 * aside[0];
        double y = 0.2 + 0.31 * (i / 10), z = 3.4 * aside[1];
        tumble_body_add(w, ball, tumble_body_at(x, y, z));
    }
    double began = tumble_world_measure(w).potential, most = 0;
    for (int f = 0; f < 90; f++) {
        tumble_world_step(w);
        tumble_measures m = tumble_world_measure(w);
        if (f > 0) most = fmax(most, m.kinetic + m.potential);
    }
    expect_fine(w);
    tumble_world_free(w);
    return most / began;
}

// Rejects: impulses that are scaled for every time that their contact is found
// again, where frames are divided.
START_TEST(balls_that_rain_on_balls_gain_nothing)
{
    for (unsigned seed = 1; seed < 4; seed++)
        ck_assert_double_le(rain(seed), 1 + 1e-3);
}
END_TEST

// A share of 0.0035 of four inner radii is 0.014 of one.  The pair above the lowest
// plate has half the effective mass, so it gives twice as much; half of that is room.
// Rejects: the radius of what is thin, beside which a third of its inner radius is
// little.
START_TEST(a_stack_of_plates_gives_by_a_share_of_their_thickness)
{
    const int plates = 10;
    const double sizes[] = { 0.02, 0.2, 2 }, share = 0.042;
    for (int k = 0; k < 3; k++) {
        double side = sizes[k], thick = side / 40;
        tumble_world *w = with_floor();
        tumble_shape s = tumble_shape_box(w, tumble_v(side, thick, side),
                                          1000 * side * side * thick);
        for (int i = 0; i < plates; i++)
            tumble_body_add(w, s, tumble_body_at(0, (i + 0.5) * thick, 0));
        run(w, 5);
        ck_assert_int_eq(tumble_world_last_step(w).asleep, plates);
        double deep = tumble_world_measure(w).penetration;
        ck_assert_double_lt(deep, share * thick / 2);
        expect_fine(w);
        tumble_world_free(w);
    }
}
END_TEST

// Nothing but its radius and the frame says how fast an overlap goes.
// Rejects: a speed in m/s, which throws a pebble and leaves a mountain where it is.
START_TEST(an_overlap_goes_in_as_many_frames_at_any_size)
{
    double rises = 0;
    for (int k = -10; k <= 10; k += 5) {
        double side = ldexp(1, k);
        tumble_world *w = weightless();
        tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
        tumble_shape s = tumble_shape_box(w, tumble_v(side, side, side), 1);
        tumble_body b = tumble_body_add(w, s, tumble_body_at(0, 0, 0));
        run(w, 0.1);
        double here = tumble_body_position(w, b).y / side;
        ck_assert(here > 0.1 && here < 0.5);
        if (rises == 0) rises = here;
        near(here, rises, 1e-12);
        tumble_world_free(w);
    }
}
END_TEST

// Omega h in a substep of 1/240 s.  Up to 10 rad a move turns by a third of a radian;
// beyond, by up to one, for no spin takes more than 32 of them.
// Rejects: so many moves as the spin of the moment asks for, which takes 5 in 100.
START_TEST(a_free_spin_keeps_energy_and_angular_momentum_at_any_rate)
{
    const tumble_vec3 axis[] = { { 1, 1e-3, 1e-3 }, { 1e-3, 1, 1e-3 },
                                 { 0.6, 0.6, 0.5 }, { 0.1, 0.7, 0.7 } };
    for (double turn = 0.1; turn < 31; turn *= 1.33)
        for (int k = 0; k < 4; k++) {
            tumble_world *w = weightless();
            tumble_body_options o = tumble_body_at(0, 0, 0);
            double rate = 240 * turn, share = turn < 10 ? 2e-3 : 2e-2;
            o.spin = tumble_v(rate * axis[k].x, rate * axis[k].y,
                              rate * axis[k].z);
            tumble_body_add(w, tumble_shape_box(w, tumble_v(1, 0.6, 0.3), 1), o);
            tumble_measures was = tumble_world_measure(w);
            for (int n = 0; n < 300; n++) {
                tumble_world_step(w);
                tumble_measures is = tumble_world_measure(w);
                near(is.kinetic / was.kinetic, 1, share);
                near_vec3(is.angular, was.angular.x, was.angular.y,
                          was.angular.z, 1e-11 * rate);
            }
            tumble_world_free(w);
        }
}
END_TEST

// A wheel hangs by its middle, and n rods hang round its rim.  The widest gap (m) of
// the rods' joints in a second.
static double widest_of_star(int n)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_body wheel = tumble_body_add(w, tumble_shape_cylinder(w, 0.1, 1, 20),
                                        tumble_body_at(0, 0, 0));
    tumble_shape rod = tumble_shape_capsule(w, 0.2, 0.02, 0.5);
    tumble_body hung[80];
    double widest = 0;
    tumble_joint_ball(w, tumble_body_ground(), wheel, tumble_v(0, 0.5, 0));
    tumble_body_set_velocity(w, wheel, tumble_v(1, 0, 0), tumble_v(0, 0, 0));
    for (int i = 0; i < n; i++) {
        double a = 2 * 3.14159265358979 * i / n, x = cos(a), z = sin(a);
        tumble_body_options o = tumble_body_at(x, -0.12, z);
        o.mask = 0;
        hung[i] = tumble_body_add(w, rod, o);
        tumble_joint_ball(w, wheel, hung[i], tumble_v(x, 0, z));
    }
    for (int f = 0; f < 60; f++) {
        tumble_world_step(w);
        for (int i = 0; i < n; i++) {
            double a = 2 * 3.14159265358979 * i / n;
            tumble_vec3 at = tumble_pose_to_world(tumble_body_pose(w, wheel),
                                                  tumble_v(cos(a), 0, sin(a)));
            tumble_vec3 end = tumble_pose_to_world(tumble_body_pose(w, hung[i]),
                                                   tumble_v(0, 0.12, 0));
            double x = at.x - end.x, y = at.y - end.y, z = at.z - end.z;
            widest = fmax(widest, sqrt(x * x + y * y + z * z));
        }
    }
    expect_fine(w);
    tumble_world_free(w);
    return widest;
}

// Rejects: a system in which all joints of a body are coupled to each other, and which
// leaves a hub of more than thirty to springs: they open by a millimetre.
START_TEST(hub_of_many_joints_holds_them_as_it_holds_few)
{
    double few = widest_of_star(8), many = widest_of_star(80);
    ck_assert_msg(few < 1e-6 && many < 1e-6, "%g m, %g m", few, many);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        hub_of_many_joints_holds_them_as_it_holds_few,
        heavy_ball_tears_no_bridge,
        a_strong_motor_in_a_tree_of_joints_loses_no_numbers,
        a_sensor_overlaps_nothing,
        a_paddle_does_not_go_through_what_it_hits,
        a_pinned_rope_keeps_its_numbers,
        what_was_lost_is_not_lost_again,
        a_joint_of_what_does_not_yield_bears_nothing,
        a_step_has_no_more_substeps_than_the_most,
        what_makes_makes_nothing_in_no_world,
        what_changes_changes_nothing_in_no_world,
        a_question_about_no_world_has_the_answer_zero,
        a_world_that_was_not_made_says_why_to_the_end,
        options_that_were_not_begun_are_refused,
        a_world_that_cannot_be_says_which_option,
        a_body_falls_as_galileo_says_and_lies,
        the_id_of_a_body_that_is_gone_is_refused,
        the_first_failure_is_the_one_that_is_kept,
        a_shape_stays_as_long_as_a_body_is_made_of_it,
        a_push_gives_velocity_and_spin,
        a_force_acts_for_one_step,
        a_torque_spins_by_the_inertia,
        a_sleeper_that_is_pushed_wakes_and_goes,
        a_pose_comes_back_as_it_was_set,
        a_matrix_is_the_rotation_that_made_it,
        a_kinematic_body_carries_what_lies_on_it,
        bodies_whose_masks_do_not_meet_pass,
        user_data_is_the_programs_own,
        a_box_on_a_hinge_swings_as_long_as_its_inertia_says,
        a_joint_goes_with_its_body_and_breaks_under_its_load,
        what_lies_on_a_plane_that_goes_falls,
        a_plane_in_the_place_of_another_has_contacts_of_its_own,
        a_joint_that_joins_nothing_is_refused,
        a_ray_meets_the_nearest_and_a_sweep_the_first,
        contacts_carry_the_weight_and_events_come_once,
        what_sleeps_beside_what_moves_still_touches,
        pieces_are_one_body,
        a_rope_hangs_from_its_pin_and_carries,
        a_loose_curtain_comes_to_rest,
        everything_is_drawn,
        every_shape_falls_and_lies_as_high_as_it_is,
        joints_hold_what_they_say,
        a_box_hangs_on_a_rope,
        cloth_meets_no_piece_of_what_it_hangs_on,
        a_box_rides_on_a_plate_that_goes_up,
        weights_over_a_drum_go_as_atwood_says,
        a_box_that_hangs_still_has_no_velocity,
        materials_cloth_and_filters_are_taken,
        nonsense_is_refused_in_a_sentence,
        balls_that_rain_on_balls_gain_nothing,
        an_overlap_goes_in_as_many_frames_at_any_size,
        a_free_spin_keeps_energy_and_angular_momentum_at_any_rate,
        a_stack_of_plates_gives_by_a_share_of_their_thickness,
        what_is_joined_gains_nothing_from_its_first_step,
        NULL
    };
    return suite_run((suite){
        .name = "program", .tests = tests, .seconds = 60,
        .repeated = { { what_few_substeps_cannot_follow_is_never_apart_in_silence,
                         1, 4 } }
    });
}
