// check.c - tests of the exercise 13/joint.

#include "shared.h"
#include "expect.h"
#include "random.h"
#include "shake.h"
#include "suite.h"

#include <check.h>
#include <string.h>

// Some dozen roundings of places of some metres.
static const real ROUNDING = 1e-13;

static const vec3 NONE = { 0, 0, 0 }, GRAVITY = { 0, -9.81, 0 };

enum { BODIES = 5 };

static particle p[FOUR * BODIES];
static shape box;
static rigid4 plan;

static unsigned long long seed = 5;

static void make(vec3 sides, real mass)
{
    ck_assert(shape_box(&box, sides, mass).ok);
    ck_assert(rigid4_build(&plan, &box).ok);
}

static void unmake(void)
{
    rigid4_free(&plan);
    shape_free(&box);
}

// Body number b, upright, at rest.
static void put(int b, vec3 at, int pinned)
{
    for (int k = 0; k < FOUR; k++) {
        vec3 x = vec3_add(at, plan.at[k]);
        p[FOUR * b + k] = (particle){ x, x, pinned ? 0 : 1 / plan.mass };
    }
}

// The frame of the plan itself, upright around its centre.
static rigid_frame upright(void)
{
    particle x[FOUR];
    for (int k = 0; k < FOUR; k++) x[k].position = plan.at[k];
    return rigid4_frame(x);
}

// The points are told in the frame of the plan.
static joint joint_of(int a, vec3 point_a, int b, vec3 point_b)
{
    rigid_frame at = upright();
    joint j = { FOUR * a, FOUR * b, joint_local(&at, point_a), NONE, point_b };
    if (b < 0) j.b = -1;
    else       j.local_b = joint_local(&at, point_b);
    return j;
}

static vec3 point(int b, vec3 local)
{
    rigid_frame now = rigid4_frame(p + FOUR * b);
    return frame_point(&now, local);
}

static vec3 centre(int b)
{
    return point(b, NONE);
}

static real worst_strain(int bodies)
{
    real worst = 0;
    for (int b = 0; b < bodies; b++)
        for (int s = 0; s < FOUR_STICKS; s++)
            worst = fmax(worst, stick_strain(plan.stick[s], p + FOUR * b));
    return worst;
}

START_TEST(coordinates_of_corners_are_those_of_the_plan)
{
    // Rejects: an axis taken for a unit vector; one for another; a frame that
    // must stand at the origin.
    const vec3 away = { 3, 1, -2 };
    make(vec3_make(1, 2, 3), 6);
    rigid_frame at = upright();
    at.center = vec3_add(at.center, away);
    for (int v = 0; v < 8; v++)
        near(vec3_distance(joint_local(&at, vec3_add(box.at[v], away)),
                           plan.local[v]), 0, 10 * ROUNDING,
             "coordinates of a corner");
    unmake();
}
END_TEST

START_TEST(body_that_hangs_on_a_point_answers_as_the_textbook_says)
{
    // 6 kg, 1 x 2 x 3 m, held at the middle of its upper side, 1 m above the
    // centre.  Pulled up: K = 1/6.  Pulled along x, it turns about z, I_z =
    // 6 (1 + 4) / 12 = 5/2: K = 1/6 + 1 / (5/2).  Its centre goes by push / 6.
    make(vec3_make(1, 2, 3), 6);
    for (int aside = 0; aside < 2; aside++) {
        vec3 gap = { aside ? 0.001 : 0, aside ? 0 : 0.001, 0 };
        put(0, NONE, 0);
        joint j = joint_of(0, vec3_make(0, 1, 0), -1,
                           vec3_add(vec3_make(0, 1, 0), gap));
        near(joint_close(&j, &plan, p), 0.001, ROUNDING, "gap before");
        near(vec3_distance(point(0, j.local_a), j.fixed), 0, ROUNDING,
             "gap afterwards");
        real k = 1 / 6.0 + (aside ? 0.4 : 0);
        near(vec3_length(centre(0)), 0.001 / k / 6, ROUNDING,
             aside ? "way of the centre, pulled aside"
                   : "way of the centre, pulled up");
    }
    unmake();
}
END_TEST

// Two bodies somewhere, with a gap of up to 2 mm between a corner of each.
static joint any_two(real gap)
{
    put(0, random_vec3(&seed, 1), 0);
    int v = (int)(4 * (random_real(&seed) + 1));
    vec3 at = vec3_add(vec3_sub(centre(0), box.at[v]), box.at[7 - v]);
    put(1, at, 0);
    joint j = joint_of(0, box.at[7 - v], 1, box.at[v]);
    for (int b = 0; b < 2; b++) {
        vec3 way = random_vec3(&seed, gap);
        vec3 turn = random_vec3(&seed, gap);
        for (int k = 0; k < FOUR; k++) {
            vec3 r = vec3_cross(turn, plan.at[k]);
            particle *x = &p[FOUR * b + k];
            x->position = vec3_add(x->position, vec3_add(way, r));
        }
    }
    return j;
}

START_TEST(gap_is_closed_at_once)
{
    // All that is done is linear in the particles' places, but for the sticks,
    // which are bent by the square.  Rejects: one body's K; the axes for
    // themselves.
    make(vec3_make(1, 2, 3), 6);
    for (int round = 0; round < 200; round++) {
        joint j = any_two(1e-3);
        joint_close(&j, &plan, p);
        near(vec3_distance(point(0, j.local_a), point(1, j.local_b)), 0,
             10 * ROUNDING, "gap afterwards");
        near(worst_strain(2), 0, 1e-4, "strain");
        near(joint_close(&j, &plan, p), 0, 10 * ROUNDING,
             "gap the second time");
    }
    unmake();
}
END_TEST

