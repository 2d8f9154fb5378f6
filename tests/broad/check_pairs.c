// check_pairs.c - does a list of pairs hold all that may meet, for as long as
// it is kept?  Book: chapter 14.

#include <check.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contact.h"
#include "pairs.h"
#include "random.h"
#include "scarce.h"
#include "suite.h"

enum { BODIES = 40 };

static pair_list list;
static sphere ball[BODIES];
static real reach[BODIES];
static char moves[BODIES];
static int awake[BODIES];
static pair_query query;
static int lost;

static void begin(int bodies)
{
    pair_list_free(&list);
    ck_assert(pair_list_grow(&list, bodies));
    for (int b = 0; b < bodies; b++) awake[b] = b;
    query = (pair_query){ .ball = ball, .reach = reach, .moves = moves,
                          .awake = awake, .awakes = bodies,
                          .bodies = bodies };
}

static void tear_down(void)
{
    pair_list_free(&list);
}

static bool update(void)
{
    return pair_list_update(&list, &query, &lost);
}

static unsigned long long seed = 7;

static void put(int b, real x, real radius, real far)
{
    ball[b] = (sphere){ { x, 0, 0 }, radius };
    reach[b] = far;
    moves[b] = 1;
}

static bool is_listed(int a, int b)
{
    for (int k = 0; k < list.count; k++)
        if (list.pair[k][0] == a && list.pair[k][1] == b) return true;
    return false;
}

static bool may_meet(int a, int b)
{
    real near = ball[a].radius + ball[b].radius + reach[a] + reach[b];
    if (ball[a].radius < 0 || ball[b].radius < 0) return false;
    return (moves[a] || moves[b])
        && vec3_distance(ball[a].center, ball[b].center) <= near;
}

// --- all that may meet -------------------------------------------------------

static void any_scene(void)
{
    begin(BODIES);
    for (int b = 0; b < BODIES; b++) {
        ball[b].center = random_vec3(&seed, 4);
        ball[b].radius = b % 11 == 10 ? -1 : 0.6 + random_real(&seed) / 2;
        reach[b] = 0.02 + random_real(&seed) / 60;
        moves[b] = b % 7 != 0;
    }
}

static void drift_one(int b)
{
    vec3 way = vec3_scale(reach[b] / 2, random_vec3(&seed, 1));
    if (moves[b]) ball[b].center = vec3_add(ball[b].center, way);
    reach[b] *= 1 + random_real(&seed) / 10;
}

// Every ball goes at most as far as its reach says, which changes as well.
static void drift(void)
{
    for (int b = 0; b < BODIES; b++) drift_one(b);
}

static int count_wrong_order(void)
{
    int wrong = 0;
    for (int k = 0; k < list.count; k++) {
        const int *p = list.pair[k];
        wrong += !(p[0] < p[1] && (moves[p[0]] || moves[p[1]]));
        wrong += ball[p[0]].radius < 0 || ball[p[1]].radius < 0;
        if (k == 0) continue;
        const int *q = list.pair[k - 1];
        wrong += !(q[0] < p[0] || (q[0] == p[0] && q[1] < p[1]));
    }
    return wrong;
}

// Pairs that are missing, and entries that should not be there.
static int count_wrong(void)
{
    int wrong = 0;
    for (int a = 0; a < BODIES; a++)
        for (int b = a + 1; b < BODIES; b++)
            wrong += may_meet(a, b) && !is_listed(a, b);
    return wrong + count_wrong_order();
}

// Rejects: a list for the balls of now; one that knows only where a ball is,
// and not how far it gets; one that is kept when a ball has left; one of all
// pairs.
START_TEST(pairs_that_may_meet_are_listed_in_every_frame)
{
    int kept = 0, pairs = 0, frames = 0;
    for (int start = 0; start < 20; start++) {
        any_scene();
        for (int f = 0; f < 30; f++, frames++) {
            long before = list.lists;
            bool is_new = update();
            kept += !is_new;
            pairs += list.count;
            ck_assert_int_eq(lost, 0);
            ck_assert_int_eq(is_new, list.lists > before);
            ck_assert(f > 0 || is_new);
            ck_assert_int_eq(count_wrong(), 0);
            drift();
        }
    }
    ck_assert_msg(kept > frames / 2, "kept in %d frames of %d", kept, frames);
    ck_assert_int_lt(pairs, frames * BODIES * (BODIES - 1) / 4);
}
END_TEST

// A ball of 1 m that may go 0.05 m was listed with 0.1 + 2 * 0.05 m more: one
// reach is for the frame, the rest to wander in.
// Rejects: room that is measured from the ball of now; a list that is found in
// every frame, or as soon as anything moves.
START_TEST(list_holds_until_a_ball_has_used_its_room)
{
    const real room = 0.1 + 0.05, hair = 1e-9;
    begin(2);
    put(0, 0, 1, 0.05);
    put(1, 5, 1, 0.05);
    ck_assert(update());
    ck_assert(!update());
    ball[0].center = vec3_make(0, room - hair, 0);
    ck_assert(!update());
    ball[0].center = vec3_make(0, 0, -(room + hair));
    ck_assert(update());
    ck_assert(!update());
    // What may go further in this frame needs some of that room.
    reach[1] = 0.05 + room - hair;
    ck_assert(!update());
    reach[1] = 0.05 + room + hair;
    ck_assert(update());
    ck_assert_int_eq(list.lists, 3);
}
END_TEST

