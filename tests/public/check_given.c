// check_given.c - tests of lib/tumble.h: does everything that a world, a body or a
// joint is given have its effect?

#include "crossings.h"
#include "scarce.h"
#include "suite.h"
#include "tumble.h"

#include <check.h>
#include <math.h>

static void near(double got, double wanted, double tolerance)
{
    ck_assert_msg(fabs(got - wanted) <= tolerance, "got %.17g, wanted %.17g",
                  got, wanted);
}

static void run(tumble_world *w, double seconds)
{
    for (int k = 0; k < (int)(seconds * 60 + 0.5); k++) tumble_world_step(w);
}

static tumble_world *of(const tumble_options *o)
{
    tumble_world *w = tumble_world_make(o);
    ck_assert_ptr_nonnull(w);
    return w;
}

static tumble_world *weightless(void)
{
    tumble_options o = tumble_options_default();
    o.gravity = tumble_v(0, 0, 0);
    return of(&o);
}

static tumble_world *with_floor(const tumble_options *o)
{
    tumble_world *w = of(o);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    return w;
}

static tumble_shape a_box(tumble_world *w)
{
    return tumble_shape_box(w, tumble_v(1, 1, 1), 2);
}

static tumble_body add_box(tumble_world *w, double x, double y, double z)
{
    return tumble_body_add(w, a_box(w), tumble_body_at(x, y, z));
}

static void expect_fine(const tumble_world *w)
{
    const char *why = tumble_world_failure(w);
    ck_assert_msg(why == NULL, "failed: %s", why);
}

// --- Options of a world ------------------------------------------------------

// A box slides at 4 m/s: it stops after v^2 / (2 mu g).  Those of the body and of
// the plane meet in the root of their product.
START_TEST(friction_is_the_worlds_or_a_planes_or_a_bodys)
{
    const double world[] = { 0.2, 0.2, 0.2 }, plane[] = { -1, 0.8, 0.8 };
    const double body[] = { -1, -1, 0.4 };
    for (int k = 0; k < 3; k++) {
        tumble_options o = tumble_options_default();
        o.friction = world[k];
        tumble_world *w = of(&o);
        tumble_plane_add(w, tumble_v(0, 1, 0), 0, plane[k]);
        tumble_body_options p = tumble_body_at(0, 0.5, 0);
        p.friction = body[k];
        p.velocity = tumble_v(4, 0, 0);
        tumble_body b = tumble_body_add(w, a_box(w), p);
        double of_plane = plane[k] < 0 ? world[k] : plane[k];
        double of_body = body[k] < 0 ? world[k] : body[k];
        run(w, 5);
        near(tumble_body_position(w, b).x,
             16 / (2 * sqrt(of_plane * of_body) * 9.81), 0.08);
        expect_fine(w);
        tumble_world_free(w);
    }
}
END_TEST

// A ball falls a metre and comes back to e^2.
START_TEST(restitution_is_the_worlds_or_a_bodys)
{
    const double world[] = { 0.7, 0, 0.1 }, body[] = { -1, 0.5, 0.8 };
    for (int k = 0; k < 3; k++) {
        tumble_options o = tumble_options_default();
        o.restitution = world[k];
        tumble_world *w = with_floor(&o);
        tumble_body_options p = tumble_body_at(0, 1.5, 0);
        p.restitution = body[k];
        tumble_body b = tumble_body_add(w, tumble_shape_sphere(w, 0.5, 1), p);
        double e = body[k] < 0 ? world[k] : body[k], high = 0;
        run(w, 0.5);
        for (int i = 0; i < 60; i++) {
            tumble_world_step(w);
            high = fmax(high, tumble_body_position(w, b).y - 0.5);
        }
        near(high, e * e, 0.02);
        tumble_world_free(w);
    }
}
END_TEST

static int steps_to_sleep(double sleep_speed, double time_to_sleep)
{
    tumble_options o = tumble_options_default();
    o.sleep_speed = sleep_speed;
    o.time_to_sleep = time_to_sleep;
    tumble_world *w = with_floor(&o);
    tumble_body b = add_box(w, 0, 0.5, 0);
    int k = 0;
    while (k < 400 && tumble_body_is_awake(w, b)) {
        tumble_world_step(w);
        k++;
    }
    ck_assert_int_eq(tumble_world_last_step(w).asleep, k < 400);
    tumble_world_free(w);
    return k;
}

START_TEST(sleep_is_as_options_say)
{
    ck_assert_int_eq(steps_to_sleep(0, 0.5), 400);
    int soon = steps_to_sleep(0.005, 0.5), late = steps_to_sleep(0.005, 2);
    ck_assert_int_ge(soon, 30);
    ck_assert_int_ge(late, 120);
    ck_assert_int_lt(late, 240);
    ck_assert_int_lt(soon, 60);
}
END_TEST

