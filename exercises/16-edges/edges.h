// edges.h - the nearest points of two edges.
//
// Units: metres.

#ifndef TUMBLE_EDGES_H
#define TUMBLE_EDGES_H

#include "vec3.h"

typedef struct {
    real s, t;              // 0 to 1: how far along the first and the second edge
    vec3 way;               // m, from the second edge's point to the first's
} edge_meeting;

// The edges lead from p0 to p1 and from q0 to q1; either may have no length.
// If several pairs of points are nearest, any of them; so of two edges that are
// parallel but for an angle of 1e-7.
edge_meeting edges_nearest(vec3 p0, vec3 p1, vec3 q0, vec3 q1);

#endif
