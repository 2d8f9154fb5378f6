// check_sphere_tree.c - does the tree hold everything, and miss nothing?
#include "families.h"
#include "scarce.h"
#include "sphere_tree.h"
#include "suite.h"

#include <check.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

// A radius is a square root of sums of a few products.
static const real BALL = 1e-12;

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
    if (k < t->leaves) { below[k] = 1; return; }
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
// by more than one, which would void the bound of the recursion.
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
    for (int i = 0; i < c.points; i++) c.rest[i].y = random_real(&seed);
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
            c.at[i] = random_vec3(&seed, 3);
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

static int share_a_vertex(const leaf_feature *a, const leaf_feature *b)
{
    for (int i = 0; i < a->count; i++)
        for (int j = 0; j < b->count; j++)
            if (a->vertex[i] == b->vertex[j]) return 1;
    return 0;
}

static int neighbours_at_rest(const sphere_tree *t, int a, int b, real apart)
{
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
        real apart = run & 4 ? 1.4 : run & 8 ? 1.1 : 1 + 1e-9;
        seed = (unsigned)run;
        if (kind == TREE_LAYERED) cloth_fold(&c, 0.1);
        for (int i = 0; kind == TREE_LAYERED && i < c.points; i++)
            c.at[i] = vec3_add_scaled(c.at[i], 0.1, random_vec3(&seed, 1));
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
    tree_result r = sphere_tree_self(&t, c.at, 1e-9, 0, found, MANY);
    int tangent = 0;
    for (int k = 0; k < r.pairs; k++)
        tangent += !share_a_vertex(&t.leaf[found[k].a], &t.leaf[found[k].b]);
    ck_assert_int_eq(tangent, 240);
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
START_TEST(bad_point_is_refused_with_a_sentence)
{
    vec3 at[3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, (real)NAN, 0 } };
    leaf_feature nan[2] = { { 1, { 0 } }, { 2, { 1, 2 } } };
    assert_refused(at, nan, 2, 0, 0, "vertex 2 of leaf 1");
    at[2].y = (real)INFINITY;
    assert_refused(at, nan, 2, 0, 0, "vertex 2 of leaf 1");
}
END_TEST

// A body of 16 points hovers over a cloth of 1,600: the larger node is opened
// first, and all but a few leaves are never looked at.  Opening both at once
// takes more visits, and is as right.
// Rejects: the smaller one opened first, which takes 859.
START_TEST(small_body_near_a_large_one_takes_few_visits)
{
    cloth c = cloth_make(40, 1, 0);
    vec3 at[16];
    leaf_feature leaf[16];
    for (int i = 0; i < 16; i++) {
        at[i] = vec3_make(20.2 + 0.1 * (i % 4), 0.3, 20.2 + 0.1 * (i / 4));
        leaf[i] = (leaf_feature){ 1, { i } };
    }
    sphere_tree large = tree_of(&c, TREE_LAYERED, 0.1, 0), small;
    ck_assert(sphere_tree_build(&small, TREE_LAYERED, at, leaf, 16, 0.01,
                                0).ok);
    tree_result r = sphere_tree_pairs(&large, c.at, &small, at, 0, NULL, 0);
    ck_assert_int_eq(r.pairs, 0);
    ck_assert_int_le(r.visited, 400);
    r = sphere_tree_pairs(&small, at, &large, c.at, 0, NULL, 0);
    ck_assert_int_le(r.visited, 400);
    sphere_tree_free(&large);
    sphere_tree_free(&small);
    cloth_free(&c);
}
END_TEST

// Rejects: "distance < reach", which no NaN fulfils: a body that has gone bad
// would meet nothing.
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

// Rejects: nodes that stay where they were when the count of refreshes begins
// again at 0.
START_TEST(refreshes_are_counted_round)
{
    vec3 at[2] = { { 0, 0, 0 }, { 1, 0, 0 } };
    leaf_feature leaf[2] = { { 1, { 0 } }, { 1, { 1 } } };
    sphere_tree t;
    ck_assert(sphere_tree_build(&t, TREE_WRAPPED, at, leaf, 2, 0, 0).ok);
    t.stamp = UINT_MAX - 1;
    for (int k = 1; k <= 3; k++) {
        at[0].y = at[1].y = k;
        sphere_tree_refresh(&t, at);
        sphere root = sphere_tree_root(&t, at);
        ck_assert(root.center.x == 0.5 && root.center.y == k);
    }
    ck_assert(t.stamp == 1);
    sphere_tree_free(&t);
}
END_TEST

int main(void)
{
    const TTest *const tests[] = {
        tree_is_a_tree,
        leaves_are_halved_across_the_longest_side,
        every_node_holds_what_is_below_it,
        wrapped_nodes_follow_a_rigid_motion,
        wrapped_nodes_are_updated_only_when_visited,
        slack_holds_a_body_stretched_by_as_much,
        layered_nodes_follow_a_deformation,
        a_wrapped_ball_is_never_larger_than_a_layered_one,
        pairs_are_those_of_all_against_all,
        wrapped_trees_miss_no_triangles_that_come_near,
        self_pairs_are_those_of_all_against_all,
        flat_cloth_has_no_pairs,
        triangles_apart_may_be_tangent_at_rest,
        folded_cloth_reports_the_particles_above_each_other,
        pairs_beyond_capacity_are_counted_not_stored,
        two_builds_are_the_same_to_the_bit,
        one_leaf_is_a_tree,
        touching_spheres_are_not_a_pair,
        bad_point_is_refused_with_a_sentence,
        small_body_near_a_large_one_takes_few_visits,
        a_bad_point_is_met_by_everything,
        refused_memory_leaves_nothing,
        refreshes_are_counted_round,
        NULL
    };
    return suite_run((suite){ .name = "sphere_tree", .tests = tests });
}
