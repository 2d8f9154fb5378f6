// check.c - tests of the exercise 17/chain.

#include "links.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>

// Some hundred roundings of speeds about 1.
static const real ROUNDING = 1e-11;
enum { BODIES = 20001 };
static limb b[BODIES];
static ball_joint j[BODIES];
static unsigned long long seed = 17;

// A box with its own axes along the world's.
static limb box(real mass, vec3 side)
{
    real x = side.x * side.x, y = side.y * side.y, z = side.z * side.z;
    return (limb){ .inverse_mass = 1 / mass,
        .inverse = { { 12 / (mass * (y + z)), 0, 0 }, { 0, 12 / (mass * (x + z)), 0 },
                     { 0, 0, 12 / (mass * (x + y)) } } };
}

// Any inertia: of three rods that point anywhere.
static limb any(void)
{
    limb l = box(random_between(&seed, 0.5, 2), vec3_make(1, 1, 1));
    block more = { { 0, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } };
    for (int i = 0; i < 3; i++) {
        vec3 d = random_vec3(&seed, 1);
        more = block_add_scaled(more, 1, (block){ vec3_scale(d.x, d), vec3_scale(d.y, d), vec3_scale(d.z, d) });
    }
    l.inverse = block_add_scaled(l.inverse, 1, more);
    l.velocity = random_vec3(&seed, 1);
    l.spin = random_vec3(&seed, 1);
    return l;
}

static void any_chain(int joints)
{
    for (int k = 0; k <= joints; k++) {
        b[k] = any();
        j[k] = (ball_joint){ .above = random_vec3(&seed, 1), .below = random_vec3(&seed, 1) };
    }
}

static vec3 velocity_at(const limb *l, vec3 arm)
{
    return vec3_add(l->velocity, vec3_cross(l->spin, arm));
}

static void all_hold(int joints)
{
    for (int k = 0; k < joints; k++)
        near_vec3(velocity_at(&b[k + 1], j[k].below), velocity_at(&b[k], j[k].above), ROUNDING,
                  "velocity of the point below, and of the point above", "A joint is a point of both.");
}

START_TEST(one_joint_answers_as_the_textbook_says)
{
    // A box of 6 kg, 1 x 2 x 3 m, hangs by the middle of its upper side.
    // Rejects: the turn without the mass, the inertia about the wrong axis.
    limb l = box(6, vec3_make(1, 2, 3));
    block k = answer_between(&l, vec3_make(0, 1, 0), vec3_make(0, 1, 0));
    near(k.y.y, 1 / 6.0, ROUNDING, "1/kg upwards", "Pulled along its arm a body does not turn.");
    near(k.x.x, 1 / 6.0 + 2 / 5.0, ROUNDING, "1/kg along x", "It turns about z, with 6 (1 + 4) / 12 = 5/2 kg m^2.");
    near(k.z.z, 1 / 6.0 + 12 / (6 * 13.0), ROUNDING, "1/kg along z", "It turns about x, with 6 (4 + 9) / 12 kg m^2.");
    // The other end of the box goes the other way.
    k = answer_between(&l, vec3_make(0, -1, 0), vec3_make(0, 1, 0));
    near(k.x.x, 1 / 6.0 - 2 / 5.0, ROUNDING, "1/kg along x, of the lower end for an impulse at the upper");
}
END_TEST

START_TEST(answer_is_at_the_first_arm)
{
    // An impulse along x at the arm (0, 1, 0) turns the cube of 6 kg by -1
    // about z, which moves the point (1, 0, 0) by -1 along y.
    // Rejects: the two arms exchanged.
    limb l = box(6, vec3_make(1, 1, 1));
    block k = answer_between(&l, vec3_make(1, 0, 0), vec3_make(0, 1, 0));
    near_vec3(k.x, vec3_make(1 / 6.0, -1, 0), ROUNDING, "move of (1, 0, 0) for an impulse along x at (0, 1, 0)");
    near_vec3(k.y, vec3_make(0, 1 / 6.0, 0), ROUNDING, "for one along y", "It goes through the centre.");
}
END_TEST

START_TEST(points_of_two_joints_go_together)
{
    // Rejects: each joint alone, a sign, the walk up left out.
    for (int joints = 1; joints <= 2; joints++) {
        any_chain(joints);
        chain_hold(b, j, joints);
        all_hold(joints);
    }
}
END_TEST

START_TEST(points_of_long_chains_go_together)
{
    // Rejects: impulses that are given on the way.
    for (int joints = 3; joints < 200; joints += 7) {
        any_chain(joints);
        if (joints % 2) b[0] = (limb){ .inverse_mass = 0 };
        chain_hold(b, j, joints);
        all_hold(joints);
    }
}
END_TEST

START_TEST(what_never_moves_stays)
{
    any_chain(5);
    b[0] = (limb){ .inverse_mass = 0 };
    chain_hold(b, j, 5);
    near_vec3(b[0].velocity, vec3_make(0, 0, 0), 0, "velocity of what never moves");
    near_vec3(velocity_at(&b[1], j[0].below), vec3_make(0, 0, 0), ROUNDING, "velocity of the point that hangs on it");
}
END_TEST

START_TEST(momentum_stays)
{
    // Rejects: an impulse on one of the two bodies only, or twice the same.
    vec3 before = { 0, 0, 0 }, after = { 0, 0, 0 };
    any_chain(30);
    for (int k = 0; k <= 30; k++) before = vec3_add_scaled(before, 1 / b[k].inverse_mass, b[k].velocity);
    chain_hold(b, j, 30);
    for (int k = 0; k <= 30; k++) after = vec3_add_scaled(after, 1 / b[k].inverse_mass, b[k].velocity);
    near_vec3(after, before, ROUNDING, "kg m/s of all");
}
END_TEST

START_TEST(chain_carries_ten_thousand_times_a_link)
{
    // Fifty links under a ceiling have fallen for 1/480 s.  Each joint carries
    // all that hangs below it.
    // Rejects: iteration.
    enum { LINKS = 50 };
    const real fall = 9.81 / 480;
    b[0] = (limb){ .inverse_mass = 0 };
    for (int k = 1; k <= LINKS; k++) b[k] = box(k < LINKS ? 1 : 10000, vec3_make(0.2, 0.2, 0.2));
    for (int k = 1; k <= LINKS; k++) b[k].velocity = vec3_make(0, -fall, 0);
    for (int k = 0; k < LINKS; k++)
        j[k] = (ball_joint){ .above = { 0, -0.1, 0 }, .below = { 0, 0.1, 0 } };
    chain_hold(b, j, LINKS);
    for (int k = 0; k < LINKS; k++)
        near_relative(j[k].part.y, fall * (10000 + LINKS - 1 - k), 1e-9, "kg m/s, that a joint gives to the body below",
                      "It carries every link below it, and the load.");
    all_hold(LINKS);
}
END_TEST

START_TEST(twenty_thousand_joints_take_no_time)
{
    // Rejects: elimination of a full matrix.
    any_chain(BODIES - 1);
    chain_hold(b, j, BODIES - 1);
    all_hold(BODIES - 1);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        one_joint_answers_as_the_textbook_says,
        answer_is_at_the_first_arm,
        points_of_two_joints_go_together,
        points_of_long_chains_go_together,
        what_never_moves_stays,
        momentum_stays,
        chain_carries_ten_thousand_times_a_link,
        twenty_thousand_joints_take_no_time,
        NULL
    };
    return suite_run((suite){ .name = "chain", .tests = tests });
}
