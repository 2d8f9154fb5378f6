//> vec3-head
// vec3.h - three numbers that add, scale and measure.
//
// Book: chapter 0.  The functions stand in the header, inline, because every
// loop of the library is made of them and each is a line or two.
// Only + - * / and sqrt: IEEE 754 rounds these alike everywhere, so the same
// scene gives the same bits on every machine.

#pragma once

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

//> vec3-swap
// Exchanges two things of that type.
#define SWAP(type, a, b) \
    do { type was_ = (a); (a) = (b); (b) = was_; } while (0)
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

//> vec3-finite
// True if no component is infinite or NaN.  x - x is 0 for every finite x, and
// NaN for the others.
static inline bool vec3_is_finite(vec3 a)
{
    return a.x - a.x == 0 && a.y - a.y == 0 && a.z - a.z == 0;
}
//<
