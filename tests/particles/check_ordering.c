// check_ordering.c - which stick first?  Book: chapter 8.

#include <check.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "ordering.h"
#include "scarce.h"
#include "suite.h"

// A body relaxed to this strain has its lengths to nine figures.
static const real FINE = 1e-9;
// Iterations that no test here should need.
enum { PLENTY = 5000 };

// The four orders that are compared.
enum { LISTED, BREADTH, REPEATED, LARGEST, ORDERS };

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
static relax_result relax(int order, const stick *s, int n, particle *p,
                          int particles, int from, int iterations,
                          relax_options options)
{
    if (order == LARGEST)
        return sticks_relax_largest(s, n, p, iterations, options);
    if (order == LISTED)
        return sticks_relax_from(NULL, -1, s, n, p, iterations, options);
    stick_lists lists;
    ck_assert(stick_lists_build(&lists, s, n, particles,
                                order == REPEATED).ok);
    relax_result r = sticks_relax_from(&lists, from, s, n, p, iterations,
                                       options);
    stick_lists_free(&lists);
    return r;
}

static relax_options to(real tolerance, bool dead_band)
{
    relax_options o = relax_options_pbd();
    o.tolerance = tolerance;
    o.dead_band = dead_band;
    return o;
}

// --- the lists ------------------------------------------------------------

// Of equal distance, the order is the body's.
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
// ours is the body's.
// Rejects: depth first, distance counted from the far end.
START_TEST(figure_7_by_distance)
{
    stick s[7];
    stick_lists l;
    figure_7(s);
    ck_assert(stick_lists_build(&l, s, 7, 5, false).ok);
    const int wanted[7] = { 0, 4, 1, 3, 5, 6, 2 };
    assert_list(&l, 0, wanted, 7);
    const int from_b[7] = { 1, 2, 6, 0, 3, 4, 5 };
    assert_list(&l, 2, from_b, 7);
    stick_lists_free(&l);
    ck_assert_ptr_null(l.stick);
    ck_assert_ptr_null(l.start);
}
END_TEST

// How often each of n sticks stands in the list of particle v.
static void count(const stick_lists *l, int v, int *times, int n)
{
    for (int k = 0; k < n; k++) times[k] = 0;
    for (int i = l->start[v]; i < l->start[v + 1]; i++) {
        ck_assert(l->stick[i] >= 0 && l->stick[i] < n);
        times[l->stick[i]]++;
    }
}

// n = 3: c1 and c5 three times, the next 3/2 = 1 time, c3 once.
// Rejects: n/2 for the neighbours; a stick that is repeated at once, which
// gains nothing; a far stick that comes first.
START_TEST(figure_7_repeated)
{
    stick s[7];
    stick_lists l;
    int times[7];
    const int wanted[7] = { 3, 1, 1, 1, 3, 1, 1 };
    figure_7(s);
    ck_assert(stick_lists_build(&l, s, 7, 5, true).ok);
    count(&l, 0, times, 7);
    for (int k = 0; k < 7; k++)
        ck_assert_msg(times[k] == wanted[k], "c%d stands in the list %d times, "
                      "wanted %d", k + 1, times[k], wanted[k]);
    for (int i = l.start[0] + 1; i < l.start[1]; i++)
        ck_assert_msg(l.stick[i] != l.stick[i - 1], "c%d is repeated at once",
                      l.stick[i] + 1);
    ck_assert_int_eq(l.stick[l.start[0]], 0);
    ck_assert_int_eq(l.stick[l.start[1] - 1], 2);
    stick_lists_free(&l);
}
END_TEST

// A chain of 8 sticks from its end: 8, 4, 2, 1, 1, 1, 1, 1 times.
// Rejects: rounding up, halving once too often, a stick that is left out.
START_TEST(repeats_halve_with_distance)
{
    stick s[8];
    stick_lists l;
    int times[8];
    for (int k = 0; k < 8; k++) s[k] = between(k, k + 1);
    ck_assert(stick_lists_build(&l, s, 8, 9, true).ok);
    const int wanted[8] = { 8, 4, 2, 1, 1, 1, 1, 1 };
    count(&l, 0, times, 8);
    for (int k = 0; k < 8; k++)
        ck_assert_msg(times[k] == wanted[k], "of 8 sticks, the one of distance "
                      "%d stands in the list %d times, wanted %d", k + 1,
                      times[k], wanted[k]);
    // From the middle, n = 4, both halves count.
    ck_assert_int_eq(l.start[5] - l.start[4], 2 * (4 + 2 + 1 + 1));
    stick_lists_free(&l);
}
END_TEST

