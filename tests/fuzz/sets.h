// sets.h - point sets made from a fuzzer's bytes, and what must hold of every
// answer about them, in long double.

#ifndef TUMBLE_SETS_H
#define TUMBLE_SETS_H

#include "bodies.h"
#include "fuzz.h"
#include "oracle.h"

// Two bodies of points, and what they measure.
typedef struct {
    body a, b;
    int  finite;        // every coordinate is
    int  fair;          // ... and 0 or from 1e-40 to 1e57 m, the smallest at
                        // least 1e-9 of the largest: answers are due
    long double reach;  // the largest coordinate of A - B
    long double place;  // twice the largest of A and B: what a place may be off
                        // is a share of it
} sets;

// Bodies of the oracle, turned, moved, flattened, scaled, or a few points of
// any kind: scattered, coincident, in line.
void sets_take(sets *s, bytes *in);
void sets_measure(sets *s);

// A point, within rounding of the size of the sets, of the hull's box.
int  set_may_hold(const body *b, vec3 x, long double rounding);

// 1 if every number of v is one.
int  is_number(real x);

#endif
