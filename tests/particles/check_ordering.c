// check_ordering.c - which stick first?  Book: chapter 8.

#include <check.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "ordering.h"
#include "scarce.h"

// A body relaxed to this strain has its lengths to nine figures.
static const real FINE = 1e-9;
// Sweeps that no test here should need.
enum { PLENTY = 5000 };

static const order_kind ALL[] = { ORDER_LISTED, ORDER_BREADTH, ORDER_REPEATED,
                                  ORDER_WORK_LIST, ORDER_LARGEST };

static stick between(int a, int b)
{
    return (stick){ a, b, 1, 1, STICK_EXACT };
}

static particle at(real x, real y, real z, real w)
{
    vec3 v = { x, y, z };
    return (particle){ v, v, w };
}

// The paper's figure 7, c1 to c7 being 0 to 6: a pentagon v a b c e with v = 0,
// whose far side is c3, and two sticks across.
static const int FIGURE_7[7][2] = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 4 },
                                    { 4, 0 }, { 1, 3 }, { 4, 2 } };

static void figure_7(stick *s)
{
    for (int k = 0; k < 7; k++)
        s[k] = between(FIGURE_7[k][0], FIGURE_7[k][1]);
}

// An icosahedron (12 particles, 36 sticks: edges and diagonals) of radius 1.
typedef struct {
    particle p[12];
    stick s[36];
} ico;

static ico ico_make(void)
{
    ico b;
    real height = 1 / sqrt(5), ring = 2 / sqrt(5), turn = acos(-1) / 5;
    b.p[0] = at(0, -1, 0, 1);
    b.p[11] = at(0, 1, 0, 1);
    for (int i = 0; i < 10; i++)
        b.p[i + 1] = at(ring * cos(turn * i), i % 2 ? height : -height,
                        ring * sin(turn * i), 1);
    int n = 0;
    for (int i = 0; i < 12; i++)
        for (int j = i + 1; j < 12; j++) {
            real d = vec3_distance(b.p[i].position, b.p[j].position);
            if (d > 1.2 && d < 1.9) continue;
            b.s[n++] = (stick){ i, j, d, 1, STICK_EXACT };
        }
    ck_assert_int_eq(n, 36);
    return b;
}

// The largest strain that stands.
static real strain_of(const stick *s, int n, const particle *p)
{
    real worst = 0;
    for (int k = 0; k < n; k++) {
        real strain = stick_strain(s[k], p);
        if (!(strain <= worst)) worst = strain;
    }
    return worst;
}

// Relaxes in the given order, building and freeing what it needs.
static relax_result relax(order_kind kind, const stick *s, int n, particle *p,
                          int particles, int from, int sweeps,
                          relax_options options)
{
    stick_lists lists;
    status ok = stick_lists_build(&lists, s, n, particles,
                                  kind == ORDER_REPEATED);
    ck_assert(ok.ok);
    order_scratch *scratch = order_scratch_new(n);
    ck_assert_ptr_nonnull(scratch);
    relax_result r = sticks_relax_ordered(kind, &lists, s, n, p, particles,
                                          from, sweeps, options, scratch);
    order_scratch_free(scratch);
    stick_lists_free(&lists);
    return r;
}

static relax_options to(real tolerance, int dead_band)
{
    relax_options o = relax_options_pbd();
    o.tolerance = tolerance;
    o.dead_band = dead_band;
    return o;
}

// --- the lists ------------------------------------------------------------

static void assert_list(const stick_lists *l, int v, const int *wanted, int n)
{
    int length = l->start[v + 1] - l->start[v];
    ck_assert_msg(length == n, "the list of particle %d has %d entries, wanted "
                  "%d", v, length, n);
    for (int i = 0; i < n; i++)
        ck_assert_msg(l->stick[l->start[v] + i] == wanted[i], "entry %d in the "
                      "list of particle %d: got stick %d, wanted %d", i, v,
                      l->stick[l->start[v] + i], wanted[i]);
}

// The paper: <c1 c5 | c2 c6 c7 c4 | c3>.  Its order within a distance is free;
// ours is the shape's.
// Rejects: depth first, distance counted from the far end.
START_TEST(figure_7_by_distance)
{
    stick s[7];
    stick_lists l;
    figure_7(s);
    ck_assert(stick_lists_build(&l, s, 7, 5, 0).ok);
    const int wanted[7] = { 0, 4, 1, 3, 5, 6, 2 };
    assert_list(&l, 0, wanted, 7);
    stick_lists_free(&l);
    ck_assert_ptr_null(l.stick);
}
END_TEST