// From the end of a chain of 16: distance 1 has a turn in every round, distance
// 2 in every second.
// Rejects: all repeats of a stick in the first rounds, or in the last.
START_TEST(repeats_are_spread_over_the_list)
{
    stick s[16];
    stick_lists l;
    for (int k = 0; k < 16; k++) s[k] = between(k, k + 1);
    ck_assert(stick_lists_build(&l, s, 16, 17, true).ok);
    int rounds = 0;
    for (int i = l.start[0]; i < l.start[1]; i++) {
        if (l.stick[i] == 0) rounds++;
        if (l.stick[i] == 1) rounds = 0;
        ck_assert_msg(rounds <= 2, "distance 2 waits for %d rounds", rounds);
    }
    stick_lists_free(&l);
}
END_TEST

// A chain whose sticks are listed from its far end, and run backwards.
// Rejects: distances that are found only along the order of the body.
START_TEST(chain_listed_backwards_has_its_distances)
{
    stick s[9];
    stick_lists l;
    for (int way = 0; way < 4; way++) {
        int wanted[9];
        for (int k = 0; k < 9; k++) {
            int a = way & 1 ? 8 - k : k;
            s[k] = way & 2 ? between(a, a + 1) : between(a + 1, a);
            wanted[k] = way & 1 ? 8 - k : k;
        }
        ck_assert(stick_lists_build(&l, s, 9, 10, false).ok);
        assert_list(&l, 0, wanted, 9);
        stick_lists_free(&l);
    }
}
END_TEST

// 2^40 is no int.
// Rejects: a power that overflows, and a far stick without a turn.
START_TEST(chain_of_forty_keeps_all_its_sticks)
{
    enum { LONG = 40 };
    stick s[LONG];
    stick_lists l;
    int times[LONG];
    for (int k = 0; k < LONG; k++) s[k] = between(k, k + 1);
    ck_assert(stick_lists_build(&l, s, LONG, LONG + 1, true).ok);
    count(&l, 0, times, LONG);
    for (int k = 0; k < LONG; k++) {
        int wanted = k < 6 ? LONG >> k : 1;
        ck_assert_msg(times[k] == wanted, "distance %d: %d times, wanted %d",
                      k + 1, times[k], wanted);
    }
    stick_lists_free(&l);
}
END_TEST

// Every list of an icosahedron holds every stick once, the six at v first.
START_TEST(every_list_holds_every_stick)
{
    ico b = ico_make();
    stick_lists l;
    int times[36];
    ck_assert(stick_lists_build(&l, b.s, 36, 12, false).ok);
    for (int v = 0; v < 12; v++) {
        count(&l, v, times, 36);
        for (int k = 0; k < 36; k++) ck_assert_int_eq(times[k], 1);
        for (int i = 0; i < 36; i++) {
            int k = l.stick[l.start[v] + i];
            ck_assert_int_eq(b.s[k].a == v || b.s[k].b == v, i < 6);
        }
    }
    stick_lists_free(&l);
}
END_TEST

// Rejects: losing what no path reaches.
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
        // Particle 5 has no stick: the order of the body.
        const int wanted[3] = { 0, 1, 2 };
        assert_list(&l, 5, wanted, 3);
        stick_lists_free(&l);
    }
    ck_assert(stick_lists_build(&l, s, 0, 0, true).ok);
    ck_assert_int_eq(l.start[0], 0);
    stick_lists_free(&l);
}
END_TEST

// Of a bundle with a tail every stick of the bundle stands 800 times in the
// lists of the two particles that it joins.
// Rejects: a number of entries that overflows, found out by writing there.
START_TEST(lists_too_long_to_number_are_refused)
{
    enum { BUNDLE = 400000, TAIL = 800 };
    stick *s = malloc((BUNDLE + TAIL) * sizeof *s);
    ck_assert_ptr_nonnull(s);
    for (int k = 0; k < BUNDLE; k++) s[k] = between(0, 1);
    for (int k = 0; k < TAIL; k++) s[BUNDLE + k] = between(1 + k, 2 + k);
    stick_lists l;
    status r = stick_lists_build(&l, s, BUNDLE + TAIL, TAIL + 2, true);
    ck_assert(!r.ok && strstr(r.why, "too long") != NULL);
    ck_assert(!l.start && !l.stick && l.particles == 0);
    free(s);

    // Every stick stands in every list: with so many particles that is enough.
    stick one = between(0, 1), three[3] = { one, one, one };
    r = stick_lists_build(&l, three, 3, INT_MAX / 8, false);
    ck_assert(!r.ok && strstr(r.why, "too long") != NULL);
    ck_assert(!l.start && !l.stick && l.particles == 0);
}
END_TEST

