// gilbert.h - distance of convex bodies by E. G. Gilbert's method of 1966.
//
// Units: metres.

#ifndef TUMBLE_GILBERT_H
#define TUMBLE_GILBERT_H

#include "gjk.h"

typedef struct {
    int  ok;            // 0: a support is not finite, and all numbers are 0
    real most;          // m, |v|: the distance is no more than this
    real least;         // m, >= 0: and no less than this
    vec3 nearest;       // m, v, a point of A - B
    int  asked;         // questions: supports of A - B
} gilbert_result;

// The point of the segment from p to q that is nearest the origin.
vec3 segment_nearest(vec3 p, vec3 q);

// Until most - least <= relative_error * most, or v is 0, or has not become
// shorter, or cap (>= 1) questions are asked.
gilbert_result gilbert_distance(hull a, hull b, real relative_error,
                                int cap);

typedef struct {
    int answer;         // 1: further apart than the margin; 0: not; -1: not
                        // known after cap questions, or not finite
    int asked;
} gilbert_answer;

// margin in m, >= 0.  A distance of just the margin is not beyond it.
gilbert_answer gilbert_beyond(hull a, hull b, real margin, int cap);

#endif
