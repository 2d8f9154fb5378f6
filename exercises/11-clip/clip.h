// clip.h - what two polygons of a plane share.
//
// Units: metres.  Only x and y count; z is 0.

#ifndef TUMBLE_CLIP_H
#define TUMBLE_CLIP_H

#include "vec3.h"

enum { CLIP_MOST = 48 };

// Corners in order, counter-clockwise.  No two neighbours are the same place.
typedef struct {
    int  count;     // 0, or 3 and more
    vec3 at[CLIP_MOST];
} polygon;

// What of p lies to the left of the line from a to b, or on it.  A corner for
// which there is no room is left out.  If a is b there is no line: all of p.
polygon clip_line(const polygon *p, vec3 a, vec3 b);

// What p shares with q, which is convex (p need not be).  count = 0: nothing
// that has an area.
polygon clip_polygon(const polygon *p, const polygon *q);

#endif
