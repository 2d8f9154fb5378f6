//> exact-head
// exact.h - sums and products that keep what rounding drops.
//
// Paper: nothing of the kind; near touch all that it computes is a small
// difference of large numbers.  Source: Dekker (1971).  Book: chapter 10.
// Units: whatever goes in; powers of it come out.

#ifndef TUMBLE_EXACT_H
#define TUMBLE_EXACT_H

#include "vec3.h"

// A result rounded, and what rounding dropped: high + low is (more) exact.
typedef struct {
    real high, low;
} rounded;

rounded exact_sum(real a, real b);  // a + b, exactly
rounded exact_product(real a, real b);  // a b, exactly
rounded exact_minor(real a, real b, real c, real d);  // a b - c d

// The cross product e x f, rounded once at the end: for vectors so nearly
// parallel that the products cancel.
vec3 cross_of_parallels(vec3 e, vec3 f);

#endif
//<
