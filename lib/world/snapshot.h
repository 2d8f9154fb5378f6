//> snapshot-head
// snapshot.h - all that a world is, as bytes.
//
// Book: chapter 19.
// A struct goes to the bytes whole, so no number of it can be forgotten; and a
// table whose pointer is not listed would be freed twice.  What the next frame
// reads is listed with its elements, what it makes again as room.

#pragma once

#include "store.h"
#include "world.h"
//<

//> snapshot-declare
//>   It has one function for a world, and one for a shape.
// The tables of a world, which lies in memory that was entered.  The things of
// the store are the shapes of its bodies.  Read, it has no clock and no threads
// of its host.
void world_store(world *w, store *s);

// Those of a shape, likewise.
void shape_store(shape *x, store *s);
//<
