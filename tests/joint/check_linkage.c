// check_linkage.c - trees of joints are solved at once, and rightly.
// Book: chapter 17.

#include <check.h>
#include <string.h>

#include "expect.h"
#include "linkage.h"
#include "random.h"
#include "suite.h"

enum { BODIES = 24 };

static unsigned long long seed = 11;

static linkage l;
static solver_body solid[BODIES];
static rigid4 plan[BODIES];
static motion velocity[BODIES], moved[BODIES];
static solver_frame frame;

static void tear_down(void)
{
    linkage_free(&l);
}

static linkage_pass pass(void)
{
    frame = (solver_frame){ .body = solid, .bodies = BODIES, .h = 1 / 480.0,
                            .substeps = 8, .warm = 1, .joint_rate = 12 };
    return (linkage_pass){ &frame, velocity, moved, NULL, 0 };
}

// Bodies of 0.01 to 100 kg, here and there, as they were thrown.
static void throw_bodies(void)
{
    for (int b = 0; b < BODIES; b++) {
        real heavy = random_real(&seed) * random_real(&seed)
             * random_real(&seed) + 1.001;
        solid[b].frame = JOINT_WORLD;
        solid[b].frame.center = random_vec3(&seed, 1);
        solid[b].basis.inverse_mass = 10 * heavy;
        plan[b] = (rigid4){ .alike = 0 };       // 4, 9 and 16 times as much
        solid[b].basis.of = &plan[b];
        for (int t = 0; t < TURNS; t++) {
            real turn = (2 + t) * sqrt(10 * heavy);
            plan[b].per_length[t] = 1;
            plan[b].root[t] = 1 / turn;
            plan[b].inverse[t] = turn * turn;
            plan[b].turn[t] = turn;
            solid[b].basis.turn[t] = vec3_scale(turn, JOINT_WORLD.axis[t]);
        }
        for (int i = 0; i < MOTIONS; i++)
            velocity[b].of[i] = random_real(&seed);
    }
}

static void join(joint_kind kind, int a, int b)
{
    joint_plan p = { .kind = kind, .a = a, .b = b,
                     .point = random_vec3(&seed, 1),
                     .axis = random_vec3(&seed, 1), .least = 0, .most = 1 };
    p.point_b = p.point;
    joint j = joint_make(&p, a < 0 ? &JOINT_WORLD : &solid[a].frame,
                         b < 0 ? &JOINT_WORLD : &solid[b].frame);
    expect_ok(linkage_add(&l, &j, NULL));
}

// m/s, the fastest that any error grows.
static real worst_speed(void)
{
    real worst = 0;
    for (int k = 0; k < l.count; k++) {
        const joint *j = &l.joint[k];
        const joint_rows *r = &l.rows[k];
        for (int i = 0; i < r->held; i++) {
            real sum = 0;
            for (int d = 0; d < MOTIONS; d++) {
                if (j->a >= 0) sum += r->a[i][d] * velocity[j->a].of[d];
                if (j->b >= 0) sum += r->b[i][d] * velocity[j->b].of[d];
            }
            worst = real_max(worst, fabs(sum));
        }
    }
    return worst;
}

START_TEST(tree_of_joints_is_solved_in_one_pass)
{
    // Random trees, some of them on the world, of all kinds: after one pass no
    // joint comes apart but by what it gives, 1e-4.  A pass over the joints,
    // one by one, leaves a large part.
    real plain = 0, tree = 0;
    for (int round = 0; round < 50; round++) {
        real first[2];
        for (int is_plain = 0; is_plain < 2; is_plain++) {
            seed = 100 + (unsigned)round;
            linkage_free(&l);
            throw_bodies();
            for (int b = 1; b < BODIES; b++)
                join((joint_kind)(JOINT_BALL + b % 3),
                     (int)(random_fraction(&seed) * b), b);
            if (round % 2) join(JOINT_BALL, 0, -1);
            l.is_plain = is_plain;
            linkage_pass q = pass();
            linkage_prepare(&l, &q);
            first[0] = worst_speed();
            linkage_relax(&l, &q);
            first[1] = worst_speed();
            real *worst = is_plain ? &plain : &tree;
            *worst = real_max(*worst, first[1] / first[0]);
        }
    }
    ck_assert_msg(tree < 0.01, "left of the errors' speed: %g", tree);
    ck_assert_msg(plain > 0.1, "one by one: %g", plain);
}
END_TEST

// Random trees with so many joints more, anywhere.  Returns which part of the errors'
// speed is left after one pass, at most.
static real left_of_rings(int more, bool *are_solved)
{
    real worst = 0;
    *are_solved = true;
    for (int round = 0; round < 50; round++) {
        seed = 200 + (unsigned)round;
        linkage_free(&l);
        throw_bodies();
        for (int b = 1; b < BODIES; b++) join(JOINT_BALL, (b - 1) / 2, b);
        for (int k = 0; k < more; k++) {
            int a = (int)(random_fraction(&seed) * BODIES);
            int b = (int)(random_fraction(&seed) * (BODIES - 1));
            join((joint_kind)(JOINT_BALL + k % 4 % 3), a, b + (b >= a));
        }
        linkage_pass q = pass();
        linkage_prepare(&l, &q);
        for (int k = 0; k < l.count; k++) *are_solved &= l.role[k] == JOINT_SOLVED;
        real before = worst_speed();
        linkage_relax(&l, &q);
        worst = real_max(worst, worst_speed() / before);
    }
    return worst;
}

