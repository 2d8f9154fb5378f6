// check.c - tests of the exercise 14/ray.

#include "ray.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>

static const real ROUNDING = 1e-12;

static const crate UNIT = { { 0, 0, 0 }, { 1, 1, 1 } };

static unsigned long long seed = 13;

static ray make(real x, real y, real z, real vx, real vy, real vz)
{
    return (ray){ { x, y, z }, { vx, vy, vz }, HUGE_VAL };
}

static void meets(ray r, real wanted, const char *what)
{
    real time = -7;
    ck_assert_msg(ray_box(&UNIT, r, &time), "%s: it is not met", what);
    near(time, wanted, ROUNDING, what);
}

static void misses(ray r, const char *what)
{
    real time = -7;
    ck_assert_msg(!ray_box(&UNIT, r, &time), "%s: it is met at %g", what, time);
    near(time, -7, 0, "what time was before");
}

START_TEST(ray_meets_a_box_at_its_side)
{
    // Rejects: a sign; sides that are exchanged; 0 that is divided by.
    meets(make(-2, 0.5, 0.5, 1, 0, 0), 2, "from the left");
    meets(make(4, 0.5, 0.5, -2, 0, 0), 1.5, "from the right, at 2 m/s");
    meets(make(0.5, 4, 0.5, 0, -1, 0), 3, "from above");
    meets(make(0.5, 0.5, -1, 0, 0, 1), 1, "from behind");
    meets(make(-3, -1, 0.5, 2, 1, 0), 1.5, "at a slant");
    misses(make(-3, 1.5, 0.5, 1, 0, 0), "above it");
    misses(make(-3, -1, 0.5, 1, 1, 0.6), "past its edge");
}
END_TEST

START_TEST(what_lies_behind_is_not_met)
{
    ray r = make(-2, 0.5, 0.5, 1, 0, 0);
    misses(make(-2, 0.5, 0.5, -1, 0, 0), "it lies behind");
    meets(make(0.25, 0.5, 0.5, -1, 0, 0), 0, "begins inside");
    meets(make(0.5, 0.5, 0.5, 0, 0, 0), 0, "rests inside");
    misses(make(2, 0.5, 0.5, 0, 0, 0), "rests outside");
    r.most = 1.9;
    misses(r, "ends before it");
    r.most = 2;
    meets(r, 2, "ends at its side");
}
END_TEST

START_TEST(ray_along_a_side_touches_it)
{
    // Rejects: 0 / 0, a NaN that passes for a miss, or for no limit.
    meets(make(-2, 1, 0.5, 1, 0, 0), 2, "along the upper side");
    meets(make(-2, 0, 0, 1, 0, 0), 2, "along an edge");
    meets(make(-2, 1, 0.5, 1, -0.0, 0), 2, "with a zero that is negative");
    misses(make(-2, 1.0000001, 0.5, 1, 0, 0), "a hair above it");
    meets(make(-1, -1, -1, 1, 1, 1), 1, "at a corner");
}
END_TEST

START_TEST(what_is_no_number_meets_nothing)
{
    const real none = (real)NAN;
    misses(make(none, 0.5, 0.5, 1, 0, 0), "from nowhere");
    misses(make(-2, 0.5, 0.5, none, 0, 0), "to nowhere");
    misses(make(-2, none, 0.5, 1, 0, 0), "from nowhere, across");
    ray r = make(-2, 0.5, 0.5, 1, 0, 0);
    r.most = none;
    misses(r, "until nowhere");
    crate odd = UNIT;
    real time = 0;
    odd.high.y = none;
    r.most = 9;
    r.way.y = 0.01;
    ck_assert(!ray_box(&odd, r, &time));
}
END_TEST

enum { MOST = 40 };

static crate box[MOST];

START_TEST(reaches_never_shrink)
{
    const real low[4] = { 0, 1, 2, 3 }, high[4] = { 5, 2, 9, 4 };
    const real wanted[4] = { 5, 5, 9, 9 };
    real *mine = malloc(4 * sizeof *mine);
    ck_assert_ptr_nonnull(mine);
    for (int k = 0; k < 4; k++)
        box[k] = (crate){ { low[k], 0, 0 }, { high[k], 1, 1 } };
    ray_reaches(box, 4, mine);
    for (int k = 0; k < 4; k++) near(mine[k], wanted[k], 0, "reach");
    free(mine);
}
END_TEST

// In memory that ends behind the last box.
static ray_hit first(int n, ray r)
{
    crate *mine = malloc((size_t)(n > 0 ? n : 1) * sizeof *mine);
    real *far = malloc((size_t)(n > 0 ? n : 1) * sizeof *far);
    ck_assert(mine && far);
    for (int k = 0; k < n; k++) mine[k] = box[k];
    ray_reaches(mine, n, far);
    ray_hit hit = ray_first(mine, far, n, r);
    free(mine);
    free(far);
    return hit;
}

