// spring.h - two weights on a spring.

#ifndef TUMBLE_SPRING_H
#define TUMBLE_SPRING_H

#include "vec3.h"

typedef struct {
    vec3 position;          // m
    vec3 velocity;          // m/s
    real inverse_mass;      // 1/kg; 0: it cannot move
} weight;

// rad/s, with which two weights of these inverse masses swing against each other
// on a spring of this stiffness (N/m); 0 if neither can move.
real spring_omega(real stiffness, real inverse_a, real inverse_b);

// One step of dt (s): new velocities from the spring's force at the old positions,
// then new positions from the new velocities.  rest: the spring's length at rest
// (m).  Weights in one place feel no force.
void spring_step(weight *a, weight *b, real stiffness, real rest, real dt);

// The smallest whole number of steps a second, at least 1, that gives each period
// of omega (rad/s) at least per_period steps.
int steps_a_second(real omega, int per_period);

#endif
