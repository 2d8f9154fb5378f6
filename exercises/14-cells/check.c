// check.c - tests of the exercise 14/cells.

#include "cells.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 120, ALL = MOST * (MOST - 1) / 2 };

static vec3 at[MOST];

static unsigned long long seed = 31;

static real anywhere(real side)
{
    return side * (random_below(&seed, 1 << 30) / (real)(1 << 29) - 1);
}

// A table in memory of just its size, with rubbish in it.
static cells begin(int points, int slots)
{
    cells g = { .points = points, .slots = slots };
    g.in = malloc((size_t)(points + 1) * sizeof *g.in);
    g.start = malloc((size_t)(slots + 1) * sizeof *g.start);
    g.member = malloc((size_t)(points > 0 ? points : 1) * sizeof *g.member);
    ck_assert(g.in && g.start && g.member);
    for (int s = 0; s <= slots; s++) g.start[s] = 3;
    return g;
}

static void end(cells *g)
{
    free(g->in);
    free(g->start);
    free(g->member);
}

START_TEST(place_has_its_cell)
{
    // Rejects: a cast, which goes towards 0.
    const real x[7] = { -2.5, -2, -0.25, 0, 1.75, 2, 1e12 };
    const long long wanted[7] = { -2, -1, -1, 0, 0, 1, 500000000000 };
    for (int axis = 0; axis < 3; axis++)
        for (int n = 0; n < 7; n++) {
            cell c = { -7, -7, -7 };
            vec3 p = { axis == 0 ? x[n] : 1, axis == 1 ? x[n] : 1,
                       axis == 2 ? x[n] : 1 };
            ck_assert_msg(cell_of(p, 2, &c), "%g has no cell", x[n]);
            long long got = axis == 0 ? c.i : axis == 1 ? c.j : c.k;
            ck_assert_msg(got == wanted[n], "%g is in cell %lld of size 2, "
                          "wanted %lld", x[n], got, wanted[n]);
            ck_assert_msg(c.i + c.j + c.k == got, "1 is in cell 0");
        }
}
END_TEST

START_TEST(same_points_give_the_same_table)
{
    // Each slot holds its points, from the lowest to the highest; also when
    // the table has been used before.
    for (int round = 0; round < 200; round++) {
        int points = random_below(&seed, MOST),
            slots = 1 << random_below(&seed, 8);
        cells g = begin(points, slots);
        for (int again = 0; again < 2; again++) {
            for (int p = 0; p < points; p++)
                at[p] = vec3_make(anywhere(5), anywhere(5), anywhere(5));
            ck_assert_int_eq(cells_fill(&g, at, 1), 1);
            int seen = 0;
            ck_assert_int_eq(g.start[0], 0);
            for (int s = 0; s < slots; s++)
                for (int p = 0; p < points; p++) {
                    cell c = { 0, 0, 0 };
                    cell_of(at[p], 1, &c);
                    if (cell_slot(c, slots) != s) continue;
                    ck_assert_msg(g.start[s] <= seen && seen < g.start[s + 1]
                                  && g.member[seen] == p, "slot %d of %d: "
                                  "point %d is not where it should be", s,
                                  slots, p);
                    seen++;
                }
            ck_assert_int_eq(g.start[slots], points);
        }
        end(&g);
    }
}
END_TEST

// Compares with all pairs; returns how many there are.
static int agreed(cells *g, real size, real reach, int capacity)
{
    static char near[MOST][MOST];
    int (*out)[2] = malloc((size_t)(capacity + 1) * sizeof *out), wanted = 0;
    ck_assert_ptr_nonnull(out);
    out[capacity][0] = -7;
    memset(near, 0, sizeof near);
    for (int a = 0; a < g->points; a++)
        for (int b = a + 1; b < g->points; b++) {
            near[a][b] = vec3_length_squared(vec3_sub(at[a], at[b]))
                       <= reach * reach;
            wanted += near[a][b];
        }
    int got = cells_pairs(g, at, size, reach, out, capacity);
    ck_assert_msg(got == wanted, "%d pairs, wanted %d", got, wanted);
    for (int k = 0; k < got && k < capacity; k++) {
        int a = out[k][0], b = out[k][1];
        ck_assert_msg(0 <= a && a < b && b < g->points && near[a][b],
                      "(%d, %d) is no pair, or comes twice", a, b);
        near[a][b] = 0;
    }
    ck_assert_msg(out[capacity][0] == -7, "one more than there is room for");
    free(out);
    return got;
}

