//> sphere-head
// sphere.h - the smallest sphere around points, around a triangle, around two
// spheres.
//
// Paper: section 5.2.  Book: chapter 6.
// Units: metres, in the frame of the points (the world's).

#ifndef TUMBLE_SPHERE_H
#define TUMBLE_SPHERE_H

#include "vec3.h"

#include <stdbool.h>

typedef struct {
    vec3 center;
    real radius;        // < 0: empty
} sphere;
//<

//> sphere-declare
// The smallest sphere that encloses the n points at[index[..]], after Welzl,
// with Gaertner's choice of the next point.  At most four of the points fix it,
// the support points: their indices are written to support, their number to
// *supports, and the centre is their weighted mean, with the weights (>= 0, sum
// 1) written to weight.  The radius is measured last, from the centre as
// rounded.
// n = 0: empty.  A point that is not finite: centre and radius are NaN, and
// *supports is 0.
sphere sphere_of_points(const vec3 *at, const int *index, int n,
                        int support[4], real weight[4], int *supports);

// The smallest sphere that encloses a vertex, an edge or a triangle: count, 1
// to 3, points at[vertex[..]].
sphere sphere_of_feature(const vec3 *at, const int *vertex, int count);

// The smallest sphere that encloses two.
sphere sphere_of_spheres(sphere a, sphere b);

#endif
//<
