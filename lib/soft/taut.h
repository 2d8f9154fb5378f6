//> taut-head
// taut.h - a string under tension, stepped by the pull at the substep's end.
//
// Paper: nothing.  Book: chapter 12.
// Units: metres, inverse masses in 1/kg.

#pragma once

#include "vec3.h"

// Particle k has its coordinates, and its inverse mass, at number k * along.
typedef struct {
    int  particles, along;
    real *x, *y, *z;        // m
    const real *weight;     // 1/kg
    const real *stiffness;  // [particles - 1] kg, of each link: T h^2 / length
} taut_string;
//<

//> taut-declare
//>   One function says how taut a link may be before it needs this, and one
//>   takes the step.
// The most (kg) that T h^2 / length of a link may be to leave it to an explicit
// step, if strands of so many directions meet at its lighter end, which has this
// inverse mass.
real taut_most(real inverse_mass, int directions);

// Each link pulls its two ends together by its stiffness times the vector
// between them as it is afterwards.  room: [4 * particles], for its own use.
void taut_step(taut_string s, real *room);
//<
