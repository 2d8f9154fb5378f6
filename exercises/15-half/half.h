// half.h - half distances: chains in the plane that never cross.
//
// Units: metres.  Everything lies in the plane z = 0.

#ifndef TUMBLE_HALF_H
#define TUMBLE_HALF_H

#include "vec3.h"

// Points 0 to points - 1; link k joins a and b of it.  A point may have any
// number of links, or none.
typedef struct {
    int a, b;
} half_link;

// How far each point may move, from where it is now, until it is asked again
// (m, >= 0): where a link and a point that is none of its ends are d apart, no
// particle of the three may move further than SHARE d.  At most `most` (m).
// Whoever has to do with a place that is no number may not move at all.
#define SHARE 0.45

void half_distances(const vec3 *at, int points, const half_link *link,
                    int links, real most, real *room);

// Moves the points towards where they want to be; one that wants to go further than
// it has room goes in the same direction, as far as it may.  A wish that is no
// number is none.  Returns how many were held back.
int half_move(vec3 *at, int points, const vec3 *want, const real *room);

#endif
