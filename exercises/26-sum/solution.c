// solution.c - what is lost is known.

#include "sum.h"

// Knuth's, of 1969; Moeller's, of 1965.
real two_sum(real a, real b, real *error)
{
    real s = a + b;
    real from_b = s - a;
    real from_a = s - from_b;
    *error = (a - from_a) + (b - from_b);
    return s;
}

real sum_pairs(const real *x, int n)
{
    if (n < 1) return 0;
    if (n == 1) return x[0];
    return sum_pairs(x, n / 2) + sum_pairs(x + n / 2, n - n / 2);
}

// The second sum is wrong, too, but by a part of a part.
real sum_careful(const real *x, int n)
{
    real s = 0, lost = 0;
    for (int i = 0; i < n; i++) {
        real error;
        s = two_sum(s, x[i], &error);
        lost += error;
    }
    return s - s == 0 ? s + lost : s;
}
