// check_blows.c - what falls on others stays there. Book: chapter 15.

#include "suite.h"
#include "tumble.h"

#include <check.h>
#include <stdbool.h>

// How fast a ball of this mass comes up again that falls at this speed on so many
// cubes of a kilogram, which stand on the ground.
static double rebound(double mass, double speed, int cubes)
{
    tumble_world *w = tumble_world_make(NULL);
    tumble_plane_add(w, tumble_v(0, 1, 0), 0, -1);
    tumble_shape cube = tumble_shape_box(w, tumble_v(0.5, 0.5, 0.5), 1);
    for (int k = 0; k < cubes; k++)
        tumble_body_add(w, cube, tumble_body_at(0, 0.25 + 0.5 * k, 0));
    for (int k = 0; k < 20; k++) tumble_world_step(w);
    tumble_body_options o = tumble_body_at(0, 0.5 * cubes + 0.273, 0);
    o.velocity = tumble_v(0, -speed, 0);
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
        double up = rebound(mass[k], 3, 1);
        ck_assert_msg(up < few, "%g kg: up again at %g m/s", mass[k], up);
    }
}
END_TEST

// With as much mass as they have, too.  Rejects: a blow only where the masses of two
// that touch differ: half of 1 m/s.
START_TEST(ball_stays_on_a_pile_of_cubes)
{
    const double speed[] = { 0.5, 1, 3 };
    for (int k = 0; k < 3; k++)
        for (int cubes = 1; cubes <= 4; cubes++)
            for (double mass = 1; mass < 200; mass *= 10) {
                double up = rebound(mass, speed[k], cubes);
                ck_assert_msg(up < 0.2 * speed[k], "%g kg at %g m/s on %d: %g",
                              mass, speed[k], cubes, up);
            }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = { heavy_ball_stays_on_a_light_cube,
                                    ball_stays_on_a_pile_of_cubes, NULL };
    return suite_run((suite){ .name = "blows", .tests = tests, .seconds = 60 });
}
