//> halves-head
// halves.h - a world in two halves, which two threads may work on at once.
//
// Paper: not asked.  Book: chapter 16.
//
// What is divided, and how, depends on the world alone, never on whether there
// are two threads: so the bits are the same.

#ifndef TUMBLE_HALVES_H
#define TUMBLE_HALVES_H

#include "world.h"
//<

//> halves-declare
// Does work(data, 0) and work(data, 1): at once, if options.both does, else one
// after the other.  What one of them writes the other must not touch.
void halves_do(const world *w, void (*work)(void *data, int half), void *data);

// Cuts the world in two, across its longest side, so that half of the bodies
// that move lie on either side.  Requires: w->pairs.ball is of this frame.  If
// few move, nothing is cut: all are left.
void halves_cut(world *w);

// The bodies on one side, 0 or 1, of the cut; how many in *n.
const int *halves_bodies(const world *w, int side, int *n);

// In which part of a pile (PILE_LEFT, PILE_RIGHT, PILE_ACROSS) is a contact of
// bodies a and b, or of a with a plane (b >= bodies)?
int halves_part(const world *w, int a, int b);

// Puts the contacts that remember in parts, for push_pile: those of the left
// side alone, those of the right, and those across the cut.
void halves_sort(world *w);

#endif
//<
