// check.c - tests of the exercise 10/when.

#include "when.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>

// s: the gap that is left, a micrometre, at some m/s.
static const real WITHIN = 1e-6, SOON = 1e-5;
enum { CAP = 100 };

static hull box(vec3 at[8], vec3 low, vec3 high)
{
    for (int i = 0; i < 8; i++)
        at[i] = (vec3){ i & 1 ? high.x : low.x, i & 2 ? high.y : low.y,
                        i & 4 ? high.z : low.z };
    return (hull){ at, 8 };
}

static hull point(const vec3 *at)
{
    return (hull){ at, 1 };
}

static const vec3 STILL = { 0, 0, 0 };

// Asks with room that ends behind A's last point.
static when_result ask(hull a, vec3 velocity_a, hull b,
                       vec3 velocity_b, real horizon, int cap)
{
    vec3 *room = malloc((size_t)a.count * sizeof *room);
    ck_assert_ptr_nonnull(room);
    when_result r = when_meet((moving){ a, velocity_a },
                              (moving){ b, velocity_b }, horizon, WITHIN, cap,
                              room);
    free(room);
    return r;
}

static const char *status_name(when_status s)
{
    static const char *name[] = { "WHEN_MEET", "WHEN_NEVER", "WHEN_CAPPED",
                                  "WHEN_NOT_FINITE" };
    return s <= WHEN_NOT_FINITE ? name[s] : "no status";
}

static void expect_status(when_result r, when_status wanted, const char *what)
{
    ck_assert_msg(r.status == wanted, "%s: the status is %s, wanted %s", what,
                  status_name(r.status), status_name(wanted));
}

static void expect_meeting(when_result r, real time, vec3 normal,
                           const char *what)
{
    expect_status(r, WHEN_MEET, what);
    near(r.time, time, SOON, what);
    ck_assert_msg(vec3_distance(r.normal, normal) < 1e-9, "%s: the normal is "
                  "(%g, %g, %g), wanted (%g, %g, %g)", what, r.normal.x,
                  r.normal.y, r.normal.z, normal.x, normal.y, normal.z);
}

static unsigned long long seed = 4;

START_TEST(point_flies_at_a_box)
{
    // 6 m at 2 m/s: one jump.  Rejects: a normal that points the other way, an
    // axis that is taken for a unit vector, a point that stays behind.
    vec3 at[8], p = { 7, 0.25, 0.5 };
    hull b = box(at, (vec3){ -1, -1, -1 }, (vec3){ 1, 1, 1 });
    when_result r = ask(point(&p), (vec3){ -2, 0, 0 }, b, STILL, 10, CAP);
    expect_meeting(r, 3, (vec3){ 1, 0, 0 }, "a point 6 m away, at 2 m/s");
    ck_assert_msg(r.looks <= 3, "one jump is enough: got %d looks", r.looks);
}
END_TEST

START_TEST(oblique_flight_takes_some_jumps)
{
    // A ray from (-5, 4, 0) along (2, -1, 0).  It enters between x = -1 and 1
    // and between y = -1 and 1: the first from t = 2 on, the second from t = 3
    // on.  So it meets the upper face, at t = 3.
    vec3 at[8], p = { -5, 4, 0 };
    hull b = box(at, (vec3){ -1, -1, -1 }, (vec3){ 1, 1, 1 });
    when_result r = ask(point(&p), (vec3){ 2, -1, 0 }, b, STILL, 10, CAP);
    expect_meeting(r, 3, (vec3){ 0, 1, 0 }, "an oblique ray");
    ck_assert_msg(r.looks < 10, "a few jumps are enough: got %d looks",
                  r.looks);
}
END_TEST

