// live_world.h - the bodies of a world in a live figure: pulled, pushed and drawn.

#ifndef TUMBLE_LIVE_WORLD_H
#define TUMBLE_LIVE_WORLD_H

#include "live.h"
#include "world.h"

// The hand pulls a rigid body for one frame, as if its mass (kg) were at least
// this.
void live_world_pull(world *w, int b, real least_mass);
// Makes a rigid body faster by dv (m/s).
void live_world_hurry(world *w, int b, vec3 dv);
// Draws body b, whose number it is to hands, too.
void live_world_body(const world *w, int b, live_colour c);

#endif