START_TEST(row_is_met_from_both_sides)
{
    for (int k = 0; k < 10; k++)
        box[k] = (crate){ { 2 * k, 0, 0 }, { 2 * k + 1, 1, 1 } };
    ray_hit hit = first(10, make(-5, 0.5, 0.5, 1, 0, 0));
    ck_assert_msg(hit.box == 0 && hit.time == 5, "from the left: box %d at %g",
                  hit.box, hit.time);
    hit = first(10, make(25, 0.5, 0.5, -1, 0, 0));
    ck_assert_msg(hit.box == 9 && hit.time == 6, "from the right: box %d at %g",
                  hit.box, hit.time);
    hit = first(10, make(7.5, 0.5, 0.5, -1, 0, 0));
    ck_assert_msg(hit.box == 3 && hit.time == 0.5, "from between, leftwards: "
                  "box %d at %g", hit.box, hit.time);
    hit = first(10, make(8.5, 9, 0.5, 0, -1, 0));
    ck_assert_msg(hit.box == 4 && hit.time == 8, "from above: box %d at %g",
                  hit.box, hit.time);
    hit = first(10, make(25, 0.5, 0.5, 1, 0, 0));
    ck_assert_msg(hit.box == -1 && hit.time == HUGE_VAL, "past the row: box %d",
                  hit.box);
    hit = first(0, make(0, 0, 0, 1, 0, 0));
    ck_assert_msg(hit.box == -1 && hit.looked == 0, "no box at all");
}
END_TEST

START_TEST(of_equals_the_lowest_is_met)
{
    for (int k = 0; k < 6; k++)
        box[k] = (crate){ { 0, 0, 0 }, { 1, 1 + k, 1 } };
    for (int right = 0; right < 2; right++) {
        ray_hit hit = first(6, make(right ? -1 : 2, 0.5, 0.5, right ? 1 : -1,
                                    0, 0));
        ck_assert_msg(hit.box == 0 && hit.time == 1, "of six alike box %d",
                      hit.box);
    }
}
END_TEST

static int by_low(const void *a, const void *b)
{
    real x = ((const crate *)a)->low.x, y = ((const crate *)b)->low.x;
    return (x > y) - (x < y);
}

START_TEST(line_agrees_with_all_boxes)
{
    // Whole numbers, so that many touch and many are equal.
    for (int round = 0; round < 20000; round++) {
        int n = random_below(&seed, MOST);
        for (int k = 0; k < n; k++) {
            vec3 low = { random_below(&seed, 20), random_below(&seed, 8),
                         random_below(&seed, 8) };
            vec3 size = { random_below(&seed, random_below(&seed, 8) ? 3 : 20),
                          random_below(&seed, 4), random_below(&seed, 4) };
            box[k] = (crate){ low, vec3_add(low, size) };
        }
        qsort(box, (size_t)n, sizeof *box, by_low);
        ray r = make(random_below(&seed, 24) - 2, random_below(&seed, 12) - 2,
                     random_below(&seed, 12) - 2, random_below(&seed, 5) - 2,
                     random_below(&seed, 5) - 2, random_below(&seed, 5) - 2);
        if (random_below(&seed, 2)) r.most = random_below(&seed, 8);
        ray_hit wanted = { -1, r.most, 0 }, hit = first(n, r);
        for (int k = 0; k < n; k++) {
            real time = 0;
            if (!ray_box(&box[k], r, &time)) continue;
            if (wanted.box >= 0 && !(time < wanted.time)) continue;
            wanted.box = k;
            wanted.time = time;
        }
        ck_assert_msg(hit.box == wanted.box && hit.time == wanted.time,
                      "round %d, %d boxes: box %d at %g, wanted box %d at %g",
                      round, n, hit.box, hit.time, wanted.box, wanted.time);
    }
}
END_TEST

START_TEST(row_asks_few)
{
    // Ten thousand boxes, 2 m apart, of 1 m.  Rejects: a walk that does not
    // begin at the ray, or end at the hit.
    enum { MANY = 10000 };
    crate *row = malloc(MANY * sizeof *row);
    real *far = malloc(MANY * sizeof *far);
    ck_assert(row && far);
    for (int k = 0; k < MANY; k++)
        row[k] = (crate){ { 2 * k, 0, 0 }, { 2 * k + 1, 1, 1 } };
    ray_reaches(row, MANY, far);
    ray across = make(7000.5, 5, 0.5, 0, -1, 0);
    ray right = make(7001.5, 0.5, 0.5, 1, 0, 0);
    ray left = make(7001.5, 0.5, 0.5, -1, 0, 0);
    ray above = make(7001.5, 2, 0.5, 1, 0, 0);
    above.most = 100;
    ray_hit hit = ray_first(row, far, MANY, across);
    ck_assert_msg(hit.box == 3500 && hit.looked <= 3, "across: box %d, asked "
                  "for %d", hit.box, hit.looked);
    across.from.x = 7001.5;
    hit = ray_first(row, far, MANY, across);
    ck_assert_msg(hit.box == -1 && hit.looked <= 3, "across, between two: box "
                  "%d, asked for %d", hit.box, hit.looked);
    hit = ray_first(row, far, MANY, right);
    ck_assert_msg(hit.box == 3501 && hit.looked <= 3, "right: box %d, asked "
                  "for %d", hit.box, hit.looked);
    hit = ray_first(row, far, MANY, left);
    ck_assert_msg(hit.box == 3500 && hit.looked <= 3, "left: box %d, asked "
                  "for %d", hit.box, hit.looked);
    hit = ray_first(row, far, MANY, above);
    ck_assert_msg(hit.box == -1 && hit.looked <= 53, "100 m above the row: box "
                  "%d, asked for %d", hit.box, hit.looked);
    free(row);
    free(far);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        ray_meets_a_box_at_its_side,
        what_lies_behind_is_not_met,
        ray_along_a_side_touches_it,
        what_is_no_number_meets_nothing,
        reaches_never_shrink,
        row_is_met_from_both_sides,
        of_equals_the_lowest_is_met,
        line_agrees_with_all_boxes,
        row_asks_few,
        NULL
    };
    return suite_run((suite){ .name = "ray", .tests = tests });
}
