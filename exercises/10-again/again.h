// again.h - what was known of two bodies in the last frame is asked first.
//
// Units: metres, in the frame of the points (the world's).

#ifndef TUMBLE_AGAIN_H
#define TUMBLE_AGAIN_H

#include "gjk.h"

// What the last query of a pair left.  All zero: there was none.
typedef struct {
    vec3    axis;       // from B to A: it parted them by more than the margin;
                        // 0: they were nearer
    simplex last;       // GJK's
} memory;

// m, how far all of A is beyond all of B along n (any length but 0): no two of
// their points are nearer than that.  Negative where n does not part them.
// Requires: the points are finite.
real gap_along(hull a, hull b, vec3 n);

// The answer of gjk_distance, which starts from m->last.  But while m->axis
// parts them by more than margin (m, >= 0), gjk_distance is not asked: then the
// status is GJK_BEYOND, the distance the gap along the axis, the axis m's,
// iterations 0, and *m stays as it was.
gjk_result ask_again(hull a, hull b, real margin, memory *m);

#endif
