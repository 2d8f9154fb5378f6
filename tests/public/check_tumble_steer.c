// check_tumble_steer.c - tests of lib/tumble.h: what a program asks of many
// bodies, and how it steers them.

#include "random.h"
#include "suite.h"
#include "tumble.h"

#include <check.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double fine = 1e-9;

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
    const char *why = tumble_failure(w);
    ck_assert_ptr_nonnull(why);
    ck_assert_msg(strstr(why, part) != NULL, "said: %s\nwanted: %s", why, part);
    tumble_forget_failure(w);
}

static void expect_fine(const tumble_world *w)
{
    const char *why = tumble_failure(w);
    ck_assert_msg(why == NULL, "failed: %s", why);
}

static tumble_world *weightless(void)
{
    tumble_options o = tumble_options_default();
    o.gravity = tumble_v(0, 0, 0);
    tumble_world *w = tumble_make(&o);
    ck_assert_ptr_nonnull(w);
    return w;
}

static tumble_world *with_floor(void)
{
    tumble_world *w = tumble_make(NULL);
    ck_assert_ptr_nonnull(w);
    ck_assert(tumble_add_plane(w, tumble_v(0, 1, 0), 0, -1).generation > 0);
    return w;
}

static void run(tumble_world *w, double seconds)
{
    int steps = (int)(seconds * 60 + 0.5);
    for (int k = 0; k < steps; k++) tumble_step(w);
}

static tumble_body add_box(tumble_world *w, double x, double y, double z)
{
    return tumble_add(w, tumble_box(w, tumble_v(1, 1, 1), 2),
                      tumble_at(x, y, z));
}

static tumble_body add_kind(tumble_world *w, tumble_kind kind, double x,
                            double y, double z)
{
    tumble_body_options o = tumble_at(x, y, z);
    o.kind = kind;
    return tumble_add(w, tumble_box(w, tumble_v(1, 1, 1), 2), o);
}

static bool is_same(tumble_body a, tumble_body b)
{
    return a.place == b.place && a.generation == b.generation;
}

// A world that was saved and loaded.
static tumble_world *copied(const tumble_world *w)
{
    size_t size = tumble_save(w, NULL, 0);
    void *bytes = malloc(size);
    ck_assert_ptr_nonnull(bytes);
    ck_assert_uint_eq(tumble_save(w, bytes, size), size);
    tumble_world *copy = tumble_load(bytes, size);
    ck_assert_msg(copy != NULL, "%s", tumble_failure(NULL));
    free(bytes);
    return copy;
}

// It goes on as w does.
static void goes_on_alike(tumble_world *w, int steps)
{
    tumble_world *copy = copied(w);
    for (int k = 0; k < steps; k++) {
        tumble_step(w);
        tumble_step(copy);
        ck_assert_uint_eq(tumble_hash(w), tumble_hash(copy));
    }
    tumble_free(copy);
}

// --- Many at once ------------------------------------------------------------
START_TEST(many_poses_are_those_of_each)
{
    enum { N = 40 };
    tumble_world *w = with_floor();
    tumble_body b[N + 1];
    for (int k = 0; k < N; k++) b[k] = add_box(w, k % 3, 1 + 1.1 * k, k % 2);
    b[N] = (tumble_body){ 0, 0 };
    tumble_remove(w, b[7]);
    run(w, 0.5);
    tumble_pose pose[N + 1];
    tumble_vec3 velocity[N + 1], spin[N + 1];
    tumble_get_poses(w, b, N + 1, pose);
    tumble_get_velocities(w, b, N + 1, velocity, NULL);
    tumble_get_velocities(w, b, N + 1, NULL, spin);
    for (int k = 0; k <= N; k++) {
        tumble_pose p = tumble_get_pose(w, b[k]);
        tumble_vec3 v = tumble_velocity(w, b[k]), s = tumble_spin(w, b[k]);
        ck_assert(memcmp(&p, &pose[k], sizeof p) == 0);
        ck_assert(memcmp(&v, &velocity[k], sizeof v) == 0);
        ck_assert(memcmp(&s, &spin[k], sizeof s) == 0);
        ck_assert((pose[k].rotation.w == 0) == (k == 7 || k == N));
    }
    expect_fine(w);
    tumble_free(w);
}
END_TEST