// n = 3: c1 and c5 three times, the next 3/2 = 1 time, c3 once.
// Rejects: n/2 for the neighbours, a stick twice in a row.
START_TEST(figure_7_repeated)
{
    stick s[7];
    stick_lists l;
    figure_7(s);
    ck_assert(stick_lists_build(&l, s, 7, 5, 1).ok);
    const int wanted[11] = { 0, 4, 0, 4, 1, 3, 5, 6, 0, 4, 2 };
    assert_list(&l, 0, wanted, 11);
    stick_lists_free(&l);
}
END_TEST

// A chain of 8 sticks from its end: 8, 4, 2, 1, 1, 1, 1, 1 times.
// Rejects: rounding up, halving once too often, a stick that is left out.
START_TEST(repeats_halve_with_distance)
{
    stick s[8];
    stick_lists l;
    for (int k = 0; k < 8; k++) s[k] = between(k, k + 1);
    ck_assert(stick_lists_build(&l, s, 8, 9, 1).ok);
    int times[8] = { 0 };
    const int wanted[8] = { 8, 4, 2, 1, 1, 1, 1, 1 };
    for (int i = l.start[0]; i < l.start[1]; i++) times[l.stick[i]]++;
    for (int k = 0; k < 8; k++)
        ck_assert_msg(times[k] == wanted[k], "of 8 sticks, the one of distance "
                      "%d stands in the list %d times, wanted %d", k + 1,
                      times[k], wanted[k]);
    // From the middle, n = 4, both halves count.
    ck_assert_int_eq(l.start[5] - l.start[4], 2 * (4 + 2 + 1 + 1));
    stick_lists_free(&l);
}
END_TEST

// Every list of an icosahedron holds every stick once, the six at v first.
START_TEST(every_list_holds_every_stick)
{
    ico b = ico_make();
    stick_lists l;
    ck_assert(stick_lists_build(&l, b.s, 36, 12, 0).ok);
    for (int v = 0; v < 12; v++) {
        int seen[36] = { 0 };
        for (int i = 0; i < 36; i++) {
            int k = l.stick[l.start[v] + i];
            seen[k]++;
            int touches = b.s[k].a == v || b.s[k].b == v;
            ck_assert_int_eq(touches, i < 6);
        }
        for (int k = 0; k < 36; k++) ck_assert_int_eq(seen[k], 1);
    }
    stick_lists_free(&l);
}
END_TEST

// Rejects: losing what no path reaches; reading before the first list.
START_TEST(sticks_without_a_path_stand_last)
{
    stick s[3] = { between(3, 4), between(0, 1), between(1, 2) };
    stick_lists l;
    for (int repeated = 0; repeated < 2; repeated++) {
        ck_assert(stick_lists_build(&l, s, 3, 6, repeated).ok);
        int n = l.start[1] - l.start[0];
        ck_assert_int_eq(n, repeated ? 4 : 3);
        ck_assert_int_eq(l.stick[l.start[0]], 1);
        ck_assert_int_eq(l.stick[l.start[1] - 1], 0);
        // Particle 5 has no stick: the order of the shape.
        const int wanted[3] = { 0, 1, 2 };
        assert_list(&l, 5, wanted, 3);
        stick_lists_free(&l);
    }
    ck_assert(stick_lists_build(&l, s, 0, 0, 1).ok);
    ck_assert_int_eq(l.start[0], 0);
    stick_lists_free(&l);
}
END_TEST

// Rejects: trusting the shape's file.
START_TEST(stick_without_ends_is_refused)
{
    stick s[2] = { between(0, 1), between(1, 7) };
    stick_lists l;
    status bad = stick_lists_build(&l, s, 2, 3, 0);
    ck_assert(!bad.ok && strstr(bad.why, "stick 1") != NULL);
    ck_assert_ptr_null(l.start);
    ck_assert_ptr_null(l.stick);
    ck_assert_int_eq(l.particles, 0);
    s[1].b = -1;
    ck_assert(!stick_lists_build(&l, s, 2, 3, 0).ok);
    s[1] = between(3, 1);
    ck_assert(!stick_lists_build(&l, s, 2, 3, 0).ok);
    s[1].a = -1;
    ck_assert(!stick_lists_build(&l, s, 2, 3, 0).ok);
}
END_TEST

