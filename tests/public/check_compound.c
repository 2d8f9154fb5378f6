// check_compound.c - tests of tumble_body_add_compound: bodies of several
// pieces that move as one.  Book: chapter 18.

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

static void near_vec3(tumble_vec3 got, tumble_vec3 wanted, double tolerance)
{
    near(got.x, wanted.x, tolerance);
    near(got.y, wanted.y, tolerance);
    near(got.z, wanted.z, tolerance);
}

static tumble_world *made(double gravity, bool sleeps)
{
    tumble_options o = tumble_options_default();
    o.gravity = tumble_v(0, -gravity, 0);
    if (!sleeps) o.sleep_speed = 0;
    return tumble_world_make(&o);
}

static tumble_pose at(double x, double y, double z)
{
    return (tumble_pose){ { x, y, z }, { 0, 0, 0, 1 } };
}

static void run(tumble_world *w, double seconds)
{
    for (int k = 0; k < (int)(seconds * 60 + 0.5); k++) tumble_world_step(w);
}

static void fine(const tumble_world *w)
{
    ck_assert_msg(!tumble_world_failure(w), "%s", tumble_world_failure(w));
}

// Two balls of 2 kg and 1 kg, 1.5 m apart along x.
static tumble_body dumbbell(tumble_world *w, tumble_body_options o)
{
    tumble_shape ball[2] = { tumble_shape_sphere(w, 0.3, 2),
                             tumble_shape_sphere(w, 0.2, 1) };
    tumble_pose pose[2] = { at(0, 0, 0), at(1.5, 0, 0) };
    return tumble_body_add_compound(w, ball, pose, 2, o);
}