static int substeps_of(tumble_world *w)
{
    int most = 0;
    for (int i = 0; i < 60; i++) {
        tumble_world_step(w);
        int now = tumble_world_last_step(w).substeps;
        most = now > most ? now : most;
    }
    return most;
}

START_TEST(substeps_are_as_many_as_options_let_them_be)
{
    for (int k = 0; k < 2; k++) {
        tumble_options o = tumble_options_default();
        o.substeps = k ? 3 : 12;
        o.most_substeps = k ? 5 : 12;
        o.restitution = 0.5;
        tumble_world *w = with_floor(&o);
        for (int i = 0; i < 5; i++) add_box(w, 0.1 * i, 0.5 + i, 0);
        int most = substeps_of(w);
        ck_assert_int_ge(most, o.substeps / 2);
        ck_assert_int_le(most, o.most_substeps);
        tumble_world_free(w);
    }
}
END_TEST

// A rope of twenty links that bears 5,000 times its weight takes many.
START_TEST(a_hard_step_takes_no_more_substeps_than_it_may)
{
    int taken[2];
    for (int k = 0; k < 2; k++) {
        tumble_options o = tumble_options_default();
        if (k == 1) o.most_substeps = 12;
        tumble_world *w = of(&o);
        tumble_body rope = tumble_body_add(w, tumble_shape_rope(w, 20, 1, 0.01),
                                           tumble_body_at(0, 0, 0));
        tumble_body load =
            tumble_body_add(w, tumble_shape_box(w, tumble_v(1, 1, 1), 50),
                            tumble_body_at(0.5, -0.5, 0));
        tumble_body_pin(w, rope, 0);
        tumble_joint_hang(w, rope, 20, load);
        taken[k] = substeps_of(w);
        tumble_world_free(w);
    }
    ck_assert_int_gt(taken[0], 12);
    ck_assert_int_le(taken[1], 12);
}
END_TEST

static int items_run;

static void backwards(void *context, void (*work)(void *data, int item),
                      void *data, int items)
{
    ck_assert_ptr_eq(context, &items_run);
    for (int k = items - 1; k >= 0; k--) work(data, k);
    items_run += items;
}

// From the start, or later, or no more.
START_TEST(work_is_run_by_the_program_if_it_wants)
{
    unsigned long long hash[3];
    for (int k = 0; k < 3; k++) {
        tumble_options o = tumble_options_default();
        if (k == 1) o.run = backwards, o.context = &items_run;
        tumble_world *w = with_floor(&o);
        for (int i = 0; i < 60; i++)
            add_box(w, 1.1 * (i % 5), 0.5 + i / 20, 1.1 * (i / 5 % 4));
        items_run = 0;
        if (k == 2) tumble_world_run_on(w, backwards, &items_run);
        run(w, 0.2);
        ck_assert(k == 0 ? items_run == 0 : items_run > 24);
        items_run = 0;
        tumble_world_run_on(w, NULL, NULL);
        run(w, 0.2);
        ck_assert_int_eq(items_run, 0);
        hash[k] = tumble_world_hash(w);
        tumble_world_free(w);
    }
    ck_assert(hash[0] == hash[1] && hash[0] == hash[2]);
}
END_TEST

// --- What a step reports -----------------------------------------------------

// How many edges of the body pass through a triangle of the sheet?
static int edges_through(const tumble_world *w, tumble_body b, tumble_body sheet)
{
    enum { MOST = 400 };
    static solid hard;
    tumble_vec3 at[MOST];
    vec3 place[MOST];
    int faces, count = 0, n = tumble_body_vertices(w, b, at, MOST);
    const int *face = tumble_body_triangles(w, b, &faces);
    for (int i = 0; i < n; i++) place[i] = vec3_make(at[i].x, at[i].y, at[i].z);
    solid_make(&hard, place, n, face, faces);
    n = tumble_body_vertices(w, sheet, at, MOST);
    face = tumble_body_triangles(w, sheet, &faces);
    for (int i = 0; i < n; i++) place[i] = vec3_make(at[i].x, at[i].y, at[i].z);
    for (int i = 0; i < faces; i++) {
        patch p = patch_make(place, &face[3 * i], 0);
        count += solid_edges_through(&hard, &p);
    }
    return count;
}

