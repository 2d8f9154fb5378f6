// check.c - tests of the exercise 01/drag.

#include "drag.h"
#include "expect.h"
#include "suite.h"

#include <check.h>

// Some hundred roundings of numbers near 1.
static const real ROUNDING = 1e-13;
// A measured order misses the whole number by the next term of the series.
static const real ORDER_SLACK = 0.05;

// A place 6 km down is rounded to 1e-12 m, 60 times a second, and a fall that
// forgets 0.3 % of its move a step adds up the last 300 of these.
static const real SPEED_SLACK = 1e-7;

static const vec3 NOTHING = { 0, 0, 0 };
static const vec3 DOWN = { 0, -9.8125, 0 };

// Starts at the origin with a last move of this, and no other history.
static particle moving(vec3 last_move, real inverse_mass)
{
    return (particle){ NOTHING, vec3_scale(-1, last_move), inverse_mass };
}

static vec3 last_move(const particle *p)
{
    return vec3_sub(p->position, p->previous);
}

START_TEST(without_drag_it_is_verlet)
{
    // Rejects: half of g dt^2, a terminal velocity divided by no drag.
    particle p = particle_start((vec3){ 1, 2, 3 }, (vec3){ 4, 5, -6 }, DOWN, 2,
                                1.0 / 64), q = p;
    for (int k = 0; k < 64; k++) {
        drag_step(&p, 1, DOWN, 0, (vec3){ 7, 0, 0 }, 1.0 / 64);
        verlet_step(&q, 1, DOWN, NULL, 1.0 / 64);
    }
    near(vec3_distance(p.position, q.position), 0, 100 * ROUNDING,
         "metres beside Verlet's place after a second",
         "With drag 0 nothing of the air may be left, not even wind.");
}
END_TEST

START_TEST(each_step_slows_by_its_factor)
{
    // drag 8 kg/s, 4 kg, dt 1/4 s: k = 1/4, and (1 - k) / (1 + k) is 0.6.
    // Rejects: a brake that pushes on, the velocity of the last half step
    // (0.5), drag on the new velocity alone (2/3), a mass that is ignored.
    particle p = moving((vec3){ 1, -2, 3 }, 0.25);
    drag_step(&p, 1, NOTHING, 8, NOTHING, 0.25);
    near(p.position.x, 0.6, ROUNDING, "move along x after one of 1 m",
         "(1 - k) / (1 + k) of it is left, with k = drag / mass * dt / 2.");
    near(vec3_distance(last_move(&p), (vec3){ 0.6, -1.2, 1.8 }), 0, ROUNDING,
         "metres beside the move", "Drag acts on all three coordinates alike.");
}
END_TEST

START_TEST(fall_ends_at_the_speed_where_drag_is_weight)
{
    // m g = c v: 80 kg and 16 kg/s, 49 m/s.
    // Rejects: a mass that is ignored, in either direction.
    particle p[2] = { { NOTHING, NOTHING, 1.0 / 80 },
                      { NOTHING, NOTHING, 1.0 / 40 } };
    for (int k = 0; k < 60 * 120; k++)
        drag_step(p, 2, DOWN, 16, NOTHING, 1.0 / 60);
    near(-60 * last_move(&p[0]).y, 80 * 9.8125 / 16, SPEED_SLACK,
         "m/s, of 80 kg",
         "The speed no longer changes where drag * v = mass * g.");
    near(-60 * last_move(&p[1]).y, 40 * 9.8125 / 16, SPEED_SLACK,
         "m/s, of 40 kg",
         "Half the mass falls half as fast: divide the drag by the mass.");
}
END_TEST

