// check.c - tests of the exercise 07/belt.

#include "belt.h"
#include "expect.h"
#include "suite.h"

#include <check.h>

// Positions of some metres, after up to a few thousand roundings.
static const real ROUNDING = 1e-12;
// A speed is a difference of two positions, by dt: 1e-12 m in 1 ms.
static const real SPEED = 1e-9;

static const real dt = 1e-3;                    // s
static const real g = 10;                       // m/s^2

// A belt through the origin that rises at an angle with this sine and cosine,
// and runs uphill at u.
static belt rising(real sine, real cosine, real u, real friction)
{
    return (belt){ { 0, 0, 0 }, { -sine, cosine, 0 },
                   { u * cosine, u * sine, 0 }, friction };
}

static vec3 uphill(const belt *b)
{
    return (vec3){ b->normal.y, -b->normal.x, 0 };
}

// A parcel of 3 kg on the belt, moving uphill at v.
static particle parcel(const belt *b, real v)
{
    particle p = { { 0, 0, 0 }, { 0, 0, 0 }, 1.0 / 3 };
    p.previous = vec3_scale(-v * dt, uphill(b));
    return p;
}

static void run(const belt *b, particle *p, int steps)
{
    for (int k = 0; k < steps; k++) {
        verlet_step(p, 1, (vec3){ 0, -g, 0 }, NULL, dt);
        belt_push(b, p, dt);
    }
}

static real way(const belt *b, const particle *p)
{
    return vec3_dot(p->position, uphill(b));
}

static real speed(const belt *b, const particle *p)
{
    return vec3_dot(vec3_sub(p->position, p->previous), uphill(b)) / dt;
}

START_TEST(above_the_belt_nothing_happens)
{
    // Rejects: a belt that draws things up, or brakes what it does not touch.
    belt b = rising(0, 1, 2, 0.5);
    particle p = { { 1, 0.25, 0 }, { 0.5, 0.5, 0 }, 1 };
    real depth = belt_push(&b, &p, dt);
    near(depth, 0, 0, "overlap");
    near(vec3_distance(p.position, (vec3){ 1, 0.25, 0 }), 0, 0, "moved by");
}
END_TEST

START_TEST(parcel_lands_on_the_surface)
{
    // A belt that stands somewhere else, and slopes.  Rejects: an overlap that
    // is measured from the world's origin, a fall that counts as sliding, a
    // previous position that moves.
    belt b = rising(0.6, 0.8, 0, 0.25);
    b.point = (vec3){ 5, 7, 9 };
    particle p = { vec3_add_scaled(b.point, -0.5, b.normal),
                   vec3_add_scaled(b.point, 0.5, b.normal), 1 };
    vec3 before = p.previous;
    near(belt_push(&b, &p, dt), 0.5, ROUNDING, "overlap before");
    near(vec3_distance(p.position, b.point), 0, ROUNDING,
         "distance from where it fell straight down to");
    near(vec3_distance(p.previous, before), 0, 0, "previous moved by");
}
END_TEST

START_TEST(parcel_gains_speed_at_mu_g)
{
    // The belt runs at 2 m/s, mu = 1/2: after k steps the parcel has come
    // mu g dt^2 (1 + 2 + ... + k).
    // Rejects: friction against the ground, a belt that runs backwards, one
    // that takes every parcel along at once.
    belt b = rising(0, 1, 2, 0.5);
    particle p = parcel(&b, 0);
    for (int k = 1; k <= 390; k++) {
        run(&b, &p, 1);
        near(way(&b, &p), 5 * dt * dt * k * (k + 1) / 2, ROUNDING,
             "way of a parcel that still slides, m");
    }
}
END_TEST

START_TEST(parcel_rides_without_a_tremor)
{
    // Rejects: a parcel that friction throws beyond the speed of the belt.
    belt b = rising(0, 1, 2, 0.5);
    particle p = parcel(&b, 0);
    run(&b, &p, 405);
    for (int k = 0; k < 100; k++) {
        run(&b, &p, 1);
        near(speed(&b, &p), 2, SPEED, "speed of a parcel that rides, m/s");
    }
}
END_TEST