// Of all sizes: no thread is stretched, and the body is through it, with a proof and
// without.  (It was said of threads alone.)
START_TEST(a_report_says_that_a_body_is_through_cloth)
{
    for (int k = 0; k < 8; k++) {
        static const double sizes[] = { 0.01, 0.1, 1, 10 };
        double size = sizes[k % 4];
        tumble_options none = tumble_options_default();
        none.gravity = tumble_v(0, 0, 0);
        none.certified = k < 4;
        tumble_world *w = of(&none);
        tumble_body sheet = tumble_body_add(
            w, tumble_shape_cloth(w, 9, 9, size, size, 0.1 * size * size),
            tumble_body_at(0, 0, 0));
        for (int i = 0; i < 81; i++) tumble_body_pin(w, sheet, i);
        tumble_body_options o = tumble_body_at(0, size, 0.03 * size);
        o.kind = TUMBLE_KINEMATIC;
        o.pose.rotation = tumble_quat_turn(tumble_v(1, 0, 0.3), 0.5);
        tumble_body b = tumble_body_add(
            w, tumble_shape_box(w, tumble_v(0.3 * size, size, 0.3 * size), 1), o);
        tumble_world_step(w);
        ck_assert_int_eq(tumble_world_last_step(w).unconverged, 0);
        o.pose.position.y = 0.4 * size;
        tumble_body_set_pose(w, b, o.pose);
        tumble_world_step(w);
        ck_assert_int_eq(tumble_world_last_step(w).unconverged, 1);
        tumble_world_free(w);
    }
}
END_TEST

// A sheet held by its corners, and a box thrust in its middle, an edge or a corner
// first.  Returns how many frames end with an edge of the box through a triangle.
static int frames_cut(double size, double dt, int side, int turn, double mass)
{
    tumble_options o = tumble_options_default();
    o.dt = dt;
    o.gravity = tumble_v(0, 0, 0);
    tumble_world *w = of(&o);
    tumble_body sheet = tumble_body_add(
        w, tumble_shape_cloth(w, side, side, size, size, 0.2 * size * size),
        tumble_body_at(0, 0, 0));
    const int corner[] = { 0, side - 1, side * (side - 1), side * side - 1 };
    for (int k = 0; k < 4; k++) tumble_body_pin(w, sheet, corner[k]);
    tumble_body_options at = tumble_body_at(0.02 * size, 0.25 * size, 0.01 * size);
    at.kind = mass > 0 ? TUMBLE_DYNAMIC : TUMBLE_KINEMATIC;
    at.velocity = tumble_v(0, -size, 0);
    at.spin = tumble_v(0, turn, 0);
    at.pose.rotation = tumble_quat_turn(tumble_v(1, 0.3, 0.8), 0.8);
    tumble_vec3 sides = { 0.3 * size, (turn ? 0.02 : 0.2) * size, 0.2 * size };
    tumble_body box = tumble_body_add(
        w, tumble_shape_box(w, sides, mass > 0 ? mass * size * size : 1), at);
    int frames = 0;
    for (int k = 0; k < (int)(0.5 / dt); k++) {
        tumble_world_step(w);
        frames += edges_through(w, box, sheet) > 0;
    }
    tumble_world_free(w);
    return frames;
}

// Of all sizes and steps, light or heavy, or driven.  Rejects: cloth that is parted
// from a body before its threads pull it back, and never after them.
START_TEST(a_body_never_ends_a_frame_through_cloth)
{
    static const double steps[] = { 1.0 / 30, 1.0 / 60, 1.0 / 120 };
    static const double masses[] = { 0, 10, 0.2 };
    int frames = 0;
    for (int k = 0; k < 9; k++) {
        int got = frames_cut(k % 2 ? 0.05 : 3, steps[k / 3], 10, k % 4 * 6,
                             masses[k % 3]);
        frames += got;
    }
    ck_assert_int_eq(frames, 0);
}
END_TEST

START_TEST(a_report_counts_what_there_is)
{
    tumble_world *w = with_floor(NULL);
    add_box(w, 0, 0.5, 0);
    add_box(w, 0, 1.5, 0);
    tumble_body hung = add_box(w, 9, 5, 0);
    tumble_joint j = tumble_joint_ball(w, tumble_body_ground(), hung,
                                       tumble_v(9, 6, 0));
    run(w, 0.2);
    tumble_report r = tumble_world_last_step(w);
    ck_assert_int_eq(r.bodies, 3);
    ck_assert_int_eq(r.asleep, 0);
    ck_assert_int_ge(r.pairs, 1);
    ck_assert_int_eq(r.contacts, 2);
    ck_assert_int_ge(r.substeps, 1);
    ck_assert_int_eq(r.unconverged + r.dropped + r.broken, 0);
    tumble_joint_set_strength(w, j, 1);
    tumble_world_step(w);
    ck_assert_int_eq(tumble_world_last_step(w).broken, 1);
    tumble_world_step(w);
    ck_assert_int_eq(tumble_world_last_step(w).broken, 0);
    // Two in one place have to part first.
    add_box(w, 20, 0.5, 0);
    add_box(w, 20.1, 0.6, 0);
    tumble_world_step(w);
    ck_assert_int_ge(tumble_world_last_step(w).unconverged, 1);
    ck_assert_double_gt(tumble_world_measure(w).penetration, 0.1);
    // And without memory there are contacts that found none.
    for (int k = 0; k < 40; k++) add_box(w, 1.1 * (k % 7), 0.5, 5 + k / 7 * 1.1);
    mallocs_left = 0;
    tumble_world_step(w);
    mallocs_left = INT_MAX;
    ck_assert_int_gt(tumble_world_last_step(w).dropped, 0);
    tumble_world_step(w);
    ck_assert_int_eq(tumble_world_last_step(w).dropped, 0);
    tumble_world_free(w);
}
END_TEST

