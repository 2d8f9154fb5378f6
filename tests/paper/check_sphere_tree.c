// check_sphere_tree.c - does the tree hold everything, and miss nothing?
#include "scarce.h"
#include "sphere_tree.h"

#include <check.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

// A radius is a square root of sums of a few products: a relative error of
// some 1e-16, times what the equations of four almost flat points lose.
static const real BALL = 1e-12;
// A weighted mean of the world's positions is as good as these, which at 1e7 m
// are 2e-9 m apart.
static const real FAR_OFF = 1e7, FAR_GRAIN = 4e-9;

// ---- shapes ----------------------------------------------------------------

static unsigned long long seed;

static real dice(void)  // -1 to 1, the same on every machine
{
    seed = seed * 6364136223846793005ull + 1442695040888963407ull;
    return (real)(seed >> 11) / 4503599627370496.0 - 1;
}

static vec3 dice3(void)
{
    real x = dice(), y = dice(), z = dice();
    return vec3_make(x, y, z);
}

enum { N = 12, FAMILIES = 12 };

// Point sets that break a solver of four equations, each in its own way.
static void family(int kind, vec3 *at, int n)
{
    for (int i = 0; i < n; i++) {
        vec3 p = dice3();
        real t = dice();
        switch (kind) {
        case 1: p = vec3_scale(t, vec3_make(1, 2, -3)); break;      // in line
        case 2: p.z = 2 * p.x - p.y; break;                         // flat
        case 3: p = vec3_unit(p); break;                            // a sphere
        case 4: p = vec3_make(i & 1, i >> 1 & 1, i >> 2 & 1); break;// a cube
        case 5: if (i > 2) p = at[i % 3]; break;                    // repeated
        case 6: p.z *= 1e-9; break;                                 // a sliver
        case 7: p = vec3_unit(vec3_make(p.x, p.y, 0)); break;       // a circle
        case 8: p = vec3_scale(i ? 1e-9 : 1, p); break;             // one far
        case 9: p.y *= 1e-8; p.z *= 1e-5; break;                    // a needle
        case 10: p = vec3_add(vec3_make(0, 0, 1e-7 * p.z),          // a disc
                              vec3_unit(vec3_make(p.x, p.y, 0))); break;
        case 11: p = vec3_make(i % 3, i / 3, 0); break;             // a grid
        default: break;                                             // a cloud
        }
        at[i] = p;
    }
}

static void count_up(int *index, int n)
{
    for (int i = 0; i < n; i++) index[i] = i;
}

static real largest_distance(const vec3 *at, int n, vec3 center)
{
    real far = 0;
    for (int i = 0; i < n; i++) far = fmax(far, vec3_distance(at[i], center));
    return far;
}

// ---- the slow oracle: the centre is that of one to four of the points -------

// The centre through k points by elimination with pivots in long double.
static int center_through(const vec3 *q, int k, vec3 *center)
{
    long double m[3][4], w[3] = { 0 };
    int n = k - 1;
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            vec3 a = vec3_sub(q[i + 1], q[0]), b = vec3_sub(q[j + 1], q[0]);
            long double x = (long double)a.x, y = (long double)a.y;
            long double z = (long double)a.z;
            m[i][j] = x * (long double)b.x + y * (long double)b.y
                    + z * (long double)b.z;
        }
        m[i][3] = m[i][i] / 2;
    }
    for (int c = 0; c < n; c++) {
        int p = c;
        for (int i = c; i < n; i++) if (fabsl(m[i][c]) > fabsl(m[p][c])) p = i;
        if (m[p][c] == 0) return 0;
        for (int j = 0; j < 4; j++) {
            long double keep = m[c][j];
            m[c][j] = m[p][j];
            m[p][j] = keep;
        }
        for (int i = 0; i < n; i++) {
            if (i == c) continue;
            long double f = m[i][c] / m[c][c];
            for (int j = 0; j < 4; j++) m[i][j] -= f * m[c][j];
        }
    }
    *center = q[0];
    for (int i = 0; i < n; i++) {
        w[i] = m[i][3] / m[i][i];
        *center = vec3_add_scaled(*center, (real)w[i],
                                  vec3_sub(q[i + 1], q[0]));
    }
    return 1;
}

// No centre encloses with less than the smallest ball's radius, and its centre
// is among those tried: the least reach is the answer, with no tolerance.
static real slow_radius(const vec3 *at, int n)
{
    real best = HUGE_VAL;
    for (int bits = 1; bits < 1 << n; bits++) {
        vec3 q[4], center;
        int k = 0;
        for (int i = 0; i < n && k < 5; i++)
            if (bits >> i & 1) { if (k < 4) q[k] = at[i]; k++; }
        if (k <= 4 && center_through(q, k, &center))
            best = fmin(best, largest_distance(at, n, center));
    }
    return best;
}

// ---- balls of points --------------------------------------------------------

// Rejects: stopping before the farthest point is inside.
START_TEST(ball_encloses_every_point)
{
    int sizes[] = { 1, 2, 3, 5, 12, 100, 3000 };
    static vec3 at[3000];
    static int index[3000];
    seed = 1;
    for (int kind = 0; kind < FAMILIES; kind++)
        for (int s = 0; s < 7; s++) {
            int n = sizes[s], support[4], supports;
            real weight[4];
            family(kind, at, n);
            count_up(index, n);
            sphere b = sphere_of_points(at, index, n, support, weight,
                                        &supports);
            ck_assert_msg(largest_distance(at, n, b.center)
                          <= b.radius * (1 + BALL), "kind %d n %d", kind, n);
        }
}
END_TEST

// Rejects: dropping the wrong support; an obtuse triangle's circumscribed
// circle; a sliver's far centre.
START_TEST(ball_is_the_smallest)
{
    seed = 2;
    for (int kind = 0; kind < FAMILIES; kind++)
        for (int run = 0; run < 40; run++) {
            vec3 at[N];
            int index[N], support[4], supports, n = 1 + run % 9;
            real weight[4];
            family(kind, at, n);
            count_up(index, n);
            sphere b = sphere_of_points(at, index, n, support, weight,
                                        &supports);
            real want = slow_radius(at, n);
            ck_assert_msg(b.radius <= want * (1 + BALL)
                          && b.radius >= want * (1 - BALL),
                          "kind %d n %d: got %.17g, wanted %.17g", kind, n,
                          b.radius, want);
        }
}
END_TEST