// Are exactly those pairs listed whose larger balls meet, and of which one is
// loose?
static int count_unlike(void)
{
    int wrong = 0;
    for (int a = 0; a < BODIES; a++)
        for (int b = a + 1; b < BODIES; b++) {
            const int pair[2] = { a, b };
            const sphere *x = &list.listed[a], *y = &list.listed[b];
            bool is_there = (moves[a] || moves[b]) && !(x->radius < 0)
                && !(y->radius < 0) && !pair_is_settled(&list, pair)
                && vec3_distance(x->center, y->center) <= x->radius + y->radius;
            wrong += is_there != is_listed(a, b);
        }
    return wrong;
}

static void wake_all_but(const bool *lies)
{
    query.awakes = 0;
    for (int b = 0; b < BODIES; b++)
        if (!lies[b]) awake[query.awakes++] = b;
}

// Bodies lie down and wake again, between two frames and within one.
// Rejects: a pair with what lies still that is missed, comes twice, or stands in
// the wrong place; one of two that lie still; one that is missing when they wake.
START_TEST(what_lies_still_is_met_and_leaves_the_list)
{
    int parted = 0, kept = 0;
    for (int start = 0; start < 20; start++) {
        bool lies[BODIES] = { false };
        any_scene();
        for (int f = 0; f < 60; f++) {
            int one = random_below(&seed, BODIES), more = f == 2 ? BODIES : 1;
            for (int k = 0; k < more && f % 4 == 2; k++)
                lies[(one + k) % BODIES] = f == 2 ? k % 5 != 0 : k % 2 == f % 8;
            wake_all_but(lies);
            kept += !update();
            lies[random_below(&seed, BODIES)] &= f % 10 != 9;
            wake_all_but(lies);
            pair_list_wake(&list, &query, &lost);
            pair_list_part(&list);
            parted += list.parted;
            ck_assert_int_eq(count_wrong_order(), 0);
            ck_assert_int_eq(count_unlike(), 0);
            for (int b = 0; b < BODIES; b++)
                ck_assert(lies[b] || !list.is_settled[b]);
            for (int b = 0; b < BODIES; b++)
                if (!lies[b]) drift_one(b);
        }
    }
    ck_assert_int_gt(parted, 20 * 60);
    ck_assert_int_gt(kept, 20 * 20);
}
END_TEST

// Rejects: what never moves, or meets nothing, that is watched.
START_TEST(what_never_moves_or_meets_nothing_makes_no_list)
{
    begin(3);
    for (int b = 0; b < 3; b++) put(b, 0.5 * b, 1, 0.01);
    moves[0] = 0;
    ball[2].radius = -1;
    ck_assert(update());
    ck_assert_int_eq(list.count, 1);
    ck_assert(is_listed(0, 1));
    ball[0].center.y = ball[2].center.y = 9;
    ck_assert(!update());
    ball[1].center.y = 9;
    ck_assert(update());
}
END_TEST

// Rejects: a lost number that makes a list hold for ever, or that hides what
// the others meet.
START_TEST(lost_number_spoils_no_other_pair)
{
    const real bad[] = { (real)NAN, HUGE_VAL, -HUGE_VAL };
    for (int k = 0; k < 6; k++) {
        any_scene();
        int b = 15 + k;
        *(k % 2 ? &reach[b] : &ball[b].center.y) = bad[k / 2];
        for (int f = 0; f < 20; f++) {
            real keep = reach[b];
            ck_assert(update() || bad[k / 2] < 0);
            int missing = 0;
            for (int a = 0; a < BODIES; a++)
                for (int c = a + 1; c < BODIES; c++)
                    missing += a != b && c != b && may_meet(a, c)
                            && !is_listed(a, c);
            ck_assert_int_eq(missing, 0);
            drift();
            reach[b] = keep;
        }
    }
}
END_TEST

// --- memory ------------------------------------------------------------------

// Rejects: pairs that are lost without a word; a cut list that is trusted in
// the next frame, or that has other pairs than the first; a write past the end.
START_TEST(pairs_without_memory_are_counted_until_there_is_some)
{
    begin(BODIES);
    for (int b = 0; b < BODIES; b++) put(b, 0.01 * b, 1, 0.01);
    int all = BODIES * (BODIES - 1) / 2;
    for (int f = 0; f < 3; f++) {
        mallocs_left = 0;
        bool is_new = update();
        mallocs_left = INT_MAX;
        ck_assert(is_new);
        ck_assert_int_gt(lost, 0);
        ck_assert_int_eq(list.count + lost, all);
        for (int k = 0; k < list.count && k < BODIES - 1; k++)
            ck_assert(list.pair[k][0] == 0 && list.pair[k][1] == k + 1);
    }
    ck_assert(update());
    ck_assert_int_eq(lost, 0);
    ck_assert_int_eq(list.count, all);
    long before = mallocs_made;
    ball[3].center.y = 1;
    bool is_new = update();
    long after = mallocs_made;
    ck_assert(is_new);
    ck_assert_int_eq(after, before);
}
END_TEST

