// check_broad.c - are the pairs of the tree those of every pair, whatever comes?
// Book: chapter 14.

#include <check.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "broad.h"
#include "random.h"
#include "scarce.h"
#include "suite.h"

enum { MANY = 2000, MOST_PAIRS = MANY * (MANY - 1) / 2 };

// A reader's code (exercises/judge.h) is slowed down by sanitizers.
#ifdef TUMBLE_JUDGE_H
enum { SMALL_SCENES = 1000, LARGE = 700, FRAMES = 200 };
#else
enum { SMALL_SCENES = 10000, LARGE = MANY, FRAMES = 600 };
#endif

static broad  s;
static int    bodies;
static sphere ball[MANY];
static char   moves[MANY];
static int    found[MOST_PAIRS + 1][2], wanted[MOST_PAIRS + 1][2];

static const sphere EMPTY = { { 0, 0, 0 }, -1 };

// --- scenes ------------------------------------------------------------------

static unsigned long long seed;

static real anywhere(real side)
{
    return side * random_below(&seed, 1 << 30) / (1 << 30);
}

static sphere any_ball(real side, real radius)
{
    real x = anywhere(side), y = anywhere(side), z = anywhere(side);
    return (sphere){ { x, y, z }, radius };
}

// Its four numbers: centre and radius.
static real *part(sphere *of, int k)
{
    real *const number[] = { &of->center.x, &of->center.y, &of->center.z,
                             &of->radius };
    return number[k];
}

static void begin(int n)
{
    broad_free(&s);
    bodies = n;
    ck_assert(broad_grow(&s, n));
    memset(moves, 1, sizeof moves);
}

static void set_up(void)
{
    seed = 13;
    begin(0);
}

static void tear_down(void)
{
    broad_free(&s);
}

// There are `crowd` others after them, which overlap them along x and meet nobody:
// so there are more leaves than one.
static void begin_among(int n, int crowd)
{
    begin(n + crowd);
    for (int b = n; b < n + crowd; b++)
        ball[b] = (sphere){ { anywhere(2) - 1, b * 1e4, 0 }, 0.25 };
}

// n balls of radius 0.5 in a room as full as the book's.
static void begin_room(int n)
{
    begin(n);
    real side = cbrt(0.317 * n / 0.15);
    for (int b = 0; b < n; b++) ball[b] = any_ball(side, 0.5);
}

// --- what must hold ----------------------------------------------------------

// What found holds is what wanted holds.
static void same_pairs(int n)
{
    if (memcmp(found, wanted, (size_t)n * sizeof *found) == 0) return;
    for (int k = 0; k < n; k++)
        ck_assert_msg(found[k][0] == wanted[k][0]
                      && found[k][1] == wanted[k][1],
                      "pair %d of %d is (%d, %d), wanted (%d, %d)", k, n,
                      found[k][0], found[k][1], wanted[k][0], wanted[k][1]);
}

// The tree and all pairs have the same answer; returns how many there are.  Where
// there is too little room the tree only counts.
static int agreed(int capacity)
{
    int n = broad_pairs(&s, ball, moves, found, capacity);
    int all = broad_pairs_all(ball, moves, bodies, wanted, capacity);
    ck_assert_int_eq(n, all);
    if (n <= capacity) same_pairs(n);
    return n;
}

static int has(int a, int b)
{
    int n = agreed(MOST_PAIRS);
    for (int k = 0; k < n; k++)
        if (found[k][0] == a && found[k][1] == b) return 1;
    return 0;
}

// --- the answer --------------------------------------------------------------

