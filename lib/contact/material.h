//> material
//>   Where two materials meet, friction is the root of the product of their
//>   coefficients, as is usual, and restitution the larger of the two.
// material.h - what a body is made of, as far as contacts ask.
//
// Paper: no friction.  Book: chapter 13.

#ifndef TUMBLE_MATERIAL_H
#define TUMBLE_MATERIAL_H

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

#endif
//<
