// check.c - tests of the exercise 06/necklace.

#include "necklace.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdio.h>
#include <string.h>

// Some dozen roundings of numbers up to 100.
static const real ROUNDING = 1e-12;

static const real PI = 3.14159265358979323846;

enum { MOST = 4096, FEW = 300 };

static vec3 at[MOST];
static leaf_pair out[FEW * FEW];

static unsigned long long seed = 8;

// Compares with all pairs, each looked at once.
static tree_result expect(const char *what, necklace n, real near, int apart)
{
    static char met[FEW][FEW];
    memset(met, 0, sizeof met);
    tree_result r = necklace_pairs(&n, near, apart, out, FEW * FEW);
    ck_assert_msg(r.pairs >= 0 && r.pairs <= FEW * FEW, "%s: %d pairs", what,
                  r.pairs);
    for (int k = 0; k < r.pairs; k++) {
        int a = out[k].a, b = out[k].b;
        if (a < 0 || a >= b || b >= n.beads)
            ck_abort_msg("%s: pair (%d, %d), wanted a < b of %d beads", what, a,
                         b, n.beads);
        if (b - a <= apart)
            ck_abort_msg("%s: pair (%d, %d) is only %d links apart, and up to "
                         "%d are neighbours", what, a, b, b - a, apart);
        if (met[a][b])
            ck_abort_msg("%s: pair (%d, %d) comes twice", what, a, b);
        met[a][b] = 1;
    }
    for (int a = 0; a < n.beads; a++)
        for (int b = a + apart + 1; b < n.beads; b++) {
            real d = vec3_distance(at[a], at[b]);
            if (met[a][b] == (d < near) || fabs(d - near) < ROUNDING) continue;
            ck_abort_msg("%s: beads %d and %d are %g m from each other, near "
                         "is %g m, and the pair is %s", what, a, b, d, near,
                         met[a][b] ? "reported" : "missing");
        }
    return r;
}

START_TEST(ball_reaches_as_far_as_the_links)
{
    // Rejects: half of the links rounded down, beads counted for links.
    for (int i = 0; i < 10; i++) at[i] = (vec3){ 0.5 * i, 1, 2 };
    necklace n = { at, 10, 0.5 };
    for (int last = 3; last < 7; last++) {
        sphere s = stretch_ball(&n, 3, last);
        int m = (3 + last) / 2;
        ck_assert_msg(vec3_distance(s.center, at[m]) == 0, "beads 3 to %d: "
                      "the centre is (%g, %g, %g), wanted bead %d", last,
                      s.center.x, s.center.y, s.center.z, m);
        ck_assert_msg(fabs(s.radius - 0.5 * (last - m)) <= ROUNDING, "beads 3 "
                      "to %d: the radius is %g, wanted %d links of 0.5 m",
                      last, s.radius, last - m);
    }
}
END_TEST

START_TEST(stretch_is_in_its_ball_however_it_lies)
{
    // Rejects: a radius that holds for straight ropes only, or for none.
    for (int k = 0; k < 200; k++) {
        vec3 here = { 0, 0, 0 };
        for (int i = 0; i < 50; i++) {
            vec3 d = random_vec3(&seed, 1);
            if (k % 3 == 0) d = (vec3){ 1, 0, 0 };
            at[i] = here;
            here = vec3_add(here, vec3_unit(d));
        }
        necklace n = { at, 50, 1 };
        int first = k % 20, last = first + k % 30;
        sphere s = stretch_ball(&n, first, last);
        for (int i = first; i <= last; i++)
            if (vec3_distance(at[i], s.center) > s.radius + ROUNDING)
                ck_abort_msg("bead %d of %d to %d is %g m from the centre, and "
                             "the radius is %g m", i, first, last,
                             vec3_distance(at[i], s.center), s.radius);
    }
}
END_TEST

START_TEST(straight_rope_has_its_neighbours_only)
{
    // Rejects: pairs along the rope that count, or not enough of them.
    for (int i = 0; i < 40; i++) at[i] = (vec3){ i, 0, 0 };
    necklace n = { at, 40, 1 };
    expect("straight", n, 0.9, 1);
    expect("straight, neighbours too", n, 1.5, 0);
    expect("straight, up to 4 m", n, 4.5, 2);
}
END_TEST

