// ray.h - which of many boxes does a ray meet first?
//
// Units: metres; time in units of the ray's `way`.

#ifndef TUMBLE_RAY_H
#define TUMBLE_RAY_H

#include "vec3.h"

// A box along the axes, its sides included.  low <= high.
typedef struct {
    vec3 low, high;
} crate;

// From `from` (m) on along `way` (m), for the times 0 to most (>= 0; HUGE_VAL:
// for ever).  `way` need not be a unit vector; it may be 0.
typedef struct {
    vec3 from, way;
    real most;
} ray;

// 1 if the ray meets the box, first at *time: 0 if it begins inside.  0 if not,
// or if a number is a NaN: then *time is as it was.
int ray_box(const crate *box, ray r, real *time);

// The boxes stand in a line, sorted by low.x, so that one that begins further right
// comes later.  reach[k] is how far right any of the first k + 1 reaches.
void ray_reaches(const crate *box, int n, real *reach);

typedef struct {
    int  box;           // the first that is met; of equals the lowest; -1: none
    real time;          // when; most, if none is
    int  looked;        // how many boxes ray_box was asked for
} ray_hit;

// Asks only for boxes whose shadows on the x axis the ray crosses before it has
// met one, and some that lie among these.
ray_hit ray_first(const crate *box, const real *reach, int n, ray r);

#endif
