// turn.h - when do two bodies first touch that fly and turn?
//
// Units: metres, radians; time as a share of the frame, 0 to 1.

#ifndef TUMBLE_TURN_H
#define TUMBLE_TURN_H

#include "gjk.h"

// At time t its center has gone t way, and it has turned about the center by t
// angle, by the right-hand rule about axis.
typedef struct {
    hull shape;        // where it is at time 0
    vec3 center;            // m, at time 0
    vec3 way;               // m, in the frame
    vec3 axis;              // unit
    real angle;             // rad, in the frame; of either sign
} turning;

typedef enum {
    TURN_TOUCH,             // at time, as near as was asked for
    TURN_NEVER,             // not in this frame
    TURN_CAPPED,            // not before time; nothing is known of later
    TURN_NOT_FINITE
} turn_status;

typedef struct {
    turn_status status;
    real time;              // 0 to 1 of TOUCH and CAPPED; else 0
    vec3 normal;            // unit, from B to A, that parted them last; 0 if
                            // they overlap at time 0, and if they never touch
    int  looks;             // questions to GJK
} turn_result;

// Where b's points are at time t.
void turning_at(const turning *b, real t, vec3 *at);

// They touch when they are no further apart than within (m, > 0).  cap >= 1
// looks.  room is for the points of a and then those of b.
turn_result turn_first_touch(const turning *a, const turning *b, real within,
                             int cap, vec3 *room);

#endif
