//> bend-head
// bend.h - ropes, and the columns and rows of a cloth, that resist bending.
//
// Paper: not asked.  Book: chapter 12.
// Units: metres, kilograms, seconds, joules.

#pragma once

#include "line.h"

// A row of the equations of one line.
typedef struct {
    real pivot;         // kg
    real next, after;   // of the two particles that follow
    vec3 move;          // m
} bend_row;
//<

//> bend-declare
// How long are the strands of s?  So many rows bend_relax needs as room.
int  bend_rows(const shape *s);

// What bending does in a substep of h (s), after the particles p of a body have
// been moved by everything else: an implicit step of Euler, which is stable for
// every stiffness >= 0 and every h.  stiffness: of a rope E I (N m^2); of a
// cloth that of one metre of its width (N m): E t^3 / 12 for a sheet of modulus
// E (Pa) and thickness t (m).  Straight is at rest.  Momentum is kept; pinned
// particles stay.  A strand whose numbers are not finite is left as it is.
void bend_relax(const shape *s, real stiffness, particle *p, real h,
                bend_row *room);

// J, what is stored in the bends.
real bend_energy(const shape *s, real stiffness, const particle *p);
//<
