// check_rest.c - who sleeps with whom, and who wakes whom?  Book: chapter 9.

#include <check.h>
#include <limits.h>
#include <stdlib.h>

#include "rest.h"
#include "scarce.h"

// A power of two: its sums have no rounding, so that a body is calm for exactly
// 0.5 s after eight frames.
#define DT 0.0625
#define PATIENCE 0.5

enum { MANY = 64 };

static rest_state rest;
static char slow[MANY];

// `bodies` bodies, all slow.
static void begin(int bodies)
{
    ck_assert(rest_init(&rest, bodies).ok);
    for (int b = 0; b < bodies; b++) slow[b] = 1;
}

static void tear_down(void)
{
    rest_free(&rest);
}

// n frames in which the pairs of `touching` (closed by a negative number)
// touch.
static void frames(int n, const int *touching)
{
    for (int k = 0; k < n; k++) {
        rest_begin(&rest);
        for (const int *t = touching; t && *t >= 0; t += 2)
            rest_touch(&rest, t[0], t[1]);
        rest_end(&rest, slow, DT, PATIENCE);
    }
}

static void asleep_are(const char *wanted)
{
    for (int b = 0; b < rest.bodies; b++)
        ck_assert_msg(rest.asleep[b] == (wanted[b] == 'z'),
                      "body %d is %s; wanted %s", b,
                      rest.asleep[b] ? "asleep" : "awake", wanted);
}

// Rejects: bodies that are born asleep, or born calm.
START_TEST(everybody_is_born_awake)
{
    begin(3);
    asleep_are("...");
    for (int b = 0; b < 3; b++) ck_assert(rest.calm[b] == 0);
}
END_TEST

// Rejects: patience one frame too short, or never at its end.
START_TEST(calm_body_sleeps_when_its_patience_is_over)
{
    begin(1);
    frames(7, NULL);
    asleep_are(".");
    frames(1, NULL);
    asleep_are("z");
}
END_TEST

// Rejects: calm that is only counted down, or halved, by a jolt.
START_TEST(one_quick_frame_starts_the_patience_anew)
{
    begin(1);
    frames(7, NULL);
    slow[0] = 0;
    frames(1, NULL);
    ck_assert(rest.calm[0] == 0);
    slow[0] = 1;
    frames(7, NULL);
    asleep_are(".");
    frames(1, NULL);
    asleep_are("z");
}
END_TEST

// Rejects: a body that sleeps while what it lies on still moves; islands that
// join only pairs, not chains.
START_TEST(island_sleeps_only_when_all_of_it_is_calm)
{
    // 4 - 1 - 3 - 0 in a chain, 2 alone, told in an order that needs both ends
    // of two chains to be joined.
    const int chain[] = { 3, 0, 4, 1, 1, 3, -1 };
    begin(5);
    slow[4] = 0;
    frames(20, chain);
    asleep_are("..z..");
    slow[4] = 1;
    frames(7, chain);
    asleep_are("..z..");
    frames(1, chain);
    asleep_are("zzzzz");
}
END_TEST

// Rejects: islands of yesterday that hold bodies which have parted.
START_TEST(bodies_that_part_are_islands_of_their_own)
{
    const int pair[] = { 0, 1, -1 };
    begin(2);
    slow[1] = 0;
    frames(20, pair);
    asleep_are("..");
    frames(1, NULL);
    asleep_are("z.");
}
END_TEST

// Rejects: waking of one body alone, which leaves those on it in the air;
// waking of all, which costs the other islands their rest.
START_TEST(waking_wakes_the_whole_island_and_no_other)
{
    const int pairs[] = { 0, 3, 3, 5, 1, 4, -1 };
    for (int who = 0; who < 6; who++) {
        static const char *const after[6] = {
            ".zz.z.", "z.zz.z", "zz.zzz", ".zz.z.", "z.zz.z", ".zz.z."
        };
        begin(6);
        frames(8, pairs);
        asleep_are("zzzzzz");
        rest_wake(&rest, who);
        asleep_are(after[who]);
        rest_free(&rest);
    }
}
END_TEST

// Rejects: a woken body that falls asleep again at once, in the air.
START_TEST(woken_island_must_be_patient_again)
{
    const int pair[] = { 0, 1, -1 };
    begin(2);
    frames(8, pair);
    rest_wake(&rest, 1);
    ck_assert(rest.calm[0] == 0 && rest.calm[1] == 0);
    frames(7, pair);
    asleep_are("..");
    frames(1, pair);
    asleep_are("zz");
}
END_TEST

// Rejects: waking that touches those who are awake.
START_TEST(waking_who_is_awake_changes_nothing)
{
    begin(2);
    slow[1] = 0;
    frames(9, NULL);
    asleep_are("z.");
    slow[1] = 1;
    frames(3, NULL);
    rest_wake(&rest, 1);
    asleep_are("z.");
    ck_assert(rest.calm[1] == 3 * DT);
}
END_TEST

// Nobody looks for contacts between sleepers, so nobody reports them.
// Rejects: islands that fall apart while their bodies sleep.
START_TEST(sleepers_keep_their_island_while_others_move)
{
    const int pair[] = { 0, 2, -1 };
    begin(4);
    slow[1] = slow[3] = 0;
    frames(8, pair);
    asleep_are("z.z.");
    frames(100, NULL);
    asleep_are("z.z.");
    rest_wake(&rest, 2);
    asleep_are("....");
}
END_TEST

// Rejects: a restless body that wakes sleepers by lying against them (that is
// for the step to decide).
START_TEST(restless_neighbour_lets_sleepers_sleep)
{
    const int before[] = { 0, 1, -1 }, after[] = { 1, 2, -1 };
    begin(3);
    slow[2] = 0;
    frames(8, before);
    asleep_are("zz.");
    frames(10, after);
    asleep_are("zz.");
    // It comes to rest on them, and now belongs to them.
    slow[2] = 1;
    frames(8, after);
    asleep_are("zzz");
    frames(5, NULL);
    rest_wake(&rest, 0);
    asleep_are("...");
}
END_TEST