// Rejects: pairs in the order of the tree; (b, a) for (a, b); pairs of balls
// that only overlap along x.
START_TEST(neighbours_are_found_in_order)
{
    static const int right[3][2] = { { 0, 2 }, { 1, 3 }, { 2, 3 } };
    begin_among(5, 40);
    ball[0] = (sphere){ { 3, 0, 0 }, 1 };
    ball[1] = (sphere){ { 0, 0, 0 }, 1 };
    ball[2] = (sphere){ { 2, 1, 0 }, 1 };
    ball[3] = (sphere){ { 1, 0, 1 }, 1 };
    ball[4] = (sphere){ { 1, 0, 9 }, 1 };
    ck_assert_int_eq(agreed(MOST_PAIRS), 3);
    memcpy(wanted, right, sizeof right);
    same_pairs(3);
}
END_TEST

// Whole numbers have no rounding, and many of these balls touch exactly or
// begin at the same place.  The oracle counts in int.
// Rejects: any error that both ways share; < for <= for spheres or
// for boxes.
START_TEST(balls_of_whole_numbers_are_judged_exactly)
{
    for (int round = 0; round < 3000; round++) {
        int n = random_below(&seed, 60), side = 2 + random_below(&seed, 14),
            right = 0, at[60][4];
        begin(n);
        for (int b = 0; b < n; b++) {
            for (int k = 0; k < 3; k++) at[b][k] = random_below(&seed, side);
            at[b][3] = random_below(&seed, 4)
                - (random_below(&seed, 8) == 0 ? 3 : 0);
            moves[b] = (char)random_below(&seed, 2);
            ball[b] = (sphere){ { at[b][0], at[b][1], at[b][2] }, at[b][3] };
        }
        for (int a = 0; a < n; a++)
            for (int b = a + 1; b < n; b++) {
                int d2 = 0, r = at[a][3] + at[b][3];
                for (int k = 0; k < 3; k++)
                    d2 += (at[a][k] - at[b][k]) * (at[a][k] - at[b][k]);
                if (at[a][3] < 0 || at[b][3] < 0 || d2 > r * r) continue;
                if (!moves[a] && !moves[b]) continue;
                wanted[right][0] = a;
                wanted[right++][1] = b;
            }
        int n_found = broad_pairs(&s, ball, moves, found, MOST_PAIRS);
        ck_assert_int_eq(n_found, right);
        same_pairs(right);
        agreed(random_below(&seed, right + 2));
    }
}
END_TEST

// Near 0 rounding leaves no room for ends that are set further out.
// Rejects: a test that is strict, or generous; boxes that are too small.
START_TEST(exact_touch_is_found_and_a_hair_less_is_not)
{
    static const real size[] = { 1, 0x1p-1060 };
    for (int k = 0; k < 3 * 2 * 2 * 3; k++) {
        int axis = k % 3, left = k / 3 % 2, still = k / 12;
        real d = size[k / 6 % 2];
        begin_among(2, 10);
        if (still < 2) moves[still] = 0;
        ball[left]  = (sphere){ { 0, 0, 0 }, 0.25 * d };
        ball[!left] = (sphere){ { 0, 0, 0 }, 0.75 * d };
        *part(&ball[!left], axis) = d;
        ck_assert_int_eq(agreed(1), 1);
        *part(&ball[!left], axis) = nextafter(d, 2);
        ck_assert_int_eq(agreed(1), 0);
    }
}
END_TEST

// Balls that touch as well as rounding lets them, near the origin and far out.
// Rejects: ends of intervals as they are rounded, which lose pairs.
START_TEST(rounded_ends_lose_nobody)
{
    int touching = 0;
    for (int round = 0; round < 20000; round++) {
        begin_among(2, 10);
        real far = round % 2 ? 1 : 0x1p30;
        real ra = anywhere(1) / 3, rb = anywhere(1) / 3;
        real x = far * (anywhere(2) - 1) / 3;
        int left = random_below(&seed, 2);
        ball[left]  = (sphere){ { x, 0, 0 }, ra };
        ball[!left] = (sphere){ { x + (ra + rb), 0, 0 }, rb };
        touching += agreed(1);
    }
    ck_assert_int_gt(touching, 10000);
}
END_TEST

// --- all kinds of scenes -----------------------------------------------------

