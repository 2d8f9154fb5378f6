//> arctan
//>   Angles of vectors, with the same last digits on every machine.
// arctan.h - the angle of a vector in a plane.
//
// Paper: not in it.  Book: chapter 13.  Units: radians.

#pragma once

#include "vec3.h"

// The arctangent of the C library has other last digits on another machine, so
// this is our own, of a few divisions and roots: arctan x for |x| <= 1.
// tan(t/2) = tan t / (1 + sqrt(1 + tan^2 t)), three times: what is left is
// below 0.1, and its series is good to rounding.
static inline real real_arctan(real x)
{
    for (int k = 0; k < 3; k++) x /= 1 + sqrt(1 + x * x);
    real y = x * x, sum = 0;
    for (int k = 17; k > 0; k -= 2) sum = 1.0 / k - y * sum;
    return 8 * x * sum;
}

// The angle of the vector (x, y), from -pi to pi; 0 of that of zeros.
static inline real real_angle(real x, real y)
{
    const real quarter = 1.5707963267948966;
    real a = fabs(x), b = fabs(y);
    real t = a > b ? real_arctan(b / a)
           : b > 0 ? quarter - real_arctan(a / b) : 0;
    if (x < 0) t = 2 * quarter - t;
    return y < 0 ? -t : t;
}
//<
