// check_drives.c - do motors, springs and sliders move what the formulas of
// mechanics say?
// Book: chapter 17.

#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "expect.h"
#include "suite.h"
#include "tumble.h"

#define EARTH 9.81
#define PI 3.14159265358979323846

static const double STEPS[] = { 1 / 30.0, 1 / 60.0, 1 / 120.0, 1 / 240.0 };
static const double SIZES[] = { 0.01, 0.1, 1, 10 };

static tumble_world *w;
static tumble_body body;
static tumble_joint joint_now;

static void end_world(void)
{
    tumble_world_free(w);
    w = NULL;
}

// Nothing sleeps in it.
static void begin_world(double dt, double down)
{
    end_world();
    tumble_options o = tumble_options_default();
    o.dt = dt;
    o.gravity = tumble_v(0, -down, 0);
    o.sleep_speed = 0;
    w = tumble_world_make(&o);
    ck_assert_ptr_nonnull(w);
}

static tumble_body box_at(double x, double y, double z, tumble_vec3 sides,
                          double mass)
{
    return tumble_body_add(w, tumble_shape_box(w, sides, mass),
                           tumble_body_at(x, y, z));
}

static void go(double seconds, double dt)
{
    int n = (int)(seconds / dt + 0.5);
    for (int k = 0; k < n; k++) tumble_world_step(w);
    ck_assert_msg(!tumble_world_failure(w), "%s", tumble_world_failure(w));
}

// A cube whose centre is so many sides beside a hinge of the ground along z;
// returns its inertia about the hinge.
static double hang_cube(double side, double beside, double mass)
{
    double arm = beside * side;
    body = box_at(arm, 0, 0, tumble_v(side, side, side), mass);
    joint_now = tumble_joint_hinge(w, tumble_body_ground(), body,
                                   tumble_v(0, 0, 0), tumble_v(0, 0, 1));
    return mass * (side * side / 6 + arm * arm);
}

// A cube on a slider of the ground.
static void slide_cube(double side, double mass, tumble_vec3 axis)
{
    body = box_at(0, 0, 0, tumble_v(side, side, side), mass);
    joint_now = tumble_joint_slider(w, tumble_body_ground(), body,
                                    tumble_v(0, 0, 0), axis);
}

static double place(void)   { return tumble_joint_place(w, joint_now); }
static double speed(void)   { return tumble_joint_speed(w, joint_now); }
static double driven(void)  { return tumble_joint_drive(w, joint_now); }

START_TEST(motor_spins_up_by_torque_over_inertia_until_its_speed)
{
    // Rejects: a torque of a frame given in each substep, a bound that is an
    // impulse, a whole kick at the start, a motor that goes on beyond its speed.
    for (int i = 0; i < COUNT(STEPS); i++)
        for (int k = 0; k < COUNT(SIZES); k++) {
            double mass = 1000 * pow(SIZES[k], 3), most = 5;
            begin_world(STEPS[i], 0);
            double inertia = hang_cube(SIZES[k], 0, mass), torque = 2 * inertia;
            ck_assert(tumble_joint_set_motor(w, joint_now, most, torque));
            go(1, STEPS[i]);
            near_relative(place(), 1, 1e-9, "the angle, torque / inertia / 2");
            near_relative(driven(), torque, 1e-12, "all that it can");
            go(2, STEPS[i]);
            near_relative(speed(), most, 1e-9, "its speed");
            near(driven() / torque, 0, 1e-9, "it has no more to do");
        }
}
END_TEST

START_TEST(motor_holds_what_its_torque_bears_and_no_more)
{
    // m g l is needed: with a thousandth more the arm stays for ten seconds, with
    // a thousandth less it sinks as the thousandth would turn it.
    // Rejects: a brake that creeps, an arm of the wrong end, a motor without bound.
    const double gravities[] = { 1.62, EARTH, 100 };
    for (int i = 0; i < COUNT(STEPS); i++)
        for (int k = 0; k < COUNT(SIZES); k++)
            for (int g = 0; g < COUNT(gravities); g++) {
                double mass = 1000 * pow(SIZES[k], 3), arm = SIZES[k];
                double need = mass * gravities[g] * arm;
                begin_world(STEPS[i], gravities[g]);
                double inertia = hang_cube(SIZES[k], 1, mass);
                tumble_joint_set_motor(w, joint_now, 0, 1.001 * need);
                go(2, STEPS[i]);
                near(place(), 0, 1e-6, "it holds");
                near_relative(driven(), need, 1e-9, "what it bears");
                double before = place();
                go(8, STEPS[i]);
                near(place(), before, 1e-12, "it does not creep");
                tumble_joint_set_motor(w, joint_now, 0, 0.999 * need);
                // So little that the arm stays level; to whole steps.
                double faster = 0.001 * need / inertia;
                double n = ceil(sqrt(2 * 0.004 / faster) / STEPS[i]);
                double t = n * STEPS[i];
                go(t, STEPS[i]);
                // A body that rested begins with a whole kick: a substep more.
                near_relative(place() - before, -faster * t * t / 2,
                              0.02 + 1 / (240 * t), "it sinks");
            }
}
END_TEST

// s, the mean of so many swings of the joint about `middle`.
static double period(double middle, double dt, int swings)
{
    double before = place() - middle, first = 0, last = 0;
    int crossings = 0;
    for (int k = 1; crossings <= 2 * swings && k < 100000; k++) {
        tumble_world_step(w);
        double now = place() - middle;
        if (now * before < 0) {
            last = (k - now / (now - before)) * dt;
            if (crossings++ == 0) first = last;
        }
        before = now;
    }
    return (last - first) / swings;
}

