//> material
//>   Where two materials meet, friction is the root of the product of their
//>   coefficients, as is usual, and restitution the larger of the two.
// material.h - what a body is made of, as far as contacts ask.
//
// Paper: no friction.  Book: chapter 13.

#pragma once

#include "vec3.h"

typedef struct {
    real friction;      // Coulomb's coefficient, >= 0
    real restitution;   // 0 to 1: speed after an impact / before
} material;

// Of two bodies that meet: rubber on anything grips, ice on anything slides,
// and what bounces does so on anything.
static inline material material_meet(material a, material b)
{
    return (material){ sqrt(a.friction * b.friction),
                       real_max(a.restitution, b.restitution) };
}

// Where body a meets body b, or a plane (b < 0), of those that are made of these.
static inline material material_between(const material *of, const material *wall,
                                        int a, int b)
{
    return material_meet(of[a], b < 0 ? wall[-1 - b] : of[b]);
}

// m/s: what meets more slowly does not bounce, or nothing would come to rest:
// a bounce that is over in less than two substeps of h (s), under gravity
// (m/s^2), is not told from what lies.
static inline real material_slowest(real gravity, real h)
{
    const real falls = 2;       // tuned, substeps
    return falls * gravity * h;
}
//<
