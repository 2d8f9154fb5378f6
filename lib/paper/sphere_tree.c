//> tree-split
//>   Leaves are halved along the axis in which they lie furthest apart.
#include "sphere_tree.h"

#include <assert.h>
#include <stdlib.h>

// A leaf, and the coordinate of its centre along the side that is halved.
typedef struct {
    real along;
    int  leaf;
} place;

// What a build needs beside the tree.
typedef struct {
    sphere_tree *t;
    const vec3 *at;
    place *place;       // [leaves] in the order of the tree
    int *member;        // [3 leaves] the vertices below one node
    int next;           // the next inner node
} builder;

static real component(vec3 a, int axis)
{
    return axis == 0 ? a.x : axis == 1 ? a.y : a.z;
}

// Ties go to the lower leaf.  So no two places are equal, and every correct
// sort gives the same order.
static int compare_places(const void *left, const void *right)
{
    const place *a = left, *b = right;
    if (a->along != b->along) return a->along < b->along ? -1 : 1;
    return a->leaf < b->leaf ? -1 : 1;
}

// Sorts n leaves across the longest side of the box around their centres.
static void sort_places(const sphere_tree *t, place *p, int n)
{
    real longest = -1;
    int side = 0;
    for (int axis = 0; axis < 3; axis++) {
        real low = (real)INFINITY, high = -low;
        for (int i = 0; i < n; i++) {
            low  = real_min(component(t->rest[p[i].leaf].center, axis), low);
            high = real_max(component(t->rest[p[i].leaf].center, axis), high);
        }
        if (high - low > longest) {
            longest = high - low;
            side = axis;
        }
    }
    for (int i = 0; i < n; i++)
        p[i].along = component(t->rest[p[i].leaf].center, side);
    qsort(p, (size_t)n, sizeof *p, compare_places);
}
//<

//> tree-below
static void enclose(const sphere_tree *t, tree_node *node, const vec3 *at,
                    const int *vertex, int count)
{
    node->ball = sphere_of_points(at, vertex, count, node->support,
                                  node->weight, &node->supports);
    node->ball.radius = node->ball.radius * (1 + t->slack) + t->thickness;
}

// Layered: every leaf again, then every node around its children, which stand
// before it.
static void refit(sphere_tree *t, const vec3 *at)
{
    for (int k = 0; k < t->leaves; k++)
        enclose(t, &t->node[k], at, t->leaf[k].vertex, t->leaf[k].count);
    for (int k = t->leaves; k < t->nodes; k++) {
        const int *child = t->node[k].child;
        t->node[k].ball = sphere_of_spheres(t->node[child[0]].ball,
                                            t->node[child[1]].ball);
    }
}

// Wrapped: the smallest sphere around all vertices of n leaves.
static void wrap(const builder *b, tree_node *node, const place *p, int n)
{
    int members = 0;
    for (int i = 0; i < n; i++) {
        const leaf_feature *f = &b->t->leaf[p[i].leaf];
        for (int j = 0; j < f->count; j++) b->member[members++] = f->vertex[j];
    }
    enclose(b->t, node, b->at, b->member, members);
}

// Builds the nodes above the leaves of places first .. first + n - 1, and returns the
// topmost.  n halves to 1 in at most LEVELS_MAX levels, which bounds the recursion.
static int build_above(builder *b, int first, int n)
{
    place *p = b->place + first;
    if (n == 1) return p->leaf;
    sort_places(b->t, p, n);
    int left  = build_above(b, first, n / 2);
    int right = build_above(b, first + n / 2, n - n / 2);
    int k = b->next++;
    b->t->node[k] = (tree_node){ .child = { left, right } };
    if (b->t->kind == TREE_WRAPPED) wrap(b, &b->t->node[k], p, n);
    return k;
}
//<

//> tree-build
//>   The rest of the build is memory and the check of what comes in.
// 2^30 leaves at most, so that an int numbers 2 n - 1 nodes.
enum { LEVELS_MAX = 30, LEAVES_MAX = 1 << LEVELS_MAX };

