//> aabb-tree-divide
//>   The things are divided across the longest side of the box around their
//>   middles: so many as fill the left leaves are put before the others.
#include "aabb_tree.h"
#include "table.h"

static real coordinate(vec3 a, int axis)
{
    return axis == 0 ? a.x : axis == 1 ? a.y : a.z;
}

// Twice the middle of its box.  One without an end has none, and may stand anywhere.
static real twice_middle(const aabb *b, int axis)
{
    real sum = coordinate(b->low, axis) + coordinate(b->high, axis);
    return sum - sum == 0 ? sum : 0;
}

static int longest_side(const aabb *around, int n)
{
    real longest = -1;
    int side = 0;
    for (int axis = 0; axis < 3; axis++) {
        real low = HUGE_VAL, high = -HUGE_VAL;
        for (int k = 0; k < n; k++) {
            real x = twice_middle(&around[k], axis);
            low = real_min(low, x);
            high = real_max(high, x);
        }
        if (high - low > longest) {
            longest = high - low;
            side = axis;
        }
    }
    return side;
}

static real middle_of_three(real a, real b, real c)
{
    return real_max(real_min(a, b), real_min(real_max(a, b), c));
}

// Moves things low to high so that those before `at` are no further along the
// axis than the others.  (FIND, Hoare 1961.  Each round leaves out one thing at
// least, so that there are n of them at worst; mostly it is half of what is left.)
static void divide(aabb_tree *t, int low, int high, int at, int axis)
{
    aabb *b = t->around;
    while (low < high) {
        real pivot = middle_of_three(twice_middle(&b[low], axis), twice_middle(&b[at], axis),
                                     twice_middle(&b[high], axis));
        int i = low, k = high;
        for (; i <= k; i++, k--) {
            while (twice_middle(&b[i], axis) < pivot) i++;
            while (twice_middle(&b[k], axis) > pivot) k--;
            if (i > k) break;
            SWAP(aabb, b[i], b[k]);
            SWAP(int, t->number[i], t->number[k]);
        }
        if (at > k && at < i) return;
        if (at <= k) high = k;
        else         low = i;
    }
}
//<

//> aabb-tree-build
int aabb_tree_leaves(int things)
{
    int leaves = 1;
    while (leaves < 1 << 28 && leaves * A_LEAF < things) leaves *= 2;
    return leaves;
}

static void box_leaf(aabb_tree *t, int leaf)
{
    aabb *b = &t->node[t->leaves + leaf];
    *b = aabb_empty();
    for (int k = leaf * A_LEAF; k < aabb_tree_end(t, leaf); k++)
        *b = aabb_join(*b, t->around[k]);
}

static void box_two(aabb_tree *t, int k)
{
    t->node[k] = aabb_join(t->node[2 * k], t->node[2 * k + 1]);
}

// Box k, around the leaves from `first` on.  It calls itself no deeper than an int
// has bits.
static void build_below(aabb_tree *t, int k, int first, int leaves)
{
    if (leaves == 1) {
        box_leaf(t, first);
        return;
    }
    int from = first * A_LEAF, at = from + leaves / 2 * A_LEAF;
    int n = int_min(leaves * A_LEAF, t->things - from);
    if (from + n > at)
        divide(t, from, from + n - 1, at, longest_side(t->around + from, n));
    build_below(t, 2 * k, first, leaves / 2);
    build_below(t, 2 * k + 1, first + leaves / 2, leaves / 2);
    box_two(t, k);
}

void aabb_tree_build(aabb_tree *t)
{
    t->leaves = aabb_tree_leaves(t->things);
    t->node[0] = aabb_empty();
    build_below(t, 1, 0, t->leaves);
}

void aabb_tree_update(aabb_tree *t, int k)
{
    int leaf = k / A_LEAF;
    box_leaf(t, leaf);
    for (int up = (t->leaves + leaf) / 2; up > 0; up /= 2) box_two(t, up);
}
//<
