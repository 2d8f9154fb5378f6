//> broad-head
//>   One struct holds the tree, and the arrays that each call fills again.
// broad.h - the broad phase: a tree against itself, instead of every pair.
//
// Paper: section 5 tests every pair.  Book: chapter 14.
// Units: metres, in the world's frame.

#pragma once

#include "aabb_tree.h"
#include "sphere_tree.h"

typedef struct broad {
    int  bodies, room;  // how many there are, and for how many there is room
    aabb_tree tree;     // of all spheres that are not empty, and of new bodies
    int *place;         // [bodies] their places in the tree; -1: none
    int *first, *next;  // [bodies] scratch for sorting pairs
} broad;
//<

//> broad-tables
//>   One list names all of these, to be grown, freed and saved: what it keeps when
//>   it has room for n bodies, and how much room.
#define BROAD_TABLES(TABLE, s, n)                                          \
    TABLE(tree.around, (s)->tree.things, A_LEAF * aabb_tree_leaves(n))      \
    TABLE(tree.number, (s)->tree.things, A_LEAF * aabb_tree_leaves(n))      \
    TABLE(tree.node, 2 * (s)->tree.leaves, 2 * aabb_tree_leaves(n))         \
    TABLE(place, (s)->bodies, n) TABLE(first, 0, n) TABLE(next, 0, n)
//<

//> broad-declare
//>   Two functions give the same answer in different times, so that one can
//>   test the other.
// Makes room for so many bodies, >= 0, if there is less; a zeroed one has room for
// none.  False, changing nothing, if memory is refused.
bool   broad_grow(broad *s, int bodies);
void   broad_free(broad *s);            // an empty or zeroed one is fine

// Builds the tree of these spheres, and writes to `out` the pairs (a, b), a < b, that
// touch or overlap, and of which at least one moves, sorted by a, then by b.
// Returns how many there are (INT_MAX if there are more); if that is more than
// capacity, `out` has no order, and must be filled again.  A sphere of negative radius
// meets none; one that is NaN meets every other, so it is reported, and never lost.
int broad_pairs(broad *s, const sphere *ball, const char *moves,
                int (*out)[2], int capacity);

// Tells the tree that sphere b has changed, or is new.  Returns false if it is new and
// the tree has no room for it.
bool broad_update(broad *s, const sphere *ball, int b);

// Adds the pairs of body b to `out`, behind `found` pairs, in any order.  A pair of two
// bodies in is_asked is left to the lower one.  Returns how many pairs there are then,
// stored or not.
int broad_near(const broad *s, const sphere *ball, const char *moves,
               const bool *is_asked, int b, int (*out)[2], int capacity,
               int found);

// Sorts n pairs by a, then by b, where they lie.
void broad_order(broad *s, int (*pair)[2], int n);
static inline bool broad_is_before(const int x[2], const int y[2])
{
    return x[0] < y[0] || (x[0] == y[0] && x[1] < y[1]);
}

// The same answer from a test of every pair, as in the paper.  Writes the first
// `capacity` pairs.
int broad_pairs_all(const sphere *ball, const char *moves, int bodies,
                    int (*out)[2], int capacity);
//<