// Two points 2 apart and one that stands out of their ball by 1e-8: the radius
// is 1 + 5e-17.  Rejects: a coarse test for "outside", which would answer with
// 1 + 1e-8; a search for the largest ball, which cannot see a gain of 1e-16.
START_TEST(a_point_just_outside_is_let_in)
{
    vec3 at[3] = { { -1, 0, 0 }, { 1, 0, 0 }, { 0, 1 + 1e-8, 0 } };
    int index[3] = { 0, 1, 2 }, support[4], supports;
    real weight[4];
    sphere b = sphere_of_points(at, index, 3, support, weight, &supports);
    ck_assert_msg(fabs(b.radius - 1) < BALL, "got %.17g", b.radius);
}
END_TEST

// Rejects: weights that make another centre; a support inside the ball.
START_TEST(centre_is_the_mean_of_its_supports)
{
    seed = 3;
    for (int kind = 0; kind < FAMILIES; kind++)
        for (int run = 0; run < 400; run++) {
            vec3 at[N], mean = { 0 };
            int index[N], support[4], supports;
            real weight[4], sum = 0;
            family(kind, at, N);
            count_up(index, N);
            sphere b = sphere_of_points(at, index, N, support, weight,
                                        &supports);
            ck_assert(supports >= 1 && supports <= 4);
            for (int i = 0; i < supports; i++) {
                ck_assert(weight[i] >= 0);
                sum += weight[i];
                mean = vec3_add_scaled(mean, weight[i], at[support[i]]);
                ck_assert(fabs(vec3_distance(at[support[i]], b.center)
                               - b.radius) <= BALL * b.radius);
                for (int j = 0; j < i; j++) ck_assert(support[i] != support[j]);
            }
            ck_assert(fabs(sum - 1) < BALL);
            ck_assert(vec3_distance(mean, b.center) <= BALL * 4);
        }
}
END_TEST

// Rejects: squares of world coordinates, which at 1e7 m leave no digit of a
// body of 1 m.
START_TEST(ball_far_from_the_origin_is_the_same)
{
    seed = 4;
    for (int kind = 0; kind < FAMILIES; kind++) {
        vec3 at[N], off = vec3_make(FAR_OFF, -FAR_OFF, FAR_OFF / 3);
        int index[N], support[4], supports;
        real weight[4];
        family(kind, at, N);
        count_up(index, N);
        for (int i = 0; i < N; i++) at[i] = vec3_add(at[i], off);
        sphere b = sphere_of_points(at, index, N, support, weight, &supports);
        ck_assert(largest_distance(at, N, b.center) <= b.radius * (1 + BALL));
        for (int i = 0; i < N; i++) at[i] = vec3_sub(at[i], off);
        sphere c = sphere_of_points(at, index, N, support, weight, &supports);
        ck_assert(fabs(b.radius - c.radius) <= FAR_GRAIN);
        ck_assert(vec3_distance(vec3_sub(b.center, off), c.center)
                  <= FAR_GRAIN);
    }
}
END_TEST

// Rejects: a tolerance in metres.  Powers of two change no digit at all.
START_TEST(ball_of_a_smaller_body_is_smaller_to_the_bit)
{
    seed = 5;
    for (int kind = 0; kind < FAMILIES; kind++) {
        vec3 at[N], tiny[N];
        int index[N], support[4], supports;
        real weight[4], scale = 1.0 / (1ll << 60);
        family(kind, at, N);
        count_up(index, N);
        for (int i = 0; i < N; i++) tiny[i] = vec3_scale(scale, at[i]);
        sphere b = sphere_of_points(at, index, N, support, weight, &supports);
        sphere c = sphere_of_points(tiny, index, N, support, weight, &supports);
        ck_assert_msg(c.radius == b.radius * scale, "kind %d", kind);
    }
}
END_TEST

START_TEST(ball_of_few_points_is_known)
{
    vec3 at[4] = { { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } };
    int index[4] = { 0, 1, 2, 3 }, support[4], supports;
    real weight[4];
    ck_assert(sphere_of_points(at, index, 0, support, weight,
                               &supports).radius < 0);
    ck_assert_int_eq(supports, 0);
    ck_assert(sphere_of_points(at, index, 1, support, weight,
                               &supports).radius == 0);
    ck_assert_int_eq(supports, 1);
    ck_assert(fabs(sphere_of_points(at, index, 2, support, weight,
                                    &supports).radius - sqrt(2)) < BALL);
    ck_assert_int_eq(supports, 2);
    ck_assert(fabs(sphere_of_points(at, index, 4, support, weight,
                                    &supports).radius - sqrt(3)) < BALL);
    ck_assert_int_eq(supports, 4);
}
END_TEST

// Rejects: comparisons that step over a NaN and answer as if it were not there.
START_TEST(ball_of_a_bad_point_says_so)
{
    int index[N], support[4], supports;
    real weight[4];
    count_up(index, N);
    for (int bad = 0; bad < N; bad++)
        for (int kind = 0; kind < 2; kind++) {
            vec3 at[N];
            family(0, at, N);
            at[bad].y = kind ? (real)NAN : (real)INFINITY;
            sphere b = sphere_of_points(at, index, N, support, weight,
                                        &supports);
            ck_assert(b.radius != b.radius && b.center.x != b.center.x);
            ck_assert_int_eq(supports, 0);
        }
}
END_TEST

// Rejects: the square of the distance for the distance: a ball of two points,
// of radius 0, because no centre was found.
START_TEST(ball_of_points_beyond_all_numbers_is_infinite)
{
    vec3 at[3] = { { -1e200, 0, 0 }, { 1e200, 0, 0 }, { 0, 1e200, 1 } };
    int index[3], support[4], supports;
    real weight[4];
    count_up(index, 3);
    sphere b = sphere_of_points(at, index, 3, support, weight, &supports);
    ck_assert(vec3_is_finite(b.center) && b.radius == HUGE_VAL);
    ck_assert(supports == 1 && weight[0] == 1);
}
END_TEST

// ---- balls of balls ---------------------------------------------------------

START_TEST(ball_of_two_balls_spans_both)
{
    sphere a = { { 0, 0, 0 }, 1 }, b = { { 6, 0, 0 }, 2 };
    sphere c = sphere_of_spheres(a, b);         // from -1 to 8
    ck_assert(fabs(c.radius - 4.5) < BALL && fabs(c.center.x - 3.5) < BALL);
    c = sphere_of_spheres(b, a);
    ck_assert(fabs(c.radius - 4.5) < BALL && fabs(c.center.x - 3.5) < BALL);
}
END_TEST

