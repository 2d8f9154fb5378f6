//> angular-head
//>   What is within a body turns it as little as it moves it.
// angular.h - the angular momentum that links and bends must not change.
//
// Paper: nothing.  Book: chapter 12.
// Units: metres, inverse masses in 1/kg.

#pragma once

#include "verlet.h"

// Angular momentum times the substep, as Verlet's step keeps it: with the arms that
// the particles had a step ago.
typedef struct {
    vec3 middle;        // m, the centre of mass a step ago
    vec3 sum;           // kg m^2, about it
} angular;
//<

//> angular-declare
// Of n particles none of which is pinned.
angular angular_measure(const particle *p, int n);

// Turns the particles as a whole, about their centre of mass, so that they have the
// angular momentum that they had, if the links within them have changed it since.
// Their lengths change by half of the square of that small angle.  It is left if the
// angle is above a twentieth of a radian, or no number.
void angular_restore(angular was, particle *p, int n);
//<
