//> join-head
//>   To the world a joint is a number. A few functions make it, drive it, take it
//>   away and look at it.
// join.h - the joints of a world.
//
// Book: chapter 17.

#pragma once

#include "actuator.h"
#include "world.h"

// Joins two rigid bodies, or one and the world, or pins a particle, as they stand now.
// The number of the joint goes to *number, which may be NULL.  Sleepers wake.  Fails,
// adding nothing, if joint_check fails, neither body can move, or memory is refused.
status world_join(world *w, joint_plan plan, int *number);

// Removes a joint; its bodies wake.
void world_unjoin(world *w, int number);

// Says whether the two bodies may collide, as if they were not joined, from the next
// frame on.
void world_touch_joint(world *w, int number, bool may_touch);

// Sets the limits of a hinge (rad, of B as seen from A, 0 as they stood when they were
// joined, -pi to pi) or of a distance (m, from 0).  Beyond these there is no limit, so
// -HUGE_VAL and HUGE_VAL take both off.  Fails, changing nothing, if they are no
// limits.
status world_limit_joint(world *w, int number, real least, real most);

// Sets the cone of a ball joint: the axis, in the world as the bodies stand now, leans
// by at most `swing` (rad), and B turns about it from least to most (rad).  A swing of
// pi or more, or a twist beyond -pi and pi, is no limit.  Fails, changing nothing, if
// they are no limits.
status world_cone_joint(world *w, int number, vec3 axis, real swing, real least,
                        real most);

// rad; 0 if the joint has no cone.
real world_joint_swing(const world *w, int number);
real world_joint_twist(const world *w, int number);

// Sets the friction of a ball joint, or a motor or a spring along the free motion of a
// joint (actuator.h).  Its bodies wake.  Fail, changing nothing, as those functions do.
status world_set_friction(world *w, int number, real torque);
status world_set_motor(world *w, int number, real speed, real force);
status world_set_spring(world *w, int number, real rest, real stiffness,
                        real damping, real bound);

// The effective mass (kg, kg m^2) of its two bodies along its free motion, as they
// stand, without all other joints; 0 if it has no free motion.
real world_joint_inertia(const world *w, int number);

// The gap (m) between the points of a joint.  Where it is along its free motion (rad or
// m), and how fast it moves; 0 if it has none.
real world_joint_gap(const world *w, int number);
real world_joint_place(const world *w, int number);
real world_joint_speed(const world *w, int number);

// What motor, spring and limits together gave along it in the last substep (N m or N);
// 0 without motor and spring.
real world_joint_drive(const world *w, int number);

// N m, the torque that a joint bore in the last substep, about its point.
real world_joint_torque(const world *w, int number);
//<

//> join-declare-inside
//>   More are for the step, and not for a program.
// The work of a frame, for step.c.  join_wake wakes what hangs on something that moves,
// as world_wake_near says.
void join_wake(world *w);
linkage_pass join_pass(world *w, const solver_frame *f);
void join_begin(world *w, const solver_frame *f);
void join_islands_of_joints(world *w);

// After the substeps: linkage_unites may be called.
void join_unite(world *w);
//<