// The greatest way from there in a second.
static double amplitude(double middle, double dt)
{
    double most = 0;
    for (int k = 0; k < 1 / dt; k++) {
        tumble_world_step(w);
        most = fmax(most, fabs(place() - middle));
    }
    return most;
}

START_TEST(spring_of_a_hinge_swings_in_the_time_of_its_inertia)
{
    // 2 pi sqrt(I / k), longer by (h omega)^2 / 12 of itself, and it keeps its
    // swing.  h is 1/240 s at most (tumble.h).
    // Rejects: a spring that is pushed from where it is, or from where it will be
    // alone, which halves its swing in ten, an inertia about the centre.
    for (int i = 0; i < COUNT(STEPS); i++)
        for (int k = 0; k < COUNT(SIZES); k++) {
            begin_world(STEPS[i], 0);
            double inertia = hang_cube(SIZES[k], 1.5, 7);
            double omega = 2 * PI, late = omega / 240;
            tumble_joint_set_spring(w, joint_now, 0.3, inertia * omega * omega,
                                    0);
            near_relative(period(0.3, STEPS[i], 10), 1, late * late / 11,
                          "one second");
            near_relative(amplitude(0.3, STEPS[i]), 0.3, 1e-3, "of ten swings");
        }
}
END_TEST

START_TEST(damper_brakes_by_its_exponential)
{
    // omega exp(-c t / I), of a damper alone.
    // Rejects: a damping of the speed before, which throws it back if c is large,
    // and one of the speed after, which brakes less by c h / (2 I).
    const double rates[] = { 0.3, 3, 30 };
    for (int i = 0; i < COUNT(STEPS); i++)
        for (int k = 0; k < COUNT(rates); k++) {
            begin_world(STEPS[i], 0);
            double inertia = hang_cube(0.5, 0, 3), off = rates[k] / 240;
            tumble_body_set_velocity(w, body, tumble_v(0, 0, 0),
                                     tumble_v(0, 0, 2));
            tumble_joint_set_spring(w, joint_now, 0, 0, rates[k] * inertia);
            go(1, STEPS[i]);
            double turned = 2 / rates[k] * (1 - exp(-rates[k]));
            near_relative(place(), turned, off * off + 1e-6);
        }
}
END_TEST

START_TEST(strong_damper_stops_what_turns_and_throws_nothing_back)
{
    // Rejects: the mean of the speeds before and after, which turns a wheel round in
    // every substep once c h / I is large, for ever.
    for (int i = 0; i < COUNT(STEPS); i++)
        for (double rate = 1e4; rate < 1e9; rate *= 100) {
            begin_world(STEPS[i], 0);
            double inertia = hang_cube(0.5, 0, 3);
            tumble_body_set_velocity(w, body, tumble_v(0, 0, 0),
                                     tumble_v(0, 0, 2));
            tumble_joint_set_spring(w, joint_now, 0, 0, rate * inertia);
            tumble_world_step(w);
            ck_assert_msg(speed() > -1e-9 && speed() < 0.02,
                          "dt %g, c / I %g: %g rad/s", STEPS[i], rate, speed());
        }
}
END_TEST

START_TEST(spring_of_a_hinge_takes_the_shorter_way_round)
{
    // From 2.5 to -2.5 rad it is 1.28 rad by way of pi, and 5 by way of 0.
    // Rejects: a difference of angles that is taken as it is.
    begin_world(1 / 60.0, 0);
    double inertia = hang_cube(0.5, 0, 3), nearest = PI;
    tumble_joint_set_servo(w, joint_now, 2.5, 2, 1, 100 * inertia);
    go(3, 1 / 60.0);
    for (int side = -1; side <= 1; side += 2) {
        tumble_joint_set_servo(w, joint_now, side * 2.5, 2, 1, 100 * inertia);
        for (int k = 0; k < 180; k++) {
            tumble_world_step(w);
            nearest = fmin(nearest, fabs(place()));
        }
        near(place(), side * 2.5, 1e-6, "there");
    }
    ck_assert_msg(nearest > 2.4, "it came by %g rad", nearest);
}
END_TEST

START_TEST(spring_of_any_stiffness_is_safe_at_any_step)
{
    // From where it is unloaded a weight sinks by twice m g / k at most.  What a
    // substep cannot follow comes to rest there.
    // Rejects: a spring pushed from where it is.
    const double steps[] = { 1 / 240.0, 1 / 60.0, 1 / 30.0, 0.25, 1 };
    for (int i = 0; i < COUNT(steps); i++)
        for (double k = 1e-3; k < 1e14; k *= 10) {
            begin_world(steps[i], EARTH);
            slide_cube(0.2, 2, tumble_v(0, 1, 0));
            tumble_joint_set_spring(w, joint_now, 0, k, 0);
            double sag = 2 * EARTH / k;
            for (int n = 0; n < 240; n++) {
                tumble_world_step(w);
                ck_assert_msg(place() <= 1e-3 * sag && place() > -2.01 * sag,
                              "k %g, dt %g: %g of %g", k, steps[i], place(), sag);
            }
            if (k >= 1e7) near_relative(place(), -sag, 1e-6, "at rest");
        }
}
END_TEST

// rad, of a spring of 1 Hz that is let go from 0 and braked by `ratio`.
static double swung(double to, double ratio, double t)
{
    double own = 2 * PI, wet = own * sqrt(1 - ratio * ratio);
    return to - to * exp(-ratio * own * t)
              * (cos(wet * t) + ratio * own / wet * sin(wet * t));
}

