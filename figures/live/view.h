// view.h - scenes of any size and place, seen by the one camera of a live figure:
// turned about the vertical, scaled and moved, so that what a scene's own eye looks at
// lies before it.

#ifndef TUMBLE_VIEW_H
#define TUMBLE_VIEW_H

#include "live.h"

// The camera of such a figure.
#define VIEW_CAMERA { .distance = 6, .turn = 0.5, .rise = 0.3, .target = { 0, 1, 0 }, .has_floor = true }

// A floor at height 0 stays there; without one the target is lifted off the ground.
void view_look(vec3 eye, vec3 target, bool has_floor);
real view_scale(void);          // drawn metres for one of the scene
vec3 view_of(vec3 place);       // of the scene -> as it is drawn
vec3 view_back(vec3 place);
vec3 view_turn(vec3 way);       // likewise, of a way or a velocity
vec3 view_turn_back(vec3 way);

#endif
