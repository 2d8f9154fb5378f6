// 06-tree.c - sphere trees: time against the number of leaves, pairs that are
// none, wrapped balls beside layered ones, and what the terms of
// T = Nv Cv + Np Cp + Nu Cu cost.

#include "body.h"
#include "clock.h"
#include "gjk.h"
#include "random.h"
#include "sphere_tree.h"

#include <stdio.h>
#include <stdlib.h>

#ifndef FLAGS
#define FLAGS "unknown"
#endif

enum { ROOM = 1 << 20, SHAPES = 3 };
static leaf_pair found[ROOM];

static void must(int good, const char *what)
{
    if (good) return;
    fprintf(stderr, "06-tree: %s\n", what);
    exit(1);
}

static unsigned long long seed = 1;

// ---- a cloth of 2 m x 2 m, n x n particles ---------------------------------

typedef struct {
    shape plan;
    int n;
    real h;
    vec3 *at;
    leaf_feature *leaf;
    int leaves;
    sphere_tree tree;
} cloth;

static const char *const shape_name[SHAPES] = { "flat", "draped", "folded" };

// Where the particle at x, z (-1 to 1 m) of the flat cloth lies: over a round
// table of 0.4 m in eight folds, or in three layers, gap (m) apart.
static vec3 placed(int kind, real x, real z, real gap)
{
    real pi = 3.14159265358979;
    if (kind == 1) {
        real r = sqrt(x * x + z * z), a = atan2(z, x), over = r - 0.4;
        if (over <= 0) return vec3_make(x, 0, z);
        real out = 0.4 + 0.25 * over
                 + 0.18 * (1 + over / 2) * over * sin(8 * a);
        return vec3_make(out * cos(a), -0.95 * over, out * sin(a));
    }
    if (kind == 2) {
        real r = gap / 2, arc = pi * r, flat = (2 - 2 * arc) / 3, s = x + 1;
        if (s < flat) return vec3_make(s, 0, z);
        if ((s -= flat) < arc)
            return vec3_make(flat + r * sin(s / r), r - r * cos(s / r), z);
        if ((s -= arc) < flat) return vec3_make(flat - s, gap, z);
        if ((s -= flat) < arc)
            return vec3_make(-r * sin(s / r), gap + r - r * cos(s / r), z);
        return vec3_make(s - arc, 2 * gap, z);
    }
    return vec3_make(x, 0, z);
}

static void cloth_move(cloth *c, int kind, real gap)
{
    for (int i = 0; i < c->plan.particles; i++)
        c->at[i] = placed(kind, c->plan.at[i].x, c->plan.at[i].z, gap);
}

static cloth cloth_make(int n, int triangles, real thickness, tree_kind kind)
{
    cloth c = { .n = n, .h = 2.0 / (n - 1) };
    must(shape_cloth(&c.plan, n, n, 2, 2, 1, 1).ok, "no cloth");
    c.leaves = triangles ? c.plan.mesh.faces : n * n;
    c.at   = calloc((size_t)n * (size_t)n, sizeof *c.at);
    c.leaf = calloc((size_t)c.leaves, sizeof *c.leaf);
    must(c.at && c.leaf, "no memory");
    for (int i = 0; i < c.leaves; i++) {
        const int *f = &c.plan.face[3 * i];
        if (triangles) c.leaf[i] = (leaf_feature){ 3, { f[0], f[1], f[2] } };
        else           c.leaf[i] = (leaf_feature){ 1, { i, 0, 0 } };
    }
    cloth_move(&c, 0, 0);
    must(sphere_tree_build(&c.tree, kind, c.at, c.leaf, c.leaves,
                           thickness * c.h, 0).ok, "no tree");
    return c;
}

static void cloth_free(cloth *c)
{
    sphere_tree_free(&c->tree);
    shape_free(&c->plan);
    free(c->at);
    free(c->leaf);
}

// ---- time against leaves ---------------------------------------------------

