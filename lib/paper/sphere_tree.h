//> tree-head
// sphere_tree.h - a bounding volume hierarchy of spheres: which features of two
// bodies, or of one, are near each other?
//
// Paper: section 5.2.  Book: chapter 6.
// Units: metres, in the frame of the points (the world's).

#pragma once

#include "sphere.h"
#include "status.h"

// What a leaf encloses: a vertex, an edge or a triangle, with the tree's
// thickness around it.
typedef struct {
    int count;          // 1 to 3
    int vertex[3];
} leaf_feature;

typedef enum {
    TREE_WRAPPED,       // a node encloses the vertices below it: for rigid
                        // bodies, brought up to date in O(1) when visited
    TREE_LAYERED        // a node encloses the spheres of its children: for
                        // deformable bodies, all brought up to date at once
} tree_kind;
//<

//> tree-types
typedef struct {
    sphere ball;        // the bounding sphere
    int child[2];       // nodes; -1, -1 in a leaf
    unsigned stamp;     // wrapped: the refresh that brought it up to date
    int support[4];     // wrapped: the vertices that fix the centre ...
    real weight[4];     // ... as this weighted mean (weights >= 0, sum 1)
    int supports;
} tree_node;

typedef struct {
    tree_kind kind;
    real thickness;     // m
    real slack;         // see sphere_tree_build
    int leaves, nodes;  // nodes = 2 * leaves - 1, the root last
    tree_node *node;    // [nodes] leaf k is node k; children before parents
    leaf_feature *leaf; // [leaves]
    sphere *rest;       // [leaves] the leaf spheres when the tree was built
    unsigned stamp;     // counts refreshes
} sphere_tree;

typedef struct leaf_pair {
    int a, b;           // leaf numbers
} leaf_pair;

// What a query did: the terms of T = Nv Cv + Np Cp + Nu Cu.
typedef struct {
    int pairs;          // Np: found; those beyond capacity are not stored
    int visited;        // Nv: pairs of spheres compared
    int updated;        // Nu: nodes brought up to date on the way
} tree_result;
//<

//> tree-declare
//>   A tree is built once, and told when its points have moved.
// Builds a tree over n leaves with vertices at positions at, top-down: the
// leaves below a node are halved across the longest side of the box around
// their centres, ties by number (Quinlan).  slack, a fraction such as 0.01,
// widens the spheres of a wrapped tree: they still enclose a body that is
// stretched by no more than this. Requires: 1 <= n <= 2^30, 1 to 3 vertices a
// leaf, thickness (m) and slack finite and >= 0.  Fails, leaving *t empty, if a
// vertex is not at a finite place or memory is refused.
status sphere_tree_build(sphere_tree *t, tree_kind kind, const vec3 *at,
                         const leaf_feature *leaf, int n, real thickness,
                         real slack);
void   sphere_tree_free(sphere_tree *t);

// Says that the points have moved.  Layered: updates every node, O(n).
// Wrapped: O(1), because nodes follow when they are visited.
// A point that is no longer finite makes the spheres that depend on it NaN, and
// such a sphere counts as near every other.
void   sphere_tree_refresh(sphere_tree *t, const vec3 *at);

// The root's sphere, up to date.
sphere sphere_tree_root(sphere_tree *t, const vec3 *at);
//<

//> tree-declare-pairs
//>   There are two queries: two trees against each other, and one tree against
//>   itself.
// Pairs of leaves of a and of b whose spheres come nearer than margin, m, >= 0.
// Writes at most capacity of them to out.  A wrapped tree leaves out pairs that
// the spheres above them show to be apart.
tree_result sphere_tree_pairs(sphere_tree *a, const vec3 *at_a,
                              sphere_tree *b, const vec3 *at_b,
                              real margin, leaf_pair *out, int capacity);

// Pairs of leaves of one tree that come nearer than margin, each once, a < b.
// Left out are neighbours at rest: leaves whose centres stood nearer than apart
// * (sum of their radii) when the tree was built.  With margin 0 and apart >= 1
// + 1e-9 a flat cloth has no pairs; with a margin, apart >= (1 + 1e-9) * (1 +
// margin / (sum of two leaves' radii)).
tree_result sphere_tree_self(sphere_tree *t, const vec3 *at, real margin,
                             real apart, leaf_pair *out, int capacity);
//<
