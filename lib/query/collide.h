//> collide-head
//>   The engine asks two questions about a pair of rigid bodies, and so there
//>   are two functions: where do they touch now, and where will they first
//>   touch on their way? Both answer with a contact manifold, so that a solver
//>   need not know which question was asked.
// collide.h - where do two rigid bodies touch, or where will they?
//
// Paper: sections 5.1 and 6.1.  Book: chapter 15.
// Units: metres, in the world's frame.  Normals point from B to A.

#pragma once

#include "manifold.h"
#include "swept.h"

// The touches of bodies a and b that are nearer than margin (m, >= 0): what
// manifold_find makes of the nearest (or deepest) pair of points.  Where faces or edges
// are parallel, these are corners of their overlap, the deepest first; else the pair
// alone.  count is 0 if they are further apart than the margin, or a number is not
// finite.  turn (rad): see manifold_find.  carried: see query_nearest.
manifold collide_rigid(const collider *a, const collider *b, real margin,
                       real turn, query_cache *carried);

// The touches of bodies a and b where they first come as near as `apart` (m, >= 0),
// while they move as of_a and of_b say.  If the result is SWEPT_TOUCHES, *m has the
// normal of that moment, and the gaps of now along this normal; else *m is as it was.
// The time of touch is exact to a ten-thousandth of the smaller body.  scratch: room
// for the vertices of both.
swept_status collide_swept(const collider *a, const swept_motion *of_a,
                           const collider *b, const swept_motion *of_b,
                           real apart, vec3 *scratch, manifold *m);
//<