// Rejects: 0/0 at equal centres; the formula's smaller ball when one is inside.
START_TEST(a_ball_inside_another_changes_nothing)
{
    sphere a = { { 1, 2, 3 }, 5 }, in = { { 2, 2, 3 }, 1 }, same = a;
    sphere touch = { { 4, 2, 3 }, 2 }, none = { { 9, 9, 9 }, -1 };
    sphere others[] = { in, same, touch, none, { { 1, 2, 3 }, 0 } };
    for (int i = 0; i < 5; i++) {
        sphere c = sphere_of_spheres(a, others[i]);
        sphere d = sphere_of_spheres(others[i], a);
        ck_assert(memcmp(&c, &a, sizeof c) == 0);
        ck_assert(memcmp(&d, &a, sizeof d) == 0);
    }
}
END_TEST

// ---- trees ------------------------------------------------------------------

// A cloth of n x n particles, h apart, and leaves over its vertices, or over
// its triangles with alternating diagonals.
typedef struct {
    int n, points, leaves;
    vec3 *rest, *at;
    leaf_feature *leaf;
} cloth;

static cloth cloth_make(int n, real h, int triangles)
{
    cloth c = { .n = n, .points = n * n,
                .leaves = triangles ? 2 * (n - 1) * (n - 1) : n * n };
    c.rest = calloc((size_t)c.points, sizeof *c.rest);
    c.at   = calloc((size_t)c.points, sizeof *c.at);
    c.leaf = calloc((size_t)c.leaves, sizeof *c.leaf);
    for (int i = 0; i < c.points; i++)
        c.rest[i] = c.at[i] = vec3_make(h * (i % n), 0, h * (i / n));
    for (int i = 0; !triangles && i < c.points; i++)
        c.leaf[i] = (leaf_feature){ 1, { i } };
    for (int j = 0, k = 0; triangles && j < n - 1; j++)
        for (int i = 0; i < n - 1; i++) {
            int a = j * n + i, b = a + 1, d = a + n, e = d + 1;
            int odd = (i + j) & 1;
            c.leaf[k++] = (leaf_feature){ 3, { a, b, odd ? d : e } };
            c.leaf[k++] = (leaf_feature){ 3, { odd ? b : a, e, d } };
        }
    return c;
}

static void cloth_free(cloth *c)
{
    free(c->rest);
    free(c->at);
    free(c->leaf);
}

// Folds the cloth at its middle column, the upper half a height above.
static void cloth_fold(cloth *c, real height)
{
    real middle = c->rest[c->points - 1].x / 2;
    for (int i = 0; i < c->points; i++)
        if (c->rest[i].x > middle)
            c->at[i] = vec3_make(2 * middle - c->rest[i].x, height,
                                 c->rest[i].z);
}

static sphere_tree tree_of(const cloth *c, tree_kind kind, real thickness,
                           real slack)
{
    sphere_tree t;
    status s = sphere_tree_build(&t, kind, c->rest, c->leaf, c->leaves,
                                 thickness, slack);
    ck_assert_msg(s.ok, "%s", s.why);
    return t;
}

// Marks the leaves below node k.
static void mark(const sphere_tree *t, int k, char *below)
{
    if (t->node[k].leaf >= 0) { below[t->node[k].leaf] = 1; return; }
    mark(t, t->node[k].child[0], below);
    mark(t, t->node[k].child[1], below);
}

// The largest part of node k's ball that a thickened point below it reaches:
// at most 1 if it is enclosed.
static real reach_in_node(const sphere_tree *t, const vec3 *at, int k)
{
    char *below = calloc((size_t)t->leaves, 1);
    real reach = 0;
    mark(t, k, below);
    for (int i = 0; i < t->leaves; i++)
        for (int j = 0; below[i] && j < t->leaf[i].count; j++)
            reach = fmax(reach, vec3_distance(at[t->leaf[i].vertex[j]],
                                              t->node[k].ball.center)
                                + t->thickness);
    free(below);
    return reach / t->node[k].ball.radius;
}

static void assert_tree_holds(const sphere_tree *t, const vec3 *at,
                              real tolerance)
{
    for (int k = 0; k < t->nodes; k++) {
        real reach = reach_in_node(t, at, k);
        ck_assert_msg(reach <= 1 + tolerance, "node %d: %.17g", k, reach);
    }
}

// Visits every node: a ball as large as the world meets them all.
static void visit_all(sphere_tree *t, const vec3 *at)
{
    vec3 zero = { 0 };
    leaf_feature one = { 1, { 0 } };
    sphere_tree world;
    ck_assert(sphere_tree_build(&world, TREE_LAYERED, &zero, &one, 1, 1e9,
                                0).ok);
    tree_result r = sphere_tree_pairs(t, at, &world, &zero, 0, NULL, 0);
    ck_assert_int_eq(r.pairs, t->leaves);
    sphere_tree_free(&world);
}

// Turns by the quaternion (1, 2, 3, 4) / sqrt(30), then moves.
static vec3 rigid(vec3 p)
{
    vec3 x = { 20.0 / -30, 20.0 / 30, 10.0 / 30 };
    vec3 y = { 4.0 / 30, -10.0 / 30, 28.0 / 30 };
    vec3 z = { 22.0 / 30, 20.0 / 30, 4.0 / 30 };
    vec3 r = { vec3_dot(x, p), vec3_dot(y, p), vec3_dot(z, p) };
    return vec3_add(r, vec3_make(5, -7, 11));
}

// Rejects: a parent before its child; a leaf twice or never; halves that differ
// by more than one, which would void the bound of the stack.
START_TEST(tree_is_a_tree)
{
    for (int n = 1; n <= 70; n++) {
        vec3 at[70];
        leaf_feature leaf[70];
        sphere_tree t;
        int parents[140] = { 0 }, depth[140] = { 0 }, deepest = 0;
        seed = (unsigned)n;
        family(n % FAMILIES, at, n);
        for (int i = 0; i < n; i++) leaf[i] = (leaf_feature){ 1, { i } };
        ck_assert(sphere_tree_build(&t, TREE_LAYERED, at, leaf, n, 0, 0).ok);
        ck_assert_int_eq(t.nodes, 2 * n - 1);
        for (int k = t.nodes - 1; k >= 0; k--) {
            ck_assert_int_eq(t.node[k].leaf, k < n ? k : -1);
            ck_assert_int_eq(parents[k], k < t.nodes - 1);
            for (int c = 0; k >= n && c < 2; c++) {
                int child = t.node[k].child[c];
                ck_assert(child >= 0 && child < k);
                parents[child]++;
                depth[child] = depth[k] + 1;
                if (depth[child] > deepest) deepest = depth[child];
            }
        }
        ck_assert_int_lt(1 << deepest, 2 * n);
        sphere_tree_free(&t);
    }
}
END_TEST

