//> cache-header
//>   The functions have a header of their own.
// cache.h - the contacts of rigid bodies, from frame to frame.
//
// Paper: section 6.1, where contacts do not outlive a step.  Book: chapter 18.
//
// A pair is asked where it touches once a frame, as far ahead as its bodies may
// get, and turned as they will be in its middle; and not at all while they lie
// where they lay when they were last asked.
// Units: metres, kilograms, seconds.  Normals point from B to A.

#pragma once

#include "cache_tables.h"
//<

//> cache-declare
// For body b, with so many vertices, which is one more, or in the place of one
// that was forgotten.  Fails, forgetting nothing.
status cache_add(contact_cache *c, int b, int vertices);
void   cache_free(contact_cache *c);    // an empty or zeroed one is fine

// The contacts of this frame in active, reach: those of pairs by pair, then
// those with planes.
void cache_update(contact_cache *c, const cache_frame *f);

// Asks again for contact k of this frame, of bodies where they are now and for
// what is ahead of them.  It keeps its place.
void cache_again(contact_cache *c, const cache_frame *f, int k);

// After the solver has taken them: what each contact's least gap is.
void cache_note(contact_cache *c, const contact_solver *s);

// Body b has been moved: no vertex of it by more than way (m).
void cache_moved(contact_cache *c, int b, real way);

// What is kept of n bodies is forgotten: they go, or are put elsewhere.  In the
// next frame the list of pairs must be a new one.
void cache_forget(contact_cache *c, const int *b, int n);
// Likewise of a plane.
void cache_forget_plane(contact_cache *c, int wall);

// The next pair of two sorted lists that have no pair in common: the k-th of the
// one, or the j-th of the other.  One of them has more.
const cache_pair *cache_next(const cache_list *l, int *k,
                             const cache_list *other, int *j);
//<
