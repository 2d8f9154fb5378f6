// check.c - tests of the exercise 08/tournament.

#include "tournament.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdlib.h>

static unsigned long long seed;

// A tournament in memory that ends behind its last match.
static tournament make(int n, const real *value)
{
    tournament t = { n, 1, value, NULL };
    while (t.leaves < n) t.leaves *= 2;
    t.winner = malloc(2 * (size_t)t.leaves * sizeof *t.winner);
    ck_assert_ptr_nonnull(t.winner);
    for (int i = 0; i < 2 * t.leaves; i++) t.winner[i] = -77;
    return t;
}

static int search(const real *value, int n)
{
    int most = n > 0 ? 0 : -1;
    for (int k = 1; k < n; k++)
        if (value[k] > value[most]) most = k;
    return most;
}

// A few values, so that many are equal.
static real *some(int n)
{
    real *value = malloc((size_t)n * sizeof *value + (n == 0));
    ck_assert_ptr_nonnull(value);
    for (int k = 0; k < n; k++) value[k] = (int)(8 * random_fraction(&seed));
    return value;
}

// Rejects: the least, the last of equals, leaves that are no sticks.
START_TEST(winner_is_the_largest)
{
    seed = 1;
    for (int n = 0; n < 40; n++) {
        real *value = some(n);
        tournament t = make(n, value);
        tournament_begin(&t);
        ck_assert_msg(t.winner[1] == search(value, n), "of %d values %d wins, "
                      "wanted %d", n, t.winner[1], search(value, n));
        free(t.winner);
        free(value);
    }
}
END_TEST

// Rejects: a path that does not reach the root, or begins too low.
START_TEST(winner_follows_every_change)
{
    seed = 2;
    for (int n = 1; n < 40; n++) {
        real *value = some(n);
        tournament t = make(n, value);
        tournament_begin(&t);
        for (int again = 0; again < 100; again++) {
            int k = (int)(random_fraction(&seed) * n);
            value[k] = (int)(8 * random_fraction(&seed));
            tournament_change(&t, k);
            ck_assert_msg(t.winner[1] == search(value, n), "value %d of %d has "
                          "changed: %d wins, wanted %d", k, n, t.winner[1],
                          search(value, n));
        }
        free(t.winner);
        free(value);
    }
}
END_TEST

// Rejects: matches played again that nothing has changed: 200,000 times 30,000.
START_TEST(changes_are_cheap)
{
    enum { MANY = 30000 };
    seed = 3;
    real *value = some(MANY);
    tournament t = make(MANY, value);
    tournament_begin(&t);
    for (int again = 0; again < 200000; again++) {
        int k = (int)(random_fraction(&seed) * MANY);
        value[k] = random_fraction(&seed);
        tournament_change(&t, k);
    }
    ck_assert_int_eq(t.winner[1], search(value, MANY));
    free(t.winner);
    free(value);
}
END_TEST

enum { SIDE = 8, POINTS = SIDE * SIDE, STICKS = 2 * SIDE * (SIDE - 1) };

typedef struct {
    particle p[POINTS];
    stick s[STICKS];
    stick_lists around;
} net;

// A net of SIDE x SIDE particles, one of which is struck aside.
static net net_make(int struck)
{
    net b;
    int n = 0;
    for (int i = 0; i < POINTS; i++) {
        vec3 x = { i % SIDE, i / SIDE, 0 };
        b.p[i] = (particle){ x, x, 1 };
        if (i % SIDE + 1 < SIDE)
            b.s[n++] = (stick){ i, i + 1, 1, 1, STICK_EXACT };
        if (i / SIDE + 1 < SIDE)
            b.s[n++] = (stick){ i, i + SIDE, 1, 1, STICK_EXACT };
    }
    b.p[struck].position = vec3_add_scaled(b.p[struck].position, 0.6,
                                           vec3_make(0.64, 0.48, 0.6));
    ck_assert(stick_lists_build(&b.around, b.s, STICKS, POINTS, false).ok);
    return b;
}

static relax_result relax(net *b, int n, int most, real tolerance)
{
    real strain[STICKS];
    relax_options o = relax_options_pbd();
    o.tolerance = tolerance;
    tournament t = make(n, strain);
    relax_result r = tournament_relax(&t, strain, &b->around, b->s, b->p, most,
                                      o);
    free(t.winner);
    return r;
}

// The same choices as sticks_relax_largest.
// Rejects: strains that are out of date.
START_TEST(relaxes_as_the_plain_search_does)
{
    for (int struck = 0; struck < POINTS; struck += 9) {
        net b = net_make(struck), c = net_make(struck);
        relax_options o = relax_options_pbd();
        o.tolerance = 0.02;
        relax_result r = relax(&b, STICKS, 100000, 0.02);
        relax_result w = sticks_relax_largest(c.s, STICKS, c.p, 1000, o);
        ck_assert_double_le(w.worst, 0.02);
        ck_assert_double_le(r.worst, 0.02);
        ck_assert_int_eq(r.relaxed, w.relaxed);
        for (int i = 0; i < POINTS; i++)
            ck_assert_double_lt(vec3_distance(b.p[i].position,
                                              c.p[i].position), 1e-9);
        stick_lists_free(&b.around);
        stick_lists_free(&c.around);
    }
}
END_TEST

// In a net a stick has at most six neighbours.
// Rejects: measuring the whole body after each relaxation.
START_TEST(looks_only_where_something_moved)
{
    net b = net_make(27);
    relax_result r = relax(&b, STICKS, 100000, 0.02);
    ck_assert_int_gt(r.relaxed, 10);
    ck_assert_msg(r.tested <= STICKS + 10 * r.relaxed, "%d relaxed, %d looked "
                  "at", r.relaxed, r.tested);
    stick_lists_free(&b.around);
}
END_TEST

// Rejects: a cap that is not kept.
START_TEST(most_is_kept)
{
    for (int most = 0; most < 5; most++) {
        net b = net_make(27);
        relax_result r = relax(&b, STICKS, most, 1e-9);
        ck_assert_int_eq(r.relaxed, most);
        ck_assert_double_gt(r.worst, 1e-9);
        stick_lists_free(&b.around);
    }
    net b = net_make(27);
    relax_result r = relax(&b, 0, 10, 0);
    ck_assert(r.relaxed == 0 && r.worst == 0);
    stick_lists_free(&b.around);
}
END_TEST

// Rejects: a loop without an end.
START_TEST(hopeless_stick_ends_it)
{
    net b = net_make(27);
    b.p[0].inverse_mass = b.p[1].inverse_mass = 0;
    b.p[0].position.x = -3;
    relax_result r = relax(&b, STICKS, 1000, 0.02);
    ck_assert_double_eq_tol(r.worst, 3, 1e-12);
    stick_lists_free(&b.around);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        winner_is_the_largest,
        winner_follows_every_change,
        changes_are_cheap,
        relaxes_as_the_plain_search_does,
        looks_only_where_something_moved,
        most_is_kept,
        hopeless_stick_ends_it,
        NULL
    };
    return suite_run((suite){ .name = "tournament", .tests = tests });
}