// Rejects: a split by index order, across the short side, or of ties by chance.
START_TEST(leaves_are_halved_across_the_longest_side)
{
    vec3 at[8];
    leaf_feature leaf[8];
    sphere_tree t;
    char below[8] = { 0 };
    for (int i = 0; i < 8; i++) {
        at[i] = vec3_make(i & 1, 3 * (i >> 1 & 1), i >> 2 & 1);
        leaf[i] = (leaf_feature){ 1, { i } };
    }
    ck_assert(sphere_tree_build(&t, TREE_LAYERED, at, leaf, 8, 0, 0).ok);
    mark(&t, t.node[14].child[0], below);
    for (int i = 0; i < 8; i++) ck_assert_int_eq(below[i], at[i].y == 0);
    sphere_tree_free(&t);

    // All in one place: the lower leaves first.
    memset(at, 0, sizeof at);
    memset(below, 0, sizeof below);
    ck_assert(sphere_tree_build(&t, TREE_LAYERED, at, leaf, 8, 0, 0).ok);
    mark(&t, t.node[14].child[0], below);
    for (int i = 0; i < 8; i++) ck_assert_int_eq(below[i], i < 4);
    sphere_tree_free(&t);
}
END_TEST

// Rejects: an inner ball without the thickness; a triangle's ball around two
// of its vertices.
START_TEST(every_node_holds_what_is_below_it)
{
    for (int triangles = 0; triangles < 2; triangles++)
        for (int kind = TREE_WRAPPED; kind <= TREE_LAYERED; kind++) {
            cloth c = cloth_make(9, 0.25, triangles);
            sphere_tree t = tree_of(&c, (tree_kind)kind, 0.01, 0);
            assert_tree_holds(&t, c.rest, BALL);
            sphere_tree_free(&t);
            cloth_free(&c);
        }
}
END_TEST

// Rejects: the circumscribed ball of an obtuse triangle, and a sliver's.
START_TEST(leaf_balls_are_the_smallest)
{
    seed = 6;
    for (int run = 0; run < 2000; run++) {
        vec3 at[3];
        int index[3] = { 0, 1, 2 }, support[4], supports, n = 2 + run % 2;
        real weight[4];
        leaf_feature f = { n, { 0, 1, 2 } };
        sphere_tree t;
        family(run / 3 % FAMILIES, at, 3);
        sphere want = sphere_of_points(at, index, n, support, weight,
                                       &supports);
        ck_assert(sphere_tree_build(&t, TREE_LAYERED, at, &f, 1, 0, 0).ok);
        ck_assert_msg(fabs(t.node[0].ball.radius - want.radius)
                      <= BALL * want.radius, "run %d: got %.17g, wanted %.17g",
                      run, t.node[0].ball.radius, want.radius);
        sphere_tree_free(&t);
    }
}
END_TEST

// Rejects: a root or a visited node that stayed behind; weights in the wrong
// order.
START_TEST(wrapped_nodes_follow_a_rigid_motion)
{
    cloth c = cloth_make(7, 0.25, 1);
    for (int i = 0; i < c.points; i++) {
        real x = c.rest[i].x - 0.7, z = c.rest[i].z - 0.6;
        c.rest[i].y = x * x - 2 * x * z;                        // not flat
    }
    sphere_tree t = tree_of(&c, TREE_WRAPPED, 0.02, 0);
    for (int i = 0; i < c.points; i++) c.at[i] = rigid(c.rest[i]);
    sphere before = sphere_tree_root(&t, c.rest);
    sphere_tree_refresh(&t, c.at);
    sphere after = sphere_tree_root(&t, c.at);
    ck_assert(vec3_distance(after.center, rigid(before.center)) < BALL * 20);
    visit_all(&t, c.at);
    assert_tree_holds(&t, c.at, BALL * 20);
    sphere_tree_free(&t);
    cloth_free(&c);
}
END_TEST

// Rejects: updating all nodes at a refresh, or the same node twice in one.
START_TEST(wrapped_nodes_are_updated_only_when_visited)
{
    cloth c = cloth_make(16, 0.25, 0);
    sphere_tree t = tree_of(&c, TREE_WRAPPED, 0.02, 0), u = t;
    ck_assert(sphere_tree_build(&u, TREE_WRAPPED, c.rest, c.leaf, c.leaves,
                                0.02, 0).ok);
    for (int i = 0; i < c.points; i++)
        c.at[i] = vec3_add(c.rest[i], vec3_make(100, 0, 0));
    sphere_tree_refresh(&t, c.at);
    tree_result r = sphere_tree_pairs(&t, c.at, &u, c.rest, 0, NULL, 0);
    ck_assert_int_eq(r.visited, 1);             // the roots, far apart
    ck_assert_int_eq(r.updated, 1);             // u has not moved
    r = sphere_tree_pairs(&t, c.at, &u, c.rest, 0, NULL, 0);
    ck_assert_int_eq(r.updated, 0);
    visit_all(&t, c.at);
    r = sphere_tree_self(&t, c.at, 0, 1, NULL, 0);
    ck_assert_int_eq(r.updated, 0);
    sphere_tree_refresh(&t, c.at);
    r = sphere_tree_self(&t, c.at, 0, 1, NULL, 0);
    ck_assert_int_eq(r.updated, t.nodes);       // each leaf meets itself
    sphere_tree_free(&t);
    sphere_tree_free(&u);
    cloth_free(&c);
}
END_TEST

// The mean is carried along by any affine map, and no distance to it grows by
// more than the largest stretch.  Rejects: slack forgotten, or taken from the
// thickness.
START_TEST(slack_holds_a_body_stretched_by_as_much)
{
    cloth c = cloth_make(7, 0.25, 1);
    seed = 7;
    for (int i = 0; i < c.points; i++) c.rest[i].y = dice();
    sphere_tree t = tree_of(&c, TREE_WRAPPED, 0, 0.01);
    sphere_tree tight = tree_of(&c, TREE_WRAPPED, 0, 0);
    // Stretched by 1 % along (1, 1, 1), squeezed by 1 % across.
    for (int i = 0; i < c.points; i++) {
        vec3 p = c.rest[i];
        real along = (p.x + p.y + p.z) / 3;
        c.at[i] = vec3_add_scaled(vec3_scale(0.99, p), 0.02 * along,
                                  vec3_make(1, 1, 1));
    }
    sphere_tree_refresh(&t, c.at);
    sphere_tree_refresh(&tight, c.at);
    visit_all(&t, c.at);
    visit_all(&tight, c.at);
    assert_tree_holds(&t, c.at, BALL);
    int escaped = 0;
    for (int k = 0; k < tight.nodes; k++)
        escaped += reach_in_node(&tight, c.at, k) > 1 + 1e-4;
    ck_assert_int_gt(escaped, 0);               // or the slack was not needed
    sphere_tree_free(&t);
    sphere_tree_free(&tight);
    cloth_free(&c);
}
END_TEST

