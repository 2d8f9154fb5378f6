// check.c - tests of the exercise 09/shoulder.

#include "shoulder.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <string.h>

// Some dozen roundings of numbers up to 10.
static const real ROUNDING = 1e-13;

static particle at(real x, real y, real z, real mass)
{
    return (particle){ { x, y, z }, { x, y, z }, mass > 0 ? 1 / mass : 0 };
}

static rod_end one(int k)
{
    return (rod_end){ 1, { k, -9, -9, -9 }, { 1, 7, 7, 7 } };
}

static rod_end mean(int count, int first, int step)
{
    rod_end e = { .count = count };
    for (int k = 0; k < count; k++) {
        e.at[k] = first + k * step;
        e.share[k] = 1.0 / count;
    }
    return e;
}

static void expect(const char *what, vec3 got, real x, real y, real z)
{
    ck_assert_msg(vec3_distance(got, (vec3){ x, y, z }) < ROUNDING * 10,
                  "%s: at (%.12g, %.12g, %.12g), wanted (%g, %g, %g)", what,
                  got.x, got.y, got.z, x, y, z);
}

START_TEST(end_is_the_mean_of_its_particles)
{
    // Rejects: shares behind the count; a mean whatever the shares.
    particle p[3] = { at(0, 0, 0, 1), at(4, 0, 0, 2), at(0, 8, 4, 0) };
    rod_end e = { 2, { 0, 1, 2, 2 }, { 0.75, 0.25, 9, 9 } };
    expect("a quarter of the way", end_place(&e, p), 1, 0, 0);
    e = (rod_end){ 3, { 0, 1, 2, -1 }, { 0.25, 0.5, 0.25, 9 } };
    expect("in a triangle", end_place(&e, p), 2, 2, 1);
    e = (rod_end){ 2, { 0, 1, -1, -1 }, { 1.5, -0.5, 9, 9 } };
    expect("beyond an end", end_place(&e, p), -2, 0, 0);
}
END_TEST

START_TEST(two_points_meet_where_their_masses_say)
{
    // 1 kg and 3 kg, 4 m apart: a ball joint brings them together at 3 m.
    // Rejects: half each; masses for inverse masses; the wrong sign; 0 / 0 when
    // they are there.
    particle p[2] = { at(0, 1, 0, 1), at(4, 1, 0, 3) };
    rod r = { one(0), one(1), 0, STICK_EXACT };
    real error = rod_relax(&r, p);
    ck_assert_msg(fabs(error - 4) < ROUNDING, "the error was %g, wanted 4",
                  error);
    expect("the light one", p[0].position, 3, 1, 0);
    expect("the heavy one", p[1].position, 3, 1, 0);
    error = rod_relax(&r, p);
    ck_assert_msg(fabs(error) < ROUNDING, "then it was %g, wanted 0", error);
    expect("the light one, again", p[0].position, 3, 1, 0);
}
END_TEST

START_TEST(rod_keeps_its_distance)
{
    // 4 m apart, to be 2 m: 1.5 and 0.5 m.
    particle p[2] = { at(0, 1, 0, 1), at(4, 1, 0, 3) };
    rod r = { one(0), one(1), 2, STICK_EXACT };
    ck_assert(fabs(rod_relax(&r, p) - 2) < ROUNDING);
    expect("the light one", p[0].position, 1.5, 1, 0);
    expect("the heavy one", p[1].position, 3.5, 1, 0);
    r.length = 6;
    ck_assert(fabs(rod_relax(&r, p) + 4) < ROUNDING);
    expect("pushed away", p[0].position, -1.5, 1, 0);
}
END_TEST

