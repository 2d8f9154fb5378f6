// cone.h - Coulomb's cone: the pushes that a surface can give.
//
// Units: newtons (any other unit of push will do).

#ifndef TUMBLE_CONE_H
#define TUMBLE_CONE_H

#include "vec3.h"

// Of all pushes with a part of at least 0 along normal (unit) and a part across
// it of at most mu (>= 0) times that, the one nearest to wish.
vec3 cone_nearest(vec3 wish, vec3 normal, real mu);

// Surfaces 0 to n-1, with these normals (unit, out of the surface), may push a
// particle at which a load pulls.  In each round each surface in turn gives the
// push of its cone that comes nearest to minus (the load and the pushes of all
// others).  push[] receives the pushes, which are 0 before the first round.
// Returns what is missing after the last: |load + the sum of all pushes|.
real grip(const vec3 *normal, int n, real mu, vec3 load, int rounds,
          vec3 *push);

#endif