static real odd_number(void)
{
    switch (random_below(&seed, 6)) {
    case 0:  return (real)NAN;
    case 1:  return HUGE_VAL;
    case 2:  return -HUGE_VAL;
    case 3:  return anywhere(1e308);
    case 4:  return -anywhere(1e308);
    default: return anywhere(1e-310);
    }
}

// kind 0: a room; 1: a heap; 2: 64 places; 3: a column; 4: one large among
// small; 5: odd numbers among them.
static void begin_kind(int n, int kind)
{
    begin_room(n);
    for (int b = 0; b < n; b++) {
        sphere *at = &ball[b];
        if (kind == 1) *at = any_ball(1, anywhere(0.2));
        if (kind == 2)
            at->center = vec3_make(3 * random_below(&seed, 4),
                                   3 * random_below(&seed, 4),
                                   random_below(&seed, 4));
        if (kind == 3) at->center = vec3_make(anywhere(0.1), b * 0.9, 0);
        if (kind == 5 && random_below(&seed, 8) == 0)
            *part(at, random_below(&seed, 4)) = odd_number();
        if (random_below(&seed, 16) == 0) at->radius = -anywhere(1);
        moves[b] = random_below(&seed, 4) > 0;
    }
    if (kind == 4 && n > 0) ball[random_below(&seed, 1 + n / 4)].radius = 1000;
}

// Rejects: nearly everything.
START_TEST(small_scenes_agree)
{
    for (int round = 0; round < SMALL_SCENES; round++) {
        begin_kind(random_below(&seed, 90), round % 6);
        int n = agreed(MOST_PAIRS);
        // Again, with too little room.
        agreed(random_below(&seed, n + 1));
    }
}
END_TEST

// Rejects: what small scenes do not reach: Shell's passes, long lists of one a.
START_TEST(large_scenes_agree)
{
    for (int kind = 0; kind < 6; kind++) {
        begin_kind(LARGE, kind);
        int n = agreed(MOST_PAIRS);
        agreed(n / 2);
    }
}
END_TEST

// Rejects: a division of what lies in one place that never ends; a sort of pairs
// that is lost among very many.
START_TEST(all_in_one_place_meet_all)
{
    begin(MANY);
    for (int b = 0; b < MANY; b++) ball[b] = (sphere){ { 1, 2, 3 }, 0 };
    ck_assert_int_eq(agreed(MOST_PAIRS), MOST_PAIRS);
}
END_TEST

// Rejects: a last or a first body that is left out.
START_TEST(no_body_and_one_body_meet_nobody)
{
    for (int n = 0; n < 2; n++) {
        begin(n);
        ball[0] = (sphere){ { 0, 0, 0 }, 1 };
        ck_assert_int_eq(agreed(MOST_PAIRS), 0);
        ck_assert_int_eq(broad_pairs(&s, ball, moves, NULL, 0), 0);
    }
}
END_TEST

// Whole numbers, so that every size holds the same scene.
// Rejects: squares that are lost below 1e-162 or beyond 1e154.
START_TEST(size_does_not_matter)
{
    static const int power[] = { -1070, -1022, -600, -480, 480, 600, 1015 };
    begin(200);
    for (int b = 0; b < 200; b++) {
        ball[b] = (sphere){ { random_below(&seed, 40), random_below(&seed, 40),
                              random_below(&seed, 40) },
                            random_below(&seed, 5) };
        moves[b] = random_below(&seed, 3) > 0;
    }
    int n = agreed(MOST_PAIRS);
    ck_assert_int_gt(n, 100);
    for (size_t k = 0; k < sizeof power / sizeof *power; k++) {
        static sphere kept[200];
        memcpy(kept, ball, sizeof kept);
        for (int b = 0; b < 200; b++)
            for (int i = 0; i < 4; i++)
                *part(&ball[b], i) = ldexp(*part(&ball[b], i), power[k]);
        ck_assert_int_eq(broad_pairs(&s, ball, moves, found, MOST_PAIRS), n);
        memcpy(ball, kept, sizeof kept);
        broad_pairs_all(ball, moves, bodies, wanted, MOST_PAIRS);
        same_pairs(n);
    }
}
END_TEST