// Rejects: a leak, or half a list, when any one allocation is refused.
START_TEST(refused_memory_leaves_no_lists)
{
    stick s[7];
    figure_7(s);
    for (int n = 0; n < 500; n++) {
        stick_lists l;
        long held = blocks_held;
        mallocs_left = n;
        status r = stick_lists_build(&l, s, 7, 5, true);
        mallocs_left = INT_MAX;
        if (r.ok) { stick_lists_free(&l); return; }
        held = blocks_held - held;
        ck_assert_str_eq(r.why, "out of memory");
        ck_assert(!l.start && !l.stick && l.particles == 0);
        ck_assert_int_eq(held, 0);
    }
    ck_abort_msg("seven sticks need 500 allocations");
}
END_TEST

static void expect_most(const particle *p, const vec3 *before, int n,
                        int wanted, const char *when)
{
    int got = most_moved(p, before, n);
    ck_assert_msg(got == wanted, "%s: got particle %d, wanted %d", when, got,
                  wanted);
}

// Rejects: the last of equals; what is not a number taken for far.
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
    p[3].position.x = (real)NAN;
    expect_most(p, before, 4, 1, "3 is not a number");
}
END_TEST

// --- relaxing -------------------------------------------------------------

// Every order, from the blow, from nowhere, with and without dead band.
// Rejects: a stick that is forgotten; stopping an iteration early.
START_TEST(every_order_reaches_the_tolerance)
{
    for (int i = 0; i < ORDERS; i++)
        for (int from = -1; from < 1; from++)
            for (int band = 0; band < 2; band++) {
                ico b = ico_make();
                b.p[0].position.y -= 0.2;
                b.p[7].position.x += 0.1;
                relax_result r = relax(i, b.s, 36, b.p, 12, from, PLENTY,
                                       to(FINE, band));
                ck_assert_double_le(strain_of(b.s, 36, b.p), 2 * FINE);
                ck_assert_double_le(r.worst, FINE);
                ck_assert_int_gt(r.relaxed, 0);
                ck_assert_int_ge(r.tested, r.relaxed);
            }
}
END_TEST

// Momentum: relaxing keeps the centre of mass, in any order.
START_TEST(every_order_keeps_the_centre_of_mass)
{
    for (int i = 0; i < ORDERS; i++) {
        ico b = ico_make();
        for (int v = 0; v < 12; v++) b.p[v].inverse_mass = 1.0 / (1 + v);
        b.p[0].position.y -= 0.3;
        vec3 before = { 0, 0, 0 }, after = { 0, 0, 0 };
        for (int v = 0; v < 12; v++)
            before = vec3_add_scaled(before, 1 + v, b.p[v].position);
        relax(i, b.s, 36, b.p, 12, 0, PLENTY, to(1e-6, true));
        for (int v = 0; v < 12; v++)
            after = vec3_add_scaled(after, 1 + v, b.p[v].position);
        // A few hundred relaxations of positions near 1 and masses up to 12.
        ck_assert_double_lt(vec3_distance(before, after), 1e-12);
    }
}
END_TEST

// Three links hang from a pinned particle, the lowest end is pulled down.  From
// the pull upwards, one iteration moves every link; from the pin downwards, the
// first two are looked at before anything has moved.
// Rejects: a list that is read from the wrong particle, or not at all.
START_TEST(list_of_the_blow_is_followed)
{
    stick s[3] = { between(0, 1), between(1, 2), between(2, 3) };
    for (int from = -1; from < 4; from += 4) {
        particle p[4];
        for (int i = 0; i < 4; i++) p[i] = at(0, -i, 0, i > 0);
        p[3].position.y -= 0.5;
        relax_result r = relax(BREADTH, s, 3, p, 4, from, 1, to(0.01, true));
        ck_assert_msg(r.relaxed == (from < 0 ? 1 : 3), "from particle %d: %d "
                      "relaxed", from, r.relaxed);
        ck_assert_int_eq(r.tested, 3);
    }
}
END_TEST

