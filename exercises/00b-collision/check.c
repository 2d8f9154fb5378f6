// check.c - tests of the exercise 00b/collision.

#include "collision.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>

// Some roundings of numbers below 100.
static const real ROUNDING = 1e-12;
enum { TRIALS = 1000 };

static real momentum(cart a, cart b)
{
    return a.velocity / a.inverse_mass + b.velocity / b.inverse_mass;
}

static real motion(cart c)
{
    return c.inverse_mass > 0 ? c.velocity * c.velocity / (2 * c.inverse_mass) : 0;
}

// Two carts of 0.1 to 10 kg; the first is the faster one.
static void any(unsigned long long *seed, cart *a, cart *b)
{
    b->velocity = random_between(seed, -5, 5);
    a->velocity = b->velocity + random_between(seed, 0.1, 5);
    a->inverse_mass = random_between(seed, 0.1, 10);
    b->inverse_mass = random_between(seed, 0.1, 10);
}

START_TEST(coupled_carts_roll_on_as_in_the_chapter)
{
    // 2 kg with 3 m/s, 1 kg at rest.  Rejects: the mean of the velocities (1.5),
    // masses exchanged (1), energy kept for momentum (2.45).
    cart a = { 3, 0.5 }, b = { 0, 1 };
    near(common_velocity(a, b), 2, ROUNDING, "m/s, of both",
         "6 kg m/s are left, and 3 kg carry them.");
    collision r = collide(&a, &b, 0);
    near(a.velocity, 2, ROUNDING, "m/s, of a with e = 0", "They couple: both have the common velocity.");
    near(b.velocity, 2, ROUNDING, "m/s, of b with e = 0", "They couple: both have the common velocity.");
    near(r.impulse, 2, ROUNDING, "N s", "b had no momentum, and has 2 kg m/s.");
    near(r.lost, 3, ROUNDING, "J lost", "9 J before, 6 J after.");
}
END_TEST

START_TEST(equal_carts_exchange_their_velocities)
{
    // Rejects: an impulse without the factor 1 + e, half of it.
    cart a = { 4, 2 }, b = { -1, 2 };
    collision r = collide(&a, &b, 1);
    near(a.velocity, -1, ROUNDING, "m/s, of a, which had 4", "With e = 1 and equal masses they exchange.");
    near(b.velocity, 4, ROUNDING, "m/s, of b, which had -1", "With e = 1 and equal masses they exchange.");
    near(r.lost, 0, ROUNDING, "J lost", "A perfect spring loses nothing.");
}
END_TEST

START_TEST(momentum_is_kept_by_any_carts)
{
    // Rejects: the same change of velocity for both, an impulse that is not equal
    // and opposite.
    unsigned long long seed = 1;
    for (int k = 0; k < TRIALS; k++) {
        cart a, b;
        any(&seed, &a, &b);
        real before = momentum(a, b);
        collide(&a, &b, random_fraction(&seed));
        near(momentum(a, b), before, 100 * ROUNDING, "kg m/s after the collision",
             "What b gains, a must lose: the same impulse, the other sign.");
    }
}
END_TEST

START_TEST(they_part_as_fast_as_e_says)
{
    // Rejects: e on the velocity of each cart, e of the impulse.
    unsigned long long seed = 2;
    for (int k = 0; k < TRIALS; k++) {
        cart a, b;
        any(&seed, &a, &b);
        real e = random_fraction(&seed), met = a.velocity - b.velocity;
        collide(&a, &b, e);
        near(b.velocity - a.velocity, e * met, ROUNDING, "m/s, with which they part",
             "It is e times the speed with which they met.");
    }
}
END_TEST

START_TEST(lost_energy_is_the_difference)
{
    // Rejects: (1 - e)^2 or 1 - e for 1 - e^2, a half that is missing, the wrong
    // masses.
    unsigned long long seed = 3;
    for (int k = 0; k < TRIALS; k++) {
        cart a, b;
        any(&seed, &a, &b);
        real before = motion(a) + motion(b);
        collision r = collide(&a, &b, random_fraction(&seed));
        near(r.lost, before - motion(a) - motion(b), 1000 * ROUNDING, "J lost",
             "Add up m v^2 / 2 of both, before and after.");
        ck_assert_msg(r.lost >= 0, "%g J lost: a collision made energy", r.lost);
    }
}
END_TEST

START_TEST(ball_bounces_off_a_wall)
{
    // Rejects: a mass that is 1 / 0.
    cart ball = { 5, 4 }, wall = { 0, 0 };
    near(common_velocity(ball, wall), 0, ROUNDING, "m/s, of a ball that sticks to a wall",
         "Infinity times 0 is NaN: work with the inverse masses.");
    collision r = collide(&ball, &wall, 0.5);
    near(ball.velocity, -2.5, ROUNDING, "m/s, of the ball that came with 5", "Half of its speed comes back.");
    near(wall.velocity, 0, 0, "m/s, of the wall", "A wall stays.");
    near(r.impulse, 7.5 / 4, ROUNDING, "N s on the wall", "0.25 kg changed by 7.5 m/s.");
    near(r.lost, (25 - 6.25) / 8, ROUNDING, "J lost", "Of the ball alone.");
}
END_TEST

START_TEST(moving_wall_drives_what_it_meets)
{
    // Rejects: a wall that is always taken to stand.
    cart wall = { 2, 0 }, ball = { 0, 1 };
    near(common_velocity(wall, ball), 2, ROUNDING, "m/s, of a ball that sticks to a wall of 2 m/s",
         "The wall goes on as before, and the ball with it.");
    collide(&wall, &ball, 1);
    near(ball.velocity, 4, ROUNDING, "m/s, of the ball", "It leaves the wall as fast as the wall came.");
}
END_TEST

START_TEST(carts_that_part_do_not_collide)
{
    // Rejects: an impulse that pulls.
    cart a = { 1, 1 }, b = { 2, 0.5 };
    collision r = collide(&a, &b, 0.5);
    ck_assert_msg(a.velocity == 1 && b.velocity == 2 && r.impulse == 0 && r.lost == 0,
                  "b is the faster one, so they do not meet; yet they have %g and %g m/s, and the impulse is %g",
                  a.velocity, b.velocity, r.impulse);
}
END_TEST

START_TEST(two_walls_do_nothing)
{
    // Rejects: 0 / 0.
    cart a = { 1, 0 }, b = { 0, 0 };
    collision r = collide(&a, &b, 1);
    near(common_velocity(a, b), 0, 0, "m/s, of two walls", "The header says what is wanted there.");
    near(r.impulse, 0, 0, "N s between two walls", "0 / 0 is NaN.");
    near(a.velocity, 1, 0, "m/s, of the first wall", "Nothing changes a wall.");
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        coupled_carts_roll_on_as_in_the_chapter,
        equal_carts_exchange_their_velocities,
        momentum_is_kept_by_any_carts,
        they_part_as_fast_as_e_says,
        lost_energy_is_the_difference,
        ball_bounces_off_a_wall,
        moving_wall_drives_what_it_meets,
        carts_that_part_do_not_collide,
        two_walls_do_nothing,
        NULL
    };
    return suite_run((suite){ .name = "collision", .tests = tests });
}
