// check.c - tests of the exercise 08/blows.

#include "blows.h"
#include "suite.h"

#include <check.h>
#include <stdio.h>
#include <stdlib.h>

static stick between(int a, int b)
{
    return (stick){ a, b, 1, 1, STICK_EXACT };
}

// What blows_order has given, all of it in memory that ends behind the last.
typedef struct {
    int sticks, largest;
    int *order;
} answer;

static int *numbers(int n)
{
    int *a = malloc((size_t)n * sizeof *a + (n == 0));
    ck_assert_ptr_nonnull(a);
    for (int i = 0; i < n; i++) a[i] = -77;
    return a;
}

static answer ask(const stick *s, int sticks, int particles, const int *struck,
                  int m)
{
    answer r = { sticks, 0, numbers(sticks) };
    int *away = numbers(particles), *distance = numbers(sticks);
    r.largest = blows_order(s, sticks, particles, struck, m, r.order, away,
                            distance);
    free(away);
    free(distance);
    return r;
}

static void expect(answer r, const int *wanted, int largest)
{
    char got[200] = "", want[200] = "";
    int same = 1, g = 0, w = 0;
    for (int i = 0; i < r.sticks; i++) {
        same &= r.order[i] == wanted[i];
        if (i >= 24) continue;
        g += snprintf(got + g, sizeof got - (size_t)g, " %d", r.order[i]);
        w += snprintf(want + w, sizeof want - (size_t)w, " %d", wanted[i]);
    }
    ck_assert_msg(same, "the order is%s, wanted%s", got, want);
    ck_assert_msg(r.largest == largest, "the largest distance is %d, wanted %d",
                  r.largest, largest);
    free(r.order);
}

static void chain(stick *s, int sticks)
{
    for (int k = 0; k < sticks; k++) s[k] = between(k, k + 1);
}

enum { SIDE = 5, GRID_STICKS = 2 * SIDE * (SIDE - 1) };

// SIDE x SIDE particles, joined to the right and downwards.
static void grid(stick *s)
{
    int n = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        if (i % SIDE + 1 < SIDE) s[n++] = between(i, i + 1);
        if (i / SIDE + 1 < SIDE) s[n++] = between(i, i + SIDE);
    }
}

START_TEST(one_blow_gives_the_list_of_one)
{
    // The same as stick_lists_build, for every particle of a grid.
    // Rejects: depth first, another order of equals, one particle too many.
    stick s[GRID_STICKS];
    stick_lists l;
    grid(s);
    ck_assert(stick_lists_build(&l, s, GRID_STICKS, SIDE * SIDE, 0).ok);
    for (int v = 0; v < SIDE * SIDE; v++) {
        int right = SIDE - 1 - v % SIDE, down = SIDE - 1 - v / SIDE;
        int across = right > v % SIDE ? right : v % SIDE;
        int along = down > v / SIDE ? down : v / SIDE;
        expect(ask(s, GRID_STICKS, SIDE * SIDE, &v, 1),
               l.stick + l.start[v], across + along);
    }
    stick_lists_free(&l);
}
END_TEST

START_TEST(both_ends_of_a_chain)
{
    // Rejects: one blow that counts more than the other, or alone.
    stick s[7];
    chain(s, 7);
    const int ends[2] = { 7, 0 }, wanted[7] = { 0, 6, 1, 5, 2, 4, 3 };
    expect(ask(s, 7, 8, ends, 2), wanted, 4);
    const int twice[4] = { 0, 7, 7, 0 };
    expect(ask(s, 7, 8, twice, 4), wanted, 4);
}
END_TEST

START_TEST(every_particle_is_struck)
{
    stick s[GRID_STICKS];
    int all[SIDE * SIDE], wanted[GRID_STICKS];
    grid(s);
    for (int i = 0; i < SIDE * SIDE; i++) all[i] = i;
    for (int k = 0; k < GRID_STICKS; k++) wanted[k] = k;
    expect(ask(s, GRID_STICKS, SIDE * SIDE, all, SIDE * SIDE), wanted, 1);
}
END_TEST

START_TEST(no_blow_is_the_order_of_the_shape)
{
    stick s[4];
    chain(s, 4);
    const int wanted[4] = { 0, 1, 2, 3 };
    expect(ask(s, 4, 5, NULL, 0), wanted, 0);
    expect(ask(s, 0, 0, NULL, 0), wanted, 0);
}
END_TEST