START_TEST(point_gets_where_it_should_in_one_go)
{
    // A point a quarter of the way between 1 kg and 1 kg, and a pin 2 m above.
    // w a^2: 9/16 + 1/16 = 5/8; pulls of 3/4 and 1/4 of 16/5 m.
    // Rejects: shares that are not squared in the sum, or left out of the pull.
    particle p[3] = { at(0, 0, 0, 1), at(4, 0, 0, 1), at(1, 2, 0, 0) };
    rod r = { { 2, { 0, 1, 0, 0 }, { 0.75, 0.25, 0, 0 } }, one(2), 0,
              STICK_EXACT };
    rod_relax(&r, p);
    expect("the point", end_place(&r.a, p), 1, 2, 0);
    expect("the near one", p[0].position, 0, 2.4, 0);
    expect("the far one", p[1].position, 4, 0.8, 0);
    expect("the pin", p[2].position, 1, 2, 0);
}
END_TEST

START_TEST(one_sided_rods_are_content)
{
    // Rejects: at least and at most exchanged.
    particle p[2] = { at(0, 0, 0, 1), at(4, 0, 0, 1) };
    rod r = { one(0), one(1), 3, STICK_AT_LEAST };
    ck_assert_msg(rod_relax(&r, p) == 0, "4 m are at least 3 m");
    expect("left alone", p[0].position, 0, 0, 0);
    r.length = 5;
    rod_relax(&r, p);
    expect("at least 5 m", p[0].position, -0.5, 0, 0);
    r = (rod){ one(0), one(1), 6, STICK_AT_MOST };
    ck_assert_msg(rod_relax(&r, p) == 0, "5 m are at most 6 m");
    r.length = 3;
    rod_relax(&r, p);
    expect("at most 3 m", p[1].position, 3.5, 0, 0);
}
END_TEST

START_TEST(what_cannot_move_is_left)
{
    // Rejects: 0 / 0.
    particle p[2] = { at(0, 0, 0, 0), at(4, 0, 0, 0) }, q[2];
    rod r = { one(0), one(1), 1, STICK_EXACT };
    rod_relax(&r, p);
    expect("two pins", p[0].position, 0, 0, 0);
    q[0] = q[1] = at(1, 2, 3, 1);
    rod_relax(&r, q);
    expect("no direction", q[0].position, 1, 2, 3);
    r.length = 0;
    rod_relax(&r, q);
    expect("nothing to do", q[1].position, 1, 2, 3);
}
END_TEST

static unsigned long long seed = 31;

START_TEST(momentum_and_its_moment_stay)
{
    // The moves times the masses: their sum, and their moment, are nothing.
    for (int k = 0; k < 200; k++) {
        particle p[7], old[7];
        for (int i = 0; i < 7; i++) {
            real x = random_real(&seed), y = random_real(&seed);
            p[i] = at(x, y, random_real(&seed), 1.5 + random_real(&seed));
        }
        memcpy(old, p, sizeof p);
        rod r = { mean(4, 0, 1), mean(3, 4, 1), 0.5 * (k % 3), STICK_EXACT };
        rod_relax(&r, p);
        vec3 sum = { 0, 0, 0 }, moment = { 0, 0, 0 };
        for (int i = 0; i < 7; i++) {
            vec3 move = vec3_scale(1 / p[i].inverse_mass,
                                   vec3_sub(p[i].position, old[i].position));
            sum = vec3_add(sum, move);
            moment = vec3_add(moment, vec3_cross(old[i].position, move));
        }
        expect("sum of moves", sum, 0, 0, 0);
        expect("their moment", moment, 0, 0, 0);
        real length = vec3_distance(end_place(&r.a, p), end_place(&r.b, p));
        ck_assert_msg(fabs(length - r.length) < ROUNDING, "it is %g m long, "
                      "wanted %g", length, r.length);
    }
}
END_TEST

