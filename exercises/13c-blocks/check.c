// check.c - tests of the exercise 13c/blocks.

#include "blocks.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>

enum { MOST = 100000, BODIES = 40000 };
static meeting m[MOST];
static int *lane, *scratch, count, bodies, degree[BODIES];

static void set_up(void)
{
    lane = malloc(LANES * MOST * sizeof *lane);
    ck_assert_ptr_nonnull(lane);
    count = bodies = 0;
}

static void tear_down(void)
{
    free(lane);
}

static void meet(int a, int b)
{
    m[count++] = (meeting){ a, b };
    bodies = a >= bodies ? a + 1 : bodies;
    bodies = b >= bodies ? b + 1 : bodies;
}

// In memory of just that size.  What is in lanes beyond the blocks is left over.
static int fill(void)
{
    scratch = malloc((size_t)(bodies + count) * sizeof *scratch + 1);
    ck_assert_ptr_nonnull(scratch);
    for (int k = 0; k < bodies + count; k++) scratch[k] = 12345;
    for (int k = 0; k < LANES * count; k++) lane[k] = -7;
    int blocks = blocks_fill(m, count, bodies, lane, scratch);
    free(scratch);
    ck_assert_msg(blocks >= 0 && blocks <= count, "%d blocks of %d contacts", blocks, count);
    return blocks;
}

static void all_are_there(int blocks)
{
    static int seen[MOST];
    for (int k = 0; k < count; k++) seen[k] = 0;
    for (int k = 0; k < LANES * blocks; k++) {
        ck_assert_msg(lane[k] >= -1 && lane[k] < count, "lane %d of block %d holds %d", k % LANES, k / LANES, lane[k]);
        if (lane[k] >= 0) seen[lane[k]]++;
    }
    for (int k = 0; k < count; k++) ck_assert_msg(seen[k] == 1, "contact %d is in %d lanes", k, seen[k]);
}

static bool share(meeting a, meeting b)
{
    return (a.a >= 0 && (a.a == b.a || a.a == b.b)) || (a.b >= 0 && (a.b == b.a || a.b == b.b));
}

static void none_share(int blocks)
{
    for (int k = 0; k < blocks; k++)
        for (int i = 0; i < LANES; i++)
            for (int j = 0; j < i; j++) {
                int p = lane[LANES * k + i], q = lane[LANES * k + j];
                ck_assert_msg(p < 0 || q < 0 || !share(m[p], m[q]), "block %d has the contacts %d and %d, which share a body",
                              k, q, p);
            }
}

// The most contacts that one body has.
static int most_of_one(void)
{
    int most = 0;
    for (int i = 0; i < bodies; i++) degree[i] = 0;
    for (int k = 0; k < count; k++) {
        if (m[k].a >= 0) most = degree[m[k].a]++ >= most ? degree[m[k].a] : most;
        if (m[k].b >= 0) most = degree[m[k].b]++ >= most ? degree[m[k].b] : most;
    }
    return most;
}

static int sound(void)
{
    int blocks = fill(), most = count / LANES + 2 * most_of_one();
    all_are_there(blocks);
    none_share(blocks);
    ck_assert_msg(blocks <= most, "%d contacts take %d blocks; count / 4 + 2 d is %d", count, blocks, most);
    return blocks;
}

static void heap(unsigned long long seed, int of, int contacts)
{
    count = bodies = 0;
    while (count < contacts) {
        int a = random_below(&seed, of), b = random_below(&seed, of + of / 4 + 1);
        if (b >= of) b = -1;
        if (a == b) continue;
        if (random_below(&seed, 2)) meet(a, b);
        else meet(b, a);
    }
}

START_TEST(every_contact_is_in_one_lane)
{
    // Rejects: a last block that is lost, one contact twice.
    for (int k = 0; k < 9; k++) {
        count = bodies = 0;
        for (int i = 0; i < k; i++) meet(2 * i, 2 * i + 1);
        int blocks = fill();
        all_are_there(blocks);
        ck_assert_msg(blocks == (k + 3) / 4, "%d contacts that share nothing take %d blocks", k, blocks);
    }
}
END_TEST

START_TEST(no_body_is_twice_in_a_block)
{
    // A pile: two colours, upwards in turn.  A ring of seven: three.
    // Rejects: contacts in their order, a look at one of the two bodies only.
    for (int i = 0; i < 10; i++) meet(i, i - 1);
    none_share(sound());
    count = bodies = 0;
    for (int i = 0; i < 7; i++) meet(i, (i + 1) % 7);
    none_share(sound());
}
END_TEST

START_TEST(what_does_not_move_is_no_body)
{
    // 40 boxes on the floor: ten full blocks.
    // Rejects: the floor as a body that can be in one lane only; last[-1].
    for (int i = 0; i < 40; i++) meet(i % 2 ? i : -1, i % 2 ? -1 : i);
    ck_assert_msg(sound() == 10, "40 boxes on the floor share nothing, and fill ten blocks");
}
END_TEST

START_TEST(body_with_hundreds_of_contacts_loses_none)
{
    // 300 balls on a floor that swings, and some on each other.
    // Rejects: a set of 32 or 64 colours.
    for (int i = 1; i <= 300; i++) meet(0, i);
    for (int i = 1; i < 300; i += 2) meet(i, i + 1);
    none_share(sound());
}
END_TEST

START_TEST(random_heaps_are_sound)
{
    // Rejects: blocks that are emptier than need be.
    for (unsigned long long seed = 1; seed <= 400; seed++) {
        heap(seed, 2 + (int)(seed % 60), 1 + (int)(seed * 7 % 200));
        sound();
    }
}
END_TEST

START_TEST(blocks_are_nearly_full)
{
    // 1,000 bodies with five contacts each: a few colours, each full but for
    // its last block.
    // Rejects: a new block wherever the next contact does not fit.
    heap(5, 1000, 2500);
    int blocks = sound();
    ck_assert_msg(blocks <= 2500 / LANES + 20, "2,500 contacts take %d blocks", blocks);
}
END_TEST

START_TEST(large_heap_takes_no_time)
{
    // Rejects: each contact held against every other.
    heap(3, BODIES - 1, MOST);
    sound();
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        every_contact_is_in_one_lane,
        no_body_is_twice_in_a_block,
        what_does_not_move_is_no_body,
        body_with_hundreds_of_contacts_loses_none,
        random_heaps_are_sound,
        blocks_are_nearly_full,
        large_heap_takes_no_time,
        NULL
    };
    return suite_run((suite){ .name = "blocks", .tests = tests, .set_up = set_up, .tear_down = tear_down });
}
