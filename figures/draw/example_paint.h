// example_paint.h - paints a world as any program sees it, through tumble.h.

#ifndef TUMBLE_EXAMPLE_PAINT_H
#define TUMBLE_EXAMPLE_PAINT_H

#include "painter.h"
#include "example.h"

// Paints the world as it stands into that box of the picture, from where the
// example's camera stands.  lamps: see painter.h.  Fails only for want of memory.
status example_paint(const example *s, const tumble_world *w, int lamps,
                   picture *out, int left, int top, int width, int height);

#endif
