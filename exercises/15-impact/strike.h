// strike.h - two bodies, and the points in which they strike each other.
//
// Units: metres, kilograms, seconds.

#ifndef TUMBLE_STRIKE_H
#define TUMBLE_STRIKE_H

#include "vec3.h"

// A rigid body.  What never moves has the inverse mass 0 and an inverse inertia
// of zeros.
typedef struct {
    vec3 velocity, spin;        // m/s, rad/s
    real inverse_mass;          // 1/kg
    vec3 inverse[3];            // 1/(kg m^2), of the inverse inertia, columns
} solid;

enum { STRIKE_POINTS = 8 };

// Bodies a and b touch in these points, all along one normal.
typedef struct {
    solid *a, *b;               // at least one of them can move
    vec3  normal;               // unit, from b to a
    int   points;               // 1 to STRIKE_POINTS
    vec3  ra[STRIKE_POINTS];    // m, from the centre of a to each point
    vec3  rb[STRIKE_POINTS];    // m, from the centre of b
    real  restitution;          // 0 to 1
} striking;

// kg: what the two bodies seem to weigh for an impulse along the normal at
// point k.
real impact_mass(const striking *s, int k);

// The impact.  Impulses along the normal, none of which pulls, stop all points
// that close; then they act once more, restitution times as large.
void impact_strike(striking *s);

#endif
