//> handle-head
//>   A program wants to know where a body is, and to push it. But there are
//>   only four particles. Their frame in the shape and their frame now differ
//>   by a rotation: that is how the body is turned. An impulse changes a
//>   motion, which is then written into `previous`.
// handle.h - what a program may do to a body between two steps.
//
// Paper: not asked; a body there only falls.  Book: chapter 18.
// Units: metres, seconds, kilograms, newtons, in the world's frame.
//
// A body that is changed from outside wakes, with all bodies that sleep with it.

#pragma once

#include "world.h"
//<

//> handle-declare
// Where body b is, and how it moves: the position and the axes of its shape, the
// velocity of its centre of mass, and its spin about it.  Of a rope or cloth: the mean
// position and velocity of its particles, no rotation and no spin.  Static and
// sleeping bodies stand still.
placement world_where(const world *w, int b);

// Puts body b elsewhere, at once, with a new velocity; a rope or cloth in the form of
// its shape, at rest, with its pins.  Its contacts are forgotten, and bodies that lay
// on it wake.  A static body stays static; where.is_static is not used.
// Fails, changing nothing, as world_add does.
status world_put(world *w, int b, placement where);

// Gives a rigid body a velocity of its centre of mass, and a spin about it.  A
// kinematic body keeps them.  Does nothing to a static one.
void world_set_velocity(world *w, int b, vec3 velocity, vec3 spin);

// In the order of tumble_kind.
typedef enum { BODY_DYNAMIC, BODY_STATIC, BODY_KINEMATIC } body_kind;

// Gives a rigid body another kind, where it is.  One that was kinematic and becomes
// dynamic keeps its velocity; else it is at rest.  Only world_set_velocity changes the
// velocity of a kinematic body: it pushes what it meets, carries what lies on it, and
// moves through static bodies.  Bodies that lie on it, or are joined to it, wake.
void world_set_kind(world *w, int b, body_kind kind);

// Sets gravity (m/s^2) from now on.  All bodies wake, and keep their velocities.
void world_set_gravity(world *w, vec3 gravity);

// Sets how many times the world's gravity acts on a rigid body; 1 at first.  The body
// wakes, and keeps its velocity.  Fails, changing nothing, if it is not finite, or
// beyond -1000 and 1000.
status world_set_gravity_scale(world *w, int b, real scale);

// Gives a rigid body an impulse (N s) at a point of the world, now.  Does nothing to a
// static or kinematic one.
void world_push(world *w, int b, vec3 impulse, vec3 at);

// Gives particle i of a rope or cloth an impulse (N s).  Does nothing to a pinned one.
void world_push_particle(world *w, int b, int i, vec3 impulse);

// The velocity (m/s) of particle i of a rope or cloth, and to set it.  False: it is
// pinned.
vec3 world_particle_velocity(const world *w, int b, int i);
bool world_set_particle_velocity(world *w, int b, int i, vec3 velocity);

// Sets a force (N) at the centre of mass of a rigid body, and a torque (N m), for all
// of the next step; calls before that step add up.
void world_force(world *w, int b, vec3 force, vec3 torque);

// What these forces add to the velocity of body b in so many seconds.
motion world_load(const world *w, int b, real seconds);
// Removes them, after a step.
void   world_forget_loads(world *w);

// Sets the material of body b, or of plane k.  Friction or restitution < 0: that of the
// world's options now.  See material.h for two that meet.  Fail, changing nothing, if
// friction is more than 1000, restitution more than 1, or one is NaN.
status world_set_material(world *w, int b, material m);
status world_set_plane_material(world *w, int k, material m);

// Sets the shares (1/s) of its velocity and its spin that a body loses; a rope or cloth
// has no spin.  Fails, changing nothing, if one is negative or not finite.
status world_set_damping(world *w, int b, real damping, real spin_damping);

// Two bodies meet if the mask of each has a bit of the other's group.  A new body has
// group 1, and meets all.
void world_set_filter(world *w, int b, unsigned group, unsigned mask);

// Sets the family of a body: pieces of one floor, of one material, have the same number
// > 0.  A new body has 0, and belongs to none.
void world_set_family(world *w, int b, int family);

// Puts body b to sleep where it is, and removes the forces that were set.  Does nothing
// to a static one.
void world_sleep(world *w, int b);
//<