// All pairs of leaf spheres, and the same rule at rest.
static int all_pairs(const sphere_tree *t, real margin, real apart)
{
    int pairs = 0;
    for (int a = 0; a < t->leaves; a++)
        for (int b = a + 1; b < t->leaves; b++) {
            sphere x = t->node[a].ball, y = t->node[b].ball;
            real r = x.radius + y.radius + margin;
            vec3 d = vec3_sub(x.center, y.center);
            if (vec3_length_squared(d) >= r * r) continue;
            r = apart * (t->rest[a].radius + t->rest[b].radius);
            d = vec3_sub(t->rest[a].center, t->rest[b].center);
            pairs += vec3_length_squared(d) >= r * r;
        }
    return pairs;
}

typedef struct {
    double refit, walk;     // ms, the fastest of many
    tree_result result;
} timing;

static timing time_tree(cloth *c)
{
    timing best = { 1e9, 1e9, { 0, 0, 0 } };
    double stop = clock_seconds() + 0.12;
    while (clock_seconds() < stop) {
        double start = clock_seconds();
        sphere_tree_refresh(&c->tree, c->at);
        double middle = clock_seconds();
        best.result = sphere_tree_self(&c->tree, c->at, 0.4 * c->h, 1.4, found,
                                       ROOM);
        double end = clock_seconds();
        best.refit = fmin(best.refit, 1e3 * (middle - start));
        best.walk  = fmin(best.walk, 1e3 * (end - middle));
    }
    must(best.result.pairs <= ROOM, "too many pairs");
    return best;
}

static void print_times(void)
{
    double tree = 0;
    for (int kind = 0; kind < SHAPES; kind++) {
        printf("# %s cloth, vertex leaves of 0.55 h, margin 0.4 h\n"
               "# leaves  refit_ms  self_ms  both_ms  visited  pairs  "
               "ns_per_visit  visits_per_leaf\n", shape_name[kind]);
        for (int n = 10; n <= 160; n *= 2) {
            cloth c = cloth_make(n, 0, 0.55, TREE_LAYERED);
            cloth_move(&c, kind, 1.2 * c.h);
            timing t = time_tree(&c);
            printf("%d %.4f %.4f %.4f %d %d %.2f %.1f\n", c.leaves, t.refit,
                   t.walk, t.refit + t.walk, t.result.visited, t.result.pairs,
                   1e6 * t.walk / t.result.visited,
                   (real)t.result.visited / c.leaves);
            if (kind == 2 && n == 80) tree = t.refit + t.walk;
            cloth_free(&c);
        }
        printf("\n\n");
    }
    printf("# all pairs of leaf spheres, folded cloth\n# leaves  ms  pairs  "
           "ns_per_pair\n");
    for (int n = 10; n <= 80; n *= 2) {
        cloth c = cloth_make(n, 0, 0.55, TREE_LAYERED);
        cloth_move(&c, 2, 1.2 * c.h);
        sphere_tree_refresh(&c.tree, c.at);
        double best = 1e9, stop = clock_seconds() + 0.05;
        int pairs = 0;
        do {
            double start = clock_seconds();
            pairs = all_pairs(&c.tree, 0.4 * c.h, 1.4);
            double ms = 1e3 * (clock_seconds() - start);
            if (ms < best) best = ms;
        } while (clock_seconds() < stop);
        printf("%d %.4f %d %.2f\n", c.leaves, best, pairs,
               1e6 * best / (0.5 * c.leaves * (c.leaves - 1)));
        if (n == 80)
            clock_print_row("sphere_tree", "folded cloth of 80 x 80",
                            "nothing missed", "tree", "all pairs",
                            best / tree);
        cloth_free(&c);
    }
    printf("\n\n");
}

// ---- pairs that are none ---------------------------------------------------

// m, the distance of two triangles of the cloth.
static real triangles_apart(const cloth *c, int a, int b)
{
    vec3 x[3], y[3];
    for (int i = 0; i < 3; i++) {
        x[i] = c->at[c->leaf[a].vertex[i]];
        y[i] = c->at[c->leaf[b].vertex[i]];
    }
    return gjk_distance((hull){ x, 3 }, (hull){ y, 3 }, HUGE_VAL,
                        NULL).distance;
}

