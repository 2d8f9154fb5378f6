// collision.h - two carts on a rail.

#ifndef TUMBLE_COLLISION_H
#define TUMBLE_COLLISION_H

#include "vec3.h"

typedef struct {
    real velocity;          // m/s, positive to the right
    real inverse_mass;      // 1/kg; 0: a wall
} cart;

// What happened in a collision.
typedef struct {
    real impulse;           // N s, on b; a had the same to the left
    real lost;              // J, of the energy of motion
} collision;

// The velocity of both when they couple; 0 if both are walls.
real common_velocity(cart a, cart b);

// a comes from the left.  They part with e (0 to 1) of the speed with which they
// met.  Carts that do not approach, and two walls, are left alone.
collision collide(cart *a, cart *b, real e);

#endif
