//> broad-head
//>   One struct holds the tree, and the arrays that each call fills again.
// broad.h - which bodies may meet?  A tree against itself, instead of every pair.
//
// Paper: section 5 tests every pair.  Book: chapter 14.
// Units: metres, in the world's frame.

#pragma once

#include "aabb_tree.h"
#include "sphere_tree.h"

typedef struct broad {
    int  bodies, room;  // how many there are, and for how many there is room
    aabb_tree tree;     // of all balls that are not empty, and what has come since
    int *place;         // [bodies] where each is in the tree; -1: nowhere
    int *first, *next;  // [bodies] scratch of the sorting of pairs
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
// For that many bodies, >= 0, if it was for fewer; at first a zeroed one is for
// none.  Fails, changing nothing, if memory is refused.
status broad_grow(broad *s, int bodies);
void   broad_free(broad *s);            // an empty or zeroed one is fine

// Builds the tree of all these balls.  Writes the pairs (a, b), a < b, of those
// that touch or overlap, where at least one moves, sorted by a, then by b, to out.
// Returns how many there are (INT_MAX if there are more); if that is more than
// capacity, out has no order, and is to be filled again.  A ball of negative radius
// meets none; one that is NaN meets every other (it is reported, never lost).
int broad_pairs(broad *s, const sphere *ball, const char *moves,
                int (*out)[2], int capacity);

// Tells the tree that ball b has changed, or is new.  Returns false if it is new
// and the tree has no room for it.
bool broad_update(broad *s, const sphere *ball, int b);

// Adds to out, where there are `found` pairs already, those of body b, in any
// order.  A pair of two that are both in is_asked is left to the lower one.  Returns
// how many pairs there are then, stored or not.
int broad_near(const broad *s, const sphere *ball, const char *moves,
               const bool *is_asked, int b, int (*out)[2], int capacity,
               int found);

// Sorts n pairs by a, then by b, where they lie.
void broad_order(broad *s, int (*pair)[2], int n);
static inline bool broad_is_before(const int x[2], const int y[2])
{
    return x[0] < y[0] || (x[0] == y[0] && x[1] < y[1]);
}

// The same answer by looking at every pair (the paper's way).  Of more than capacity
// it writes the first.
int broad_pairs_all(const sphere *ball, const char *moves, int bodies,
                    int (*out)[2], int capacity);
//<
