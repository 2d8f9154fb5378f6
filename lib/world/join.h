//> join-head
//>   To the world a joint is a number. Five functions make it, take it away and
//>   look at it.
// join.h - the joints of a world.
//
// Book: chapter 17.

#ifndef TUMBLE_JOIN_H
#define TUMBLE_JOIN_H

#include "world.h"

// Joins two rigid bodies, or one and the world, or pins a particle, as they
// stand now; the joint's
// number in *number (which may be NULL).  Sleepers wake.  Fails, adding
// nothing, if joint_check does, or neither body can move, or for want of
// memory.
status world_join(world *w, joint_plan plan, int *number);

// Takes a joint away; what it held wakes.
void world_unjoin(world *w, int number);

// Limits to a hinge: rad, of B against A, from how they stood when they were
// joined, from -pi to pi.  Or to a distance: m, from 0.  What lies beyond that is
// no limit, so -HUGE_VAL and HUGE_VAL take both off.  Fails, changing nothing, if
// these are none.
status world_limit_joint(world *w, int number, real least, real most);

// How far the points of a joint are apart: m.  How far a hinge has turned: rad.
real world_joint_gap(const world *w, int number);
real world_joint_angle(const world *w, int number);
//<

//> join-declare-inside
//>   Four more are for the step, and not for a program.
// A frame's part of the work, for step.c.
linkage_pass join_pass(world *w, const solver_frame *f);
void join_begin(world *w, const solver_frame *f);
void join_drop_pairs(world *w);
void join_islands_of_joints(world *w);

#endif
//<