// A cube of 2 kg and side 1: I = m / 6.  About the origin the angular momentum is
// that of its spin and of its way.
START_TEST(measures_are_those_of_the_textbook)
{
    tumble_world *w = with_floor(NULL);
    tumble_body_options o = tumble_body_at(3, 7, 0);
    o.velocity = tumble_v(0, 0, 5);
    o.spin = tumble_v(0, 6, 0);
    tumble_body_add(w, a_box(w), o);
    tumble_body rope = tumble_body_add(w, tumble_shape_rope(w, 4, 4, 1),
                                       tumble_body_at(0, 90, 0));
    tumble_measures m = tumble_world_measure(w);
    // (Half a substep ago, by the chord of a fall that begins at rest.)
    double fall = 9.81 / 240 / 240 / 4;
    near(m.potential, 2 * 9.81 * (7 - fall) + 9.81 * (90 - fall), 1e-9);
    near(m.kinetic, 25 + 0.5 * 36 / 3, 1e-3);
    near(m.momentum.z, 10, 1e-9);
    near(m.angular.x, 7 * 10, 1e-9);
    near(m.angular.y, 2 - 3 * 10, 1e-9);
    near(m.strain, 0, 1e-12);
    tumble_body_pin(w, rope, 0);
    tumble_body_set_stretch(w, rope, 1e-2);
    run(w, 0.5);
    ck_assert_double_gt(tumble_world_measure(w).strain, 0.01);
    tumble_world_free(w);
}
END_TEST

// --- Bodies ------------------------------------------------------------------

// What is said when a body is added, and what is set afterwards, are the same.
START_TEST(a_body_takes_its_options_at_once_or_later)
{
    unsigned long long hash[3];
    for (int k = 0; k < 3; k++) {
        tumble_world *w = with_floor(NULL);
        tumble_body_options o = tumble_body_at(0, 0.7, 0), full = o;
        full.velocity = tumble_v(2, 1, 0);
        full.spin = tumble_v(0, 1, 0.5);
        full.friction = 0.1;
        full.restitution = 0.6;
        full.damping = 0.3;
        full.spin_damping = 0.7;
        full.group = 2;
        full.mask = 5;
        add_box(w, 0.2, 2.5, 0);
        tumble_body b = tumble_body_add(w, a_box(w), k == 0 ? full : o);
        if (k == 1) {
            tumble_body_set_velocity(w, b, full.velocity, full.spin);
            tumble_body_set_material(w, b, full.friction, full.restitution);
            tumble_body_set_damping(w, b, full.damping, full.spin_damping);
            tumble_body_set_filter(w, b, full.group, full.mask);
        }
        near(tumble_body_spin(w, b).y, k < 2, 1e-9);
        run(w, 1.5);
        hash[k] = tumble_world_hash(w);
        expect_fine(w);
        tumble_world_free(w);
    }
    ck_assert(hash[0] == hash[1]);
    ck_assert(hash[0] != hash[2]);
}
END_TEST

// A box of a metre may be a million kilometres away, where a double knows a tenth
// of a micrometre, and no further; what is refused changes nothing.
START_TEST(what_is_too_far_for_its_numbers_is_refused)
{
    const double far[] = { 2e9, 1e15, 1e17, 1e300, HUGE_VAL };
    tumble_world *w = weightless();
    tumble_body_options o = tumble_body_at(9e8, 0, 0);
    o.spin = tumble_v(0, 1, 0);
    tumble_body b = tumble_body_add(w, a_box(w), o);
    for (int k = 0; k < 5; k++) {
        tumble_pose there = { { 0, far[k], 0 }, { 0, 0, 0, 1 } };
        tumble_body none = tumble_body_add(w, a_box(w),
                                           tumble_body_at(0, far[k], 0));
        ck_assert_uint_eq(none.generation, 0);
        ck_assert_ptr_nonnull(tumble_world_failure(w));
        tumble_world_forget_failure(w);
        ck_assert(!tumble_body_set_pose(w, b, there));
        ck_assert_ptr_nonnull(tumble_world_failure(w));
        tumble_world_forget_failure(w);
    }
    ck_assert_int_eq(tumble_world_bodies(w, NULL, 0), 1);
    run(w, 1);
    near(tumble_body_position(w, b).x, 9e8, 1e-5);
    near(tumble_body_spin(w, b).y, 1, 1e-3);
    ck_assert_double_lt(tumble_world_measure(w).strain, 1e-5);
    tumble_world_free(w);
}
END_TEST

