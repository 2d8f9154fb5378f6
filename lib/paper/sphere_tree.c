//> ball-trial
#include "sphere_tree.h"

#include <assert.h>
#include <limits.h>
#include <stdlib.h>

// A ball on trial: the smallest around its own supports.  Positions are taken
// relative to the first point given, so that a body far from the origin loses
// no digits.
typedef struct {
    int  count;         // supports, 1 to 4
    int  index[5];      // their numbers (one more while a point is let in)
    vec3 at[5];         // m, relative to the first point
    real weight[4];
    vec3 center;        // m, relative
    real reach2;        // m^2, square of the largest distance to a support
} trial;

static real distance2(vec3 a, vec3 b)
{
    return vec3_length_squared(vec3_sub(a, b));
}
//<

//> ball-weights
// The centre of the sphere through q[0 .. n-1], n = 2 to 4, in their own flat
// space: c = q0 + sum w_j e_j, e_j = q_j - q0, stands as far from q0 as from
// q_i:  |c - q0|^2 = |c - q_i|^2   <=>   e_i . (c - q0) = e_i . e_i / 2,
// which is a symmetric system of n - 1 equations for the weights w_1 ...; the
// first weight is what is left to 1.  Returns 0 if a weight is negative (the
// centre lies outside the hull: fewer points do) or there is no such sphere.
static int weights_through(const vec3 *q, int n, real weight[4])
{
    real m[3][4];
    for (int i = 0; i < n - 1; i++) {
        for (int j = 0; j < n - 1; j++)
            m[i][j] = vec3_dot(vec3_sub(q[i + 1], q[0]),
                               vec3_sub(q[j + 1], q[0]));
        m[i][3] = m[i][i] / 2;
    }
    for (int k = 0; k < n - 1; k++) {
        // Points in line or in a plane: no unique sphere of this kind.
        if (!(m[k][k] > 0)) return 0;
        for (int i = k + 1; i < n - 1; i++) {
            real factor = m[i][k] / m[k][k];
            for (int j = k; j < 4; j++) m[i][j] -= factor * m[k][j];
        }
    }
    weight[0] = 1;
    for (int i = n - 2; i >= 0; i--) {
        real sum = m[i][3];
        for (int j = i + 1; j < n - 1; j++) sum -= m[i][j] * weight[j + 1];
        weight[i + 1] = sum / m[i][i];
        weight[0] -= weight[i + 1];
    }
    for (int i = 0; i < n; i++)
        if (!(weight[i] >= 0)) return 0;
    return 1;
}
//<

//> ball-candidate
// Which of the old supports stand beside the new one: all subsets of one to
// three of four, the small ones first, as bits.
static const int subset[14] = { 1, 2, 4, 8, 3, 5, 6, 9, 10, 12, 7, 11, 13, 14 };

// Makes *s the ball through the new point (old->at[old->count]) and the old
// supports in bits.  Its reach is taken over all of them, old and new: the
// smallest reach among the candidates is the smallest ball around them all.
static int candidate(trial *s, const trial *old, int bits)
{
    s->count = 0;
    s->at[0] = old->at[old->count];
    s->index[s->count++] = old->index[old->count];
    for (int i = 0; i < old->count; i++)
        if (bits & 1 << i) {
            s->at[s->count] = old->at[i];
            s->index[s->count++] = old->index[i];
        }
    if (!weights_through(s->at, s->count, s->weight)) return 0;

    s->center = s->at[0];
    for (int i = 1; i < s->count; i++)
        s->center = vec3_add_scaled(s->center, s->weight[i],
                                    vec3_sub(s->at[i], s->at[0]));
    s->reach2 = 0;
    for (int i = 0; i <= old->count; i++) {
        real d2 = distance2(old->at[i], s->center);
        if (d2 > s->reach2) s->reach2 = d2;
    }
    return 1;
}
//<