// --- who moves ---------------------------------------------------------------

// Rejects: pairs of two that stand still.
START_TEST(nobody_moves_nobody_meets)
{
    begin(50);
    for (int b = 0; b < 50; b++) ball[b] = (sphere){ { -b, 0, 0 }, 1 };
    memset(moves, 0, sizeof moves);
    ck_assert_int_eq(agreed(MOST_PAIRS), 0);
}
END_TEST

// Rejects: a search that starts from movers only, and loses those that it finds
// twice.
START_TEST(one_that_moves_meets_those_that_do_not)
{
    begin(50);
    for (int b = 0; b < 50; b++) ball[b] = (sphere){ { b * 0.1, 0, 0 }, 10 };
    for (int who = 0; who < 50; who++) {
        memset(moves, 0, sizeof moves);
        moves[who] = 1;
        ck_assert_int_eq(agreed(MOST_PAIRS), 49);
    }
}
END_TEST

// --- odd balls ---------------------------------------------------------------

enum { CROWD = 30 };

// Three balls in a row touch; the fourth is odd.
static void begin_row(sphere fourth)
{
    begin_among(4, CROWD);
    for (int b = 0; b < 3; b++) ball[b] = (sphere){ { b, 0, 0 }, 0.5 };
    ball[3] = fourth;
}

// Rejects: a sphere test that squares the sum of the radii and looks no
// further; an empty ball in the tree.
START_TEST(ball_of_negative_radius_meets_nobody)
{
    static const real radius[] = { -1e-300, -0.25, -1, -1e300, -HUGE_VAL };
    for (size_t k = 0; k < sizeof radius / sizeof *radius; k++)
        for (int b = 0; b < 3; b++) {
            begin_row((sphere){ { b, 0, 0 }, radius[k] });
            ck_assert_int_eq(agreed(MOST_PAIRS), 2);
            // Not even one that meets everybody, wherever they all are.
            ball[0].center.x = 1e300;
            ball[2].radius = (real)NAN;
            ball[3].center.x = (real)NAN;
            ck_assert_int_eq(agreed(MOST_PAIRS), 2 + CROWD);
            ck_assert(!has(2, 3));
        }
}
END_TEST

// Rejects: a NaN that is compared once, found not to be greater or not to be
// less, and is lost, or ends up anywhere and spoils the boxes of the others.
START_TEST(ball_that_is_nan_meets_everybody_else_and_spoils_nothing)
{
    for (int which = 0; which < 4; which++)
        for (int where = 0; where < 100; where++) {
            begin_kind(100, 0);
            int before = agreed(MOST_PAIRS), rest = 0, others = 0;
            for (int k = 0; k < before; k++)
                rest += found[k][0] != where && found[k][1] != where;
            ball[where].radius = 0.5;
            moves[where] = 1;
            *part(&ball[where], which) = (real)NAN;
            for (int b = 0; b < 100; b++)
                others += b != where && ball[b].radius >= 0;
            ck_assert_int_eq(agreed(MOST_PAIRS), rest + others);
        }
}
END_TEST

// Rejects: inf - inf, which is NaN, as an end.
START_TEST(infinite_radius_meets_everybody)
{
    begin_row((sphere){ { 1e9, 1e9, 1e9 }, HUGE_VAL });
    ck_assert_int_eq(agreed(MOST_PAIRS), 5 + CROWD);
    for (int axis = 0; axis < 3; axis++) {
        *part(&ball[3], axis) = -HUGE_VAL;
        ck_assert_int_eq(agreed(MOST_PAIRS), 5 + CROWD);
    }
}
END_TEST

