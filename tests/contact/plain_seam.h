//> plain-seam-head
// plain_seam.h - which way out of a floor of several pieces? slow, and short.
//
// The oracle of lib/contact/seams.c, which asks the contacts of a frame, for bodies
// and pieces of any shape.  Book: chapter 11.
// Units: metres.

#ifndef TUMBLE_PLAIN_SEAM_H
#define TUMBLE_PLAIN_SEAM_H

#include "scene.h"

#include <stdbool.h>

enum { PLAIN_SIDES = 6 };

// A convex piece: its sides look outwards.
typedef struct {
    int   sides;
    plane side[PLAIN_SIDES];
} plain_piece;

// A box along the world's axes; `half` (m) is half as large as it.
plain_piece plain_box(vec3 center, vec3 half);

bool plain_holds(const plain_piece *x, vec3 p);

// The side by which the corner p of a body leaves piece number b, in which it is, and
// the floor; -1: none.  Pieces with no more than `flush` (m) between them have no
// room there.
int plain_way_out(const plain_piece *piece, int pieces, int b, vec3 p, real flush);

#endif
//<
