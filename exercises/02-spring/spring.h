// spring.h - a stick that gives.

#ifndef TUMBLE_SPRING_H
#define TUMBLE_SPRING_H

#include "constraint.h"

typedef struct {
    int  a, b;          // particles, not the same
    real rest_length;   // m
    real compliance;    // m/N, >= 0: how far it gives for a newton; 0: a stick
} spring;

// Moves both ends until length - rest_length = compliance lambda / dt^2, where
// *lambda (kg m) is what this spring has given in all in this step of dt
// (s): the caller sets it to 0 before the first, and each call adds its own.
// lambda > 0 pulls the ends together.  Ends in one place or both pinned:
// nothing changes.
void spring_relax(spring s, particle *p, real dt, real *lambda);

#endif