START_TEST(servo_of_one_hertz_comes_as_a_damped_spring_does)
{
    // Rejects: an inertia about the centre, or of one body of two, a ratio taken
    // for a damping.
    const double ratios[] = { 0, 0.1, 0.7 };
    for (int i = 0; i < COUNT(STEPS); i++)
        for (int k = 0; k < COUNT(ratios); k++) {
            begin_world(STEPS[i], 0);
            hang_cube(0.3, 2, 4);
            tumble_joint_set_servo(w, joint_now, 0.2, 1, ratios[k], HUGE_VAL);
            for (int n = 1; n <= 2 / STEPS[i]; n++) {
                tumble_world_step(w);
                near(place(), swung(0.2, ratios[k], n * STEPS[i]), 2e-4);
            }
        }
}
END_TEST

START_TEST(servo_gives_its_most_and_arrives)
{
    // It lifts an arm with 1.5 m g l, and would give ten times as much.
    // Rejects: a bound that is not asked, or not left again.
    begin_world(1 / 60.0, EARTH);
    hang_cube(0.2, 1, 3);
    double need = 3 * EARTH * 0.2;
    tumble_joint_set_servo(w, joint_now, 1.2, 5, 1, 1.5 * need);
    double most = 0;
    for (int k = 0; k < 300; k++) {
        tumble_world_step(w);
        most = fmax(most, fabs(driven()));
    }
    near_relative(most, 1.5 * need, 1e-9, "its most");
    near_relative(driven(), need * cos(place()), 1e-6, "what it bears");
    ck_assert(place() > 1.1 && place() < 1.2);
    tumble_joint_set_servo(w, joint_now, 1.2, 5, 1, 0.3 * need);
    go(0.3, 1 / 60.0);
    ck_assert_msg(place() < 1.1, "less lets the arm sink: %g", place());
}
END_TEST

// m: a joint gives way by 1e-4 of what gravity does in a substep of 1/240 s.
static const double GAP = 2e-8;

START_TEST(slider_on_a_slope_falls_by_the_sine)
{
    // Rejects: rows of directions that do not turn with A, a slider that turns.
    const double slopes[] = { 0, 0.3, 1, PI / 2 };
    for (int i = 0; i < COUNT(STEPS); i++)
        for (int k = 0; k < COUNT(SIZES); k++)
            for (int s = 0; s < COUNT(slopes); s++) {
                double pull = EARTH * sin(slopes[s]);
                begin_world(STEPS[i], EARTH);
                slide_cube(SIZES[k], 3, tumble_v(cos(slopes[s]), -sin(slopes[s]),
                                                 0));
                go(1, STEPS[i]);
                near(place(), pull / 2, 1e-9 * pull + 1e-9);
                near(tumble_joint_gap(w, joint_now), 0, GAP);
                near(tumble_body_spin(w, body).z, 0, 1e-9);
            }
}
END_TEST

START_TEST(slider_stops_at_its_limits_and_bears_the_weight_there)
{
    // Rejects: a limit that pulls, an end that is taken for the other.
    for (int is_driven = 0; is_driven < 2; is_driven++) {
        begin_world(1 / 60.0, EARTH);
        slide_cube(0.2, 3, tumble_v(0, 1, 0));
        ck_assert(tumble_joint_set_limits(w, joint_now, -0.5, 0.25));
        if (is_driven) tumble_joint_set_motor(w, joint_now, 0, 1e-9);
        go(2, 1 / 60.0);
        near(place(), -0.5, 1e-6);
        near_relative(tumble_joint_force(w, joint_now), 3 * EARTH, 1e-6);
        tumble_body_set_velocity(w, body, tumble_v(0, 5, 0), tumble_v(0, 0, 0));
        double most = -1;
        for (int k = 0; k < 30; k++) {
            tumble_world_step(w);
            most = fmax(most, place());
        }
        near(most, 0.25, 1e-3, "the upper one");
        go(2, 1 / 60.0);
        near(place(), -0.5, 1e-6);
    }
}
END_TEST

START_TEST(spring_sags_by_weight_over_stiffness)
{
    for (int i = 0; i < COUNT(STEPS); i++)
        for (double k = 10; k < 1e6; k *= 10) {
            begin_world(STEPS[i], EARTH);
            slide_cube(0.2, 2, tumble_v(0, 1, 0));
            tumble_joint_set_spring(w, joint_now, 0.1, k, 2 * sqrt(2 * k));
            go(20, STEPS[i]);
            near_relative(place() - 0.1, -2 * EARTH / k, 1e-9);
            near_relative(driven(), 2 * EARTH, 1e-9);
        }
}
END_TEST

START_TEST(distance_with_a_spring_is_a_spring)
{
    // A weight hangs from it, and swings up and down in 2 pi sqrt(m / k).
    // Rejects: a rod that stays a rod.
    begin_world(1 / 60.0, EARTH);
    body = box_at(0, -1, 0, tumble_v(0.1, 0.1, 0.1), 2);
    joint_now = tumble_joint_distance(w, tumble_body_ground(),
                                      tumble_v(0, 0, 0), body,
                                      tumble_v(0, -1, 0), 1, 1);
    double k = 2 * 16 * PI * PI, sag = 2 * EARTH / k;
    ck_assert(tumble_joint_set_spring(w, joint_now, 1, k, 0));
    near_relative(period(1 + sag, 1 / 60.0, 10), 0.5, 3e-4);
    tumble_joint_set_spring(w, joint_now, 1, k, 30);
    go(5, 1 / 60.0);
    near_relative(place(), 1 + sag, 1e-9);
    near_relative(tumble_joint_force(w, joint_now), 2 * EARTH, 1e-9);
    tumble_joint_set_limits(w, joint_now, 0.5, 1.01);
    go(2, 1 / 60.0);
    near(place(), 1.01, 1e-6, "a limit holds beside it");
    tumble_joint_set_limits(w, joint_now, 1, 1);
    tumble_joint_set_spring(w, joint_now, 1, 0, 0);
    go(2, 1 / 60.0);
    near(place(), 1, 1e-6, "without it, it is a rod");
}
END_TEST