// The listed order relaxes what sticks_relax relaxes.
START_TEST(listed_order_is_the_plain_one)
{
    ico b = ico_make(), c;
    b.p[0].position.y -= 0.2;
    c = b;
    relax_options o = to(1e-3, true);
    relax_result r = relax(LISTED, b.s, 36, b.p, 12, 0, PLENTY, o);
    relax_result w = sticks_relax(c.s, 36, c.p, PLENTY, o);
    for (int i = 0; i < 12; i++)
        ck_assert_double_lt(vec3_distance(b.p[i].position, c.p[i].position),
                            1e-12);
    ck_assert_int_eq(r.relaxed, w.relaxed);
    ck_assert_int_eq(r.tested, w.tested);
    ck_assert_double_eq_tol(r.worst, w.worst, 1e-12);
}
END_TEST

// Rejects: a dead band that relaxes all the same; one that is always on.
START_TEST(dead_band_leaves_what_is_within)
{
    for (int i = 0; i < ORDERS; i++) {
        ico b = ico_make(), c = b;
        for (int k = 0; k < 36; k++) b.s[k].rest_length *= 1.009;
        relax_result r = relax(i, b.s, 36, b.p, 12, 0, PLENTY, to(0.01, true));
        ck_assert_int_eq(r.relaxed, 0);
        ck_assert(memcmp(b.p, c.p, sizeof b.p) == 0);
        ck_assert_double_eq_tol(r.worst, 0.009 / 1.009, 1e-12);
        ck_assert_int_le(r.iterations, 1);
        r = relax(i, b.s, 36, b.p, 12, 0, PLENTY, to(0.01, false));
        ck_assert_int_eq(r.relaxed > 0, i != LARGEST);
        ck_assert_int_lt(r.iterations, 10);
    }
}
END_TEST

// Three separate sticks, two of them beyond the tolerance: they alone are
// relaxed.  Then two in a row, the second worse: the first is looked at again.
// Rejects: the least violated first; a stick that is relaxed only once.
START_TEST(largest_comes_first)
{
    stick s[3] = { between(0, 1), between(2, 3), between(4, 5) };
    particle p[6];
    for (int i = 0; i < 6; i++) p[i] = at(i % 2, i / 2, 0, 1);
    p[1].position.x = 1.1;
    p[3].position.x = 1.3;
    p[5].position.x = 1.4;
    relax_result r = relax(LARGEST, s, 3, p, 6, 0, 1, to(0.2, true));
    ck_assert_msg(r.relaxed == 2, "strains 0.1, 0.3 and 0.4, tolerance 0.2: "
                  "got %d relaxations, wanted 2", r.relaxed);
    ck_assert_int_eq(r.tested, 9);
    ck_assert(p[1].position.x == 1.1);
    ck_assert_double_eq_tol(r.worst, 0.1, 1e-12);

    // One relaxation is allowed: it is for the second.
    stick row[2] = { between(0, 1), between(1, 2) };
    p[0] = at(0, 0, 0, 1), p[1] = at(1.1, 0, 0, 1), p[2] = at(2.5, 0, 0, 1);
    r = sticks_relax_largest(row, 2, p, 1, to(0.2, true));
    ck_assert_int_eq(r.relaxed, 2);
    ck_assert_msg(fabs(p[1].position.x - 1.15) <= 1e-12, "the worse of two "
                  "comes first: the middle is at x = %g, wanted 1.15",
                  p[1].position.x);
}
END_TEST

// Southwell needs fewest relaxations on a single blow.
START_TEST(largest_needs_fewest_relaxations)
{
    int relaxed[ORDERS];
    for (int i = 0; i < ORDERS; i++) {
        ico b = ico_make();
        b.p[0].position.y += 0.3;
        relaxed[i] = relax(i, b.s, 36, b.p, 12, 0, PLENTY,
                           to(0.01, true)).relaxed;
    }
    for (int i = 0; i < LARGEST; i++)
        ck_assert_int_lt(relaxed[LARGEST], relaxed[i]);
}
END_TEST

// Two ends pinned too far apart; then coincident ends, which have no direction.
// Rejects: an endless loop, a verdict that all is well.
START_TEST(hopeless_sticks_end)
{
    for (int i = 0; i < ORDERS; i++) {
        stick s[1] = { between(0, 1) };
        particle p[2] = { at(0, 0, 0, 0), at(3, 0, 0, 0) };
        relax_result r = relax(i, s, 1, p, 2, 0, PLENTY, to(FINE, true));
        ck_assert_double_eq_tol(r.worst, 2, 1e-12);
        ck_assert_int_eq(r.relaxed, 0);
        ck_assert_int_lt(r.iterations, PLENTY);

        particle q[2] = { at(0, 0, 0, 1), at(0, 0, 0, 1) };
        r = relax(i, s, 1, q, 2, 0, PLENTY, to(FINE, true));
        ck_assert(r.worst == 1 && r.relaxed == 0);
    }
}
END_TEST

