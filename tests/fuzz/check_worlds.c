// check_worlds.c - random worlds (worlds.h), a few steps of each: does anything
// stop at an assertion, or lose its numbers?  Book: chapter 20.
//
// make fuzz goes on for longer, and watches the time.

#include <check.h>
#include <stdlib.h>

#include "worlds.h"
#include "suite.h"

enum { SEEDS = 40, MOMENTS = 20 };

static trial t;

static void tear_down(void)
{
    trial_free(&t);
}

// Options within their ranges, shapes and places are accepted; a body that was
// given numbers keeps them, whatever the others were given.
START_TEST(numbers_stay_numbers)
{
    trial_make(&t, (unsigned long long)_i);
    for (int k = 0; k < MOMENTS && t.fault == TRIAL_WELL; k++)
        trial_step(&t);
    ck_assert_msg(t.fault != TRIAL_REFUSED && t.fault != TRIAL_NOT_NUMBERS,
                  "seed %d, step %d: %s\n%s", _i, t.step, t.why, t.what);
}
END_TEST

// A seed is a trial, and no other.
START_TEST(same_seed_is_the_same_trial)
{
    static trial u;
    trial_make(&t, 3);
    trial_make(&u, 3);
    for (int k = 0; k < MOMENTS; k++) {
        trial_step(&t);
        trial_step(&u);
    }
    ck_assert_int_eq(t.world.bodies, u.world.bodies);
    for (int b = 0; b < t.world.bodies; b++)
        ck_assert(vec3_distance(t.middle[b], u.middle[b]) == 0);
    trial_free(&u);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        same_seed_is_the_same_trial,
        NULL
    };
    return suite_run((suite){
        .name = "worlds", .tests = tests, .tear_down = tear_down, .seconds = 60,
        .repeated = { { numbers_stay_numbers, 1, SEEDS + 1 } }
    });
}
