// ball.h - a ball against a box.
//
// Units: metres, in the frame of the box: its middle is the origin, its edges
// lie along the axes.

#ifndef TUMBLE_BALL_H
#define TUMBLE_BALL_H

#include "hit_face.h"

typedef struct {
    real gap;           // m, between the surfaces; < 0: they overlap
    vec3 normal;        // unit, from the box to the ball: the ball moves out
                        // along it by -gap
    vec3 on_box;        // m, the point of the box's surface nearest the centre
} ball_contact;

// half: half of the box's edges (m, > 0).  radius in m, >= 0.
ball_contact ball_meets_box(vec3 half, vec3 centre, real radius);

#endif
