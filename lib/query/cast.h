//> cast-head
// cast.h - rays, sweeps and nearest points against one body.
//
// Paper: not asked.  Book: chapter 15.
// Units: metres, in the frame of the points (the world's); time as a fraction of the
// displacement.

#pragma once

#include "scene.h"
#include "search.h"
#include "sphere.h"
#include "swept.h"

// All points no further than `round` (m, >= 0) from a convex hull.  The tip of a ray is
// one point, a ball is one point and a radius.
typedef struct {
    hull core;
    real round;
    real rim;           // m, of a cylinder: see shape; else 0
} rounded;

// A rigid shape whose vertices are at `at`.
static inline rounded rounded_shape(const shape *s, const vec3 *at)
{
    return (rounded){ { at, s->particles }, s->round, s->rim };
}

// Its bounding sphere around the mean of the hull's points.
sphere rounded_ball(rounded r);

typedef struct {
    bool hits;
    real fraction;      // 0 to 1, of the displacement
    vec3 point;         // m, on the body that was met
    vec3 normal;        // unit, out of that body; if they overlap at the start, against
                        // the displacement, or 0 if that is 0
} cast_result;
//<

//> cast-declare
//>   Three questions are about a moving body, and five about one that stands
//>   still.
// Where does a, which moves straight by `way` without turning, first touch b?  Exact to
// 1e-12 of the displacement and the sizes.  What overlaps at the start is met at 0, and
// what is not finite meets nothing.  Only a point meets the round side of a cylinder;
// all else meets its prism.  scratch: room for the points of both.
cast_result cast_first(rounded a, vec3 delta, rounded b, vec3 *scratch);

// The same for a body that moves and turns, to a millionth of the displacement and its
// size.
cast_result cast_turning(rounded a, const swept_motion *m, rounded b,
                         vec3 *scratch);

// The same for a body that moves straight, and the half-space behind a plane.
cast_result cast_first_plane(rounded a, vec3 delta, plane p);

// The point of b nearest to x, if it is no further away than most (m); x itself
// if it is inside.  fraction is the distance (m).
cast_result cast_nearest(vec3 x, rounded b, real most);
cast_result cast_nearest_plane(vec3 x, plane p, real most);

// Do they have a point in common?
bool cast_overlaps(rounded a, rounded b);

// How far apart are the two?  fraction is the gap (m); if they overlap, it is below 0,
// and a is parted by so much along the normal.  hits: both are in range.
cast_result cast_gap(rounded a, rounded b);
cast_result cast_gap_plane(rounded a, plane p);
//<
