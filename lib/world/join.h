//> join-head
//>   To the world a joint is a number. A few functions make it, drive it, take it
//>   away and look at it.
// join.h - the joints of a world.
//
// Book: chapter 17.

#pragma once

#include "actuator.h"
#include "world.h"

// Joins two rigid bodies, or one and the world, or pins a particle, as they
// stand now; the joint's
// number in *number (which may be NULL).  Sleepers wake.  Fails, adding
// nothing, if joint_check does, or neither body can move, or for want of
// memory.
status world_join(world *w, joint_plan plan, int *number);

// Takes a joint away; what it held wakes.
void world_unjoin(world *w, int number);

// May the two bodies touch, as if they were not joined?  From the next frame on.
void world_touch_joint(world *w, int number, bool may_touch);

// Limits to a hinge: rad, of B against A, from how they stood when they were
// joined, from -pi to pi.  Or to a distance: m, from 0.  What lies beyond that is
// no limit, so -HUGE_VAL and HUGE_VAL take both off.  Fails, changing nothing, if
// these are none.
status world_limit_joint(world *w, int number, real least, real most);

// The axis of a ball joint, in the world as its bodies stand, leans by `swing` (rad)
// at most, and B turns about it from least to most (rad).  A swing of pi or more and
// a twist from -pi to pi or more are no limits.  Fails, changing nothing, if
// these are none.
status world_cone_joint(world *w, int number, vec3 axis, real swing, real least,
                        real most);

// rad; 0 if the joint has no cone.
real world_joint_swing(const world *w, int number);
real world_joint_twist(const world *w, int number);

// Friction of a ball joint, a motor or a spring along the free way of a joint
// (actuator.h).  Its bodies wake.  Fail, changing nothing, as those do.
status world_set_friction(world *w, int number, real torque);
status world_set_motor(world *w, int number, real speed, real force);
status world_set_spring(world *w, int number, real rest, real stiffness,
                        real damping, real bound);

// How hard are its two bodies to move along its free way, as they stand, and as
// if all others were not there?  kg, kg m^2; 0 if it has none.
real world_joint_inertia(const world *w, int number);

// How far the points of a joint are apart that should not be: m.  Where it is
// along its free way, and how fast: rad or m; 0 if it has none.
real world_joint_gap(const world *w, int number);
real world_joint_place(const world *w, int number);
real world_joint_speed(const world *w, int number);

// What motor, spring and limits together gave along that way in the last substep:
// N m or N; 0 if the joint is not driven.
real world_joint_drive(const world *w, int number);

// N m, what a joint bore in the last substep against turning, about its point.
real world_joint_torque(const world *w, int number);
//<

//> join-declare-inside
//>   More are for the step, and not for a program.
// A frame's part of the work, for step.c.  join_wake: what hangs on something that
// moves wakes, as world_wake_near says.
void join_wake(world *w);
linkage_pass join_pass(world *w, const solver_frame *f);
void join_begin(world *w, const solver_frame *f);
void join_islands_of_joints(world *w);

// After the substeps: linkage_unites may be asked.
void join_unite(world *w);
//<
