//> material
//>   Where two materials meet, friction is the root of the product of their
//>   coefficients, as is usual, and restitution the larger of the two.
// material.h - friction and restitution of a body.
//
// Paper: no friction.  Book: chapter 13.

#pragma once

#include "vec3.h"

typedef struct {
    real friction;      // Coulomb's coefficient, >= 0
    real restitution;   // 0 to 1: speed after an impact / before
} material;

// The material between two bodies that meet: rubber grips on anything, ice slides on
// anything, and a ball that bounces does so on anything.
static inline material material_meet(material a, material b)
{
    return (material){ sqrt(a.friction * b.friction),
                       real_max(a.restitution, b.restitution) };
}

// The material between body a and body b, or a plane (b < 0).
static inline material material_between(const material *of, const material *wall,
                                        int a, int b)
{
    return material_meet(of[a], b < 0 ? wall[-1 - b] : of[b]);
}

// m/s: bodies that meet more slowly do not bounce, or nothing would come to rest.  A
// bounce that is over in less than two substeps of h (s), under gravity (m/s^2), cannot
// be told from lying still.
static inline real material_slowest(real gravity, real h)
{
    const real falls = 2;       // tuned, substeps
    return falls * gravity * h;
}
//<
