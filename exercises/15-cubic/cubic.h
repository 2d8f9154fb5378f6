// cubic.h - when does a corner go through a triangle?
//
// Units: metres; time as a share of the way, 0 to 1.

#ifndef TUMBLE_CUBIC_H
#define TUMBLE_CUBIC_H

#include "vec3.h"

// The t from 0 to 1 at which c[0] + c[1] t + c[2] t^2 + c[3] t^3 = 0, in
// ascending order, to about 1e-12; at most three.  Where the curve only touches
// 0, within CUBIC_NOTHING times the sum of all |c|, that is a root as well, and
// is named once.  Returns how many there are; -1 if all c are 0; 0 if one of
// them is not finite.
#define CUBIC_NOTHING 1e-14

int cubic_roots(const real c[4], real root[3]);

// A corner and a triangle, 0 and 1, 2, 3: where they are at time 0, and where
// each goes, straight, until time 1.
typedef struct {
    vec3 at[4], way[4];
} meeting;

// The volume (m^3) that the three edges from the corner to the triangle span,
// (x1 - x0) . ((x2 - x0) x (x3 - x0)), as a polynomial in time.  It is 0 where
// the four lie in a plane.
void meeting_cubic(const meeting *m, real c[4]);

// 1 if the corner is ever in the triangle or on its rim, first at *time.  0,
// and nothing written, if not; nor if all four lie in one plane all the time,
// or the triangle is a line when they do.  On the rim: with weights of -1e-9 or
// more.
int corner_hits(const meeting *m, real *time);

#endif
