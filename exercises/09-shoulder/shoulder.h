// shoulder.h - rods between points of bodies, and joints made of them.
//
// Units: metres, kilograms.

#ifndef TUMBLE_SHOULDER_H
#define TUMBLE_SHOULDER_H

#include "body.h"

// A point that rides on 1 to 4 particles: sum share_k x_k.  The shares add up
// to 1; one may be negative, the point is then beyond the particles.
typedef struct {
    int  count;
    int  at[4];         // in the pool; none twice, nor in the other end
    real share[4];
} rod_end;

// Holds two points at a distance, as a stick holds two particles.  Of length 0
// and STICK_EXACT it is a ball joint.
typedef struct {
    rod_end a, b;
    real length;        // m, >= 0
    stick_kind kind;
} rod;

// m, where the point is.
vec3 end_place(const rod_end *e, const particle *p);

// Gives the rod its length by the least move of the particles (each counted
// with its mass).  Returns the error before: distance - length, m; 0 if a
// one-sided rod is satisfied.  Moves nothing if all are pinned, or if the points
// coincide and the length is not 0: there is no direction.
real rod_relax(const rod *r, particle *p);

// Relaxes n rods, one after the other, again and again, until in a whole iteration
// none had an error of more than tolerance (m) in size, at most cap times.
// Returns how many iterations there were.
int rods_relax(const rod *r, int n, particle *p, real tolerance, int cap);

#endif
