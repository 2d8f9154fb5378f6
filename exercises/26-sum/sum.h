// sum.h - sums that lose less.

#ifndef TUMBLE_SUM_H
#define TUMBLE_SUM_H

#include "vec3.h"

// a + b, rounded as the machine does; *error is what the true sum is more than
// that, exactly.  For finite sums.
real two_sum(real a, real b, real *error);

// x[0] + ... + x[n - 1], as the sum of the first half (n / 2 of them) and the
// sum of the second; the halves likewise.  n = 0: 0.
real sum_pairs(const real *x, int n);

// The same sum one by one; what each addition loses is added up beside it, and
// put back in the end.  A sum that leaves the range of numbers is infinite.
real sum_careful(const real *x, int n);

#endif
