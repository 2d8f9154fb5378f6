// nearest_leaf.h - the nearest leaf of a tree.

#ifndef TUMBLE_NEAREST_LEAF_H
#define TUMBLE_NEAREST_LEAF_H

#include "sphere_tree.h"

// The number of a leaf of t whose ball is nearest to p, by |p - center| -
// radius (m), which goes to *distance; how many balls were measured goes to
// *visited.  Requires: t is layered, and refreshed.  p not finite: -1, and
// *distance is NaN.
int nearest_leaf(const sphere_tree *t, vec3 p, real *distance, int *visited);

#endif
