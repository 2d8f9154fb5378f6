// side.h - on which side of a line is a point?  Without a doubt.

#ifndef TUMBLE_SIDE_H
#define TUMBLE_SIDE_H

#include "vec3.h"

// Seen from above (x and y count, z does not): 1 if c lies to the left of
// a walk from a to b, -1 to the right, 0 exactly in line, or if a is b.
// Exact for coordinates that are 0 or from 2^-200 to 2^200 in size; 0 for NaN.
int side(vec3 a, vec3 b, vec3 c);

#endif
