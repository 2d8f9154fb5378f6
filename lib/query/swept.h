//> swept-head
//>   The result says what became of the two bodies, and when. Time is a
//>   fraction of the way, so the query knows nothing of seconds.
// swept.h - when do two bodies on their way first touch?
//
// Paper: section 7 asks for very small time steps when objects are thin; here:
// conservative advancement (Mirtich 1996) on gjk, because the time of touch can
// be had for two or three distances.
// Book: chapter 15.
// Units: metres; time as a share of the way, 0 to 1.

#pragma once

#include "body.h"
#include "gjk.h"

typedef enum {
    SWEPT_PASSES,       // they stay further apart than `apart` all the way
    SWEPT_TOUCHES,      // first as near as `apart` at `time`
    SWEPT_OVERLAP,      // as near as that at the start already: time 0
    SWEPT_CAPPED,       // nearing, but too slowly to tell: time is a moment up
                        // to which they surely do not touch
    SWEPT_NOT_FINITE
} swept_status;

typedef struct {
    swept_status status;
    real time;          // 0 to 1; 1 if they pass
    vec3 normal;        // unit, from B to A, at that time; 0 if the hulls
                        // themselves overlap at the start: ask hit_face.  Of
                        // bodies that pass: the last axis that parted them
    vec3 on_a, on_b;    // m, the nearest points at that time, A's where A then
                        // is; only of bodies that touch or overlap
    simplex last;       // their vertices and weights
    int  iterations;    // distances asked for
    int  supports;      // support points that these asked for
} swept_result;
//<

//> swept-declare
//>   A body that turns does not go straight. Its outermost point leaves the
//>   straight way by no more than the arc of its turning. Put that arc into
//>   `apart`, and nothing is missed, though the answer comes a little early.
enum { SWEPT_CAP = 64 };        // distances, at most

// Hull a goes straight by `way` (m) as seen from b, without turning (a body
// that turns: put its turning into `apart`, as the arc of its outermost point).
// Touching is to come nearer than apart (m, >= 0), to within tolerance (m, > 0,
// of which the caller knows the scale): the answer's distance lies between
// apart and apart + tolerance.  A tolerance finer than doubles can tell, 8
// units in the last place of the way and the sizes, is raised to that.
// scratch: room for a.count + b.count points.
swept_result swept_first_touch(hull a, vec3 way, hull b, real apart,
                               real tolerance, vec3 *scratch);
//<

//> swept-turning-declare
//>   And it is the arc of a whole frame: a needle that tumbles is thinner than that,
//>   and what comes by would touch all that it might sweep. So the second query turns
//>   the bodies as well.
// How a hull goes in a frame: its centre straight, and all of it about that.
typedef struct {
    vec3 center;        // m, at the start
    vec3 way;           // m, in the frame
    vec3 turn;          // rad, in the frame, by the right-hand rule
    real out;           // m, its furthest point from the centre
} swept_motion;

// Where the points of h come to after a share t of the frame.
void swept_place(hull h, const swept_motion *m, real t, vec3 *out);

// When hulls that go so first come as near as apart, as swept_first_touch says.
// Where they touch far inside of `out`, each distance brings them a small part
// nearer.
enum { TURNING_CAP = 512 };     // distances, at most
swept_result swept_turning(hull a, const swept_motion *of_a, hull b,
                           const swept_motion *of_b, real apart, real tolerance,
                           vec3 *scratch);
//<

//> swept-inner-declare
//>   A pair that goes further than this in a frame is fast-moving.
// The radius (m) of the largest sphere about the origin of a rigid shape that
// lies inside it; 0 for a shape that has no inside.
real shape_inner(const shape *s);
//<
