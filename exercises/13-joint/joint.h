// joint.h - two bodies of four particles that share a point.
//
// Units: metres, kilograms.

#ifndef TUMBLE_JOINT_H
#define TUMBLE_JOINT_H

#include "rigid4.h"

// A point of body A, and one of body B or of the world.
typedef struct {
    int  a, b;              // the first of the four particles of each; b = -1:
                            // the world
    real share_a[FOUR], share_b[FOUR];  // which point: sum share_k x_k
    vec3 fixed;             // m, where it is if b is -1
} joint;

// The shares (sum 1) of a point of the body whose particles stand at `at`.  They
// do not lie in a plane.
void joint_shares(const vec3 at[FOUR], vec3 point, real share[FOUR]);

// Brings the two points together: moves the positions of both bodies' particles
// by the least moves, weighed by mass, that close the gap and (to first order)
// bend nobody.  The bodies' ways are those of a step ago (`previous`), so that
// momentum stays, and angular momentum, too, if the points were together then.
// Nailed bodies stay; where nobody can move, nobody does.  Returns how far the
// points were apart (m).
real joint_close(const joint *j, particle *p);

#endif
