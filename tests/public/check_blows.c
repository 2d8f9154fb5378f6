// check_blows.c - what is heavy falls on what is light, and stays. Book: chapter 15.

#include "suite.h"
#include "tumble.h"

#include <check.h>
#include <math.h>
#include <stdbool.h>

// How fast a ball of this mass comes up again that falls at 3 m/s on a cube of a
// kilogram, which lies on the ground.
static double rebound(double mass)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_shape cube = tumble_shape_box(w, tumble_v(0.5, 0.5, 0.5), 1);
    tumble_body_add(w, cube, tumble_body_at(0, 0.25, 0));
    for (int k = 0; k < 20; k++) tumble_world_step(w);
    tumble_body_options o = tumble_body_at(0, 0.773, 0);
    o.velocity = tumble_v(0, -3, 0);
    tumble_body ball = tumble_body_add(w, tumble_shape_sphere(w, 0.25, mass), o);
    double most = 0;
    for (int k = 0; k < 30; k++) {
        tumble_world_step(w);
        double up = tumble_body_velocity(w, ball).y;
        most = up > most ? up : most;
    }
    ck_assert_msg(!tumble_world_failure(w), "%s", tumble_world_failure(w));
    tumble_world_free(w);
    return most;
}

// A tenth of 3 m/s.  Rejects: a solver that takes the blow through the light body
// a little in each substep, and gives it back: 0.8 m/s at 10 kg.
START_TEST(heavy_ball_stays_on_a_light_cube)
{
    const double mass[] = { 10, 30, 100 }, few = 0.3;
    for (int k = 0; k < 3; k++) {
        double up = rebound(mass[k]);
        ck_assert_msg(up < few, "%g kg: up again at %g m/s", mass[k], up);
    }
}
END_TEST

// 0 to 1, from a whole number: some throw like any other.
static double some(unsigned *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (*state >> 8) * 0x1p-24;
}

static tumble_vec3 some_vec3(unsigned *state, double size)
{
    double x = some(state), y = some(state), z = some(state);
    return tumble_v(size * (2 * x - 1), size * (2 * y - 1), size * (2 * z - 1));
}

// A box that tumbles is thrown on a rough floor.  Returns how much its energy rises
// above its least, as a share of the kinetic one at first.
static double energy_gained(unsigned state, double restitution)
{
    tumble_options o = tumble_options_default();
    o.friction = 0.1 + 1.4 * some(&state);
    o.restitution = restitution;
    tumble_world *w = tumble_world_make(&o);
    tumble_plane_add(w, tumble_v(0, 1, 0), -2, -1);
    tumble_vec3 size = some_vec3(&state, 0.8);
    tumble_shape box = tumble_shape_box(
        w, tumble_v(1 + size.x, 1 + size.y, 1 + size.z), 1);
    tumble_body_options b = tumble_body_at(0, 0, 0);
    b.pose.rotation = tumble_quat_turn(some_vec3(&state, 1), 6 * some(&state));
    b.velocity = some_vec3(&state, 3);
    b.velocity.y -= 5;
    b.spin = some_vec3(&state, 5);
    tumble_body_add(w, box, b);
    tumble_measures m = tumble_world_measure(w);
    double all = m.kinetic, least = HUGE_VAL, gained = 0;
    for (int k = 0; k < 90; k++) {
        m = tumble_world_measure(w);
        least = fmin(least, m.kinetic + m.potential);
        gained = fmax(gained, m.kinetic + m.potential - least);
        tumble_world_step(w);
    }
    ck_assert_msg(!tumble_world_failure(w), "%s", tumble_world_failure(w));
    tumble_world_free(w);
    return gained / all;
}

// Of many throws none gains more than `most`, nor all of them more than `mean`.
static void thrown_boxes_gain(double restitution, double most, double mean)
{
    const unsigned throws = 400;
    double sum = 0;
    for (unsigned n = 0; n < throws; n++) {
        double gained = energy_gained(1000 * n + 1, restitution);
        sum += gained;
        ck_assert_msg(gained < most, "gains %g", gained);
    }
    ck_assert_msg(sum / throws < mean, "gains %g in the mean", sum / throws);
}

// Rejects: a corner that lies on the floor and keeps others from striking, so that
// they come through it and are pushed out: up to .0053, and .00037 in the mean.
START_TEST(a_thrown_box_that_bounces_gains_no_energy)
{
    thrown_boxes_gain(0.3, 0.003, 1e-4);
}
END_TEST

// Rejects: friction of what struck that acts again in the next substep, when nothing
// presses: it turns the box into the floor, which pushes back.  Up to .23, and .0085
// in the mean.
START_TEST(a_thrown_box_that_does_not_bounce_gains_no_energy)
{
    thrown_boxes_gain(0, 0.05, 4e-4);
}
END_TEST

// Four boxes fall on each other from half a millimetre.  Where are they after a
// second, from `far` (m)?
static void land_at(double far, tumble_vec3 at[4])
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_shape box = tumble_shape_box(w, tumble_v(0.5, 0.5, 0.5), 100);
    tumble_body b[4];
    for (int k = 0; k < 4; k++)
        b[k] = tumble_body_add(w, box,
                               tumble_body_at(far, 0.2505 + 0.5005 * k, 0));
    for (int n = 0; n < 60; n++) tumble_world_step(w);
    for (int k = 0; k < 4; k++) {
        at[k] = tumble_body_position(w, b[k]);
        at[k].x -= far;
    }
    tumble_world_free(w);
}

// Rejects: a gap that is open if it is more than zero: what has landed has one of
// zero, and rounding decides.  .1 mm.
START_TEST(boxes_land_alike_wherever_they_are)
{
    tumble_vec3 here[4], there[4];
    land_at(0, here);
    for (double far = 10.1; far < 2000; far *= 5) {
        land_at(far, there);
        for (int k = 0; k < 4; k++) {
            ck_assert_double_eq_tol(here[k].x, there[k].x, 1e-9);
            ck_assert_double_eq_tol(here[k].y, there[k].y, 1e-9);
            ck_assert_double_eq_tol(here[k].z, there[k].z, 1e-9);
        }
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = { heavy_ball_stays_on_a_light_cube,
                                   a_thrown_box_that_bounces_gains_no_energy,
                                   a_thrown_box_that_does_not_bounce_gains_no_energy,
                                   boxes_land_alike_wherever_they_are,
                                   NULL };
    return suite_run((suite){ .name = "blows", .tests = tests, .seconds = 60 });
}
