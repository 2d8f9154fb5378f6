// circle.h - the smallest circle around points of a plane.

#ifndef TUMBLE_CIRCLE_H
#define TUMBLE_CIRCLE_H

#include "vec3.h"

typedef struct {
    real x, y;          // m
} point;

typedef struct {
    point center;
    real radius;        // m; < 0: empty
} circle;

// The smallest circle that encloses n points.  n = 0: radius -1.  A point that
// is not finite: all NaN.  The radius is that of the farthest point.
circle smallest_circle(const point *at, int n);

#endif
