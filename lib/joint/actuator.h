//> actuator-head
//>   What drives a joint is one more row along its free way, in the same
//>   elimination as all others. Its impulse does what the spring, the motor and
//>   the limits do together.
// actuator.h - motors, springs and limits along the free motion of a joint.
//
// Paper: not asked.  Book: chapter 17.
// Units: metres, kilograms, seconds, radians, newtons.

#pragma once

#include "joint.h"

// Sets a motor (rad/s and N m, or m/s and N).  A force of 0 takes it off, and a speed
// of 0 makes it friction.  Fails, changing nothing, if the joint has no free motion, a
// number is not finite, or the force is below 0.
status actuator_set_motor(joint *j, real speed, real force);

// Sets a spring and damper that pulls to `rest` with `stiffness` (N/m, N m/rad) and
// brakes with `damping` (N s/m, N m s/rad), with at most `bound` (N, N m).  Both 0: it
// is taken off.  Fails, changing nothing, as above.
status actuator_set_spring(joint *j, real rest, real stiffness, real damping,
                           real bound);

// Sets the friction of a ball joint: the most torque (N m) with which it resists
// turning.  Fails, changing nothing, if it is no ball joint, or the number no torque.
status actuator_set_friction(joint *j, real torque);

// Sets limits of a joint; they have a row of their own if it is not driven.
void actuator_set_limits(joint *j, real least, real most, bool has_limits);

// J, the most kinetic energy that motor and spring give to bodies at rest in so many
// seconds, from this place.
real actuator_energy(const joint *j, real place, real seconds);

// The step of such a joint.  The inverse effective mass (1/kg, 1/(kg m^2)) along its
// free motion while all other rows hold, for bodies of these inverse masses (1/kg).
real actuator_inverse(const joint_rows *r, real mass_a, real mass_b);

// Begins a substep of h (s), in which forces act for `kick` (s): velocities are those
// of the middle of a substep, so it is the mean of the last h and this one, and half of
// this one for a force that has not acted before.
// Finds what the spring gives.  A motor or spring at its most gives just that.
void actuator_begin(joint *j, joint_rows *r, real h, real kick);

// Once K, the matrix k of all n rows, and the compliance of hard rows are known: adds
// the compliance of a soft row, and clears a row that does not hold now.
void actuator_weigh(const joint *j, joint_rows *r, int n,
                    real k[JOINT_ROWS][JOINT_ROWS]);

// Finds the speed of a drive, and the speeds that its limits allow, from the place at
// the end of the substep, or, if that is NULL, for a motion at `speed`.  Returns what
// the row wants.
real actuator_bias(const joint *j, joint_rows *r, real h, real joint_rate,
                   const real *end, real speed);

// Keeps what row i of a cone wants, and returns it, or 0 if it does not hold, from the
// room at the end of the substep (rad), or, if that is NULL, for a motion at `speed`.
real actuator_bias_cone(const joint *j, joint_rows *r, int i, real h,
                        real joint_rate, const real *end, real speed);

// The same for friction, of bodies that turn with r->turning when a substep begins in
// which forces act for `kick` (s); what row i wants; and whether the joint has changed
// between holding and slipping.
void actuator_begin_friction(joint *j, joint_rows *r, real kick);
real actuator_bias_friction(const joint *j, const joint_rows *r, int i);
bool actuator_switch_friction(joint *j, const joint_rows *r,
                              real more[JOINT_ROWS]);

// After that: a limit that pulls lets go, and one that is passed holds.  Adds the
// impulses of that to `more`, and returns whether something has changed.
bool actuator_switch_cone(joint *j, const joint_rows *r, real more[JOINT_ROWS]);

// After actuator_bias: what gave more than it may gives its most, what gave its most
// and need not holds again, a limit that pulls lets go, and one that is passed holds.
// Returns whether something has changed; the impulse of that (N s) goes to *more.
bool actuator_switch(joint *j, const joint_rows *r, real *more);
//<