static status copy_leaves(builder *b, const leaf_feature *leaf)
{
    for (int i = 0; i < b->t->leaves; i++) {
        assert(leaf[i].count >= 1 && leaf[i].count <= 3);
        for (int j = 0; j < leaf[i].count; j++)
            if (!vec3_is_finite(b->at[leaf[i].vertex[j]]))
                return status_fail("vertex %d of leaf %d is not finite",
                                   leaf[i].vertex[j], i);
        b->t->leaf[i] = leaf[i];
        b->place[i].leaf = i;
    }
    return status_ok();
}

static void build_nodes(builder *b)
{
    sphere_tree *t = b->t;
    for (int k = 0; k < t->leaves; k++) {
        t->node[k].child[0] = t->node[k].child[1] = -1;
        enclose(t, &t->node[k], b->at, t->leaf[k].vertex, t->leaf[k].count);
        t->rest[k] = t->node[k].ball;
    }
    b->next = t->leaves;
    build_above(b, 0, t->leaves);
    if (t->kind == TREE_LAYERED) refit(t, b->at);
}

status sphere_tree_build(sphere_tree *t, tree_kind kind, const vec3 *at,
                         const leaf_feature *leaf, int n, real thickness,
                         real slack)
{
    assert(n >= 1 && n <= LEAVES_MAX && slack >= 0 && slack < HUGE_VAL);
    assert(thickness >= 0 && thickness < HUGE_VAL);
    size_t leaves = (size_t)n;
    *t = (sphere_tree){ .kind = kind, .thickness = thickness, .leaves = n,
                        .nodes = 2 * n - 1,
                        .slack = kind == TREE_WRAPPED ? slack : 0 };
    builder b = { .t = t, .at = at };
    t->node  = calloc(2 * leaves - 1, sizeof *t->node);
    t->leaf  = calloc(leaves, sizeof *t->leaf);
    t->rest  = calloc(leaves, sizeof *t->rest);
    b.place  = calloc(leaves, sizeof *b.place);
    b.member = calloc(leaves, 3 * sizeof *b.member);
    status s = status_out_of_memory();
    if (t->node && t->leaf && t->rest && b.place && b.member)
        s = copy_leaves(&b, leaf);
    if (s.ok) build_nodes(&b);
    else      sphere_tree_free(t);
    free(b.place);
    free(b.member);
    return s;
}

void sphere_tree_free(sphere_tree *t)
{
    free(t->node);
    free(t->leaf);
    free(t->rest);
    *t = (sphere_tree){ 0 };
}
//<

//> tree-refresh
void sphere_tree_refresh(sphere_tree *t, const vec3 *at)
{
    t->stamp++;
    if (t->kind == TREE_LAYERED) refit(t, at);
}

// Brings a wrapped node up to date: the centre is the same mean of its supports
// as before, and the radius does not change.  Returns 1 if it was out of date.
// Paper: the sphere through the supports is computed again; here: their mean
// with constant weights, because it needs no equations to be solved and still
// stands in the middle when the body is strained.
static int node_follow(sphere_tree *t, int k, const vec3 *at)
{
    tree_node *n = &t->node[k];
    if (t->kind == TREE_LAYERED || n->stamp == t->stamp) return 0;
    vec3 first = at[n->support[0]], center = first;
    for (int i = 1; i < n->supports; i++)
        center = vec3_add_scaled(center, n->weight[i],
                                 vec3_sub(at[n->support[i]], first));
    n->ball.center = center;
    n->stamp = t->stamp;
    return 1;
}

sphere sphere_tree_root(sphere_tree *t, const vec3 *at)
{
    node_follow(t, t->nodes - 1, at);
    return t->node[t->nodes - 1].ball;
}
//<

//> tree-query
// A query of two trees, or of one and itself.
typedef struct {
    sphere_tree *a, *b;
    const vec3 *at_a, *at_b;
    real margin, apart; // apart < 0: not of one tree and itself
    leaf_pair *out;
    int capacity;
    tree_result result;
} query;