START_TEST(motor_without_a_speed_is_friction)
{
    // v^2 / (2 F / m) is the way; then it stays on a slope that pulls less.
    for (int i = 0; i < COUNT(STEPS); i++) {
        begin_world(STEPS[i], 0);
        slide_cube(0.2, 2, tumble_v(1, 0, 0));
        tumble_body_set_velocity(w, body, tumble_v(3, 0, 0), tumble_v(0, 0, 0));
        tumble_joint_set_motor(w, joint_now, 0, 9);
        go(3, STEPS[i]);
        near_relative(place(), 1, 1e-3);
        near(speed(), 0, 1e-9);
        tumble_world_set_gravity(w, tumble_v(4.4, 0, 0));
        go(3, STEPS[i]);
        near_relative(place(), 1, 1e-3);
        near_relative(driven(), -8.8, 1e-6);
    }
}
END_TEST

START_TEST(motor_pushes_at_a_limit_and_comes_away_from_it)
{
    // Rejects: a limit that the motor pushes through, or that glues it.
    begin_world(1 / 60.0, 0);
    double inertia = hang_cube(0.2, 1, 3), torque = 20 * inertia;
    tumble_joint_set_limits(w, joint_now, -0.5, 1);
    tumble_joint_set_motor(w, joint_now, 2, torque);
    go(2, 1 / 60.0);
    near(place(), 1, 1e-5);
    near(driven(), 0, 1e-9 * torque, "the limit takes what the motor gives");
    tumble_joint_set_motor(w, joint_now, -2, torque);
    go(0.5, 1 / 60.0);
    near(place(), 1 - 2 * 0.45, 0.01);
    go(2, 1 / 60.0);
    near(place(), -0.5, 1e-5);
}
END_TEST

START_TEST(arm_of_seven_motors_holds_itself_level)
{
    // Each bears the moment of all beyond it, and a hundredth more.
    // Rejects: motors that give way one after the other.
    enum { LINKS = 7 };
    tumble_joint at[LINKS];
    begin_world(1 / 60.0, EARTH);
    tumble_body before = tumble_body_ground();
    double need[LINKS];
    for (int k = 0; k < LINKS; k++) {
        tumble_body b = box_at(0.1 + 0.2 * k, 0, 0, tumble_v(0.2, 0.05, 0.05), 1);
        at[k] = tumble_joint_hinge(w, before, b, tumble_v(0.2 * k, 0, 0),
                                   tumble_v(0, 0, 1));
        need[k] = 0;
        for (int i = k; i < LINKS; i++) need[k] += EARTH * (0.1 + 0.2 * (i - k));
        tumble_joint_set_motor(w, at[k], 0, 1.01 * need[k]);
        before = b;
    }
    go(10, 1 / 60.0);
    for (int k = 0; k < LINKS; k++) {
        near(tumble_joint_place(w, at[k]), 0, 1e-3);
        near_relative(tumble_joint_drive(w, at[k]), need[k], 1e-3);
    }
}
END_TEST

static double worst(tumble_vec3 a, tumble_vec3 b)
{
    return fmax(fabs(a.x - b.x), fmax(fabs(a.y - b.y), fabs(a.z - b.z)));
}

START_TEST(driven_bodies_in_flight_keep_their_momenta)
{
    // A motor, a spring and a slider with limits between four bodies that tumble.
    // Rejects: a slider whose impulses act at two points, a kick of one body.
    begin_world(1 / 60.0, 0);
    tumble_body a = box_at(0, 0, 0, tumble_v(0.3, 0.2, 0.1), 1);
    tumble_body b = box_at(0.5, 0.1, 0, tumble_v(0.2, 0.4, 0.1), 2);
    tumble_body c = box_at(1, 0, 0.2, tumble_v(0.1, 0.1, 0.3), 0.5);
    tumble_body d = box_at(1, 1, 0.2, tumble_v(0.1, 0.1, 0.3), 0.5);
    const tumble_body all[] = { a, b, c, d };
    for (int k = 0; k < 4; k++) tumble_body_set_filter(w, all[k], 1, 2);
    tumble_joint h = tumble_joint_hinge(w, a, b, tumble_v(0.25, 0, 0),
                                        tumble_v(0, 1, 1));
    tumble_joint s = tumble_joint_slider(w, b, c, tumble_v(0.7, 0, 0),
                                         tumble_v(1, 0.3, 0.1));
    tumble_joint e = tumble_joint_distance(w, c, tumble_v(1, 0.05, 0.2), d,
                                           tumble_v(1, 0.95, 0.2), 0.1, 2);
    tumble_joint_set_motor(w, h, 7, 0.2);
    tumble_joint_set_spring(w, s, 0.1, 200, 0);
    tumble_joint_set_limits(w, s, -0.3, 0.5);
    tumble_joint_set_spring(w, e, 0.5, 100, 0);
    tumble_body_set_velocity(w, a, tumble_v(0, 1, 0), tumble_v(3, 1, 2));
    tumble_measures m = tumble_world_measure(w);
    for (int k = 0; k < 600; k++) {
        tumble_world_step(w);
        tumble_measures now = tumble_world_measure(w);
        near(worst(now.momentum, m.momentum), 0, 1e-10);
        near(worst(now.angular, m.angular), 0, 1e-10);
        near(tumble_joint_gap(w, s), 0, 1e-4);
    }
}
END_TEST

