// check_cylinders.c - tests of tumble_shape_cylinder: what is round on its side and
// on its rims, and flat at its ends.  Book: chapter 10.

#include "suite.h"
#include "tumble.h"

#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double G = 9.81;

static void near(double got, double wanted, double tolerance)
{
    ck_assert_msg(fabs(got - wanted) <= tolerance, "got %.17g, wanted %.17g",
                  got, wanted);
}

static double length_of(tumble_vec3 v)
{
    return sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

static tumble_world *made(double friction)
{
    tumble_options o = tumble_options_default();
    o.friction = friction;
    return tumble_world_make(&o);
}

static void is_well(tumble_world *w)
{
    ck_assert_msg(!tumble_world_failure(w), "%s", tumble_world_failure(w));
    tumble_world_free(w);
}

static void run(tumble_world *w, int steps)
{
    for (int k = 0; k < steps; k++) tumble_world_step(w);
}

// A floor at y = 0: a plane, a box, or a terrain.
enum { FLOORS = 3 };

static void add_floor(tumble_world *w, int kind)
{
    tumble_body_options o = tumble_body_at(0, -0.5, 0);
    o.kind = TUMBLE_STATIC;
    if (kind == 0) tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    if (kind == 1)
        tumble_body_add(w, tumble_shape_box(w, tumble_v(100, 1, 100), 1), o);
    if (kind == 2) {
        double *height = calloc(81 * 81, sizeof *height);
        ck_assert_ptr_nonnull(height);
        tumble_body_add_heights(w, height, 81, 81, 80, 80, 0,
                                tumble_body_at(0, 0, 0));
        free(height);
    }
}

// On its side, with its axis along z.
static tumble_body_options lying(double x, double y)
{
    tumble_body_options o = tumble_body_at(x, y, 0);
    o.pose.rotation = tumble_quat_turn(tumble_v(1, 0, 0), acos(-1) / 2);
    return o;
}

static double kinetic_of(tumble_world *w, tumble_body b, tumble_vec3 spin)
{
    tumble_body_set_velocity(w, b, tumble_v(0, 0, 0), spin);
    return tumble_world_measure(w).kinetic;
}

// Rejects: the inertia of the prism.
START_TEST(moments_of_inertia_are_those_of_the_formulas)
{
    const double m = 3, r = 0.4, l = 1.5;
    tumble_world *w = made(0.5);
    tumble_world_set_gravity(w, tumble_v(0, 0, 0));
    tumble_body b = tumble_body_add(w, tumble_shape_cylinder(w, l, r, m),
                                    tumble_body_at(0, 0, 0));
    double across = m * (3 * r * r + l * l) / 12;
    near(tumble_body_mass(w, b), m, 1e-12);
    near(kinetic_of(w, b, tumble_v(0, 1, 0)), m * r * r / 4, 1e-12);
    near(kinetic_of(w, b, tumble_v(1, 0, 0)), across / 2, 1e-12);
    near(kinetic_of(w, b, tumble_v(0, 0, 1)), across / 2, 1e-12);
    is_well(w);
}
END_TEST

// a = g sin t / (1 + I / (m r^2)), and I = m r^2 / 2.  (Velocities are those of half
// a substep ago.)  Rejects: a prism, which is slower by a tenth.
START_TEST(it_rolls_down_a_slope_as_the_formula_says)
{
    const double t = 0.2, r = 0.3, aspect[] = { 0.05, 0.3, 1, 4, 20 };
    for (int floor = 0; floor < FLOORS - 1; floor++)
        for (int k = 0; k < 5; k++) {
            tumble_world *w = made(0.8);
            tumble_world_set_gravity(w, tumble_v(G * sin(t), -G * cos(t), 0));
            add_floor(w, floor);
            tumble_shape s = tumble_shape_cylinder(w, aspect[k] * r, r, 2);
            tumble_body b = tumble_body_add(w, s, lying(0, r));
            run(w, 120);
            double h = 1 / 60.0 / tumble_world_last_step(w).substeps;
            double wanted = G * sin(t) / 1.5 * (2 - h / 2);
            near(length_of(tumble_body_velocity(w, b)), wanted, 1e-4 * wanted);
            is_well(w);
        }
}
END_TEST

// Rejects: a side of flat faces; a rim that is met too late.
START_TEST(it_rolls_for_ten_seconds_without_loss)
{
    const double r = 0.5, v = 3, aspect[] = { 0.05, 0.5, 2, 6 };
    for (int floor = 0; floor < FLOORS; floor++)
        for (int k = 0; k < 4; k++) {
            tumble_world *w = made(0.5);
            add_floor(w, floor);
            tumble_body_options o = lying(-15, r);
            o.velocity = tumble_v(v, 0, 0);
            o.spin = tumble_v(0, 0, -v / r);
            tumble_shape s = tumble_shape_cylinder(w, aspect[k] * r, r, 2);
            tumble_body b = tumble_body_add(w, s, o);
            run(w, 600);
            near(tumble_body_velocity(w, b).x, v, 1e-5 * v);
            near(tumble_body_velocity(w, b).y, 0, 1e-3);
            near(tumble_body_position(w, b).y, r, 1e-3 * r);
            is_well(w);
        }
}
END_TEST

START_TEST(it_stands_on_its_end_and_sleeps)
{
    const double l = 1, radius[] = { 0.1, 0.5, 2 };
    for (int floor = 0; floor < FLOORS; floor++)
        for (int k = 0; k < 3; k++) {
            tumble_world *w = made(0.5);
            add_floor(w, floor);
            tumble_shape s = tumble_shape_cylinder(w, l, radius[k], 2);
            tumble_body b = tumble_body_add(w, s, tumble_body_at(0.1, l / 2, 0));
            run(w, 120);
            tumble_quat q = tumble_body_pose(w, b).rotation;
            near(tumble_quat_rotate(q, tumble_v(0, 1, 0)).y, 1, 1e-6);
            near(tumble_body_position(w, b).y, l / 2, 1e-3);
            ck_assert(!tumble_body_is_awake(w, b));
            is_well(w);
        }
}
END_TEST

// Over the lowest point of its rim at tan t = 2 r / l, whichever way it leans.
static bool falls(int floor, double l, double r, double angle, double way)
{
    tumble_world *w = made(1);
    add_floor(w, floor);
    double y = l / 2 * cos(angle) + r * sin(angle);
    tumble_body_options o = tumble_body_at(0, y, 0);
    o.pose.rotation = tumble_quat_turn(tumble_v(cos(way), 0, sin(way)), angle);
    tumble_body b = tumble_body_add(w, tumble_shape_cylinder(w, l, r, 2), o);
    run(w, 400);
    tumble_quat q = tumble_body_pose(w, b).rotation;
    is_well(w);
    return tumble_quat_rotate(q, tumble_v(0, 1, 0)).y < 0.7;
}

START_TEST(it_falls_over_beyond_the_angle_of_its_rim)
{
    for (int floor = 0; floor < FLOORS; floor++)
        for (int k = 1; k < 4; k++)
            for (int way = 0; way < 3; way++) {
                double r = 0.2 * k, most = atan(2 * r);
                ck_assert(!falls(floor, 1, r, 0.985 * most, 0.07 * way));
                ck_assert(falls(floor, 1, r, 1.015 * most, 0.07 * way));
            }
}
END_TEST

// A coin that leans rolls on its rim and keeps its energy.
START_TEST(coin_that_leans_rolls_on)
{
    const double r = 0.5, l = 0.05, lean = 0.4, v = 4;
    for (int floor = 0; floor < 2; floor++) {
        tumble_world *w = made(1);
        add_floor(w, floor);
        tumble_body_options o = tumble_body_at(0, r * cos(lean)
                                                  + l / 2 * sin(lean), 0);
        o.pose.rotation = tumble_quat_turn(tumble_v(1, 0, 0),
                                           acos(-1) / 2 + lean);
        tumble_vec3 axis = tumble_quat_rotate(o.pose.rotation,
                                              tumble_v(0, 1, 0));
        double spin = axis.z > 0 ? -v / r : v / r;
        o.velocity = tumble_v(v, 0, 0);
        o.spin = tumble_v(spin * axis.x, spin * axis.y, spin * axis.z);
        tumble_body_add(w, tumble_shape_cylinder(w, l, r, 2), o);
        run(w, 1);
        tumble_measures m = tumble_world_measure(w);
        double energy = m.kinetic + m.potential;
        run(w, 300);
        m = tumble_world_measure(w);
        near(m.kinetic + m.potential, energy, 2e-3 * energy);
        is_well(w);
    }
}
END_TEST

// Rejects: a normal that jumps from face to face of the prism, which throws it up.
START_TEST(it_rolls_over_an_edge_as_a_capsule_does)
{
    double end[2][2];
    for (int k = 0; k < 2; k++) {
        tumble_world *w = made(0.8);
        add_floor(w, 0);
        tumble_body_options o = tumble_body_at(1.5, 0.01, 0);
        o.kind = TUMBLE_STATIC;
        tumble_body_add(w, tumble_shape_box(w, tumble_v(1, 0.08, 4), 1), o);
        tumble_shape s = k ? tumble_shape_capsule(w, 2, 0.3, 2)
                           : tumble_shape_cylinder(w, 2, 0.3, 2);
        o = lying(0, 0.3);
        o.velocity = tumble_v(2.5, 0, 0);
        o.spin = tumble_v(0, 0, -2.5 / 0.3);
        tumble_body b = tumble_body_add(w, s, o);
        run(w, 40);
        end[k][0] = tumble_body_position(w, b).y;
        run(w, 80);
        end[k][1] = tumble_body_velocity(w, b).x;
        near(tumble_body_velocity(w, b).z, 0, 0.02);
        is_well(w);
    }
    near(end[0][0], end[1][0], 0.02);
    near(end[0][1], end[1][1], 0.25);
}
END_TEST

// Three logs, the third in the groove of the two, which lean on walls; and one across
// another.
START_TEST(logs_lie_on_each_other)
{
    const double r = 0.25;
    tumble_world *w = made(0.5);
    add_floor(w, 0);
    tumble_plane_add(w, tumble_v(1, 0, 0), -2 * r, -1);
    tumble_plane_add(w, tumble_v(-1, 0, 0), -2 * r, -1);
    tumble_shape s = tumble_shape_cylinder(w, 2, r, 2);
    tumble_body_add(w, s, lying(-r, r));
    tumble_body_add(w, s, lying(r, r));
    tumble_body top = tumble_body_add(w, s, lying(0, r + sqrt(3) * r));
    run(w, 240);
    near(tumble_body_position(w, top).y, r + sqrt(3) * r, 2e-3);
    near(tumble_body_position(w, top).x, 0, 2e-3);
    tumble_body_options o = tumble_body_at(0, 2.95 * r + sqrt(3) * r, 0);
    o.pose.rotation = tumble_quat_turn(tumble_v(0, 0, 1), acos(-1) / 2);
    tumble_body across =
        tumble_body_add(w, tumble_shape_cylinder(w, 0.8, r, 1), o);
    run(w, 240);
    near(tumble_body_position(w, across).y, 3 * r + sqrt(3) * r, 4e-3);
    is_well(w);
}
END_TEST

// Rejects: a ray that meets the prism: between two corners it is too late by half a
// per cent of the radius.
START_TEST(ray_meets_side_and_ends_where_the_formulas_say)
{
    const double r = 0.5, l = 1.2;
    tumble_world *w = made(0.5);
    tumble_body b = tumble_body_add(w, tumble_shape_cylinder(w, l, r, 2),
                                    tumble_body_at(1, 2, 3));
    tumble_hit hit;
    for (int k = 0; k < 100; k++) {
        double z = -0.495 + k * 0.01, y = -0.55 + 0.011 * k;
        double x = sqrt(r * r - z * z);
        ck_assert(tumble_world_ray(w, tumble_v(6, 2 + y, 3 + z),
                                   tumble_v(-4, 2 + y, 3 + z), ~0u, &hit));
        near(hit.point.x, 1 + x, 1e-12);
        near(hit.fraction, (5 - x) / 10, 1e-12);
        near(hit.normal.x, x / r, 1e-9);
        near(hit.normal.z, z / r, 1e-9);
        ck_assert(hit.body.place == b.place);
        ck_assert(tumble_world_ray(w, tumble_v(1 + z, 5, 3),
                                   tumble_v(1 + z, -1, 3), ~0u, &hit));
        near(hit.point.y, 2 + l / 2, 1e-12);
        near(hit.normal.y, 1, 1e-12);
    }
    ck_assert(!tumble_world_ray(w, tumble_v(1.51, 5, 3), tumble_v(1.51, -1, 3),
                                ~0u, &hit));
    ck_assert(!tumble_world_ray(w, tumble_v(6, 2.61, 3), tumble_v(-4, 2.61, 3),
                                ~0u, &hit));
    ck_assert(!tumble_world_ray(w, tumble_v(6, 2, 3.51), tumble_v(-4, 2, 3.51),
                                ~0u, &hit));
    ck_assert(tumble_world_ray(w, tumble_v(1, 2, 3), tumble_v(9, 2, 3), ~0u,
                               &hit));
    near(hit.fraction, 0, 0);
    ck_assert(tumble_world_nearest(w, tumble_v(2.3, 2 + l / 2 + 0.6, 3), 2, ~0u,
                                   &hit));
    near(hit.fraction, 1, 1e-12);
    near(hit.point.x, 1.5, 1e-12);
    near(hit.normal.y, 0.6, 1e-12);
    is_well(w);
}
END_TEST

// Its bits do not depend on whether it was saved, and put back.
START_TEST(it_is_saved_and_goes_on_alike)
{
    tumble_world *w = made(0.5);
    add_floor(w, 1);
    tumble_shape s[2] = { tumble_shape_cylinder(w, 0.6, 0.2, 1),
                          tumble_shape_cylinder(w, 0.1, 0.3, 1) };
    for (int k = 0; k < 12; k++) {
        tumble_body_options o = tumble_body_at(0.1 * k, 0.5 + 0.5 * k, 0);
        o.pose.rotation = tumble_quat_turn(tumble_v(1, k, 2), 0.7 * k);
        tumble_body_add(w, s[k % 2], o);
    }
    run(w, 60);
    size_t size = tumble_world_save(w, NULL, 0);
    void *bytes = malloc(size);
    ck_assert_ptr_nonnull(bytes);
    tumble_world_save(w, bytes, size);
    tumble_world *copy = tumble_world_load(bytes, size);
    run(w, 200);
    run(copy, 200);
    ck_assert(tumble_world_hash(w) == tumble_world_hash(copy));
    ck_assert(tumble_world_restore(copy, bytes, size));
    run(copy, 200);
    ck_assert(tumble_world_hash(w) == tumble_world_hash(copy));
    free(bytes);
    is_well(copy);
    is_well(w);
}
END_TEST

static void add_triangle(void *context, tumble_body b, const tumble_vec3 at[3])
{
    double *area = context;
    tumble_vec3 d = tumble_v(at[1].x - at[0].x, at[1].y - at[0].y,
                             at[1].z - at[0].z);
    tumble_vec3 e = tumble_v(at[2].x - at[0].x, at[2].y - at[0].y,
                             at[2].z - at[0].z);
    tumble_vec3 n = tumble_v(d.y * e.z - d.z * e.y, d.z * e.x - d.x * e.z,
                             d.x * e.y - d.y * e.x);
    (void)b;
    area[0] += length_of(n) / 2;
    area[1] += (at[0].x * n.x + at[0].y * n.y + at[0].z * n.z) / 6;
}

START_TEST(it_is_drawn_as_a_closed_prism)
{
    const double r = 0.5, l = 2, pi = acos(-1);
    double got[2] = { 0, 0 };
    tumble_world *w = made(0.5);
    tumble_body_add(w, tumble_shape_cylinder(w, l, r, 2),
                    tumble_body_at(0, 0, 0));
    tumble_pen pen = { .triangle = add_triangle, .context = got };
    tumble_world_draw(w, &pen);
    double wanted = 2 * pi * r * (l + r);
    near(got[0], wanted, 0.01 * wanted);
    near(got[1], pi * r * r * l, 0.01 * pi * r * r * l);
    is_well(w);
}
END_TEST

START_TEST(what_is_no_cylinder_is_refused)
{
    const double bad[][3] = { { 0, 1, 1 }, { 1, -1, 1 }, { 1, 1, 0 },
                              { NAN, 1, 1 }, { 1, INFINITY, 1 }, { 1, 1, NAN },
                              { 1, 1e5, 1 }, { 1e5, 1, 1 } };
    for (int k = 0; k < 8; k++) {
        tumble_world *w = made(0.5);
        tumble_shape s = tumble_shape_cylinder(w, bad[k][0], bad[k][1],
                                               bad[k][2]);
        ck_assert_uint_eq(s.generation, 0);
        ck_assert_ptr_nonnull(tumble_world_failure(w));
        tumble_world_free(w);
    }
}
END_TEST

// --- Cones ----------------------------------------------------------------------
// Rejects: the inertia of the pyramid.
START_TEST(a_cone_has_the_mass_and_the_moments_of_a_round_one)
{
    const double m = 3, r = 0.4, h = 1.5;
    tumble_world *w = made(0.5);
    tumble_world_set_gravity(w, tumble_v(0, 0, 0));
    tumble_body b = tumble_body_add(w, tumble_shape_cone(w, h, r, m),
                                    tumble_body_at(0, 9, 0));
    double across = 3 * m * (4 * r * r + h * h) / 80;
    near(tumble_body_mass(w, b), m, 1e-12);
    near(kinetic_of(w, b, tumble_v(0, 1, 0)), 0.3 * m * r * r / 2, 1e-12);
    near(kinetic_of(w, b, tumble_v(1, 0, 0)), across / 2, 1e-12);
    near(kinetic_of(w, b, tumble_v(0, 0, 1)), across / 2, 1e-12);
    is_well(w);
}
END_TEST

// Its side is as far out as the height above the base says, less what a side of the
// pyramid lies inside: 1 - cos(pi / 32).
START_TEST(rays_meet_a_cone_where_it_is)
{
    const double r = 0.4, h = 1.6;
    tumble_world *w = made(0.5);
    tumble_hit hit;
    tumble_body_add(w, tumble_shape_cone(w, h, r, 1), tumble_body_at(0, 9, 0));
    for (int k = 0; k < 40; k++) {
        double turn = 0.37 * k, up = 0.04 * k, out = r * (1 - up / h);
        double y = 9 - h / 4 + up;
        ck_assert(tumble_world_ray(w, tumble_v(2 * cos(turn), y, 2 * sin(turn)),
                                   tumble_v(0, y, 0), ~0u, &hit));
        double at = hypot(hit.point.x, hit.point.z);
        ck_assert(at <= out + 1e-9 && at >= out * cos(acos(-1) / 32) - 1e-9);
    }
    ck_assert(tumble_world_ray(w, tumble_v(0, 20, 0), tumble_v(0, 0, 0), ~0u, &hit));
    near(hit.point.y, 9 + 0.75 * h, 1e-9);
    is_well(w);
}
END_TEST

// It stands if its centre, h / 4 above the base, is over that: tan t < 4 r / h.
START_TEST(a_cone_that_leans_falls_back_or_over)
{
    for (int k = 0; k < 4; k++)
        for (int i = -1; i < 2; i += 2) {
            double r = 0.3, h = 0.4 + 0.3 * k, t = atan(4 * r / h) + 0.05 * i;
            tumble_world *w = made(0.8);
            tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
            double out = hypot(r, h / 4);
            tumble_body_options o = tumble_body_at(0, out, 0);
            // It stands on the corner at x = r.
            o.pose.rotation = tumble_quat_turn(tumble_v(0, 0, 1), -t);
            tumble_body b = tumble_body_add(w, tumble_shape_cone(w, h, r, 2), o);
            for (int n = 0; n < 600; n++) tumble_world_step(w);
            double y = tumble_body_position(w, b).y;
            if (i < 0) near(y, h / 4, 1e-3);
            else       ck_assert(fabs(y - h / 4) > 0.01);
            is_well(w);
        }
}
END_TEST

START_TEST(what_is_no_cone_is_refused)
{
    const double bad[][3] = { { 0, 1, 1 }, { 1, -1, 1 }, { 1, 1, 0 },
                              { NAN, 1, 1 }, { 1, INFINITY, 1 }, { 1, 1, NAN } };
    for (int k = 0; k < 6; k++) {
        tumble_world *w = made(0.5);
        tumble_shape s = tumble_shape_cone(w, bad[k][0], bad[k][1], bad[k][2]);
        ck_assert_uint_eq(s.generation, 0);
        ck_assert_ptr_nonnull(tumble_world_failure(w));
        tumble_world_free(w);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        moments_of_inertia_are_those_of_the_formulas,
        it_rolls_down_a_slope_as_the_formula_says,
        it_rolls_for_ten_seconds_without_loss,
        it_stands_on_its_end_and_sleeps,
        it_falls_over_beyond_the_angle_of_its_rim,
        coin_that_leans_rolls_on,
        it_rolls_over_an_edge_as_a_capsule_does,
        logs_lie_on_each_other,
        ray_meets_side_and_ends_where_the_formulas_say,
        it_is_saved_and_goes_on_alike,
        it_is_drawn_as_a_closed_prism,
        what_is_no_cylinder_is_refused,
        a_cone_has_the_mass_and_the_moments_of_a_round_one,
        rays_meet_a_cone_where_it_is,
        a_cone_that_leans_falls_back_or_over,
        what_is_no_cone_is_refused,
        NULL
    };
    return suite_run((suite){ .name = "cylinders", .tests = tests,
                              .seconds = 60 });
}
