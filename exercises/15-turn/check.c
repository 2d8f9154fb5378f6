// check.c - tests of the exercise 15/turn.

#include "turn.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>

static const real WITHIN = 1e-6, SOON = 1e-5;
static const real PI = 3.14159265358979324;
static const vec3 NONE = { 0, 0, 0 }, Z = { 0, 0, 1 };

enum { CAP = 1000 };

static turning box(vec3 at[8], vec3 center, vec3 half)
{
    for (int i = 0; i < 8; i++)
        at[i] = vec3_add(center, vec3_make(i & 1 ? half.x : -half.x,
                                           i & 2 ? half.y : -half.y,
                                           i & 4 ? half.z : -half.z));
    return (turning){ { at, 8 }, center, NONE, Z, 0 };
}

static turning rod(vec3 at[2], vec3 center, vec3 half)
{
    at[0] = vec3_sub(center, half);
    at[1] = vec3_add(center, half);
    return (turning){ { at, 2 }, center, NONE, Z, 0 };
}

static turning floor_box(vec3 at[8])
{
    return box(at, vec3_make(0, -1, 0), vec3_make(50, 1, 50));
}

// Asks with room that ends behind the last point.
static turn_result ask(const turning *a, const turning *b, int cap)
{
    vec3 *room = malloc((size_t)(a->shape.count + b->shape.count)
                        * sizeof *room);
    ck_assert_ptr_nonnull(room);
    turn_result r = turn_first_touch(a, b, WITHIN, cap, room);
    free(room);
    return r;
}

static void expect(turn_result r, turn_status wanted, const char *what)
{
    static const char *name[] = { "TURN_TOUCH", "TURN_NEVER", "TURN_CAPPED",
                                  "TURN_NOT_FINITE" };
    ck_assert_msg(r.status == wanted, "%s: the status is %s, wanted %s", what,
                  r.status <= TURN_NOT_FINITE ? name[r.status] : "none",
                  name[wanted]);
    if (wanted == TURN_NEVER)
        ck_assert_msg(r.time == 0 && vec3_length(r.normal) == 0, "%s: never has"
                      " no time and no normal", what);
}

static unsigned long long seed = 41;

START_TEST(place_of_a_point_that_turns)
{
    // 1 m from the center along x, a quarter turn about z; and 2 m along z.
    vec3 p = { 6, 5, 7 }, *out = malloc(sizeof *out);
    ck_assert_ptr_nonnull(out);
    turning b = { { &p, 1 }, { 5, 5, 5 }, { 8, 0, 0 }, Z, PI };
    turning_at(&b, 0.5, out);
    near(out->x, 9, 1e-12, "x: the center has gone 4 m");
    near(out->y, 6, 1e-12, "y: the point has turned there");
    near(out->z, 7, 1e-12, "z: along the axis");
    turning_at(&b, 0, out);
    near(vec3_distance(*out, p), 0, 1e-12, "way at time 0");
    free(out);
}
END_TEST

START_TEST(end_of_a_rod_meets_the_floor)
{
    // Half a rod of 1 m, 0.5 m above the floor: sin = 0.5, 30 degrees of 90.
    // Both ways round.
    vec3 rt[2], ft[8];
    turning f = floor_box(ft);
    for (int sign = -1; sign < 2; sign += 2) {
        turning r = rod(rt, vec3_make(0, 0.5, 0), vec3_make(1, 0, 0));
        r.angle = sign * PI / 2;
        turn_result t = ask(&r, &f, CAP);
        expect(t, TURN_TOUCH, "a rod turns to the floor");
        near(t.time, 1 / 3.0, SOON, "30 of 90 degrees");
        near(t.normal.y, 1, 1e-9, "normal");
    }
}
END_TEST

START_TEST(coin_that_spins_on_a_table_never_touches)
{
    // A millimetre above it, ten turns a frame, and it slides.
    vec3 ct[8], ft[8];
    turning f = floor_box(ft);
    turning c = box(ct, vec3_make(0, 0.011, 0), vec3_make(0.1, 0.01, 0.1));
    c.axis = vec3_make(0, 1, 0);
    c.angle = 20 * PI;
    c.way = vec3_make(3, 0, 0);
    turn_result t = ask(&c, &f, CAP);
    expect(t, TURN_NEVER, "a spinning coin");
    ck_assert_msg(t.looks <= 3, "it comes no nearer: %d looks", t.looks);
}
END_TEST

START_TEST(both_may_turn)
{
    // Two rods of 2 m, one above the other by 1.5 m, upright in the end: they
    // meet when sin of both adds up to 1.5; 2 sin = 1.5.
    vec3 at[2], bt[2];
    turning a = rod(at, vec3_make(0, 1.5, 0), vec3_make(1, 0, 0));
    turning b = rod(bt, NONE, vec3_make(1, 0, 0));
    a.angle = -PI / 2;
    b.angle = PI / 2;
    turn_result t = ask(&a, &b, CAP);
    expect(t, TURN_TOUCH, "two rods");
    near(t.time, asin(0.75) / (PI / 2), SOON, "time of two rods");
    turning still = rod(at, vec3_make(0, 0.5, 0), vec3_make(1, 0, 0));
    t = ask(&still, &b, CAP);
    expect(t, TURN_TOUCH, "B alone turns");
}
END_TEST

