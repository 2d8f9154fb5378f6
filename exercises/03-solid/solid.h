// solid.h - mass, centre and inertia of what is inside a mesh.

#ifndef TUMBLE_SOLID_H
#define TUMBLE_SOLID_H

#include "body.h"

typedef struct {
    real mass;                      // kg
    vec3 centre;                    // m
    real xx, yy, zz, yz, zx, xy;    // kg m^2: the sums of m x x ..., measured
                                    // from the centre
} solid;

// The solid of this density (kg/m^3) inside a closed mesh with its vertices at
// `at` (m).  If the faces look inwards mass and spread are negative, as for a
// hole.  Without faces, or of mass 0: all zeros.
solid solid_measure(const mesh *m, const vec3 *at, real density);

#endif