static void expect_refusal(bool is_done, const char *why)
{
    ck_assert(!is_done);
    ck_assert_ptr_nonnull(tumble_world_failure(w));
    ck_assert_msg(strstr(tumble_world_failure(w), why), "\"%s\", not \"%s\"",
                  tumble_world_failure(w), why);
    tumble_world_forget_failure(w);
}

static double swing(void)   { return tumble_joint_swing(w, joint_now); }
static double twist(void)   { return tumble_joint_twist(w, joint_now); }

START_TEST(cone_holds_what_leans_on_it)
{
    // A rod stands on a ball joint, is tipped, and lies on its cone, wherever it
    // falls: its moment is m g l sin(swing), and its lean is that of its pose.
    // Rejects: a swing that is measured about one axis, a limit that pulls.
    for (int i = 0; i < COUNT(STEPS); i++)
        for (int k = 0; k < COUNT(SIZES); k++)
            for (double way = 0; way < 6; way += 1.3) {
                double l = SIZES[k], pace = 0.3 * sqrt(EARTH / l);
                begin_world(STEPS[i], EARTH);
                body = box_at(0, l, 0, tumble_v(0.2 * l, 2 * l, 0.2 * l), 3);
                joint_now = tumble_joint_ball(w, tumble_body_ground(), body,
                                              tumble_v(0, 0, 0));
                ck_assert(tumble_joint_set_cone(w, joint_now, tumble_v(0, 2, 0),
                                                0.6, -HUGE_VAL, HUGE_VAL));
                tumble_body_set_velocity(w, body, tumble_v(0, 0, 0),
                                         tumble_v(pace * cos(way), 0,
                                                  pace * sin(way)));
                double most = 0;
                for (int n = 0; n < 6 / STEPS[i]; n++) {
                    tumble_world_step(w);
                    most = fmax(most, swing());
                }
                near(most, 0.6, 2e-3, "at the impact");
                near(swing(), 0.6, 1e-5, "at rest");
                near(acos(tumble_body_position(w, body).y / l), 0.6, 1e-5);
                near(tumble_joint_gap(w, joint_now), 0, 1e-4 * l);
            }
}
END_TEST

START_TEST(cone_stops_a_twist_at_each_of_its_ends)
{
    // The swing is kept at 0.4 rad by its own limit while B turns about its axis.
    // Rejects: an end taken for the other, a twist that the swing changes.
    for (int sign = -1; sign <= 1; sign += 2) {
        begin_world(1 / 60.0, 0);
        body = box_at(0, 1, 0, tumble_v(0.3, 0.3, 0.3), 3);
        joint_now = tumble_joint_ball(w, tumble_body_ground(), body,
                                      tumble_v(0, 1, 0));
        tumble_joint_set_cone(w, joint_now, tumble_v(0, 1, 0), 0.4, -0.5, 0.8);
        tumble_body_set_velocity(w, body, tumble_v(0, 0, 0),
                                 tumble_v(0.3, sign * 2, 0.1));
        double most = 0, least = 0;
        for (int k = 0; k < 300; k++) {
            tumble_world_step(w);
            most = fmax(most, twist());
            least = fmin(least, twist());
            ck_assert(swing() < 0.4 + 1e-3);
        }
        if (sign > 0)   near(most, 0.8, 1e-3);
        else            near(least, -0.5, 1e-3);
        ck_assert(most < 0.801 && least > -0.501);
    }
}
END_TEST

START_TEST(cone_in_flight_keeps_momenta_and_gains_no_energy)
{
    // Two boxes that tumble, thrown against their limits again and again.
    // Rejects: rows that turn one body only.
    begin_world(1 / 60.0, 0);
    tumble_body a = box_at(0, 0, 0, tumble_v(0.3, 0.2, 0.1), 1);
    tumble_body b = box_at(0.5, 0.1, 0, tumble_v(0.2, 0.4, 0.1), 2);
    joint_now = tumble_joint_ball(w, a, b, tumble_v(0.25, 0, 0));
    tumble_joint_set_cone(w, joint_now, tumble_v(1, 0, 0), 0.5, -0.3, 0.3);
    tumble_body_set_velocity(w, a, tumble_v(0, 1, 0), tumble_v(3, 1, 2));
    tumble_measures m = tumble_world_measure(w);
    double before = m.kinetic;
    for (int k = 0; k < 1200; k++) {
        tumble_world_step(w);
        tumble_measures now = tumble_world_measure(w);
        near(worst(now.momentum, m.momentum), 0, 1e-10);
        near(worst(now.angular, m.angular), 0, 1e-10);
        ck_assert(now.kinetic < 1.001 * before);
        ck_assert(swing() < 0.5 + 2e-3 && fabs(twist()) < 0.3 + 2e-3);
    }
}
END_TEST