START_TEST(parcel_lags_by_u2_over_2_mu_g)
{
    // 2 m/s, mu g = 5 m/s^2: it slides for 0.4 s, in which the belt runs
    // 0.8 m and the parcel 0.4 m.  A step more or less is 1 % here.
    belt b = rising(0, 1, 2, 0.5);
    particle p = parcel(&b, 0);
    run(&b, &p, 1000);
    near(2.0 - way(&b, &p), 0.4, 0.004, "lag behind the belt, m");
}
END_TEST

START_TEST(parcel_that_is_too_fast_is_braked)
{
    // Rejects: friction that pushes on; friction that only knows one way.
    belt b = rising(0, 1, 1, 0.5);
    particle p = parcel(&b, 3);
    run(&b, &p, 100);
    near(speed(&b, &p), 2.5, SPEED, "speed after 0.1 s, m/s");
    run(&b, &p, 400);
    near(speed(&b, &p), 1, SPEED, "speed after 0.5 s, m/s");
}
END_TEST

START_TEST(steep_belt_carries_if_mu_exceeds_the_slope)
{
    // A slope of 3 in 4.  mu = 0.8 carries: the parcel gains speed at
    // g (mu cos - sin) = 0.4 m/s^2, and rides.
    belt b = rising(0.6, 0.8, 0.5, 0.8);
    particle p = parcel(&b, 0);
    run(&b, &p, 1000);
    near(speed(&b, &p), 0.4, SPEED, "speed after 1 s, m/s");
    run(&b, &p, 1000);
    near(speed(&b, &p), 0.5, SPEED, "speed after 2 s, m/s");
}
END_TEST

START_TEST(too_steep_a_belt_lets_it_slide_down)
{
    // mu = 0.7 is less than 3/4: however fast the belt runs, the parcel slides
    // down, at g (sin - mu cos) = 0.4 m/s^2.
    belt b = rising(0.6, 0.8, 50, 0.7);
    particle p = parcel(&b, 0);
    run(&b, &p, 1000);
    near(speed(&b, &p), -0.4, SPEED, "speed after 1 s, m/s");
}
END_TEST

START_TEST(belt_runs_across_too)
{
    // A parcel shot along x over a belt that runs along z.  Friction points
    // against the sliding, not against the motion.
    belt b = rising(0, 1, 0, 0.5);
    b.velocity = (vec3){ 0, 0, 4 };
    particle p = parcel(&b, 3);
    run(&b, &p, 1);
    vec3 v = vec3_scale(1 / dt, vec3_sub(p.position, p.previous));
    near(v.x, 3 - 0.005 * 0.6, SPEED, "speed along x, m/s");
    near(v.z, 0.005 * 0.8, SPEED, "speed along z, m/s");
}
END_TEST

START_TEST(belt_without_friction_carries_nothing)
{
    // Rejects: 0 / 0 where nothing slides and nothing brakes.
    belt b = rising(0, 1, 2, 0);
    particle p = parcel(&b, 0), q = parcel(&b, 2);
    run(&b, &p, 10);
    near(speed(&b, &p), 0, SPEED, "speed of one put down, m/s");
    b.velocity = (vec3){ 0, 0, 0 };
    q.previous = q.position;
    q.position.y = -1;
    belt_push(&b, &q, dt);
    near(q.position.x, 0, 0, "x of one that does not slide at all, m");
}
END_TEST

START_TEST(pinned_parcel_stays)
{
    belt b = rising(0, 1, 2, 0.5);
    particle p = { { 0, -0.25, 0 }, { 0, -0.25, 0 }, 0 };
    near(belt_push(&b, &p, dt), 0.25, 0, "overlap");
    near(vec3_distance(p.position, (vec3){ 0, -0.25, 0 }), 0, 0, "moved by");
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        above_the_belt_nothing_happens,
        parcel_lands_on_the_surface,
        parcel_gains_speed_at_mu_g,
        parcel_rides_without_a_tremor,
        parcel_lags_by_u2_over_2_mu_g,
        parcel_that_is_too_fast_is_braked,
        steep_belt_carries_if_mu_exceeds_the_slope,
        too_steep_a_belt_lets_it_slide_down,
        belt_runs_across_too,
        belt_without_friction_carries_nothing,
        pinned_parcel_stays,
        NULL
    };
    return suite_run((suite){ .name = "belt", .tests = tests });
}
