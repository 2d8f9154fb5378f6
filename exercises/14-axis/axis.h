// axis.h - along which axis should a line of bodies be sorted?
//
// Units: metres.

#ifndef TUMBLE_AXIS_H
#define TUMBLE_AXIS_H

#include "vec3.h"

// How far n points are spread along x, y and z: the mean of the squares (m^2)
// of their distances from their mean.  A point that is not finite is left out.
// No point, or one: 0.
void axis_spreads(const vec3 *at, int n, real spread[3]);

// 0, 1 or 2: the axis along which to sort.  `before` is the axis that the line
// is sorted along now (-1: none yet).  Another one is worth it only if the
// points are more than STUBBORN times as wide along it: sorting from nothing is slow.
// Of several, the widest; of equals, the first.  (Width is the root of spread.)
#define STUBBORN 1.25

int axis_widest(const vec3 *at, int n, int before);

#endif
