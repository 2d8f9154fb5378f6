// necklace.h - a tree over a rope that needs no building.

#ifndef TUMBLE_NECKLACE_H
#define TUMBLE_NECKLACE_H

#include "sphere_tree.h"

typedef struct {
    const vec3 *at;     // m, the beads, in their order along the rope
    int  beads;         // >= 0
    real link;          // m, no link is longer
} necklace;

// The ball around beads first to last, however the rope lies, about bead
// (first + last) / 2.  Requires: 0 <= first <= last < beads.
sphere stretch_ball(const necklace *n, int first, int last);

// All pairs of beads a < b with b - a > apart that are nearer than `near` (m),
// each once.  Writes at most capacity of them to out, in any order; pairs
// counts them all, visited the pairs of stretches whose balls were compared,
// updated is 0.
tree_result necklace_pairs(const necklace *n, real near, int apart,
                           leaf_pair *out, int capacity);

#endif