// Two that are infinitely far on the same side cannot be told apart, and are
// reported; from all others they are apart.
// Rejects: a body that has flown off and takes part in every pair from now on.
START_TEST(infinitely_far_ball_meets_only_its_like)
{
    for (int axis = 0; axis < 3; axis++) {
        begin_row((sphere){ { 0, 0, 0 }, 0.5 });
        *part(&ball[3], axis) = HUGE_VAL;
        ck_assert_int_eq(agreed(MOST_PAIRS), 2);
        ball[0] = ball[3];
        ck_assert(has(0, 3) && !has(0, 1) && has(1, 2));
        *part(&ball[0], axis) = -HUGE_VAL;
        ck_assert_int_eq(agreed(MOST_PAIRS), 1);
    }
}
END_TEST

// Rejects: |x| + r that overflows into ends that are NaN; some large number for
// the end of the line.
START_TEST(largest_numbers_are_numbers)
{
    const real most = 0x1.fffffffffffffp1023;
    begin_among(5, 200);
    ball[0] = (sphere){ { -most, 0, 0 }, 1 };
    ball[1] = (sphere){ { most, 0, 0 }, 1 };
    ball[2] = (sphere){ { 0, 0, 0 }, most };
    ball[3] = (sphere){ { 0, most, 0 }, most };
    ball[4] = (sphere){ { (real)NAN, 0, 0 }, 1 };
    ck_assert(has(0, 2) && has(1, 2) && has(2, 3) && !has(0, 1) && !has(0, 3));
    ck_assert(has(0, 4) && has(1, 4));
}
END_TEST

// --- room --------------------------------------------------------------------

// Rejects: a look at every pair that keeps other pairs than the first; a count of
// what was kept instead of what there is; one pair too many.
START_TEST(too_little_room_keeps_the_first_pairs)
{
    for (int kind = 0; kind < 6; kind++) {
        begin_kind(60, kind);
        int n = agreed(MOST_PAIRS);
        ck_assert_int_gt(n, 10);
        for (int room = 0; room <= n; room++) {
            found[room][0] = found[room][1] = -7;
            ck_assert_int_eq(agreed(room), n);
            ck_assert(found[room][0] == -7 && found[room][1] == -7);
            agreed(MOST_PAIRS);
            broad_pairs_all(ball, moves, 60, wanted, room);
            same_pairs(room);
        }
        ck_assert_int_eq(broad_pairs(&s, ball, moves, NULL, 0), n);
        ck_assert_int_eq(broad_pairs_all(ball, moves, 60, NULL, 0), n);
    }
}
END_TEST

// --- from frame to frame -----------------------------------------------------

// velocity: the centres of balls.
static void fly(sphere *velocity, real side)
{
    for (int b = 0; b < bodies; b++)
        for (int k = 0; k < 3; k++) {
            real *x = part(&ball[b], k), *v = part(&velocity[b], k);
            *x += *v / 60;
            if (*x < 0)    *v = fabs(*v);
            if (*x > side) *v = -fabs(*v);
        }
}

// Rejects: a tree that is not brought up to date.
START_TEST(moving_scene_agrees_in_every_frame)
{
    static sphere velocity[300];
    begin_room(300);
    for (int b = 0; b < 300; b++) {
        velocity[b] = any_ball(10, 0);
        for (int k = 0; k < 3; k++) *part(&velocity[b], k) -= 5;
    }
    for (int frame = 0; frame < FRAMES; frame++) {
        fly(velocity, cbrt(0.317 * 300 / 0.15));
        ball[frame % 300].radius = frame % 7 ? 0.5 : -1;
        moves[frame / 2] = !moves[frame / 2];
        agreed(MOST_PAIRS);
    }
}
END_TEST

static bool is_listed(int n, int a, int b)
{
    for (int k = 0; k < n; k++)
        if (found[k][0] == int_min(a, b) && found[k][1] == int_max(a, b))
            return true;
    return false;
}