START_TEST(passes_end_when_all_hold)
{
    // A chain of three rods between two pins 3 m apart, and one that is too
    // far away.  Rejects: one iteration; a loop without its cap; a look at the last
    // rod alone.
    particle p[4] = { at(0, 0, 0, 0), at(0.5, 0.5, 0, 1), at(2.2, -0.4, 0, 1),
                      at(2, 0, 0, 0) };
    rod r[3];
    for (int k = 0; k < 3; k++)
        r[k] = (rod){ one(k), one(k + 1), 1, STICK_EXACT };
    int iterations = rods_relax(r, 3, p, 1e-9, 1000);
    ck_assert_msg(iterations > 5 && iterations < 1000, "it took %d iterations", iterations);
    for (int k = 0; k < 3; k++)
        ck_assert_msg(fabs(vec3_distance(p[k].position, p[k + 1].position) - 1)
                      < 1e-8, "rod %d does not hold", k);
    ck_assert_int_eq(rods_relax(r, 3, p, 1e-9, 1000), 1);
    p[3].position.x = 4;
    ck_assert_int_eq(rods_relax(r, 3, p, 1e-9, 50), 50);
    ck_assert_int_eq(rods_relax(r, 0, p, 1e-9, 50), 1);
    // Too short is as wrong as too long.
    p[1].position = p[2].position = (vec3){ 1, 0, 0 };
    p[3].position.x = 1.5;
    ck_assert_int_gt(rods_relax(r, 3, p, 1e-9, 50), 1);
    // The first one was off, the last one never.
    particle q[4] = { at(0, 0, 0, 0), at(3, 0, 0, 1), at(0, 5, 0, 1),
                      at(1, 5, 0, 1) };
    const rod apart[2] = { r[0], { one(2), one(3), 1, STICK_EXACT } };
    ck_assert_int_eq(rods_relax(apart, 2, q, 1e-9, 50), 2);
}
END_TEST

// ---- things that hang

static const real dt = 1.0 / 960;       // s
static const vec3 GRAVITY = { 0, -9.81, 0 };
static shape arm;                       // 0.2 m by 1 m by 0.1 m, 1 kg
static particle p[17];                  // a pin, and two arms

static void set_up(void)
{
    ck_assert(shape_box(&arm, (vec3){ 0.2, 1, 0.1 }, 1).ok);
}

static void tear_down(void)
{
    shape_free(&arm);
}

// An arm, its middle here, turned by `turn` about z.
static void hang(int first, real x, real y, real turn)
{
    real c = cos(turn), s = sin(turn);
    for (int k = 0; k < 8; k++) {
        vec3 r = arm.at[k];
        p[first + k] = at(x + c * r.x - s * r.y, y + s * r.x + c * r.y, r.z,
                          arm.mass[k]);
    }
}

// The middle of an arm's upper or lower face: its vertices 2, 3, 6, 7 or 0, 1,
// 4, 5.
static rod_end face_of(int first, int upper)
{
    int v = first + (upper ? 2 : 0);
    return (rod_end){ 4, { v, v + 1, v + 4, v + 5 },
                      { 0.25, 0.25, 0.25, 0.25 } };
}

static void step(int arms, const rod *r, int n)
{
    relax_options o = relax_options_pbd();
    verlet_step(p, 1 + 8 * arms, GRAVITY, NULL, dt);
    for (int k = 0; k < 8; k++) {
        rods_relax(r, n, p, 1e-9, 4);
        for (int i = 0; i < arms; i++)
            sticks_relax(arm.stick, arm.sticks, &p[1 + 8 * i], 1, o);
    }
}

