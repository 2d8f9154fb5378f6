// blows.h - the order of the sticks when a body is struck in many places.

#ifndef TUMBLE_BLOWS_H
#define TUMBLE_BLOWS_H

#include "ordering.h"

// Writes the numbers of all sticks to order, by increasing distance from the
// nearest of m struck particles (m >= 0); of equals in the order of the shape,
// what no path reaches last.  away[particles] and distance[sticks] are written
// on.  Returns the largest distance that is reached.
int blows_order(const stick *s, int sticks, int particles, const int *struck,
                int m, int *order, int *away, int *distance);

#endif