// Rejects: a refit from the root downwards; a leaf that keeps its old ball.
START_TEST(layered_nodes_follow_a_deformation)
{
    for (int triangles = 0; triangles < 2; triangles++) {
        cloth c = cloth_make(9, 0.25, triangles);
        sphere_tree t = tree_of(&c, TREE_LAYERED, 0.01, 0);
        seed = 8;
        for (int i = 0; i < c.points; i++)
            c.at[i] = vec3_scale(3, dice3());
        sphere_tree_refresh(&t, c.at);
        assert_tree_holds(&t, c.at, BALL);
        sphere_tree_free(&t);
        cloth_free(&c);
    }
}
END_TEST

START_TEST(a_wrapped_ball_is_never_larger_than_a_layered_one)
{
    cloth c = cloth_make(16, 0.25, 0);
    sphere_tree w = tree_of(&c, TREE_WRAPPED, 0.01, 0);
    sphere_tree l = tree_of(&c, TREE_LAYERED, 0.01, 0);
    for (int k = 0; k < w.nodes; k++)
        ck_assert(w.node[k].ball.radius <= l.node[k].ball.radius * (1 + BALL));
    ck_assert(w.node[w.nodes - 1].ball.radius
              < 0.8 * l.node[l.nodes - 1].ball.radius);
    sphere_tree_free(&w);
    sphere_tree_free(&l);
    cloth_free(&c);
}
END_TEST

// ---- pairs ------------------------------------------------------------------

enum { MANY = 40000 };
static leaf_pair found[MANY], wanted[MANY];

static int by_numbers(const void *p, const void *q)
{
    const leaf_pair *a = p, *b = q;
    int first = (a->a > b->a) - (a->a < b->a);
    return first ? first : (a->b > b->b) - (a->b < b->b);
}

static int balls_near(sphere a, sphere b, real margin)
{
    return vec3_distance(a.center, b.center) < a.radius + b.radius + margin;
}

static void assert_found_is_wanted(tree_result r, int want)
{
    ck_assert_int_eq(r.pairs, want);
    qsort(found, (size_t)want, sizeof *found, by_numbers);
    qsort(wanted, (size_t)want, sizeof *wanted, by_numbers);
    for (int i = 0; i < want; i++) {
        ck_assert_int_eq(found[i].a, wanted[i].a);
        ck_assert_int_eq(found[i].b, wanted[i].b);
    }
}

// Two clothes that cross; the wrapped ones of vertices, whose leaf spheres lie
// inside their parents'.
static void cross(cloth *a, sphere_tree *ta, cloth *b, sphere_tree *tb, int run)
{
    tree_kind ka = run & 1 ? TREE_WRAPPED : TREE_LAYERED;
    tree_kind kb = run & 2 ? TREE_WRAPPED : TREE_LAYERED;
    *a = cloth_make(9, 0.25, run >> 4 & 1);
    *b = cloth_make(run & 4 ? 3 : 8, run & 8 ? 0.02 : 0.3, run >> 4 & 1);
    *ta = tree_of(a, ka, 0.05, 0);
    *tb = tree_of(b, kb, 0.01, 0);
    for (int i = 0; i < b->points; i++)
        b->at[i] = vec3_sub(rigid(b->rest[i]),
                            vec3_make(4, -7, 10 + 0.1 * run / 24));
    sphere_tree_refresh(ta, a->at);
    sphere_tree_refresh(tb, b->at);
    visit_all(ta, a->at);
    visit_all(tb, b->at);
}

// Rejects: a branch of the traversal that forgets a child, in trees alike and
// very unlike in size and number.
START_TEST(pairs_are_those_of_all_against_all)
{
    for (int run = 0; run < 64; run++) {
        cloth a, b;
        sphere_tree ta, tb;
        if (run & 16 && run & 3) continue;      // wrapped triangles: below
        cross(&a, &ta, &b, &tb, run);
        real margin = run & 32 ? 0.1 : 0;
        int want = 0;
        for (int i = 0; i < ta.leaves; i++)
            for (int j = 0; j < tb.leaves; j++)
                if (balls_near(ta.node[i].ball, tb.node[j].ball, margin))
                    wanted[want++] = (leaf_pair){ i, j };
        tree_result r = sphere_tree_pairs(&ta, a.at, &tb, b.at, margin, found,
                                          MANY);
        ck_assert(want > 0 || !(run & 16));
        assert_found_is_wanted(r, want);
        sphere_tree_free(&ta);
        sphere_tree_free(&tb);
        cloth_free(&a);
        cloth_free(&b);
    }
}
END_TEST

// The least distance between two triangles on a lattice of points of each.
static real sampled_distance(const vec3 *p, const int *a, const vec3 *q,
                             const int *b)
{
    enum { STEPS = 6 };
    real least = HUGE_VAL;
    for (int n = 0; n < STEPS * STEPS * STEPS * STEPS; n++) {
        int u = n % STEPS, v = n / 6 % STEPS, s = n / 36 % STEPS, t = n / 216;
        real e = 1.0 / (STEPS - 1);
        if (u + v >= STEPS || s + t >= STEPS) continue;
        vec3 x = vec3_add(p[a[0]], vec3_add(
            vec3_scale(e * u, vec3_sub(p[a[1]], p[a[0]])),
            vec3_scale(e * v, vec3_sub(p[a[2]], p[a[0]]))));
        vec3 y = vec3_add(q[b[0]], vec3_add(
            vec3_scale(e * s, vec3_sub(q[b[1]], q[b[0]])),
            vec3_scale(e * t, vec3_sub(q[b[2]], q[b[0]]))));
        least = fmin(least, vec3_distance(x, y));
    }
    return least;
}

