//> cache-header
//>   The functions have a header of their own.
// cache.h - the contacts of rigid bodies, from frame to frame.
//
// Paper: section 6.1, where contacts do not outlive a step.  Book: chapter 18.
//
// A pair is asked where it touches once a frame, as far ahead as its bodies may move,
// and turned as in the middle of the frame; and not at all while both bodies lie where
// they lay at the last query.
// Units: metres, kilograms, seconds.  Normals point from B to A.

#pragma once

#include "cache_tables.h"
//<

//> cache-declare
// Makes room for body b with so many vertices: a new number, or that of a body that was
// forgotten.  False, changing nothing, if memory is refused.
bool   cache_add(contact_cache *c, int b, int vertices);
void   cache_free(contact_cache *c);    // an empty or zeroed one is fine

// Finds the contacts of this frame (active, of, reach): those of two bodies in the
// order of the list, then those with planes.
void cache_update(contact_cache *c, const cache_frame *f);

// Finds contact k of this frame again, from where its bodies are now, for the rest of
// the frame.  It keeps its number.
void cache_again(contact_cache *c, const cache_frame *f, int k);

// After solver_activate: notes the least gap of each contact.
void cache_note(contact_cache *c, const contact_solver *s);

// Notes that body b has moved, none of its vertices by more than `delta` (m).
void cache_moved(contact_cache *c, int b, real delta);

// Forgets what is kept of n bodies, which go, or are put elsewhere.  In the next frame
// the list of pairs must be a new one.
void cache_forget(contact_cache *c, const int *b, int n);
// The same for a plane.
void cache_forget_plane(contact_cache *c, int wall);

// Merges two sorted lists that have no pair in common: returns the k-th pair of the one
// or the j-th of the other, whichever comes first, and counts k or j up.  One of them
// must have more.
const cache_pair *cache_next(const cache_list *l, int *k,
                             const cache_list *other, int *j);
//<