START_TEST(what_no_path_reaches_stands_last)
{
    // Rejects: sticks that are lost, or stand first because they have no ring.
    const stick s[4] = { between(4, 5), between(0, 1), between(1, 2),
                         between(3, 4) };
    const int struck = 2, wanted[4] = { 2, 1, 0, 3 };
    expect(ask(s, 4, 6, &struck, 1), wanted, 2);
    const int lonely = 6, shape[4] = { 0, 1, 2, 3 };
    expect(ask(s, 4, 7, &lonely, 1), shape, 0);
}
END_TEST

// How far stick k is from one blow on v, from a list of one.
static int rank_of(const stick *s, int k, int v)
{
    int ax = abs(s[k].a % SIDE - v % SIDE) + abs(s[k].a / SIDE - v / SIDE);
    int bx = abs(s[k].b % SIDE - v % SIDE) + abs(s[k].b / SIDE - v / SIDE);
    return (ax < bx ? ax : bx) + 1;
}

START_TEST(distance_is_that_of_the_nearest_blow)
{
    // On a grid the distance is a count of rows and columns.
    stick s[GRID_STICKS];
    grid(s);
    for (int u = 0; u < SIDE * SIDE; u++) {
        int three[3] = { u, (7 * u + 3) % (SIDE * SIDE), 24 - u };
        answer r = ask(s, GRID_STICKS, SIDE * SIDE, three, 3);
        int before = 1, seen[GRID_STICKS] = { 0 };
        for (int i = 0; i < GRID_STICKS; i++) {
            int k = r.order[i], least = 99;
            ck_assert_msg(k >= 0 && k < GRID_STICKS && !seen[k]++,
                          "stick %d stands twice, or is none", k);
            for (int j = 0; j < 3; j++) {
                int d = rank_of(s, k, three[j]);
                least = d < least ? d : least;
            }
            ck_assert_msg(least >= before, "stick %d, of distance %d, stands "
                          "behind one of distance %d", k, least, before);
            before = least;
        }
        ck_assert_int_eq(before, r.largest);
        free(r.order);
    }
}
END_TEST

enum { ROPE = 40 };

// Relaxes a rope whose ends were pulled a stick's length along in this order;
// returns the iterations until no stick is off by more than 1 %.
static int iterations_to_the_end(const int *order)
{
    particle p[ROPE + 1];
    stick s[ROPE];
    chain(s, ROPE);
    for (int i = 0; i <= ROPE; i++)
        p[i] = (particle){ { i, 0, 0 }, { i, 0, 0 }, 1 };
    p[0].position.y = p[ROPE].position.y = 1;
    for (int k = 1; k <= 1000; k++) {
        real worst = 0;
        for (int i = 0; i < ROPE; i++)
            stick_relax(s[order[i]], p, relax_options_pbd());
        for (int i = 0; i < ROPE; i++)
            worst = fmax(worst, stick_strain(s[i], p));
        if (worst <= 0.01) return k;
    }
    return 1000;
}

START_TEST(rope_struck_at_both_ends_is_mended_sooner)
{
    // The order of one blow knows half of what has happened.
    stick s[ROPE];
    chain(s, ROPE);
    const int ends[2] = { 0, ROPE };
    answer one = ask(s, ROPE, ROPE + 1, ends, 1);
    answer two = ask(s, ROPE, ROPE + 1, ends, 2);
    int with_one = iterations_to_the_end(one.order);
    int with_two = iterations_to_the_end(two.order);
    ck_assert_msg(with_two < with_one, "iterations until all is within 1 %%: "
                  "%d from the nearer blow, %d from one of them", with_two,
                  with_one);
    free(one.order);
    free(two.order);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        one_blow_gives_the_list_of_one,
        both_ends_of_a_chain,
        every_particle_is_struck,
        no_blow_is_the_order_of_the_shape,
        what_no_path_reaches_stands_last,
        distance_is_that_of_the_nearest_blow,
        rope_struck_at_both_ends_is_mended_sooner,
        NULL
    };
    return suite_run((suite){ .name = "blows", .tests = tests });
}
