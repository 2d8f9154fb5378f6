// check_joint.c - errors of a joint, and the rows by which they change.
// Book: chapter 17.

#include <check.h>
#include <string.h>

#include "expect.h"
#include "joint.h"
#include "random.h"
#include "suite.h"

static unsigned long long seed = 7;

// A body somewhere, with axes of any lengths, and its basis: I = a diagonal.
typedef struct {
    rigid_frame frame;
    motion_basis basis;
} thing;

static thing any_thing(void)
{
    thing t = { .basis = { .inverse_mass = 1.5 + random_real(&seed) } };
    vec3 x = vec3_unit(vec3_add(random_vec3(&seed, 1), vec3_make(2, 0, 0)));
    vec3 y = vec3_unit(vec3_cross(x, random_vec3(&seed, 1))),
         z = vec3_cross(x, y);
    vec3 axis[3] = { x, y, z };
    t.frame.center = random_vec3(&seed, 1);
    for (int i = 0; i < 3; i++) {
        t.frame.axis[i] = vec3_scale(1.5 + random_real(&seed), axis[i]);
        t.basis.turn[i] = vec3_scale(1.5 + random_real(&seed), axis[i]);
    }
    return t;
}

static rigid_frame moved(const thing *t, const motion *u, real seconds)
{
    motion d = *u;
    for (int i = 0; i < MOTIONS; i++) d.of[i] *= seconds;
    return motion_frame(&t->frame, &t->basis, &d);
}

static motion any_motion(void)
{
    motion u = { { 0 } };
    for (int i = 0; i < MOTIONS; i++) u.of[i] = random_real(&seed);
    return u;
}

static joint any_joint(joint_kind kind, const thing *a, const thing *b)
{
    joint_plan p = { .kind = kind, .a = 0, .b = 1,
                     .point = random_vec3(&seed, 1),
                     .point_b = random_vec3(&seed, 1),
                     .axis = random_vec3(&seed, 1), .most = 1 };
    expect_ok(joint_check(&p));
    joint j = joint_make(&p, &a->frame, &b->frame);
    if (kind == JOINT_HINGE) {
        j.is_limited = true;
        j.least = -1;
        j.most = 1;
    }
    return j;
}

START_TEST(rows_say_how_fast_errors_change)
{
    // By central differences, from nearly where the joint was made.  Rejects: a
    // sign, an axis of the other body, an arm to the wrong point.
    const real far = 1e-4, seconds = 1e-5;
    const joint_kind kinds[] = { JOINT_BALL, JOINT_HINGE, JOINT_FIXED,
                                 JOINT_DISTANCE, JOINT_SLIDER };
    for (int round = 0; round < 500; round++) {
        thing a = any_thing(), b = any_thing();
        joint j = any_joint(kinds[round % 5], &a, &b);
        motion u = any_motion(), v = any_motion(), off = any_motion();
        a.frame = moved(&a, &off, far);
        joint_side x = { &a.basis, a.frame }, y = { &b.basis, b.frame };
        joint_rows r;
        memset(&r, 0, sizeof r);
        joint_find_rows(&r, &j, &x, &y);
        real before[JOINT_ROWS], after[JOINT_ROWS];
        rigid_frame a0 = moved(&a, &u, -seconds), a1 = moved(&a, &u, seconds);
        rigid_frame b0 = moved(&b, &v, -seconds), b1 = moved(&b, &v, seconds);
        joint_errors(&j, &r, &a0, &b0, before);
        joint_errors(&j, &r, &a1, &b1, after);
        for (int k = 0; k < r.held + j.is_limited; k++) {
            real speed = 0;
            for (int i = 0; i < MOTIONS; i++)
                speed += r.a[k][i] * u.of[i] + r.b[k][i] * v.of[i];
            near((after[k] - before[k]) / (2 * seconds), speed, 3e-3,
                 "speed of an error");
        }
        const int rows[] = { 3, 6, 6, 1, 5 };
        ck_assert_int_eq(r.held + j.is_limited, rows[round % 5]);
    }
}
END_TEST

START_TEST(joint_as_made_has_no_error)
{
    for (int round = 0; round < 100; round++) {
        thing a = any_thing(), b = any_thing();
        joint j = any_joint((joint_kind)(JOINT_BALL + round % 3), &a, &b);
        joint_side x = { &a.basis, a.frame }, y = { &b.basis, b.frame };
        joint_rows r;
        memset(&r, 0, sizeof r);
        joint_find_rows(&r, &j, &x, &y);
        for (int k = 0; k < r.held; k++)
            near(r.error[k], 0, 1e-14, "an error");
        near(joint_angle(&j, &a.frame, &b.frame), 0, 1e-14, "an angle");
    }
}
END_TEST

START_TEST(hinge_measures_angles_all_around)
{
    // B turned about z by an angle.  Rejects: an arctan that does not see the
    // signs of both.
    joint_plan p = { .kind = JOINT_HINGE, .axis = { 0, 0, 2 } };
    joint j = joint_make(&p, &JOINT_WORLD, &JOINT_WORLD);
    for (int k = -314; k <= 314; k++) {
        real t = 0.01 * k;
        rigid_frame b = { { 0, 0, 0 }, { { cos(t), sin(t), 0 },
                            { -sin(t), cos(t), 0 }, { 0, 0, 1 } } };
        near(joint_angle(&j, &JOINT_WORLD, &b), t, 1e-14, "the angle");
    }
}
END_TEST

START_TEST(small_systems_are_solved)
{
    for (int round = 0; round < 200; round++) {
        int n = 1 + round % JOINT_ROWS;
        real root[JOINT_ROWS][JOINT_ROWS], m[JOINT_ROWS][JOINT_ROWS];
        real x[JOINT_ROWS], y[JOINT_ROWS] = { 0 };
        for (int i = 0; i < n; i++)
            for (int k = 0; k < n; k++) root[i][k] = random_real(&seed)
                + 2 * (i == k);
        for (int i = 0; i < n; i++) {
            x[i] = random_real(&seed);
            for (int k = 0; k < n; k++) {
                m[i][k] = 0;
                for (int l = 0; l < n; l++) m[i][k] += root[i][l] * root[k][l];
            }
        }
        for (int i = 0; i < n; i++)
            for (int k = 0; k < n; k++) y[i] += m[i][k] * x[k];
        small_invert(n, m);
        small_times(n, m, y);
        for (int i = 0; i < n; i++) near(y[i], x[i], 1e-10, "a solution");
    }
    // What nothing answers stays as it is.
    real none[JOINT_ROWS][JOINT_ROWS] = { { 0 } }, x[JOINT_ROWS] = { 1, 2, 3 };
    small_invert(3, none);
    small_times(3, none, x);
    for (int i = 0; i < 3; i++) near(x[i], 0, 0, "an answer of what is fixed");
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        rows_say_how_fast_errors_change,
        joint_as_made_has_no_error,
        hinge_measures_angles_all_around,
        small_systems_are_solved,
        NULL
    };
    return suite_run((suite){ .name = "joint", .tests = tests });
}