//> ball-let-in
// The smallest ball around the supports of *old and one new point, which lies
// outside the old ball and therefore on the new one (Welzl's lemma).
// count = 0: there is none, because squares of lengths overflow.
static trial let_in(trial *old, int index, vec3 at)
{
    trial best = { .count = 0, .reach2 = (real)INFINITY }, s;
    old->index[old->count] = index;
    old->at[old->count] = at;
    for (int k = 0; k < 14; k++) {
        int known = subset[k] < 1 << old->count;
        if (known && candidate(&s, old, subset[k]) && s.reach2 < best.reach2)
            best = s;
    }
    return best;
}
//<

//> ball-farthest
// Which point is farthest from center, which is relative to from, and its
// squared distance; ties go to the first.
static int farthest(const vec3 *at, const int *index, int n, vec3 from,
                    vec3 center, real *far2)
{
    int far = 0;
    *far2 = -1;
    for (int i = 0; i < n; i++) {
        real d2 = distance2(vec3_sub(at[index[i]], from), center);
        if (d2 > *far2) {
            *far2 = d2;
            far = i;
        }
    }
    return far;
}

// The trial becomes an answer, in the frame of the points.
static sphere ball_of_trial(const trial *s, const vec3 *at, const int *index,
                            int n, vec3 from, int support[4], real weight[4])
{
    sphere ball = { .center = vec3_add(from, s->center) };
    for (int i = 0; i < s->count; i++) {
        support[i] = s->index[i];
        weight[i]  = s->weight[i];
    }
    farthest(at, index, n, (vec3){ 0 }, ball.center, &ball.radius);
    ball.radius = sqrt(ball.radius);
    return ball;
}
//<

//> ball-points
// Beyond this the farthest point lies outside the ball for more than rounding.
static const real OUTSIDE = 1 + 1e-14;

// Every pass enlarges the ball, so no set of supports returns and the passes
// end; three to ten are usual.  Points that lie on one sphere up to rounding
// may chase each other: then the cap ends it, with the best ball seen.
enum { PASSES_MAX = 60 };

sphere sphere_of_points(const vec3 *at, const int *index, int n,
                        int support[4], real weight[4], int *supports)
{
    assert(n >= 0);
    *supports = 0;
    if (n == 0) return (sphere){ .radius = -1 };
    for (int i = 0; i < n; i++)
        if (!vec3_is_finite(at[index[i]]))
            return (sphere){ { (real)NAN, (real)NAN, (real)NAN }, (real)NAN };

    vec3  from = at[index[0]];
    trial s = { .count = 1, .index = { index[0] }, .weight = { 1 } }, best = s;
    real  best2 = (real)INFINITY;
    for (int pass = 0; pass < PASSES_MAX && s.count > 0; pass++) {
        real far2;
        int far = farthest(at, index, n, from, s.center, &far2);
        if (far2 < best2) {
            best2 = far2;
            best  = s;
        }
        if (far2 <= s.reach2 * OUTSIDE) break;
        s = let_in(&s, index[far], vec3_sub(at[index[far]], from));
    }
    *supports = best.count;
    return ball_of_trial(&best, at, index, n, from, support, weight);
}
//<

//> ball-spheres
// Two balls, radii a and b, centres d apart.  If d <= |a - b| the larger one
// holds the other (equal centres are such a case).  Else the smallest ball
// spans from the far side of one to the far side of the other: its diameter is
// a + d + b, and its centre lies radius - a from a's towards b's.
sphere sphere_of_spheres(sphere a, sphere b)
{
    if (a.radius < 0) return b;
    if (b.radius < 0) return a;
    vec3 along = vec3_sub(b.center, a.center);
    real d2 = vec3_length_squared(along), more = a.radius - b.radius;
    if (d2 <= more * more) return more >= 0 ? a : b;

    real d = sqrt(d2), radius = (a.radius + d + b.radius) / 2;
    real t = (radius - a.radius) / d;
    return (sphere){ vec3_add_scaled(a.center, t, along), radius };
}
//<

