// check.c - tests of the exercise 01/eight.

#include "eight.h"
#include "expect.h"
#include "suite.h"

#include <check.h>

// Some dozen roundings of numbers near 1.
static const real ROUNDING = 1e-14;
// A thousand steps of a comet, each rounding places near 1.
static const real AREA_SLACK = 1e-12;
// What a method of order 2 may miss after one round of 2,000 steps: some
// (2 pi / 2000)^2 = 1e-5, more where bodies pass each other.
static const real ROUND_SLACK = 1e-3;

static const real PI = 3.14159265358979323846;

static particle at(real x, real y, real z)
{
    return (particle){ { x, y, z }, { x, y, z }, 1 };
}

START_TEST(two_bodies_attract_by_the_square_of_their_distance)
{
    // 2 kg and 5 kg, 5 m apart, G = 10: 4 N along (0.6, 0.8, 0).
    // Rejects: a push, a direction that is not of length 1, one mass only.
    particle p[2] = { at(1, 1, 1), at(4, 5, 1) };
    real mass[2] = { 2, 5 };
    vec3 force[2] = { { 0, 0, 0 } };
    attract(p, mass, 2, 10, force);
    near_vec3(force[0], (vec3){ 2.4, 3.2, 0 }, ROUNDING, "on the first",
                "G m m' / d^2 is 4 N, towards the other.");
    near_vec3(force[1], (vec3){ -2.4, -3.2, 0 }, ROUNDING, "on the second",
                "As much as on the first, the other way.");
}
END_TEST

START_TEST(forces_begin_at_nothing)
{
    // Rejects: sums on top of what the array held; a lone body left out.
    particle p[2] = { at(0, 0, 0), at(1, 0, 0) };
    real mass[2] = { 1, 1 };
    vec3 force[2] = { { 7, 8, 9 }, { 7, 8, 9 } };
    attract(p, mass, 2, 1, force);
    near_vec3(force[0], (vec3){ 1, 0, 0 }, ROUNDING, "on the first",
                "The array came with (7, 8, 9) in it.");
    force[0] = (vec3){ 7, 8, 9 };
    attract(p, mass, 1, 1, force);
    near_vec3(force[0], (vec3){ 0, 0, 0 }, 0, "on a body alone",
                "Nothing attracts it, itself least of all.");
}
END_TEST

START_TEST(bodies_in_one_place_do_not_attract)
{
    // Rejects: 0 / 0; and also to forget the third for it.
    particle p[3] = { at(1, 2, 3), at(1, 2, 3), at(1, 2, 5) };
    real mass[3] = { 1, 1, 1 };
    vec3 force[3] = { { 0, 0, 0 } };
    attract(p, mass, 3, 4, force);
    near_vec3(force[0], (vec3){ 0, 0, 1 }, ROUNDING, "on the first", "");
    near_vec3(force[1], (vec3){ 0, 0, 1 }, ROUNDING, "on the second", "");
    near_vec3(force[2], (vec3){ 0, 0, -2 }, ROUNDING, "on the third", "");
}
END_TEST

START_TEST(action_is_reaction_among_many)
{
    // A ring of four and one in its middle, and one far away.  Rejects: pairs
    // counted twice or left out, the last body forgotten, one past the end.
    particle p[6] = { at(1, 0, 0), at(0, 1, 0), at(-1, 0, 0), at(0, -1, 0),
                      at(0, 0, 0), at(0, 0, 100) };
    real mass[6] = { 1, 1, 1, 1, 8, 1000 };
    vec3 force[6] = { { 0, 0, 0 } }, sum = { 0, 0, 0 };
    attract(p, mass, 5, 1, force);
    near_vec3(force[4], (vec3){ 0, 0, 0 }, 10 * ROUNDING, "in the middle",
                "Four equal pulls, from four sides.");
    near(force[0].x, -8 - 0.25 - 1 / sqrt(2.0), 10 * ROUNDING, "on the ring",
         "The middle pulls with 8 N, the opposite with 1/4, two neighbours "
         "with 1/2 each along their lines.");
    attract(p, mass, 6, 1, force);
    for (int i = 0; i < 6; i++) sum = vec3_add(sum, force[i]);
    near_vec3(sum, (vec3){ 0, 0, 0 }, 10 * ROUNDING, "sum of all forces",
                "Nothing outside pulls.");
}
END_TEST

START_TEST(area_is_half_a_parallelogram)
{
    // Rejects: the whole of it, clockwise for counter-clockwise, a sun that is
    // always at the origin.
    particle p = { .previous = { 3, 1, 1 }, .position = { 1, 4, 1 } };
    near_vec3(area_swept(&p, (vec3){ 1, 1, 1 }), (vec3){ 0, 0, 3 }, ROUNDING,
                "triangle with sides of 2 m and 3 m", "");
    near_vec3(area_swept(&p, (vec3){ 5, 1, 1 }), (vec3){ 0, 0, -3 }, ROUNDING,
                "seen from the other side", "");
}
END_TEST

