//> sphere-head
//>   A sphere is a centre and a radius.
// sphere.h - the smallest sphere around points, and around two spheres.
//
// Paper: section 5.2.  Book: chapter 6.
// Units: metres, in the frame of the points (the world's).

#pragma once

#include "vec3.h"

typedef struct {
    vec3 center;
    real radius;        // < 0: empty
} sphere;
//<

//> sphere-declare
//>   Two functions make one: from points, and from two spheres. The first also
//>   returns the recipe for the centre, support points and weights.
// The smallest sphere that encloses the n points at[index[..]] (Welzl,
// Gaertner).  At most four of them fix it, the support points: writes their
// indices to support, their number to *supports, and to weight the weights
// (>= 0, sum 1) with which the centre is their mean.
// n = 0: empty.  A point that is not finite: centre and radius are NaN, and
// *supports is 0.
sphere sphere_of_points(const vec3 *at, const int *index, int n,
                        int support[4], real weight[4], int *supports);

// The smallest sphere that encloses two.
sphere sphere_of_spheres(sphere a, sphere b);
//<