START_TEST(coil_meets_itself)
{
    // A spring: each bead lies above one 20 links before it.  Rejects: one
    // half that is not compared with the other.
    for (int i = 0; i < FEW; i++)
        at[i] = (vec3){ cos(PI * i / 10), sin(PI * i / 10), 0.01 * i };
    necklace n = { at, FEW, 0.32 };
    tree_result r = expect("a coil", n, 0.25, 3);
    ck_assert_msg(r.pairs > 200, "a coil of 15 turns: %d pairs", r.pairs);
}
END_TEST

START_TEST(tangle_has_the_slow_answer)
{
    // Links from 0 to as long as may be.  Rejects: stretches that are left out
    // because the mean link is short.
    for (int k = 0; k < 20; k++) {
        int beads = 2 + 15 * k;
        vec3 here = { 0, 0, 0 };
        for (int i = 0; i < beads; i++) {
            vec3 d = random_vec3(&seed, 1);
            at[i] = here;
            here = vec3_add_scaled(here, i % 7 ? 0.3 : 1, vec3_unit(d));
        }
        expect("a tangle", (necklace){ at, beads, 1 }, 0.5, k % 5);
    }
}
END_TEST

START_TEST(pairs_beyond_capacity_are_counted_not_stored)
{
    // Rejects: one pair past the end.
    for (int i = 0; i < 40; i++) at[i] = (vec3){ i % 2, 0, 0 };
    necklace n = { at, 40, 1 };
    out[5] = (leaf_pair){ -7, -7 };
    tree_result r = necklace_pairs(&n, 0.5, 1, out, 5);
    ck_assert_msg(out[5].a == -7, "room for 5 pairs, and a sixth was written");
    ck_assert_msg(r.pairs == 2 * 190, "40 beads in two places: %d pairs, "
                  "wanted %d: all are counted, also those that find no room",
                  r.pairs, 2 * 190);
}
END_TEST

START_TEST(short_ropes_have_no_pairs)
{
    // Rejects: a halving of one bead, without end.
    at[0] = at[1] = (vec3){ 0, 0, 0 };
    expect("no bead", (necklace){ at, 0, 1 }, 1, 0);
    expect("one bead", (necklace){ at, 1, 1 }, 1, 0);
    expect("two beads in one place", (necklace){ at, 2, 1 }, 1, 0);
    expect("two neighbours", (necklace){ at, 2, 1 }, 1, 1);
}
END_TEST

START_TEST(straight_rope_takes_time_by_its_length)
{
    // Rejects: all pairs; balls that are larger than they have to be.
    long visits[2];
    for (int i = 0; i < MOST; i++) at[i] = (vec3){ i, 0, 0 };
    for (int k = 0; k < 2; k++) {
        necklace n = { at, MOST / (2 - k), 1 };
        visits[k] = necklace_pairs(&n, 0.5, 1, out, FEW).visited;
    }
    printf("straight, %d beads: %ld visits; %d: %ld\n", MOST / 2, visits[0],
           MOST, visits[1]);
    ck_assert_msg(visits[0] > 0 && visits[1] < 20L * MOST, "%d beads: %ld "
                  "pairs of stretches compared, wanted fewer than %d", MOST,
                  visits[1], 20 * MOST);
    ck_assert_msg(10 * visits[1] < 22 * visits[0], "%ld pairs of stretches "
                  "compared, and %ld for twice the beads: wanted about twice "
                  "as many", visits[0], visits[1]);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        ball_reaches_as_far_as_the_links,
        stretch_is_in_its_ball_however_it_lies,
        straight_rope_has_its_neighbours_only,
        coil_meets_itself,
        tangle_has_the_slow_answer,
        pairs_beyond_capacity_are_counted_not_stored,
        short_ropes_have_no_pairs,
        straight_rope_takes_time_by_its_length,
        NULL
    };
    return suite_run((suite){ .name = "necklace", .tests = tests });
}