// Half a turn in a second.
START_TEST(a_kinematic_body_turns_as_it_was_told)
{
    const double pi = acos(-1);
    for (int k = 0; k < 2; k++) {
        tumble_world *w = of(NULL);
        tumble_body_options o = tumble_body_at(0, 0, 0);
        o.kind = TUMBLE_KINEMATIC;
        if (k == 0) o.spin = tumble_v(0, pi, 0);
        tumble_body b = tumble_body_add(w, a_box(w), o);
        if (k == 1)
            tumble_body_set_velocity(w, b, tumble_v(0, 0, 0),
                                     tumble_v(0, pi, 0));
        run(w, 1);
        near(fabs(tumble_body_pose(w, b).rotation.y), 1, 1e-6);
        near(tumble_body_spin(w, b).y, pi, 1e-9);
        // What moves it stands outside of the books.
        tumble_body_set_velocity(w, b, tumble_v(3, 0, 0), tumble_v(0, pi, 0));
        run(w, 0.1);
        ck_assert(tumble_body_mass(w, b) == 0);
        near(tumble_world_measure(w).kinetic, 0, 0);
        near(tumble_world_measure(w).momentum.x, 0, 0);
        tumble_world_free(w);
    }
}
END_TEST

// Two tiles, and a box on each that is pushed: both tiles are ice, and then both
// let it through.
START_TEST(all_pieces_take_what_a_body_is_given)
{
    tumble_world *w = of(NULL);
    tumble_shape tile = tumble_shape_box(w, tumble_v(8, 1, 8), 1);
    const tumble_shape piece[2] = { tile, tile };
    const tumble_pose where[2] = { { { 0, -0.5, 0 }, { 0, 0, 0, 1 } },
                                   { { 0, -0.5, 20 }, { 0, 0, 0, 1 } } };
    tumble_body stage = tumble_body_add_pieces(w, piece, where, 2,
                                               tumble_body_at(0, 0, 0));
    tumble_body b[2] = { add_box(w, 0, 0.5, 0), add_box(w, 0, 0.5, 20) };
    ck_assert(tumble_body_set_material(w, stage, 0, 0));
    for (int k = 0; k < 2; k++)
        tumble_body_push(w, b[k], tumble_v(2, 0, 0),
                         tumble_body_position(w, b[k]));
    run(w, 1);
    for (int k = 0; k < 2; k++) near(tumble_body_position(w, b[k]).x, 1, 0.01);
    ck_assert(tumble_body_set_filter(w, stage, 4, 0));
    run(w, 0.5);
    for (int k = 0; k < 2; k++)
        near(tumble_body_position(w, b[k]).y, 0.5 - 9.81 / 8, 0.1);
    tumble_world_free(w);
}
END_TEST

// Two boxes lie on each other, and a third one beside them: the lower one is put on
// the third.
START_TEST(what_is_put_elsewhere_wakes_what_it_left_and_what_it_meets)
{
    tumble_world *w = with_floor(NULL);
    tumble_body low = add_box(w, 0, 0.5, 0), high = add_box(w, 0, 1.5, 0);
    tumble_body far = add_box(w, 9, 0.5, 0);
    run(w, 3);
    ck_assert_int_eq(tumble_world_last_step(w).asleep, 3);
    tumble_pose there = { { 9, 1.45, 0 }, { 0, 0, 0, 1 } };
    ck_assert(tumble_body_set_pose(w, low, there));
    ck_assert(tumble_body_is_awake(w, high));
    ck_assert(tumble_body_is_awake(w, far));
    run(w, 2);
    near(tumble_body_position(w, high).y, 0.5, 2e-3);
    near(tumble_body_position(w, low).y, 1.5, 4e-3);
    tumble_world_free(w);
}
END_TEST

// A box sleeps on a slope of 17 degrees, a box, a mesh or a table of heights.  When
// that becomes as smooth as ice, the box slides by g sin a t^2 / 2, of any size.
// Rejects: a floor that wakes nothing, for it never sleeps.
START_TEST(what_sleeps_on_a_slope_slides_when_that_becomes_smooth)
{
    const double high[4] = { 0 };
    const int flat[6] = { 0, 2, 1, 0, 3, 2 };
    for (int k = 0; k < 12; k++) {
        const double l = (double[]){ 0.05, 1, 10 }[k / 4], a = 4 * l;
        const tumble_vec3 at[4] = { { -a, 0, -a }, { a, 0, -a }, { a, 0, a },
                                    { -a, 0, a } };
        tumble_options o = tumble_options_default();
        o.gravity = tumble_v(3, -9.81, 0);
        tumble_world *w = of(&o);
        tumble_body_options p = tumble_body_at(0, k % 4 < 2 ? -l : 0, 0);
        p.kind = (tumble_kind[]){ TUMBLE_STATIC, TUMBLE_KINEMATIC }[k % 4 == 1];
        tumble_shape block = tumble_shape_box(w, tumble_v(2 * a, 2 * l, 2 * a), 1);
        tumble_body slope = k % 4 < 2 ? tumble_body_add(w, block, p)
            : k % 4 == 2 ? tumble_body_add_mesh(w, at, 4, flat, 2, 0, p)
            : tumble_body_add_heights(w, high, 2, 2, 2 * a, 2 * a, 0, p);
        tumble_shape s = tumble_shape_box(w, tumble_v(l, l, l), 1);
        tumble_body b = tumble_body_add(w, s, tumble_body_at(0, l / 2, 0));
        run(w, 3 * fmax(1, sqrt(l)));
        ck_assert(!tumble_body_is_awake(w, b));
        double from = tumble_body_position(w, b).x, t = 24 / 60.0;
        ck_assert(tumble_body_set_material(w, slope, 0, 0));
        ck_assert(tumble_body_is_awake(w, b));
        if (l < 0.1) t = 6 / 60.0;
        run(w, t);
        // Half a substep more or less, for it falls in steps.
        near(tumble_body_position(w, b).x - from, 3 * t * t / 2, 3 * t / 480);
        tumble_world_free(w);
    }
}
END_TEST

