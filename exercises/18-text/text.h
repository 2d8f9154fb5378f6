// text.h - a scene that is written down.
//
// Units: metres, seconds, kilograms.

#ifndef TUMBLE_TEXT_H
#define TUMBLE_TEXT_H

#include "step.h"

enum { TEXT_BODIES = 20, TEXT_LINE = 200 };

// The world, and the shapes of its bodies, which have to stay where they are as
// long as it lives: a text_scene is never copied.
typedef struct {
    world world;
    int   bodies;                   // how many of the plans are built
    shape plan[TEXT_BODIES];
} text_scene;

// Builds the scene that the text tells, ready for its first step.  A line is
//
//   gravity  X Y Z                 m/s^2; before the first body
//   plane    X Y Z OFFSET          a half-space, as world_add_plane has it
//   box      X Y Z MASS  X Y Z     sides, mass, where its middle is
//   ball     RADIUS MASS  X Y Z    an icosahedron
//   throw    X Y Z                 the last body's velocity
//   spin     X Y Z                 the last body's spin, rad/s
//   nail                           the last body never moves
//
// or nothing; # and what follows it in a line mean nothing.  Of a world's
// options all but gravity are the default ones.  Fails with "line N: " and a
// sentence, N from 1 on: a word that is not known, a number too many, too few,
// or not finite, a line of TEXT_LINE characters or more, a body too many, and
// what the builders of shapes and worlds refuse.  *s is empty then.
status text_scene_read(text_scene *s, const char *text);

// Gives everything back.  *s is empty after it; an empty or zeroed one is fine.
void text_scene_free(text_scene *s);

#endif