START_TEST(feather_goes_with_the_wind)
{
    // Rejects: drag against the ground, wind of the wrong sign, half the wind.
    vec3 wind = { 3, 0.5, -1 };
    particle p = { NOTHING, NOTHING, 1000 };
    for (int k = 0; k < 6000; k++)
        drag_step(&p, 1, NOTHING, 0.01, wind, 1.0 / 60);
    near(vec3_distance(vec3_scale(60, last_move(&p)), wind), 0, 1e-9,
         "m/s beside the wind",
         "Drag acts against v - wind, so it ends where v is the wind.");
}
END_TEST

START_TEST(no_drag_is_too_large)
{
    // k from 1 to 10^9.  Rejects: the velocity of the last half step, which
    // makes the factor 1 - 2 k; one that goes to NaN.
    for (real drag = 2; drag < 1e10; drag *= 10) {
        particle p = moving((vec3){ 1, 0, 0 }, 1);
        for (int k = 0; k < 100; k++) {
            drag_step(&p, 1, NOTHING, drag, NOTHING, 1);
            real move = vec3_length(last_move(&p));
            ck_assert_msg(move <= 1 + ROUNDING, "drag %g: after %d steps a "
                          "move of %g m, it began with 1.  A brake that takes "
                          "the old velocity for the whole step pushes back "
                          "more than there is.", drag, k + 1, move);
        }
    }
}
END_TEST

// Thrown upwards at 10 m/s, 1 kg, 2 kg/s: v = -g/2 + (10 + g/2) e^(-2 t).
static real error_at_1(int steps)
{
    real dt = 1.0 / steps, g = 9.8125;
    particle p = particle_start(NOTHING, (vec3){ 0, 10, 0 },
                                (vec3){ 0, -g - 20, 0 }, 1, dt);
    for (int k = 0; k < steps; k++) drag_step(&p, 1, DOWN, 2, NOTHING, dt);
    real truth = -g / 2 + (10 + g / 2) * (1 - exp(-2.0)) / 2;
    return fabs(p.position.y - truth);
}

START_TEST(it_is_of_order_2)
{
    // Rejects: a velocity from either end of the step, which is half a step
    // off and makes the error fall by 2, not by 4.
    near(log2(error_at_1(200) / error_at_1(400)), 2, ORDER_SLACK, "order",
         "Order 1 means that v is not the one in the middle.");
}
END_TEST

START_TEST(every_particle_is_moved_and_no_other)
{
    // Rejects: one too few, one past the end.
    particle p[3] = { moving((vec3){ 1, 0, 0 }, 1),
                      moving((vec3){ 2, 0, 0 }, 1),
                      moving((vec3){ 4, 0, 0 }, 1) };
    drag_step(p, 2, NOTHING, 1, NOTHING, 0.5);
    near(p[0].position.x, 0.6, ROUNDING, "particle 0", "");
    near(p[1].position.x, 1.2, ROUNDING, "particle 1, the last of two", "");
    near(p[2].position.x, 0, 0, "particle 2, which is not of them", "");
}
END_TEST

START_TEST(pinned_particle_stays)
{
    // Rejects: wind or weight on a pinned particle, a speed that waits in previous.
    particle p = moving((vec3){ 1, 0, 0 }, 0);
    for (int k = 0; k < 3; k++)
        drag_step(&p, 1, DOWN, 5, (vec3){ 9, 0, 0 }, 0.1);
    ck_assert_msg(vec3_length(p.position) == 0, "the pinned particle is at "
                  "(%g, %g, %g), it was at the origin", p.position.x,
                  p.position.y, p.position.z);
    ck_assert_msg(vec3_length(last_move(&p)) == 0, "it stands, but previous "
                  "is not its place: set free, it would dart off");
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        without_drag_it_is_verlet,
        each_step_slows_by_its_factor,
        fall_ends_at_the_speed_where_drag_is_weight,
        feather_goes_with_the_wind,
        no_drag_is_too_large,
        it_is_of_order_2,
        every_particle_is_moved_and_no_other,
        pinned_particle_stays,
        NULL
    };
    return suite_run((suite){ .name = "drag", .tests = tests });
}
