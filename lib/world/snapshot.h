//> snapshot-head
// snapshot.h - the whole state of a world as bytes.
//
// Book: chapter 19.
// A struct is stored whole, so no number of it can be forgotten, and a table that is
// not listed would be freed twice, which a test notices.  Tables that the next frame
// reads are listed with their elements, and those that it fills again as room.

#pragma once

#include "store.h"
#include "world.h"
//<

//> snapshot-declare
//>   It has one function for a world, and one for a shape.
// Stores, or reads, the tables of a world that lies in memory which was entered.  The
// things of the store are the shapes of its bodies.  A world that was read has no clock
// and no threads.
void world_store(world *w, store *s);

// The same for the tables of a shape.
void shape_store(shape *x, store *s);
//<