START_TEST(cone_is_refused_saved_and_taken_off)
{
    begin_world(1 / 60.0, EARTH);
    body = box_at(0, 1, 0, tumble_v(0.2, 2, 0.2), 3);
    joint_now = tumble_joint_ball(w, tumble_body_ground(), body,
                                  tumble_v(0, 0, 0));
    tumble_vec3 up = tumble_v(0, 1, 0);
    tumble_joint j = joint_now;
    expect_refusal(tumble_joint_set_cone(w, j, tumble_v(0, 0, 0), 1, -1, 1),
                   "the axis");
    expect_refusal(tumble_joint_set_cone(w, j, tumble_v(NAN, 0, 0), 1, -1, 1),
                   "the axis");
    expect_refusal(tumble_joint_set_cone(w, j, up, -1, -1, 1), "a swing of -1");
    expect_refusal(tumble_joint_set_cone(w, j, up, NAN, -1, 1), "a swing of");
    expect_refusal(tumble_joint_set_cone(w, j, up, 1, 1, -1),
                   "a twist of 1 to -1");
    expect_refusal(tumble_joint_set_cone(w, j, up, 1, 4, 5),
                   "a twist of 4 to 5");
    ck_assert(swing() == 0 && twist() == 0);
    ck_assert(tumble_joint_set_cone(w, j, up, 0.5, -0.1, 0.1));
    tumble_body_set_velocity(w, body, tumble_v(1, 0, 0), tumble_v(0, 1, -1));
    for (int n = 0; n < 20; n++) {
        size_t size = tumble_world_save(w, NULL, 0);
        void *bytes = malloc(size);
        tumble_world_save(w, bytes, size);
        tumble_world *copy = tumble_world_load(bytes, size);
        for (int k = 0; k < 7; k++) {
            tumble_world_step(w);
            tumble_world_step(copy);
        }
        ck_assert(tumble_world_hash(w) == tumble_world_hash(copy));
        tumble_world_free(copy);
        free(bytes);
    }
    ck_assert(tumble_joint_set_cone(w, j, up, HUGE_VAL, -HUGE_VAL, HUGE_VAL));
    go(1, 1 / 60.0);
    ck_assert(tumble_body_position(w, body).y < 0);
    tumble_vec3 sides = tumble_v(1, 1, 1);
    tumble_joint h = tumble_joint_hinge(w, tumble_body_ground(),
                                        box_at(9, 0, 0, sides, 1),
                                        tumble_v(9, 0, 0), up);
    expect_refusal(tumble_joint_set_cone(w, h, up, 1, -1, 1),
                   "is no ball joint");
}
END_TEST

START_TEST(joint_says_where_it_is_and_how_fast_without_a_drive)
{
    begin_world(1 / 60.0, 0);
    hang_cube(0.2, 1, 3);
    tumble_body_set_velocity(w, body, tumble_v(0, 0.2, 0), tumble_v(0, 0, 1));
    go(0.5, 1 / 60.0);
    near_relative(place(), 0.5, 1e-5);
    near_relative(speed(), 1, 1e-6);
    near_relative(tumble_joint_angle(w, joint_now), 0.5, 1e-5);
    near(driven(), 0, 0);
}
END_TEST

// A door of this size, that a strong damper lets a spring close slowly, falls asleep.
// m, how far its edge is from where it is closed then.
static double edge_left(double side, double ratio, double hertz)
{
    end_world();
    w = tumble_world_make(NULL);
    tumble_vec3 up = tumble_v(0, 1, 0), at = tumble_v(side / 2, 0, 0);
    tumble_body door = box_at(at.x, 0, 0, tumble_v(side, 2 * side, side / 20), 1);
    tumble_joint j = tumble_joint_hinge(w, tumble_body_ground(), door,
                                        tumble_v(0, 0, 0), up);
    tumble_pose open = { at, tumble_quat_turn(up, 1) };
    open.position = tumble_quat_rotate(open.rotation, at);
    ck_assert(tumble_body_set_pose(w, door, open));
    ck_assert(tumble_joint_set_servo(w, j, 0, hertz, ratio, HUGE_VAL));
    int frames = 0;
    while (tumble_body_is_awake(w, door) && frames++ < 30000) tumble_world_step(w);
    ck_assert(!tumble_body_is_awake(w, door));
    return fabs(tumble_joint_angle(w, j)) * side;
}

// It sleeps where it has no further to go than what is still goes before it sleeps:
// sleep_speed for half of time_to_sleep, by Froude's scaling, or a little less.
// Rejects: one that sleeps while it is slow, however far it has to go.
START_TEST(door_that_closes_slowly_closes)
{
    for (double side = 0.02; side < 3; side *= 5)
        for (double hertz = 0.3; hertz < 2; hertz *= 4)
            for (double ratio = 2; ratio < 30; ratio *= 3) {
                double size = side * 1.12 / 0.5, times = fmax(1, sqrt(size));
                double most = 0.005 * sqrt(size) * 0.25 * times;
                double left = edge_left(side, ratio, hertz);
                ck_assert_msg(left < 1.2 * most, "%g m, %g Hz, ratio %g: %g m "
                              "of %g m", side, hertz, ratio, left, most);
            }
}
END_TEST

// A servo and a joint's strength take HUGE_VAL for no bound, and so does a motor: it
// lifts what is heavy as fast as it should, stands at its limit, and comes back.
// Rejects: a motor that is refused, and one that gives all that it has at a limit.
START_TEST(a_motor_of_infinite_force_gives_what_it_takes)
{
    begin_world(1 / 60.0, EARTH);
    hang_cube(0.2, 1, 1000);
    tumble_joint j = joint_now;
    ck_assert(tumble_joint_set_strength(w, j, HUGE_VAL));
    ck_assert(tumble_joint_set_servo(w, j, 0, 1, 1, HUGE_VAL));
    ck_assert(tumble_joint_set_servo(w, j, 0, 1, 1, 0));
    ck_assert(tumble_joint_set_limits(w, j, -0.5, 0.5));
    ck_assert(tumble_joint_set_motor(w, j, 1, HUGE_VAL));
    for (int k = 0; k < 15; k++) tumble_world_step(w);
    near_relative(tumble_joint_angle(w, j), 0.25, 1e-3);
    for (int k = 0; k < 45; k++) tumble_world_step(w);
    near_relative(tumble_joint_angle(w, j), 0.5, 1e-3);
    ck_assert(tumble_joint_set_motor(w, j, -1, HUGE_VAL));
    for (int k = 0; k < 30; k++) tumble_world_step(w);
    near(tumble_joint_angle(w, j), 0, 1e-3);
    near(tumble_joint_speed(w, j), -1, 1e-3);
}
END_TEST

