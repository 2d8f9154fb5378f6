//> tree-head
// sphere_tree.h - bounding spheres in a binary tree: who could touch whom?
//
// Paper: section 5.2.  Book: chapter 6.
// A leaf encloses one feature: a vertex, an edge or a triangle, thickened.
// A wrapped node encloses the vertices below it tightly, and remembers at most
// four support points, so that it is brought up to date in O(1) when a rigid
// body has moved, and only if it is visited.  A layered node encloses the
// spheres of its children, and is brought up to date from the leaves upwards,
// in O(n), when a body has changed shape.
// Units: metres, in the frame of the points (the world's).

#ifndef TUMBLE_SPHERE_TREE_H
#define TUMBLE_SPHERE_TREE_H

#include "status.h"
#include "vec3.h"

typedef struct {
    vec3 center;
    real radius;        // < 0: empty
} sphere;

// What a leaf encloses: vertex[0 .. count-1], thickened by the tree's
// thickness.
typedef struct {
    int count;          // 1 to 3
    int vertex[3];
} leaf_feature;
//<

//> tree-types
typedef enum { TREE_WRAPPED, TREE_LAYERED } tree_kind;

typedef struct {
    sphere ball;
    int child[2];       // nodes; -1, -1 in a leaf
    int leaf;           // the leaf number, -1 in an inner node
    int stamp;          // wrapped: the refresh that brought it up to date
    int support[4];     // wrapped: vertices that fix the centre ...
    real weight[4];     // ... as this weighted mean (weights >= 0, sum 1)
    int supports;
} tree_node;

typedef struct {
    tree_kind kind;
    real thickness;     // m
    int leaves, nodes;  // nodes = 2 * leaves - 1, children before parents,
                        // the root last
    tree_node *node;    // [nodes] node k < leaves is leaf k
    leaf_feature *leaf; // [leaves]
    sphere *rest;       // [leaves] the leaf spheres when the tree was built
    int stamp;          // counts refreshes
} sphere_tree;

typedef struct leaf_pair {
    int a, b;           // leaf numbers
} leaf_pair;

// What a traversal did: the terms of T = Nv Cv + Np Cp + Nu Cu.
typedef struct {
    int pairs;          // found; those beyond capacity are counted, not stored
    int visited;        // Nv: pairs of spheres compared
    int updated;        // Nu: nodes brought up to date on the way
} tree_result;
//<

//> ball-declare
// The smallest sphere that encloses n points, after Welzl, with Gaertner's
// choice of the next point: made of at most four of them, their indices in
// support, the centre as their weighted mean in weight (>= 0, sum 1), how many
// in *supports.  The radius is measured last, from the centre as rounded.
// n >= 0; n = 0: empty.  A point that is not finite: centre and radius are NaN,
// *supports is 0.
sphere sphere_of_points(const vec3 *at, const int *index, int n,
                        int support[4], real weight[4], int *supports);

// The smallest sphere that encloses two.
sphere sphere_of_spheres(sphere a, sphere b);
//<

//> tree-declare
// Builds a tree over n leaves at positions at, top-down: the leaves below a
// node are halved across the longest side of their centres' box (Quinlan).
// slack (a fraction, e.g. 0.01) widens wrapped balls so that they still enclose
// a body that is stretched by no more than this in any direction.
// Fails, leaving *t empty: n < 1 or > 2^30, a leaf without 1 to 3 vertices, a
// negative vertex or one that is not finite, a bad thickness or slack, or no
// memory.
status sphere_tree_build(sphere_tree *t, tree_kind kind, const vec3 *at,
                         const leaf_feature *leaf, int n, real thickness,
                         real slack);
void   sphere_tree_free(sphere_tree *t);

// Says that the points have moved.  Layered: refits every node, O(n).
// Wrapped: O(1), the nodes follow when they are visited.
// A point that is no longer finite makes the balls that depend on it NaN, and
// such a ball meets every other: it is reported, never lost.
void   sphere_tree_refresh(sphere_tree *t, const vec3 *at);

// The root's sphere, up to date.
sphere sphere_tree_root(sphere_tree *t, const vec3 *at);
//<

//> tree-declare-pairs
// Pairs of leaves of a and of b whose spheres come nearer than margin, m, >= 0
// (touching spheres do not).  Writes at most capacity of them to out, in an
// order fixed by the trees.  A wrapped tree leaves out pairs whose spheres
// overlap but whose features are shown to be apart by the balls above them.
tree_result sphere_tree_pairs(sphere_tree *a, const vec3 *at_a,
                              sphere_tree *b, const vec3 *at_b,
                              real margin, leaf_pair *out, int capacity);

// Pairs of leaves of one tree that come nearer than margin, each once, a < b.
// Left out are neighbours at rest: leaves that share a vertex, or whose centres
// stood nearer than apart * (sum of their radii) when the tree was built.  With
// margin 0 and apart >= 1 + 1e-9 a flat cloth has no pairs; with a margin,
// apart >= (1 + 1e-9) * (1 + margin / (sum of two leaves' radii)).
tree_result sphere_tree_self(sphere_tree *t, const vec3 *at, real margin,
                             real apart, leaf_pair *out, int capacity);

#endif
//<