static void print_false_pairs(void)
{
    printf("# three layers of 40 x 40, leaves are triangles without thickness\n"
           "# gap_h  spheres_per_triangle  near_0.12h_per_triangle\n");
    for (int k = 1; k <= 32; k++) {
        cloth c = cloth_make(40, 1, 0, TREE_LAYERED);
        cloth_move(&c, 2, 0.05 * k * c.h);
        sphere_tree_refresh(&c.tree, c.at);
        tree_result r = sphere_tree_self(&c.tree, c.at, 0, 1 + 1e-9, found,
                                         ROOM);
        must(r.pairs <= ROOM, "too many pairs");
        int near = 0;
        for (int i = 0; i < r.pairs; i++)
            near += triangles_apart(&c, found[i].a, found[i].b) < 0.12 * c.h;
        printf("%.2f %.3f %.3f\n", 0.05 * k, (real)r.pairs / c.leaves,
               (real)near / c.leaves);
        cloth_free(&c);
    }
    printf("\n\n");
}

// ---- wrapped and layered ---------------------------------------------------

// Adds, level by level, the radii of t.
static void add_radii(const sphere_tree *t, int node, int level, real *sum,
                      int *count)
{
    sum[level] += t->node[node].ball.radius;
    count[level]++;
    for (int i = 0; i < 2; i++)
        if (node >= t->leaves)
            add_radii(t, t->node[node].child[i], level + 1, sum, count);
}

static void print_radii(void)
{
    printf("# mean radius by level, flat cloth of 32 x 32 particles, leaves of "
           "0.1 h\n# level  wrapped_m  layered_m  ratio\n");
    cloth w = cloth_make(32, 0, 0.1, TREE_WRAPPED);
    cloth l = cloth_make(32, 0, 0.1, TREE_LAYERED);
    real sum[2][32] = { { 0 } };
    int count[2][32] = { { 0 } };
    add_radii(&w.tree, w.tree.nodes - 1, 0, sum[0], count[0]);
    add_radii(&l.tree, l.tree.nodes - 1, 0, sum[1], count[1]);
    for (int i = 0; i < 32 && count[0][i] > 0; i++)
        printf("%d %.5f %.5f %.4f\n", i, sum[0][i] / count[0][i],
               sum[1][i] / count[1][i], sum[1][i] / sum[0][i]);
    cloth_free(&w);
    cloth_free(&l);
    printf("\n\n");
}

// ---- the terms of the cost -------------------------------------------------

// Solves the three normal equations of least squares.
static void solve3(real m[3][4], real x[3])
{
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++) {
            real f = m[i][k] / m[k][k];
            for (int j = 0; i != k && j < 4; j++) m[i][j] -= f * m[k][j];
        }
    for (int k = 0; k < 3; k++) x[k] = m[k][3] / m[k][k];
}

enum { POSES = 10 };

typedef struct {
    real n[3];          // visited, pairs, updated
    real ms;
} query;

// Two rigid sheets, wrapped, b ever deeper across a.  The poses take turns, so
// that no query meets a processor that has just learned its branches.
static void time_poses(cloth *a, cloth *b, query *q)
{
    for (int k = 0; k < POSES; k++) q[k].ms = 1e9;
    for (int run = 0; run < 300; run++)
        for (int k = 0; k < POSES; k++) {
            for (int i = 0; i < b->plan.particles; i++) {
                vec3 p = b->plan.at[i];
                b->at[i] = vec3_make(0.8 * p.x - 0.6 * p.z + 0.3,
                                     0.6 * p.x + 0.8 * p.z - 1.5 + 0.1 * k,
                                     p.y);
            }
            sphere_tree_refresh(&a->tree, a->at);
            sphere_tree_refresh(&b->tree, b->at);
            double start = clock_seconds();
            tree_result r = sphere_tree_pairs(&a->tree, a->at, &b->tree, b->at,
                                              0.02 * k, found, ROOM);
            q[k].ms = fmin(q[k].ms, 1e3 * (clock_seconds() - start));
            q[k].n[0] = r.visited;
            q[k].n[1] = r.pairs;
            q[k].n[2] = r.updated;
        }
}

