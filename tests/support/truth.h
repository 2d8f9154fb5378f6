// truth.h - the exact answer of a query about two small hulls, with its proof.
//
// Every feature of the one is tried with every feature of the other, in long
// double.  An answer counts only when it is proven: a distance by a plane that
// parts the bodies by as much, a depth by an error bound for every direction
// that could be shorter.  What long double does not prove is done again with 113
// bits.  Takes from lib/ the types of its questions, and none of its functions.

#ifndef TUMBLE_TRUTH_H
#define TUMBLE_TRUTH_H

#include "gjk.h"

enum { TRUTH_POINTS = 16 };         // of a body, at most

typedef struct {
    long double value;  // m, the distance; of bodies that overlap -depth
    long double doubt;  // m, how far the proof leaves it open
    long double size;   // m, the larger body's largest side
    int wider;          // it took 113 bits
} truth;

truth truth_find(hull a, hull b);

// m, how far A - B reaches along n, of any length.  To 113 bits.
long double truth_width(hull a, hull b, vec3 n);

#endif
