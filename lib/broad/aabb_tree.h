//> aabb-tree-head
//>   A box is six numbers, and a tree of boxes is two arrays: the things, and
//>   the boxes around them.
// aabb_tree.h - a bounding volume hierarchy of boxes with sides along the axes.
//
// Paper: section 4.3 has spheres (chapter 06).  Book: chapter 14.
// Units: metres.

#pragma once

#include "vec3.h"

// A box with sides along the axes.  It is empty if low is beyond high.
typedef struct {
    vec3 low, high;     // m
} aabb;

static inline vec3 vec3_min(vec3 a, vec3 b)
{
    return vec3_make(real_min(a.x, b.x), real_min(a.y, b.y), real_min(a.z, b.z));
}

static inline vec3 vec3_max(vec3 a, vec3 b)
{
    return vec3_make(real_max(a.x, b.x), real_max(a.y, b.y), real_max(a.z, b.z));
}

static inline aabb aabb_join(aabb a, aabb b)
{
    return (aabb){ vec3_min(a.low, b.low), vec3_max(a.high, b.high) };
}

static inline aabb aabb_with(aabb a, vec3 x)
{
    return aabb_join(a, (aabb){ x, x });
}

// How far x is outside of an interval, beyond 0; a NaN stays one.
static inline real real_outside(real x, real low, real high)
{
    return x < low ? low - x : x > high ? x - high : x - x;
}

// The square of the distance from the box to x: m^2.
static inline real aabb_distance_squared(const aabb *a, vec3 x)
{
    vec3 d = { real_outside(x.x, a->low.x, a->high.x),
               real_outside(x.y, a->low.y, a->high.y),
               real_outside(x.z, a->low.z, a->high.z) };
    return vec3_length_squared(d);
}

static inline bool aabbs_meet(const aabb *a, const aabb *b)
{
    return a->low.x <= b->high.x && b->low.x <= a->high.x
        && a->low.y <= b->high.y && b->low.y <= a->high.y
        && a->low.z <= b->high.z && b->low.z <= a->high.z;
}

// The box, wider by so much (m) on every side.
static inline aabb aabb_wider(aabb a, real by)
{
    vec3 out = { by, by, by };
    return (aabb){ vec3_sub(a.low, out), vec3_add(a.high, out) };
}

static inline aabb aabb_empty(void)
{
    return (aabb){ { HUGE_VAL, HUGE_VAL, HUGE_VAL },
                  { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL } };
}

// Things in a leaf.  With fewer of them fewer are compared, and boxes take more
// memory.
enum { A_LEAF = 4 };                        // tuned, things

// All leaves are equally deep.  The box of leaf k is node[leaves + k], and its things
// begin at A_LEAF k; all leaves but the last have A_LEAF of them.
typedef struct {
    aabb *around;       // [things] at most A_LEAF * leaves
    int *number;        // [things] the owner's names for them
    int  things;
    aabb *node;         // [2 leaves] 1: around all; 2k and 2k + 1 are in k
    int  leaves;        // a power of two
} aabb_tree;
//<

//> aabb-tree-declare
// How many leaves a tree of so many things has.  Requires: things <= 2^30.
int aabb_tree_leaves(int things);

// Builds the tree of t->things things, which are in any order, and moves them to their
// leaves.  Requires room in t->node.
void aabb_tree_build(aabb_tree *t);

// Adapts the boxes above thing k, after t->around[k] has changed, or k is new and the
// last.
void aabb_tree_update(aabb_tree *t, int k);

static inline int aabb_tree_end(const aabb_tree *t, int leaf)
{
    return int_min((leaf + 1) * A_LEAF, t->things);
}
//<
