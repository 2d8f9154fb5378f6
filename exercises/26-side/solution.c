// solution.c - six products, twelve numbers, one sign.

#include "side.h"

static real two_sum(real a, real b, real *error)
{
    real s = a + b, from_b = s - a, from_a = s - from_b;
    *error = (a - from_a) + (b - from_b);
    return s;
}

// Halves of 26 bits have products of 52 (Veltkamp, Dekker).
static real two_product(real a, real b, real *error)
{
    real p = a * b, t = 134217729 * a, u = 134217729 * b;
    real a_high = t - (t - a), b_high = u - (u - b);
    real a_low = a - a_high, b_low = b - b_high;
    *error = a_low * b_low
           - (((p - a_high * b_high) - a_low * b_high) - a_high * b_low);
    return p;
}

// To the list e of n numbers, the small ones first, adds a b.  Returns how many
// there are now.
static int add_product(real *e, int n, real a, real b)
{
    real small, large = two_product(a, b, &small);
    for (int i = 0; i < n; i++) small = two_sum(small, e[i], &e[i]);
    e[n++] = small;
    for (int i = 0; i < n; i++) large = two_sum(large, e[i], &e[i]);
    e[n++] = large;
    return n;
}

// The largest number outweighs all others together.
int side(vec3 a, vec3 b, vec3 c)
{
    real e[12];
    int n = add_product(e, 0, a.x, b.y);
    n = add_product(e, n, -a.y, b.x);
    n = add_product(e, n, b.x, c.y);
    n = add_product(e, n, -b.y, c.x);
    n = add_product(e, n, c.x, a.y);
    n = add_product(e, n, -c.y, a.x);
    for (int i = n - 1; i >= 0; i--) {
        if (e[i] > 0) return 1;
        if (e[i] < 0) return -1;
    }
    return 0;
}
