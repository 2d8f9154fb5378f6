// check.c - tests of the exercise 01/bounce.

#include "bounce.h"
#include "suite.h"

#include <check.h>

// Some dozen roundings of numbers up to 10.
static const real ROUNDING = 1e-13;
// A thousand short steps, each of which rounds speed and height.
static const real STEPS_SLACK = 1e-10;
// A day of bounces is 1e8 flights: the time of one, rounded, times 1e8.
static const real DAY_SLACK = 1e-5;

static const real G = 10;

static void expect(const char *what, ball got, real height, real speed,
                   real slack, const char *reason)
{
    ck_assert_msg(fabs(got.height - height) <= slack
                  && fabs(got.speed - speed) <= slack,
                  "%s: got height %.12g m and speed %.12g m/s, wanted %.12g "
                  "and %.12g.  %s", what, got.height, got.speed, height, speed,
                  reason);
}

// 1.25 m above the floor: it lands after 0.5 s, with 5 m/s.
static const ball DROPPED = { 1.25, 0 };

START_TEST(in_the_air_it_flies_a_parabola)
{
    // Rejects: the wrong sign of g, the half of g t^2 forgotten.
    expect("dropped", ball_step(DROPPED, G, 0.5, 0.25), 0.9375, -2.5, ROUNDING,
           "Nothing touches it yet.");
    expect("thrown up from the floor", ball_step((ball){ 0, 5 }, G, 0.5, 0.5),
           1.25, 0, ROUNDING, "It leaves the floor; that is no bounce.");
    expect("no time", ball_step(DROPPED, G, 0.5, 0), 1.25, 0, 0, "");
}
END_TEST

START_TEST(bounce_happens_at_its_moment)
{
    // Up with 2.5 m/s at 0.5 s, at its top at 0.75 s.  Rejects: a ball that is
    // lifted onto the floor at the end of the step; e on the height.
    expect("at the top of the first bounce", ball_step(DROPPED, G, 0.5, 0.75),
           0.3125, 0, ROUNDING,
           "It lands at 0.5 s and has 0.25 s left, upwards with e 5 m/s.");
}
END_TEST

START_TEST(second_bounce_is_in_the_same_step)
{
    // It lands again at 1 s, goes up with 1.25 m/s, is at its top at 1.125 s.
    // Rejects: one bounce a step, and the ball under the floor.
    expect("at the top of the second", ball_step(DROPPED, G, 0.5, 1.125),
           0.078125, 0, ROUNDING, "A quarter of 0.3125 m: e^2.");
    ball b = ball_step(DROPPED, G, 0.5, 1.06);
    ck_assert_msg(b.height > 0, "the ball is at %g m, under the floor",
                  b.height);
}
END_TEST

START_TEST(long_step_is_as_good_as_short_ones)
{
    // Rejects: whatever is lost or gained at the end of a step.
    ball b = { 3, 2 };
    for (int k = 0; k < 1000; k++) b = ball_step(b, G, 0.75, 1.0 / 256);
    ball once = ball_step((ball){ 3, 2 }, G, 0.75, 1000.0 / 256);
    expect("1,000 steps", b, once.height, once.speed, STEPS_SLACK,
           "That is what one step of the same time gave.");
}
END_TEST

START_TEST(infinitely_many_bounces_end)
{
    // 0.5 s of fall, 0.5 s for the first bounce, and as much for all others.
    // Rejects: a loop without end, a rest that comes too soon or too late.
    expect("after all of them", ball_step(DROPPED, G, 0.5, 2), 0, 0, 0,
           "All bounces together take 0.5 / (1 - 0.5) seconds.");
    expect("a year later", ball_step(DROPPED, G, 0.5, 3e7), 0, 0, 0, "");
    ball b = ball_step(DROPPED, G, 0.5, 1.4999);
    ck_assert_msg(b.height > 0 && b.height < 1e-6, "a ten-thousandth of a "
                  "second before: got height %g m, wanted more than 0, and "
                  "less than 1e-6", b.height);
    expect("nearly no loss", ball_step(DROPPED, G, 0.9999, 1e5), 0, 0, 0,
           "It takes 10,000 s: 0.5 + 0.9999 / (1 - 0.9999).");
}
END_TEST

START_TEST(without_loss_it_never_ends)
{
    // A flight takes 1 s.  Rejects: 1 / (1 - e) for e = 1; energy that is lost
    // or found.
    expect("after 7 s", ball_step(DROPPED, G, 1, 7), 1.25, 0, ROUNDING,
           "As high as at the start, once a second.");
    expect("after 7.25 s", ball_step(DROPPED, G, 1, 7.25), 0.9375, -2.5,
           ROUNDING, "On its way down for the eighth time.");
}
END_TEST

START_TEST(day_of_bounces_takes_no_time)
{
    // 5e-7 m: a flight takes 2 sqrt(2 h / g), 0.63 ms.  Rejects: a count of
    // each.
    ball tiny = { 5e-7, 0 };
    ball b = ball_step(tiny, G, 1, 86400);
    real energy = G * b.height + b.speed * b.speed / 2;
    ck_assert_msg(fabs(energy / (G * 5e-7) - 1) <= DAY_SLACK, "after a day its "
                  "energy is %g of what it was, wanted 1", energy / (G * 5e-7));
}
END_TEST

START_TEST(ball_without_bounce_stays_down)
{
    // Rejects: 0 / 0 for a ball that lies; a ball of clay that bounces.
    expect("clay", ball_step(DROPPED, G, 0, 0.75), 0, 0, 0, "e is 0.");
    expect("on the floor", ball_step((ball){ 0, 0 }, G, 0.5, 1), 0, 0, 0, "");
    expect("on the floor, e = 1", ball_step((ball){ 0, 0 }, G, 1, 1), 0, 0, 0,
           "Its flights take no time: there is nothing to divide by.");
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        in_the_air_it_flies_a_parabola,
        bounce_happens_at_its_moment,
        second_bounce_is_in_the_same_step,
        long_step_is_as_good_as_short_ones,
        infinitely_many_bounces_end,
        without_loss_it_never_ends,
        day_of_bounces_takes_no_time,
        ball_without_bounce_stays_down,
        NULL
    };
    return suite_run((suite){ .name = "bounce", .tests = tests });
}