// One ball after the other is put elsewhere, and one in ten becomes empty.
// Rejects: boxes above a leaf that do not grow with it; a new ball that does not
// find room, or is found where it was; a pair that two of those list.
START_TEST(ball_that_is_put_elsewhere_has_its_own_pairs)
{
    static bool is_asked[400];
    memset(is_asked, 0, sizeof is_asked);
    begin_room(400);
    for (int b = 390; b < 400; b++) ball[b] = EMPTY;
    agreed(MOST_PAIRS);
    for (int k = 0; k < 400; k++) {
        int b = (k * 7 + 390) % 400;
        ball[b] = any_ball(cbrt(0.317 * 400 / 0.15), 0.5);
        if (k % 10 == 5) ball[b] = EMPTY;
        ck_assert(broad_update(&s, ball, b));
        int n = broad_near(&s, ball, moves, is_asked, b, found, MOST_PAIRS, 0);
        int all = broad_pairs_all(ball, moves, bodies, wanted, MOST_PAIRS);
        int own = 0;
        for (int i = 0; i < all; i++) {
            if (wanted[i][0] != b && wanted[i][1] != b) continue;
            ck_assert(is_listed(n, wanted[i][0], wanted[i][1]));
            own++;
        }
        ck_assert_int_eq(n, own);
    }
    // Two that are asked: their pair is listed by the lower one alone.
    for (int b = 0; b < 400; b++) is_asked[b] = b % 3 == 0;
    int all = broad_pairs_all(ball, moves, bodies, wanted, MOST_PAIRS);
    int n = 0, own = 0;
    for (int b = 0; b < 400; b += 3)
        n = broad_near(&s, ball, moves, is_asked, b, found, MOST_PAIRS, n);
    for (int i = 0; i < all; i++)
        own += is_asked[wanted[i][0]] || is_asked[wanted[i][1]];
    ck_assert_int_eq(n, own);
}
END_TEST

// Rejects: an answer, or a tree, that remembers where bodies were.
START_TEST(history_leaves_no_trace)
{
    static int order[500];
    for (int history = 0; history < 5; history++) {
        seed = (unsigned long long)history;
        begin_kind(500, history);
        if (history > 0) agreed(MOST_PAIRS);
        seed = 99;
        for (int b = 0; b < 500; b++)
            ball[b] = (sphere){ { random_below(&seed, 20),
                                  random_below(&seed, 20),
                                  random_below(&seed, 4) }, 1 };
        ball[7] = EMPTY;
        ball[9].center.y = (real)NAN;
        memset(moves, 1, sizeof moves);
        agreed(MOST_PAIRS);
        size_t bytes = (size_t)s.tree.things * sizeof *order;
        if (history == 0) memcpy(order, s.tree.number, bytes);
        ck_assert(memcmp(order, s.tree.number, bytes) == 0);
    }
}
END_TEST

// --- what is spared ----------------------------------------------------------

// How many balls each is compared with: those of leaves whose boxes meet.
static real compared(void)
{
    const aabb *leaf = s.tree.node + s.tree.leaves;
    long tests = 0;
    for (int i = 0; i < s.tree.leaves; i++)
        for (int k = i; k < s.tree.leaves; k++)
            tests += aabbs_meet(&leaf[i], &leaf[k]);
    return (real)tests * A_LEAF * A_LEAF / bodies;
}

// Of 700 or 2,000, a few dozen, whatever shape the scene has: a leaf meets its
// neighbours.
// Rejects: a tree whose leaves hold what is not near; one that a single ball, far
// away, leaves without its divisions.
START_TEST(scene_of_any_shape_spares_comparisons)
{
    for (int kind = 0; kind < 4; kind++) {
        begin_room(LARGE);
        for (int b = 0; b < LARGE; b++) {
            if (kind == 1) ball[b].center = vec3_make(anywhere(0.1), b * 0.9, 0);
            if (kind == 2) ball[b].center.z = anywhere(0.1) + b / 100;
        }
        if (kind == 3) ball[7].center.y = -1e9;
        agreed(MOST_PAIRS);
        ck_assert(compared() < 80);
    }
}
END_TEST