START_TEST(what_makes_no_drive_is_refused_with_a_sentence)
{
    begin_world(1 / 60.0, EARTH);
    hang_cube(0.2, 1, 3);
    tumble_joint j = joint_now, none = { 0, 0 };
    tumble_joint_set_motor(w, j, 0, 100);
    unsigned long long hash = tumble_world_hash(w);
    expect_refusal(tumble_joint_set_motor(w, j, NAN, 1), "a motor of speed");
    expect_refusal(tumble_joint_set_motor(w, j, HUGE_VAL, 1),
                   "a motor of speed");
    expect_refusal(tumble_joint_set_motor(w, j, 1, -1), "force -1");
    expect_refusal(tumble_joint_set_motor(w, j, 1, NAN), "a motor of speed");
    expect_refusal(tumble_joint_set_motor(w, none, 1, 1), "joint");
    expect_refusal(tumble_joint_set_spring(w, j, NAN, 1, 1),
                   "a spring of stiffness");
    expect_refusal(tumble_joint_set_spring(w, j, 0, -1, 1), "stiffness -1");
    expect_refusal(tumble_joint_set_spring(w, j, 0, 1, HUGE_VAL),
                   "a spring of");
    expect_refusal(tumble_joint_set_spring(w, j, 4, 1, 1), "never at 4 rad");
    expect_refusal(tumble_joint_set_spring(w, none, 0, 1, 1), "joint");
    expect_refusal(tumble_joint_set_servo(w, j, 0, 0, 1, 1), "a servo of 0 Hz");
    expect_refusal(tumble_joint_set_servo(w, j, 0, 1, -1, 1),
                   "a servo of 1 Hz");
    expect_refusal(tumble_joint_set_servo(w, j, 0, 1, 1, NAN),
                   "a servo of 1 Hz");
    expect_refusal(tumble_joint_set_servo(w, j, NAN, 1, 1, 1), "a spring of");
    tumble_body b = box_at(5, 0, 0, tumble_v(1, 1, 1), 1);
    tumble_joint ball = tumble_joint_ball(w, tumble_body_ground(), b,
                                          tumble_v(5, 0, 0));
    expect_refusal(tumble_joint_set_motor(w, ball, 1, 1),
                   "a ball joint has no free way");
    expect_refusal(tumble_joint_set_spring(w, ball, 1, 1, 0),
                   "there is no spring");
    expect_refusal(tumble_joint_set_servo(w, ball, 1, 1, 0, 1),
                   "there is no spring");
    j = tumble_joint_slider(w, tumble_body_ground(), b, tumble_v(0, 0, 0),
                            tumble_v(0, 0, 0));
    expect_refusal(j.generation != 0, "the axis of a slider has no direction");
    ck_assert(!tumble_joint_set_motor(NULL, j, 1, 1));
    ck_assert(tumble_joint_speed(NULL, j) == 0);
    ck_assert(tumble_joint_drive(w, none) == 0);
    go(1, 1 / 60.0);
    near(place(), 0, 1e-6, "the motor that was set holds");
    ck_assert(hash != 0);
}
END_TEST

START_TEST(saved_drives_go_on_with_the_same_bits)
{
    begin_world(1 / 60.0, EARTH);
    hang_cube(0.2, 1, 3);
    tumble_joint_set_limits(w, joint_now, -1, 1);
    tumble_joint_set_motor(w, joint_now, 2, 8);
    tumble_joint_set_servo(w, joint_now, 0.3, 2, 0.1, 5);
    slide_cube(0.2, 2, tumble_v(0, 1, 0.2));
    tumble_joint_set_spring(w, joint_now, 0.1, 300, 1);
    for (int n = 0; n < 60; n++) {
        size_t size = tumble_world_save(w, NULL, 0);
        void *bytes = malloc(size);
        tumble_world_save(w, bytes, size);
        tumble_world *copy = tumble_world_load(bytes, size);
        ck_assert_ptr_nonnull(copy);
        for (int k = 0; k < 7; k++) {
            tumble_world_step(w);
            tumble_world_step(copy);
        }
        ck_assert(tumble_world_hash(w) == tumble_world_hash(copy));
        ck_assert(tumble_joint_drive(copy, joint_now) == driven());
        tumble_world_free(copy);
        free(bytes);
    }
}
END_TEST

START_TEST(drive_goes_with_its_body_and_with_what_breaks)
{
    begin_world(1 / 60.0, EARTH);
    slide_cube(0.2, 2, tumble_v(0, 1, 0));
    tumble_joint_set_spring(w, joint_now, 0, 300, 30);
    tumble_body_remove(w, body);
    ck_assert(!tumble_joint_exists(w, joint_now) && place() == 0
              && speed() == 0);
    slide_cube(0.2, 2, tumble_v(0, 1, 0));
    tumble_joint_set_spring(w, joint_now, 0, 1e5, 100);
    tumble_joint_set_strength(w, joint_now, 1.9 * EARTH);
    go(1, 1 / 60.0);
    ck_assert(!tumble_joint_exists(w, joint_now));
    ck_assert(tumble_body_velocity(w, body).y < -5);
}
END_TEST

// As a program has it: bodies sleep.
static void begin_sleepy(void)
{
    end_world();
    w = tumble_world_make(NULL);
}