static void expect_too_long(const stick *s, int sticks, int particles,
                            int repeated)
{
    stick_lists l;
    status r = stick_lists_build(&l, s, sticks, particles, repeated);
    ck_assert(!r.ok && strstr(r.why, "lists too long to number") != NULL);
    ck_assert(!l.start && !l.stick && l.particles == 0);
}

// Rejects: a number of bytes that overflows, found out by writing there.
START_TEST(lists_too_long_to_number_are_refused)
{
    stick one = between(0, 1);
    expect_too_long(&one, 1, INT_MAX, 0);
    expect_too_long(&one, 0, INT_MAX, 0);
    expect_too_long(&one, 1, INT_MAX / 4 + 1, 0);
    stick three[3] = { one, one, one };
    expect_too_long(three, 3, INT_MAX / 8, 0);

    // Of a bundle with a tail of 3,000 sticks every stick stands 3,000 times in
    // the lists of the two particles that it joins.
    enum { BUNDLE = 100000, TAIL = 3000 };
    stick *s = malloc((BUNDLE + TAIL) * sizeof *s);
    ck_assert_ptr_nonnull(s);
    for (int k = 0; k < BUNDLE; k++) s[k] = between(0, 1);
    for (int k = 0; k < TAIL; k++) s[BUNDLE + k] = between(1 + k, 2 + k);
    expect_too_long(s, BUNDLE + TAIL, TAIL + 2, 1);
    free(s);
}
END_TEST

// Rejects: a leak, or half a list, when any one allocation is refused.
START_TEST(refused_memory_leaves_no_lists)
{
    stick s[7];
    figure_7(s);
    int n = 0;
    for (; n < 20; n++) {
        stick_lists l;
        long held = blocks_held;
        mallocs_left = n;
        status r = stick_lists_build(&l, s, 7, 5, 1);
        mallocs_left = INT_MAX;
        if (r.ok) { stick_lists_free(&l); break; }
        held = blocks_held - held;
        ck_assert_str_eq(r.why, "out of memory");
        ck_assert(!l.start && !l.stick && l.particles == 0);
        ck_assert_int_eq(held, 0);
    }
    ck_assert_int_eq(n, 5);
}
END_TEST

START_TEST(refused_memory_leaves_no_scratch)
{
    int n = 0;
    for (; n < 20; n++) {
        long held = blocks_held;
        mallocs_left = n;
        order_scratch *o = order_scratch_new(36);
        mallocs_left = INT_MAX;
        if (o) { order_scratch_free(o); break; }
        held = blocks_held - held;
        ck_assert_int_eq(held, 0);
    }
    ck_assert_int_eq(n, 5);
}
END_TEST

static void expect_most(const particle *p, const vec3 *before, int n,
                        int wanted, const char *when)
{
    int got = most_moved(p, before, n);
    ck_assert_msg(got == wanted, "%s: got particle %d, wanted %d", when, got,
                  wanted);
}

// Rejects: the last of equals, a distance in place of a comparison.
START_TEST(most_moved_is_the_first_of_the_furthest)
{
    particle p[4];
    vec3 before[4];
    for (int i = 0; i < 4; i++) {
        p[i] = at(i, 0, 0, 1);
        before[i] = p[i].position;
    }
    expect_most(p, before, 4, -1, "none has moved");
    expect_most(p, before, 0, -1, "there are no particles");
    p[3].position.y = -1;
    expect_most(p, before, 4, 3, "the last has moved");
    p[1].position.z = 1;
    expect_most(p, before, 4, 1, "1 and 3 have moved equally far");
}
END_TEST

// --- relaxing -------------------------------------------------------------

// Every order, from the blow, from nowhere, with and without dead band.
// Rejects: a stick that is forgotten; stopping a sweep early.
START_TEST(every_order_reaches_the_tolerance)
{
    for (int i = 0; i < 5; i++)
        for (int from = -1; from < 1; from++)
            for (int band = 0; band < 2; band++) {
                ico b = ico_make();
                b.p[0].position.y -= 0.2;
                b.p[7].position.x += 0.1;
                relax_result r = relax(ALL[i], b.s, 36, b.p, 12, from, PLENTY,
                                       to(FINE, band));
                ck_assert_double_le(strain_of(b.s, 36, b.p), 2 * FINE);
                ck_assert_double_le(r.worst, FINE);
                ck_assert_int_gt(r.relaxed, 0);
                ck_assert_int_ge(r.tested, r.relaxed);
                ck_assert_int_gt(r.iterations, 0);
            }
}
END_TEST