// A rope of 0.1 kg and 1 m hangs asleep.  It gives by 0.5 / N: its own weight makes it
// longer by the mean of what its links bear, 0.5 * 0.981 / 2 m.  One that is held at
// both vertices of its first link stands out when it becomes stiff.
// Rejects: a rope that sleeps on as it was.
START_TEST(a_rope_that_sleeps_wakes_when_it_becomes_soft_or_stiff)
{
    for (int k = 0; k < 2; k++) {
        tumble_world *w = of(NULL);
        tumble_body b = tumble_body_add(w, tumble_shape_rope(w, 10, 1, 0.1),
                                        tumble_body_at(0, 0, 0));
        tumble_body_set_damping(w, b, 2, 0);
        for (int i = 0; i <= k; i++) tumble_body_pin(w, b, i);
        run(w, 25);
        ck_assert(!tumble_body_is_awake(w, b));
        double was = tumble_body_vertex(w, b, 10).y;
        if (k == 0) tumble_body_set_stretch(w, b, 0.5);
        else        tumble_body_set_bending(w, b, 1);
        ck_assert(tumble_body_is_awake(w, b));
        run(w, 20);
        double by = tumble_body_vertex(w, b, 10).y - was;
        if (k == 0) near(by, -0.5 * 0.981 / 2, 0.002);
        else        ck_assert(by > 0.5);
        tumble_world_free(w);
    }
}
END_TEST

// A sheet lies on a static box that is put aside, and then back over the floor, under
// it.  Rejects: a ghost of the box that the sheet still lies on.
START_TEST(cloth_meets_a_body_where_it_was_put)
{
    tumble_world *w = with_floor(NULL);
    tumble_body_options o = tumble_body_at(0, 1, 0);
    o.kind = TUMBLE_STATIC;
    tumble_body b = tumble_body_add(w, a_box(w), o);
    tumble_body sheet =
        tumble_body_add(w, tumble_shape_cloth(w, 9, 9, 0.8, 0.8, 0.1),
                        tumble_body_at(0, 1.6, 0));
    run(w, 1);
    near(tumble_body_vertex(w, sheet, 40).y, 1.5, 0.1);
    ck_assert(tumble_body_set_pose(w, b, (tumble_pose){ { 9, 1, 0 },
                                                        { 0, 0, 0, 1 } }));
    run(w, 0.4);
    double fallen = tumble_body_vertex(w, sheet, 40).y;
    near(fallen, 1.5 - 9.81 * 0.16 / 2, 0.15);
    ck_assert(tumble_body_set_pose(w, b, (tumble_pose){ { 0, fallen - 0.7, 0 },
                                                        { 0, 0, 0, 1 } }));
    run(w, 2);
    near(tumble_body_vertex(w, sheet, 40).y, fallen - 0.2, 0.1);
    tumble_world_free(w);
}
END_TEST

