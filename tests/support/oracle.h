//> oracle-head
//>   The duality gap of chapter 04 proves an answer to a reader who believes
//>   the mathematics. To trust the program as well, we want another way: one
//>   that shares nothing with GJK and EPA, and has hardly anything to get
//>   wrong. It may be as slow as it likes.
// oracle.h - slow answers that leave nothing to think about: the distance of
// two convex bodies, and how deep they are in each other.
//
// Every feature of the one is tried with every feature of the other, in long
// double.  The tests of chapters 4 and 5 compare the fast answers with these.
// Takes from lib/ the types of its questions, and none of its functions.
// Book: chapter 10, the slow way.

#ifndef TUMBLE_ORACLE_H
#define TUMBLE_ORACLE_H

#include "gjk.h"

// m, of bodies that are apart; of others it means nothing.
long double oracle_distance(hull a, hull b);
//<

//> oracle-declare-depth
//>   Which triples of points are faces, and which pairs are edges? We do not
//>   need to know. We try *all* triples and *all* pairs. A direction too many
//>   does no harm: it is a way out, too, and the shortest way out stays the
//>   shortest.
// m, how far A - B reaches from the origin along n (any length but 0): A must
// move by so much against n until all of it lies behind all of B.
long double oracle_width(hull a, hull b, vec3 n);

// m, the least move that parts them; of bodies that are apart, minus a lower
// bound of their distance.  Infinite if A - B has no area, and 0 or less if it
// lies in one plane.
long double oracle_depth(hull a, hull b);

#endif
//<
