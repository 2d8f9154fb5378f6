// check.c - tests of the exercise 03/flex.

#include "flex.h"
#include "expect.h"
#include "scarce.h"
#include "suite.h"

#include <check.h>

// Some hundred roundings of numbers near 1, made perpendicular two times.
static const real ROUNDING = 1e-12;
static const real PI = 3.14159265358979323846;

enum { MOST = 32 };

static int list(stick *s, const int (*pair)[2], int n)
{
    for (int k = 0; k < n; k++)
        s[k] = (stick){ pair[k][0], pair[k][1], 1, 1, STICK_EXACT };
    return n;
}

// A flex as each stick sees it, and as the whole.
static void look(const char *what, const vec3 *at, int n, const stick *s,
                 int sticks, const vec3 *flex, real slack)
{
    vec3 sum = { 0, 0, 0 }, turn = { 0, 0, 0 };
    real length = 0;
    for (int i = 0; i < n; i++) {
        sum = vec3_add(sum, flex[i]);
        turn = vec3_add(turn, vec3_cross(vec3_sub(at[i], at[0]), flex[i]));
        length += vec3_length_squared(flex[i]);
    }
    near(length, 1, slack, what, "The sum of all v . v: scale it to 1.");
    near(vec3_length(sum), 0, slack, what, "The sum of all velocities: a flex "
         "is perpendicular to the shifts.");
    near(vec3_length(turn), 0, slack, what, "The sum of all r x v: a flex is "
         "perpendicular to the turns.");
    for (int k = 0; k < sticks; k++) {
        vec3 u = vec3_unit(vec3_sub(at[s[k].b], at[s[k].a]));
        near(vec3_dot(u, vec3_sub(flex[s[k].b], flex[s[k].a])), 0, slack, what,
             "How fast a stick changes its length: no stick may notice.");
    }
}

static void expect(const char *what, const vec3 *at, int n, const stick *s,
                   int sticks, int flexes, real slack)
{
    vec3 flex[MOST];
    for (int i = 0; i < n; i++) flex[i] = (vec3){ 7, 7, 7 };
    int got = flex_find(at, n, s, sticks, flex);
    ck_assert_msg(got == flexes, "%s: got %d flexes, wanted %d: 3 n less what "
                  "is forbidden by sticks, shifts and turns that do not follow "
                  "from each other", what, got, flexes);
    for (int i = 0; flexes == 0 && i < n; i++)
        near(vec3_length(flex[i]), 0, 0, what, "No flex is written as zeros.");
    if (flexes > 0) look(what, at, n, s, sticks, flex, slack);
}

START_TEST(pair_flies_apart)
{
    // Without a stick: 6 numbers, 3 shifts, 2 turns (the third moves no particle).
    // Rejects: 3 n - 6 for every body, a flex that is not scaled.
    vec3 at[2] = { { 1, 0, 0 }, { 3, 0, 0 } }, flex[2];
    stick s = { 0, 1, 2, 1, STICK_EXACT };
    expect("a pair without a stick", at, 2, &s, 0, 1, ROUNDING);
    flex_find(at, 2, &s, 0, flex);
    near(fabs(flex[0].x), sqrt(0.5), ROUNDING, "speed of the first along x",
         "Apart, or together; each with the root of a half.");
    expect("a pair with its stick", at, 2, &s, 1, 0, ROUNDING);
}
END_TEST

START_TEST(hinge_flaps)
{
    // A square and one diagonal: the wings go up, the hinge goes down.
    // Rejects: a flex that is a turn of the whole.
    static const int pair[5][2] = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 },
                                    { 0, 2 } };
    vec3 at[4] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } };
    vec3 flex[4];
    stick s[5];
    list(s, pair, 5);
    expect("a hinge", at, 4, s, 5, 1, ROUNDING);
    flex_find(at, 4, s, 5, flex);
    for (int i = 1; i < 4; i++)
        near(flex[i].z, i % 2 ? -flex[0].z : flex[0].z, ROUNDING,
             "speed out of the plane", "Neighbours go opposite ways.");
    near(fabs(flex[0].z), 0.5, ROUNDING, "speed of the first out of the plane",
         "Four equal speeds, of length 1 in all.");
    expect("a square", at, 4, s, 4, 2, ROUNDING);
    expect("four particles", at, 4, s, 0, 6, ROUNDING);
}
END_TEST

START_TEST(stick_twice_forbids_once)
{
    // Rejects: every stick counted, whether it says something new or not;
    // rounding taken for something new.
    static const int pair[6][2] = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 },
                                    { 1, 0 }, { 0, 1 } };
    vec3 at[4] = { { 0.1, 0.7, 0 }, { 1, 0.2, 0.3 }, { 1, 1, 0 },
                   { 0, 1, 0.9 } };
    stick s[6];
    list(s, pair, 6);
    expect("four sticks, one of them three times", at, 4, s, 6, 2, ROUNDING);
}
END_TEST

