// check_grid.c - does the grid find what all pairs find, and nothing else?
#include "grid.h"
#include "random.h"
#include "scarce.h"
#include "suite.h"

#include <check.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 24, N = SIDE * SIDE, MOST = 64 * N };

static unsigned long long seed;

static grid g;
static vec3 at[N];
static leaf_pair found[MOST], wanted[MOST];

static void lay_flat(void)
{
    for (int i = 0; i < N; i++)
        at[i] = vec3_make(i % SIDE, 0, i / SIDE);
}

static bool are_neighbours(int a, int b)
{
    return abs(a / SIDE - b / SIDE) <= 1 && abs(a % SIDE - b % SIDE) <= 1;
}

// All pairs, by a and then b.
static int all_pairs(int n, real reach)
{
    int pairs = 0;
    for (int a = 0; a < n; a++)
        for (int b = a + 1; b < n; b++) {
            vec3 d = vec3_sub(at[a], at[b]);
            if (vec3_length_squared(d) < reach * reach && !are_neighbours(a, b))
                wanted[pairs++] = (leaf_pair){ a, b };
        }
    return pairs;
}

static int by_number(const void *p, const void *q)
{
    const leaf_pair *x = p, *y = q;
    return x->a != y->a ? (x->a > y->a) - (x->a < y->a)
                        : (x->b > y->b) - (x->b < y->b);
}

static void expect_all_pairs(int n, real reach)
{
    int pairs = grid_pairs(&g, at, n, reach, SIDE, found, MOST);
    ck_assert_int_eq(pairs, all_pairs(n, reach));
    qsort(found, (size_t)pairs, sizeof *found, by_number);
    for (int k = 0; k < pairs; k++)
        ck_assert_msg(found[k].a == wanted[k].a && found[k].b == wanted[k].b,
                      "pair %d is (%d, %d), not (%d, %d)", k, found[k].a,
                      found[k].b, wanted[k].a, wanted[k].b);
}

// Sheets flat, crumpled, in a ball and in a line; few points and many; cells
// with one of them and cells with hundreds.  Rejects: a cell that is left out,
// a pair that comes twice, neighbours in the sheet, cells that go on around a
// corner, the end of a row beside the beginning of the next.
START_TEST(it_finds_what_all_pairs_find)
{
    static const int count[6] = { 1, 2, 3, 33, 200, N };
    static const vec3 shape[5] = {
        { 0, 0, 0 }, { 0.3, 0.3, 0.3 }, { 4, 4, 4 }, { 40, 40, 40 },
        { 0, 90, 0 }
    };
    ck_assert(grid_init(&g, N).ok);
    for (int k = 0; k < 6; k++)
        for (int s = 0; s < 5; s++)
            for (real reach = 0.7; reach < 4; reach *= 1.5) {
                lay_flat();
                for (int i = 0; i < N; i++) {
                    vec3 d = random_vec3(&seed, 1);
                    if (s == 2 || s == 3) at[i] = (vec3){ 0, 0, 0 };
                    if (s == 4) at[i].x = 0;
                    at[i] = vec3_add(at[i], vec3_make(shape[s].x * d.x,
                                                      shape[s].y * d.y,
                                                      shape[s].z * d.z));
                }
                if (s == 2 && count[k] == N && reach > 2) continue; // too many
                if (s == 3 && count[k] < N) continue;   // far apart: see below
                expect_all_pairs(count[k], reach);
            }
    grid_free(&g);
}
END_TEST

// Rejects: cells counted in metres.
START_TEST(size_and_place_do_not_matter)
{
    ck_assert(grid_init(&g, N).ok);
    for (int power = -100; power <= 100; power += 50) {
        real size = ldexp(1, power);
        lay_flat();
        for (int i = 0; i < N; i++) {
            vec3 d = vec3_add(vec3_make(-7e5, 3e5, 9),
                              random_vec3(&seed, 0.4));
            at[i] = vec3_scale(size, vec3_add(at[i], d));
        }
        expect_all_pairs(N, 2.2 * size);
    }
    grid_free(&g);
}
END_TEST

// Rejects: an endless search for a width, a cell number out of an int, a NaN
// that is sorted somewhere.
START_TEST(who_is_far_away_is_left_to_a_tree)
{
    const real far[5] = { 1e6, -1e30, (real)INFINITY, -(real)INFINITY,
                          (real)NAN };
    ck_assert(grid_init(&g, N).ok);
    for (int k = 0; k < 5; k++)
        for (int axis = 0; axis < 3; axis++) {
            lay_flat();
            // In a line of points alone there may be room for it.
            at[1].y = 9;
            real *x = axis == 0 ? &at[77].x : axis == 1 ? &at[77].y : &at[77].z;
            *x = far[k];
            ck_assert_int_eq(grid_pairs(&g, at, N, 2.1, SIDE, found, MOST), -1);
            lay_flat();
            expect_all_pairs(N, 2.1);
        }
    grid_free(&g);
}
END_TEST

// Rejects: a write beyond the capacity, a count of what was written only.
START_TEST(what_finds_no_room_is_counted)
{
    ck_assert(grid_init(&g, N).ok);
    lay_flat();
    int all = grid_pairs(&g, at, N, 2.1, SIDE, found, MOST);
    ck_assert_int_eq(all, 2 * SIDE * (SIDE - 2));
    found[100] = (leaf_pair){ -7, -7 };
    ck_assert_int_eq(grid_pairs(&g, at, N, 2.1, SIDE, found, 100), all);
    ck_assert_int_eq(found[100].a, -7);
    ck_assert_int_eq(grid_pairs(&g, at, N, 2.1, SIDE, NULL, 0), all);
    ck_assert_int_eq(grid_pairs(&g, at, 0, 2.1, SIDE, NULL, 0), 0);
    grid_free(&g);
}
END_TEST

// Rejects: a write through NULL when memory is refused; memory that is kept.
START_TEST(refused_memory_leaves_it_empty)
{
    for (int allowed = 0; allowed < 3; allowed++) {
        long held = blocks_held;
        mallocs_left = allowed;
        status s = grid_init(&g, N);
        mallocs_left = INT_MAX;
        long left = blocks_held - held;
        ck_assert(!s.ok && g.start == NULL && g.points == 0);
        ck_assert_int_eq(left, 0);
        grid_free(&g);
    }
    ck_assert(grid_init(&g, 0).ok);
    grid_free(&g);
    grid_free(&g);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        it_finds_what_all_pairs_find,
        size_and_place_do_not_matter,
        who_is_far_away_is_left_to_a_tree,
        what_finds_no_room_is_counted,
        refused_memory_leaves_it_empty,
        NULL
    };
    return suite_run((suite){ .name = "grid", .tests = tests });
}
