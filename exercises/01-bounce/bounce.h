// bounce.h - a ball over a floor.

#ifndef TUMBLE_BOUNCE_H
#define TUMBLE_BOUNCE_H

#include "vec3.h"

typedef struct {
    real height;        // m, above the floor, >= 0
    real speed;         // m/s, upwards
} ball;

// Where the ball is after dt (s), >= 0, under gravity g (m/s^2), > 0, with
// every bounce in between; each leaves the fraction e in [0, 1] of the speed (the
// restitution).
// At rest: height 0, speed 0.  If e is 1 it takes no longer for many bounces
// than for one.
ball ball_step(ball b, real g, real e, real dt);

#endif