// Rejects: an island named by a body that has left it: here both islands have
// gone through the name 0.
START_TEST(islands_that_form_later_do_not_share_a_name)
{
    const int first[] = { 0, 1, -1 }, second[] = { 0, 2, -1 };
    begin(3);
    frames(8, first);
    asleep_are("zzz");
    rest_wake(&rest, 1);            // 0 and 1
    rest_wake(&rest, 2);
    slow[1] = 0;
    frames(8, second);
    asleep_are("z.z");
    slow[1] = 1;
    frames(8, NULL);
    asleep_are("zzz");
    rest_wake(&rest, 1);
    asleep_are("z.z");
    rest_wake(&rest, 2);
    asleep_are("...");
}
END_TEST

// 1 fell asleep with 0, and has been awake since; 2 falls asleep with 0 later,
// under the number that 1 still carries.  Rejects: a waking that believes the
// old island number of a body that is awake, and takes its calm away.
START_TEST(an_old_island_number_means_nothing)
{
    const int first[] = { 0, 1, -1 }, second[] = { 0, 2, -1 };
    begin(3);
    slow[2] = 0;
    frames(8, first);
    asleep_are("zz.");
    rest_wake(&rest, 0);
    slow[1] = 0;
    slow[2] = 1;
    frames(8, second);
    asleep_are("z.z");
    slow[1] = 1;
    frames(3, NULL);
    rest_wake(&rest, 2);
    asleep_are("...");
    ck_assert(rest.calm[1] == 3 * DT);
    frames(5, NULL);
    asleep_are(".z.");
}
END_TEST

// The slow oracle: who can be reached through contacts, by colouring.
// Rejects: a union that loses a branch, or hangs.
START_TEST(islands_are_what_can_be_reached)
{
    unsigned long long seed = 5;
    for (int round = 0; round < 500; round++) {
        int touching[2 * MANY + 1], color[MANY], n = 0;
        begin(MANY);
        for (int k = 0; k < MANY * 3 / 4; k++)
            for (int side = 0; side < 2; side++) {
                seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
                touching[n++] = (int)(seed >> 33) % MANY;
            }
        touching[n] = -1;
        for (int b = 0; b < MANY; b++) color[b] = b;
        for (int again = 1; again;) {
            again = 0;
            for (int k = 0; k < n; k += 2) {
                int *a = &color[touching[k]], *b = &color[touching[k + 1]];
                if (*a == *b) continue;
                if (*a < *b) *b = *a; else *a = *b;
                again = 1;
            }
        }
        int restless = round % MANY;
        slow[restless] = 0;
        frames(8, touching);
        for (int b = 0; b < MANY; b++)
            ck_assert_int_eq(rest.asleep[b], color[b] != color[restless]);
        // Without contacts the sleepers keep their islands; those that the
        // restless one kept awake are alone, and sleep.
        int waker = (restless + 1) % MANY;
        frames(2, NULL);
        if (color[waker] != color[restless]) {
            rest_wake(&rest, waker);
            for (int b = 0; b < MANY; b++)
                ck_assert_int_eq(rest.asleep[b], color[b] != color[waker]
                                                 && b != restless);
        }
        rest_free(&rest);
    }
}
END_TEST

// Rejects: an empty world that cannot rest; memory that is left.
START_TEST(no_bodies_are_no_trouble)
{
    begin(0);
    frames(3, NULL);
    rest_free(&rest);
    rest_free(&rest);
    ck_assert_int_eq(rest.bodies, 0);
}
END_TEST

// Rejects: a leak, or half a state, when any one allocation is refused.
START_TEST(refused_memory_leaves_nothing)
{
    int n = 0;
    for (; n < 20; n++) {
        long held = blocks_held;
        mallocs_left = n;
        status s = rest_init(&rest, 3);
        mallocs_left = INT_MAX;
        if (s.ok) break;
        held = blocks_held - held;
        ck_assert_str_eq(s.why, "out of memory");
        ck_assert(!rest.parent && !rest.island && !rest.calm && !rest.asleep
                  && !rest.restless && rest.bodies == 0);
        ck_assert_int_eq(held, 0);
    }
    ck_assert_int_eq(n, 5);
}
END_TEST

int main(void)
{
    const TTest *const test[] = {
        everybody_is_born_awake,
        calm_body_sleeps_when_its_patience_is_over,
        one_quick_frame_starts_the_patience_anew,
        island_sleeps_only_when_all_of_it_is_calm,
        bodies_that_part_are_islands_of_their_own,
        waking_wakes_the_whole_island_and_no_other,
        woken_island_must_be_patient_again,
        waking_who_is_awake_changes_nothing,
        sleepers_keep_their_island_while_others_move,
        restless_neighbour_lets_sleepers_sleep,
        islands_that_form_later_do_not_share_a_name,
        an_old_island_number_means_nothing,
        islands_are_what_can_be_reached,
        no_bodies_are_no_trouble,
        refused_memory_leaves_nothing,
    };
    Suite *s = suite_create("rest");
    TCase *t = tcase_create("rest");
    tcase_add_checked_fixture(t, NULL, tear_down);
    for (size_t i = 0; i < sizeof test / sizeof *test; i++)
        tcase_add_test(t, test[i]);
    suite_add_tcase(s, t);
    SRunner *runner = srunner_create(s);
    srunner_run_all(runner, CK_NORMAL);
    int failed = srunner_ntests_failed(runner);
    srunner_free(runner);
    return failed != 0;
}