START_TEST(momenta_stay)
{
    // Rejects: a sign; a frame of the new places.
    make(vec3_make(1, 2, 3), 6);
    for (int round = 0; round < 200; round++) {
        joint j = any_two(0.1);
        vec3 moved[2], turned[2];
        for (int after = 0; after < 2; after++) {
            moved[after] = turned[after] = NONE;
            if (after) joint_close(&j, &plan, p);
            for (int i = 0; i < 2 * FOUR; i++) {
                moved[after] = vec3_add(moved[after], p[i].position);
                turned[after] = vec3_add(turned[after],
                                 vec3_cross(p[i].previous, p[i].position));
            }
        }
        near(vec3_distance(moved[0], moved[1]), 0, 1e-12, "momentum");
        near(vec3_distance(turned[0], turned[1]), 0, 1e-12,
             "angular momentum");
    }
    unmake();
}
END_TEST

static void step(const joint *j, int joints, int bodies, int rounds, real h)
{
    relax_options o = relax_options_default();
    o.tolerance = 1e-12;
    verlet_step(p, FOUR * bodies, GRAVITY, NULL, h);
    for (int r = 0; r < rounds; r++) {
        for (int b = 0; b < bodies; b++) shake(&plan, p + FOUR * b, 6, o);
        for (int i = 0; i < joints; i++) joint_close(&j[i], &plan, p);
    }
}

START_TEST(rod_swings_in_its_time)
{
    // 1 m long, 0.1 m thick, held at its end: I = m (1 + 0.01) / 12 + m / 4,
    // T = 2 pi sqrt(I / (m g / 2)).  It starts at 0.01 rad.
    const real h = 1.0 / 2000;
    make(vec3_make(0.1, 1, 0.1), 3);
    put(0, vec3_make(0, -0.5, 0), 0);
    joint j = joint_of(0, vec3_make(0, 0.5, 0), -1, NONE);
    for (int k = 0; k < FOUR; k++) {
        vec3 x = p[k].position;
        p[k].position = vec3_make(x.x * cos(0.01) - x.y * sin(0.01),
                                  x.x * sin(0.01) + x.y * cos(0.01), x.z);
        p[k].previous = p[k].position;
    }
    real before = centre(0).x, crossed = 0;
    for (int k = 1; crossed == 0 && k < 4000; k++) {
        step(&j, 1, 1, 2, h);
        real now = centre(0).x;
        if (now <= 0) crossed = (k - now / (now - before)) * h;
        before = now;
    }
    real inertia = 1.01 / 12 + 0.25;
    real quarter = 3.14159265358979324 / 2 * sqrt(inertia / (9.81 / 2));
    near(crossed / quarter, 1, 1e-3, "a quarter of its time, as a share");
    unmake();
}
END_TEST

START_TEST(chain_of_boxes_falls_and_holds)
{
    // Five boxes from the horizontal; the first hangs on the world.  It falls
    // for 3/4 s.  Its energy stays, its joints hold.
    const real h = 1.0 / 2000;
    joint j[BODIES];
    real energy = 0;
    make(vec3_make(1, 0.2, 0.2), 2);
    for (int b = 0; b < BODIES; b++) {
        put(b, vec3_make(b + 0.5, 0, 0), 0);
        j[b] = joint_of(b, vec3_make(-0.5, 0, 0), b - 1, b
                        ? vec3_make(0.5, 0, 0) : NONE);
    }
    for (int k = 0; k < 1500; k++) step(j, BODIES, BODIES, 12, h);
    for (int i = 0; i < FOUR * BODIES; i++) {
        vec3 v = vec3_scale(1 / h, vec3_sub(p[i].position, p[i].previous));
        energy += plan.mass * (vec3_dot(v, v) / 2
                  + 9.81 * (p[i].position.y + p[i].previous.y) / 2);
    }
    for (int b = 1; b < BODIES; b++)
        near(vec3_distance(point(b, j[b].local_a),
                           point(b - 1, j[b].local_b)), 0, 1e-5, "a gap");
    ck_assert_msg(centre(4).y < -1.5, "the last box has fallen to %g m only",
                  centre(4).y);
    near(energy / (10 * 9.81), 0, 0.01, "energy, in units of m g times 1 m");
    unmake();
}
END_TEST

START_TEST(pinned_bodies_stay)
{
    make(vec3_make(1, 1, 1), 1);
    for (int round = 0; round < 2; round++) {
        put(0, NONE, 1);
        put(1, vec3_make(1.5, 0, 0), 1);
        joint j = joint_of(0, vec3_make(0.5, 0, 0), round ? 1 : -1,
                           round ? vec3_make(-0.5, 0, 0)
                                 : vec3_make(1, 0, 0));
        near(joint_close(&j, &plan, p), 0.5, ROUNDING, "gap");
        for (int i = 0; i < 2 * FOUR; i++)
            near(vec3_distance(p[i].position, p[i].previous), 0, 0, "a way");
    }
    // One of them free: it comes all the way.
    put(1, vec3_make(1.5, 0, 0), 0);
    joint j = joint_of(0, vec3_make(0.5, 0, 0), 1, vec3_make(-0.5, 0, 0));
    joint_close(&j, &plan, p);
    near(centre(1).x, 1, ROUNDING, "where the free one's centre comes to");
    unmake();
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        coordinates_of_corners_are_those_of_the_plan,
        body_that_hangs_on_a_point_answers_as_the_textbook_says,
        gap_is_closed_at_once,
        momenta_stay,
        rod_swings_in_its_time,
        chain_of_boxes_falls_and_holds,
        pinned_bodies_stay,
        NULL
    };
    return suite_run((suite){ .name = "joint", .tests = tests });
}
