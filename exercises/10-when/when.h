// when.h - when do two bodies meet that fly and do not turn?
//
// Units: metres, seconds.  Frame: the world's.

#ifndef TUMBLE_WHEN_H
#define TUMBLE_WHEN_H

#include "gjk.h"

typedef struct {
    hull shape;    // where it is at time 0
    vec3 velocity;      // m/s
} moving;

typedef enum {
    WHEN_MEET,          // at time, as near as was asked for
    WHEN_NEVER,         // not before the horizon, perhaps never at all
    WHEN_CAPPED,        // not before time; nothing is known of later
    WHEN_NOT_FINITE     // a coordinate is no number
} when_status;

typedef struct {
    when_status status;
    real time;          // s, of WHEN_MEET and WHEN_CAPPED; else 0
    vec3 normal;        // unit, from B to A, of a plane that parted them last;
                        // 0 if they overlap at time 0, and if they never meet
    int  looks;         // questions to GJK
} when_result;

// horizon (s) > 0, within (m) > 0, cap >= 1 looks; velocities are finite.  room
// is for a.shape.count points.
when_result when_meet(moving a, moving b, real horizon, real within, int cap,
                      vec3 *room);

#endif