START_TEST(rings_of_joints_are_solved_in_one_pass)
{
    // Of all kinds, some of them twice between the same two.  What is too wide is
    // solved joint by joint.  Rejects: a front that forgets how its bodies move each
    // other, or one that takes a body along that has no joint left.
    bool are_solved;
    for (int more = 1; more <= 5; more++) {
        real left = left_of_rings(more, &are_solved);
        ck_assert_msg(are_solved, "%d joints more are too wide", more);
        ck_assert_msg(left < 0.01, "%d more: left of the errors' speed: %g", more,
                      left);
    }
    ck_assert_msg(left_of_rings(100, &are_solved) < 1, "joint by joint");
    ck_assert(!are_solved);
}
END_TEST

// kg m^2/s, about the origin.
static vec3 angular_of(int b)
{
    const real *u = velocity[b].of;
    vec3 momentum = vec3_scale(1 / solid[b].basis.inverse_mass,
                               vec3_make(u[0], u[1], u[2]));
    return vec3_add(vec3_cross(solid[b].frame.center, momentum),
                    motion_angular(&solid[b].basis, &velocity[b]));
}

START_TEST(impulses_are_handed_from_body_to_body)
{
    // Momentum and angular momentum stay, to rounding, however far the joints
    // are torn apart.  Rejects: two impulses that act in two places.
    throw_bodies();
    for (int b = 1; b < BODIES; b++) join(JOINT_BALL, b - 1, b);
    join(JOINT_HINGE, 0, BODIES - 1);       // a ring
    for (int b = 0; b < BODIES; b++)
        solid[b].frame.center = vec3_add_scaled(solid[b].frame.center, 0.1,
                                               random_vec3(&seed, 1));
    vec3 was = { 0, 0, 0 }, now = { 0, 0, 0 }, turns[2] = { was, was };
    for (int after = 0; after < 2; after++) {
        vec3 *sum = after ? &now : &was;
        linkage_pass q = pass();
        if (after) {
            linkage_prepare(&l, &q);
            linkage_begin(&l, &q);
            linkage_push(&l, &q, true);
            linkage_relax(&l, &q);
        }
        for (int b = 0; b < BODIES; b++) {
            const real *u = velocity[b].of;
            turns[after] = vec3_add(turns[after], angular_of(b));
            *sum = vec3_add_scaled(*sum, 1 / solid[b].basis.inverse_mass,
                                   vec3_make(u[0], u[1], u[2]));
        }
    }
    ck_assert_msg(vec3_distance(was, now) < 1e-10, "off by %g",
                  vec3_distance(was, now));
    real turned = vec3_distance(turns[0], turns[1]);
    ck_assert_msg(turned < 1e-9, "angular momentum: off by %g", turned);
}
END_TEST

START_TEST(limit_gives_back_what_it_pushed_too_much)
{
    // A body turns away from its limit, which has pushed in the last substep:
    // the sum of what it gives is never negative, and the body turns on.
    throw_bodies();
    join(JOINT_HINGE, -1, 0);
    joint *j = &l.joint[0];
    j->is_limited = true;
    j->least = -1;
    j->most = 0;
    vec3 axis = j->axis_a[0];       // the world's coordinates
    for (int t = 0; t < TURNS; t++) {
        vec3 turn = solid[0].basis.turn[t];
        velocity[0].of[MOTION_TURN + t] = -vec3_dot(axis, turn)
                                        / vec3_length_squared(turn);
    }
    linkage_pass q = pass();
    linkage_prepare(&l, &q);
    j->impulse[5] = 1e-3;
    linkage_prepare(&l, &q);
    linkage_begin(&l, &q);
    linkage_push(&l, &q, true);
    linkage_relax(&l, &q);
    ck_assert_msg(j->impulse[5] >= 0, "it pulls: %g", j->impulse[5]);
    ck_assert(vec3_dot(axis, motion_rotation(&solid[0].basis, &velocity[0]))
              < -0.01);
}
END_TEST

// Two joints, of which one breaks, for a substep.
static void run_substep(const linkage_pass *q)
{
    linkage_prepare(&l, q);
    linkage_begin(&l, q);
    linkage_push(&l, q, true);
    linkage_relax(&l, q);
}

