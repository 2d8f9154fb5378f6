// shared.h - two rigid bodies of four particles that share a point.
//
// Units: metres, kilograms.

#ifndef TUMBLE_SHARED_H
#define TUMBLE_SHARED_H

#include "motion.h"

// A point of body A, and one of body B or of the world.
typedef struct {
    int  a, b;              // the first of the four particles of each; b = -1:
                            // the world
    vec3 local_a, local_b;  // which point: its coordinates in their frames
    vec3 fixed;             // m, where it is if b is -1
} joint;

// The coordinates of a point (m) in a frame: frame_point gives it back.
vec3 joint_local(const rigid_frame *frame, vec3 point);

// Brings the two points together: moves the positions of both bodies' particles
// by the displacements that a push at the points gives, one push on A and the
// opposite one on B, so that (to first order) the gap closes and no stick is
// bent.  Bases and arms are those of a step ago (`previous`), so that momentum
// stays, and angular momentum, too, if the points were together then.  All
// bodies are built to f.  Pinned ones stay; where nothing can move, nothing
// does.  Returns how far the points were apart (m).
real joint_close(const joint *j, const rigid4 *f, particle *p);

#endif
