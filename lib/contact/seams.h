//> seams-head
//>   One function goes over the contacts of a frame.
// seams.h - floors of several pieces, whose inner sides nothing should meet.
//
// Paper: bodies meet one by one.  Book: chapter 11.
// Units: metres, in the world's frame.

#pragma once

#include "cache_tables.h"

// Which of a and b lies on the other, as on a floor?  A floor does not move by
// itself, or is more than twice as large.  -1: neither (of two like bodies, in
// a heap, no side is hidden).  b < 0, a plane: a.
int seams_slider(const cache_frame *f, int a, int b);

// Mends the contacts that were found in this frame with a side of a floor that
// another piece hides, or that A cannot reach past one: each is found again
// along the side that A does reach, or emptied.  And those with pieces of one
// body that lie in one plane under A become one.
// Asks only about bodies on a floor, and no further than their first 64
// contacts, or 2,048 where there are parts of surfaces.  What is mended depends
// on where bodies are, and how they move, in this frame: not on an order, and not
// on the past.  For want of memory nothing is mended, and c->lost counts one
// more.
void seams_correct(contact_cache *c, const cache_frame *f);
//<
