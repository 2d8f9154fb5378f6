//> vec3-head
// vec3.h - three numbers that add, scale and measure.
//
// Book: chapter 0.  The functions stand in the header, inline, because every
// loop of the library is made of them and each is a line or two.
// Only + - * / and sqrt: IEEE 754 rounds these alike everywhere, so the same
// scene gives the same bits on every machine.

#ifndef TUMBLE_VEC3_H
#define TUMBLE_VEC3_H

#include <math.h>
#include <stdbool.h>

#ifdef __FAST_MATH__
#error "compile without -ffast-math: it rounds otherwise, and overlooks NaN"
#endif

// The number type has a name of its own, so that a reader may try float.
typedef double real;

typedef struct {
    real x, y, z;
} vec3;
//<

//> real-max
// The larger and the smaller of two numbers.  If a is NaN, the result is b.
static inline real real_max(real a, real b)
{
    return a > b ? a : b;
}

static inline real real_min(real a, real b)
{
    return a < b ? a : b;
}

static inline int int_max(int a, int b)
{
    return a > b ? a : b;
}

static inline int int_min(int a, int b)
{
    return a < b ? a : b;
}
//<

//> vec3-add
static inline vec3 vec3_make(real x, real y, real z)
{
    return (vec3){ x, y, z };
}

static inline vec3 vec3_add(vec3 a, vec3 b)
{
    return (vec3){ a.x + b.x, a.y + b.y, a.z + b.z };
}

static inline vec3 vec3_sub(vec3 a, vec3 b)
{
    return (vec3){ a.x - b.x, a.y - b.y, a.z - b.z };
}

static inline vec3 vec3_scale(real s, vec3 a)
{
    return (vec3){ s * a.x, s * a.y, s * a.z };
}

// a + s b: start at a, go s times b.
static inline vec3 vec3_add_scaled(vec3 a, real s, vec3 b)
{
    return (vec3){ a.x + s * b.x, a.y + s * b.y, a.z + s * b.z };
}
//<

//> vec3-products
static inline real vec3_dot(vec3 a, vec3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

// Perpendicular to a and b, by the right-hand rule; its length is the area of
// their parallelogram.
static inline vec3 vec3_cross(vec3 a, vec3 b)
{
    return (vec3){ a.y * b.z - a.z * b.y,
                   a.z * b.x - a.x * b.z,
                   a.x * b.y - a.y * b.x };
}
//<

//> vec3-length
static inline real vec3_length_squared(vec3 a)
{
    return vec3_dot(a, a);
}

static inline real vec3_length(vec3 a)
{
    return sqrt(vec3_dot(a, a));
}

static inline real vec3_distance(vec3 a, vec3 b)
{
    return vec3_length(vec3_sub(a, b));
}

// The unit vector along a; the zero vector, which has no direction, stays zero.
static inline vec3 vec3_unit(vec3 a)
{
    real length = vec3_length(a);
    return length > 0 ? vec3_scale(1 / length, a) : a;
}
//<

//> vec3-angle
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

//> vec3-finite
// True if no component is infinite or NaN.  x - x is 0 for every finite x, and
// NaN for the others.
static inline bool vec3_is_finite(vec3 a)
{
    return a.x - a.x == 0 && a.y - a.y == 0 && a.z - a.z == 0;
}

#endif
//<
