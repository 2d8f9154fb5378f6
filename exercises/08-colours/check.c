// check.c - tests of the exercise 08/colours.

#include "colours.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>
#include <string.h>

static stick between(int a, int b)
{
    return (stick){ a, b, 1, 1, STICK_EXACT };
}

// What two_colours has said, in memory that ends behind the last.
typedef struct {
    int particles, count;
    int *colour, *ring;
} answer;

static int *numbers(int n)
{
    int *a = malloc((size_t)n * sizeof *a + (n == 0));
    ck_assert_ptr_nonnull(a);
    for (int i = 0; i < n; i++) a[i] = -77;
    return a;
}

static answer ask(const stick *s, int sticks, int particles)
{
    answer r = { particles, 0, numbers(particles), numbers(particles) };
    int *scratch = numbers(3 * particles);
    r.count = two_colours(s, sticks, particles, r.colour, r.ring, scratch);
    free(scratch);
    return r;
}

static void forget(answer r)
{
    free(r.colour);
    free(r.ring);
}

// There is an answer, and it is this one.
static void expect_colours(answer r, const int *wanted)
{
    ck_assert_msg(r.count == 0, "it can be done, but the answer is an odd ring "
                  "of %d", r.count);
    for (int i = 0; i < r.particles; i++)
        ck_assert_msg(r.colour[i] == wanted[i], "particle %d has the colour %d,"
                      " wanted %d", i, r.colour[i], wanted[i]);
    forget(r);
}

static int has_stick(const stick *s, int sticks, int a, int b)
{
    for (int k = 0; k < sticks; k++)
        if ((s[k].a == a && s[k].b == b) || (s[k].a == b && s[k].b == a))
            return 1;
    return 0;
}

// It cannot be done, and the ring shows why.  Returns its number.
static int expect_ring(answer r, const stick *s, int sticks)
{
    int seen[64] = { 0 };
    ck_assert_msg(r.count != 0, "it cannot be done, but the answer is yes");
    ck_assert_msg(r.count >= 3 && r.count <= r.particles && r.count % 2 == 1,
                  "a ring of %d is no proof: the number must be odd, and at "
                  "least 3", r.count);
    for (int i = 0; i < r.count; i++) {
        int a = r.ring[i], b = r.ring[(i + 1) % r.count];
        ck_assert_msg(a >= 0 && a < r.particles && !seen[a]++,
                      "particle %d stands in the ring twice, or is none", a);
        ck_assert_msg(has_stick(s, sticks, a, b), "%d and %d follow each other "
                      "in the ring, and share no stick", a, b);
    }
    int count = r.count;
    forget(r);
    return count;
}

START_TEST(rope_is_red_and_black_in_turn)
{
    stick s[6];
    for (int k = 0; k < 6; k++) s[k] = between(k, k + 1);
    const int wanted[7] = { 0, 1, 0, 1, 0, 1, 0 };
    expect_colours(ask(s, 6, 7), wanted);
}
END_TEST

START_TEST(rope_may_be_listed_backwards)
{
    // From the last stick to the first, each from its far end.
    // Rejects: sticks that are one-way streets, one round over the sticks.
    stick s[6];
    for (int k = 0; k < 6; k++) s[5 - k] = between(k + 1, k);
    const int wanted[7] = { 0, 1, 0, 1, 0, 1, 0 };
    expect_colours(ask(s, 6, 7), wanted);
}
END_TEST

enum { SIDE = 6, NET = SIDE * SIDE, NET_STICKS = 2 * SIDE * (SIDE - 1) };

static void net(stick *s)
{
    int n = 0;
    for (int i = 0; i < NET; i++) {
        if (i % SIDE + 1 < SIDE) s[n++] = between(i, i + 1);
        if (i / SIDE + 1 < SIDE) s[n++] = between(i, i + SIDE);
    }
}

START_TEST(net_is_a_chessboard)
{
    // Rejects: colours by number: rows of six, so even stands below even.
    stick s[NET_STICKS];
    int wanted[NET];
    net(s);
    for (int i = 0; i < NET; i++) wanted[i] = (i % SIDE + i / SIDE) % 2;
    expect_colours(ask(s, NET_STICKS, NET), wanted);
}
END_TEST

START_TEST(cube_can_be_coloured_and_its_faces_have_no_diagonals)
{
    stick s[13];
    int n = 0, wanted[8];
    for (int i = 0; i < 8; i++) {
        for (int bit = 1; bit < 8; bit *= 2)
            if (!(i & bit)) s[n++] = between(i, i | bit);
        wanted[i] = (i + i / 2 + i / 4) % 2;
    }
    expect_colours(ask(s, 12, 8), wanted);
    s[12] = between(0, 3);
    ck_assert_int_eq(expect_ring(ask(s, 13, 8), s, 13), 3);
}
END_TEST

START_TEST(every_piece_begins_with_red)
{
    // Two ropes and two lonely particles, 2 and 7.
    const stick s[4] = { between(6, 5), between(0, 1), between(4, 3),
                         between(3, 5) };
    const int wanted[8] = { 0, 1, 0, 0, 1, 1, 0, 0 };
    expect_colours(ask(s, 4, 8), wanted);
    expect_colours(ask(NULL, 0, 0), wanted);
}
END_TEST

