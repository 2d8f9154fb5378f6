//> actuator-head
//>   What drives a joint is one more row along its free way, in the same
//>   elimination as all others. Its impulse does what the spring, the motor and
//>   the limits do together.
// actuator.h - motors, springs and their limits, along a joint's free way.
//
// Paper: not asked.  Book: chapter 17.
// Units: metres, kilograms, seconds, radians, newtons.

#pragma once

#include "joint.h"

// A motor: rad/s and N m, or m/s and N.  No force: it is taken off, and a force
// without a speed is friction.  Fails, changing nothing, if the joint has no free
// way, or numbers are not finite, or the force is below 0.
status actuator_set_motor(joint *j, real speed, real force);

// A spring and damper: it pulls to `rest` with `stiffness` (N/m, N m/rad) and
// brakes with `damping` (N s/m, N m s/rad), by `bound` (N, N m) at most.  With
// both 0 it is taken off.  Fails, changing nothing, as above.
status actuator_set_spring(joint *j, real rest, real stiffness, real damping,
                           real bound);

// Friction of a ball joint: it resists turning with so much (N m) at most; 0: not
// at all.  Fails, changing nothing, if the joint is none, or the number no torque.
status actuator_set_friction(joint *j, real torque);

// Limits of a joint, which are rows of their own if it is not driven.
void actuator_set_limits(joint *j, real least, real most, bool has_limits);

// J: so much motion, at most, motor and spring give to bodies at rest in so many
// seconds, from that place on.
real actuator_energy(const joint *j, real place, real seconds);

// The step of such a joint.  What answers along the free way, if all other rows
// hold: 1/kg, 1/(kg m^2); the inverse masses (1/kg) are those of its bodies.
real actuator_inverse(const joint_rows *r, real mass_a, real mass_b);

// A substep of h (s) begins, in which forces act for `kick` (s): as velocities are
// those of the middle of a substep, it is the mean of the last h and this one, and
// half of this one for what has not acted before.
// Finds what the spring gives.  What gives its most gives that, whatever it gave
// before.
void actuator_begin(joint *j, joint_rows *r, real h, real kick);

// When K, the matrix k of all n rows, and what hard rows give way by are known: a
// soft row gives way by more, and one that is none now has none.
void actuator_weigh(const joint *j, joint_rows *r, int n,
                    real k[JOINT_ROWS][JOINT_ROWS]);

// How fast does it go, and how fast may it, between its limits?  With the place
// at the end of the substep, or, if that is NULL, for what goes on at `speed`.
// Returns what the row wants.
real actuator_bias(const joint *j, joint_rows *r, real h, real joint_rate,
                   const real *end, real speed);

// Keeps what row i of a cone wants, and returns it, or 0 if it does not hold.  With
// the room at the end of the substep (rad), or, if that is NULL, for what it grows
// by at `speed`.
real actuator_bias_cone(const joint *j, joint_rows *r, int i, real h,
                        real joint_rate, const real *end, real speed);

// The same of friction, when the bodies turn by r->turning at the begin of a substep
// in which forces act for `kick` (s); what row i wants; and whether the joint holds or
// slips has changed.
void actuator_begin_friction(joint *j, joint_rows *r, real kick);
real actuator_bias_friction(const joint *j, const joint_rows *r, int i);
bool actuator_switch_friction(joint *j, const joint_rows *r,
                              real more[JOINT_ROWS]);

// After that: a limit that pulls lets go, one that is passed holds.  The impulses
// that are to be given at once are added to `more`.  Returns whether that has
// changed.
bool actuator_switch_cone(joint *j, const joint_rows *r, real more[JOINT_ROWS]);

// After actuator_bias: what gave more than it may gives its most, what gave its
// most and need not holds again, a limit that pulls lets go, and one that is
// passed holds.  Returns whether that has changed; the impulse that is to be
// given at once, N s, in *more.
bool actuator_switch(joint *j, const joint_rows *r, real *more);
//<