// A wrapped node holds its triangles, but not their spheres: it may rule out a
// pair of spheres that overlap, never of triangles that come near.
START_TEST(wrapped_trees_miss_no_triangles_that_come_near)
{
    int ruled_out = 0, near = 0;
    for (int run = 16; run < 48; run++) {
        cloth a, b;
        sphere_tree ta, tb;
        if (!(run & 16) || !(run & 3)) continue;
        cross(&a, &ta, &b, &tb, run);
        tree_result r = sphere_tree_pairs(&ta, a.at, &tb, b.at, 0, found, MANY);
        qsort(found, (size_t)r.pairs, sizeof *found, by_numbers);
        for (int i = 0; i < ta.leaves; i++)
            for (int j = 0; j < tb.leaves; j++) {
                leaf_pair key = { i, j };
                if (bsearch(&key, found, (size_t)r.pairs, sizeof key,
                            by_numbers)) {
                    ck_assert(balls_near(ta.node[i].ball, tb.node[j].ball, 0));
                    continue;
                }
                if (!balls_near(ta.node[i].ball, tb.node[j].ball, 0)) continue;
                ruled_out++;
                ck_assert(sampled_distance(a.at, a.leaf[i].vertex, b.at,
                                           b.leaf[j].vertex) > 0.06);
            }
        near += r.pairs;
        sphere_tree_free(&ta);
        sphere_tree_free(&tb);
        cloth_free(&a);
        cloth_free(&b);
    }
    ck_assert_int_gt(ruled_out, 0);
    ck_assert_int_gt(near, 100);
}
END_TEST

static int neighbours_at_rest(const sphere_tree *t, int a, int b, real apart)
{
    for (int i = 0; i < t->leaf[a].count; i++)
        for (int j = 0; j < t->leaf[b].count; j++)
            if (t->leaf[a].vertex[i] == t->leaf[b].vertex[j]) return 1;
    return vec3_distance(t->rest[a].center, t->rest[b].center)
        < apart * (t->rest[a].radius + t->rest[b].radius);
}

// Rejects: a pair twice, or as (b, a); a leaf with itself; the rest rule on
// today's positions; neighbours that were never left out.
START_TEST(self_pairs_are_those_of_all_against_all)
{
    int total = 0;
    for (int run = 0; run < 16; run++) {
        tree_kind kind = run & 2 ? TREE_WRAPPED : TREE_LAYERED;
        cloth c = cloth_make(11, 0.25, kind == TREE_LAYERED && (run & 1));
        sphere_tree t = tree_of(&c, kind, run & 4 ? 0.14 : 0.01, 0);
        real margin = run & 8 ? 0.1 : 0;
        real apart = run & 4 ? 1.4 : run & 8 ? 0 : 1 + 1e-9;
        seed = (unsigned)run;
        if (kind == TREE_LAYERED) cloth_fold(&c, 0.1);
        for (int i = 0; kind == TREE_LAYERED && i < c.points; i++)
            c.at[i] = vec3_add_scaled(c.at[i], 0.1, dice3());
        sphere_tree_refresh(&t, c.at);
        if (kind == TREE_WRAPPED) visit_all(&t, c.at);
        int want = 0;
        for (int i = 0; i < t.leaves; i++)
            for (int j = i + 1; j < t.leaves; j++)
                if (balls_near(t.node[i].ball, t.node[j].ball, margin)
                    && !neighbours_at_rest(&t, i, j, apart))
                    wanted[want++] = (leaf_pair){ i, j };
        tree_result r = sphere_tree_self(&t, c.at, margin, apart, found, MANY);
        assert_found_is_wanted(r, want);
        total += want;
        sphere_tree_free(&t);
        cloth_free(&c);
    }
    ck_assert_int_gt(total, 1000);
}
END_TEST

// Spheres of triangles of a cell share their centre, and those of cells at a
// corner's distance are tangent.  Rejects: a rest rule by shared vertices only,
// and one without a margin for rounding.
START_TEST(flat_cloth_has_no_pairs)
{
    for (int n = 3; n <= 41; n += 19)
        for (int triangles = 0; triangles < 2; triangles++)
            for (int k = 0; k < 4; k++) {
                real h = 2.0 / (n - 1);
                real thick = triangles ? 0 : (k & 1 ? 0.55 : 0.5) * h;
                real margin = k & 2 ? 0.4 * h : 0;
                cloth c = cloth_make(n, h, triangles);
                sphere_tree t = tree_of(&c, TREE_LAYERED, thick, 0);
                real radii = 2 * (triangles ? h / sqrt(2) : thick);
                real apart = (1 + 1e-9) * (1 + margin / radii);
                sphere_tree_refresh(&t, c.at);
                tree_result r = sphere_tree_self(&t, c.at, margin, apart, NULL,
                                                 0);
                ck_assert_int_eq(r.pairs, 0);
                for (int i = 0; i < c.points; i++) c.at[i] = rigid(c.rest[i]);
                sphere_tree_refresh(&t, c.at);
                r = sphere_tree_self(&t, c.at, margin, apart, NULL, 0);
                ck_assert_int_eq(r.pairs, 0);
                sphere_tree_free(&t);
                cloth_free(&c);
            }
}
END_TEST

// Ten by ten cells: 240 pairs of triangles without a common vertex have tangent
// balls at rest.  Rejects: leaving out only those that share a vertex.
START_TEST(triangles_apart_may_be_tangent_at_rest)
{
    cloth c = cloth_make(11, 0.25, 1);
    sphere_tree t = tree_of(&c, TREE_LAYERED, 0, 0);
    tree_result r = sphere_tree_self(&t, c.at, 1e-9, 0, NULL, 0);
    ck_assert_int_eq(r.pairs, 240);
    r = sphere_tree_self(&t, c.at, 1e-10, 1 + 1e-9, NULL, 0);
    ck_assert_int_eq(r.pairs, 0);
    sphere_tree_free(&t);
    cloth_free(&c);
}
END_TEST

// Each particle of the upper half stands over one of the lower, lower than the
// spheres' 1.1 h: these pairs and, but for those near the fold that were
// neighbours at rest, no others.
START_TEST(folded_cloth_reports_the_particles_above_each_other)
{
    enum { ROWS = 20 };
    real h = 0.1;
    cloth c = cloth_make(ROWS, h, 0);
    sphere_tree t = tree_of(&c, TREE_LAYERED, 0.55 * h, 0);
    cloth_fold(&c, 0.9 * h);
    sphere_tree_refresh(&t, c.at);
    tree_result r = sphere_tree_self(&t, c.at, 0, 1 + 1e-9, found, MANY);
    // The two columns at the fold stood h apart at rest: they are neighbours.
    ck_assert_int_eq(r.pairs, ROWS * (ROWS / 2 - 1));
    for (int i = 0; i < r.pairs; i++) {
        ck_assert_int_lt(found[i].a, found[i].b);
        ck_assert_int_eq(found[i].a / ROWS, found[i].b / ROWS);
        ck_assert_int_eq(found[i].a % ROWS + found[i].b % ROWS, ROWS - 1);
    }
    sphere_tree_free(&t);
    cloth_free(&c);
}
END_TEST