//> ball-feature
// The smallest ball around an edge: its middle.
static sphere ball_of_edge(vec3 a, vec3 b)
{
    vec3 half = vec3_scale((real)0.5, vec3_sub(b, a));
    return (sphere){ vec3_add(a, half), vec3_length(half) };
}

// The smallest ball around a triangle.  With no acute angle at a corner, the
// opposite edge is a diameter.  Else the three are supports, each weighted by
// the square of the opposite edge times (the dot product of the edges here).
static sphere ball_of_triangle(vec3 a, vec3 b, vec3 c)
{
    vec3 ab = vec3_sub(b, a), bc = vec3_sub(c, b), ca = vec3_sub(a, c);
    real at_a = -vec3_dot(ab, ca), at_b = -vec3_dot(ab, bc);
    real at_c = -vec3_dot(bc, ca);
    if (at_a <= 0) return ball_of_edge(b, c);
    if (at_b <= 0) return ball_of_edge(c, a);
    if (at_c <= 0) return ball_of_edge(a, b);

    real wa = vec3_length_squared(bc) * at_a;
    real wb = vec3_length_squared(ca) * at_b;
    real wc = vec3_length_squared(ab) * at_c;
    real sum = wa + wb + wc;
    vec3 to_center = vec3_sub(vec3_scale(wb / sum, ab),
                              vec3_scale(wc / sum, ca));
    return (sphere){ vec3_add(a, to_center), vec3_length(to_center) };
}

static sphere ball_of_feature(const leaf_feature *f, const vec3 *at,
                              real thickness)
{
    const int *v = f->vertex;
    sphere ball = { at[v[0]], 0 };
    if (f->count == 2) ball = ball_of_edge(at[v[0]], at[v[1]]);
    if (f->count == 3) ball = ball_of_triangle(at[v[0]], at[v[1]], at[v[2]]);
    ball.radius += thickness;
    return ball;
}
//<

//> tree-split
// What a build needs beside the tree.  place: the leaves in the order of the
// tree, with their centres' coordinate along the side that is being halved.
typedef struct {
    real along;
    int  leaf;
} place;

typedef struct {
    sphere_tree *t;
    const vec3 *at;
    real slack;
    place *place;       // [leaves]
    int *member;        // [3 leaves] vertices below the node in hand
    int next;           // the next inner node
} builder;
//<

//> tree-sort
// Ties go to the lower leaf: no two places are equal, so whatever sorts them,
// the tree is the same.
static int before(place a, place b)
{
    return a.along < b.along || (a.along == b.along && a.leaf < b.leaf);
}

// Puts p where it belongs below heap[k], among heap[0 .. n-1], whose parents
// stand after their children.
static void sift(place *heap, int k, int n, place p)
{
    for (int child = 2 * k + 1; child < n; child = 2 * k + 1) {
        if (child + 1 < n && before(heap[child], heap[child + 1])) child++;
        if (!before(p, heap[child])) break;
        heap[k] = heap[child];
        k = child;
    }
    heap[k] = p;
}

// Heap sort: n log n whatever the order that it starts from.
static void sort_places(place *p, int n)
{
    for (int k = n / 2 - 1; k >= 0; k--) sift(p, k, n, p[k]);
    for (int last = n - 1; last > 0; last--) {
        place top = p[0];
        sift(p, 0, last, p[last]);
        p[last] = top;
    }
}
//<

//> tree-order
static real component(vec3 a, int axis)
{
    return axis == 0 ? a.x : axis == 1 ? a.y : a.z;
}

// Sorts the leaves across the longest side of the box of their centres.
static void order_places(const builder *b, place *p, int n)
{
    real longest = -1;
    int side = 0;
    for (int axis = 0; axis < 3; axis++) {
        real low = (real)INFINITY, high = -low;
        for (int i = 0; i < n; i++) {
            real x = component(b->t->rest[p[i].leaf].center, axis);
            if (x < low) low = x;
            if (x > high) high = x;
        }
        if (high - low > longest) {
            longest = high - low;
            side = axis;
        }
    }
    for (int i = 0; i < n; i++)
        p[i].along = component(b->t->rest[p[i].leaf].center, side);
    sort_places(p, n);
}
//<