// Momentum: relaxing keeps the centre of mass, in any order.
START_TEST(every_order_keeps_the_centre_of_mass)
{
    for (int i = 0; i < 5; i++) {
        ico b = ico_make();
        for (int v = 0; v < 12; v++) b.p[v].inverse_mass = 1.0 / (1 + v);
        b.p[0].position.y -= 0.3;
        vec3 before = { 0, 0, 0 }, after = { 0, 0, 0 };
        for (int v = 0; v < 12; v++)
            before = vec3_add_scaled(before, 1 + v, b.p[v].position);
        relax(ALL[i], b.s, 36, b.p, 12, 0, PLENTY, to(1e-6, 1));
        for (int v = 0; v < 12; v++)
            after = vec3_add_scaled(after, 1 + v, b.p[v].position);
        // A few hundred relaxations of positions near 1 and masses up to 12.
        ck_assert_double_lt(vec3_distance(before, after), 1e-12);
    }
}
END_TEST

// The listed order is sticks_relax, bit for bit.
START_TEST(listed_order_is_the_plain_sweep)
{
    ico b = ico_make(), c;
    b.p[0].position.y -= 0.2;
    c = b;
    relax_options o = to(1e-3, 1);
    relax_result r = sticks_relax_ordered(ORDER_LISTED, NULL, b.s, 36, b.p, 12,
                                          0, PLENTY, o, NULL);
    relax_result w = sticks_relax(c.s, 36, c.p, PLENTY, o);
    ck_assert(memcmp(b.p, c.p, sizeof b.p) == 0);
    ck_assert_int_eq(r.relaxed, w.relaxed);
    ck_assert_int_eq(r.tested, w.tested);
    ck_assert_int_eq(r.iterations, w.iterations);
    ck_assert(r.worst == w.worst);
}
END_TEST

// Rejects: a dead band that relaxes all the same; one that is always on.
START_TEST(dead_band_leaves_what_is_within)
{
    for (int i = 0; i < 5; i++) {
        ico b = ico_make(), c = b;
        for (int k = 0; k < 36; k++) b.s[k].rest_length *= 1.009;
        relax_result r = relax(ALL[i], b.s, 36, b.p, 12, 0, PLENTY,
                               to(0.01, 1));
        ck_assert_int_eq(r.relaxed, 0);
        ck_assert_int_eq(r.tested, i == 2 ? r.tested : 36);
        ck_assert(memcmp(b.p, c.p, sizeof b.p) == 0);
        ck_assert_double_eq_tol(r.worst, 0.009 / 1.009, 1e-12);
        r = relax(ALL[i], b.s, 36, b.p, 12, 0, PLENTY, to(0.01, 0));
        ck_assert_int_eq(r.relaxed > 0, i < 3);
    }
}
END_TEST

// A chain of 6, stretched at its near end: looked at 6 times, and then only
// the neighbours of what moved.
// Rejects: a work list that starts all over; tests not counted.
START_TEST(work_list_looks_only_where_something_moved)
{
    stick s[6];
    particle p[7];
    for (int i = 0; i < 7; i++) p[i] = at(i, 0, 0, i > 1 ? 0 : 1);
    for (int k = 0; k < 6; k++) s[k] = between(k, k + 1);
    p[0].position.x = -1;
    p[0].inverse_mass = 1e9;    // gives way at once: stick 1 hardly feels it
    relax_result r = relax(ORDER_WORK_LIST, s, 6, p, 7, 0, PLENTY,
                           to(1e-6, 1));
    ck_assert_int_eq(r.relaxed, 1);
    ck_assert_int_eq(r.tested, 6);
    r = relax(ORDER_WORK_LIST, s, 6, p, 7, 6, PLENTY, to(1e-6, 1));
    ck_assert_int_eq(r.tested, 6);

    // Two sticks from a nailed hub have nothing to do with each other.
    stick star[2] = { between(0, 1), between(0, 2) };
    particle q[3] = { at(0, 0, 0, 0), at(1, 0, 0, 1), at(0, 2, 0, 1) };
    r = relax(ORDER_WORK_LIST, star, 2, q, 3, 1, PLENTY, to(1e-6, 1));
    ck_assert(r.relaxed == 1 && r.tested == 2);

    // From the far end stick 0 comes last; then stick 1 is looked at again.
    p[0].position.x = -1;
    r = relax(ORDER_WORK_LIST, s, 6, p, 7, 6, PLENTY, to(1e-6, 1));
    ck_assert_int_eq(r.relaxed, 1);
    ck_assert_int_eq(r.tested, 7);
}
END_TEST

