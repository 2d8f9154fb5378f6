// strip.h - a scene at three moments, side by side.

#ifndef TUMBLE_STRIP_H
#define TUMBLE_STRIP_H

#include "tumble.h"

enum { STRIP_PICTURES = 3 };

// Where pictures are taken from, beside a body that begins at x = z = 0: both go
// along with it, and the floor passes below.
typedef struct {
    int body;                   // its number among those of the world
    tumble_vec3 eye, target;    // m, as at the beginning
} strip_camera;

// The main of a figure, whose only argument is a file: paints the scene of this
// name there, at moments (s) that grow.  Fails if the scene fails, or what it
// claims is not so.
int strip_main(int arguments, char **argument, const char *scene,
               const double moment[STRIP_PICTURES]);

// The same, from a camera that goes along.
int strip_along(int arguments, char **argument, const char *scene,
                const double moment[STRIP_PICTURES], const strip_camera *c);

#endif
