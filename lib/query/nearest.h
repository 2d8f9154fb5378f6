//> nearest-head
// nearest.h - which point of a segment, a triangle or a tetrahedron is nearest
// the origin, and with which weights do its corners make it?
//
// Paper: section 5.1 asks whether a simplex holds the origin; here: the signed
// volumes of Montanari et al. (2017).  Book: chapter 10.
// Units: any length; nothing depends on it.

#ifndef TUMBLE_NEAREST_H
#define TUMBLE_NEAREST_H

#include "vec3.h"

// The point nearest the origin of the simplex with these corners, 1 to 4.
// weight[c] > 0 if corner c bears it, 0 if not.  Three that bear it have areas
// for weights: right beside each other, but their sum is not 1; all others' is.
vec3 nearest_of_simplex(const vec3 *of, int count, real weight[4]);

// The weights (>= 0, sum 1) of a triangle's corners that make x, a point of it.
void triangle_weights(vec3 p0, vec3 p1, vec3 p2, vec3 x, real weight[3]);
//<

//> nearest-segment
// The point of the segment p, q nearest the origin.  Its weights go to *wp and
// *wq; a corner that does not bear it gets 0.
static inline vec3 nearest_of_segment(vec3 p, vec3 q, real *wp, real *wq)
{
    vec3 e = vec3_sub(q, p);
    real ahead = -vec3_dot(p, e), behind = vec3_dot(q, e);
    *wp = 1;
    *wq = 0;
    if (!(ahead > 0)) return p;
    *wp = 0;
    *wq = 1;
    if (!(behind > 0)) return q;
    real whole = vec3_length_squared(e);
    *wp = behind / whole;
    *wq = ahead / whole;
    // Start from the nearer end: less is cancelled.  What rounding left along
    // the segment is taken off again, so that near the origin the answer is
    // perpendicular to it and not only close to the foot.
    vec3 v = ahead < behind ? vec3_add_scaled(p, *wq, e)
                            : vec3_add_scaled(q, -*wp, e);
    return vec3_add_scaled(v, -vec3_dot(v, e) / whole, e);
}

#endif
//<