// Rejects: large balls that take all with them into their leaves.
START_TEST(few_large_balls_leave_the_others_alone)
{
    begin(LARGE);
    for (int b = 0; b < LARGE; b++)
        ball[b] = any_ball(400, b % 100 == 7 ? 50 : 0.5);
    ck_assert_int_gt(agreed(MOST_PAIRS), LARGE / 20);
    ck_assert(compared() < 80);
}
END_TEST

// Pairs that touch along an axis as well as rounding lets them, a few metres and
// 134,000 km from the origin.
// Rejects: boxes that one of two that touch just does not reach into.
START_TEST(rounded_boxes_lose_nobody)
{
    for (int round = 0; round < 12; round++) {
        int axis = round % 3, touching = 0;
        real far = round / 3 % 2 ? 0x1p27 : 0;
        begin(LARGE);
        for (int b = 0; b < LARGE; b += 2) {
            ball[b] = ball[b + 1] = any_ball(200, 0);
            ball[b].radius = anywhere(1) / 3;
            ball[b + 1].radius = anywhere(1) / 3;
            *part(&ball[b], axis) += far;
            *part(&ball[b + 1], axis) = *part(&ball[b], axis)
                                      + (ball[b].radius + ball[b + 1].radius);
        }
        touching = agreed(MOST_PAIRS);
        ck_assert_int_gt(touching, LARGE / 5);
    }
}
END_TEST

// --- memory ------------------------------------------------------------------

// Rejects: a refusal that goes unnoticed, or leaves something half built.
START_TEST(refused_memory_leaves_nothing)
{
    broad t = { .bodies = 0 };
    int n = 0;
    for (int ok = 0; n < 100 && !ok; n++) {
        long before = blocks_held;
        mallocs_left = n;
        ok = broad_grow(&t, 10);
        mallocs_left = INT_MAX;
        broad_free(&t);
        long after = blocks_held;
        ck_assert_int_eq(after, before);
        ck_assert(!t.bodies && !t.place && !t.first && !t.next);
        ck_assert(!t.tree.around && !t.tree.number && !t.tree.node);
    }
    ck_assert_int_eq(n, 7);
    broad_free(&t);
}
END_TEST

// Rejects: memory that is asked for in a frame.
START_TEST(query_asks_for_no_memory)
{
    begin_kind(MANY, 2);
    long before = mallocs_made;
    broad_pairs(&s, ball, moves, found, MOST_PAIRS);
    broad_pairs(&s, ball, moves, found, 100);
    broad_pairs_all(ball, moves, bodies, wanted, 100);
    long after = mallocs_made;
    ck_assert_int_eq(after, before);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        neighbours_are_found_in_order,
        balls_of_whole_numbers_are_judged_exactly,
        exact_touch_is_found_and_a_hair_less_is_not,
        rounded_ends_lose_nobody,
        small_scenes_agree,
        large_scenes_agree,
        all_in_one_place_meet_all,
        no_body_and_one_body_meet_nobody,
        size_does_not_matter,
        nobody_moves_nobody_meets,
        one_that_moves_meets_those_that_do_not,
        ball_of_negative_radius_meets_nobody,
        ball_that_is_nan_meets_everybody_else_and_spoils_nothing,
        infinite_radius_meets_everybody,
        infinitely_far_ball_meets_only_its_like,
        largest_numbers_are_numbers,
        too_little_room_keeps_the_first_pairs,
        moving_scene_agrees_in_every_frame,
        ball_that_is_put_elsewhere_has_its_own_pairs,
        history_leaves_no_trace,
        scene_of_any_shape_spares_comparisons,
        few_large_balls_leave_the_others_alone,
        rounded_boxes_lose_nobody,
        refused_memory_leaves_nothing,
        query_asks_for_no_memory,
        NULL
    };
    return suite_run((suite){
        .name = "broad", .tests = tests, .set_up = set_up,
        .tear_down = tear_down
    });
}
