// spin.h - point masses that turn about an axis through the origin.

#ifndef TUMBLE_SPIN_H
#define TUMBLE_SPIN_H

#include "vec3.h"

typedef struct {
    real mass;              // kg
    vec3 position;          // m
    vec3 velocity;          // m/s
} point;

// kg m^2, about the axis: a unit vector.
real inertia(const point *p, int n, vec3 axis);

// kg m^2/s, about the origin.
vec3 angular_momentum(const point *p, int n);

// kg m^2, of a box about the axis through its middle that is perpendicular to the
// sides of lengths a and b (m).
real box_inertia(real mass, real a, real b);

// Brings each point to factor (more than 0) of its distance from the axis.  They
// turn about the axis as one body then, with the angular momentum along it that
// they had.  Returns the work (J).  Points on the axis alone: nothing changes, 0.
real pull_in(point *p, int n, vec3 axis, real factor);

#endif
