// area.h - the area of a polygon in space, and its middle.
//
// Units: metres, square metres.

#ifndef TUMBLE_AREA_H
#define TUMBLE_AREA_H

#include "vec3.h"

// The area vector (m^2) of the polygon with these n corners, in order: as long
// as its area, perpendicular to it, and it looks to where they are seen to run
// counter-clockwise.  The polygon need not be convex.  Fewer than three corners
// have none: zero.
vec3 polygon_area(const vec3 *at, int n);

// Where a plate cut to that (flat) polygon balances.  A polygon without area
// has the mean of its corners, one without corners the origin.
vec3 polygon_center(const vec3 *at, int n);

#endif