// Rejects: larger balls made anew for all, so that others' pairs change.
START_TEST(body_that_comes_changes_no_pair_of_the_others)
{
    begin(4);
    for (int b = 0; b < 4; b++) put(b, 2.1 * b, 1, 0.1);
    ck_assert(update());
    sphere was[4];
    memcpy(was, list.listed, sizeof was);
    ck_assert(pair_list_grow(&list, 5));
    query.bodies = query.awakes = 5;
    awake[4] = 4;
    for (int b = 0; b < 4; b++) ball[b].center.y += 0.01;
    put(4, -1.5, 1, 0.1);
    ck_assert(update());
    ck_assert(!update());
    for (int b = 0; b < 4; b++)
        ck_assert(memcmp(&was[b], &list.listed[b], sizeof *was) == 0);
    ck_assert_int_eq(list.count, 4);
    ck_assert(is_listed(0, 4) && is_listed(0, 1) && !is_listed(1, 4));
    put(4, 7.5, 1, 0.1);
    pair_list_renew(&list, 4);
    ck_assert(update());
    ck_assert(is_listed(3, 4) && !is_listed(0, 4));
    pair_list_renew(&list, -1);
    ck_assert(update());
}
END_TEST

// Of six in a row the last was nowhere when the others lay down; the first moves.
// Rejects: all pairs found again for what had none; a settled one whose old place
// goes on being met.
START_TEST(what_was_nowhere_comes_without_a_list_of_all)
{
    begin(6);
    for (int b = 0; b < 6; b++) put(b, 1.5 * b, b == 5 ? -1 : 1, 0.1);
    ck_assert(update());
    query.awakes = 1;
    for (int f = 0; f < 3; f++) {
        pair_list_renew(&list, 0);
        update();
        pair_list_part(&list);
    }
    put(5, -1.3, 1, 0.1);
    pair_list_renew(&list, 5);
    query.awakes = 2;
    awake[1] = 5;
    ck_assert(update() && !list.is_whole);
    ck_assert_int_eq(list.count, 2);
    ck_assert(is_listed(0, 1) && is_listed(0, 5));
    // One that has lain still is put elsewhere: that does need one.
    pair_list_part(&list);
    put(3, -2, 1, 0.1);
    pair_list_renew(&list, 3);
    query.awakes = 3;
    awake[1] = 3;
    awake[2] = 5;
    ck_assert(update() && list.is_whole);
    ck_assert(is_listed(0, 3) && is_listed(3, 5) && !is_listed(2, 3));
}
END_TEST

// Rejects: a plane that only the nearest is listed for; one that lies far.
START_TEST(planes_are_listed_for_what_is_near_them)
{
    const plane floor = { { 0, 1, 0 }, 0 }, far = { { 1, 0, 0 }, -100 };
    const plane both[] = { floor, far };
    begin(3);
    for (int b = 0; b < 3; b++) put(b, 5 * b, 1, 0.1);
    ball[0].center.y = 0.9;
    ball[1].center.y = 4;
    ball[2].center.y = (real)NAN;
    query.plane = both;
    query.planes = 2;
    ck_assert(update());
    ck_assert_int_eq(list.walls, 3);
    const int want[3][2] = { { 0, contact_with_plane(0) },
                             { 2, contact_with_plane(0) },
                             { 2, contact_with_plane(1) } };
    ck_assert(memcmp(list.pair + list.count, want, sizeof want) == 0);
}
END_TEST

// Rejects: an answer that is not looked at; a half-made list.
START_TEST(refused_memory_leaves_nothing)
{
    bool ok = false;
    int n = 0;
    pair_list_free(&list);
    for (; !ok; n++) {
        long before = blocks_held;
        mallocs_left = n;
        ok = pair_list_grow(&list, BODIES);
        mallocs_left = INT_MAX;
        pair_list_free(&list);
        long held = blocks_held;
        ck_assert_int_eq(held, before);
    }
    ck_assert_int_gt(n, 3);
}
END_TEST

// Rejects: sizes of nothing taken for a failure.
START_TEST(no_bodies_have_no_pairs)
{
    begin(0);
    ck_assert(update());
    ck_assert_int_eq(list.count, 0);
    pair_list_free(&list);
    pair_list_free(&list);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        pairs_that_may_meet_are_listed_in_every_frame,
        list_holds_until_a_ball_has_used_its_room,
        what_never_moves_or_meets_nothing_makes_no_list,
        what_lies_still_is_met_and_leaves_the_list,
        lost_number_spoils_no_other_pair,
        pairs_without_memory_are_counted_until_there_is_some,
        refused_memory_leaves_nothing,
        body_that_comes_changes_no_pair_of_the_others,
        what_was_nowhere_comes_without_a_list_of_all,
        planes_are_listed_for_what_is_near_them,
        no_bodies_have_no_pairs,
        NULL
    };
    return suite_run((suite){
        .name = "pairs", .tests = tests, .tear_down = tear_down
    });
}