START_TEST(box_meets_box)
{
    vec3 at[8], bt[8];
    hull a = box(at, (vec3){ 0, 9, 0 }, (vec3){ 1, 10, 1 });
    hull b = box(bt, (vec3){ -5, -1, -5 }, (vec3){ 5, 0, 5 });
    expect_meeting(ask(a, (vec3){ 0.5, -3, 0 }, b, STILL, 10, CAP), 3,
                   (vec3){ 0, 1, 0 }, "a box falls on a floor");
    expect_meeting(ask(b, STILL, a, (vec3){ 0.5, -3, 0 }, 10, CAP), 3,
                   (vec3){ 0, -1, 0 }, "the same, exchanged");
}
END_TEST

START_TEST(bullet_does_not_fly_through_a_sheet)
{
    // 1000 m/s, and a sheet of a millimetre, 53 m away.
    // Rejects: looking at equal times.
    vec3 at[8], p = { 0, 0, 0 };
    hull sheet = box(at, (vec3){ 53, -9, -9 }, (vec3){ 53.001, 9, 9 });
    expect_meeting(ask(point(&p), (vec3){ 1000, 0, 0 }, sheet, STILL, 1, CAP),
                   0.053, (vec3){ -1, 0, 0 }, "a bullet");
}
END_TEST

START_TEST(overtaking_takes_longer)
{
    // Rejects: B taken to stand still; velocities added.
    vec3 at[8], p = { 0, 0, 0 };
    hull b = box(at, (vec3){ 4, -1, -1 }, (vec3){ 5, 1, 1 });
    expect_meeting(ask(point(&p), (vec3){ 3, 7, 0 }, b, (vec3){ 1, 7, 0 }, 10,
                       CAP), 2, (vec3){ -1, 0, 0 }, "3 m/s behind 1 m/s");
    expect_meeting(ask(point(&p), STILL, b, (vec3){ -8, 0, 0 }, 10, CAP), 0.5,
                   (vec3){ -1, 0, 0 }, "B comes alone");
}
END_TEST

START_TEST(side_by_side_is_never)
{
    vec3 at[8], p = { 0, 0, 0 };
    hull b = box(at, (vec3){ 4, -1, -1 }, (vec3){ 5, 1, 1 });
    vec3 v = { 3, 1, 2 };
    expect_status(ask(point(&p), v, b, v, 10, CAP), WHEN_NEVER,
                  "the same velocity");
    expect_status(ask(point(&p), STILL, b, STILL, 10, CAP), WHEN_NEVER,
                  "nobody moves");
}
END_TEST

START_TEST(leaving_is_never)
{
    vec3 at[8], p = { 0, 0, 0 };
    hull b = box(at, (vec3){ 4, -1, -1 }, (vec3){ 5, 1, 1 });
    when_result r = ask(point(&p), (vec3){ -1, 0.5, 0 }, b, STILL, 10, CAP);
    expect_status(r, WHEN_NEVER, "it leaves");
    ck_assert_msg(r.time == 0 && vec3_length(r.normal) == 0, "never has no "
                  "time and no normal: got %g s", r.time);
}
END_TEST

START_TEST(passing_by_is_never)
{
    // 10 cm beside the corner, and later on nearer than that to nothing.
    // Rejects: jumps by the whole speed, which creep up to where the way is
    // shortest, and past it never come to an end.
    vec3 at[8], p = { -10, 1.1, 0 };
    hull b = box(at, (vec3){ -1, -1, -1 }, (vec3){ 1, 1, 1 });
    when_result r = ask(point(&p), (vec3){ 1, 0, 0 }, b, STILL, 1000, CAP);
    expect_status(r, WHEN_NEVER, "10 cm above the box");
    ck_assert_msg(r.looks < 10, "a few looks are enough: got %d", r.looks);
}
END_TEST

START_TEST(too_late_is_never)
{
    vec3 at[8], p = { 0, 0, 0 };
    hull b = box(at, (vec3){ 4, -1, -1 }, (vec3){ 5, 1, 1 });
    expect_status(ask(point(&p), (vec3){ 1, 0, 0 }, b, STILL, 3.9, CAP),
                  WHEN_NEVER, "they meet after 4 s, the horizon is 3.9 s");
    expect_status(ask(point(&p), (vec3){ 1, 0, 0 }, b, STILL, 4.1, CAP),
                  WHEN_MEET, "they meet after 4 s, the horizon is 4.1 s");
}
END_TEST

