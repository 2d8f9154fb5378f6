//> rolling-head
// rolling.h - what rolls slowly comes to rest.
//
// Paper: nothing rolls there.  Book: chapter 18.

#pragma once

#include "world.h"

// Friction does not stop a ball that rolls, nor one that spins on its point:
// alone it would never sleep, and keep awake all that it touches.  So contacts
// of round bodies that carry something turn against slow rolling, as ground
// does that gives way a little: with a torque of a hundredth of the load times
// the radius, and no more than stops it.  Slow is up to 30 times the speed at
// which bodies fall asleep.  Spinning on a point, at any speed, is braked by as much
// again, unless there is no friction.  In a world without sleep neither is braked.  After
// the substeps of a frame.
void rolling_brake(world *w);
//<