// A box, a ball and a capsule fall on a sheet that lies on the floor.  They leave what
// they have sunk into without a speed: nothing is thrown back up, and a fifth of the
// energy is won at most.  The flat box comes to lie on two halves of what the sheet
// is thick, 1.1 of its spacing.  Rejects: vertices that the floor pushes up in every
// substep, as if they came by themselves: the more substeps, the higher they throw.
START_TEST(what_falls_on_a_sheet_on_the_floor_lies_there)
{
    for (int k = 0; k < 6; k++) {
        tumble_options o = tumble_options_default();
        o.substeps = k < 3 ? 8 : 17;
        tumble_world *w = with_floor(&o);
        tumble_body_add(w, tumble_shape_cloth(w, 20, 20, 1.5, 1.5, 0.4),
                        tumble_body_at(0, 0.05, 0));
        tumble_shape s =
            k % 3 == 0 ? tumble_shape_box(w, tumble_v(0.3, 0.3, 0.3), 1)
          : k % 3 == 1 ? tumble_shape_sphere(w, 0.15, 1)
                       : tumble_shape_capsule(w, 0.4, 0.15, 1);
        tumble_body b = tumble_body_add(w, s, tumble_body_at(0.01, 0.9, 0.02));
        double least = HUGE_VAL, unit = 9.81 * 0.9, fastest = 0;
        for (int f = 0; f < 120; f++) {
            tumble_world_step(w);
            tumble_measures m = tumble_world_measure(w);
            least = fmin(least, m.kinetic + m.potential);
            ck_assert_msg(m.kinetic + m.potential < least + 0.2 * unit,
                          "%d: %g J are won", k, m.kinetic + m.potential - least);
            fastest = fmax(fastest, tumble_body_velocity(w, b).y);
        }
        ck_assert_msg(fastest < 1, "%d: up by %g m/s", k, fastest);
        if (k % 3 == 0)
            near(tumble_body_position(w, b).y, 0.15 + 1.1 * 1.5 / 19, 1e-3);
        tumble_world_free(w);
    }
}
END_TEST

// A vertex of 0.1 kg: the impulse of 0.2 N s gives it 2 m/s, and the rope of 0.5 kg
// 0.4 m/s.
START_TEST(an_impulse_on_a_vertex_is_divided_by_its_mass)
{
    tumble_world *w = weightless();
    tumble_body rope = tumble_body_add(w, tumble_shape_rope(w, 4, 4, 0.5),
                                       tumble_body_at(0, 0, 0));
    ck_assert(tumble_body_push_vertex(w, rope, 2, tumble_v(0, 0.2, 0)));
    near(tumble_world_measure(w).momentum.y, 0.2, 1e-9);
    near(tumble_body_velocity(w, rope).y, 0.4, 0.1);
    run(w, 1);
    near(tumble_world_measure(w).momentum.y, 0.2, 1e-9);
    tumble_world_free(w);
}
END_TEST

// 1 kg on a rope of a metre that gives by 0.01 / N.
START_TEST(a_rope_gives_as_it_was_told)
{
    for (int k = 0; k < 2; k++) {
        tumble_world *w = of(NULL);
        tumble_body rope = tumble_body_add(w, tumble_shape_rope(w, 5, 1, 0.001),
                                           tumble_body_at(0, 0, 0));
        tumble_body_options o = tumble_body_at(1.5, 0, 0);
        o.damping = 3;
        tumble_body b =
            tumble_body_add(w, tumble_shape_box(w, tumble_v(1, 1, 1), 1), o);
        tumble_body_pin(w, rope, 0);
        tumble_joint_hang(w, rope, 5, b);
        ck_assert(tumble_body_set_damping(w, rope, 3, 0));
        if (k == 1) ck_assert(tumble_body_set_stretch(w, rope, 0.01));
        run(w, 20);
        double top = tumble_body_vertex(w, rope, 0).y;
        near(top - tumble_body_vertex(w, rope, 5).y, k ? 1 + 0.01 * 9.81 : 1,
             0.01);
        tumble_world_free(w);
    }
}
END_TEST

// A strip of a metre is held at one end.  A limp one hangs down, a stiff one
// hardly: at its end a beam sags by q L^4 / (8 EI).
START_TEST(a_strip_is_as_stiff_as_it_was_told)
{
    for (int k = 0; k < 2; k++) {
        const double q = 0.1 * 9.81, stiff = 2;
        tumble_world *w = of(NULL);
        tumble_body rope = tumble_body_add(w, tumble_shape_rope(w, 20, 1, 0.1),
                                           tumble_body_at(0, 0, 0));
        tumble_body_pin(w, rope, 0);
        tumble_body_pin(w, rope, 1);
        tumble_body_set_damping(w, rope, 2, 0);
        if (k == 1) ck_assert(tumble_body_set_bending(w, rope, stiff));
        run(w, 15);
        double sag = tumble_body_vertex(w, rope, 0).y
            - tumble_body_vertex(w, rope, 20).y;
        if (k == 0) ck_assert_double_gt(sag, 0.8);
        else near(sag, q * pow(0.95, 4) / (8 * stiff), 0.2 * sag);
        tumble_world_free(w);
    }
}
END_TEST

// --- Joints ------------------------------------------------------------------

START_TEST(a_joint_of_strength_zero_never_breaks)
{
    tumble_world *w = of(NULL);
    tumble_body b = add_box(w, 0, 0, 0);
    tumble_joint j = tumble_joint_ball(w, tumble_body_ground(), b,
                                       tumble_v(0, 0.5, 0));
    tumble_joint_set_strength(w, j, 1);
    ck_assert(tumble_joint_set_strength(w, j, 0));
    run(w, 0.2);
    tumble_body_push(w, b, tumble_v(0, -100, 0), tumble_body_position(w, b));
    run(w, 0.2);
    ck_assert(tumble_joint_exists(w, j));
    tumble_world_free(w);
}
END_TEST