START_TEST(overlap_is_now)
{
    vec3 at[8], p = { 0.5, 0, 0 };
    hull b = box(at, (vec3){ -1, -1, -1 }, (vec3){ 1, 1, 1 });
    when_result r = ask(point(&p), (vec3){ 1, 0, 0 }, b, STILL, 10, CAP);
    expect_meeting(r, 0, (vec3){ 0, 0, 0 }, "inside from the first");
}
END_TEST

START_TEST(cap_is_kept)
{
    vec3 at[8], p = { -5, 4, 0 };
    hull b = box(at, (vec3){ -1, -1, -1 }, (vec3){ 1, 1, 1 });
    when_result r = ask(point(&p), (vec3){ 2, -1, 0 }, b, STILL, 10, 1);
    expect_status(r, WHEN_CAPPED, "one look");
    ck_assert_msg(r.looks == 1 && r.time > 0 && r.time <= 3, "one look, and "
                  "surely nothing before %g s: wanted more than 0 and at most "
                  "3", r.time);
}
END_TEST

START_TEST(what_is_not_finite_is_said)
{
    vec3 at[8], p = { 0, (real)NAN, 0 };
    hull b = box(at, (vec3){ 4, -1, -1 }, (vec3){ 5, 1, 1 });
    when_result r = ask(point(&p), (vec3){ 1, 0, 0 }, b, STILL, 10, CAP);
    expect_status(r, WHEN_NOT_FINITE, "a coordinate is no number");
    ck_assert_msg(r.time == 0, "time is %g", r.time);
}
END_TEST

START_TEST(nobody_has_touched_before)
{
    // Random hulls.  At the meeting the gap is closed; at a hundred moments
    // before it is open.  Rejects: a jump too far.
    int met = 0;
    for (int k = 0; k < 100; k++) {
        vec3 s[6], t[6], later[6];
        for (int i = 0; i < 6; i++) {
            s[i] = vec3_add(random_vec3(&seed, 1), (vec3){ 6, 0, 0 });
            t[i] = random_vec3(&seed, 1);
        }
        hull a = { s, 6 }, b = { t, 6 };
        vec3 v = { -3, random_real(&seed), random_real(&seed) };
        when_result r = ask(a, v, b, STILL, 10, CAP);
        ck_assert_msg(r.status == WHEN_MEET || r.status == WHEN_NEVER,
                      "after %d looks: %s", r.looks, status_name(r.status));
        met += r.status == WHEN_MEET;
        real end = r.status == WHEN_MEET ? r.time : 10;
        for (int m = 1; m <= 100; m++) {
            real time = end * m / 100;
            for (int i = 0; i < 6; i++)
                later[i] = vec3_add_scaled(s[i], time, v);
            gjk_result g = gjk_distance((hull){ later, 6 }, b, HUGE_VAL, NULL);
            if (m == 100 && r.status == WHEN_MEET)
                ck_assert_msg(g.distance <= 2 * WITHIN, "at the meeting they "
                              "are %g m apart", g.distance);
            else
                ck_assert_msg(g.status == GJK_APART, "they overlap at %g s, and"
                              " are said to meet at %g s", time, end);
        }
    }
    ck_assert_msg(met > 20 && met < 90, "%d of 100 meet: both kinds are to be "
                  "tried", met);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        point_flies_at_a_box,
        oblique_flight_takes_some_jumps,
        box_meets_box,
        bullet_does_not_fly_through_a_sheet,
        overtaking_takes_longer,
        side_by_side_is_never,
        leaving_is_never,
        passing_by_is_never,
        too_late_is_never,
        overlap_is_now,
        cap_is_kept,
        what_is_not_finite_is_said,
        nobody_has_touched_before,
        NULL
    };
    return suite_run((suite){ .name = "when", .tests = tests });
}
