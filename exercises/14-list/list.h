// list.h - the list of neighbours (Verlet 1967): ask for more, and less often.
//
// Units: metres.

#ifndef TUMBLE_LIST_H
#define TUMBLE_LIST_H

#include "vec3.h"

// All memory is the caller's.  At first, points, reach, margin, capacity and
// the two arrays are set, and all else is 0.
typedef struct {
    int  points;
    real reach;         // >= 0: pairs no further apart than this are wanted
    real margin;        // >= 0: the list holds those up to reach + margin
    int  capacity;      // of pair
    int (*pair)[2];     // [capacity] the list: a < b, sorted by a, then by b
    vec3 *from;         // [points] where they were when it was made
    int  pairs;         // in the list; -1: there were more than capacity, and
                        // the list holds nothing
    int  made;          // how many lists have been made
} near_list;

// 1 if the list still holds every pair that is within reach now.  It does as
// long as the two points that have moved furthest from where they were have not
// moved by more than the margin, both ways added.  0 if there is none yet, or
// if a point is no number.
int list_is_good(const near_list *l, const vec3 *at);

// Makes the list for where the points are now.  A NaN is near no other point.
void list_make(near_list *l, const vec3 *at);

// The pairs that are within reach now, a < b, sorted by a, then by b; out keeps
// the first `room` of them.  Returns how many there are.  Makes a new list if
// the old one is not good; where it has not held them all, all pairs are asked.
int list_pairs(near_list *l, const vec3 *at, int (*out)[2], int room);

#endif