static void print_model(void)
{
    static query q[POSES];
    real m[3][4] = { { 0 } }, cost[3];
    cloth a = cloth_make(40, 1, 0, TREE_WRAPPED), b = cloth_make(40, 1, 0,
                                                          TREE_WRAPPED);
    time_poses(&a, &b, q);
    // Every pose has the same say, whatever it costs.
    for (int k = 0; k < POSES; k++)
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++)
                m[i][j] += q[k].n[i] * q[k].n[j] / (q[k].ms * q[k].ms);
            m[i][3] += q[k].n[i] / q[k].ms;
        }
    solve3(m, cost);
    printf("# two wrapped trees of %d triangles, ever deeper in each other\n"
           "# Cv = %.2f ns, Cp = %.2f ns, Cu = %.2f ns\n"
           "# Nv  Np  Nu  of_nodes  measured_ms  model_ms  error\n", a.leaves,
           1e6 * cost[0], 1e6 * cost[1], 1e6 * cost[2]);
    for (int k = 0; k < POSES; k++) {
        const real *n = q[k].n;
        real model = n[0] * cost[0] + n[1] * cost[1] + n[2] * cost[2];
        printf("%.0f %.0f %.0f %d %.5f %.5f %.3f\n", n[0], n[1], n[2],
               a.tree.nodes + b.tree.nodes, q[k].ms, model,
               model / q[k].ms - 1);
    }
    cloth_free(&a);
    cloth_free(&b);
    printf("\n\n");
}

// Two roots that are apart: what every pair of bodies in a room pays.
static void print_roots(void)
{
    cloth a = cloth_make(10, 1, 0, TREE_WRAPPED), b = cloth_make(10, 1, 0,
                                                          TREE_WRAPPED);
    for (int i = 0; i < b.plan.particles; i++) b.at[i].y += 9;
    sphere_tree_refresh(&b.tree, b.at);
    int runs = 4000000, pairs = 0;
    double start = clock_seconds();
    for (int i = 0; i < runs; i++) {
        real r = sphere_tree_root(&a.tree, a.at).radius
               + sphere_tree_root(&b.tree, b.at).radius;
        vec3 d = vec3_sub(a.tree.node[a.tree.nodes - 1].ball.center,
                          b.tree.node[b.tree.nodes - 1].ball.center);
        pairs += vec3_length_squared(d) < r * r;
    }
    double roots = 1e9 * (clock_seconds() - start) / runs;
    start = clock_seconds();
    for (int i = 0; i < runs; i++)
        pairs += sphere_tree_pairs(&a.tree, a.at, &b.tree, b.at, 0, NULL,
                                   0).pairs;
    double pair = 1e9 * (clock_seconds() - start) / runs;
    start = clock_seconds();
    for (int i = 0; i < runs; i++) {
        sphere_tree_refresh(&a.tree, a.at);
        pairs += sphere_tree_root(&a.tree, a.at).radius < 0;
    }
    printf("# two bodies apart (ns): roots compared, sphere_tree_pairs, "
           "refresh and root\n%.2f %.2f %.2f %d\n\n\n", roots, pair,
           1e9 * (clock_seconds() - start) / runs, pairs);
    cloth_free(&a);
    cloth_free(&b);
}

// ---- balls -----------------------------------------------------------------

static void print_balls(void)
{
    enum { MOST = 100000 };
    static vec3 at[MOST];
    static int index[MOST];
    int support[4], supports;
    real weight[4], sum = 0;
    printf("# smallest ball of n points in a cube, mean of many\n"
           "# n  us  ns_per_point\n");
    for (int n = 10; n <= MOST; n *= 10) {
        int runs = 1000000 / n < 2000 ? 1000000 / n : 2000;
        double time = 0;
        for (int run = 0; run < runs; run++) {
            for (int i = 0; i < n; i++) {
                real x = random_real(&seed), y = random_real(&seed),
                     z = random_real(&seed);
                at[i] = vec3_make(x, y, z);
                index[i] = i;
            }
            double start = clock_seconds();
            sum += sphere_of_points(at, index, n, support, weight,
                                    &supports).radius;
            time += clock_seconds() - start;
        }
        printf("%d %.3f %.2f\n", n, 1e6 * time / runs, 1e9 * time / runs / n);
    }
    printf("# mean radius of the last: %.3f\n\n\n", sum > 0 ? sum : 0);
}

