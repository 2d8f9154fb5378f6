// example_frames.h - frames of a scene that knows nothing but tumble.h.

#ifndef TUMBLE_EXAMPLE_FRAMES_H
#define TUMBLE_EXAMPLE_FRAMES_H

#include "example.h"
#include "status.h"

typedef struct {
    const example *scene;
    const tumble_world *world;
} example_moment;

// Of an example_moment, for frames_add: a picture.
status example_picture(const void *moment, const char *path);

// The same: a body an object, each triangle with corners of its own, as
// tumble_world_draw hands them out; ropes and joints are lines.
status example_obj(const void *moment, const char *path);

#endif
