// plane.h - convex shapes in a plane, for the live figures of GJK, EPA and the
// response.

#ifndef TUMBLE_PLANE_H
#define TUMBLE_PLANE_H

#include "gjk.h"

// Turns d by the angle whose half has the tangent t: no sine is needed, so the
// bits are the same on all machines.
vec3 plane_turned(vec3 d, real t);
// The tangent of half of an angle of up to 150 degrees, to eleven digits.
real plane_tangent(real degrees);
// The mean of n places.
vec3 plane_middle(const vec3 *at, int n);
// Where `rest` stands: turned about its middle, and that moved by `to`.
void plane_place(const vec3 *rest, int n, vec3 to, real t, vec3 *at);

// A flat shape has no volume, which the hit face asks for: the same as a prism, 40
// m long.  Writes its corners, first all in front, to at[2 n].
hull plane_prism(const vec3 *flat, int n, vec3 *at);

// The corners of the flat A - B, counter-clockwise: at most `most`.
int  plane_difference(hull a, hull b, vec3 *at, int most);

#endif
