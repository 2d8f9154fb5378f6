//> exact-sums
#include "exact.h"

// Knuth's sum and Dekker's product (1971): what rounding drops is a double too,
// and can be had by taking the result apart again.
rounded exact_sum(real a, real b)
{
    real sum = a + b, b_there = sum - a, a_there = sum - b_there;
    return (rounded){ sum, (a - a_there) + (b - b_there) };
}

// A factor of 53 bits is cut in two of 26, whose products are exact.
rounded exact_product(real a, real b)
{
    real product = a * b, cut_a = 0x8000001p0 * a, cut_b = 0x8000001p0 * b;
    real ah = cut_a - (cut_a - a), al = a - ah;
    real bh = cut_b - (cut_b - b), bl = b - bh;
    return (rounded){ product,
                  al * bl - (((product - ah * bh) - al * bh) - ah * bl) };
}

// Exact where the result has at most 106 bits; else to about that many of the
// larger product.
rounded exact_minor(real a, real b, real c, real d)
{
    rounded ab = exact_product(a, b), cd = exact_product(c, d);
    rounded high = exact_sum(ab.high, -cd.high);
    return exact_sum(high.high, (high.low + ab.low) - cd.low);
}

vec3 cross_of_parallels(vec3 e, vec3 f)
{
    return (vec3){ exact_minor(e.y, f.z, e.z, f.y).high,
                   exact_minor(e.z, f.x, e.x, f.z).high,
                   exact_minor(e.x, f.y, e.y, f.x).high };
}
//<
