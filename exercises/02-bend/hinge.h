// hinge.h - two triangles that share an edge, pulled flat.

#ifndef TUMBLE_HINGE_H
#define TUMBLE_HINGE_H

#include "constraint.h"

// Two triangles (a, b, c) and (b, a, d) share the edge a b.  Flat, the lines a b
// and c d cross, in a point that both lines can name:
//     u a + (1 - u) b = v c + (1 - v) d.
// weight holds u, 1 - u, -v, -(1 - v).
typedef struct {
    int  at[4];         // a, b, c, d
    real weight[4];     // without unit; their sum is 0
    real stiffness;     // fraction of the error that one relaxation corrects
} bend;

// The bend of these four particles as they lie now: u and v of the points of the
// lines a b and c d that are nearest to each other.  A rope bends at m between c
// and d: at = { m, m, c, d }.  Fails if the lines a b and c d are parallel (the
// squared sine of their angle is below 1e-12), if c is d, or if a position is
// not finite; then *b is left as it was.
status bend_make(bend *b, const int at[4], const particle *p, real stiffness);

// Moves all four until both lines cross again.  The centre of mass and the
// angular momentum stay.  error of the result: m, the gap between the two
// points, never negative, HUGE_VAL for NaN.  Nothing moves if there is no gap, if
// all four are pinned, or if a position is NaN.
stick_result bend_relax(bend b, particle *p);

#endif