// What it does not look at would not have been relaxed: the same relaxations
// as by distance, to the bit, for fewer looks.
// Rejects: a stick taken for fresh whose end has moved.
START_TEST(work_list_relaxes_what_breadth_relaxes)
{
    for (real tolerance = 0.1; tolerance > 1e-8; tolerance /= 10) {
        ico b = ico_make(), c;
        b.p[5].position.y += 0.2;
        b.p[3].inverse_mass = 0;
        c = b;
        relax_result r = relax(ORDER_WORK_LIST, b.s, 36, b.p, 12, 5, PLENTY,
                               to(tolerance, 1));
        relax_result w = relax(ORDER_BREADTH, c.s, 36, c.p, 12, 5, PLENTY,
                               to(tolerance, 1));
        ck_assert(memcmp(b.p, c.p, sizeof b.p) == 0);
        ck_assert_int_eq(r.relaxed, w.relaxed);
        ck_assert_int_lt(r.tested, w.tested);
    }
}
END_TEST

// Three separate sticks, two of them beyond the tolerance: they alone are
// mended.  Of equals the first.
// Rejects: the least violated first, the last of equals.
START_TEST(largest_comes_first)
{
    stick s[3] = { between(0, 1), between(2, 3), between(4, 5) };
    particle p[6];
    for (int i = 0; i < 6; i++) p[i] = at(i % 2, i / 2, 0, 1);
    p[1].position.x = 1.1;
    p[3].position.x = 1.3;
    p[5].position.x = 1.3;
    relax_result r = relax(ORDER_LARGEST, s, 3, p, 6, 0, 1, to(0.2, 1));
    ck_assert_msg(r.relaxed == 2, "strains 0.1, 0.3 and 0.3, tolerance 0.2: got "
                  "%d relaxations, wanted 2", r.relaxed);
    ck_assert_int_eq(r.tested, 3);
    ck_assert(p[1].position.x == 1.1);
    ck_assert_double_eq_tol(r.worst, 0.1, 1e-12);

    // Equals in a row: the first, then the second, which pulls the middle on.
    stick row[2] = { between(0, 1), between(1, 2) };
    for (int i = 0; i < 3; i++) p[i] = at(1.3 * i, 0, 0, 1);
    r = relax(ORDER_LARGEST, row, 2, p, 3, -1, 1, to(1e-6, 1));
    ck_assert_int_eq(r.relaxed, 2);
    ck_assert_msg(fabs(p[1].position.x - 1.375) <= 1e-12, "two sticks in a row, "
                  "equally wrong: the middle is at x = %g, wanted 1.375 (the "
                  "first of equals comes first)", p[1].position.x);
}
END_TEST

// A stick by itself, with no neighbour to have it looked at again: soft, by the
// approximate root, by the old gradient.  Short by a hair more than the
// tolerance, which the approximate root takes for less.
// Rejects: one relaxation and done; a stick given up because the approximate
// strain lies within the dead band.
START_TEST(one_stick_that_does_not_land_converges)
{
    for (int i = 0; i < 5; i++)
        for (int way = 0; way < 3; way++)
            for (int band = 0; band < 2; band++) {
                stick s[1] = { between(0, 1) };
                particle p[2] = { at(0, 0, 0, 1), at(1.5, 0, 0, 1) };
                relax_options o = to(1e-6, band);
                if (way == 0) s[0].stiffness = 0.3;
                if (way == 1) o.root = ROOT_APPROXIMATE;
                if (way == 2) o.gradient = GRADIENT_OLD;
                relax_result r = relax(ALL[i], s, 1, p, 2, 0, PLENTY, o);
                ck_assert_double_le(stick_strain(s[0], p), 1.1e-6);
                ck_assert_double_le(r.worst, 1e-6);
            }
    stick s[1] = { between(0, 1) };
    particle p[2] = { at(0, 0, 0, 1), at(0.98999, 0, 0, 1) };
    relax_options o = to(0.01, 1);
    o.root = ROOT_APPROXIMATE;
    relax_result r = relax(ORDER_LARGEST, s, 1, p, 2, 0, PLENTY, o);
    ck_assert_int_eq(r.relaxed, 1);
    ck_assert_double_le(r.worst, 0.01);
}
END_TEST