START_TEST(what_is_begun_again_goes_as_it_went)
{
    // Bit for bit, after the caller has put back the velocities: impulses, limits,
    // and what broke and holds again.
    throw_bodies();
    join(JOINT_BALL, -1, 0);
    join(JOINT_BALL, 0, 1);
    linkage_pass q = pass();
    run_substep(&q);
    motion start[BODIES], end[BODIES];
    memcpy(start, velocity, sizeof start);
    joint first[2] = { l.joint[0], l.joint[1] };
    l.joint[1].strength = 1e-6;
    linkage_mark(&l);
    run_substep(&q);
    memcpy(end, velocity, sizeof end);
    ck_assert(l.joint[1].is_broken && l.broken == 1);
    l.rows[0].is_upper = true;      // it came to its other limit
    linkage_rewind(&l, &q);
    ck_assert(!l.joint[1].is_broken && l.broken == 0 && !l.rows[0].is_upper);
    for (int k = 0; k < 2; k++)
        ck_assert(memcmp(l.joint[k].impulse, first[k].impulse,
                         sizeof first[k].impulse) == 0);
    memcpy(velocity, start, sizeof start);
    run_substep(&q);
    ck_assert(memcmp(velocity, end, sizeof end) == 0 && l.broken == 1);
}
END_TEST

// rad/s; m, from the joint.
static const real SPIN = 20, ARM = 0.5;

// A body on a point of the world turns about it, for some substeps.
static void turn_about_a_point(const linkage_pass *q)
{
    solver_body *x = &solid[0];
    real length = vec3_length(x->basis.turn[2]);
    velocity[0] = (motion){ { SPIN * ARM, 0, 0, 0, 0, SPIN / length } };
    joint_plan p = { .kind = JOINT_BALL, .a = -1, .b = 0,
                     .point = { 0, ARM, 0 } };
    x->frame.center = (vec3){ 0, 0, 0 };
    x->radius = ARM;
    joint j = joint_make(&p, &JOINT_WORLD, &x->frame);
    expect_ok(linkage_add(&l, &j, NULL));
    linkage_prepare(&l, q);
    for (int n = 0; n < 20; n++) {
        linkage_begin(&l, q);
        linkage_push(&l, q, true);
        linkage_advance(&l, q, 0, x);
        linkage_relax(&l, q);
    }
}

START_TEST(what_swings_evenly_begins_with_what_it_will_need)
{
    // On a circle a joint pulls the body aside by (h spin)^2 / 2 of its arm, in a
    // direction that turns by h spin in every substep.  As it grew it will grow:
    // what is left is of the next order.  Rejects: to begin with what joints gave
    // altogether, in the last substep, or with what they gave before the move.
    throw_bodies();
    linkage_pass q = pass();
    turn_about_a_point(&q);
    linkage_begin(&l, &q);
    solver_body end;
    linkage_advance(&l, &q, 0, &end);
    vec3 at = frame_point(&end.frame, l.joint[0].local_b);
    real off = vec3_distance(at, l.joint[0].local_a) / ARM;
    real step = q.f->h * SPIN;
    ck_assert_msg(off < step * step * step, "off by %g of the arm, a step is %g",
                  off, step);
}
END_TEST

START_TEST(two_pushes_with_nothing_between_are_one)
{
    // To the bit.  Rejects: to solve once more what nothing has touched.
    motion once = { { 0 } };
    for (int pushes = 1; pushes <= 2; pushes++) {
        seed = 100;
        linkage_free(&l);
        throw_bodies();
        linkage_pass q = pass();
        turn_about_a_point(&q);
        linkage_begin(&l, &q);
        if (pushes == 2) linkage_push(&l, &q, false);
        linkage_push(&l, &q, true);
        if (pushes == 1) once = velocity[0];
        ck_assert(memcmp(&once, &velocity[0], sizeof once) == 0);
    }
}
END_TEST

START_TEST(pairs_that_are_joined_are_kept_apart)
{
    throw_bodies();
    join(JOINT_BALL, 2, 0);
    join(JOINT_BALL, 2, 3);
    join(JOINT_BALL, 4, 9);
    join(JOINT_BALL, 5, -1);
    l.joint[1].may_touch = true;
    l.joint[2].is_broken = true;
    linkage_find_apart(&l);
    for (int a = 0; a < 10; a++)
        for (int b = a + 1; b < 10; b++)
            ck_assert_int_eq(linkage_keeps_apart(&l, a, b), a == 0 && b == 2);
    linkage_remove(&l, 0);
    linkage_find_apart(&l);
    ck_assert(!linkage_keeps_apart(&l, 0, 2));
}
END_TEST

START_TEST(nothing_joined_costs_nothing)
{
    throw_bodies();
    linkage_pass q = pass();
    linkage_prepare(&l, &q);
    linkage_begin(&l, &q);
    linkage_push(&l, &q, true);
    linkage_relax(&l, &q);
    ck_assert(!linkage_has(&l, 0));
    linkage_find_apart(&l);
    ck_assert(!linkage_keeps_apart(&l, 0, 1));
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        tree_of_joints_is_solved_in_one_pass,
        rings_of_joints_are_solved_in_one_pass,
        impulses_are_handed_from_body_to_body,
        limit_gives_back_what_it_pushed_too_much,
        what_is_begun_again_goes_as_it_went,
        what_swings_evenly_begins_with_what_it_will_need,
        two_pushes_with_nothing_between_are_one,
        pairs_that_are_joined_are_kept_apart,
        nothing_joined_costs_nothing,
        NULL
    };
    return suite_run((suite){
        .name = "linkage", .tests = tests, .tear_down = tear_down
    });
}
