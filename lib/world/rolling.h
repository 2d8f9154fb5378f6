//> rolling-head
// rolling.h - rolling friction: a body that rolls slowly comes to rest.
//
// Paper: nothing rolls there.  Book: chapter 18.

#pragma once

#include "world.h"

// Friction stops neither a ball that rolls nor one that spins on its point.  It would
// never sleep, and keep everything awake that it touches.  So loaded contacts of round
// bodies act against slow rolling, as soft ground does, with a torque of a hundredth of
// the load times the radius, but no more than stops it.  Slow means up to 30 times the
// speed at which bodies fall asleep.  Spin about the normal, of any speed, is braked by
// the same torque, unless there is no friction.  In a world without sleep nothing is
// braked.  Call it after the substeps of a frame.
void rolling_brake(world *w);
//<