START_TEST(neighbours_across_the_border_are_found)
{
    // Two in one cell, and two across a side, an edge, a corner of a cell;
    // on both sides of 0.
    for (int n = 0; n < 27; n++) {
        cells g = begin(2, 64);
        vec3 way = { 0.125 * (n % 3 - 1), 0.125 * (n / 3 % 3 - 1),
                     0.125 * (n / 9 - 1) };
        for (int home = -2; home <= 2; home++) {
            at[0] = vec3_make(home, home, home);
            at[1] = vec3_add(at[0], way);
            ck_assert_int_eq(agreed(&g, 1, 0.25, ALL), 1);
        }
        end(&g);
    }
}
END_TEST

START_TEST(each_pair_comes_once_even_in_a_table_of_one_slot)
{
    for (int slots = 1; slots <= 8; slots *= 2) {
        cells g = begin(MOST, slots);
        for (int p = 0; p < MOST; p++)
            at[p] = vec3_make(anywhere(3), anywhere(3), anywhere(3));
        ck_assert_int_gt(agreed(&g, 1, 1, ALL), 50);
        end(&g);
    }
}
END_TEST

START_TEST(scenes_agree_with_all_pairs)
{
    // Many on whole numbers, just within reach.
    for (int round = 0; round < 300; round++) {
        cells g =
            begin(random_below(&seed, MOST), 1 << random_below(&seed, 10));
        real size = 1 + random_below(&seed, 3),
             reach = size - (random_below(&seed, 2) ? 0 : 0.5);
        for (int p = 0; p < g.points; p++)
            at[p] = random_below(&seed, 2)
                ? vec3_make(random_below(&seed, 12) - 6,
                            random_below(&seed, 12) - 6,
                            random_below(&seed, 12) - 6)
                  : vec3_make(anywhere(6), anywhere(6), anywhere(6));
        int n = agreed(&g, size, reach, ALL);
        agreed(&g, size, reach, random_below(&seed, n + 1));
        end(&g);
    }
}
END_TEST

START_TEST(room_is_asked_in_proportion_to_its_bodies)
{
    // One point in each cell, on the average: 27 cells, half of them asked.
    for (int n = 1000; n <= 8000; n *= 2) {
        cells g = begin(n, 8192);
        vec3 *place = malloc((size_t)n * sizeof *place);
        ck_assert_ptr_nonnull(place);
        real side = cbrt(n) / 2;
        for (int p = 0; p < n; p++)
            place[p] = vec3_make(anywhere(side), anywhere(side),
                                 anywhere(side));
        ck_assert(cells_pairs(&g, place, 1, 1, NULL, 0) > n);
        ck_assert_msg(g.looked > 8L * n && g.looked < 16L * n, "%d points: %g "
                      "distances each, wanted 10 to 13", n,
                      (real)g.looked / n);
        free(place);
        end(&g);
    }
}
END_TEST

START_TEST(what_has_no_cell_is_refused)
{
    const real bad[4] = { (real)NAN, HUGE_VAL, -HUGE_VAL, 3e12 };
    cells g = begin(3, 16);
    for (int n = 0; n < 12; n++) {
        at[0] = at[1] = at[2] = vec3_make(0, 0, 0);
        if (n / 4 == 0) at[1].x = bad[n % 4];
        if (n / 4 == 1) at[1].y = bad[n % 4];
        if (n / 4 == 2) at[1].z = bad[n % 4];
        ck_assert_int_eq(cells_pairs(&g, at, 1, 1, NULL, 0), -1);
    }
    at[1] = at[0];
    ck_assert_int_eq(cells_pairs(&g, at, 1, 1.001, NULL, 0), -1);
    ck_assert_int_eq(cells_pairs(&g, at, 1, (real)NAN, NULL, 0), -1);
    ck_assert_int_eq(cells_pairs(&g, at, 1, 0, NULL, 0), 3);
    g.points = 0;
    ck_assert_int_eq(cells_pairs(&g, at, 1, 1, NULL, 0), 0);
    end(&g);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        place_has_its_cell,
        same_points_give_the_same_table,
        neighbours_across_the_border_are_found,
        each_pair_comes_once_even_in_a_table_of_one_slot,
        scenes_agree_with_all_pairs,
        room_is_asked_in_proportion_to_its_bodies,
        what_has_no_cell_is_refused,
        NULL
    };
    return suite_run((suite){ .name = "cells", .tests = tests });
}