// Neighbours at rest are held apart by their sticks, not by contacts.
// Paper: says nothing of neighbours, whose spheres overlap all the time.
static bool are_neighbours(const sphere_tree *t, int a, int b, real apart)
{
    vec3 between = vec3_sub(t->rest[a].center, t->rest[b].center);
    real near = apart * (t->rest[a].radius + t->rest[b].radius);
    return vec3_length_squared(between) < near * near;
}

static void report(query *q, int a, int b)
{
    bool is_self = q->apart >= 0;
    if (is_self && are_neighbours(q->a, a, b, q->apart)) return;
    if (q->result.pairs < q->capacity)
        q->out[q->result.pairs] = is_self && b < a ? (leaf_pair){ b, a }
                                                   : (leaf_pair){ a, b };
    q->result.pairs++;
}
//<

//> tree-descend
// The children of node k, up to date.
static const int *open_node(query *q, sphere_tree *t, int k, const vec3 *at)
{
    const int *child = t->node[k].child;
    q->result.updated += node_follow(t, child[0], at);
    q->result.updated += node_follow(t, child[1], at);
    return child;
}

// Compares node i of a with node j of b.  If they come near, the larger is
// opened, so that each call goes down one level of one tree: at most 2 *
// LEVELS_MAX deep.  The comparison is written so that a NaN counts as near.
static void compare(query *q, int i, int j)
{
    const sphere *a = &q->a->node[i].ball, *b = &q->b->node[j].ball;
    real near = a->radius + b->radius + q->margin;
    vec3 between = vec3_sub(a->center, b->center);
    q->result.visited++;
    if (vec3_length_squared(between) >= near * near) return;

    bool a_is_leaf = i < q->a->leaves, b_is_leaf = j < q->b->leaves;
    if (a_is_leaf && b_is_leaf) {
        report(q, i, j);
    } else if (b_is_leaf || (!a_is_leaf && a->radius >= b->radius)) {
        const int *child = open_node(q, q->a, i, q->at_a);
        compare(q, child[0], j);
        compare(q, child[1], j);
    } else {
        const int *child = open_node(q, q->b, j, q->at_b);
        compare(q, i, child[0]);
        compare(q, i, child[1]);
    }
}

// A node against itself: each child against itself, and one against the other.
// So no pair of leaves comes twice.
static void compare_self(query *q, int k)
{
    if (k < q->a->leaves) return;
    const int *child = open_node(q, q->a, k, q->at_a);
    compare_self(q, child[0]);
    compare_self(q, child[1]);
    compare(q, child[0], child[1]);
}
//<

//> tree-pairs
//>   The two public functions only fill in the query, and start it at the
//>   roots.
tree_result sphere_tree_pairs(sphere_tree *a, const vec3 *at_a,
                              sphere_tree *b, const vec3 *at_b,
                              real margin, leaf_pair *out, int capacity)
{
    assert(margin >= 0 && capacity >= 0 && (out || capacity == 0));
    query q = { .a = a, .b = b, .at_a = at_a, .at_b = at_b, .margin = margin,
                .apart = -1, .out = out, .capacity = capacity };
    q.result.updated = node_follow(a, a->nodes - 1, at_a)
                     + node_follow(b, b->nodes - 1, at_b);
    compare(&q, a->nodes - 1, b->nodes - 1);
    return q.result;
}

tree_result sphere_tree_self(sphere_tree *t, const vec3 *at, real margin,
                             real apart, leaf_pair *out, int capacity)
{
    assert(margin >= 0 && apart >= 0);
    assert(capacity >= 0 && (out || capacity == 0));
    query q = { .a = t, .b = t, .at_a = at, .at_b = at, .margin = margin,
                .apart = apart, .out = out, .capacity = capacity };
    q.result.updated = node_follow(t, t->nodes - 1, at);
    compare_self(&q, t->nodes - 1);
    return q.result;
}
//<
