// check_turning.c - what turns is asked again within a frame, through tumble.h.
// Book: chapter 18.

#include "tumble.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>

static const double PI = 3.14159265358979323846;
enum { RIM = 24 };

// Its faces look along y.
static tumble_shape coin(tumble_world *w, double radius, double height)
{
    tumble_vec3 p[2 * RIM];
    for (int k = 0; k < 2 * RIM; k++) {
        double a = 2 * PI * (k % RIM) / RIM;
        p[k] = tumble_v(radius * cos(a), k < RIM ? -height / 2 : height / 2,
                        radius * sin(a));
    }
    return tumble_shape_hull(w, p, 2 * RIM, 1);
}

static double lowest(const tumble_world *w, tumble_body b)
{
    double y = HUGE_VAL;
    for (int k = 0; k < 2 * RIM; k++)
        y = fmin(y, tumble_body_vertex(w, b, k).y);
    return y;
}

// A coin that lands on its rim and falls over: how deep any vertex comes in two
// seconds, in its diameters.
static double deepest(double radius, double tilt)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_body_options o = tumble_body_at(0, 2 * radius, 0);
    o.pose.rotation = tumble_quat_turn(tumble_v(1, 0, 0.3), tilt);
    tumble_body b = tumble_body_add(w, coin(w, radius, radius / 4), o);
    double deep = 0;
    for (int k = 0; k < 120; k++) {
        tumble_world_step(w);
        deep = fmax(deep, -lowest(w, b) / (2 * radius));
    }
    tumble_world_free(w);
    return deep;
}

// Rejects: four points of a rim that are asked once a frame, while it slaps.
START_TEST(coin_that_slaps_a_plane_sinks_by_less_than_a_fiftieth)
{
    double deep = 0;
    for (double radius = 0.01; radius < 1; radius *= 3)
        for (double tilt = 0.4; tilt < 1.5; tilt += 0.1)
            deep = fmax(deep, deepest(radius, tilt));
    printf("coins that slap sink by %.2g of their diameter\n", deep);
    ck_assert_msg(deep < 1.0 / 50, "%g", deep);
}
END_TEST

// A blade of 2 m spins about its middle, in space; a ball at rest is in its way.
static bool is_hit(double spin, double thick, double radius, double away,
                   double angle)
{
    tumble_options o = tumble_options_default();
    o.gravity = tumble_v(0, 0, 0);
    tumble_world *w = tumble_world_make(&o);
    tumble_body_options spun = tumble_body_at(0, 0, 0);
    spun.spin = tumble_v(0, spin, 0);
    tumble_body_add(w, tumble_shape_box(w, tumble_v(2, 0.2, thick), 1000),
                    spun);
    tumble_body ball = tumble_body_add(w, tumble_shape_sphere(w, radius, 0.01),
        tumble_body_at(away * cos(angle), 0, away * sin(angle)));
    for (int k = 0; k < (int)(60 * PI / spin) + 2; k++) tumble_world_step(w);
    tumble_vec3 v = tumble_body_velocity(w, ball);
    tumble_world_free(w);
    return v.x * v.x + v.y * v.y + v.z * v.z > 0;
}

// Rejects: a blade that has come past a ball between two looks.
START_TEST(blade_misses_no_ball)
{
    unsigned long long seed = 3;
    int missed = 0;
    for (int k = 0; k < 400; k++) {
        double spin = 5 * pow(200, random_fraction(&seed));
        double thick = 0.005 * pow(20, random_fraction(&seed));
        double radius = 0.02 * pow(5, random_fraction(&seed));
        double away = 0.4 + 0.55 * random_fraction(&seed);
        double angle = PI * (0.15 + 0.7 * random_fraction(&seed));
        missed += !is_hit(spin, thick, radius, away, angle);
    }
    ck_assert_int_eq(missed, 0);
}
END_TEST

// A ball that does not turn itself goes round on a thread under the point that holds
// it, at an angle A, with sqrt(g / (L cos A)).  Rejects: a joint that asks for
// substeps by how its bodies turn alone.
static double rate_missed(double length, double angle, double dt)
{
    double rate = sqrt(9.81 / (length * cos(angle))), way = 0, last = 0;
    tumble_options how = tumble_options_default();
    how.dt = dt;
    tumble_world *w = tumble_world_make(&how);
    tumble_body_options o = tumble_body_at(length * sin(angle),
                                           -length * cos(angle), 0);
    o.velocity = tumble_v(0, 0, -rate * length * sin(angle));
    tumble_body b = tumble_body_add(w, tumble_shape_sphere(w, length / 20, 1),
                                    o);
    tumble_joint_distance(w, tumble_body_ground(), tumble_v(0, 0, 0), b,
                          o.pose.position, length, length);
    int steps = (int)(5 * 2 * PI / rate / dt);
    for (int k = 0; k < steps; k++) {
        tumble_world_step(w);
        tumble_vec3 x = tumble_body_position(w, b);
        double now = atan2(-x.z, x.x);
        way += remainder(now - last, 2 * PI);
        last = now;
    }
    tumble_world_free(w);
    return fabs(way / (rate * steps * dt) - 1);
}

START_TEST(conical_pendulum_keeps_its_rate_on_any_thread)
{
    for (double length = 0.02; length < 3; length *= 5)
        for (double angle = 0.3; angle < 1.45; angle += 0.2)
            for (double dt = 1.0 / 240; dt < 0.04; dt *= 2)
                ck_assert_double_lt(rate_missed(length, angle, dt), 1e-3);
}
END_TEST

// m in 10 s.  A low box of `size` stands on a plate that turns, where this part of
// what its friction can give holds it on its circle.
static double crept(double radius, double size, double friction, double part)
{
    double spin = sqrt(part * friction * 9.81 / radius);
    tumble_options o = tumble_options_default();
    o.friction = friction;
    tumble_world *w = tumble_world_make(&o);
    tumble_body_options at = tumble_body_at(0, -radius / 8, 0);
    at.kind = TUMBLE_KINEMATIC;
    at.spin = tumble_v(0, spin, 0);
    tumble_vec3 sides = { 4 * radius, radius / 4, 4 * radius };
    tumble_body plate = tumble_body_add(w, tumble_shape_box(w, sides, 1), at);
    tumble_body_options on = tumble_body_at(radius, size / 4, 0);
    on.velocity = tumble_v(0, 0, -spin * radius);
    on.spin = at.spin;
    tumble_body rider = tumble_body_add(w,
        tumble_shape_box(w, tumble_v(size, size / 2, size), 1), on);
    for (int k = 0; k < 600; k++) tumble_world_step(w);
    tumble_quat q = tumble_body_pose(w, plate).rotation;
    tumble_vec3 x = tumble_body_position(w, rider);
    double turned = 2 * atan2(q.y, q.w);
    tumble_world_free(w);
    return hypot(x.x - radius * cos(turned), x.z + radius * sin(turned));
}

// Coulomb's law lets it creep by nothing.  Rejects: friction that begins each substep
// in the direction that it had in the last, which lags behind the plate (2.4e-4 m and
// more).
START_TEST(box_on_a_turntable_stays_where_it_is)
{
    ck_assert_double_lt(crept(8, 1, 0.5, 0.5), 1e-4);
    ck_assert_double_lt(crept(8, 1, 0.2, 0.95), 1e-4);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        coin_that_slaps_a_plane_sinks_by_less_than_a_fiftieth,
        blade_misses_no_ball,
        conical_pendulum_keeps_its_rate_on_any_thread,
        box_on_a_turntable_stays_where_it_is,
        NULL
    };
    return suite_run((suite){ .name = "turning", .tests = tests });
}
