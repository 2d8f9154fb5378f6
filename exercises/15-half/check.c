// check.c - tests of the exercise 15/half.

#include "half.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>
#include <string.h>

static const real ROUNDING = 1e-15;

enum { MOST = 32 };

static vec3 at[MOST];
static half_link link[MOST];
static real room[MOST];

static unsigned long long seed = 45;

// Asks in memory that ends behind the last point and link.
static void ask(int points, int links, real most)
{
    vec3 *p = malloc((size_t)points * sizeof *p);
    half_link *l = malloc((size_t)(links + 1) * sizeof *l);
    real *r = malloc((size_t)points * sizeof *r);
    ck_assert(p && l && r);
    memcpy(p, at, (size_t)points * sizeof *p);
    memcpy(l, link, (size_t)links * sizeof *l);
    half_distances(p, points, l, links, most, r);
    memcpy(room, r, (size_t)points * sizeof *r);
    free(p);
    free(l);
    free(r);
}

START_TEST(link_and_point_share_their_distance)
{
    // A link of 4 m, a point 2 m above its middle, and a link far away.
    // Rejects: ends that are forgotten; the nearest end for the nearest point.
    at[0] = vec3_make(-2, 0, 0);
    at[1] = vec3_make(2, 0, 0);
    at[2] = vec3_make(100, 100, 0);
    at[3] = vec3_make(101, 100, 0);
    at[4] = vec3_make(0, 2, 0);
    link[0] = (half_link){ 2, 3 };
    link[1] = (half_link){ 0, 1 };
    ask(5, 2, 9);
    near(room[4], 0.9, ROUNDING, "room of the point");
    near(room[0], 0.9, ROUNDING, "room of one end");
    near(room[1], 0.9, ROUNDING, "room of the other");
    near(room[2], 9, 0, "room of who is far away");
    ask(5, 2, 0.25);
    for (int i = 0; i < 5; i++) near(room[i], 0.25, 0, "at most this much");
    ask(5, 0, 7);
    near(room[4], 7, 0, "room without links");
}
END_TEST

START_TEST(nearest_point_may_be_an_end)
{
    at[0] = vec3_make(0, 0, 0);
    at[1] = vec3_make(2, 0, 0);
    link[0] = (half_link){ 1, 0 };
    at[2] = vec3_make(5, 4, 0);
    ask(3, 1, 9);
    near(room[2], 0.45 * 5, ROUNDING, "room of a point beyond one end");
    at[2] = vec3_make(-0.6, -0.8, 0);
    ask(3, 1, 9);
    near(room[2], 0.45, ROUNDING, "room of a point beyond the other");
    at[2] = vec3_make(1, 0, 0);
    ask(3, 1, 9);
    near(room[0] + room[1] + room[2], 0, 0, "rooms of those that touch");
}
END_TEST

START_TEST(link_without_length_is_a_point)
{
    at[0] = at[1] = vec3_make(1, 1, 0);
    at[2] = vec3_make(4, 5, 0);
    link[0] = (half_link){ 0, 1 };
    ask(3, 1, 9);
    for (int i = 0; i < 3; i++) near(room[i], 2.25, ROUNDING, "room");
}
END_TEST

START_TEST(who_may_go_gets_his_wish)
{
    // To the last bit.
    vec3 want[2] = { { 0.1, 0.2, 0 }, { 1.0 / 3, 0, 0 } };
    const real space[2] = { 1, 1 };
    at[0] = vec3_make(1e-17, 0.1, 0);
    at[1] = vec3_make(0.7, -0.3, 0);
    ck_assert_int_eq(half_move(at, 2, want, space), 0);
    for (int i = 0; i < 2; i++)
        ck_assert_msg(at[i].x == want[i].x && at[i].y == want[i].y, "point %d "
                      "is at (%.17g, %.17g)", i, at[i].x, at[i].y);
}
END_TEST

START_TEST(who_may_not_goes_as_far_as_he_may)
{
    vec3 want[2] = { { 3, 4, 0 }, { 0, 9, 0 } };
    const real space[2] = { 1, 0 };
    at[0] = at[1] = vec3_make(0, 0, 0);
    ck_assert_int_eq(half_move(at, 2, want, space), 2);
    near(at[0].x, 0.6, ROUNDING, "x, of 1 m towards (3, 4)");
    near(at[0].y, 0.8, ROUNDING, "y, of 1 m towards (3, 4)");
    near(at[1].y, 0, 0, "y of who has no room");
}
END_TEST