// Rejects: writing past the end; counting only what was stored.
START_TEST(pairs_beyond_capacity_are_counted_not_stored)
{
    cloth c = cloth_make(10, 0.1, 0);
    sphere_tree t = tree_of(&c, TREE_LAYERED, 0.055, 0);
    cloth_fold(&c, 0.05);
    sphere_tree_refresh(&t, c.at);
    tree_result all = sphere_tree_self(&t, c.at, 0, 1, wanted, MANY);
    ck_assert_int_gt(all.pairs, 7);
    found[7] = (leaf_pair){ -3, -4 };
    tree_result few = sphere_tree_self(&t, c.at, 0, 1, found, 7);
    ck_assert_int_eq(few.pairs, all.pairs);
    ck_assert_int_eq(few.visited, all.visited);
    ck_assert(memcmp(found, wanted, 7 * sizeof *found) == 0);
    ck_assert_int_eq(found[7].a, -3);
    few = sphere_tree_pairs(&t, c.at, &t, c.at, 0, found, 7);
    ck_assert_int_ge(few.pairs, 100);           // each leaf meets itself
    ck_assert_int_eq(found[7].b, -4);
    few = sphere_tree_pairs(&t, c.at, &t, c.at, 0, NULL, 0);
    ck_assert_int_ge(few.pairs, 100);
    sphere_tree_free(&t);
    cloth_free(&c);
}
END_TEST

// Rejects: a sort that leaves ties to the library; memory read before written.
START_TEST(two_builds_are_the_same_to_the_bit)
{
    cloth c = cloth_make(20, 0.1, 1);
    for (int kind = TREE_WRAPPED; kind <= TREE_LAYERED; kind++) {
        sphere_tree t = tree_of(&c, (tree_kind)kind, 0.02, 0.01);
        sphere_tree u = tree_of(&c, (tree_kind)kind, 0.02, 0.01);
        size_t size = (size_t)t.nodes * sizeof *t.node;
        ck_assert(memcmp(t.node, u.node, size) == 0);
        cloth_fold(&c, 0.05);
        sphere_tree_refresh(&t, c.at);
        sphere_tree_refresh(&u, c.at);
        tree_result a = sphere_tree_self(&t, c.at, 0, 1, found, MANY);
        tree_result b = sphere_tree_self(&u, c.at, 0, 1, wanted, MANY);
        ck_assert(memcmp(&a, &b, sizeof a) == 0 && a.pairs < MANY);
        ck_assert(memcmp(found, wanted, (size_t)a.pairs * sizeof *found) == 0);
        sphere_tree_free(&t);
        sphere_tree_free(&u);
    }
    cloth_free(&c);
}
END_TEST

START_TEST(one_leaf_is_a_tree)
{
    vec3 at[2] = { { 1, 2, 3 }, { 3, 2, 3 } };
    leaf_feature edge = { 2, { 0, 1 } };
    for (int kind = TREE_WRAPPED; kind <= TREE_LAYERED; kind++) {
        sphere_tree t;
        ck_assert(sphere_tree_build(&t, (tree_kind)kind, at, &edge, 1, 0.5,
                                    0).ok);
        ck_assert_int_eq(t.nodes, 1);
        ck_assert_int_eq(t.node[0].child[0], -1);
        sphere root = sphere_tree_root(&t, at);
        ck_assert(fabs(root.radius - 1.5) < BALL && root.center.x == 2);
        ck_assert_int_eq(sphere_tree_self(&t, at, 1, 1, NULL, 0).pairs, 0);
        tree_result r = sphere_tree_pairs(&t, at, &t, at, 0, found, 1);
        ck_assert_int_eq(r.pairs, 1);
        ck_assert_int_eq(r.visited, 1);
        sphere_tree_free(&t);
    }
}
END_TEST

// Rejects: spheres that touch counted as overlapping (every flat cloth's do).
START_TEST(touching_spheres_are_not_a_pair)
{
    vec3 at[2] = { { 0, 0, 0 }, { 2, 0, 0 } };
    leaf_feature a = { 1, { 0 } }, b = { 1, { 1 } };
    sphere_tree t, u;
    ck_assert(sphere_tree_build(&t, TREE_LAYERED, at, &a, 1, 1, 0).ok);
    ck_assert(sphere_tree_build(&u, TREE_WRAPPED, at, &b, 1, 1, 0).ok);
    ck_assert_int_eq(sphere_tree_pairs(&t, at, &u, at, 0, NULL, 0).pairs, 0);
    ck_assert_int_eq(sphere_tree_pairs(&t, at, &u, at, 1e-9, NULL, 0).pairs, 1);
    sphere_tree_free(&t);
    sphere_tree_free(&u);
}
END_TEST

static void assert_refused(const vec3 *at, const leaf_feature *leaf, int n,
                           real thickness, real slack, const char *word)
{
    sphere_tree t;
    memset(&t, 0x55, sizeof t);
    status s = sphere_tree_build(&t, TREE_LAYERED, at, leaf, n, thickness,
                                 slack);
    ck_assert(!s.ok);
    ck_assert_msg(strstr(s.why, word) != NULL, "%s", s.why);
    ck_assert(!t.node && !t.leaf && !t.rest && !t.leaves && !t.nodes);
    sphere_tree_free(&t);                       // harmless
}

// Rejects: half a tree left behind; a NaN let in.
START_TEST(bad_input_is_refused_with_a_sentence)
{
    vec3 at[3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, (real)NAN, 0 } };
    leaf_feature good[2] = { { 1, { 0 } }, { 2, { 0, 1 } } };
    leaf_feature none[1] = { { 0, { 0 } } }, four[1] = { { 4, { 0 } } };
    leaf_feature nan[2] = { { 1, { 0 } }, { 2, { 1, 2 } } };
    assert_refused(at, good, 0, 0, 0, "leaves");
    assert_refused(at, good, -5, 0, 0, "leaves");
    assert_refused(at, none, 1, 0, 0, "leaf 0");
    assert_refused(at, four, 1, 0, 0, "leaf 0");
    leaf_feature less[2] = { { 1, { 0 } }, { 3, { 0, 1, -1 } } };
    assert_refused(at, good, (1 << 30) + 1, 0, 0, "leaves");
    assert_refused(at, good, INT_MAX, 0, 0, "leaves");
    assert_refused(at, nan, 2, 0, 0, "vertex 2 of leaf 1");
    assert_refused(at, less, 2, 0, 0, "vertex -1 of leaf 1");
    assert_refused(at, good, 2, -1, 0, "thickness");
    assert_refused(at, good, 2, (real)NAN, 0, "thickness");
    assert_refused(at, good, 2, (real)INFINITY, 0, "thickness");
    assert_refused(at, good, 2, 0, (real)NAN, "slack");
    assert_refused(at, good, 2, 0, (real)INFINITY, "slack");
    assert_refused(at, good, 2, 0, -0.1, "slack");
}
END_TEST