static bool has_moved(const tumble_world *w, tumble_body b)
{
    tumble_body moved[64];
    int n = tumble_moved(w, moved, 64);
    ck_assert_int_le(n, 64);
    bool found = false;
    for (int k = 0; k < n; k++) found |= is_same(moved[k], b);
    return found;
}

// All that are not named stand where they stood, to the bit, and a pile that has
// fallen asleep is named no more.
START_TEST(what_is_not_said_to_have_moved_has_not)
{
    enum { N = 24 };
    tumble_world *w = with_floor();
    tumble_body b[N];
    int most = 0, least = N;
    for (int k = 0; k < N - 3; k++)
        b[k] = add_box(w, 3 * (k % 7), 0.5 + 1.001 * (k / 7), 0);
    b[N - 3] = add_kind(w, TUMBLE_STATIC, 0, 0, 20);
    b[N - 2] = add_kind(w, TUMBLE_KINEMATIC, 0, 0, 40);
    b[N - 1] = tumble_add(w, tumble_rope(w, 8, 2, 1), tumble_at(0, 1, 60));
    ck_assert_int_eq(tumble_moved(w, NULL, 0), 0);
    for (int step = 0; step < 600; step++) {
        tumble_vec3 was[N], is[N];
        if (step == 300)
            tumble_set_velocity(w, b[N - 2], tumble_v(0, 0, 1),
                                tumble_v(0, 0, 0));
        for (int k = 0; k < N; k++) was[k] = tumble_vertex(w, b[k], 0);
        tumble_step(w);
        int n = tumble_moved(w, NULL, 0);
        most = n > most ? n : most;
        least = n < least ? n : least;
        for (int k = 0; k < N; k++) {
            is[k] = tumble_vertex(w, b[k], 0);
            if (!has_moved(w, b[k]))
                ck_assert(memcmp(&is[k], &was[k], sizeof *is) == 0);
        }
        ck_assert(!has_moved(w, b[N - 3]));
        ck_assert_int_eq(has_moved(w, b[N - 2]), step >= 300);
    }
    ck_assert_int_eq(most, N - 2);
    ck_assert_int_eq(least, 0);
    ck_assert_int_eq(tumble_moved(w, NULL, 0), 1);
    tumble_free(w);
}
END_TEST

// --- Joined bodies that meet ---------------------------------------------------
// A door before a wall, hinged a tenth of a metre away from its own side and from
// the wall's.  When it has swung down it leans on the wall with its lower corner,
// as far behind the hinge's line as it was before it: so it has turned by a
// quarter, and twice the angle under which the hinge sees that tenth.
static double place_after(bool asked, bool given_back, tumble_world **left)
{
    tumble_world *w = tumble_make(NULL);
    tumble_body_options o = tumble_at(0, -1, 0);
    o.kind = TUMBLE_STATIC;
    tumble_body wall = tumble_add(w, tumble_box(w, tumble_v(1, 3, 1), 1), o);
    tumble_body door = add_box(w, 1.2, 1.2, 0);
    tumble_joint j = tumble_hinge(w, wall, door, tumble_v(0.6, 0.6, 0),
                                  tumble_v(0, 0, 1));
    ck_assert(!tumble_may_touch(w, j));
    if (asked) ck_assert(tumble_set_touching(w, j, true));
    ck_assert_int_eq(tumble_may_touch(w, j), asked);
    tumble_push(w, door, tumble_v(0.5, 0, 0), tumble_v(1.2, 1.7, 0));
    run(w, 1);
    if (given_back) ck_assert(tumble_set_touching(w, j, false));
    double least = 0;
    for (int k = 0; k < 240; k++) {
        tumble_step(w);
        double place = tumble_joint_place(w, j);
        least = place < least ? place : least;
    }
    expect_fine(w);
    *left = w;
    return least;
}

START_TEST(a_door_stops_at_its_wall_if_it_may_touch_it)
{
    const double tenth = asin(0.1 / sqrt(1.22)), quarter = acos(0);
    tumble_world *w;
    near(place_after(true, false, &w), -quarter - 2 * tenth, 2e-3);
    goes_on_alike(w, 30);
    tumble_free(w);
    ck_assert(place_after(false, false, &w) < -2.2);
    tumble_free(w);
    ck_assert(place_after(true, true, &w) < -2.2);
    ck_assert(!tumble_set_touching(w, (tumble_joint){ 9, 1 }, true));
    expect_failure(w, "joint 9 is gone");
    ck_assert(!tumble_may_touch(w, (tumble_joint){ 9, 1 }));
    tumble_free(w);
}
END_TEST

