//> swept-head
//>   The result says what became of the two bodies, and when. Time is a
//>   fraction of the way, so the query knows nothing of seconds.
// swept.h - time of impact: when do two moving bodies first touch?
//
// Paper: section 7 asks for very small time steps when objects are thin.  Here it is
// conservative advancement (Mirtich 1996) with gjk, which needs two or three distances.
// Book: chapter 15.
// Units: metres; time as a fraction of the displacement, 0 to 1.

#pragma once

#include "body.h"
#include "gjk.h"

typedef enum {
    SWEPT_PASSES,       // they stay further apart than `apart`
    SWEPT_TOUCHES,      // they are first as near as `apart` at `time`
    SWEPT_OVERLAP,      // they are as near as that at the start: time 0
    SWEPT_CAPPED,       // the search ended before it knew; until `time` they do not
                        // touch
    SWEPT_NOT_FINITE
} swept_status;

typedef struct {
    swept_status status;
    real time;          // 0 to 1; 1 if they pass
    vec3 normal;        // unit, from B to A, at that time; 0 if the hulls overlap at
                        // the start (hit_face knows more).  If they pass, the
                        // last axis that separated them
    vec3 on_a, on_b;    // m, the nearest points at that time, with A where it is
                        // then; only if they touch or overlap
    simplex last;       // the vertices and weights of those points
    int  iterations;    // how many distances were computed,
    int  supports;      // and support points for them
} swept_result;
//<

//> swept-declare
//>   A body that turns does not go straight. Its outermost point leaves the
//>   straight way by no more than the arc of its turning. Put that arc into
//>   `apart`, and nothing is missed, though the answer comes a little early.
enum { SWEPT_CAP = 64 };        // distances, at most

// When does hull a, which moves straight by `delta` (m) as seen from b, come as near as
// `apart` (m, >= 0)?  The distance at the time of the answer is between apart and apart
// + tolerance (m, > 0).  A tolerance below 8 units in the last place of the
// displacement and the sizes is raised to that.  For bodies that turn, add the arc of
// the outermost point to `apart`.
// scratch: room for a.count + b.count points.
swept_result swept_first_touch(hull a, vec3 delta, hull b, real apart,
                               real tolerance, vec3 *scratch);
//<

//> swept-turning-declare
//>   And it is the arc of a whole frame: a needle that tumbles is thinner than that,
//>   and what comes by would touch all that it might sweep. So the second query turns
//>   the bodies as well.
// The motion of a hull in a frame: its centre moves straight, and it turns about it.
typedef struct {
    vec3 center;        // m, at the start
    vec3 delta;         // m, displacement of the centre in the frame
    vec3 turn;          // rad, in the frame, right-handed
    real out;           // m, distance of its furthest point from the centre
} swept_motion;

// Where the points of h are after a fraction t of the frame.
void swept_place(hull h, const swept_motion *m, real t, vec3 *out);

// The same as swept_first_touch for two hulls that move so.  If they touch far inside
// of `out`, it needs many distances.
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
