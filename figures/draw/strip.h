// strip.h - a scene at three moments, side by side.

#ifndef TUMBLE_STRIP_H
#define TUMBLE_STRIP_H

enum { STRIP_PICTURES = 3 };

// The main of a figure, whose only argument is a file: paints the scene of this
// name there, at moments (s) that grow.  Fails if the scene fails, or what it
// claims is not so.
int strip_main(int arguments, char **argument, const char *scene,
               const double moment[STRIP_PICTURES]);

#endif
