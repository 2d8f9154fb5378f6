// check.c - tests of the exercise 19/events.

#include "events.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>

enum { MOST = 100000 };
static id_pair before[MOST], now[MOST];
static event out[2 * MOST];

static void is_pair(id_pair p, unsigned long long a, unsigned long long b)
{
    ck_assert_msg(p.a == a && p.b == b, "got the pair (%llu, %llu), wanted (%llu, %llu)", p.a, p.b, a, b);
}

START_TEST(pairs_are_sorted_and_there_once)
{
    // Rejects: an order by the first id alone, doubles that are kept, a pair that
    // counts once in each direction.
    id_pair p[7] = { { 5, 2 }, { 1, 9 }, { 2, 5 }, { 9, 1 }, { 2, 3 }, { 4, 4 }, { 2, 5 } };
    ck_assert_int_eq(pairs_tidy(p, 7), 3);
    is_pair(p[0], 1, 9);
    is_pair(p[1], 2, 3);
    is_pair(p[2], 2, 5);
    ck_assert_int_eq(pairs_tidy(p, 0), 0);
    id_pair self[1] = { { 7, 7 } };
    ck_assert_msg(pairs_tidy(self, 1) == 0, "a body touches itself");
}
END_TEST

START_TEST(large_ids_keep_their_order)
{
    // Rejects: a difference that is cut to an int.
    id_pair p[3] = { { 1ULL << 63, 3ULL << 62 }, { 5, (1ULL << 63) + 1 }, { 5, 7 } };
    ck_assert_int_eq(pairs_tidy(p, 3), 3);
    is_pair(p[0], 5, 7);
    is_pair(p[1], 5, (1ULL << 63) + 1);
    is_pair(p[2], 1ULL << 63, 3ULL << 62);
}
END_TEST

START_TEST(new_pairs_begin_and_old_ones_end)
{
    // Rejects: began and ended exchanged, a list that is not walked to its end.
    const id_pair old[3] = { { 1, 2 }, { 1, 5 }, { 8, 9 } };
    const id_pair new[4] = { { 1, 3 }, { 1, 5 }, { 9, 10 }, { 9, 12 } };
    const event wanted[5] = { { { 1, 2 }, false }, { { 1, 3 }, true }, { { 8, 9 }, false },
                              { { 9, 10 }, true }, { { 9, 12 }, true } };
    ck_assert_int_eq(events_between(old, 3, new, 4, out, 9), 5);
    for (int i = 0; i < 5; i++) {
        is_pair(out[i].pair, wanted[i].pair.a, wanted[i].pair.b);
        ck_assert_msg(out[i].began == wanted[i].began, "event %d: %s", i, wanted[i].began ? "it began" : "it ended");
    }
}
END_TEST

START_TEST(nothing_has_happened_while_all_lies)
{
    // Rejects: an event in each frame.
    const id_pair same[2] = { { 1, 2 }, { 3, 4 } };
    ck_assert_int_eq(events_between(same, 2, same, 2, out, 9), 0);
    ck_assert_int_eq(events_between(same, 0, same, 0, out, 9), 0);
    ck_assert_int_eq(events_between(same, 2, same, 0, out, 9), 2);
    ck_assert_msg(!out[0].began && !out[1].began, "all has ended");
    ck_assert_int_eq(events_between(same, 0, same, 2, out, 9), 2);
    ck_assert_msg(out[0].began && out[1].began, "all has begun");
}
END_TEST

START_TEST(room_is_not_overstepped)
{
    // Rejects: a write past the end, a count that stops with the room.
    const id_pair new[3] = { { 1, 2 }, { 3, 4 }, { 5, 6 } };
    event few[2] = { { { 0, 0 }, false }, { { 77, 77 }, false } };
    ck_assert_msg(events_between(NULL, 0, new, 3, few, 1) == 3, "there are three events, however little room there is");
    is_pair(few[0].pair, 1, 2);
    is_pair(few[1].pair, 77, 77);
    ck_assert_int_eq(events_between(NULL, 0, new, 3, NULL, 0), 3);
}
END_TEST

static int has(const id_pair *list, int n, id_pair p)
{
    for (int i = 0; i < n; i++) if (list[i].a == p.a && list[i].b == p.b) return 1;
    return 0;
}

START_TEST(random_lists_have_the_events_of_a_slow_search)
{
    unsigned long long seed = 19;
    for (int round = 0; round < 2000; round++) {
        int olds = random_below(&seed, 12), news = random_below(&seed, 12), events = 0;
        for (int i = 0; i < 12; i++) {
            before[i] = (id_pair){ (unsigned)random_below(&seed, 6), (unsigned)random_below(&seed, 6) };
            now[i] = (id_pair){ (unsigned)random_below(&seed, 6), (unsigned)random_below(&seed, 6) };
        }
        olds = pairs_tidy(before, olds);
        news = pairs_tidy(now, news);
        for (int i = 0; i < olds; i++) events += !has(now, news, before[i]);
        for (int i = 0; i < news; i++) events += !has(before, olds, now[i]);
        ck_assert_int_eq(events_between(before, olds, now, news, out, 99), events);
        for (int i = 0; i < events; i++)
            ck_assert_msg(out[i].began == has(now, news, out[i].pair), "what began is in the new list");
    }
}
END_TEST

START_TEST(hundred_thousand_pairs_take_no_time)
{
    // Rejects: a search through the whole list for each pair.
    unsigned long long seed = 7;
    for (int i = 0; i < MOST; i++) {
        before[i] = (id_pair){ random_bits(&seed) >> 40, random_bits(&seed) >> 40 };
        now[i] = i % 2 ? before[i] : (id_pair){ random_bits(&seed) >> 40, random_bits(&seed) >> 40 };
    }
    int olds = pairs_tidy(before, MOST), news = pairs_tidy(now, MOST);
    int events = events_between(before, olds, now, news, out, 2 * MOST);
    ck_assert_msg(events >= 99000 && events <= 100000, "there are %d events, and about half of all pairs are new", events);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        pairs_are_sorted_and_there_once,
        large_ids_keep_their_order,
        new_pairs_begin_and_old_ones_end,
        nothing_has_happened_while_all_lies,
        room_is_not_overstepped,
        random_lists_have_the_events_of_a_slow_search,
        hundred_thousand_pairs_take_no_time,
        NULL
    };
    return suite_run((suite){ .name = "events", .tests = tests });
}