// --- What is set is told -------------------------------------------------------
START_TEST(a_body_made_of_anothers_options_is_its_twin)
{
    tumble_world *w = weightless(), *other = weightless();
    int mine = 7;
    tumble_body_options o = tumble_at(1, 2, 3);
    o.pose.rotation = tumble_turn(tumble_v(1, 2, 3), 0.7);
    o.velocity = tumble_v(0.1, 0.2, 0.3);
    o.spin = tumble_v(-1, 0.5, 0.25);
    o.friction = 0.3;
    o.restitution = 0.4;
    o.damping = 0.01;
    o.spin_damping = 0.02;
    o.group = 6;
    o.mask = 9;
    o.user = &mine;
    tumble_shape s = tumble_box(w, tumble_v(1, 2, 3), 4);
    tumble_body b = tumble_add(w, s, o);
    tumble_body_options got = tumble_get_options(w, b);
    ck_assert_int_eq(got.kind, TUMBLE_DYNAMIC);
    near_vec3(got.pose.position, 1, 2, 3, fine);
    near(got.pose.rotation.w, o.pose.rotation.w, fine);
    near_vec3(got.velocity, 0.1, 0.2, 0.3, fine);
    near_vec3(got.spin, -1, 0.5, 0.25, fine);
    ck_assert(got.friction == 0.3 && got.restitution == 0.4);
    ck_assert(got.damping == 0.01 && got.spin_damping == 0.02);
    ck_assert(got.group == 6 && got.mask == 9 && got.user == &mine);
    tumble_shape of = tumble_shape_of(w, b);
    ck_assert(of.place == s.place && of.generation == s.generation);
    tumble_body twin = tumble_add(other, tumble_box(other, tumble_v(1, 2, 3), 4),
                                  got);
    run(w, 1);
    run(other, 1);
    tumble_vec3 x = tumble_vertex(w, b, 3), y = tumble_vertex(other, twin, 3);
    near_vec3(y, x.x, x.y, x.z, 1e-12);
    tumble_set_material(w, b, 0.6, 0.1);
    tumble_set_damping(w, b, 1, 2);
    tumble_set_filter(w, b, 2, 5);
    got = tumble_get_options(w, b);
    ck_assert(got.friction == 0.6 && got.restitution == 0.1);
    ck_assert(got.damping == 1 && got.spin_damping == 2);
    ck_assert(got.group == 2 && got.mask == 5);
    tumble_remove(w, b);
    expect_fine(w);
    ck_assert_uint_eq(tumble_shape_of(w, b).generation, 0);
    tumble_add(w, s, tumble_get_options(w, b));
    expect_failure(w, "group 0");
    tumble_free(w);
    tumble_free(other);
}
END_TEST

START_TEST(a_world_tells_its_options)
{
    tumble_options o = tumble_options_default();
    o.dt = 0.01;
    o.substeps = 7;
    o.friction = 0.2;
    tumble_world *w = tumble_make(&o);
    tumble_set_gravity(w, tumble_v(0, 0, -2));
    tumble_options got = tumble_get_world_options(w);
    ck_assert(got.dt == 0.01 && got.substeps == 7 && got.friction == 0.2);
    ck_assert(got.gravity.z == -2 && got.gravity.y == 0 && !got.run);
    ck_assert(tumble_get_world_options(NULL).dt == tumble_options_default().dt);
    tumble_free(w);
    tumble_options none = { 0 };
    ck_assert_ptr_null(tumble_make(&none));
    expect_failure(NULL, "dt is 0");
}
END_TEST

START_TEST(joints_are_listed_with_what_they_join)
{
    tumble_world *w = weightless();
    tumble_body a = add_box(w, 0, 0, 0), b = add_box(w, 3, 0, 0);
    tumble_joint j[2], got[2];
    j[0] = tumble_ball(w, a, b, tumble_v(1.5, 0, 0));
    j[1] = tumble_fix(w, b, tumble_ground(), tumble_v(3, 0, 0));
    ck_assert_int_eq(tumble_joints(w, got, 2), 2);
    for (int k = 0; k < 2; k++)
        ck_assert(got[k].place == j[k].place
                  && got[k].generation == j[k].generation);
    ck_assert(is_same(tumble_joint_body(w, j[0], 0), a));
    ck_assert(is_same(tumble_joint_body(w, j[0], 1), b));
    ck_assert(is_same(tumble_joint_body(w, j[1], 1), tumble_ground()));
    tumble_unjoin(w, j[0]);
    ck_assert_int_eq(tumble_joints(w, NULL, 0), 1);
    ck_assert_uint_eq(tumble_joint_body(w, j[0], 0).generation, 0);
    ck_assert_uint_eq(tumble_joint_body(w, j[1], 2).generation, 0);
    tumble_free(w);
}
END_TEST

