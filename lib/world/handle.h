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
// What is touched from outside wakes, and with it all that sleep with it.

#pragma once

#include "world.h"
//<

//> handle-declare
// Where body b is, and how it moves: the place and the axes of its shape, the
// velocity of its centre of mass, and its spin about it.  Of a deformable one:
// the mean of its particles, their mean velocity, no rotation and no spin.  What
// is static or asleep stands still.
placement world_where(const world *w, int b);

// Puts body b elsewhere, at once, with that velocity; a deformable one as its
// shape is, at rest, with its pins.  What it touched is forgotten, and what lay
// on it wakes.  Only static bodies stay so: where.is_static is not asked.
// Fails, changing nothing, as world_add does.
status world_put(world *w, int b, placement where);

// Gives a rigid body this velocity of its centre of mass, and this spin about
// it; a kinematic one keeps them.  Nothing happens to a static one.
void world_set_velocity(world *w, int b, vec3 velocity, vec3 spin);

// In the order of tumble_kind.
typedef enum { BODY_DYNAMIC, BODY_STATIC, BODY_KINEMATIC } body_kind;

// Makes a rigid body another one, as it stands.  One that was kinematic and becomes
// dynamic goes on as it went; else it is at rest.  Nothing but world_set_velocity
// changes the velocity of a kinematic body: it pushes what it meets, carries what
// lies on it, and goes through what does not move.  What lay on the body wakes, and
// what is joined to it.
void world_set_kind(world *w, int b, body_kind kind);

// Another gravity (m/s^2) from now on: everything wakes, and has the velocity that
// it had.
void world_set_gravity(world *w, vec3 gravity);

// So many times the world's gravity acts on a rigid body from now on: it wakes, and
// has the velocity that it had.  A new one has 1.  Fails, changing nothing, if it is
// not finite, or beyond -1000 and 1000.
status world_set_gravity_scale(world *w, int b, real scale);

// An impulse (N s) on a rigid body, now, at a point of the world.  A static or
// kinematic one does not feel it.
void world_push(world *w, int b, vec3 impulse, vec3 at);

// An impulse (N s) on particle i of a deformable body.  A pinned one does not
// feel it.
void world_push_particle(world *w, int b, int i, vec3 impulse);

// m/s: how fast particle i of a deformable body goes, as world_where says it of
// bodies; and to give it a velocity.  False: it is pinned.
vec3 world_particle_velocity(const world *w, int b, int i);
bool world_set_particle_velocity(world *w, int b, int i, vec3 velocity);

// A force (N) at the centre of mass of a rigid body, and a torque (N m), all
// through the next step; what is set twice adds up.
void world_force(world *w, int b, vec3 force, vec3 torque);

// What they add to the velocity of body b in so many seconds of a frame.
motion world_load(const world *w, int b, real seconds);
// A step is over: they are gone.
void   world_forget_loads(world *w);

// What body b, or plane k, is made of; friction or restitution < 0: as the
// world's options say now.  Two that meet rub with the root of the product of
// their frictions, and bounce with the larger restitution.  Fail, changing
// nothing, if friction is more than 1000, restitution more than 1, or one is no
// number.
status world_set_material(world *w, int b, material m);
status world_set_plane_material(world *w, int k, material m);

// The shares of its velocity and its spin that a body loses, 1/s; a deformable
// one has no spin.  Fails, changing nothing, if one is negative or not finite.
status world_set_damping(world *w, int b, real damping, real spin_damping);

// Two bodies meet if the mask of each has a bit of the other's group.  A new one
// has group 1, and meets all.
void world_set_filter(world *w, int b, unsigned group, unsigned mask);

// Pieces of one body, of one material, have the same number > 0, so that a floor
// of them is one floor.  A new one has 0, and is alone.
void world_set_family(world *w, int b, int family);

// Puts body b to sleep where it is, without the forces that were set; anything
// may wake it.  Nothing happens to a static one.
void world_sleep(world *w, int b);
//<
