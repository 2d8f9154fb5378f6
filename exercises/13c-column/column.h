// column.h - boxes on one another, which go up and down.
//
// Units: metres, kilograms, seconds.

#ifndef TUMBLE_COLUMN_H
#define TUMBLE_COLUMN_H

#include "vec3.h"

typedef struct {
    real y;                 // m, above where it would lie if all below just touched
    real velocity;          // m/s, upwards
    real inverse_mass;      // 1/kg, more than 0
} crate;

// How a contact takes back an overlap.
typedef struct {
    real rate;              // 1/s, of the overlap
    real mass;              // the share of the effective mass that answers
    real leak;              // the share of the old impulse that is let go
} give;

// Of a substep of h (s), omega (rad/s) and zeta, the damping ratio.
give column_spring(real h, real omega, real zeta);

// One substep of h (s) under gravity (m/s^2, more than 0 is downwards).  push[k]
// (kg m/s) is what contact k gave in the last substep, and afterwards what it
// gave in this one.
void column_substep(crate *c, real *push, int count, give soft, real h, real gravity);

#endif