START_TEST(triangle_shows_itself)
{
    const stick s[3] = { between(0, 1), between(1, 2), between(2, 0) };
    ck_assert_int_eq(expect_ring(ask(s, 3, 3), s, 3), 3);
}
END_TEST

START_TEST(pentagon_shows_itself)
{
    // Listed so that the stick that closes the ring stands first.
    const stick s[5] = { between(2, 3), between(0, 1), between(1, 2),
                         between(3, 4), between(4, 0) };
    ck_assert_int_eq(expect_ring(ask(s, 5, 5), s, 5), 5);
}
END_TEST

START_TEST(tail_of_a_kite_is_no_part_of_its_ring)
{
    // The string of the kite leads from the lowest particle to the triangle.
    // Rejects: a ring that goes up the string and down again.
    const stick s[6] = { between(0, 1), between(1, 2), between(2, 3),
                         between(3, 4), between(3, 5), between(4, 5) };
    ck_assert_int_eq(expect_ring(ask(s, 6, 6), s, 6), 3);
}
END_TEST

START_TEST(figure_7_of_the_paper_cannot_be_coloured)
{
    const stick s[7] = { between(0, 1), between(1, 2), between(2, 3),
                         between(3, 4), between(4, 0), between(1, 3),
                         between(4, 2) };
    expect_ring(ask(s, 7, 5), s, 7);
}
END_TEST

START_TEST(random_bodies_are_coloured_or_refuted)
{
    unsigned long long seed = 8;
    int coloured = 0;
    for (int k = 0; k < 300; k++) {
        stick s[14];
        int n = 4 + k % 11;
        for (int i = 0; i < n; i++) {
            int a = random_below(&seed, 12), b = random_below(&seed, 11);
            s[i] = between(a, b < a ? b : b + 1);
        }
        answer r = ask(s, n, 12);
        if (r.count != 0) {
            expect_ring(r, s, n);
            continue;
        }
        coloured++;
        for (int i = 0; i < n; i++)
            ck_assert_msg(r.colour[s[i].a] + r.colour[s[i].b] == RED + BLACK,
                          "stick %d joins two of one colour", i);
        forget(r);
    }
    ck_assert_msg(coloured > 50 && coloured < 250, "%d of 300 coloured: they "
                  "are of both kinds", coloured);
}
END_TEST

// Each particle of this colour, but for the frame, moves to the mean height of
// its four neighbours; in this direction.
static void settle(real *height, const int *colour, int which, int backwards)
{
    for (int j = 0; j < NET; j++) {
        int i = backwards ? NET - 1 - j : j, x = i % SIDE, y = i / SIDE;
        if (colour[i] != which) continue;
        if (x == 0 || y == 0 || x == SIDE - 1 || y == SIDE - 1) continue;
        height[i] = (height[i - 1] + height[i + 1] + height[i - SIDE]
                     + height[i + SIDE]) / 4;
    }
}

START_TEST(within_a_colour_no_order_matters)
{
    // A net in a frame that is bent like a saddle, x^2 - y^2, settles down: and
    // the saddle is what it settles to, as the mean of four neighbours is met
    // exactly there.
    stick s[NET_STICKS];
    net(s);
    answer r = ask(s, NET_STICKS, NET);
    real one[NET], two[NET];
    for (int i = 0; i < NET; i++) {
        int x = i % SIDE, y = i / SIDE, rim = x == 0 || y == 0 || x == SIDE - 1
                                           || y == SIDE - 1;
        one[i] = two[i] = rim ? x * x - y * y : 0;
    }
    for (int k = 0; k < 200; k++) {
        settle(one, r.colour, RED, 0);
        settle(one, r.colour, BLACK, 0);
        settle(two, r.colour, RED, 1);
        settle(two, r.colour, BLACK, k % 2);
    }
    ck_assert_msg(memcmp(one, two, sizeof one) == 0, "forwards and backwards "
                  "give different bits: two of one colour share a stick");
    for (int i = 0; i < NET; i++) {
        int x = i % SIDE, y = i / SIDE;
        ck_assert_msg(fabs(one[i] - (x * x - y * y)) < 1e-12, "height of "
                      "particle %d: got %g, wanted %d", i, one[i],
                      x * x - y * y);
    }
    forget(r);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        rope_is_red_and_black_in_turn,
        rope_may_be_listed_backwards,
        net_is_a_chessboard,
        cube_can_be_coloured_and_its_faces_have_no_diagonals,
        every_piece_begins_with_red,
        triangle_shows_itself,
        pentagon_shows_itself,
        tail_of_a_kite_is_no_part_of_its_ring,
        figure_7_of_the_paper_cannot_be_coloured,
        random_bodies_are_coloured_or_refuted,
        within_a_colour_no_order_matters,
        NULL
    };
    return suite_run((suite){ .name = "colours", .tests = tests });
}