// One step, with the forces of the moment.
static void step(particle *p, const real *mass, int n, real dt)
{
    vec3 force[3] = { { 0, 0, 0 } };
    attract(p, mass, n, 1, force);
    verlet_step(p, n, (vec3){ 0, 0, 0 }, force, dt);
}

START_TEST(planet_sweeps_equal_areas)
{
    // A comet, and a sun that is pinned; only 50 steps a round, and the areas
    // are equal still.  Rejects: a force that is not along the line.
    vec3 x0 = { 2, 1, 1 }, v0 = { 0, 0.9, 0 }, sun = { 1, 1, 1 };
    real mass[2] = { 2, 1 }, dt = 0.125;
    particle p[2] = { particle_start(x0, v0, (vec3){ -1, 0, 0 }, 0.5, dt),
                      { sun, sun, 0 } };
    real first = area_swept(&p[0], sun).z;
    ck_assert_msg(first > 0.05, "the first area is %g m^2, wanted about "
                  "0.056: v dt / 2 at 1 m from the sun", first);
    for (int k = 0; k < 1000; k++) {
        step(p, mass, 2, dt);
        near_vec3(area_swept(&p[0], sun), (vec3){ 0, 0, first }, AREA_SLACK,
                    "area", "Only a pull along the line to the sun keeps it.");
    }
}
END_TEST

START_TEST(two_bodies_keep_the_third_law)
{
    // T^2 = 4 pi^2 d^3 / (G (m + m')): two stars of 3 kg and 1 kg, 2 m apart,
    // go round their centre of mass.  Rejects: 1 / d, one mass only.
    real mass[2] = { 3, 1 }, T = 2 * PI * sqrt(2.0 * 2 * 2 / 4);
    real dt = T / 2000, omega = 2 * PI / T;
    vec3 a = { -0.5, 0, 0 }, b = { 1.5, 0, 0 };
    real square = omega * omega;
    particle p[2] = {
        particle_start(a, (vec3){ 0, omega * a.x, 0 },
                       vec3_scale(-square, a), 1.0 / 3, dt),
        particle_start(b, (vec3){ 0, omega * b.x, 0 },
                       vec3_scale(-square, b), 1, dt)
    };
    for (int k = 0; k < 1000; k++) step(p, mass, 2, dt);
    near_vec3(p[1].position, (vec3){ -1.5, 0, 0 }, ROUND_SLACK,
                "after half a period", "It should stand opposite its start.");
    for (int k = 0; k < 1000; k++) step(p, mass, 2, dt);
    near_vec3(p[1].position, b, ROUND_SLACK, "after a period",
                "It should be back.");
}
END_TEST

START_TEST(three_bodies_dance_on_a_figure_eight)
{
    // Moore 1993; Chenciner and Montgomery proved it in 2000.  The numbers are
    // Simo's.  Rejects: any wrong force; nothing else brings them home.
    const real T = 6.32591398;
    vec3 x = { 0.97000436, -0.24308753, 0 };
    vec3 v = { -0.93240737, -0.86473146, 0 }, half = vec3_scale(-0.5, v);
    vec3 x0[3] = { x, vec3_scale(-1, x), { 0, 0, 0 } };
    vec3 v0[3] = { half, half, v };
    real mass[3] = { 1, 1, 1 }, dt = T / 3000;
    particle p[3];
    vec3 force[3] = { { 0, 0, 0 } };
    for (int i = 0; i < 3; i++) p[i] = (particle){ x0[i], x0[i], 1 };
    attract(p, mass, 3, 1, force);
    for (int i = 0; i < 3; i++)
        p[i] = particle_start(x0[i], v0[i], force[i], 1, dt);
    for (int k = 0; k < 1000; k++) step(p, mass, 3, dt);
    near_vec3(p[2].position, x0[1], ROUND_SLACK, "after a third of a period",
                "The one from the middle should stand where the second began.");
    for (int k = 0; k < 2000; k++) step(p, mass, 3, dt);
    for (int i = 0; i < 3; i++)
        near_vec3(p[i].position, x0[i], ROUND_SLACK, "after a period",
                    "Each should be back where it began.");
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        two_bodies_attract_by_the_square_of_their_distance,
        forces_begin_at_nothing,
        bodies_in_one_place_do_not_attract,
        action_is_reaction_among_many,
        area_is_half_a_parallelogram,
        planet_sweeps_equal_areas,
        two_bodies_keep_the_third_law,
        three_bodies_dance_on_a_figure_eight,
        NULL
    };
    return suite_run((suite){ .name = "eight", .tests = tests });
}
