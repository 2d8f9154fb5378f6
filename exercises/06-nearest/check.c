// check.c - tests of the exercise 06/nearest.

#include "nearest_leaf.h"
#include "random.h"
#include "suite.h"

#include <check.h>
#include <stdio.h>

// Bounds are rounded: a ball may keep out what is nearer by this, of places up
// to 10.
static const real ROUNDING = 1e-13;

enum { MOST = 2048 };

static vec3 at[MOST];

static unsigned long long seed = 66;

static void build(sphere_tree *t, int n)
{
    static leaf_feature leaf[MOST];
    for (int i = 0; i < n; i++) leaf[i] = (leaf_feature){ 1, { i, 0, 0 } };
    status s = sphere_tree_build(t, TREE_LAYERED, at, leaf, n, 0, 0);
    ck_assert_msg(s.ok, "the test's own tree: %s", s.why);
}

// Asks, and compares with all; returns how many nodes were visited.
static int expect(const char *what, const sphere_tree *t, vec3 p)
{
    real distance = -7, best = (real)INFINITY;
    int visited = -7, k = nearest_leaf(t, p, &distance, &visited), which = 0;
    for (int i = 0; i < t->leaves; i++) {
        real d = vec3_distance(p, at[i]);
        if (d < best) which = i;
        best = fmin(best, d);
    }
    ck_assert_msg(k >= 0 && k < t->leaves, "%s: got leaf %d of %d", what, k,
                  t->leaves);
    ck_assert_msg(fabs(vec3_distance(p, at[k]) - best) <= ROUNDING,
                  "%s: leaf %d is %.12g m away, and leaf %d only %.12g", what,
                  k, vec3_distance(p, at[k]), which, best);
    ck_assert_msg(fabs(distance - best) <= ROUNDING, "%s: got the distance "
                  "%.12g, wanted %.12g", what, distance, best);
    ck_assert_msg(visited >= 1 && visited <= t->nodes, "%s: %d nodes visited, "
                  "of %d", what, visited, t->nodes);
    return visited;
}

START_TEST(one_leaf_is_nearest)
{
    // Rejects: children of a leaf, whose number is -1.
    sphere_tree t;
    at[0] = (vec3){ 1, 2, 3 };
    build(&t, 1);
    expect("one leaf", &t, (vec3){ 4, 6, 3 });
    sphere_tree_free(&t);
}
END_TEST

START_TEST(of_a_row_each_is_found)
{
    // Rejects: a leaf left out, one side of the tree never seen.
    sphere_tree t;
    for (int i = 0; i < 33; i++) at[i] = (vec3){ i, 0, 0 };
    build(&t, 33);
    for (int i = 0; i < 33; i++) {
        expect("beside a row", &t, (vec3){ i + 0.25, 2, 0 });
        expect("in a row", &t, (vec3){ i - 0.25, 0, 0 });
    }
    sphere_tree_free(&t);
}
END_TEST

START_TEST(cloud_has_the_slow_answer)
{
    // From inside and from outside.  Rejects: the way downhill only, a bound
    // without the radius, one with the wrong sign.
    sphere_tree t;
    for (int i = 0; i < 300; i++) at[i] = random_vec3(&seed, 1);
    build(&t, 300);
    for (int i = 0; i < 1000; i++)
        expect("a cloud", &t, vec3_scale(i % 2 ? 1 : 4, random_vec3(&seed, 1)));
    sphere_tree_free(&t);
}
END_TEST

START_TEST(points_in_one_place_are_all_nearest)
{
    // All 2,047 balls are the same point.  Rejects: a stack that overflows, a
    // bound that leaves out only what is strictly farther.
    sphere_tree t;
    for (int i = 0; i < MOST; i++) at[i] = (vec3){ 1, 2, 3 };
    build(&t, MOST);
    int visited = expect("in one place", &t, (vec3){ 1, 2, 4 });
    ck_assert_msg(visited <= 64, "2,048 leaves in one place: %d nodes visited; "
                  "what is just as far as the best need not be opened",
                  visited);
    expect("in that place", &t, (vec3){ 1, 2, 3 });
    sphere_tree_free(&t);
}
END_TEST

START_TEST(tree_that_was_refreshed_counts_as_it_is)
{
    // Rejects: places remembered from the build (`rest`).
    sphere_tree t;
    for (int i = 0; i < 100; i++) at[i] = random_vec3(&seed, 1);
    build(&t, 100);
    for (int i = 0; i < 100; i++) at[i] = random_vec3(&seed, 2);
    sphere_tree_refresh(&t, at);
    for (int i = 0; i < 100; i++)
        expect("a new cloud", &t, random_vec3(&seed, 1));
    sphere_tree_free(&t);
}
END_TEST

START_TEST(from_nowhere_nothing_is_near)
{
    sphere_tree t;
    at[0] = (vec3){ 1, 2, 3 };
    build(&t, 1);
    real distance = 0;
    int visited = 0;
    int k = nearest_leaf(&t, (vec3){ 0, (real)NAN, 0 }, &distance, &visited);
    sphere_tree_free(&t);
    ck_assert_msg(k == -1 && distance != distance, "from a place that is no "
                  "number: got leaf %d at %g, wanted -1 at nan", k, distance);
}
END_TEST

START_TEST(most_of_the_tree_is_left_out)
{
    // Rejects: a search of everything; the farther child first.
    sphere_tree t;
    long all = 0;
    for (int i = 0; i < MOST; i++) at[i] = random_vec3(&seed, 1);
    build(&t, MOST);
    for (int i = 0; i < 500; i++)
        all += expect("a cloud of 2,048", &t,
                      vec3_add_scaled(at[i], 0.02, random_vec3(&seed, 1)));
    sphere_tree_free(&t);
    real mean = (real)all / 500;
    printf("2,048 particles, 4,095 nodes: %g visited on average\n", mean);
    ck_assert_msg(mean <= 100, "%g nodes visited on average, wanted no more "
                  "than 100 of 4,095.  Nearer child first, and what cannot be "
                  "nearer than the best is not opened.", mean);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        one_leaf_is_nearest,
        of_a_row_each_is_found,
        cloud_has_the_slow_answer,
        points_in_one_place_are_all_nearest,
        tree_that_was_refreshed_counts_as_it_is,
        from_nowhere_nothing_is_near,
        most_of_the_tree_is_left_out,
        NULL
    };
    return suite_run((suite){ .name = "nearest", .tests = tests });
}