static real worst_strain(const shape *s, const vec3 *at)
{
    real worst = 0;
    for (int i = 0; i < s->sticks; i++) {
        real rest = s->stick[i].rest_length;
        real now_long = vec3_distance(at[s->stick[i].a], at[s->stick[i].b]);
        worst = fmax(worst, fabs(now_long / rest - 1));
    }
    return worst;
}

// How far a vertex stands out of a ball above it, in radii, at worst; marks in
// below the vertices below the node.
static real worst_escape(const sphere_tree *t, const vec3 *at, int node,
                         char *below)
{
    real worst = -1;
    const tree_node *n = &t->node[node];
    for (int i = 0; i < 12; i++) below[i] = 0;
    if (node < t->leaves) {
        for (int j = 0; j < t->leaf[node].count; j++)
            below[t->leaf[node].vertex[j]] = 1;
    } else {
        char half[12];
        for (int c = 0; c < 2; c++) {
            worst = fmax(worst, worst_escape(t, at, n->child[c], half));
            for (int i = 0; i < 12; i++) below[i] |= half[i];
        }
    }
    vec3 center = { 0, 0, 0 };
    for (int i = 0; i < n->supports; i++)
        center = vec3_add_scaled(center, n->weight[i], at[n->support[i]]);
    for (int i = 0; i < 12; i++)
        if (below[i])
            worst = fmax(worst, vec3_distance(at[i], center) / n->ball.radius
                                - 1);
    return worst;
}

// An icosahedron whose particles are displaced at random until its worst stick
// is strained by 1 %: does a slack of 1 % hold it?
static void print_strain(void)
{
    shape s;
    sphere_tree t;
    leaf_feature leaf[20];
    real worst = 0, mean = 0;
    int runs = 2000, over = 0;
    must(shape_icosahedron(&s, 1, 1).ok, "no icosahedron");
    for (int i = 0; i < 20; i++)
        leaf[i] = (leaf_feature){ 3, { s.face[3 * i], s.face[3 * i + 1],
                                       s.face[3 * i + 2] } };
    must(sphere_tree_build(&t, TREE_WRAPPED, s.at, leaf, 20, 0, 0).ok,
         "no tree");
    for (int run = 0; run < runs; run++) {
        vec3 move[12], at[12];
        char below[12];
        real size = 1e-3;
        for (int i = 0; i < 12; i++) {
            real x = random_real(&seed), y = random_real(&seed),
                 z = random_real(&seed);
            move[i] = vec3_make(x, y, z);
        }
        for (int k = 0; k < 6; k++) {   // the strain is nearly linear in size
            for (int i = 0; i < 12; i++)
                at[i] = vec3_add_scaled(s.at[i], size, move[i]);
            size *= 0.01 / worst_strain(&s, at);
        }
        real escape = worst_escape(&t, at, t.nodes - 1, below);
        worst = fmax(worst, escape);
        mean += escape / runs;
        over += escape > 0.01;
    }
    printf("# icosahedron, worst stick 1 %% strained at random, %d times:\n"
           "# worst_escape  mean_escape  share_beyond_0.01 (radii)\n"
           "%.4f %.4f %.3f\n", runs, worst, mean, (real)over / runs);
    sphere_tree_free(&t);
    shape_free(&s);
}

int main(void)
{
    printf("# Sphere trees: time, pairs that are none, radii, cost of a term\n"
           "# compiler: %s; flags: %s\n", __VERSION__, FLAGS);
    print_times();
    print_false_pairs();
    print_radii();
    print_model();
    print_roots();
    print_balls();
    print_strain();
    return 0;
}