START_TEST(ways_count_as_seen_from_each_other)
{
    vec3 at[8], bt[8];
    turning a = box(at, vec3_make(10, 0, 0), vec3_make(1, 1, 1));
    turning b = box(bt, NONE, vec3_make(1, 1, 1));
    a.way = vec3_make(-4, 7, 0);
    b.way = vec3_make(12, 7, 0);
    turn_result t = ask(&a, &b, CAP);
    expect(t, TURN_TOUCH, "8 m at 16 m a frame");
    near(t.time, 0.5, SOON, "8 m at 16 m a frame");
    near(t.normal.x, 1, 1e-9, "normal");
}
END_TEST

START_TEST(bat_hits_a_ball)
{
    // The bat turns by half a turn about its grip; the ball comes across, and
    // is where the bat's end is after a quarter turn.
    vec3 at[2], ball = { -0.5, 0.9, 0 };
    turning bat = rod(at, vec3_make(0.5, 0, 0), vec3_make(0.5, 0, 0));
    bat.center = NONE;
    bat.angle = PI;
    turning b = { { &ball, 1 }, ball, { 1, 0, 0 }, Z, 0 };
    turn_result t = ask(&bat, &b, CAP);
    expect(t, TURN_TOUCH, "a bat");
    near(t.time, 0.5, SOON, "a quarter of a turn");
}
END_TEST

START_TEST(frame_has_an_end)
{
    vec3 rt[2], ft[8];
    turning f = floor_box(ft);
    turning r = rod(rt, vec3_make(0, 0.5, 0), vec3_make(1, 0, 0));
    r.angle = 29 * PI / 180;
    expect(ask(&r, &f, CAP), TURN_NEVER, "29 degrees: one is missing");
    r.angle = 31 * PI / 180;
    expect(ask(&r, &f, CAP), TURN_TOUCH, "31 degrees");
    r.angle = 31 * PI / 180;
    turn_result t = ask(&r, &f, 1);
    expect(t, TURN_CAPPED, "one look");
    ck_assert_msg(t.looks == 1 && t.time > 0 && t.time < 30.0 / 31,
                  "one look, and surely nothing before %g", t.time);
}
END_TEST

START_TEST(nobody_moves_and_nobody_touches)
{
    vec3 at[8], bt[8];
    turning a = box(at, vec3_make(3, 0, 0), vec3_make(1, 1, 1));
    turning b = box(bt, NONE, vec3_make(1, 1, 1));
    expect(ask(&a, &b, CAP), TURN_NEVER, "nobody moves");
    a.way = vec3_make(3, 0, 0);
    expect(ask(&a, &b, CAP), TURN_NEVER, "it leaves");
    turning c = box(at, vec3_make(1, 0, 0), vec3_make(1, 1, 1));
    turn_result t = ask(&c, &b, CAP);
    expect(t, TURN_TOUCH, "they overlap");
    ck_assert(t.time == 0 && vec3_length(t.normal) == 0);
    b.way.y = (real)NAN;
    expect(ask(&a, &b, CAP), TURN_NOT_FINITE, "a NaN, after the first look or "
           "at it");
}
END_TEST

START_TEST(nobody_has_touched_before)
{
    // Random hulls that fly and turn.  At the touch the gap is closed; at 50
    // moments before it is open.
    int met = 0;
    for (int round = 0; round < 200; round++) {
        vec3 s[6], t[6], x[6], y[6];
        turning b[2] = { { { s, 6 }, { 3, 0, 0 }, { -3, 0, 0 }, Z,
                           4 * random_real(&seed) },
                         { { t, 6 }, NONE, random_vec3(&seed, 1), Z,
                           4 * random_real(&seed) } };
        for (int i = 0; i < 6; i++) {
            s[i] = vec3_add(b[0].center, random_vec3(&seed, 1));
            t[i] = random_vec3(&seed, 1);
        }
        for (int k = 0; k < 2; k++)
            b[k].axis = vec3_unit(vec3_add(Z, random_vec3(&seed, 0.9)));
        turn_result r = ask(&b[0], &b[1], CAP);
        ck_assert_msg(r.status == TURN_TOUCH || r.status == TURN_NEVER,
                      "status %d after %d looks", (int)r.status, r.looks);
        met += r.status == TURN_TOUCH;
        real end = r.status == TURN_TOUCH ? r.time : 1;
        for (int m = 1; m <= 50; m++) {
            turning_at(&b[0], end * m / 50, x);
            turning_at(&b[1], end * m / 50, y);
            gjk_result g = gjk_distance((hull){ x, 6 },
                                        (hull){ y, 6 }, HUGE_VAL, NULL);
            if (m == 50 && r.status == TURN_TOUCH)
                near(g.distance, 0, 2 * WITHIN, "gap at the touch");
            else
                ck_assert_msg(g.status == GJK_APART, "they overlap at %g, and "
                              "are said to touch at %g", end * m / 50, end);
        }
    }
    ck_assert_msg(met > 50 && met < 195, "%d of 200 touch: both kinds are to "
                  "be tried", met);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        place_of_a_point_that_turns,
        end_of_a_rod_meets_the_floor,
        coin_that_spins_on_a_table_never_touches,
        both_may_turn,
        ways_count_as_seen_from_each_other,
        bat_hits_a_ball,
        frame_has_an_end,
        nobody_moves_and_nobody_touches,
        nobody_has_touched_before,
        NULL
    };
    return suite_run((suite){ .name = "turn", .tests = tests });
}
