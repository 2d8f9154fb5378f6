// check_blows.c - what is heavy falls on what is light, and stays. Book: chapter 15.

#include "suite.h"
#include "tumble.h"

#include <check.h>
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

int main(void)
{
    const TTest *const tests[] = { heavy_ball_stays_on_a_light_cube, NULL };
    return suite_run((suite){ .name = "blows", .tests = tests, .seconds = 60 });
}