//> tree-below
// The smallest ball around all vertices of n leaves, and what fixes it.
static void wrap_node(const builder *b, tree_node *node, const place *p, int n)
{
    int members = 0;
    for (int i = 0; i < n; i++) {
        const leaf_feature *f = &b->t->leaf[p[i].leaf];
        for (int j = 0; j < f->count; j++) b->member[members++] = f->vertex[j];
    }
    node->ball = sphere_of_points(b->at, b->member, members, node->support,
                                  node->weight, &node->supports);
    node->ball.radius *= 1 + b->slack;
    node->ball.radius += b->t->thickness;
}

// Builds what lies below the node of places first .. first + n-1, then the
// node; returns its number.  Halving makes n shrink to 1 in log2 n levels: the
// recursion is at most LEVELS_MAX deep.
static int build_below(builder *b, int first, int n)
{
    place *p = b->place + first;
    if (n == 1) return p->leaf;
    order_places(b, p, n);
    int left  = build_below(b, first, n / 2);
    int right = build_below(b, first + n / 2, n - n / 2);

    tree_node *node = &b->t->node[b->next];
    *node = (tree_node){ .child = { left, right }, .leaf = -1 };
    if (b->t->kind == TREE_WRAPPED)
        wrap_node(b, node, p, n);
    else
        node->ball = sphere_of_spheres(b->t->node[left].ball,
                                       b->t->node[right].ball);
    return b->next++;
}
//<

//> tree-build
// 2^30 leaves at most, so that an int numbers 2 n - 1 nodes.
enum { LEVELS_MAX = 30, LEAVES_MAX = 1 << LEVELS_MAX };

static status check_build(const vec3 *at, const leaf_feature *leaf, int n,
                          real thickness, real slack)
{
    if (n < 1 || n > LEAVES_MAX)
        return status_fail("a sphere tree has 1 to %d leaves, not %d",
                           LEAVES_MAX, n);
    if (!(thickness >= 0) || !(thickness - thickness == 0))
        return status_fail("the thickness is %g, not finite and >= 0",
                           thickness);
    if (!(slack >= 0) || !(slack - slack == 0))
        return status_fail("the slack is %g, not finite and >= 0", slack);
    for (int i = 0; i < n; i++) {
        if (leaf[i].count < 1 || leaf[i].count > 3)
            return status_fail("leaf %d has %d vertices, not 1 to 3", i,
                               leaf[i].count);
        for (int j = 0; j < leaf[i].count; j++) {
            int v = leaf[i].vertex[j];
            if (v < 0)
                return status_fail("vertex %d of leaf %d does not exist", v, i);
            if (!vec3_is_finite(at[v]))
                return status_fail("vertex %d of leaf %d is not finite", v, i);
        }
    }
    return status_ok();
}

// The leaves are nodes 0 .. n-1; the inner nodes follow as they are finished.
static void build_nodes(builder *b)
{
    sphere_tree *t = b->t;
    for (int i = 0; i < t->leaves; i++) {
        b->place[i].leaf = i;
        t->node[i] = (tree_node){ .child = { -1, -1 }, .leaf = i };
        if (t->kind == TREE_WRAPPED)
            wrap_node(b, &t->node[i], &b->place[i], 1);
        else
            t->node[i].ball = ball_of_feature(&t->leaf[i], b->at, t->thickness);
        t->rest[i] = t->node[i].ball;
    }
    build_below(b, 0, t->leaves);
}
//<