START_TEST(box_swings_like_a_pendulum)
{
    // Eight equal masses at the corners: I = m (0.1^2 + 0.5^2) about the
    // middle, and m 0.5^2 more about the joint; T = 2 pi sqrt(I / (m g 0.5)).
    // Rejects: whatever gives momentum, or takes it.
    p[0] = at(0, 0, 0, 0);
    hang(1, 0.5 * sin(0.05), -0.5 * cos(0.05), 0.05);
    rod joint = { one(0), face_of(1, 1), 0, STICK_EXACT };
    real wanted = 2 * acos(-1.0) * sqrt((0.26 + 0.25) / (9.81 * 0.5));
    // It begins at its turning point; it passes the middle after 1/4 and 3/4.
    int crossings = 0;
    real before = 1, when[2] = { 0, 0 };
    rod_end foot = face_of(1, 0);
    for (int k = 0; k < 4000 && crossings < 2; k++) {
        step(1, &joint, 1);
        real x = end_place(&foot, p).x;
        if (k > 0 && (x > 0) != (before > 0))
            when[crossings++] = (k + before / (before - x)) * dt;
        before = x;
    }
    ck_assert_msg(crossings == 2, "it does not swing");
    real got = 2 * (when[1] - when[0]);
    ck_assert_msg(fabs(got / wanted - 1) < 0.005, "it swings in %g s, wanted "
                  "%g s", got, wanted);
}
END_TEST

START_TEST(arm_with_two_joints_does_not_come_apart)
{
    // Let go side by side, stretched out; after a second all is in turmoil.
    p[0] = at(0, 0, 0, 0);
    hang(1, 0.5, 0, acos(0.0));
    hang(9, 1.5, 0, acos(0.0));
    rod joint[2] = { { one(0), face_of(1, 1), 0, STICK_EXACT },
                     { face_of(1, 0), face_of(9, 1), 0, STICK_EXACT } };
    real worst = 0;
    for (int k = 0; k < 960; k++) {
        step(2, joint, 2);
        for (int i = 0; i < 2; i++) {
            real gap = vec3_distance(end_place(&joint[i].a, p),
                                     end_place(&joint[i].b, p));
            if (!(gap <= worst)) worst = gap;
        }
    }
    ck_assert_msg(worst < 1e-3, "a joint opens by %g m", worst);
}
END_TEST

START_TEST(elbow_stops_where_it_was_told_to)
{
    // The lower arm is folded up beside the upper one, and may not come nearer
    // to it than its hand 1 m from the shoulder: 60 degrees at the elbow.
    p[0] = at(0, 0, 0, 0);
    hang(1, 0, -0.5, 0);
    hang(9, 0.5 * sin(1.2), -1 + 0.5 * cos(1.2), acos(-1.0) - 1.2);
    rod joint[3] = { { one(0), face_of(1, 1), 0, STICK_EXACT },
                     { face_of(1, 0), face_of(9, 1), 0, STICK_EXACT },
                     { face_of(1, 1), face_of(9, 0), 1, STICK_AT_LEAST } };
    // Thrown upwards: 4 rad/s about the elbow.
    for (int k = 9; k < 17; k++) {
        p[k].previous.x += 4 * dt * (p[k].position.y + 1);
        p[k].previous.y -= 4 * dt * p[k].position.x;
    }
    real nearest = 9;
    for (int k = 0; k < 480; k++) {
        step(2, joint, 3);
        real d = vec3_distance(end_place(&joint[2].a, p),
                               end_place(&joint[2].b, p));
        if (!(d >= nearest)) nearest = d;
    }
    ck_assert_msg(nearest > 0.99, "the hand came to %g m from the shoulder, "
                  "and 1 m is the least", nearest);
    ck_assert_msg(nearest < 1.05, "the hand never came near: %g m", nearest);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        end_is_the_mean_of_its_particles,
        two_points_meet_where_their_masses_say,
        rod_keeps_its_distance,
        point_gets_where_it_should_in_one_go,
        one_sided_rods_are_content,
        what_cannot_move_is_left,
        momentum_and_its_moment_stay,
        passes_end_when_all_hold,
        box_swings_like_a_pendulum,
        arm_with_two_joints_does_not_come_apart,
        elbow_stops_where_it_was_told_to,
        NULL
    };
    return suite_run((suite){
        .name = "shoulder", .tests = tests, .set_up = set_up,
        .tear_down = tear_down
    });
}