// A box of 2 kg hangs in the middle of a rope by a joint that bears 10 N more than
// its weight.
START_TEST(a_vertex_is_held_and_let_go_when_it_bears_too_much)
{
    tumble_world *w = of(NULL);
    tumble_body rope = tumble_body_add(w, tumble_shape_rope(w, 10, 2, 0.1),
                                       tumble_body_at(0, 0, 0));
    tumble_body box = add_box(w, 0, -0.7, 0);
    tumble_vec3 was = tumble_body_vertex(w, rope, 0);
    tumble_joint held = tumble_joint_hang(w, rope, 0, tumble_body_ground());
    tumble_joint hung = tumble_joint_hang(w, rope, 5, box);
    tumble_body_set_damping(w, rope, 2, 0);
    tumble_body_set_damping(w, box, 2, 2);
    run(w, 10);
    expect_fine(w);
    tumble_vec3 is = tumble_body_vertex(w, rope, 0),
                mid = tumble_body_vertex(w, rope, 5);
    near(hypot(is.x - was.x, hypot(is.y - was.y, is.z - was.z)), 0, 1e-9);
    near(is.y - mid.y, 1, 0.02);
    near(tumble_joint_force(w, hung), 2 * 9.81, 1);
    tumble_vec3 at = tumble_body_position(w, box);
    near(hypot(at.x - mid.x, hypot(at.y - mid.y, at.z - mid.z)), 0.7, 0.01);
    ck_assert(tumble_joint_set_strength(w, hung, 2 * 9.81 + 10));
    run(w, 1);
    ck_assert(tumble_joint_exists(w, hung));
    tumble_body_push(w, box, tumble_v(0, -20, 0), at);
    run(w, 0.5);
    ck_assert(!tumble_joint_exists(w, hung));
    ck_assert(tumble_joint_exists(w, held));
    ck_assert_double_lt(tumble_body_position(w, box).y, at.y - 1);
    tumble_world_free(w);
}
END_TEST

// A door that sleeps is opened by its limits, and a box by its distance.
START_TEST(new_limits_wake_what_they_move)
{
    tumble_world *w = with_floor(NULL);
    tumble_body door = add_box(w, 0, 0.5, 0);
    tumble_joint h = tumble_joint_hinge(w, tumble_body_ground(), door,
                                        tumble_v(-0.5, 0.5, 0),
                                        tumble_v(0, 1, 0));
    tumble_body box = add_box(w, 5, 0.5, 0);
    tumble_joint d = tumble_joint_distance(w, tumble_body_ground(),
                                           tumble_v(8, 0.5, 0), box,
                                           tumble_v(5, 0.5, 0), 0, 3);
    run(w, 3);
    ck_assert(!tumble_body_is_awake(w, door) && !tumble_body_is_awake(w, box));
    ck_assert(tumble_joint_set_limits(w, h, 0.3, 0.5));
    ck_assert(tumble_joint_set_limits(w, d, 0, 2.5));
    ck_assert(tumble_body_is_awake(w, door) && tumble_body_is_awake(w, box));
    run(w, 2);
    near(tumble_joint_angle(w, h), 0.3, 0.02);
    near(tumble_body_position(w, box).x, 5.5, 0.02);
    tumble_world_free(w);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        friction_is_the_worlds_or_a_planes_or_a_bodys,
        restitution_is_the_worlds_or_a_bodys,
        sleep_is_as_options_say,
        substeps_are_as_many_as_options_let_them_be,
        a_hard_step_takes_no_more_substeps_than_it_may,
        work_is_run_by_the_program_if_it_wants,
        a_report_says_that_a_body_is_through_cloth,
        a_body_never_ends_a_frame_through_cloth,
        a_report_counts_what_there_is,
        measures_are_those_of_the_textbook,
        a_body_takes_its_options_at_once_or_later,
        what_is_too_far_for_its_numbers_is_refused,
        a_kinematic_body_turns_as_it_was_told,
        all_pieces_take_what_a_body_is_given,
        what_is_put_elsewhere_wakes_what_it_left_and_what_it_meets,
        what_sleeps_on_a_slope_slides_when_that_becomes_smooth,
        a_rope_that_sleeps_wakes_when_it_becomes_soft_or_stiff,
        cloth_meets_a_body_where_it_was_put,
        what_falls_on_a_sheet_on_the_floor_lies_there,
        an_impulse_on_a_vertex_is_divided_by_its_mass,
        a_rope_gives_as_it_was_told,
        a_strip_is_as_stiff_as_it_was_told,
        a_joint_of_strength_zero_never_breaks,
        a_vertex_is_held_and_let_go_when_it_bears_too_much,
        new_limits_wake_what_they_move,
        NULL
    };
    return suite_run((suite){ .name = "given", .tests = tests,
                              .seconds = 60 });
}