//> tree-make
status sphere_tree_build(sphere_tree *t, tree_kind kind, const vec3 *at,
                         const leaf_feature *leaf, int n, real thickness,
                         real slack)
{
    *t = (sphere_tree){ .kind = kind, .thickness = thickness };
    status s = check_build(at, leaf, n, thickness, slack);
    if (!s.ok) return s;

    size_t leaves = (size_t)n;
    builder b = { .t = t, .at = at, .slack = slack, .next = n };
    t->leaves = n;
    t->nodes  = 2 * n - 1;
    t->node   = calloc(2 * leaves - 1, sizeof *t->node);
    t->leaf   = calloc(leaves, sizeof *t->leaf);
    t->rest   = calloc(leaves, sizeof *t->rest);
    b.place   = calloc(leaves, sizeof *b.place);
    b.member  = calloc(leaves, 3 * sizeof *b.member);
    if (t->node && t->leaf && t->rest && b.place && b.member) {
        for (int i = 0; i < n; i++) t->leaf[i] = leaf[i];
        build_nodes(&b);
    } else {
        sphere_tree_free(t);
        s = status_out_of_memory();
    }
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
    // The count starts again at 0 rather than overflow: only a node that nobody
    // visited for 2^31 refreshes could take that for its own.
    t->stamp = t->stamp < INT_MAX ? t->stamp + 1 : 0;
    if (t->kind == TREE_WRAPPED) return;

    for (int i = 0; i < t->leaves; i++)
        t->node[i].ball = ball_of_feature(&t->leaf[i], at, t->thickness);
    // Children stand before their parents.
    for (int k = t->leaves; k < t->nodes; k++) {
        const int *child = t->node[k].child;
        t->node[k].ball = sphere_of_spheres(t->node[child[0]].ball,
                                            t->node[child[1]].ball);
    }
}

// Brings a wrapped node up to date: the centre is the same mean of its supports
// as ever, the radius does not change.  Returns 1 if there was anything to do.
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

//> tree-traversal
// Every pair on the stack is of two nodes whose balls come near.  One taken off
// is replaced by at most four, one level deeper in both trees, or by two, one
// level deeper in one; a node taken with itself by three.  With 30 levels a
// tree the stack never holds more than 1 + 3 * 30 pairs, so no recursion is
// needed; one more place is written before it is known to be taken.
enum { STACK_MAX = 3 * LEVELS_MAX + 2 };

typedef struct {
    sphere_tree *a, *b;
    const vec3 *at_a, *at_b;
    real margin;
    tree_result result;
    int top;
    leaf_pair stack[STACK_MAX]; // of nodes
} traversal;
//<

//> tree-push
// Leaves the stack as it is: to clear it would cost more than most queries,
// which end at the roots.
static void traversal_start(traversal *v, sphere_tree *a, const vec3 *at_a,
                            sphere_tree *b, const vec3 *at_b, real margin)
{
    assert(margin >= 0);
    v->a = a;
    v->b = b;
    v->at_a = at_a;
    v->at_b = at_b;
    v->margin = margin;
    v->result = (tree_result){ 0, 0, 0 };
    v->top = 0;
}

// Pushes node i of a with node j of b if their balls come near.  There is no
// branch, which a processor would guess wrongly half of the time: the pair is
// written, and stays if the top moves over it.  Asked so that a NaN, of which
// no comparison holds, counts as near.
static inline void push_if_near(traversal *v, int i, int j)
{
    const sphere *a = &v->a->node[i].ball, *b = &v->b->node[j].ball;
    real near = a->radius + b->radius + v->margin;
    assert(v->top < STACK_MAX);
    v->stack[v->top] = (leaf_pair){ i, j };
    v->top += !(distance2(a->center, b->center) >= near * near);
    v->result.visited++;
}

static inline void report(tree_result *r, int a, int b, leaf_pair *out,
                          int capacity)
{
    if (r->pairs < capacity) out[r->pairs] = (leaf_pair){ a, b };
    r->pairs++;
}
//<

//> tree-descend
// The nodes to compare in the place of node k: itself, or its children.
// Returns how many; they are brought up to date.
static inline int halves(traversal *v, sphere_tree *t, const vec3 *at, int k,
                         int open, int half[2])
{
    half[0] = half[1] = k;
    if (!open) return 1;
    half[0] = t->node[k].child[0];
    half[1] = t->node[k].child[1];
    if (t->kind == TREE_WRAPPED)
        v->result.updated += node_follow(t, half[0], at)
                           + node_follow(t, half[1], at);
    return 2;
}

