//> broad-head
//>   One struct holds what is kept from frame to frame, the order and a tree,
//>   and the arrays that each call fills again.
// broad.h - which bodies may meet?  Sorted, instead of every pair.
//
// Paper: section 5 tests every pair.  Sweep and prune after Baraff (1992).
// Book: chapter 14.
// Units: metres, in the world's frame.

#ifndef TUMBLE_BROAD_H
#define TUMBLE_BROAD_H

#include "sphere_tree.h"

// The bodies in the order of their balls' left ends, kept from call to call:
// bodies move little in a frame, and an order that was right is nearly right.
// This line is divided in lanes that lie side by side along y and z: a body
// that reaches into several stands in each of them.
enum { LANES_A_BODY = 4 };      // tuned, lanes: on average, at most

typedef struct {
    int first, last;
} lane_range;

// The ends of a box's shadow on an axis (0: x).
typedef struct {
    real low, high;     // m
} shadow;

typedef struct broad {
    int   bodies, room; // so many there are, and for so many there is room
    int  *order;        // [bodies] by low, equal ones by number
    real *low, *high;   // [bodies] m, ends of each ball along x
    int  *first;        // [bodies + 1] scratch of the sorting of pairs

    // Made by every call.
    int   lanes[2];     // along y, and along z
    lane_range (*reach)[2];     // [bodies] into which lanes, along y and z
    int  *lane;         // [bodies + 2] where the places of each lane begin
    int   places;       // in all lanes
    real   *start;      // [LANES_A_BODY * bodies] m, low
    sphere *line;       // [same]
    int    *who;        // [same] the body
    int    *mover;      // [same + 1] the next place, from here on, of one that
                        // moves; then scratch, like first

    long shifts;        // places that bodies moved up in the last sorting

    // A tree of boxes: around a few neighbours on a curve each, then around two
    // boxes each.
    int  (*key)[2];     // [bodies] scratch: where on the curve, and which body
    int   *tree;        // [in_tree] bodies along the curve; behind them, what has
                        // come since
    int   *place;       // [bodies] where each is in it; -1: nowhere
    int    in_tree, leaves;     // leaves: a power of two
    shadow (*box)[3];   // [2 * leaves] 1: around all; 2k and 2k + 1 are in k
} broad;
//<

//> broad-tables
//>   One list names all of these, to be grown, freed and saved: what it keeps when
//>   it has room for n bodies, and how much room. A saved one keeps its order.
#define BROAD_TABLES(KEPT, ROOM, s, n)                                     \
    KEPT(order, (s)->bodies, n)                                            \
    ROOM(tree, (s)->in_tree, n) ROOM(place, (s)->bodies, n)                \
    ROOM(box, 2 * (s)->leaves, broad_boxes(n)) ROOM(key, 0, n)             \
    ROOM(low, 0, n) ROOM(high, 0, n) ROOM(first, 0, (n) + 1)               \
    ROOM(reach, 0, n) ROOM(lane, 0, (n) + 2)                               \
    ROOM(start, 0, LANES_A_BODY * (n)) ROOM(line, 0, LANES_A_BODY * (n))   \
    ROOM(who, 0, LANES_A_BODY * (n)) ROOM(mover, 0, LANES_A_BODY * (n) + 1)
//<

//> broad-declare
//>   Two functions give the same answer in different times, so that one can
//>   test the other.
// For that many bodies, >= 0, if it was for fewer; at first a zeroed one is for
// none.  Fails, changing nothing, if memory is refused.
status broad_grow(broad *s, int bodies);
void   broad_free(broad *s);            // an empty or zeroed one is fine

// The pairs (a, b), a < b, of balls that touch or overlap, where at least one
// moves, sorted by a, then by b.  A ball of negative radius meets none; one
// that is NaN meets every other (it is reported, never lost).  Writes the
// first of them in that order, at most capacity, to out and returns how many
// there are (INT_MAX if there are more).
int broad_pairs(broad *s, const sphere *ball, const char *moves,
                int (*out)[2], int capacity);

// So many boxes has a tree of so many bodies.
int broad_boxes(int bodies);

// The tree of all these balls.
void broad_plant(broad *s, const sphere *ball);

// Ball b is another one now, or has come.  Returns false if the tree has no room
// for it.
bool broad_put(broad *s, const sphere *ball, int b);

// Adds to out, where there are `found` pairs already, those of body b, in any
// order; but none with a lower one that is_asked, too.  Returns how many there are
// then.
int broad_near(const broad *s, const sphere *ball, const char *moves,
               const bool *is_asked, int b, int (*out)[2], int capacity,
               int found);

// Sorts n pairs by a, then by b, where they lie: Shell's passes again.
void broad_order(int (*pair)[2], int n);
static inline bool broad_is_before(const int x[2], const int y[2])
{
    return x[0] < y[0] || (x[0] == y[0] && x[1] < y[1]);
}

// The same answer by looking at every pair (the paper's way).
int broad_pairs_all(const sphere *ball, const char *moves, int bodies,
                    int (*out)[2], int capacity);

#endif
//<
