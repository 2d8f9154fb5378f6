// ball.h - round bodies of 12, 42, 162, 642 ... corners, for the figures.

#ifndef TUMBLE_BALL_H
#define TUMBLE_BALL_H

#include "body.h"

enum { BALL_LEVELS = 4, BALL_CORNERS = 642 };

// An icosahedron whose triangles have been cut in four `level` times, with all
// corners on a sphere of that radius (m): shape_convex's plan of it.
// Fails as shape_convex does.
status ball_shape(shape *s, int level, real radius, real mass);

#endif