// A repeated list is longer than the budget, and the trouble lies at its end.
// Rejects: a verdict from the part of a sweep that was looked at.
START_TEST(sweep_cut_short_does_not_say_that_all_is_well)
{
    stick s[4];
    particle p[5];
    for (int k = 0; k < 4; k++) {
        s[k] = between(k, k + 1);
        s[k].stiffness = 0.5;   // never quite at rest
    }
    for (int i = 0; i < 5; i++) p[i] = at(1.001 * i + (i > 3), 0, 0, 1);
    relax_result r = relax(ORDER_REPEATED, s, 4, p, 5, 0, 1, to(0.01, 0));
    ck_assert_int_eq(r.relaxed, 4);
    ck_assert_double_eq_tol(r.worst, strain_of(s, 4, p), 1e-12);
    ck_assert_double_gt(r.worst, 0.9);
}
END_TEST

// Southwell needs fewest relaxations on a single blow.
START_TEST(largest_needs_fewest_relaxations)
{
    int relaxed[5];
    for (int i = 0; i < 5; i++) {
        ico b = ico_make();
        b.p[0].position.y += 0.3;
        relaxed[i] = relax(ALL[i], b.s, 36, b.p, 12, 0, PLENTY,
                           to(0.01, 1)).relaxed;
    }
    for (int i = 0; i < 4; i++) ck_assert_int_lt(relaxed[4], relaxed[i]);
}
END_TEST

// Two ends nailed too far apart: nobody can help.
// Rejects: an endless loop, a verdict that all is well.
START_TEST(hopeless_sticks_end)
{
    for (int i = 0; i < 5; i++) {
        stick s[2] = { between(0, 1), between(1, 2) };
        particle p[3] = { at(0, 0, 0, 0), at(3, 0, 0, 0), at(4.5, 0, 0, 1) };
        relax_result r = relax(ALL[i], s, 2, p, 3, 0, PLENTY, to(FINE, 1));
        ck_assert_double_eq_tol(r.worst, 2, 1e-12);
        ck_assert_int_eq(r.relaxed, 1);
        ck_assert_double_eq_tol(p[2].position.x, 4, 1e-12);

        // Coincident ends.
        particle q[3] = { at(0, 0, 0, 1), at(0, 0, 0, 1), at(1, 0, 0, 1) };
        r = relax(ALL[i], s, 1, q, 2, 0, PLENTY, to(FINE, 1));
        ck_assert(r.worst == 1 && r.relaxed == 0);
    }
}
END_TEST

// A particle held by sticks that contradict each other: the budget ends it.
// Rejects: a cap in the wrong unit, one relaxation too many.
START_TEST(budget_ends_what_cannot_converge)
{
    for (int i = 0; i < 5; i++)
        for (int sweeps = 0; sweeps < 20; sweeps += 3) {
            stick s[2] = { between(0, 1), between(1, 2) };
            particle p[3] = { at(0, 0, 0, 0), at(1, 0, 0, 1), at(5, 0, 0, 0) };
            relax_result r = relax(ALL[i], s, 2, p, 3, 0, sweeps,
                                   to(FINE, 1));
            ck_assert_int_eq(r.relaxed, 2 * sweeps);
            ck_assert_double_eq_tol(r.worst, strain_of(s, 2, p), 1e-12);
            ck_assert(vec3_is_finite(p[1].position));
        }
}
END_TEST

// Soft sticks, one-sided ones, the approximate root and the old gradient do not
// land at once: they must be looked at again.
// Rejects: taking a stick for mended because it was relaxed.
START_TEST(sticks_that_do_not_land_at_once_converge)
{
    for (int i = 0; i < 5; i++)
        for (int way = 0; way < 4; way++) {
            ico b = ico_make();
            relax_options o = to(1e-7, 1);
            if (way == 1) o.root = ROOT_APPROXIMATE;
            if (way == 2) o.gradient = GRADIENT_OLD;
            for (int k = 0; k < 36; k++) {
                if (way == 0) b.s[k].stiffness = 0.3;
                if (way == 3) b.s[k].kind = (stick_kind)(k % 3);
            }
            b.p[0].position.y -= 0.1;
            relax_result r = relax(ALL[i], b.s, 36, b.p, 12, 0, PLENTY, o);
            ck_assert_double_le(r.worst, 1e-7);
            ck_assert_double_le(strain_of(b.s, 36, b.p), 2e-7);
        }
}
END_TEST