// I = sum of 2/5 m r^2 + m d^2: about x without the second term.
// Rejects: the inertia of one piece; of pieces about their own middles; a centre
// halfway.
START_TEST(a_dumbbell_has_the_inertia_of_its_balls)
{
    const double own = 0.4 * (2 * 0.09 + 1 * 0.04);
    const double across = own + 2 * 0.25 + 1 * 1;
    const tumble_vec3 arm[3] = { { 0, 0, 0.1 }, { 0, 0, 0.1 }, { 0.1, 0, 0 } };
    const tumble_vec3 push[3] = { { 0, -1, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
    const tumble_vec3 spin[3] = { { 0.1 / own, 0, 0 }, { 0, 0.1 / across, 0 },
                                  { 0, 0, 0.1 / across } };
    for (int k = 0; k < 3; k++) {
        tumble_world *w = made(0, false);
        tumble_body b = dumbbell(w, tumble_body_at(1, 2, 3));
        tumble_vec3 p = tumble_v(1.5 + arm[k].x, 2, 3 + arm[k].z);
        near(tumble_body_mass(w, b), 3, 1e-14);
        ck_assert(tumble_body_push(w, b, push[k], p));
        near_vec3(tumble_body_spin(w, b), spin[k], 1e-12);
        near_vec3(tumble_body_velocity(w, b),
                  tumble_v(push[k].x / 3, push[k].y / 3,
                           push[k].z / 3), 1e-12);
        fine(w);
        tumble_world_free(w);
    }
}
END_TEST

// Any pieces: what they have together is that of one box that is cut in eight,
// whose pieces are turned each in its own way.
START_TEST(a_box_in_pieces_is_the_box)
{
    tumble_vec3 end[2], spin[2];
    for (int k = 0; k < 2; k++) {
        tumble_world *w = made(0, false);
        tumble_shape s[8];
        tumble_pose p[8];
        for (int i = 0; i < 8; i++) {
            // Of sides 1, 0.5 and 1.5; turned by right angles about an axis.
            bool is_turned = i % 2 == 1;
            s[i] = tumble_shape_box(w, is_turned ? tumble_v(0.25, 0.5, 0.75)
                                           : tumble_v(0.5, 0.25, 0.75), 1);
            p[i] = at(i & 1 ? 0.25 : -0.25, i & 2 ? 0.125 : -0.125,
                      i & 4 ? 0.375 : -0.375);
            if (is_turned)
                p[i].rotation = tumble_quat_turn(tumble_v(0, 0, 1),
                                                 1.5707963267948966);
        }
        tumble_shape whole = tumble_shape_box(w, tumble_v(1, 0.5, 1.5), 8);
        tumble_body_options o = tumble_body_at(0, 0, 0);
        o.spin = tumble_v(1, 3, 0.2);
        o.velocity = tumble_v(0.5, 0, 0);
        tumble_body b = k == 0 ? tumble_body_add(w, whole, o)
                               : tumble_body_add_compound(w, s, p, 8, o);
        run(w, 2);
        tumble_pose now = tumble_body_pose(w, b);
        double m[9];
        tumble_quat_matrix(now.rotation, m);
        end[k] = tumble_v(now.position.x + m[0], m[3], m[6]);
        spin[k] = tumble_body_spin(w, b);
        fine(w);
        tumble_world_free(w);
    }
    near_vec3(end[1], end[0], 1e-9);
    near_vec3(spin[1], spin[0], 1e-9);
}
END_TEST

// A dumbbell on a ball joint: T = 2 pi sqrt(I / (m g d)), for small swings, and
// its energy and momentum when nothing pulls.
START_TEST(a_compound_pendulum_swings_with_its_period)
{
    const double g = 9.81, d = 1;       // m, from the joint to the centre
    tumble_world *w = made(g, false);
    tumble_body_options o = tumble_body_at(0, 0, 0);
    // Hangs along -y: its x goes down, leaned by 0.02.
    o.pose.rotation = tumble_quat_turn(tumble_v(0, 0, 1),
                                       -1.5707963267948966 + 0.02);
    tumble_body b = dumbbell(w, o);
    // The centre of mass is 0.5 m from the first ball; the joint 0.5 m above it.
    double c = cos(-1.5707963267948966 + 0.02), s = sin(-1.5707963267948966 + 0.02);
    tumble_joint_hinge(w, tumble_body_ground(), b,
                       tumble_v(-0.5 * c, -0.5 * s, 0), tumble_v(0, 0, 1));
    const double inertia = 0.4 * (2 * 0.09 + 0.04) + 2 * 0.25 + 1 + 3 * d * d;
    const double wanted = 2 * 3.14159265358979 * sqrt(inertia / (3 * g * d));
    double first = 0, last = 0, was = tumble_body_spin(w, b).z;
    int n = 0;
    for (int k = 1; k < 2000 && n < 9; k++) {
        tumble_world_step(w);
        double now = tumble_body_spin(w, b).z;
        if (was < 0 && now >= 0) {
            last = (k - now / (now - was)) / 60;
            if (n++ == 0) first = last;
        }
        was = now;
    }
    near((last - first) / (n - 1) / wanted, 1, 0.001);
    fine(w);
    tumble_world_free(w);
}
END_TEST

START_TEST(what_spins_freely_keeps_energy_and_momentum)
{
    tumble_world *w = made(0, false);
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.spin = tumble_v(3, 0.5, 2);
    o.velocity = tumble_v(0, 1, 0);
    tumble_shape s[3] = { tumble_shape_box(w, tumble_v(1, 0.2, 0.3), 2),
                          tumble_shape_capsule(w, 0.5, 0.1, 0.5),
                          tumble_shape_sphere(w, 0.2, 1) };
    tumble_pose p[3] = { at(0, 0, 0), at(0.4, 0.3, 0.1), at(-0.5, -0.1, 0.4) };
    tumble_body_add_compound(w, s, p, 3, o);
    tumble_world_step(w);
    tumble_measures was = tumble_world_measure(w);
    run(w, 10);
    tumble_measures now = tumble_world_measure(w);
    near(now.kinetic / was.kinetic, 1, 1e-3);
    near_vec3(now.momentum, was.momentum, 1e-9);
    near_vec3(now.angular, was.angular, 1e-9);
    ck_assert(now.kinetic > 1);
    near(now.penetration, 0, 0);
    fine(w);
    tumble_world_free(w);
}
END_TEST

// An L of two boxes of one density, on a slope with much friction: it stands up to
// the slope at which its centre of mass is over its edge.  Its foot is 0.9 m long
// and 0.3 m high, its leg 0.3 m wide and 0.9 m high, over the foot's end.
static bool l_topples(double degrees)
{
    tumble_world *w = made(9.81, true);
    double turn = degrees * 3.14159265358979 / 180;
    tumble_plane f = tumble_plane_add(w, tumble_v(sin(turn), cos(turn), 0), 0, 5);
    (void)f;
    tumble_shape s[2] = { tumble_shape_box(w, tumble_v(0.9, 0.3, 0.5), 3),
                          tumble_shape_box(w, tumble_v(0.3, 0.9, 0.5), 3) };
    tumble_pose p[2] = { at(0.45, 0.15, 0), at(0.75, 0.75, 0) };
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.friction = 5;
    o.pose.rotation = tumble_quat_turn(tumble_v(0, 0, 1), -turn);
    tumble_body b = tumble_body_add_compound(w, s, p, 2, o);
    run(w, 6);
    double m[9];
    tumble_quat_matrix(tumble_body_pose(w, b).rotation, m);
    bool has_fallen = m[4] < cos(turn) - 0.1;
    ck_assert_msg(has_fallen || tumble_world_measure(w).kinetic < 1e-6,
                  "it neither stands nor falls at %g", degrees);
    fine(w);
    tumble_world_free(w);
    return has_fallen;
}

// Downhill is +x.  The centre is at x = 0.6, y = 0.45, and the edge at x = 0.9: it
// falls beyond tan a = 0.3 / 0.45, 33.7 degrees.
// Rejects: the centre of the first piece (0.45 / 0.15: 71 degrees), or a piece
// that touches nothing.
START_TEST(an_l_topples_at_its_slope)
{
    ck_assert(!l_topples(32.7));
    ck_assert(l_topples(34.7));
}
END_TEST

// Each piece meets what it meets: a table's four legs stand on the floor, a ball
// lies on its top, and one lies between its legs.
START_TEST(each_piece_touches_and_holds)
{
    tumble_world *w = made(9.81, true);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_shape s[5] = { tumble_shape_box(w, tumble_v(1.2, 0.1, 1.2), 4) };
    tumble_pose p[5] = { at(0, 1, 0) };
    for (int k = 1; k < 5; k++) {
        s[k] = k == 1 ? tumble_shape_box(w, tumble_v(0.1, 1, 0.1), 1) : s[1];
        p[k] = at(k % 2 ? 0.5 : -0.5, 0.45, k < 3 ? 0.5 : -0.5);
    }
    tumble_body table = tumble_body_add_compound(w, s, p, 5,
                                                 tumble_body_at(0, 0.06, 0));
    tumble_shape ball = tumble_shape_box(w, tumble_v(0.3, 0.3, 0.3), 1);
    tumble_body on = tumble_body_add(w, ball, tumble_body_at(0.1, 1.4, 0));
    tumble_body under = tumble_body_add(w, ball, tumble_body_at(0, 0.2, 0));
    // Steps go on while all of them sleep.
    tumble_body_options o = tumble_body_at(50, 5, 0);
    o.kind = TUMBLE_KINEMATIC;
    o.spin = tumble_v(0, 1, 0);
    tumble_body_add(w, ball, o);
    run(w, 4);
    near(tumble_body_position(w, table).y, 0.05, 0.003);
    near(tumble_body_position(w, on).y, 1.25, 0.005);
    near(tumble_body_position(w, under).y, 0.15, 0.003);
    near(tumble_world_measure(w).penetration, 0, 0.003);
    ck_assert(!tumble_body_is_awake(w, table) && !tumble_body_is_awake(w, on));
    ck_assert_int_eq(tumble_world_last_step(w).asleep, 3);
    // A push wakes the table and what lies on it, and it slides.
    tumble_body_push(w, table, tumble_v(8, 0, 0), tumble_v(0, 0.775, 0));
    run(w, 0.1);
    ck_assert(tumble_body_is_awake(w, table) && tumble_body_is_awake(w, on));
    ck_assert(tumble_body_position(w, table).x > 0.03);
    // And its legs still stand on the floor.
    run(w, 2);
    near(tumble_body_position(w, table).y, 0.05, 0.003);
    fine(w);
    tumble_world_free(w);
}
END_TEST

// What comes at a piece that sleeps wakes all of it.
START_TEST(what_strikes_a_piece_wakes_the_body)
{
    tumble_world *w = made(9.81, true);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_shape s[2] = { tumble_shape_box(w, tumble_v(2, 0.2, 0.5), 1),
                          tumble_shape_box(w, tumble_v(0.2, 0.6, 0.5), 1) };
    tumble_pose p[2] = { at(0, 0.1, 0), at(0.9, 0.5, 0) };
    tumble_body b = tumble_body_add_compound(w, s, p, 2,
                                             tumble_body_at(0, 0, 0));
    run(w, 3);
    ck_assert(!tumble_body_is_awake(w, b));
    tumble_body_options o = tumble_body_at(3, 0.6, 0);
    o.velocity = tumble_v(-8, 2, 0);
    tumble_body_add(w, tumble_shape_sphere(w, 0.15, 2), o);
    run(w, 1);
    ck_assert(tumble_body_position(w, b).x < -0.05);
    fine(w);
    tumble_world_free(w);
}
END_TEST

// A ray and an overlap find the piece, and name the body; its points are drawn
// where its pieces are; what is put elsewhere takes all pieces along; a body that
// is removed leaves none.
START_TEST(questions_drawing_and_removal_are_of_all_pieces)
{
    tumble_world *w = made(0, false);
    tumble_body_options o = tumble_body_at(2, 0, 0);
    o.pose.rotation = tumble_quat_turn(tumble_v(0, 0, 1), 1.5707963267948966);
    tumble_body b = dumbbell(w, o), found;
    tumble_hit hit;
    // The small ball is at (2, 1.5, 0).
    ck_assert(tumble_world_ray(w, tumble_v(2, 1.5, 5), tumble_v(2, 1.5, -5),
                               ~0u, &hit));
    near_vec3(hit.point, tumble_v(2, 1.5, 0.2), 1e-9);
    ck_assert_uint_eq(hit.body.place, b.place);
    tumble_shape probe = tumble_shape_sphere(w, 0.1, 1);
    ck_assert_int_eq(tumble_world_overlap(w, probe, at(2, 1.6, 0), ~0u, &found,
                                          1), 1);
    ck_assert_int_eq(tumble_world_overlap(w, probe, at(2, 0.8, 0), ~0u, &found,
                                          1), 0);
    tumble_vec3 point[800];
    int n = tumble_body_vertices(w, b, point, 800);
    double high = -9, low = 9;
    ck_assert(n > 0 && n <= 800);
    for (int k = 0; k < n; k++) {
        high = fmax(high, point[k].y);
        low = fmin(low, point[k].y);
    }
    near(high, 1.7, 1e-9);
    near(low, -0.3, 1e-9);
    ck_assert(tumble_body_set_pose(w, b, at(-4, 0, 0)));
    tumble_world_step(w);
    ck_assert(tumble_world_ray(w, tumble_v(-2.5, 0, 5), tumble_v(-2.5, 0, -5),
                               ~0u, &hit));
    near(hit.point.z, 0.2, 1e-9);
    ck_assert(tumble_body_remove(w, b));
    ck_assert(!tumble_world_ray(w, tumble_v(-2.5, 0, 5), tumble_v(-2.5, 0, -5),
                                ~0u, &hit));
    tumble_body c = dumbbell(w, tumble_body_at(0, 0, 0));
    ck_assert(tumble_body_exists(w, c) && tumble_world_bodies(w, NULL, 0) == 1);
    run(w, 0.1);
    fine(w);
    tumble_world_free(w);
}
END_TEST

// A leg that comes down slowly, within what was found once, is stopped.
// Rejects: pieces of which nobody knows how far they have gone.
START_TEST(what_comes_slowly_is_stopped_at_its_piece)
{
    tumble_world *w = made(0, false);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_shape s[2] = { tumble_shape_box(w, tumble_v(2, 0.1, 0.1), 1),
                          tumble_shape_box(w, tumble_v(0.1, 1, 0.1), 1) };
    tumble_pose p[2] = { at(0, 1.05, 0), at(0, 0.5, 0) };
    double deepest = 0;
    for (int k = 0; k < 10; k++) {
        tumble_body_options o = tumble_body_at(3 * k, 0.01 + 0.003 * k, 0);
        o.velocity = tumble_v(0, -0.06, 0);
        tumble_body_add_compound(w, s, p, 2, o);
    }
    for (int k = 0; k < 90; k++) {
        tumble_world_step(w);
        deepest = fmax(deepest, tumble_world_measure(w).penetration);
    }
    near(deepest, 0, 0.0005);
    fine(w);
    tumble_world_free(w);
}
END_TEST

// A sheet that flies at one of the pieces gives the body what it loses.
START_TEST(cloth_pushes_the_body_of_a_piece)
{
    tumble_world *w = made(0, false);
    tumble_shape s[2] = { tumble_shape_box(w, tumble_v(0.4, 0.4, 0.4), 1),
                          tumble_shape_box(w, tumble_v(0.5, 0.4, 0.5), 1) };
    tumble_pose p[2] = { at(-1.5, 0, 0), at(0, 0, 0) };
    tumble_body b = tumble_body_add_compound(w, s, p, 2,
                                             tumble_body_at(0, 0, 0));
    tumble_body_options o = tumble_body_at(0, 0.5, 0);
    o.velocity = tumble_v(0, -2, 0);
    tumble_body_add(w, tumble_shape_cloth(w, 12, 12, 1, 1, 1), o);
    run(w, 1);
    ck_assert(tumble_body_velocity(w, b).y < -0.2);
    near(tumble_world_measure(w).momentum.y, -2, 0.02);
    fine(w);
    tumble_world_free(w);
}
END_TEST

// A sheet that falls on a cross of two bars hangs over both, and presses on it as
// it weighs.
START_TEST(cloth_lies_on_all_pieces)
{
    tumble_world *w = made(9.81, true);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_shape s[2] = { tumble_shape_box(w, tumble_v(1.6, 0.3, 0.3), 5),
                          tumble_shape_box(w, tumble_v(0.3, 0.3, 1.6), 5) };
    tumble_pose p[2] = { at(0, 0, 0), at(0, 0, 0) };
    tumble_body b = tumble_body_add_compound(w, s, p, 2,
                                             tumble_body_at(0, 0.15, 0));
    tumble_body sheet =
        tumble_body_add(w, tumble_shape_cloth(w, 15, 15, 1.6, 1.6, 0.5),
                        tumble_body_at(0, 0.6, 0));
    run(w, 2);
    double edge[2] = { tumble_body_vertex(w, sheet, 7).y,
                       tumble_body_vertex(w, sheet, 7 * 15).y };
    ck_assert_msg(edge[0] > 0.27 && edge[1] > 0.27, "%g and %g", edge[0], edge[1]);
    ck_assert(tumble_body_vertex(w, sheet, 0).y < 0.25);
    near(tumble_body_position(w, b).y, 0.15, 0.003);
    fine(w);
    tumble_world_free(w);
}
END_TEST

// Loaded, it goes on with the same bits.
START_TEST(a_saved_compound_goes_on)
{
    tumble_world *w = made(9.81, true);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    for (int k = 0; k < 6; k++) {
        tumble_body_options o = tumble_body_at(0.1 * k, 0.5 + 0.7 * k,
                                               0.05 * k);
        o.spin = tumble_v(0, k, 1);
        tumble_body b = dumbbell(w, o);
        if (k == 3) tumble_body_remove(w, b);
    }
    for (int k = 0; k < 6; k++) {
        run(w, 0.5);
        size_t size = tumble_world_save(w, NULL, 0);
        void *bytes = malloc(size);
        tumble_world_save(w, bytes, size);
        tumble_world *copy = tumble_world_load(bytes, size);
        ck_assert_ptr_nonnull(copy);
        run(w, 0.5);
        run(copy, 0.5);
        ck_assert_uint_eq(tumble_world_hash(w), tumble_world_hash(copy));
        free(bytes);
        tumble_world_free(copy);
    }
    fine(w);
    tumble_world_free(w);
}
END_TEST

// Two doors on one hinge, whose pieces overlap there: what is joined does not meet.
START_TEST(joined_bodies_do_not_meet_with_any_piece)
{
    tumble_world *w = made(0, false);
    tumble_shape s[2] = { tumble_shape_box(w, tumble_v(1, 0.2, 0.2), 1),
                          tumble_shape_box(w, tumble_v(0.2, 1, 0.2), 1) };
    tumble_pose p[2] = { at(0, 0, 0), at(0.4, 0.55, 0) };
    tumble_body a = tumble_body_add_compound(w, s, p, 2,
                                             tumble_body_at(0, 0, 0));
    tumble_body b = tumble_body_add_compound(w, s, p, 2,
                                             tumble_body_at(0.3, 0, 0));
    tumble_joint_hinge(w, a, b, tumble_v(0, 0, 0), tumble_v(0, 0, 1));
    run(w, 1);
    near(tumble_world_measure(w).kinetic, 0, 1e-20);
    fine(w);
    tumble_world_free(w);
}
END_TEST

// A wavy ground of triangles, in a wide bowl, carries each piece.
// Rejects: the second piece of a body pushed into the ground, because it was asked
// by the number of the body.
START_TEST(pieces_lie_on_triangles)
{
    tumble_world *w = made(9.81, true);
    double height[441];
    for (int k = 0; k < 441; k++) {
        int x = k % 21 - 10, z = k / 21 - 10;
        height[k] = 0.1 * sin(k % 21) * cos(0.7 * (k / 21))
                  + 0.01 * (x * x + z * z);
    }
    tumble_body_options o = tumble_body_at(0, 0, 0);
    tumble_body_add_heights(w, height, 21, 21, 20, 20, 0, o);
    for (int k = 0; k < 9; k++) {
        o = tumble_body_at(3 * (k % 3) - 3, 1, 3 * (k / 3) - 3);
        o.spin = tumble_v(k, 1, 2);
        dumbbell(w, o);
    }
    for (int k = 0; k < 90; k++) {
        run(w, 1.0 / 6);
        ck_assert(tumble_world_measure(w).penetration < 0.01);
    }
    fine(w);
    tumble_world_free(w);
}
END_TEST

static void refused(int n, tumble_kind kind, bool is_rope, double side,
                    const char *why)
{
    tumble_world *w = made(0, false);
    tumble_shape s = is_rope ? tumble_shape_rope(w, 5, 1, 1)
                             : tumble_shape_box(w, tumble_v(1, 1, 1), 1);
    tumble_pose p = at(0, side, 0);
    tumble_body_options o = tumble_body_at(0, 0, 0);
    o.kind = kind;
    tumble_body b = tumble_body_add_compound(w, &s, &p, n, o);
    ck_assert(!tumble_body_exists(w, b)
              && tumble_world_bodies(w, NULL, 0) == 0);
    ck_assert_msg(strstr(tumble_world_failure(w), why) != NULL, "%s",
                  tumble_world_failure(w));
    tumble_world_free(w);
}

START_TEST(pieces_that_are_none_are_refused)
{
    refused(0, TUMBLE_DYNAMIC, false, 0, "0 pieces");
    refused(1, TUMBLE_STATIC, false, 0, "dynamic");
    refused(1, TUMBLE_KINEMATIC, false, 0, "dynamic");
    refused(1, TUMBLE_DYNAMIC, true, 0, "rope or a cloth");
    refused(1, TUMBLE_DYNAMIC, false, NAN, "");
    tumble_world *w = made(0, false);
    const tumble_shape none = { 7, 1 };
    const tumble_pose p = at(0, 0, 0);
    tumble_body b = tumble_body_add_compound(w, &none, &p, 1,
                                             tumble_body_at(0, 0, 0));
    ck_assert(!tumble_body_exists(w, b));
    ck_assert(tumble_world_failure(w) != NULL);
    tumble_world_free(w);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        a_dumbbell_has_the_inertia_of_its_balls,
        a_box_in_pieces_is_the_box,
        a_compound_pendulum_swings_with_its_period,
        what_spins_freely_keeps_energy_and_momentum,
        an_l_topples_at_its_slope,
        each_piece_touches_and_holds,
        what_strikes_a_piece_wakes_the_body,
        questions_drawing_and_removal_are_of_all_pieces,
        what_comes_slowly_is_stopped_at_its_piece,
        cloth_pushes_the_body_of_a_piece,
        cloth_lies_on_all_pieces,
        joined_bodies_do_not_meet_with_any_piece,
        pieces_lie_on_triangles,
        a_saved_compound_goes_on,
        pieces_that_are_none_are_refused,
        NULL
    };
    return suite_run((suite){ .name = "compound", .tests = tests,
                              .seconds = 60 });
}