// A particle held by two sticks that contradict each other: the cap ends it.
// Rejects: a cap in the wrong unit.
START_TEST(cap_ends_what_cannot_converge)
{
    for (int i = 0; i < ORDERS; i++)
        for (int most = 0; most < 20; most += 3) {
            stick s[2] = { between(0, 1), between(1, 2) };
            particle p[3] = { at(0, 0, 0, 0), at(1, 0, 0, 1), at(5, 0, 0, 0) };
            relax_result r = relax(i, s, 2, p, 3, 1, most, to(FINE, false));
            ck_assert_int_le(r.relaxed, 2 * most);
            ck_assert(most == 0 || r.relaxed > 0);
            ck_assert(most == 0 || r.worst > 1);
            ck_assert(vec3_is_finite(p[1].position));
        }
}
END_TEST

// Soft sticks, one-sided ones, the approximate root and the old gradient do not
// have their length after one relaxation: they must be looked at again.
// Rejects: taking a stick for right because it was relaxed.
START_TEST(sticks_that_need_several_relaxations_converge)
{
    for (int i = 0; i < ORDERS; i++)
        for (int way = 0; way < 4; way++) {
            ico b = ico_make();
            relax_options o = to(1e-7, true);
            if (way == 1) o.root = ROOT_APPROXIMATE;
            if (way == 2) o.gradient = GRADIENT_OLD;
            for (int k = 0; k < 36; k++) {
                if (way == 0) b.s[k].stiffness = 0.3;
                if (way == 3) b.s[k].kind = (stick_kind)(k % 3);
            }
            b.p[0].position.y -= 0.1;
            relax_result r = relax(i, b.s, 36, b.p, 12, 0, PLENTY, o);
            ck_assert_double_le(r.worst, 1.1e-7);
            ck_assert_double_le(strain_of(b.s, 36, b.p), 2e-7);
        }
}
END_TEST

// A position that is not a number is not called well.
START_TEST(nan_does_not_pass_quietly)
{
    for (int i = 0; i < ORDERS; i++) {
        ico b = ico_make();
        b.p[4].position.x = (real)NAN;
        relax_result r = relax(i, b.s, 36, b.p, 12, 0, 10, to(1e-3, true));
        ck_assert(!(r.worst <= 1e-3));
    }
}
END_TEST

START_TEST(nothing_to_relax)
{
    for (int i = 0; i < ORDERS; i++) {
        relax_result r = relax(i, NULL, 0, NULL, 0, -1, 10, to(0, true));
        ck_assert(r.relaxed == 0 && r.tested == 0 && r.worst == 0);

        // Two sticks that have their length, to the last bit.
        stick s[2] = { between(0, 1), between(1, 2) };
        particle p[3] = { at(0, 0, 0, 1), at(1, 0, 0, 1), at(2, 0, 0, 1) };
        r = relax(i, s, 2, p, 3, 0, 10, to(0, true));
        ck_assert(r.relaxed == 0 && r.worst == 0);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        // Lists.
        figure_7_by_distance,
        figure_7_repeated,
        repeats_halve_with_distance,
        repeats_are_spread_over_the_list,
        chain_listed_backwards_has_its_distances,
        chain_of_forty_keeps_all_its_sticks,
        every_list_holds_every_stick,
        sticks_without_a_path_stand_last,
        refused_memory_leaves_no_lists,
        most_moved_is_the_first_of_the_furthest,
        // Relaxing.
        every_order_reaches_the_tolerance,
        every_order_keeps_the_centre_of_mass,
        list_of_the_blow_is_followed,
        listed_order_is_the_plain_one,
        dead_band_leaves_what_is_within,
        largest_comes_first,
        largest_needs_fewest_relaxations,
        hopeless_sticks_end,
        cap_ends_what_cannot_converge,
        sticks_that_need_several_relaxations_converge,
        nan_does_not_pass_quietly,
        nothing_to_relax,
        // Long lists.
        lists_too_long_to_number_are_refused,
        NULL
    };
    return suite_run((suite){
        .name = "ordering", .tests = tests, .seconds = 60
    });
}
