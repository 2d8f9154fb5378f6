//> hit-face-head
// hit_face.h - two bodies overlap: which way out is shortest, and which
// features touch?
//
// Paper: section 5.1, the hit face: the face of A - B closest to the origin,
// found by the expanding polytope algorithm (EPA; van den Bergen, 2001).
// Book: chapter 5.  Units: metres, in the frame of the points.

#pragma once

#include "climb.h"
#include "feature.h"

typedef enum {
    HIT_FOUND,
    HIT_FLAT,           // A - B has no volume: depth 0, the normal of its plane
    HIT_CAPPED,         // polytope full: depth is a lower bound
    HIT_NOT_FINITE      // NaN, or out of range (gjk.h): all numbers are 0
} hit_status;

typedef struct {
    hit_status status;
    touch_kind kind;
    real depth;         // m, >= 0: the least move that parts the bodies
    vec3 normal;        // unit, from B to A: A moves out along it by depth
    vec3 on_a, on_b;    // m, what this move joins: on_b - on_a = depth * normal
    feature_point a, b; // the same two points, by vertices
    corner hit[3];      // the corners of the hit face
    int    iterations;  // supports computed, beyond the first four corners
} hit_result;

// The hit face of two hulls that overlap.  start: the last simplex of the
// gjk_distance that said so, which has a corner at least.  Allocates nothing;
// takes 150 kB of stack.
hit_result hit_face_find(hull a, hull b, const simplex *start);

// The same of bodies in range whose meshes may be known: then of many vertices
// few are asked.
hit_result hit_face_climb(const hull_mesh *a, const hull_mesh *b,
                          const simplex *start);
//<
