// colours.h - particles red and black, so that every stick joins the two.

#ifndef TUMBLE_COLOURS_H
#define TUMBLE_COLOURS_H

#include "ordering.h"

enum { RED = 0, BLACK = 1 };

// Every stick joins two different particles.  Returns 0 if the particles can be
// coloured, and does so: colour[i] is RED or BLACK, the lowest of each piece
// RED.  If not, returns the number of particles of an odd ring (>= 3), which
// stand in ring[] one after another.  ring has room for every particle, scratch
// for three numbers each.
int two_colours(const stick *s, int sticks, int particles, int *colour,
                int *ring, int *scratch);

#endif