START_TEST(what_sleeps_wakes_when_its_drive_is_set)
{
    begin_sleepy();
    hang_cube(0.2, 1, 3);
    tumble_joint_set_motor(w, joint_now, 0, 100);
    go(5, 1 / 60.0);
    ck_assert(!tumble_body_is_awake(w, body));
    tumble_joint_set_motor(w, joint_now, 1, 100);
    go(1, 1 / 60.0);
    ck_assert(tumble_body_is_awake(w, body));
    near(place(), 1, 0.02);
    tumble_joint_set_motor(w, joint_now, 0, 100);
    go(5, 1 / 60.0);
    ck_assert(!tumble_body_is_awake(w, body));
    tumble_joint_set_spring(w, joint_now, 0, 10, 10);
    tumble_joint_set_motor(w, joint_now, 0, 0);
    go(1, 1 / 60.0);
    ck_assert(fabs(place() - 1) > 0.1);
}
END_TEST

START_TEST(clock_never_falls_asleep)
{
    // A millimetre a second is slower than what falls asleep.
    begin_sleepy();
    hang_cube(0.2, 0, 3);
    tumble_joint_set_motor(w, joint_now, 0.01, 100);
    go(60, 1 / 60.0);
    near_relative(place(), 0.6, 1e-3);
}
END_TEST

// A heavy body, a light hub that is welded to it, and a wheel on the hub: how far
// do hub and body turn against each other?
static double hub_of(double radius, int drive)
{
    begin_world(1 / 60.0, 0);
    tumble_vec3 at = { 1.2, -0.4, 0.9 }, axis = { 0, 0, 1 };
    tumble_body car = box_at(0, 0, 0, tumble_v(3, 0.5, 1.5), 800);
    tumble_body hub = tumble_body_add(w, tumble_shape_sphere(w, radius, 10),
                                      tumble_body_at(at.x, at.y, at.z));
    tumble_body_options o = tumble_body_at(at.x, at.y, at.z);
    if (drive == 2) o.spin = tumble_v(0, 0, 20);
    body = tumble_body_add(w, tumble_shape_sphere(w, 0.35, 20), o);
    tumble_joint_fixed(w, car, hub, at);
    joint_now = drive == 2 ? tumble_joint_ball(w, hub, body, at)
                           : tumble_joint_hinge(w, hub, body, at, axis);
    if (drive == 0) tumble_joint_set_motor(w, joint_now, 100, 20);
    if (drive == 1) tumble_joint_set_servo(w, joint_now, 3, 200, 1, 20);
    if (drive == 2) tumble_joint_set_friction(w, joint_now, 20);
    double worst = 0;
    for (int k = 0; k < 30; k++) {
        if (drive == 0 && k == 15) tumble_joint_set_motor(w, joint_now, -100, 20);
        tumble_world_step(w);
        tumble_quat a = tumble_body_pose(w, car).rotation;
        tumble_quat b = tumble_body_pose(w, hub).rotation;
        worst = fmax(worst, fabs(a.x - b.x) + fabs(a.y - b.y) + fabs(a.z - b.z));
    }
    ck_assert_ptr_null(tumble_world_failure(w));
    return worst;
}

// What cannot do what it should gives its most, and no joint beside it more.
// Rejects: joints that keep what they bore while a motor was asked for its speed,
// whatever it took: a hub turned by a radian, and at last lost its numbers.
START_TEST(hub_stays_however_light_it_is)
{
    for (double radius = 0.1; radius > 0.01; radius /= 2)
        for (int drive = 0; drive < 3; drive++) {
            ck_assert_double_lt(hub_of(radius, drive), 1e-4);
            end_world();
        }
    hub_of(0.1, 0);
    near(tumble_joint_speed(w, joint_now), 0, 0.2);     // of 5 rad/s on the way
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        motor_spins_up_by_torque_over_inertia_until_its_speed,
        motor_holds_what_its_torque_bears_and_no_more,
        spring_of_a_hinge_swings_in_the_time_of_its_inertia,
        damper_brakes_by_its_exponential,
        strong_damper_stops_what_turns_and_throws_nothing_back,
        spring_of_a_hinge_takes_the_shorter_way_round,
        spring_of_any_stiffness_is_safe_at_any_step,
        servo_of_one_hertz_comes_as_a_damped_spring_does,
        servo_gives_its_most_and_arrives,
        slider_on_a_slope_falls_by_the_sine,
        slider_stops_at_its_limits_and_bears_the_weight_there,
        spring_sags_by_weight_over_stiffness,
        distance_with_a_spring_is_a_spring,
        motor_without_a_speed_is_friction,
        motor_pushes_at_a_limit_and_comes_away_from_it,
        arm_of_seven_motors_holds_itself_level,
        driven_bodies_in_flight_keep_their_momenta,
        cone_holds_what_leans_on_it,
        cone_stops_a_twist_at_each_of_its_ends,
        cone_in_flight_keeps_momenta_and_gains_no_energy,
        cone_is_refused_saved_and_taken_off,
        joint_says_where_it_is_and_how_fast_without_a_drive,
        door_that_closes_slowly_closes,
        a_motor_of_infinite_force_gives_what_it_takes,
        what_makes_no_drive_is_refused_with_a_sentence,
        saved_drives_go_on_with_the_same_bits,
        drive_goes_with_its_body_and_with_what_breaks,
        what_sleeps_wakes_when_its_drive_is_set,
        clock_never_falls_asleep,
        hub_stays_however_light_it_is,
        NULL
    };
    return suite_run((suite){ .name = "drives", .tests = tests,
                              .tear_down = end_world, .seconds = 120 });
}
