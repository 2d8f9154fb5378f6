// check.c - tests of the exercise 13c/column.

#include "column.h"
#include "expect.h"
#include "suite.h"

#include <check.h>

// Of the answer: columns settle by a factor a substep, for some thousands.
static const real SETTLED = 1e-6;
static const real ROUNDING = 1e-12;
static const real H = 1.0 / 480, G = 9.81;
enum { MOST = 10 };
static crate c[MOST];
static real push[MOST];

// An eighth of a turn in a substep, and strong damping.
static give usual(real h) { return column_spring(h, 2 * 3.14159265358979 / (8 * h), 10); }

// Boxes of 1 kg, the highest of `top`, just touching.
static void lay(int count, real top)
{
    for (int k = 0; k < count; k++) {
        c[k] = (crate){ .inverse_mass = k + 1 < count ? 1 : 1 / top };
        push[k] = 0;
    }
}

static void run(int count, real seconds, real h)
{
    for (int s = 0; s < seconds / h; s++) column_substep(c, push, count, usual(h), h, G);
}

// m, that a contact of the effective mass m sinks under the load F (N).
static real sag(real load, real mass, real h)
{
    real omega = 2 * 3.14159265358979 / (8 * h);
    return load / (mass * omega * omega);
}

START_TEST(spring_that_is_stiff_is_a_hard_contact)
{
    // Rejects: a1 and a2 exchanged, half of the damping, shares beyond 1.
    give g = column_spring(H, 1e12, 10);
    near_relative(g.rate, 1 / H, 1e-6, "rate without end", "A hard contact takes an overlap back in one substep.");
    near(g.mass, 1, 1e-6, "share of the mass");
    near(g.leak, 0, 1e-6, "leak");
    g = column_spring(0.01, 50, 0.25);
    near_relative(g.rate, 50, ROUNDING, "rate (1/s)", "a1 = 2 zeta + h omega = 1.");
    near_relative(g.mass, 1 / 3.0, ROUNDING, "share of the mass", "a2 = h omega a1 = 0.5.");
    near_relative(g.leak, 2 / 3.0, ROUNDING, "leak");
}
END_TEST

START_TEST(box_sinks_by_the_law_of_the_sag)
{
    // Rejects: a leak that is lost, the square of the wrong number.
    lay(1, 5);
    run(1, 20, H);
    near_relative(-c[0].y, sag(5 * G, 5, H), SETTLED, "m, that a box sinks", "F / (m omega^2), whatever it weighs.");
    near(c[0].velocity, 0, 1e-9, "m/s, of a box at rest");
    lay(1, 5);
    run(1, 20, H / 2);
    near_relative(-c[0].y, sag(5 * G, 5, H) / 4, SETTLED, "m, with half of the substep", "Half of it makes a quarter.");
}
END_TEST

START_TEST(heavy_on_light_sinks_by_the_law)
{
    // 20 kg on 1 kg: between them the effective mass is 20 / 21 kg.
    // Rejects: substeps that begin cold, the mass of one of the two.
    lay(2, 20);
    run(2, 60, H);
    near_relative(c[0].y - c[1].y, sag(20 * G, 20 / 21.0, H), SETTLED, "m, that the heavy one sinks into the light one");
    near_relative(-c[0].y, sag(21 * G, 1, H), SETTLED, "m, that the light one sinks into the floor");
}
END_TEST

START_TEST(contacts_carry_all_that_is_above)
{
    // Rejects: one box that is left out.
    lay(MOST, 3);
    run(MOST, 60, H);
    for (int k = 0; k < MOST; k++)
        near_relative(push[k], (MOST - 1 - k + 3) * G * H, SETTLED, "kg m/s, of a contact", "The weight of all above it, times h.");
}
END_TEST

START_TEST(box_comes_out_of_the_floor_and_does_not_hop)
{
    // Rejects: no second pass, an overlap that goes at any speed.
    lay(1, 1);
    c[0].y = -0.5;
    real highest = -1, fastest = 0;
    for (int s = 0; s < 960; s++) {
        real before = c[0].y;
        column_substep(c, push, 1, usual(H), H, G);
        highest = real_max(highest, c[0].y);
        fastest = real_max(fastest, (c[0].y - before) / H);
    }
    ck_assert_msg(highest <= 1e-9, "it hops %g m above the floor: the second pass takes back what the spring gave", highest);
    ck_assert_msg(fastest <= 3.0001 && fastest > 2.5, "it comes out at %g m/s; an overlap goes at 3 m/s at most", fastest);
}
END_TEST

START_TEST(falling_box_comes_to_the_floor_and_no_further)
{
    // 4 m/s, and 6 mm are left: it would be 2.3 mm deep.
    // Rejects: a contact that waits for an overlap, one that stops too early.
    lay(1, 1);
    c[0].y = 0.006;
    c[0].velocity = -4;
    column_substep(c, push, 1, usual(H), H, G);
    near(c[0].y, 0, ROUNDING, "height after the substep (m)", "The gap closes, and no further.");
    lay(1, 1);
    c[0].y = 0.1;
    column_substep(c, push, 1, usual(H), H, G);
    near(c[0].velocity, -G * H, ROUNDING, "m/s, of a box that is far above", "Nothing touches it.");
    near(push[0], 0, 0, "kg m/s, of its contact");
}
END_TEST

START_TEST(nothing_pulls_and_momentum_stays)
{
    // Two boxes in the air, one deep in the other, and no gravity.
    // Rejects: an impulse on one of the two, a contact that holds what parts.
    lay(2, 4);
    c[0].y = 1;
    c[1] = (crate){ .y = 0.9, .velocity = -1, .inverse_mass = 0.25 };
    for (int s = 0; s < 480; s++) {
        column_substep(c, push, 2, usual(H), H, 0);
        near(c[0].velocity + 4 * c[1].velocity, -4, 1e-11, "kg m/s of both");
        ck_assert_msg(push[0] >= 0 && push[1] >= 0, "a contact gives %g kg m/s: it pulls", real_min(push[0], push[1]));
        if (c[0].y < 0.2) break;
    }
    lay(2, 1);
    c[1].y = 0.001;
    c[1].velocity = 2;
    column_substep(c, push, 2, usual(H), H, 0);
    near(c[1].velocity, 2, 0, "m/s, of a box that leaves");
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        spring_that_is_stiff_is_a_hard_contact,
        box_sinks_by_the_law_of_the_sag,
        heavy_on_light_sinks_by_the_law,
        contacts_carry_all_that_is_above,
        box_comes_out_of_the_floor_and_does_not_hop,
        falling_box_comes_to_the_floor_and_no_further,
        nothing_pulls_and_momentum_stays,
        NULL
    };
    return suite_run((suite){ .name = "column", .tests = tests });
}