// A point on a body goes with it, and comes back as the same point.
START_TEST(a_point_of_a_body_is_where_the_body_is)
{
    tumble_world *w = weightless();
    tumble_body b = add_box(w, 1, 2, 3);
    const tumble_vec3 corner = tumble_v(0.5, -0.5, 0.5);
    tumble_set_velocity(w, b, tumble_v(1, 0, 0), tumble_v(0.3, 2, -1));
    run(w, 1);
    tumble_pose p = tumble_get_pose(w, b);
    tumble_vec3 at = tumble_to_world(p, corner), back = tumble_to_local(p, at);
    near_vec3(back, 0.5, -0.5, 0.5, fine);
    tumble_vec3 v = tumble_vertex(w, b, 5);     // bits 0 and 2: +x, +z
    near_vec3(v, at.x, at.y, at.z, fine);
    tumble_quat quarter = tumble_turn(tumble_v(0, 0, 2), acos(0));
    near_vec3(tumble_rotate(quarter, tumble_v(1, 2, 3)), -2, 1, 3, fine);
    const tumble_pose none = { { 1, 1, 1 }, { 0, 0, 0, 0 } };
    near_vec3(tumble_to_world(none, corner), 1.5, 0.5, 1.5, fine);
    tumble_free(w);
}
END_TEST

START_TEST(the_version_is_told_as_words_and_as_a_number)
{
    int major, minor, patch;
    ck_assert_str_eq(tumble_version(), TUMBLE_VERSION);
    ck_assert_int_eq(sscanf(tumble_version(), "%d.%d.%d", &major, &minor,
                            &patch), 3);
    ck_assert_int_eq(tumble_version_number(),
                     10000 * major + 100 * minor + patch);
    ck_assert_int_eq(tumble_version_number(), TUMBLE_VERSION_NUMBER);
}
END_TEST

// A force F beside the centre of a cube of side 1 and mass m: v = F t / m, and its
// spin is that of the torque r F, with the inertia m / 6.
START_TEST(a_force_at_a_point_pushes_and_turns)
{
    tumble_world *w = weightless();
    tumble_body b = add_box(w, 4, 0, 0);
    ck_assert(tumble_force_at(w, b, tumble_v(0, 6, 0), tumble_v(4.3, 0, 0)));
    ck_assert(tumble_force_at(w, b, tumble_v(0, 6, 0), tumble_v(4.3, 0, 0)));
    tumble_step(w);
    near_vec3(tumble_velocity(w, b), 0, 12.0 / 60 / 2, 0, fine);
    near_vec3(tumble_spin(w, b), 0, 0, 0.3 * 12 / 60 / (2.0 / 6), 1e-6);
    tumble_step(w);
    near_vec3(tumble_velocity(w, b), 0, 12.0 / 60 / 2, 0, fine);
    tumble_body still = add_kind(w, TUMBLE_STATIC, 0, 9, 0);
    ck_assert(!tumble_force_at(w, still, tumble_v(1, 0, 0), tumble_v(0, 9, 0)));
    expect_failure(w, "static");
    ck_assert(!tumble_force_at(w, b, tumble_v(NAN, 0, 0), tumble_v(0, 9, 0)));
    expect_failure(w, "not finite");
    tumble_free(w);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        many_poses_are_those_of_each,
        what_is_not_said_to_have_moved_has_not,
        a_door_stops_at_its_wall_if_it_may_touch_it,
        a_body_made_of_anothers_options_is_its_twin,
        a_world_tells_its_options,
        joints_are_listed_with_what_they_join,
        a_point_of_a_body_is_where_the_body_is,
        the_version_is_told_as_words_and_as_a_number,
        a_force_at_a_point_pushes_and_turns,
        NULL
    };
    return suite_run((suite){ .name = "steer", .tests = tests, .seconds = 60 });
}
