// check.c - tests of the exercise 13b/heirs.

#include "heirs.h"
#include "expect.h"
#include "random.h"
#include "suite.h"

#include <check.h>

static const real ROUNDING = 1e-14;
static const vec3 CORNER[4] = { { -1, 0, -1 }, { 1, 0, -1 }, { -1, 0, 1 }, { 1, 0, 1 } };
static heir old[4], now[4];

// A box on its four corners, which give 1, 2, 3 and 4 kg m/s.
static void lay(void)
{
    for (int i = 0; i < 4; i++) {
        old[i] = (heir){ CORNER[i], 1 + i, { 0.1 * (1 + i), 0, 0 } };
        now[i] = (heir){ CORNER[i], -7, { 7, 7, 7 } };
    }
}

static void gives(int i, real push, const char *reason)
{
    near(now[i].push, push, 0, "push that a new point begins with", reason);
    near_vec3(now[i].rub, vec3_make(0.1 * push, 0, 0), ROUNDING, "rub that it begins with", reason);
}

START_TEST(points_that_stayed_keep_what_they_gave)
{
    // Rejects: no memory, friction that is forgotten.
    lay();
    ck_assert_int_eq(points_inherit(now, 4, old, 4, 0.2), 4);
    for (int i = 0; i < 4; i++) gives(i, 1 + i, "It is where it was.");
}
END_TEST

START_TEST(order_does_not_matter)
{
    // Rejects: the same index for the same place.
    lay();
    for (int i = 0; i < 4; i++) now[i].at = vec3_add(CORNER[3 - i], vec3_make(0.05, 0, 0.02));
    ck_assert_int_eq(points_inherit(now, 4, old, 4, 0.2), 4);
    for (int i = 0; i < 4; i++) gives(i, 4 - i, "The points have changed their order, and slid a little.");
}
END_TEST

START_TEST(no_impulse_is_inherited_twice)
{
    // Two new points are near the first old one, and near no other.
    // Rejects: the nearest old point for each.
    lay();
    now[0].at = vec3_make(-1, 0, -0.95);
    now[1].at = vec3_make(-0.99, 0, -1);
    ck_assert_int_eq(points_inherit(now, 2, old, 1, 0.2), 1);
    gives(1, 1, "It is the nearer one.");
    gives(0, 0, "The only old point near it has an heir already: twice the impulse is a hop.");
}
END_TEST

START_TEST(nearest_pair_comes_first)
{
    // On a line: new at 0 and 0.1; old at 0.08 and 0.3.  The second new point is
    // nearest to the first old one; the first new point gets what is left.
    // Rejects: first come, first served.
    for (int i = 0; i < 2; i++) now[i] = (heir){ .at = { i ? 0.1 : 0, 0, 0 } };
    old[0] = (heir){ { 0.08, 0, 0 }, 1, { 0.1, 0, 0 } };
    old[1] = (heir){ { 0.3, 0, 0 }, 2, { 0.2, 0, 0 } };
    ck_assert_int_eq(points_inherit(now, 2, old, 2, 0.5), 2);
    gives(1, 1, "It is 0.02 m from the first old point, the nearest of all pairs.");
    gives(0, 2, "0.3 m are still near enough.");
}
END_TEST

START_TEST(what_is_far_inherits_nothing)
{
    // Rejects: the nearest, however far; a distance that is just `near`; NaN.
    lay();
    now[0].at = vec3_make(0, 0, 0);
    now[1].at = vec3_make(1.25, 0, -1);
    now[2].at = vec3_make((real)NAN, 0, 1);
    ck_assert_int_eq(points_inherit(now, 4, old, 4, 0.25), 1);
    gives(0, 0, "1.4 m are not near.");
    gives(1, 0, "It is `near` apart, and not nearer.");
    gives(2, 0, "NaN is near nothing.");
    gives(3, 4, "It is where it was.");
    ck_assert_int_eq(points_inherit(now, 4, old, 0, 0.25), 0);
    gives(3, 0, "There was no contact before.");
    ck_assert_int_eq(points_inherit(now, 0, old, 4, 0.25), 0);
}
END_TEST

// Is there a pair that would have been nearer for both?  With all distances
// different, only the right answer has none.
static void no_pair_is_nearer(int count, int olds, const int *from, real near)
{
    for (int i = 0; i < count; i++)
        for (int k = 0; k < olds; k++) {
            real d = vec3_distance(now[i].at, old[k].at);
            int heir_of_k = -1;
            for (int m = 0; m < count; m++) if (from[m] == k) heir_of_k = m;
            bool i_would = from[i] < 0 || d < vec3_distance(now[i].at, old[from[i]].at);
            bool k_would = heir_of_k < 0 || d < vec3_distance(now[heir_of_k].at, old[k].at);
            ck_assert_msg(!(d < near && i_would && k_would), "new point %d and old point %d are %g apart, and nearer than "
                          "what they got", i, k, d);
        }
}

START_TEST(random_contacts_have_the_right_heirs)
{
    unsigned long long seed = 13;
    for (int round = 0; round < 20000; round++) {
        int count = random_below(&seed, 5), olds = random_below(&seed, 5), from[4], found = 0;
        for (int i = 0; i < 4; i++) {
            old[i] = (heir){ random_vec3(&seed, 1), 1 + i, { 0.1 * (1 + i), 0, 0 } };
            now[i] = (heir){ random_vec3(&seed, 1), -7, { 7, 7, 7 } };
        }
        int said = points_inherit(now, count, old, olds, 1);
        for (int i = 0; i < count; i++) {
            from[i] = (int)now[i].push - 1;
            found += from[i] >= 0;
            for (int k = 0; k < i; k++) ck_assert_msg(from[i] < 0 || from[i] != from[k], "two inherit from old point %d", from[i]);
            gives(i, 1 + from[i], "Push and rub come from one old point.");
        }
        ck_assert_int_eq(said, found);
        no_pair_is_nearer(count, olds, from, 1);
    }
}
END_TEST

START_TEST(friction_is_across_the_new_normal)
{
    // Rejects: the old impulse as it was; a cone that is left; 0 / 0.
    vec3 normal = { 0, 0.8, 0.6 };
    near_vec3(rub_carried(vec3_make(2, 0, 0), normal, 3), vec3_make(2, 0, 0), ROUNDING, "rub that is across already");
    near_vec3(rub_carried(vec3_make(0, 0, 1), normal, 3), vec3_make(0, -0.48, 0.64), ROUNDING, "rub across a normal that has turned");
    near(vec3_length(rub_carried(vec3_make(2, 0, 1), normal, 0.5)), 0.5, ROUNDING, "kg m/s, of a rub that is too long",
         "It is shortened to the rim of the cone.");
    near_vec3(rub_carried(vec3_make(0, 4, 3), normal, 0), vec3_make(0, 0, 0), 1e-14, "rub along the normal, and no cone");
    near_vec3(rub_carried(vec3_make(0, 0, 0), normal, 0), vec3_make(0, 0, 0), 0, "no rub, and no cone", "0 / 0 is NaN.");
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        points_that_stayed_keep_what_they_gave,
        order_does_not_matter,
        no_impulse_is_inherited_twice,
        nearest_pair_comes_first,
        what_is_far_inherits_nothing,
        random_contacts_have_the_right_heirs,
        friction_is_across_the_new_normal,
        NULL
    };
    return suite_run((suite){ .name = "heirs", .tests = tests });
}
