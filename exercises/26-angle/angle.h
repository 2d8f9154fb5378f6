// angle.h - how far two vectors are apart, as a tangent.

#ifndef TUMBLE_ANGLE_H
#define TUMBLE_ANGLE_H

#include "vec3.h"

// tan(t / 2), where t, from 0 to pi, is the angle between a and b, right to a
// few of its own last digits however small t is, or pi - t; HUGE_VAL if they
// point in opposite directions.  A vector that is zero has no direction: 0.
// Lengths from 1e-70 to 1e70.
real half_tangent(vec3 a, vec3 b);

#endif
