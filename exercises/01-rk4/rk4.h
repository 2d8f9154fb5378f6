// rk4.h - the classical method of Runge and Kutta, of order 4.

#ifndef TUMBLE_RK4_H
#define TUMBLE_RK4_H

#include "vec3.h"

typedef struct {
    vec3 position;      // m
    vec3 velocity;      // m/s
} motion;

// The acceleration (m/s^2) of a particle in this motion at time t (s).  about
// is whatever the caller wants it to know.
typedef vec3 acceleration(motion m, real t, const void *about);

// Where the motion m, at time t, has come after dt (s).  Asks a four times.
motion rk4_step(motion m, acceleration *a, const void *about, real t, real dt);

#endif
