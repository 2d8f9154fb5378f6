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

// Is the pair one of a body and a floor that touch, and is it asked in this frame?
bool seams_is_on_floor(const cache_frame *f, const cache_pair *p);

// Corrects the contacts of this frame that were found with a side of a floor which
// another piece covers, or which the body cannot reach past another piece.  Each is
// found again along the side that the body does reach, or loses its points.  Contacts
// of a body with pieces in one plane become one contact.
// It asks about bodies on a floor only, and about their first 64 contacts, or 2,048
// where there are parts of surfaces.  The result depends on where bodies are and how
// they move in this frame, and neither on an order nor on the past.  If memory is
// refused, nothing is corrected, and c->lost counts one more.
void seams_correct(contact_cache *c, const cache_frame *f);
//<
