// check.c - tests of the exercise 02/pulley.

#include "pulley.h"
#include "expect.h"
#include "suite.h"

#include <check.h>

// Some dozen roundings of numbers up to 10.
static const real ROUNDING = 1e-13;
// A parabola of n steps rounds as n^2 / 2 roundings: 1,000 steps at 100 m.
static const real PATH_SLACK = 1e-8;

static const vec3 DOWN = { 0, -9.8125, 0 };

static particle at(real x, real y, real z, real inverse_mass)
{
    return (particle){ { x, y, z }, { x, y, z }, inverse_mass };
}

// Two wheels at the height 0, 2 m apart.
static pulley rope(real ratio, real length)
{
    return (pulley){ 0, 1, { -1, 0, 0 }, { 1, 0, 0 }, ratio, length };
}

static real too_long(pulley r, const particle *p)
{
    return vec3_distance(p[r.a].position, r.wheel_a)
         + r.ratio * vec3_distance(p[r.b].position, r.wheel_b) - r.length;
}

START_TEST(rope_too_long_gets_its_length_again)
{
    // Three and four metres where six are; b weighs a third.
    // Rejects: a move the wrong way, half the error, directions that are not
    // of length 1, equal moves, moves by mass.
    particle p[2] = { at(-1, -3, 0, 1), at(1, -4, 0, 3) };
    stick_result r = pulley_relax(rope(1, 6), p);
    near(r.error, 1, ROUNDING, "error", "3 m + 4 m - 6 m, before the move.");
    ck_assert_msg(r.moved == 1, "moved: got %d, wanted 1", r.moved);
    near(p[0].position.y, -2.75, ROUNDING, "height of a",
         "It weighs three times as much as b: a quarter of the error is its.");
    near(p[1].position.y, -3.25, ROUNDING, "height of b",
         "Three quarters of the error are its, upwards, to its wheel.");
}
END_TEST

START_TEST(tackle_counts_its_parts_squared)
{
    // 3 m + 2 * 4 m where 10 are.  Rejects: a bottom with ratio for ratio^2,
    // which goes too far; a tackle on the wrong end; parts that only weigh in
    // the length.
    particle p[2] = { at(-1, -3, 0, 1), at(1, -4, 0, 2) };
    pulley r = rope(2, 10);
    near(pulley_relax(r, p).error, 1, ROUNDING, "error", "3 + 2 * 4 - 10.");
    near(too_long(r, p), 0, ROUNDING, "metres too long, after",
         "b moves by ratio for each move of a, and each metre of b counts ratio "
         "times again.");
    near(p[0].position.y, -3 + 1.0 / 9, ROUNDING, "height of a",
         "Its fraction is w_a / (w_a + ratio^2 w_b), 1 of 9.");
    near(p[1].position.y, -4 + 4.0 / 9, ROUNDING, "height of b",
         "Two parts of rope lift it, with 4 / 9 m in all.");
}
END_TEST

START_TEST(slanting_rope_pulls_along_itself)
{
    // Rejects: a pull straight upwards.
    particle p[2] = { at(2, 4, 0, 1), at(1, -5, 0, 0) };
    pulley_relax(rope(1, 9), p);
    near(p[0].position.x, 1.4, ROUNDING, "x of a",
         "5 m along (0.6, 0.8) become 4 m.");
    near(p[0].position.y, 3.2, ROUNDING, "y of a",
         "5 m along (0.6, 0.8) become 4 m.");
    near(p[1].position.y, -5, 0, "pinned end", "Inverse mass 0 never moves.");
}
END_TEST

START_TEST(slack_rope_does_not_push)
{
    // Rejects: a rope that holds its ends apart; an error of one that is
    // satisfied.
    particle p[2] = { at(-1, -1, 0, 1), at(1, -2, 0, 1) };
    stick_result r = pulley_relax(rope(1, 5), p);
    ck_assert_msg(r.moved == 0 && r.error == 0, "moved %d, error %g, wanted 0 "
                  "and 0: the rope is 2 m too long for its ends, not they too "
                  "far for it", r.moved, r.error);
    near(p[0].position.y, -1, 0, "height of a", "Nothing pulls.");
}
END_TEST