// Rejects: "distance < reach", which no NaN fulfils: a body that has gone bad
// would meet nobody.
START_TEST(a_bad_point_is_met_by_everything)
{
    cloth c = cloth_make(6, 0.25, 0);
    vec3 far = { 1e6, 0, 0 };
    leaf_feature one = { 1, { 0 } };
    sphere_tree u, t = tree_of(&c, TREE_LAYERED, 0.01, 0);
    ck_assert(sphere_tree_build(&u, TREE_LAYERED, &far, &one, 1, 0.1, 0).ok);
    c.at[17].z = (real)NAN;
    sphere_tree_refresh(&t, c.at);
    sphere root = sphere_tree_root(&t, c.at);
    ck_assert(root.center.z != root.center.z);
    tree_result r = sphere_tree_pairs(&t, c.at, &u, &far, 0, found, MANY);
    ck_assert_int_eq(r.pairs, 1);
    ck_assert_int_eq(found[0].a, 17);
    r = sphere_tree_self(&t, c.at, 0, 1, found, MANY);
    ck_assert_int_eq(r.pairs, 35);
    for (int i = 0; i < r.pairs; i++)
        ck_assert(found[i].a == 17 || found[i].b == 17);
    sphere_tree_free(&t);
    sphere_tree_free(&u);
    cloth_free(&c);
}
END_TEST

// Rejects: a leak, or half a tree, when any one allocation is refused.
START_TEST(refused_memory_leaves_nothing)
{
    vec3 at[2] = { { 0, 0, 0 }, { 1, 0, 0 } };
    leaf_feature leaf[2] = { { 1, { 0 } }, { 2, { 0, 1 } } };
    int n = 0;
    for (; n < 20; n++) {
        sphere_tree t;
        long held = blocks_held;
        mallocs_left = n;
        status s = sphere_tree_build(&t, TREE_WRAPPED, at, leaf, 2, 0, 0);
        mallocs_left = INT_MAX;
        if (s.ok) { sphere_tree_free(&t); break; }
        held = blocks_held - held;
        ck_assert_str_eq(s.why, "out of memory");
        ck_assert(!t.node && !t.leaf && !t.rest && !t.leaves && !t.nodes);
        ck_assert_int_eq(held, 0);
    }
    ck_assert_int_eq(n, 5);
}
END_TEST

// Rejects: a count of refreshes that overflows, or nodes that then stay where
// they were.
START_TEST(refreshes_are_counted_round)
{
    vec3 at[2] = { { 0, 0, 0 }, { 1, 0, 0 } };
    leaf_feature leaf[2] = { { 1, { 0 } }, { 1, { 1 } } };
    sphere_tree t;
    ck_assert(sphere_tree_build(&t, TREE_WRAPPED, at, leaf, 2, 0, 0).ok);
    t.stamp = INT_MAX - 1;
    for (int k = 1; k <= 3; k++) {
        at[0].y = at[1].y = k;
        sphere_tree_refresh(&t, at);
        ck_assert(t.stamp >= 0);
        sphere root = sphere_tree_root(&t, at);
        ck_assert(root.center.x == 0.5 && root.center.y == k);
    }
    ck_assert_int_eq(t.stamp, 1);
    sphere_tree_free(&t);
}
END_TEST

int main(void)
{
    Suite *s = suite_create("sphere_tree");
    TCase *t = tcase_create("sphere_tree");
    tcase_add_test(t, ball_encloses_every_point);
    tcase_add_test(t, ball_is_the_smallest);
    tcase_add_test(t, a_point_just_outside_is_let_in);
    tcase_add_test(t, centre_is_the_mean_of_its_supports);
    tcase_add_test(t, ball_far_from_the_origin_is_the_same);
    tcase_add_test(t, ball_of_a_smaller_body_is_smaller_to_the_bit);
    tcase_add_test(t, ball_of_few_points_is_known);
    tcase_add_test(t, ball_of_a_bad_point_says_so);
    tcase_add_test(t, ball_of_points_beyond_all_numbers_is_infinite);
    tcase_add_test(t, ball_of_two_balls_spans_both);
    tcase_add_test(t, a_ball_inside_another_changes_nothing);
    tcase_add_test(t, tree_is_a_tree);
    tcase_add_test(t, leaves_are_halved_across_the_longest_side);
    tcase_add_test(t, every_node_holds_what_is_below_it);
    tcase_add_test(t, leaf_balls_are_the_smallest);
    tcase_add_test(t, wrapped_nodes_follow_a_rigid_motion);
    tcase_add_test(t, wrapped_nodes_are_updated_only_when_visited);
    tcase_add_test(t, slack_holds_a_body_stretched_by_as_much);
    tcase_add_test(t, layered_nodes_follow_a_deformation);
    tcase_add_test(t, a_wrapped_ball_is_never_larger_than_a_layered_one);
    tcase_add_test(t, pairs_are_those_of_all_against_all);
    tcase_add_test(t, wrapped_trees_miss_no_triangles_that_come_near);
    tcase_add_test(t, self_pairs_are_those_of_all_against_all);
    tcase_add_test(t, flat_cloth_has_no_pairs);
    tcase_add_test(t, triangles_apart_may_be_tangent_at_rest);
    tcase_add_test(t, folded_cloth_reports_the_particles_above_each_other);
    tcase_add_test(t, pairs_beyond_capacity_are_counted_not_stored);
    tcase_add_test(t, two_builds_are_the_same_to_the_bit);
    tcase_add_test(t, one_leaf_is_a_tree);
    tcase_add_test(t, touching_spheres_are_not_a_pair);
    tcase_add_test(t, bad_input_is_refused_with_a_sentence);
    tcase_add_test(t, a_bad_point_is_met_by_everything);
    tcase_add_test(t, refused_memory_leaves_nothing);
    tcase_add_test(t, refreshes_are_counted_round);
    suite_add_tcase(s, t);
    SRunner *r = srunner_create(s);
    srunner_run_all(r, CK_NORMAL);
    int failed = srunner_ntests_failed(r);
    srunner_free(r);
    return failed != 0;
}