START_TEST(what_is_no_number_moves_nobody)
{
    const real none = (real)NAN, space[3] = { 1, 1, 1 };
    vec3 want[3] = { { none, 0, 0 }, { HUGE_VAL, 0, 0 }, { 0, -none, 0 } };
    for (int i = 0; i < 3; i++) at[i] = vec3_make(i, 2, 0);
    ck_assert_int_eq(half_move(at, 3, want, space), 3);
    for (int i = 0; i < 3; i++)
        ck_assert_msg(at[i].x == i && at[i].y == 2, "point %d is at (%g, %g)",
                      i, at[i].x, at[i].y);
    at[2].x = none;
    link[0] = (half_link){ 0, 1 };
    ask(3, 1, 1);
    near(room[0] + room[1] + room[2], 0, 0, "room beside a lost point");
}
END_TEST

// Twice the area of a triangle, positive if it turns left.
static real turn(vec3 a, vec3 b, vec3 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

static int cross(vec3 a, vec3 b, vec3 c, vec3 d)
{
    return turn(a, b, c) * turn(a, b, d) < 0
        && turn(c, d, a) * turn(c, d, b) < 0;
}

// Shoves all points as far as 50 m, within their halves; looks at all links 8
// times on the way.
static void shove(int points, int links, int round)
{
    vec3 want[MOST], was[MOST], now[MOST];
    for (int i = 0; i < points; i++) {
        want[i] =
            vec3_make(50 * random_real(&seed), 50 * random_real(&seed), 0);
        if (round % 2) want[i] = vec3_add_scaled(at[i], 0.1, want[i]);
        was[i] = at[i];
    }
    ask(points, links, 1);
    half_move(at, points, want, room);
    for (int step = 1; step <= 8; step++) {
        for (int i = 0; i < points; i++)
            now[i] = vec3_add_scaled(vec3_scale(1 - step / 8.0, was[i]),
                                     step / 8.0, at[i]);
        for (int k = 0; k < links; k++)
            for (int m = 0; m < k; m++) {
                half_link s = link[k], t = link[m];
                if (s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b)
                    continue;
                ck_assert_msg(!cross(now[s.a], now[s.b], now[t.a], now[t.b]),
                              "links %d and %d cross in round %d", m, k, round);
            }
    }
}

START_TEST(chains_never_cross)
{
    // Two of 9 links each, side by side.  Each shove may leave a tenth of a
    // distance: after ten of them they begin anew.
    for (int k = 0; k < 18; k++)
        link[k] = (half_link){ k < 9 ? k : k + 1, k < 9 ? k + 1 : k + 2 };
    for (int round = 0; round < 150; round++) {
        for (int i = 0; i < 20 && round % 10 == 0; i++)
            at[i] = vec3_make(0.1 * (i % 10), i < 10 ? 0 : 0.05, 0);
        shove(20, 18, round);
    }
}
END_TEST

START_TEST(spider_stays_in_its_ring)
{
    // It is inside as long as the ring turns around it once.
    enum { RING = 12 };
    for (int round = 0; round < 150; round++) {
        real around = 0;
        for (int i = 0; i < RING && round % 10 == 0; i++) {
            at[i] = vec3_make(cos(i * 0.5235987755982988),
                              sin(i * 0.5235987755982988), 0);
            link[i] = (half_link){ i, (i + 1) % RING };
        }
        if (round % 10 == 0) at[RING] = vec3_make(0.9, 0, 0);
        shove(RING + 1, RING, round);
        for (int i = 0; i < RING; i++) {
            vec3 a = vec3_sub(at[i], at[RING]);
            vec3 b = vec3_sub(at[(i + 1) % RING], at[RING]);
            around += atan2(a.x * b.y - a.y * b.x, vec3_dot(a, b));
        }
        ck_assert_msg(fabs(around - 6.283185307179586) < 1e-6, "round %d: the "
                      "ring turns around the spider by %g", round, around);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        link_and_point_share_their_distance,
        nearest_point_may_be_an_end,
        link_without_length_is_a_point,
        who_may_go_gets_his_wish,
        who_may_not_goes_as_far_as_he_may,
        what_is_no_number_moves_nobody,
        chains_never_cross,
        spider_stays_in_its_ring,
        NULL
    };
    return suite_run((suite){ .name = "half", .tests = tests });
}
