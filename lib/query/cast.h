//> cast-head
// cast.h - what does a thing meet on its way, or nearby?
//
// Paper: not asked.  Book: chapter 15.
// Units: metres, in the frame of the points (the world's); time as a fraction
// of the way.

#pragma once

#include "scene.h"
#include "search.h"
#include "sphere.h"
#include "swept.h"

// All points no further than `round` (m, >= 0) from a convex hull: a ray's tip
// is one point, a ball one point and a radius.
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

// A ball around all of it, whose centre is the mean of the hull's points.
sphere rounded_ball(rounded r);

typedef struct {
    bool hits;
    real fraction;      // 0 to 1, of the way
    vec3 point;         // m, on what was met
    vec3 normal;        // unit, out of what was met; where they overlap from
                        // the start: against the way, 0 if there is none
} cast_result;
//<

//> cast-declare
//>   Three questions are about a moving body, and five about one that stands
//>   still.
// Where does a, which goes straight by `way` without turning, first touch b?  (What
// is no point meets the prism of a cylinder.)
// To 1e-12 of the way and the sizes.  What overlaps at the start is met at 0.
// What is not finite meets nothing.  scratch: room for the points of both.
cast_result cast_first(rounded a, vec3 way, rounded b, vec3 *scratch);

// The same of one that goes and turns, to a millionth of the way and its size.
cast_result cast_turning(rounded a, const swept_motion *m, rounded b,
                         vec3 *scratch);

// What goes straight, with what is behind a plane.
cast_result cast_first_plane(rounded a, vec3 way, plane p);

// The point of b nearest to x, if it is no further away than most (m); x itself
// if it is inside.  fraction is the distance (m).
cast_result cast_nearest(vec3 x, rounded b, real most);
cast_result cast_nearest_plane(vec3 x, plane p, real most);

// Do they have a point in common?
bool cast_overlaps(rounded a, rounded b);

// How far apart are the two?  fraction is the gap (m); of what overlaps it is less
// than 0, and a comes out by so much along the normal.  hits: they are in range.
cast_result cast_gap(rounded a, rounded b);
cast_result cast_gap_plane(rounded a, plane p);
//<
