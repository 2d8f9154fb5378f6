// check.c - tests of the exercise 14/list.

#include "list.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>

enum { MOST = 200, ALL = MOST * (MOST - 1) / 2 };

static vec3 at[MOST];
static near_list l;

static unsigned long long seed = 67;

// A list in memory of just its size.
static void begin(int points, real reach, real margin, int capacity)
{
    l = (near_list){ .points = points, .reach = reach, .margin = margin,
                     .capacity = capacity };
    l.pair = malloc((size_t)(capacity > 0 ? capacity : 1) * sizeof *l.pair);
    l.from = malloc((size_t)(points > 0 ? points : 1) * sizeof *l.from);
    ck_assert(l.pair && l.from);
}

static void end(void)
{
    free(l.pair);
    free(l.from);
}

// Asks with this much room, compares with all pairs; returns how many.
static int agreed(int room)
{
    int (*out)[2] = malloc((size_t)(room > 0 ? room : 1) * sizeof *out);
    ck_assert_ptr_nonnull(out);
    int got = list_pairs(&l, at, out, room), wanted = 0;
    for (int a = 0; a < l.points; a++)
        for (int b = a + 1; b < l.points; b++) {
            if (!(vec3_length_squared(vec3_sub(at[a], at[b]))
                  <= l.reach * l.reach)) continue;
            if (wanted < room && wanted < got)
                ck_assert_msg(out[wanted][0] == a && out[wanted][1] == b,
                              "pair %d is (%d, %d), wanted (%d, %d)", wanted,
                              out[wanted][0], out[wanted][1], a, b);
            wanted++;
        }
    ck_assert_msg(got == wanted, "%d pairs, wanted %d", got, wanted);
    free(out);
    return got;
}

static void row(int n, real apart)
{
    for (int i = 0; i < n; i++) at[i] = vec3_make(i * apart, 0, 0);
}

START_TEST(first_question_makes_a_list)
{
    // Five in a row, 1 m apart; reach 1 m, and up to 2 m in the list.
    begin(5, 1, 1, ALL);
    row(5, 1);
    for (int i = 0; i < 5; i++) l.from[i] = at[i];
    ck_assert_msg(!list_is_good(&l, at), "no list has been made yet");
    ck_assert_int_eq(agreed(ALL), 4);
    ck_assert_msg(l.pairs == 7, "%d pairs in the list: wanted 4 that are 1 m "
                  "apart and 3 that are 2 m apart", l.pairs);
    ck_assert_int_eq(l.made, 1);
    ck_assert_int_eq(agreed(ALL), 4);
    ck_assert_msg(l.made == 1, "nobody has moved: %d lists made", l.made);
    end();
}
END_TEST

START_TEST(list_is_good_until_two_could_have_met)
{
    // Far apart, with reach 1 and margin 1/2.  One alone may move by 1/2; or
    // one by 3/8 and one by 1/8.
    begin(4, 1, 0.5, ALL);
    row(4, 10);
    agreed(ALL);
    at[2].y = 0.5;
    ck_assert_msg(list_is_good(&l, at), "one moved by the margin, and nobody "
                  "else: the list is good");
    at[2].y = 0.501;
    ck_assert_msg(!list_is_good(&l, at), "one moved by more than the margin");
    at[2].y = 0.375;
    at[3].z = 0.125;
    ck_assert_msg(list_is_good(&l, at), "by 3/8 and 1/8: just good");
    at[3].z = 0.126;
    ck_assert_msg(!list_is_good(&l, at), "by 3/8 and a little more than 1/8");
    for (int i = 0; i < 4; i++) at[i].y = 0.25, at[i].z = 0;
    ck_assert_msg(list_is_good(&l, at), "all by half the margin: just good");
    end();
}
END_TEST

START_TEST(the_two_that_moved_furthest_count_in_any_order)
{
    // Rejects: a second that is lost, or not seen.
    for (int first = 0; first < 5; first++)
        for (int second = 0; second < 5; second++) {
            if (first == second) continue;
            begin(5, 1, 0.5, ALL);
            row(5, 10);
            agreed(ALL);
            for (int i = 0; i < 5; i++) at[i].y += 0.125;
            at[first].y += 0.25;
            at[second].y += 0.0625;
            ck_assert_msg(!list_is_good(&l, at), "point %d moved by 0.375, "
                          "point %d by 0.1875, margin 0.5", first, second);
            end();
        }
}
END_TEST

START_TEST(slow_drift_makes_a_new_list_in_time)
{
    // One comes from afar by 1/16 m a frame.  Rejects: a margin that is
    // measured from the last frame.
    begin(2, 1, 1, ALL);
    row(2, 20);
    for (int frame = 0; frame < 320; frame++) {
        agreed(ALL);
        at[1].x -= 0.0625;
    }
    ck_assert_msg(l.made >= 18 && l.made <= 20, "20 m at a margin of 1 m: %d "
                  "lists made, wanted 19 or so", l.made);
    end();
}
END_TEST

START_TEST(frames_agree_with_all_pairs)
{
    // 200 points wander about a room for 500 frames.
    static vec3 speed[MOST];
    begin(MOST, 1, 0.5, ALL);
    for (int i = 0; i < MOST; i++) {
        at[i] = random_vec3(&seed, 4);
        speed[i] = random_vec3(&seed, 0.01);
    }
    for (int frame = 0; frame < 500; frame++) {
        for (int i = 0; i < MOST; i++) {
            at[i] = vec3_add(at[i], speed[i]);
            if (fabs(at[i].x) > 4) speed[i].x = -speed[i].x;
            if (fabs(at[i].y) > 4) speed[i].y = -speed[i].y;
            if (fabs(at[i].z) > 4) speed[i].z = -speed[i].z;
        }
        agreed(ALL);
    }
    ck_assert_msg(l.made > 20 && l.made < 100, "%d lists in 500 frames",
                  l.made);
    end();
}
END_TEST

START_TEST(too_little_room_loses_nobody)
{
    // In the list, in the answer, in both.
    row(30, 0.25);
    for (int capacity = 0; capacity < 300; capacity += 7)
        for (int room = 0; room < 200; room += 9) {
            begin(30, 1, 0.5, capacity);
            int n = agreed(room);
            ck_assert_int_eq(n, 110);
            agreed(room);
            end();
        }
}
END_TEST

START_TEST(lost_point_does_no_harm)
{
    // It is near nobody, and each frame with it makes a list anew.
    begin(6, 1, 0.5, ALL);
    row(6, 1);
    ck_assert_int_eq(agreed(ALL), 5);
    at[2].y = (real)NAN;
    ck_assert_int_eq(agreed(ALL), 3);
    ck_assert_msg(!list_is_good(&l, at), "a point is no number");
    at[5].x = HUGE_VAL;
    ck_assert_int_eq(agreed(ALL), 2);
    row(6, 1);
    ck_assert_int_eq(agreed(ALL), 5);
    end();
}
END_TEST

START_TEST(nobody_has_no_neighbours)
{
    begin(0, 1, 1, 0);
    ck_assert_int_eq(agreed(0), 0);
    end();
    begin(1, 1, 0, 0);
    ck_assert_int_eq(agreed(0), 0);
    end();
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        first_question_makes_a_list,
        list_is_good_until_two_could_have_met,
        the_two_that_moved_furthest_count_in_any_order,
        slow_drift_makes_a_new_list_in_time,
        frames_agree_with_all_pairs,
        too_little_room_loses_nobody,
        lost_point_does_no_harm,
        nobody_has_no_neighbours,
        NULL
    };
    return suite_run((suite){ .name = "list", .tests = tests });
}