// Goes down from two nodes that come near, not both leaves: into both, but
// never into a leaf, nor into a ball less than half as large as the other,
// whose halves would be compared with the same large ball in vain.  The first
// halves are pushed last, to be taken first.
static void descend(traversal *v, int i, int j)
{
    real size_a = v->a->node[i].ball.radius, size_b = v->b->node[j].ball.radius;
    int inner_a = i >= v->a->leaves, inner_b = j >= v->b->leaves;
    int a[2], b[2];
    int na = halves(v, v->a, v->at_a, i,
                    inner_a && !(inner_b && 2 * size_a < size_b), a);
    int nb = halves(v, v->b, v->at_b, j,
                    inner_b && !(inner_a && 2 * size_b < size_a), b);
    for (int x = na; x-- > 0;)
        for (int y = nb; y-- > 0;) push_if_near(v, a[x], b[y]);
}
//<

//> tree-pairs
tree_result sphere_tree_pairs(sphere_tree *a, const vec3 *at_a,
                              sphere_tree *b, const vec3 *at_b,
                              real margin, leaf_pair *out, int capacity)
{
    assert(capacity >= 0 && (out || capacity == 0));
    traversal v;
    traversal_start(&v, a, at_a, b, at_b, margin);
    v.result.updated = node_follow(a, a->nodes - 1, at_a)
                     + node_follow(b, b->nodes - 1, at_b);
    push_if_near(&v, a->nodes - 1, b->nodes - 1);
    while (v.top > 0) {
        leaf_pair p = v.stack[--v.top];
        if (p.a < a->leaves && p.b < b->leaves)
            report(&v.result, p.a, p.b, out, capacity);
        else
            descend(&v, p.a, p.b);
    }
    return v.result;
}
//<

//> tree-neighbours
static int share_a_vertex(const leaf_feature *a, const leaf_feature *b)
{
    for (int i = 0; i < a->count; i++)
        for (int j = 0; j < b->count; j++)
            if (a->vertex[i] == b->vertex[j]) return 1;
    return 0;
}

// Neighbours at rest are held apart by their sticks, not by contacts.
// Paper: says nothing of neighbours, whose spheres overlap at every moment.
static int neighbours(const sphere_tree *t, int a, int b, real apart)
{
    real near = apart * (t->rest[a].radius + t->rest[b].radius);
    return distance2(t->rest[a].center, t->rest[b].center) < near * near
        || share_a_vertex(&t->leaf[a], &t->leaf[b]);
}
//<

//> tree-self
// A node against itself is each of its halves against itself, and one against
// the other: no pair of leaves comes twice.
static void descend_self(traversal *v, int k)
{
    int half[2];
    if (k < v->a->leaves) return;
    halves(v, v->a, v->at_a, k, 1, half);
    push_if_near(v, half[0], half[1]);
    v->stack[v->top++] = (leaf_pair){ half[1], half[1] };
    v->stack[v->top++] = (leaf_pair){ half[0], half[0] };
}

tree_result sphere_tree_self(sphere_tree *t, const vec3 *at, real margin,
                             real apart, leaf_pair *out, int capacity)
{
    assert(apart >= 0 && capacity >= 0 && (out || capacity == 0));
    traversal v;
    traversal_start(&v, t, at, t, at, margin);
    v.result.updated = node_follow(t, t->nodes - 1, at);
    v.stack[v.top++] = (leaf_pair){ t->nodes - 1, t->nodes - 1 };
    while (v.top > 0) {
        leaf_pair p = v.stack[--v.top];
        int a = p.a < p.b ? p.a : p.b, b = p.a < p.b ? p.b : p.a;
        if (a == b)
            descend_self(&v, a);
        else if (b >= t->leaves)
            descend(&v, p.a, p.b);
        else if (!neighbours(t, a, b, apart))
            report(&v.result, a, b, out, capacity);
    }
    return v.result;
}
//<