START_TEST(end_at_its_wheel_leaves_it_to_the_other)
{
    // Rejects: 0 / 0; a move for one that has nowhere to go.
    particle p[2] = { at(-1, 0, 0, 1), at(1, -4, 0, 1) };
    stick_result r = pulley_relax(rope(1, 3), p);
    ck_assert_msg(vec3_is_finite(p[0].position), "a is nan: its direction "
                  "is 0 / 0");
    near(p[0].position.y, 0, 0, "height of a, at its wheel", "");
    near(p[1].position.y, -3, ROUNDING, "height of b", "All of the error.");
    ck_assert_int_eq(r.moved, 1);
}
END_TEST

START_TEST(both_pinned_reports_and_stays)
{
    // Rejects: a division by no weight.
    particle p[2] = { at(-1, -3, 0, 0), at(1, -4, 0, 0) };
    stick_result r = pulley_relax(rope(1, 5), p);
    ck_assert_msg(r.moved == 0, "moved: got %d, wanted 0", r.moved);
    near(r.error, 2, ROUNDING, "error", "It is too long all the same.");
    near(p[0].position.y, -3, 0, "height of a", "");
}
END_TEST

START_TEST(not_a_number_is_reported)
{
    // Rejects: a comparison that lets it pass as slack.
    particle p[2] = { at(-1, (real)NAN, 0, 1), at(1, -4, 0, 1) };
    stick_result r = pulley_relax(rope(1, 5), p);
    ck_assert_msg(r.moved == 0 && r.error == HUGE_VAL,
                  "moved %d, error %g, wanted 0 and infinity", r.moved,
                  r.error);
    near(p[1].position.y, -4, 0, "height of b", "It stays clean.");
}
END_TEST

START_TEST(atwoods_machine_falls_slowly)
{
    // 5 kg against 3 kg: a quarter of g, and exactly, for the ropes hang
    // straight.  Rejects: any other fractions; a rope that brakes.
    const real g = 9.8125, quarter = g / 4, dt = 1.0 / 256;
    particle p[2] = {
        particle_start((vec3){ -1, -200, 0 }, (vec3){ 0, 0, 0 },
                       (vec3){ 0, quarter, 0 }, 1.0 / 3, dt),
        particle_start((vec3){ 1, -50, 0 }, (vec3){ 0, 0, 0 },
                       (vec3){ 0, -quarter, 0 }, 1.0 / 5, dt)
    };
    for (int k = 0; k < 1024; k++) {
        verlet_step(p, 2, DOWN, NULL, dt);
        pulley_relax(rope(1, 250), p);
    }
    near(p[1].position.y, -50 - quarter * 16 / 2, PATH_SLACK,
         "height of 5 kg after 4 s", "It falls with g (5 - 3) / (5 + 3).");
    near(p[0].position.y, -200 + quarter * 16 / 2, PATH_SLACK,
         "height of 3 kg after 4 s", "It rises as fast.");
}
END_TEST

START_TEST(one_holds_two_by_a_tackle)
{
    // 1 kg against 2 kg on two parts.  Rejects: a ratio at the wrong end.
    particle p[2] = { at(-1, -3, 0, 1), at(1, -4, 0, 0.5) };
    for (int k = 0; k < 1000; k++) {
        verlet_step(p, 2, DOWN, NULL, 1.0 / 64);
        pulley_relax(rope(2, 11), p);
    }
    near(p[0].position.y, -3, PATH_SLACK, "height of 1 kg after 1,000 steps",
         "Its weight, times two parts, holds the other.");
    near(p[1].position.y, -4, PATH_SLACK, "height of 2 kg after 1,000 steps",
         "Two parts of rope hold it, each with the weight of 1 kg.");
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        rope_too_long_gets_its_length_again,
        tackle_counts_its_parts_squared,
        slanting_rope_pulls_along_itself,
        slack_rope_does_not_push,
        end_at_its_wheel_leaves_it_to_the_other,
        both_pinned_reports_and_stays,
        not_a_number_is_reported,
        atwoods_machine_falls_slowly,
        one_holds_two_by_a_tackle,
        NULL
    };
    return suite_run((suite){ .name = "pulley", .tests = tests });
}