START_TEST(cubes_fold_until_they_have_eighteen)
{
    // 12 edges, 4 main diagonals, 6 of sides.  Rejects: a count of sticks for
    // a rank: 16 leave three flexes, not two.
    vec3 at[8];
    stick s[22];
    int n = 0;
    for (int i = 0; i < 8; i++) at[i] = (vec3){ i & 1, i >> 1 & 1, i >> 2 };
    for (int i = 0; i < 8; i++)
        for (int bit = 1; bit < 8; bit *= 2)
            if (!(i & bit))
                s[n++] = (stick){ i, i | bit, 1, 1, STICK_EXACT };
    expect("a cube of 12 sticks", at, 8, s, n, 6, ROUNDING);
    for (int i = 0; i < 4; i++)
        s[n++] = (stick){ i, 7 - i, 1, 1, STICK_EXACT };
    expect("a cube of 16 sticks", at, 8, s, n, 3, ROUNDING);
    static const int side[6][2] = { { 0, 3 }, { 4, 7 }, { 0, 5 }, { 2, 7 },
                                    { 0, 6 }, { 1, 7 } };
    list(s + 12, side, 6);
    expect("a cube of 18 sticks", at, 8, s, 18, 0, ROUNDING);
    expect("a cube of 17 sticks", at, 8, s, 17, 1, ROUNDING);
}
END_TEST

START_TEST(schoenhardts_prism_is_shaky)
{
    // Two triangles, one above the other and turned by -30 degrees: 12 sticks
    // for 12 motions, and one is left.  Turned by 60 it is an octahedron.
    static const int pair[12][2] = {
        { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 }, { 5, 3 },
        { 0, 3 }, { 1, 4 }, { 2, 5 }, { 1, 3 }, { 2, 4 }, { 0, 5 } };
    stick s[12];
    list(s, pair, 12);
    for (int turn = -30; turn <= 60; turn += 90) {
        vec3 at[6];
        for (int i = 0; i < 3; i++) {
            real low = 2 * PI / 3 * i, high = low + turn * PI / 180;
            at[i] = (vec3){ cos(low), sin(low), 0 };
            at[3 + i] = (vec3){ cos(high), sin(high), 1 };
        }
        expect(turn < 0 ? "Schoenhardt's prism" : "an octahedron", at, 6, s, 12,
               turn < 0, ROUNDING);
    }
}
END_TEST

START_TEST(particles_in_a_line_turn_two_ways)
{
    // A rope of two links: 9 numbers, 3 shifts, 2 turns, 2 sticks.
    // Rejects: a turn of length 0 that is scaled to 1.
    vec3 at[3] = { { 0, 0, 0 }, { 0, 0, 1 }, { 0, 0, 3 } };
    stick s[2] = { { 0, 1, 1, 1, STICK_EXACT }, { 1, 2, 1, 1, STICK_EXACT } };
    expect("a straight rope", at, 3, s, 2, 2, ROUNDING);
}
END_TEST

START_TEST(stick_without_length_asks_nothing)
{
    // Rejects: 0 / 0 as its direction.
    vec3 at[3] = { { 0, 0, 0 }, { 0, 0, 0 }, { 1, 2, 3 } };
    stick s[2] = { { 0, 1, 1, 1, STICK_EXACT }, { 1, 2, 1, 1, STICK_EXACT } };
    expect("two in one place", at, 3, s, 2, 3, ROUNDING);
}
END_TEST

START_TEST(far_away_it_folds_alike)
{
    // A micrometre, and a kilometre; and so far from the origin that a metre is
    // nothing beside it, at places that need no rounding.  Rejects: a threshold
    // in metres; turns about the origin of the world.
    static const int pair[5][2] = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 },
                                    { 0, 2 } };
    stick s[5];
    list(s, pair, 5);
    for (real size = 1e-6; size < 1e4; size *= 1e9) {
        vec3 at[4] = { { 0, 0, 0 }, { size, 0, 0 }, { size, size, 0 },
                       { 0, size, size / 2 } };
        expect("a hinge", at, 4, s, 5, 1, ROUNDING * fmax(1, size));
    }
    const real far = 1099511627776;
    vec3 at[4] = { { far, 0, far }, { far + 1, 0, far },
                   { far + 1, 1, far }, { far, 1, far + 0.5 } };
    expect("a hinge far away", at, 4, s, 5, 1, ROUNDING);
}
END_TEST

START_TEST(refused_memory_is_answered)
{
    // Rejects: memory that is written to before it is there, or kept.
    vec3 at[2] = { { 1, 0, 0 }, { 3, 0, 0 } }, flex[2];
    for (int grants = 0; grants < 8; grants++) {
        long before = blocks_held;
        mallocs_left = grants;
        int got = flex_find(at, 2, NULL, 0, flex);
        mallocs_left = INT_MAX;
        long kept = blocks_held - before;
        ck_assert_msg(got == -1 || (grants > 0 && got == 1), "memory given %d "
                      "times: got %d, wanted %s", grants, got,
                      grants > 0 ? "1 or -1" : "-1");
        ck_assert_msg(kept == 0, "%ld blocks of memory are not given back",
                      kept);
    }
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        pair_flies_apart,
        hinge_flaps,
        stick_twice_forbids_once,
        cubes_fold_until_they_have_eighteen,
        schoenhardts_prism_is_shaky,
        particles_in_a_line_turn_two_ways,
        stick_without_length_asks_nothing,
        far_away_it_folds_alike,
        refused_memory_is_answered,
        NULL
    };
    return suite_run((suite){ .name = "flex", .tests = tests });
}