// A position that is not a number is not called well.
START_TEST(nan_does_not_pass_quietly)
{
    for (int i = 0; i < 5; i++) {
        ico b = ico_make();
        b.p[4].position.x = (real)NAN;
        relax_result r = relax(ALL[i], b.s, 36, b.p, 12, 0, 10, to(1e-3, 1));
        ck_assert(!(r.worst <= 1e-3));
    }
}
END_TEST

// An empty body, and the same bits from the same input.
START_TEST(nothing_to_relax)
{
    for (int i = 0; i < 5; i++) {
        relax_result r = relax(ALL[i], NULL, 0, NULL, 0, -1, 10, to(0, 1));
        ck_assert(r.relaxed == 0 && r.tested == 0 && r.worst == 0);
    }
}
END_TEST

// One scratch serves bodies of different sizes, and forgets what it did.
START_TEST(scratch_may_be_used_again)
{
    order_scratch *big = order_scratch_new(100);
    for (int i = 3; i < 5; i++) {
        ico b = ico_make(), c;
        b.p[0].position.y -= 0.2;
        c = b;
        stick_lists l;
        ck_assert(stick_lists_build(&l, b.s, 36, 12, 0).ok);
        sticks_relax_ordered(ALL[i], &l, b.s, 36, b.p, 12, 0, 1,
                             to(1e-9, 1), big);
        b = c;
        relax_result r = sticks_relax_ordered(ALL[i], &l, b.s, 36, b.p, 12, 0,
                                              PLENTY, to(1e-3, 1), big);
        relax_result w = relax(ALL[i], c.s, 36, c.p, 12, 0, PLENTY,
                               to(1e-3, 1));
        ck_assert(memcmp(b.p, c.p, sizeof b.p) == 0);
        ck_assert_int_eq(r.tested, w.tested);
        stick_lists_free(&l);
    }
    order_scratch_free(big);
    order_scratch_free(NULL);
}
END_TEST

int main(void)
{
    Suite *s = suite_create("ordering");
    TCase *t = tcase_create("lists");
    tcase_add_test(t, figure_7_by_distance);
    tcase_add_test(t, figure_7_repeated);
    tcase_add_test(t, repeats_halve_with_distance);
    tcase_add_test(t, every_list_holds_every_stick);
    tcase_add_test(t, sticks_without_a_path_stand_last);
    tcase_add_test(t, stick_without_ends_is_refused);
    tcase_add_test(t, lists_too_long_to_number_are_refused);
    tcase_add_test(t, refused_memory_leaves_no_lists);
    tcase_add_test(t, refused_memory_leaves_no_scratch);
    tcase_add_test(t, most_moved_is_the_first_of_the_furthest);
    suite_add_tcase(s, t);

    t = tcase_create("relaxing");
    tcase_add_test(t, every_order_reaches_the_tolerance);
    tcase_add_test(t, every_order_keeps_the_centre_of_mass);
    tcase_add_test(t, listed_order_is_the_plain_sweep);
    tcase_add_test(t, dead_band_leaves_what_is_within);
    tcase_add_test(t, work_list_looks_only_where_something_moved);
    tcase_add_test(t, work_list_relaxes_what_breadth_relaxes);
    tcase_add_test(t, largest_comes_first);
    tcase_add_test(t, one_stick_that_does_not_land_converges);
    tcase_add_test(t, sweep_cut_short_does_not_say_that_all_is_well);
    tcase_add_test(t, largest_needs_fewest_relaxations);
    tcase_add_test(t, hopeless_sticks_end);
    tcase_add_test(t, budget_ends_what_cannot_converge);
    tcase_add_test(t, sticks_that_do_not_land_at_once_converge);
    tcase_add_test(t, nan_does_not_pass_quietly);
    tcase_add_test(t, nothing_to_relax);
    tcase_add_test(t, scratch_may_be_used_again);
    suite_add_tcase(s, t);

    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed != 0;
}
