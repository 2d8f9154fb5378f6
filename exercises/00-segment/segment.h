// segment.h - nearest points and mirror images.
//
// Units: metres.

#ifndef TUMBLE_SEGMENT_H
#define TUMBLE_SEGMENT_H

#include "vec3.h"

// The point of the segment from a to b that is nearest to p; a if a is b.
vec3 segment_nearest(vec3 a, vec3 b, vec3 p);

// How far (m) p is above the plane through `at` that is perpendicular to
// normal; negative below, where normal does not point to.
// Requires: normal is not zero; its length does not matter.
real plane_height(vec3 at, vec3 normal, vec3 p);

// The mirror image of p in that plane.
vec3 plane_mirror(vec3 at, vec3 normal, vec3 p);

#endif
